"""The frequency equation of a string whose tension varies, a hanging chain: Bessel functions, their zeros, shapes."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Line, line
from vibcli.report.place_letter import place_letter
from vibcli.report.sections.orthogonality import orthogonality

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.hanging_strings import HangingString
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.problem import Problem

PRINTED, DIGITS = 5, 10


def hanging_alone(problem: "Problem", pieces: "Sequence[PlacedPiece]") -> "HangingString | None":
    """The equation of pieces that are one such string; None of others."""
    if len(pieces) != 1 or pieces[0].piece.gradient.is_zero:
        return None
    from vibcli.analyses.closed_form.hanging_strings import hanging_string

    scene = problem.scene
    return hanging_string(problem.symbolic.linearisation, pieces[0], {*scene.coordinates, *scene.parameters.nodes})


def of_hanging(problem: "Problem", found: "HangingString", label: Any) -> Iterator[Line]:
    """The equation, its roots where these are zeros of one function, ω by z, the shape and the orthogonality."""
    from vibcli.analyses.closed_form.hanging_strings import first_zeros

    table, z = found.omega.table, found.wave_number
    yield line(found.left, " = ", found.right, label=label)
    for letter, meant in found.named:
        yield line(letter, " = ", meant, inset=2)
    if found.zeros_of:
        roots = ", ".join(f"{value:.{DIGITS}g}" for value in first_zeros(found.zeros_of, PRINTED))
        yield line(z, " = ", roots, ", …", inset=2)
    yield line(found.omega, " = ", z * table.sqrt(found.square / z ** 2), inset=2)
    along = found.along(table.parameter(place_letter(problem.scene)))
    second = [] if found.sigma is None else [" − σ·", table.call("Y0", along)]
    yield line("X(x) = ", table.call("J0", along), *second, inset=2)
    if found.sigma is not None:
        yield line("σ = ", found.sigma, inset=2)
    yield from orthogonality(problem, found)
