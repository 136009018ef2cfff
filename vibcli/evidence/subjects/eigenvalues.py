"""All natural modes, and all damped ones, of lumped bodies: rates λ beside those that mpmath finds."""

from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.modal_analysis import ModalAnalysis
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import member_damped_modes, members, modal
from vibcli.evidence.reference.settled import relative_error
from vibcli.evidence.subject import MethodAnswer, Subject
from vibcli.evidence.subjects import DAMPED, NATURAL, SUBJECTS
from vibcli.quantities.quantity import counted

if TYPE_CHECKING:
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

LEAST, MOST = 3, 12     # modes of members


def natural(problem: "Problem", tree: Any) -> Subject:
    """The rates of the modes without dampers: iω of those that oscillate; of members the lowest."""
    elements = _element_data(problem)
    if elements.pieces:
        return _of_members(problem, elements, tree)
    configuration = problem.configuration
    M, _, G, K = elements.arrays()
    gyroscopic = bool(elements.G)
    true = (modal.eigenvalues if gyroscopic else modal.rates)(
        lambda digits: _undamped(configuration.precise_system(digits)))

    def ours() -> MethodAnswer:
        return _rates(ModalAnalysis(configuration).modes)

    kind = "damped modes" if gyroscopic else "modes"
    return Subject(kind, "omega", f"natural modes, {counted(len(true.values), 'rate')} λ = iω", problem, true, ours,
                   (M, G, K), relative_error)


def _of_members(problem: "Problem", elements: "FactoredSystem", tree: "QuantityRef") -> Subject:
    """As many as the highest that is asked for, at least so many."""
    configuration, count = problem.configuration, _highest(problem, tree, NATURAL)
    true = modal.as_rates(members.squares(lambda digits: _undamped(configuration.precise_system(digits)), count))

    def ours() -> MethodAnswer:
        return _rates(ModalAnalysis(configuration).modes.first(count))

    return Subject("member modes", "omega", f"natural modes of members, the lowest {count} rates λ = iω", problem, true,
                   ours, (elements.each(float), count), relative_error)


def _highest(problem: "Problem", tree: "QuantityRef", kind: str | tuple[str, str]) -> int:
    asked = [*(part for answer in problem.spec.answers for part in answer.asked.parts.quantities), *[tree] * bool(tree)]
    numbers = [int(part.indices[0]) for part in asked
               if SUBJECTS.get(part.head) == kind and part.indices and part.indices[0].isdecimal()]
    return min(max([*numbers, LEAST]), MOST)


def _rates(modes: "Modes") -> MethodAnswer:
    return MethodAnswer([complex(mode.growth_rate or 0.0, mode.omega or 0.0) for mode in modes],
                        max(mode.error for mode in modes))


def damped(problem: "Problem", tree: Any) -> Subject:
    """The eigenvalues with dampers, of each conjugate pair one."""
    elements = _element_data(problem)
    if problem.modal.member_damping is not None:
        raise PhysicsError("`damping:` gives the modes of members their ratios: there is nothing to compare")
    if not problem.modal.damps:
        raise PhysicsError("nothing damps: the damped modes are the natural ones", "ask for omega[1]")
    if elements.pieces:
        return _damped_of_members(problem, elements, tree)
    configuration = problem.configuration
    M, C, G, K = elements.arrays()
    true = modal.eigenvalues(configuration.precise_system)

    def ours() -> MethodAnswer:
        modes = ModalAnalysis(configuration).damped
        return MethodAnswer([complex(mode.eigenvalue) for mode in modes], max(mode.error for mode in modes))

    title = f"damped modes, {counted(len(true.values), 'eigenvalue')} λ with Im λ ≥ 0"
    return Subject("damped modes", "eigenvalue", title, problem, true, ours, (M, C + G, K), relative_error)


def _damped_of_members(problem: "Problem", elements: "FactoredSystem", tree: "QuantityRef") -> Subject:
    """As many eigenvalues as the highest mode that is asked for, at least so many."""
    configuration, count = problem.configuration, _highest(problem, tree, DAMPED)
    true = member_damped_modes.eigenvalues(configuration.precise_system, count)

    def ours() -> MethodAnswer:
        modes = ModalAnalysis(configuration).damped.first(count)
        return MethodAnswer([complex(mode.eigenvalue) for mode in modes], max(mode.error for mode in modes))

    return Subject("damped member modes", "eigenvalue", f"damped modes of members, the lowest {count} eigenvalues λ "
                   "with Im λ ≥ 0", problem, true, ours, (elements.each(float), count), relative_error)


def _element_data(problem: "Problem") -> "FactoredSystem":
    elements = problem.configuration.linear_system
    if problem.configuration.sources[0] is None:
        raise PhysicsError("the equilibrium is known to the digits of floats, and no reference can be found there",
                           "change the data by a little")
    return elements


def _undamped(elements: "FactoredSystem") -> "FactoredSystem":
    return elements.with_parts(dampers=(), C={}, drag={})
