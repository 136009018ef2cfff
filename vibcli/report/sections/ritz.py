"""Estimates of the lowest natural frequencies by assumed shapes."""

from collections.abc import Iterator, Sequence
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.normalisation import WORDS, normalised, weights
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Section, TableBlock, note, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.insight import grid, off, require_numbers
from vibcli.report.sections.mode_tables import shapes

if TYPE_CHECKING:
    from vibcli.analyses.modal.assumed_motions import RitzMode
    from vibcli.report.blocks import Paragraph
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

HEAD = ("", "estimate [rad/s]", "f [Hz]", "T [s]", "exact ω [rad/s]", "error")


def ritz(problem: "Problem", report: "Report") -> Iterator[Section]:
    require_numbers(problem, "ritz")
    found = problem.modal.result("ritz")
    one = len(found.modes) == 1
    yield from section("Rayleigh's quotient of the assumed shape" if one else "Ritz estimates by the assumed shapes",
                       TableBlock(HEAD, tuple(map(_row, found.modes))), *_quotient(found) if one else (),
                       *map(paragraph, _remarks(found.modes)))
    if not one:
        for title, matrix in (("Reduced mass matrix ΦᵀMΦ", found.M), ("Reduced stiffness matrix ΦᵀKΦ", found.K)):
            columns = [(f"shape {j}", {f"shape {i}": x for i, x in enumerate(row, 1)})
                       for j, row in enumerate(matrix, 1)]
            yield from grid(title, columns, figure)
        if found.modes[0].weights is not None:
            columns = [(f"mode {mode.index}", {f"shape {i}": x for i, x in enumerate(_scaled(mode.weights), 1)})
                       for mode in found.modes]
            yield from grid("Combinations of the shapes", columns, figure)
            return
        held = weights(problem.configuration.linear_system)
        yield from section("Shapes of the estimates", *shapes(
            problem.scene.coordinates, [mode.index for mode in found.modes],
            [normalised(mode.shape, report.normalise, held) for mode in found.modes]), note(WORDS[report.normalise]))


def _row(mode: "RitzMode") -> tuple[str, str, str, str, str, str]:
    omega, exact = mode.omega, mode.exact
    known = (figure(omega), figure(omega / tau), figure(tau / omega) if omega else "∞") if omega is not None else (
        "–", "–", "–")
    return f"mode {mode.index}", *known, figure(exact), off(omega, exact) if omega and exact else ""


def _scaled(weights: Sequence[float]) -> list[float]:
    """Those of a combination, the first shape that takes part having 1."""
    first = next(x for x in weights if x)
    return [x / first for x in weights]


def _quotient(found: Any) -> "list[Paragraph]":
    if found.modes[0].weights is not None:
        return [paragraph(f"K̂/M̂ = {figure(found.K[0][0])}/{figure(found.M[0][0])}, the square of the estimate.")]
    return [paragraph(f"φᵀKφ/φᵀMφ = {figure(found.K[0][0])}/{figure(found.M[0][0])}, the square of the estimate.")]


def _remarks(modes: "Sequence[RitzMode]") -> Iterator[str]:
    """What is known of the estimates."""
    if any(mode.exact is not None for mode in modes):
        yield ("It is an upper bound of ω of the first mode" if len(modes) == 1 else
               "Each is an upper bound of ω of the mode with its number") + " (minimax principle)."
    falling = [str(mode.index) for mode in modes if mode.omega is None]
    if falling:
        yield f"The square of the estimate of mode {', '.join(falling)} is negative: the equilibrium is unstable."
    hidden = [str(mode.index) for mode in modes if mode.omega is not None and mode.exact is None]
    if hidden:
        yield f"Mode {', '.join(hidden)} is unstable, which these shapes do not show."


def _ritz(problem: "Problem") -> dict[str, Any]:
    found = problem.modal.result("ritz")
    names = problem.scene.coordinates
    return KEY.row(found.shapes, found.M, found.K, [
        MODES.row(mode.index, mode.square, mode.omega, mode.exact, mode.omega / mode.exact - 1 if mode.omega
                  and mode.exact else None, dict(zip(names, mode.shape, strict=True)), mode.weights)
        for mode in found.modes])


MODES = Key("modes", "a list, one entry to each estimate, by ascending square", each=(
    Key("index", "number of the mode whose omega it bounds"),
    Key("square", "the square of the estimate, negative where the equilibrium is unstable along the shapes"),
    Key("omega", "the estimate, an upper bound; null where its square is negative"),
    Key("exact", "omega of the mode; null where it is unstable"),
    Key("error", "omega/exact − 1; null where one of them is null or zero"),
    Key("shape", "{coordinate: amplitude} of the combination of the shapes, φᵀMφ = 1"),
    Key("weights", "the part of each shape in it; null in scenes without members")))
KEY = Key("ritz", "bounds of the lowest natural frequencies by assumed shapes", _ritz, of=(
    Key("shapes", "the assumed shapes, a row to each, in the order of the coordinates"),
    Key("M", "reduced mass matrix, a row to each shape"),
    Key("K", "reduced stiffness matrix, a row to each shape"),
    MODES))
