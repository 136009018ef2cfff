"""Random rows of members with springs, masses and oscillators, as scenes and, by themselves, in finite elements."""

import random
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np

ENDS = {"free": (), "pinned": (0,), "guided": (1,), "clamped": (0, 1)}       # of (u, slope), those that are held


class DrawnPart(NamedTuple):
    """A member between nodes: in N·m², kg/m, N, N/m²; `stiff` is EI, of bars EA."""

    length: float
    stiff: float
    inertia: float
    tension: float
    bed: float
    hinged: bool        # to the one on its left


class DrawnNode(NamedTuple):
    """What stands at a node, 0 where nothing does: oscillator: its mass and spring."""

    held: tuple[int, ...]
    spring: float
    torsion: float
    mass: float
    turning: float
    oscillator: tuple[float, float] | None


class RowOfMembers(NamedTuple):
    """Parts from left to right, and the nodes at their ends."""

    beams: bool
    parts: list[DrawnPart]
    nodes: list[DrawnNode]


def random_row(seed: int) -> RowOfMembers:
    """One to four members, of which neighbours are alike now and then."""
    draw = random.Random(seed)
    beams, count = draw.random() < 0.6, draw.randint(1, 4)
    even, alike = draw.random() < 0.3, draw.random() < 0.4
    usual = _power(draw, -1, 1), _power(draw, -1, 1)
    parts = []
    for i in range(count):
        length = 1.0 if even else draw.uniform(0.2, 2)
        stiff, inertia = usual if alike else (_power(draw, -2, 2), _power(draw, -1, 1))
        tension = draw.uniform(-2, 10) * stiff / length**2 if beams and draw.random() < 0.3 else 0.0
        bed = _power(draw, -1, 1) * stiff / length**(4 if beams else 2) if draw.random() < 0.2 else 0.0
        parts.append(DrawnPart(length, stiff, inertia, tension, bed, bool(i) and beams and draw.random() < 0.2))
    return RowOfMembers(beams, parts, [_node(draw, beams, node in (0, count)) for node in range(count + 1)])


def _power(draw: random.Random, low: float, high: float) -> float:
    return 10 ** draw.uniform(low, high)


def _node(draw: random.Random, beams: bool, at_end: bool) -> DrawnNode:
    ends = list(ENDS.values()) if beams else [(), (0,)]
    held = draw.choice(ends) if at_end else (0,) if draw.random() < 0.2 else ()
    spring, mass = (_power(draw, -1, 2) if 0 not in held and draw.random() < 0.4 else 0.0 for _ in range(2))
    torsion, turning = (_power(draw, -1, 1) if beams and 1 not in held and draw.random() < 0.3 else 0.0
                        for _ in range(2))
    hung = (_power(draw, -1, 1), _power(draw, -1, 2)) if 0 not in held and draw.random() < 0.25 else None
    return DrawnNode(held, spring, torsion, mass, turning, hung)


def scene(row: RowOfMembers) -> str:
    """It in the scene language."""
    kind, stiff = ("beams", "EI: {!r} N*m^2") if row.beams else ("bars", "EA: {!r} N")
    lines = [f"{kind}:"]
    for i, part in enumerate(row.parts):
        keys = [f"length: {part.length!r} m", stiff.format(part.stiff), f"mass_per_length: {part.inertia!r} kg/m"]
        keys += [f"preload: {part.tension!r} N"] * bool(part.tension) + [f"foundation: {part.bed!r} N/m^2"] * bool(
            part.bed)
        joint = "pinned" if part.hinged else "clamped"
        keys.append(f"left: {{{joint}: p{i - 1}, at: {row.parts[i - 1].length!r} m}}" if i else
                    f"left: {_end(row.nodes[0])}")
        keys += [f"right: {_end(row.nodes[-1])}"] * (i == len(row.parts) - 1)
        attached = [*(_attached(row.nodes[0], 0.0) if not i else ()), *_attached(row.nodes[i + 1], part.length)]
        if 0 in row.nodes[i + 1].held and i < len(row.parts) - 1:
            attached.append(f"{{at: {part.length!r} m, support: pinned}}")
        keys += [f"attached: [{', '.join(attached)}]"] * bool(attached)
        lines.append(f"  p{i}: {{{', '.join(keys)}}}")
    return "\n".join(lines) + "\n"


def _end(node: DrawnNode) -> str:
    return next(name for name, held in ENDS.items() if held == node.held)


