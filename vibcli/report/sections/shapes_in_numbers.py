"""Shape functions of members that meet in one motion, in numbers, stretch by stretch of each mode:

    N X″ = κ X    X = a cos kx + b sin kx, k⁴ or k² = −κ/(B or N)
    B X⁗ = −κ X   X = a cos kx + b sin kx + c cosh k(x − x_m) + d sinh k(x − x_m), x_m the middle: no digits cancel
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.notation.numbers import figure
from vibcli.report.blocks import Line, Words, line

if TYPE_CHECKING:
    from vibcli.analyses.continuous.shapes import Moved
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.results.problem import Problem

MODES, STRETCHES = 2, 6     # told at most, stretches in each mode
DIGITS, OF_K, RESTS = 7, 10, 1e-9       # the last: of the largest factor, what is 0


def shapes_in_numbers(problem: "Problem", normalise: str, members: Sequence[str]) -> Iterator[Line]:
    """X(x) of the first modes that bend or stretch these members, normalised as shapes are told, x from the left
    end of each; nothing where a symbol has no value, modes are damped, or a stretch is of another equation."""
    if problem.numeric.has_free_symbols:
        return
    shown = [mode for mode in problem.modal.modes.shown() if mode.omega][:MODES]
    for mode in shown:
        told = shape_in_numbers(problem, mode, normalise, members)
        if told is None:
            return
        for member, found in told.items():
            for start, end, text in found:
                span = [Words(", "), "x", Words(" in m")] if len(found) == 1 else [
                    Words(f", {figure(start)} m < "), "x", Words(f" < {figure(end)} m")]
                yield line("X(x) = ", text, Words(f"   of {member} in mode {mode.index}"),
                           *(span if text != "0" else []), inset=2)


def shape_in_numbers(problem: "Problem", mode: "Mode", normalise: str,
                     members: Sequence[str]) -> dict[str, list[tuple[float, float, str]]] | None:
    """{member: [(start, end, text of X(x))] of its stretches}; None of damped modes, many stretches, other
    equations."""
    told = problem.modal.told_apart(mode)
    fields, factor = problem.modal.fields(told), complex(problem.modal.scale(told, normalise))
    pieces = [(member, moved) for member in members for moved in fields.pieces(member)]
    if factor.imag or len(pieces) > STRETCHES or not all(_is_plain(moved) for _, moved in pieces):
        return None
    return {member: _joined([(moved, _told(moved, factor.real)) for one, moved in pieces if one == member])
            for member in members}


def _joined(told: "Sequence[tuple[Moved, str]]") -> list[tuple[float, float, str]]:
    """[(start, end, text)] of stretches, those next to one another together that are one function."""
    found: list[tuple[float, float, str]] = []
    for moved, text in told:
        start, end = float(moved.start), float(moved.start) + float(moved.piece.length)
        if found and found[-1][2] == text:
            found[-1] = found[-1][0], end, text
        else:
            found.append((start, end, text))
    return found


def _is_plain(moved: "Moved") -> bool:
    piece = moved.piece
    plain = not piece.gradient and not (piece.bending and piece.tension) and moved.kappa < 0
    return bool(plain and not any(getattr(end, "imag", 0) for end in moved.ends))


def _told(moved: "Moved", factor: float) -> str:
    """The sum, x from the left end of the member."""
    import numpy as np

    piece, start, length = moved.piece, float(moved.start), float(moved.piece.length)
    k = float(-moved.kappa / (piece.bending or piece.tension)) ** (1 / piece.order)
    left, right, middle = start, start + length, start + length / 2
    bent = piece.order == 4

    def row(x: float, slope: int) -> "list[float]":
        swings = [-k * np.sin(k * x), k * np.cos(k * x)] if slope else [np.cos(k * x), np.sin(k * x)]
        y = k * (x - middle)
        return [*swings, *([k * np.sinh(y), k * np.cosh(y)] if slope else [np.cosh(y), np.sinh(y)])][:piece.order]

    rows = [row(x, slope) for x in (left, right) for slope in range(1 + bent)]
    found = np.linalg.solve(np.array(rows), np.array(moved.ends, float) * factor)
    sizes = np.abs(found) * ([1, 1, np.cosh(k * length / 2), np.sinh(k * length / 2)][:piece.order])
    number = figure(k, digits=OF_K)
    shifted = f"({number}·x)", f"({number}·x)", *[f"({number}·(x − {figure(middle, digits=OF_K)}))"] * 2
    text = ""
    for name, c, argument, size in zip(("cos", "sin", "cosh", "sinh"), found, shifted, sizes, strict=False):
        if size > RESTS * sizes.max():
            sign = " − " if c < 0 else " + "
            times = figure(abs(float(c)), digits=DIGITS)
            text += (sign if text else sign.strip(" +")) + (f"{times}·" if times != "1" else "") + name + argument
    return text or "0"
