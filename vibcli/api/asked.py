"""Which quantities of `answers` hold what a section of a report tells."""

from itertools import combinations_with_replacement

from vibcli.report.sections.mode_tables import LONGEST, shapes_told
from vibcli.report.sections.requested_signals import trees_asked
from vibcli.report.sections.shown_modes import shown, shown_damped

MOST = 12       # coordinates of which matrices and shapes are written out


def _chosen(problem):
    yield from problem.spec.choices


def _coordinates(problem):
    return list(problem.spec.coordinates)[:MOST]


def _equilibrium(problem):
    yield from (f"equilibrium[{q}]" for q in _coordinates(problem))
    if not problem.numeric.has_free_symbols and not problem.scene.held:
        yield "stable"


def _virtual_work(problem):
    if "virtual_work" in (problem.spec.get("find") or ()):
        yield from (f"Q[{q}]" for q in _coordinates(problem))


def _energies(problem):
    yield from ("T", "V")
    if not problem.symbolic.energies["Phi"].is_zero:
        yield "Phi"


def _equations(problem):
    own = [q for q in _coordinates(problem) if problem.scene.pieces or q in problem.symbolic.equations.names]
    yield from (f"motion[{q}]" for q in own)
    yield from (f"equation[{q}]" for q in own)


def _matrices(problem):
    """The entries that are not zero, of symmetric ones each once."""
    names, found = problem.scene.coordinates, problem.symbolic.equations
    if not 2 <= len(names) <= MOST or problem.scene.pieces or found.refusal:
        return
    for letter in "MCGK":
        for i, j in combinations_with_replacement(range(len(names)), 2):
            if getattr(found, letter).get((i, j)):
                yield f"{letter}[{names[i]},{names[j]}]"


def _modes(problem):
    """The modes that are told; of a scene in letters all, in closed form."""
    if problem.numeric.has_free_symbols:
        from vibcli.inverse.letters import closed_modes

        return [(mode, mode.unstable) for mode in closed_modes(problem)]
    return [(mode, mode.growth_rate is not None) for mode in shown(problem)]


def _frequencies(problem):
    yield from (f"{'growth_rate' if unstable else 'omega'}[{mode.index}]" for mode, unstable in _modes(problem))


def _damping(problem):
    modes = ([mode for mode, _ in _modes(problem)] if problem.numeric.has_free_symbols else shown_damped(problem)) or ()
    for mode in modes:
        if mode.zeta is not None:
            yield f"zeta[{mode.index}]"
            yield f"{'omega_d' if mode.omega_d else 'decay'}[{mode.index}]"


def _shapes(problem):
    if len(_coordinates(problem)) < 2 or len(problem.spec.coordinates) > MOST:
        return
    modes = _modes(problem)
    for mode, _ in modes[:shapes_told(len(modes))]:
        yield from (f"mode[{mode.index}][{q}]" for q in _coordinates(problem))


def _kept_up(problem):
    """Amplitude and phase, where there is a steady state of one harmonic."""
    from vibcli.report.document import Report
    from vibcli.report.sections.kept_up import kept_up

    if any(kept_up(problem, Report(problem))):
        for q in _coordinates(problem):
            yield from (f"amplitude({q})", f"phase({q})")


def _response(problem):
    for text, _ in trees_asked(problem, "response"):
        for extreme in ("max", "min"):
            yield from (f"{extreme}({text})", f"arg{extreme}({text})")


def _equilibria(problem):
    yield "equilibria"
    for number in range(1, len(problem.equilibria.items) + 1):
        yield from (f"equilibrium[{q}][{number}]" for q in _coordinates(problem))
        yield f"stable[{number}]"


def _sensitivities(problem):
    found = problem.modal.result("sensitivities")
    for mode in problem.modal.modes.shown()[:LONGEST]:
        yield from (f"sensitivity[{mode.index},{name}]" for name in found.omega if mode.omega)


def _estimates(problem):
    yield from ("rayleigh", "dunkerley")


def _ritz(problem):
    yield from (f"ritz[{mode.index}]" for mode in problem.modal.result("ritz").modes)


ASKED = {"chosen": _chosen, "equilibrium": _equilibrium, "virtual_work": _virtual_work, "energies": _energies,
         "equations": _equations, "matrices": _matrices, "frequencies": _frequencies, "damping": _damping,
         "modes": _shapes, "kept_up": _kept_up, "response": _response, "equilibria": _equilibria,
         "sensitivities": _sensitivities, "estimates": _estimates, "ritz": _ritz}
