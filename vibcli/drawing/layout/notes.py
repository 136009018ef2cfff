"""What a drawing cannot show, in words below it: elements without a place, equations, given energies and matrices."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import extent
from vibcli.drawing.layout import captions, lettering
from vibcli.drawing.symbols.connection import symbol
from vibcli.notation.names import GREEK

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import LetterRuns, Run
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.rows import Edge
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Expression, Record
    from vibcli.scene.scene import Scene

SIZE, LEADING, MOST = 9.5, 15.0, 8


def lines(stage: "Scenery", drawn: Sequence[Any]) -> "list[LetterRuns]":
    """The Texts of the notes, below what is drawn."""
    found, every = [], of(stage)[:MOST]
    box = extent(drawn) if every else None
    left, bottom = (box[0], box[1] - 10.0) if box else (0.0, 0.0)
    for runs in every:
        bottom -= LEADING
        found.append(lettering.text(runs, left, bottom, "note"))
    return found


def of(stage: "Scenery") -> "list[tuple[Run, ...]]":
    """The runs of each note."""
    spec, scene = stage.scene.spec, stage.scene
    shown = {record.name for bunch in stage.bunches for record in bunch.members}
    shown |= _shown(scene) if stage.rows else set()
    found = []
    for record in spec.connections:
        if "stretch" in record and record.name not in shown:
            fields = [record[key] for key in (*symbol(record).NAMED_BY, "law", "friction")
                      if hasattr(record.get(key), "tree")]
            what = [(field, " on ") for field in fields[:1]]    # none of what consists of parts
            found.append(_note(f"{record.name}: ", scene, *what, (record["stretch"], "")))
    hung = [name for one in stage.hung for name in one.ties]
    found += [_tie(record, stage.sketch) for record in spec.connections
              if record.name not in hung and _unplaced(record, stage.sketch)]
    found += _held(stage) if stage.rows and stage.strips else []
    for name, record in (spec.get("forces") or {}).items():
        if "value" in record:
            found.append(_note(f"{name}: ", scene, (record["value"], "")))
    for name, record in (spec.get("constraints") or {}).items():
        if "equation" in record:
            found.append(_note(f"{name}: ", scene, (record["equation"], " = 0")))
        for kind in ("gear", "belt"):
            if kind in record and any(scene.bodies[end.text].frame is None for end in record[kind]):
                names = " – ".join(end.text for end in record[kind])
                found.append(lettering.words(f"{name}: {kind} {names}", SIZE))
    for key, field in (spec.get("energies") or {}).items():
        found.append(_note(f"{GREEK.get(key, key)} = ", scene, (field, "")))
    return found


def _shown(scene: "Scene") -> set[str]:
    """The names of the elements in rows that say no more than what is drawn of them."""
    from vibcli.drawing.layout import rows

    return {edge.record.name for edge in rows.edges(scene) if _is_plain(edge, scene, rows.motion)}


def _held(stage: "Scenery") -> "list[tuple[Run, ...]]":
    """What holds members to bodies in rows."""
    from vibcli.drawing.symbols.member_ends import held

    standing = {name for layout in stage.rows for name in layout.places}
    return [lettering.words(f"{strip.name}: {side} end {word} to {name}", SIZE) for strip in stage.strips
            for side in ("left", "right") for word, name in held(strip.member, side) if name in standing]


def _is_plain(edge: "Edge", scene: "Scene", motion: "Callable[[Body], Expression]") -> bool:
    """Is an element among lumped bodies stretched by how far they are apart, to either side? motion: of a body."""
    if "stretch" not in edge.record:
        return True
    stretch = captions.raw(edge.record["stretch"], scene)
    one, two = (scene.table.zero if name is None else captions.raw(motion(scene.bodies[name]), scene)
                for name in (edge.one, edge.two))
    return any((stretch - sign * (two - one)).is_zero for sign in (1, -1))


def _unplaced(record: "Record", sketch: "Sketch") -> bool:
    """Does an element end at a point on a member that has no place?"""
    points = sketch.spec.get("member_points") or {}
    names = [getattr(end, "text", None) for end in record.get("between", ())]
    return any(name in points and name not in sketch.frames for name in names)


def _tie(record: "Record", sketch: "Sketch") -> "tuple[Run, ...]":
    """What an element joins: `tie: k between tip and block`."""
    ends = " and ".join(getattr(end, "text", "a place") for end in record["between"])
    runs = captions.quantity(record, symbol(record).NAMED_BY, sketch)
    return (*lettering.words(f"{record.name}: ", SIZE), *(run._replace(size=SIZE * run.size / lettering.SIZE)
            for run in runs), *lettering.words(f" between {ends}", SIZE))


def _note(head: str, scene: "Scene", *parts: "tuple[Expression, str]") -> "tuple[Run, ...]":
    from vibcli.drawing.layout.formulas import written

    runs = list(lettering.words(head, SIZE))
    for field, after in parts:
        node = captions.raw(field, scene)
        given = node.op == "number"     # which keeps its unit
        runs += (lettering.words(captions.as_printed(field.text.strip()), SIZE) if given else
                 shortened(written(node, SIZE)))
        if after:
            runs += lettering.words(after, SIZE)
    return tuple(runs)


def shortened(runs: "Sequence[Run]", longest: int = lettering.LONGEST) -> "tuple[Run, ...]":
    """The runs as far as there is room for them."""
    found, left = [], longest
    for run in runs:
        if len(run.text) > left:
            return (*found, run._replace(text=run.text[:left] + " …"))
        found.append(run)
        left -= len(run.text)
    return tuple(found)
