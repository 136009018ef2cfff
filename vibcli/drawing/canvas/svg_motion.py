"""Frames of a drawing as an SVG that moves by itself (SMIL): between frames everything goes on a straight line, and
what keeps its shape is shifted and turned.

Where less motion is preferred, and on paper, one frame stands still.
"""

from cmath import exp, phase
from collections.abc import Sequence
from math import degrees, remainder, tau
from typing import Any

from vibcli.drawing.canvas.primitives import Circle, Hatch, LetterRuns, Polygon, Polyline, Primitive, extent
from vibcli.drawing.canvas.svg_canvas import document, element, number, outline
from vibcli.drawing.layout import plane

SAME = 0.02     # points: what keeps its shape to within this is shifted and turned
MOVES, RESTS = "vibcli-moves", "vibcli-rests"
STYLE = (f"\n<style>.{RESTS}{{display:none}}@media print,(prefers-reduced-motion:reduce){{.{RESTS}{{display:inline}}"
         f".{MOVES}{{display:none}}}}</style>")


def moving(frames: Sequence[list[Any]], title: str, about: str = "", milliseconds: int = 40, closed: bool = False,
           rests: bool = True) -> bytes:
    """The bytes of the SVG. closed: does the first frame follow the last? rests: is one frame kept for those who
    prefer it to stand still: that a quarter of the way through, where a mode is displaced most."""
    ordered = [sorted(frame, key=lambda part: part.layer) for frame in frames]
    boxes = [extent(frame) for frame in frames]
    box = (min(b[0] for b in boxes), min(b[1] for b in boxes), max(b[2] for b in boxes), max(b[3] for b in boxes))
    still = len(frames) // 4 if rests else None
    timing = f'dur="{number(len(frames) * milliseconds / 1000)}s" repeatCount="indefinite"'
    last = 0 if closed else -1
    if len({tuple(map(_kind, frame)) for frame in ordered}) == 1:
        columns = list(zip(*ordered, strict=True))
        body = [_column((*column, column[last]), timing, still) for column in columns]
    else:
        body = _whole(ordered, timing, still)
    return document("\n".join(body), box, title, about, STYLE if rests else "")


def _kind(part: Primitive) -> tuple[Any, ...]:
    """What parts of two frames share if they are the same thing, elsewhere."""
    if isinstance(part, (Polyline, Polygon, Hatch)):
        return type(part), len(part.points), part._replace(points=())
    if isinstance(part, Circle):
        return Circle, part._replace(centre=(0.0, 0.0), radius=0.0)
    return type(part), part.role, part.layer


def _column(parts: tuple[Primitive, ...], timing: str, still: int | None) -> str:
    """The elements of one thing in all frames."""
    first = parts[0]
    if all(part == first for part in parts):
        return element(first)
    rests = "" if still is None else "\n" + element(parts[still], attributes=f' class="{RESTS}"')
    return _moved(parts, timing, f' class="{MOVES}"' if rests else "") + rests


def _moved(parts: tuple[Any, ...], timing: str, attributes: str) -> str:
    first = parts[0]
    if isinstance(first, Circle):
        values = {"cx": [part.centre[0] for part in parts], "cy": [-part.centre[1] for part in parts],
                  "r": [part.radius for part in parts]}
        return element(first, "".join(_animated(name, list(map(number, numbers)), timing)
                                      for name, numbers in values.items()), attributes)
    found = None if isinstance(first, LetterRuns) else _shifts(parts)
    if found is None:
        if isinstance(first, (Hatch, LetterRuns)):
            return "\n".join(_in_turn(parts[:-1], timing, attributes))
        return element(first, _animated("d", list(map(outline, parts)), timing), attributes)
    pivot, shifts, turns = found
    about = first._replace(points=tuple(plane.minus(point, pivot) for point in first.points))
    places, angles = [f"{number(x)} {number(-y)}" for x, y in shifts], [number(-degrees(turn)) for turn in turns]
    children = _turned("translate", places, timing) + _turned("rotate", angles, timing, ' additive="sum"')
    return element(about, children, f' transform="translate({places[0]})"{attributes}')


def _animated(name: str, values: list[str], timing: str) -> str:
    if len(set(values)) == 1:
        return ""
    return f'<animate attributeName="{name}" values="{";".join(values)}" {timing}/>'


def _turned(kind: str, values: list[str], timing: str, further: str = "") -> str:
    if len(set(values)) == 1:
        return ""
    return (f'<animateTransform attributeName="transform" type="{kind}" values="{";".join(values)}" '
            f"{timing}{further}/>")


def _shifts(parts: tuple[Any, ...]) -> tuple[tuple[float, float], list[tuple[float, float]], list[float]] | None:
    """(the middle of the first, where it is in each, by what angle each is turned) of what keeps its shape; None of
    other things."""
    rows = [[complex(*point) for point in part.points] for part in parts]
    middles = [sum(row) / len(row) for row in rows]
    arms = [point - middles[0] for point in rows[0]]
    longest = max(range(len(arms)), key=lambda i: abs(arms[i]))
    turns = [0.0]
    for row, middle in zip(rows, middles, strict=True):
        turns.append(turns[-1] + remainder(phase(row[longest] - middle) - phase(arms[longest]) - turns[-1], tau))
        turn = exp(1j * turns[-1])
        if any(abs(middle + turn * arm - point) > SAME for arm, point in zip(arms, row, strict=True)):
            return None
    return (middles[0].real, middles[0].imag), [(middle.real, middle.imag) for middle in middles], turns[1:]


def _whole(frames: Sequence[list[Any]], timing: str, still: int | None) -> list[str]:
    """The elements of frames that do not consist of the same things: each is shown in its turn."""
    groups = ["\n".join(map(element, frame)) for frame in frames]
    rests = [] if still is None else [f'<g class="{RESTS}">\n{groups[still]}\n</g>']
    moves = f' class="{MOVES}"' if rests else ""
    return [f'<g visibility="hidden"{moves}>{group}{_shown(i, len(groups), timing)}</g>'
            for i, group in enumerate(groups)] + rests


def _in_turn(parts: Sequence[Any], timing: str, attributes: str) -> list[str]:
    return [element(part, _shown(i, len(parts), timing), f' visibility="hidden"{attributes}')
            for i, part in enumerate(parts)]


def _shown(index: int, count: int, timing: str) -> str:
    """Visible in the one of `count` equal parts of the time."""
    times = sorted({0.0, index / count, (index + 1) / count} - {1.0})
    values = ";".join("visible" if index / count <= time < (index + 1) / count else "hidden" for time in times)
    moments = ";".join(f"{time:.6g}" for time in times)
    return (f'<animate attributeName="visibility" calcMode="discrete" values="{values}" keyTimes="{moments}" '
            f"{timing}/>")
