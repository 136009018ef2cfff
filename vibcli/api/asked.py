"""Which quantities of `answers` hold what a section of a report tells."""

from collections.abc import Iterator, Sequence
from itertools import combinations_with_replacement, pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.base.errors import PhysicsError
from vibcli.language.parameter_samples import given_values
from vibcli.report.sections.mode_tables import LONGEST, repeated, shapes_told
from vibcli.report.sections.requested_signals import trees_asked
from vibcli.report.sections.shown_modes import shown, shown_damped
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import is_zero

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MOST = 12       # coordinates of which matrices and shapes are written out
SAMPLES, ALIKE = 8, 1e-9        # sets of values of letters; what is rounding of a frequency


def _chosen(problem: "Problem") -> Iterator[str]:
    yield from problem.spec.choices


def _coordinates(problem: "Problem") -> list[str]:
    return list(problem.spec.coordinates)[:MOST]


def _equilibrium(problem: "Problem") -> Iterator[str]:
    yield from (f"equilibrium[{q}]" for q in _coordinates(problem))
    if not problem.numeric.has_free_symbols and not problem.scene.held:
        yield "stable"


def _virtual_work(problem: "Problem") -> Iterator[str]:
    if "virtual_work" in (problem.spec.get("find") or ()):
        yield from (f"Q[{q}]" for q in _coordinates(problem))


def _energies(problem: "Problem") -> Iterator[str]:
    yield from ("T", "V")
    if not problem.symbolic.energies["Phi"].is_zero:
        yield "Phi"


def _equations(problem: "Problem") -> Iterator[str]:
    own = [q for q in _coordinates(problem) if problem.scene.pieces or q in problem.symbolic.equations.names]
    yield from (f"motion[{q}]" for q in own)
    yield from (f"equation[{q}]" for q in own)


def _matrices(problem: "Problem") -> Iterator[str]:
    """The entries that are not zero, of symmetric ones each once."""
    names, found = problem.scene.coordinates, problem.symbolic.equations
    if not 2 <= len(names) <= MOST or problem.scene.pieces or found.refusal:
        return
    for letter in "MCGK":
        for i, j in combinations_with_replacement(range(len(names)), 2):
            if getattr(found, letter).get((i, j)):
                yield f"{letter}[{names[i]},{names[j]}]"


def _modes(problem: "Problem", damped: bool = False) -> list[tuple[Any, bool]]:
    """Each mode that is told, and does it grow; in letters all, in closed form, or those that are `damped`."""
    if problem.numeric.has_free_symbols:
        from vibcli.quantities.letters import closed_modes

        modes = [mode for mode in closed_modes(problem) if not damped or mode.zeta is not None]
        _require_ordered(problem, [mode.omega for mode in modes if not mode.unstable])
        return [(mode, mode.unstable) for mode in modes]
    return [(mode, mode.growth_rate is not None) for mode in shown(problem)]


def _require_ordered(problem: "Problem", omegas: "list[Node]") -> None:
    """Refuse modes whose numbers hang on the values of the letters."""
    scene = problem.scene
    for attempt in range(SAMPLES):
        letters = given_values(scene.parameters, scene.sample, scene.parameters.free, attempt)
        values = scene.parameters.values(Floats, {name: float(value) for name, value in letters.items()})
        found = evaluate(omegas, Floats, values)
        if any(b < a * (1 - ALIKE) for a, b in pairwise(found)):
            raise PhysicsError("the letters leave open which of the modes has the lower frequency")


def _frequencies(problem: "Problem") -> Iterator[str]:
    yield from (f"{'growth_rate' if unstable else 'omega'}[{mode.index}]" for mode, unstable in _modes(problem))


def _damping(problem: "Problem") -> Iterator[str]:
    letters = problem.numeric.has_free_symbols
    for mode in [mode for mode, _ in _modes(problem, True)] if letters else shown_damped(problem) or ():
        if mode.zeta is not None:
            yield f"zeta[{mode.index}]"
            yield f"{'omega_d' if _is_some(mode.omega_d) else 'decay'}[{mode.index}]"


def _is_some(rate: "float | Node") -> bool:
    """Is a rate, in letters or a number, there and not zero?"""
    return rate is not None and not (rate.is_zero if hasattr(rate, "is_zero") else rate == 0)


def _shapes(problem: "Problem") -> Iterator[str]:
    if len(_coordinates(problem)) < 2 or len(problem.spec.coordinates) > MOST:
        return
    modes = [mode for mode, _ in _modes(problem)]
    shared = _of_one_frequency(problem, modes)
    for mode in modes[:shapes_told(len(modes))]:
        if mode.index not in shared:
            yield from (f"mode[{mode.index}][{q}]" for q in _coordinates(problem))
    if shared:
        numbers = listed([str(number) for number in sorted(shared)])
        raise PhysicsError(f"modes {numbers} share a frequency: each mix of their shapes is one")


def _of_one_frequency(problem: "Problem", modes: Sequence[Any]) -> set[int]:
    """The numbers of modes that have the frequency of another."""
    if not problem.numeric.has_free_symbols:
        return set(repeated(modes))
    known = [mode for mode in modes if mode.omega is not None]
    return {number for a, b in pairwise(known) if is_zero(a.omega - b.omega) for number in (a.index, b.index)}


def _kept_up(problem: "Problem") -> Iterator[str]:
    """Amplitude and phase, where there is a steady state of one harmonic."""
    from vibcli.report.document import Report
    from vibcli.report.sections.kept_up import kept_up

    if any(kept_up(problem, Report(problem))):
        for q in _coordinates(problem):
            yield from (f"amplitude({q})", f"phase({q})")


def _response(problem: "Problem") -> Iterator[str]:
    for text, _ in trees_asked(problem, "response"):
        for extreme in ("max", "min"):
            yield from (f"{extreme}({text})", f"arg{extreme}({text})")


def _equilibria(problem: "Problem") -> Iterator[str]:
    yield "equilibria"
    for number in range(1, len(problem.equilibria.items) + 1):
        yield from (f"equilibrium[{q}][{number}]" for q in _coordinates(problem))
        yield f"stable[{number}]"


def _sensitivities(problem: "Problem") -> Iterator[str]:
    found = problem.modal.result("sensitivities")
    for mode in problem.modal.modes.shown()[:LONGEST]:
        yield from (f"sensitivity[{mode.index},{name}]" for name in found.omega if mode.omega)


def _estimates(problem: "Problem") -> Iterator[str]:
    yield from ("rayleigh", "dunkerley")


def _ritz(problem: "Problem") -> Iterator[str]:
    yield from (f"ritz[{mode.index}]" for mode in problem.modal.result("ritz").modes)


ASKED = {"chosen": _chosen, "equilibrium": _equilibrium, "virtual_work": _virtual_work, "energies": _energies,
         "equations": _equations, "matrices": _matrices, "frequencies": _frequencies, "damping": _damping,
         "modes": _shapes, "kept_up": _kept_up, "response": _response, "equilibria": _equilibria,
         "sensitivities": _sensitivities, "estimates": _estimates, "ritz": _ritz}
