"""All natural modes, and all damped ones, of lumped bodies: rates λ beside those that mpmath finds."""

from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.modal_analysis import ModalAnalysis
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import modal
from vibcli.evidence.reference.settled import relative_error
from vibcli.evidence.subject import MethodAnswer, Subject
from vibcli.quantities.modal import counted

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


def natural(problem: "Problem", _: Any) -> Subject:
    """The rates of the modes without dampers: iω of those that oscillate."""
    elements = _element_data(problem)
    configuration = problem.configuration
    M, _, G, K = elements.arrays()
    gyroscopic = bool(elements.G)
    true = (modal.eigenvalues if gyroscopic else modal.rates)(
        lambda digits: _undamped(configuration.precise_system(digits)))

    def ours():
        modes = ModalAnalysis(configuration).modes
        return MethodAnswer([complex(mode.growth_rate or 0.0, mode.omega or 0.0) for mode in modes],
                     max(mode.error for mode in modes))

    kind = "damped modes" if gyroscopic else "modes"
    return Subject(kind, "omega", f"natural modes, {counted(len(true.values), 'rate')} λ = iω", problem, true, ours,
                   (M, G, K), relative_error)


def damped(problem: "Problem", _: Any) -> Subject:
    """The eigenvalues with dampers, of each conjugate pair one."""
    elements = _element_data(problem)
    if not problem.modal.damps:
        raise PhysicsError("nothing damps: the damped modes are the natural ones", "ask for omega[1]")
    configuration = problem.configuration
    M, C, G, K = elements.arrays()
    true = modal.eigenvalues(configuration.precise_system)

    def ours():
        modes = ModalAnalysis(configuration).damped
        return MethodAnswer([complex(mode.eigenvalue) for mode in modes], max(mode.error for mode in modes))

    title = f"damped modes, {counted(len(true.values), 'eigenvalue')} λ with Im λ ≥ 0"
    return Subject("damped modes", "eigenvalue", title, problem, true, ours, (M, C + G, K), relative_error)


def _element_data(problem):
    elements = problem.configuration.linear_system
    if problem.configuration.sources[0] is None:
        raise PhysicsError("the equilibrium is known to the digits of floats, and no reference can be found there",
                           "change the data by a little")
    return elements


def _undamped(elements):
    return elements.with_parts(dampers=(), C={}, drag={})
