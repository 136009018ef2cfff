"""The frequency equation of a string whose tension varies, a hanging chain: Bessel functions, their zeros, shapes."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Line, line
from vibcli.report.own_letters import own_letters
from vibcli.report.sections.orthogonality import orthogonality

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.hanging_strings import HangingString
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.problem import Problem

ZEROS = {"J0": "2.404825558, 5.520078110, 8.653727913, 11.79153444, 14.93091771",
         "J1": "3.831705970, 7.015586670, 10.17346814, 13.32369194, 16.47063005"}      # Abramowitz & Stegun, table 9.5


def hanging_alone(problem: "Problem", pieces: "Sequence[PlacedPiece]") -> "HangingString | None":
    """The equation of pieces that are one such string; None of others."""
    if len(pieces) != 1 or pieces[0].piece.gradient.is_zero:
        return None
    from vibcli.analyses.closed_form.hanging_strings import hanging_string

    scene = problem.scene
    return hanging_string(problem.symbolic.linearisation, pieces[0], {*scene.coordinates, *scene.parameters.nodes})


def of_hanging(problem: "Problem", found: "HangingString", label: Any) -> Iterator[Line]:
    """The equation, its roots where these are zeros of one function, ω by z, the shape and the orthogonality."""
    table, z = found.omega.table, found.wave_number
    yield line(found.left, " = ", found.right, label=label)
    for letter, meant in found.named:
        yield line(letter, " = ", meant, inset=2)
    if found.zeros_of:
        yield line(z, " = ", ZEROS[found.zeros_of], ", …", inset=2)
    yield line(found.omega, " = ", z * table.sqrt(found.square / z ** 2), inset=2)
    along = found.along(table.parameter(own_letters(problem.scene).place))
    second = [] if found.sigma is None else [" − σ·", table.call("Y0", along)]
    yield line("X(x) = ", table.call("J0", along), *second, inset=2)
    if found.sigma is not None:
        yield line("σ = ", found.sigma, inset=2)
    yield from orthogonality(problem, found)
