"""The steps from M and K of several degrees of freedom to bounds of their frequencies, where a scene asks for these: by
assumed shapes Φ the roots of det(ΦᵀKΦ − ω²ΦᵀMΦ) = 0 (Ritz), of one shape Rayleigh's quotient (Rao 2011, section 8.8);
by the static deflection, and by each inertia alone."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.rayleigh_dunkerley import LowestFrequency
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.results.problem import Problem

CLOSE = 1e-9        # relative: of ΦᵀMΦ by the lines and the engine's, of what a root leaves


def tell_estimates(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: "Sequence[int]") -> None:
    """Write down what is asked of these; nothing in letters and where the bounds do not hold."""
    problem = about.problem
    if problem.numeric.has_free_symbols or problem.scene.pieces:
        return
    rules, find = problem.spec.get("variants"), problem.spec.get("find") or ()
    asked = [answer.asked for answer in problem.spec.answers] + [one.asked for one in (rules.ask if rules else ())]
    heads = {tree.head for one in asked for tree in one.parts.quantities}
    before = len(sheet.steps)
    try:
        if "ritz" in find:
            _ritz(problem, sheet, uses)
        before = len(sheet.steps)
        if "estimates" in find or heads & {"rayleigh", "dunkerley"}:
            bounds = LowestFrequency(about, sheet, found, uses)
            bounds.rayleigh()
            bounds.dunkerley()
    except PhysicsError:
        del sheet.steps[before:]


def _ritz(problem: "Problem", sheet: WorkedSolution, uses: "Sequence[int]") -> None:
    found = problem.modal.result("ritz")
    M, _, _, K = problem.configuration.linear_system.matrices()
    if not all(_reduced(matrix, found.shapes, known) for matrix, known in ((M, found.M), (K, found.K))):
        return
    names = problem.scene.coordinates
    letters = [Name(sheet.letter(f"w{k}")) for k in range(1, len(found.shapes) + 1)]
    shapes = [part for letter, row in zip(letters, found.shapes, strict=True) for part in (
        Words(",  "), letter, f" = ({', '.join(told(float(x)) for x in row)})")]
    order = [part for name in names for part in (", ", Name(name))][1:]
    line = sheet.write(Words("assumed shapes, in the order "), *order, Words(":  "), *shapes[1:], settles="shapes",
                       uses=uses)
    entries = [part for letter, matrix in (("M", found.M), ("K", found.K)) for i, row in enumerate(matrix)
               for j, value in enumerate(row) if j >= i for part in (
                   Words(",  "), letters[i], "·", Name(sheet.matrix(letter)), "·", letters[j], *number(float(value)))]
    head = Words("reduced matrices, row by matrix by column:  ")
    line = sheet.write(head, *entries[1:], settles="reduced matrices", uses=[line])
    for mode in found.modes:
        if mode.omega is not None:
            exact = [] if mode.exact is None else [Words("   (an upper bound of "), told(float(mode.exact)), Words(")")]
            words = "Rayleigh's quotient, its root" if len(found.modes) == 1 else (
                f"root {mode.index} of the determinant of the reduced matrices")
            sheet.write(Words(f"{words}:  "), "ω = " + told(float(mode.omega)), Words(" rad/s"), *exact, uses=[line],
                        settles=f"ritz[{mode.index}]", value=float(mode.omega), unit="rad/s")


def _reduced(matrix: Mapping[tuple[int, int], float], shapes: "Sequence[list[float]]",
             known: "Sequence[list[float]]") -> bool:
    """Is ΦᵀAΦ what the engine has?"""
    size = max(abs(float(x)) for row in known for x in row)
    return all(abs(sum(value * float(one[i]) * float(other[j]) for (i, j), value in matrix.items())
                   - float(known[k][m])) <= CLOSE * size
               for k, one in enumerate(shapes) for m, other in enumerate(shapes))
