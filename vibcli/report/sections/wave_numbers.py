"""Wave numbers β of modes, beside their frequencies: B β⁴ + N β² + k = μ ω² of what is alike in N/B, k/B and μ/B.

Where two differ each has a column; of more the first alone is told. A stretch whose tension varies
along it has no β.
"""

from collections.abc import Sequence
from math import isclose, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import figure
from vibcli.report.blocks import note
from vibcli.report.own_letters import own_letters

if TYPE_CHECKING:
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece
    from vibcli.report.blocks import Paragraph
    from vibcli.results.problem import Problem

CLOSE, COLUMNS, NAMED = 1e-9, 2, 1      # relative: what is alike; columns that are told, members named in each
NOTHING = 1e-12                 # of μω² and k: a β of 0
# (name in scenes, letter, words where the scene has that name of something else)
STIFFNESS = {"bar": ("EA", "EA", "stiffness"), "shaft": ("GIo", "GI_o", "stiffness"), "beam": ("EI", "EI", "stiffness"),
             "string": ("N", "N", "tension")}
PULL, BED = ("N", "N", "tension"), ("k", "k", "foundation")
MASS, TURNING = ("mu", "μ", "mass per length"), ("j", "j", "inertia per length")


def wave_numbers(problem: "Problem", modes: "Sequence[Mode]") -> "tuple[list[tuple[str, list[str]]], Paragraph]":
    """[(head, β of each mode)], and by which equation β is told where that is more than two terms."""
    found = _alike([placed for placed in problem.configuration.linear_system.pieces
                    if placed.piece.inertia and not placed.piece.gradient])
    shown = found if len(found) <= COLUMNS else found[:1]
    beta = own_letters(problem.scene).text("β")
    columns = [(f"{beta} [1/m]" if len(found) == 1 else f"{beta} of {_name(group, found, problem)} [1/m]",
                [_told(group[0].piece, mode) for mode in modes]) for group in shown]
    return columns, _definition(shown, problem)


def _alike(pieces: "Sequence[PlacedPiece]") -> "list[list[PlacedPiece]]":
    """Pieces in groups of one relation of β and ω."""
    groups: list[list[Any]] = []
    for placed in pieces:
        same = next((group for group in groups if _is_alike(group[0].piece, placed.piece)), None)
        if same is None:
            groups.append([placed])
        else:
            same.append(placed)
    return groups


def _is_alike(one: "Piece", other: "Piece") -> bool:
    return one.order == other.order and all(isclose(a, b, rel_tol=CLOSE) for a, b in zip(
        _ratios(one), _ratios(other), strict=True))


def _ratios(piece: "Piece") -> list[float]:
    stiffness = piece.bending or piece.tension
    return [float(x / stiffness) for x in (piece.inertia, piece.bending and piece.tension, piece.foundation)]


def _name(group: "Sequence[PlacedPiece]", groups: Sequence[Any], problem: "Problem") -> str:
    """The members of a group, those of which it is a part with the place where that begins."""
    named = []
    for placed in group:
        whole = all(other is group or all(one.owner != placed.owner for one in other) for other in groups)
        one = placed.owner if whole else f"{placed.owner} from {figure(float(placed.start))} m"
        if not any(placed.owner == name.partition(" ")[0] for name in named):
            named.append(one)
    return ", ".join(named[:NAMED]) + ", …" * (len(named) > NAMED)


def _told(piece: "Piece", mode: "Mode") -> str:
    """β of a mode; – where it is not real."""
    if mode.omega is None:
        return "–"
    load = float(piece.inertia) * float(mode.omega) ** 2
    left = load - float(piece.foundation)
    if abs(left) <= NOTHING * load:
        left = 0.0
    if piece.bending and piece.tension:
        B, N = float(piece.bending), float(piece.tension)
        inside = N * N + 4 * B * left
        square = (sqrt(inside) - N) / (2 * B) if inside >= 0 else -1.0
        power, steep = 2, B * square * square / (left or 1.0)
    else:
        square, power, steep = left / float(piece.bending or piece.tension), piece.order, 1.0
    if square < 0:
        return "–"
    return figure(square ** (1 / power), mode.error * max(load / abs(left), abs(steep), 1.0) if left else 0.0)


def _definition(groups: "Sequence[list[PlacedPiece]]", problem: "Problem") -> "Paragraph | None":
    """EI·β⁴ + N·β² + k = μ·ω² of those that a force along them or a foundation acts on."""
    letters = list(map(own_letters(problem.scene).text, "βω"))
    text = "; ".join(dict.fromkeys(filter(None, (_relation(group[0], problem, *letters) for group in groups))))
    return note(text) if text else None


def _relation(placed: "PlacedPiece", problem: "Problem", beta: str, omega: str) -> str:
    """The relation of β and ω of a piece, in words what shares its letter with something else; "" of two terms."""
    piece, kind = placed.piece, problem.scene.members[placed.owner].kind.name
    if not ((piece.bending and piece.tension) or piece.foundation):
        return ""
    floats, values = problem.numeric.floats, (piece.bending or piece.tension, piece.tension, piece.foundation,
                                              piece.inertia)
    stiffness, pull, bed, inertia = (
        letter if name not in floats or isclose(floats[name], value, rel_tol=CLOSE) else words
        for (name, letter, words), value in zip((STIFFNESS[kind], PULL, BED, TURNING if kind == "shaft" else MASS),
                                                values, strict=True))
    power = "⁴" if piece.order == 4 else "²"
    return f"{stiffness}·{beta}{power}" + f" + {pull}·{beta}²" * bool(piece.bending and piece.tension) + (
        f" + {bed}" * bool(piece.foundation)) + f" = {inertia}·{omega}²"