def _attached(node: DrawnNode, place: float) -> list[str]:
    texts = [f"mass: {node.mass!r} kg"] * bool(node.mass) + [f"inertia: {node.turning!r} kg*m^2"] * bool(node.turning)
    texts = [", ".join(texts)] * bool(texts)
    texts += [f"k: {node.spring!r} N/m"] * bool(node.spring) + [f"torsion: {node.torsion!r} N*m"] * bool(node.torsion)
    if node.oscillator:
        texts.append("oscillator: {{mass: {!r} kg, k: {!r} N/m}}".format(*node.oscillator))
    return [f"{{at: {place!r} m, {text}}}" for text in texts]


def squares_by_finite_elements(row: RowOfMembers, count: int, parts: int = 20) -> "np.ndarray":
    """The lowest eigenvalues ω² with so many elements a member, each a little too high."""
    import numpy as np

    n, elements = 0, []

    def new(held: bool = False) -> int | None:
        nonlocal n
        n += not held
        return None if held else n - 1

    ways = 2 if row.beams else 1
    left = [new(way in row.nodes[0].held) for way in range(ways)]
    _lump(elements, row.nodes[0], left, new)
    for part, node in zip(row.parts, row.nodes[1:], strict=True):
        if part.hinged:
            left = [left[0], new()]
        size = part.length / parts
        for number in range(parts):
            last = number == parts - 1
            right = [new(last and way in node.held) for way in range(ways)]
            if row.beams:
                elements.append((left + right, *beam_element(size, part.stiff, part.tension, part.inertia, part.bed)))
            else:
                elements.append(([*left, *right, new()], *bar_element(size, part.stiff, part.inertia, part.bed)))
            left = right
        _lump(elements, node, left, new)
    K, M = np.zeros((n, n)), np.zeros((n, n))
    for numbers, k, m in elements:
        free = [i for i, number in enumerate(numbers) if number is not None]
        at = np.ix_([numbers[i] for i in free], [numbers[i] for i in free])
        K[at] += k[np.ix_(free, free)]
        M[at] += m[np.ix_(free, free)]
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    return np.linalg.eigvalsh(inverse @ K @ inverse.T)[:count]


def _lump(elements: "list[tuple[list[int | None], np.ndarray, np.ndarray]]", node: DrawnNode, at: list[int | None],
          new: "Callable[[], int | None]") -> None:
    """What stands at a node, as elements."""
    import numpy as np

    for way, (k, m) in enumerate(zip((node.spring, node.torsion)[:len(at)], (node.mass, node.turning), strict=False)):
        elements.append((at[way:way + 1], np.array([[k]]), np.array([[m]])))
    if node.oscillator:
        m, k = node.oscillator
        elements.append(([at[0], new()], k * np.array([[1, -1], [-1, 1]]), np.diag([0.0, m])))


def beam_element(length: float, bending: float, tension: float, inertia: float,
                 foundation: float) -> "tuple[np.ndarray, np.ndarray]":
    """K and M of a Hermite element over (u, slope) of its ends."""
    import numpy as np

    a = length
    k = bending / a**3 * np.array([[12, 6*a, -12, 6*a], [6*a, 4*a*a, -6*a, 2*a*a],
                                   [-12, -6*a, 12, -6*a], [6*a, 2*a*a, -6*a, 4*a*a]])
    g = tension / (30*a) * np.array([[36, 3*a, -36, 3*a], [3*a, 4*a*a, -3*a, -a*a],
                                     [-36, -3*a, 36, -3*a], [3*a, -a*a, -3*a, 4*a*a]])
    m = a / 420 * np.array([[156, 22*a, 54, -13*a], [22*a, 4*a*a, 13*a, -3*a*a],
                            [54, 13*a, 156, -22*a], [-13*a, -3*a*a, -22*a, 4*a*a]])
    return k + g + foundation * m, inertia * m


def bar_element(length: float, tension: float, inertia: float, foundation: float) -> "tuple[np.ndarray, np.ndarray]":
    """K and M of a quadratic element over u at its left end, its right end and its middle."""
    import numpy as np

    k = tension / (3*length) * np.array([[7, 1, -8], [1, 7, -8], [-8, -8, 16]])
    m = length / 30 * np.array([[4, -1, 2], [-1, 4, 2], [2, 2, 16]])
    return k + foundation * m, inertia * m
