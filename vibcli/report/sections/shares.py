"""Shares of the elements in the energy of the modes."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import figure, with_minus
from vibcli.report.blocks import Section, paragraph
from vibcli.report.keys import Key
from vibcli.report.sections.insight import NOTHING, grid, numbered, require_numbers, without_end

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def shares(problem: "Problem", _: "Report") -> Iterator[Section]:
    require_numbers(problem, "shares")
    if not problem.modal.modes.finite:
        yield from without_end("Shares of the energy of modes", "shares")
        return
    found = problem.modal.result("shares")
    potential = [(f"mode {i}", column) for i, column in found.potential.items() if column]
    lowering = any(share < -NOTHING / 100 for _, column in potential for share in column.values())
    told = [paragraph("(negative: it lowers the stiffness of the mode)", hang=None)] * lowering
    told += [paragraph(f"(modes {numbered(group)} have one frequency: only the means of their shares are definite)",
                       hang=None) for group in found.coinciding]
    yield from grid("Shares of the potential energy [%]", potential, _per_cent, *told)
    yield from grid("Shares of the kinetic energy [%]",
                     [(f"mode {i}", column) for i, column in found.kinetic.items()], _per_cent)
    if found.dissipation is not None:
        yield from grid("Shares of the energy that the damped modes lose [%]",
                         [(_damped_head(mode), column) for mode, column in found.dissipation if column], _per_cent)


def _per_cent(share: float | None) -> str:
    return "–" if share is None else figure(0.0 if abs(100 * share) < NOTHING else 100 * share, digits=4)


def _damped_head(mode: Any) -> str:
    """`mode 2`, with the eigenvalue where it is one of several real ones of the mode."""
    real = not mode.eigenvalue.imag
    return f"mode {mode.index}" + (f" (λ = {with_minus(float(mode.eigenvalue.real), 4)})" if real else "")


KEY = Key("shares", "whose energy each mode has, in fractions of one; negative those of what lowers the stiffness",
          lambda problem: problem.modal.result("shares") if problem.modal.modes.finite else None, of=(
    Key("modes", "a list, one entry to each mode", lambda found: [
        {"index": i, "potential": found.potential[i], "kinetic": found.kinetic[i]} for i in found.kinetic], each=(
            Key("index", "number of the mode"),
            Key("potential", "{name of a spring, `tension of` it, `the weights` or `written out`: share}; empty of a "
                "rigid mode"),
            Key("kinetic", "{name of a body, or `written out`: share}"))),
    Key("damped", "a list, one entry to each eigenvalue; null where nothing damps",
        lambda found: found.dissipation, each=(
            Key("index", "number of the damped mode", lambda one: one[0].index),
            Key("dissipation", "{name of a damper: its share of the energy that is lost}", lambda one: one[1])))))
