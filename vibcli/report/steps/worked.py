"""All steps of a scene."""

from contextlib import suppress
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.nonsmooth import require_smooth
from vibcli.report.measured import with_units
from vibcli.report.steps.asked import tell_asked
from vibcli.report.steps.by_amplitude import tell_by_amplitude
from vibcli.report.steps.chosen import tell_chosen, tell_chosen_motion, with_letters
from vibcli.report.steps.coordinates import tell_conditions, tell_constraints, tell_coordinates, tell_loops
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.dry_friction import tell_friction
from vibcli.report.steps.expansion import tell_expansion
from vibcli.report.steps.full_equations import FullEquations
from vibcli.report.steps.held import HINT, UNTOLD, SmallEquations, Untold
from vibcli.report.steps.linearised import linearised
from vibcli.report.steps.members import MemberSteps
from vibcli.report.steps.members_about_rest import tell_members_about_rest
from vibcli.report.steps.motion_in_time import tell_motion
from vibcli.report.steps.one_degree import OneDegree
from vibcli.report.steps.place_of_rest import about_rest
from vibcli.report.steps.reactions import tell_accelerations, tell_forces, tell_statics
from vibcli.report.steps.repeated_lines import without_repeats
from vibcli.report.steps.several_degrees import SeveralDegrees
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.small_oscillations import Derivation
from vibcli.report.steps.step import WorkedLine, WorkedSolution
from vibcli.report.steps.told_before import settle_told

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

MOST = 12           # coordinates, beyond which the steps are no page to read
ENERGIES = {"T", "V"}       # quantities that are none of small oscillations


def worked(problem: "Problem") -> list[WorkedLine]:
    """The steps of a scene: to its equations of motion where these are asked, or small oscillations are not told apart
    element by element; then to its small oscillations."""
    _require_told(problem)
    problem = with_units(problem, asked=True)
    sheet = _sheet_of(problem)
    tell_expansion(problem, sheet)
    tell_by_amplitude(problem, sheet)
    if problem.choice is not None:
        tell_chosen(problem, sheet)
        tell_chosen_motion(problem, sheet)
    settle_told(problem, sheet)
    tell_asked(problem, sheet)
    return without_repeats(sheet.steps)


def _sheet_of(problem: "Problem") -> WorkedSolution:
    if problem.scene.held:
        sheet = _sheet(problem)
        tell_statics(problem, sheet)
        return sheet
    if problem.scene.pieces:
        sheet = _sheet(problem)
        if problem.symbolic.linearisable or problem.numeric.has_free_symbols:
            MemberSteps(problem, sheet).write()
        else:
            tell_members_about_rest(problem, sheet)
        return sheet
    sheet = _told(with_letters(problem))
    tell_forces(problem, sheet)
    return sheet


def _told(problem: "Problem") -> WorkedSolution:
    if asks_in_full(problem) or not problem.scene.q:
        return _in_full(problem)
    try:
        return _small(problem)
    except PhysicsError as refusal:
        with suppress(PhysicsError):
            return _in_full(problem)
        raise refusal


def _sheet(problem: "Problem") -> WorkedSolution:
    return WorkedSolution([*problem.spec.parameters, *problem.spec.coordinates, *problem.scene.coordinates])


def _small(problem: "Problem") -> WorkedSolution:
    _require_small(problem)
    sheet = _sheet(problem)
    tell_coordinates(problem, problem.scene, sheet)
    tell_constraints(problem, sheet)
    conditions = tell_conditions(problem, sheet)
    about = about_rest(problem, sheet)
    tell_loops(about, sheet, conditions)
    _solved(about, sheet, Derivation(about, sheet).equations())
    if problem.scene.loops is not None:
        from vibcli.report.steps.first_order_multipliers import tell_first_order_multipliers

        tell_first_order_multipliers(about, sheet)
    return sheet


def _in_full(problem: "Problem") -> WorkedSolution:
    """The equations of motion, and what follows for small oscillations where there are any."""
    sheet, loose = _sheet(problem), problem.system.scene_with_multipliers
    tell_coordinates(problem, loose, sheet)
    tell_constraints(problem, sheet)
    conditions = tell_conditions(problem, sheet)
    lines = FullEquations(problem, sheet).write(conditions)
    tell_accelerations(problem, sheet, lines)
    (tell_motion if problem.system.sticking is None else tell_friction)(problem, sheet, lines)
    before = len(sheet.steps)
    try:
        if problem.system.sticking is not None or not problem.scene.q:
            return sheet
        _require_slope(problem)
        about = about_rest(problem, sheet)
        if loose is problem.scene:
            found = linearised(about, sheet, problem.symbolic.equations.full, lines)
        else:
            _require_small(problem)
            tell_loops(about, sheet, conditions)
            found = Derivation(about, sheet).equations()
        _solved(about, sheet, found)
    except PhysicsError:
        del sheet.steps[before:]
    return sheet


def _solved(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
    if len(about.scene.q) == 1:
        OneDegree(Degree(about, sheet, found)).write()
    else:
        SeveralDegrees(about, sheet, found).write()


def asks_in_full(problem: "Problem") -> bool:
    """Does a scene ask for energies or equations that are not expanded? Of closed loops energies alone are told about
    rest."""
    spec = problem.spec
    heads = {tree.head for answer in spec.answers for tree in answer.asked.parts.quantities
             if not tree.indices or tree.head == "motion"}
    if spec.expanded:
        return False
    return spec.motion == "full" or "equations" in (spec.get("find") or ()) or "motion" in heads or bool(
        heads & ENERGIES and problem.scene.loops is None)


def _require_told(problem: "Problem") -> None:
    """PhysicsError of scenes whose steps are not told."""
    scene = problem.scene
    if not (scene.q or scene.pieces or scene.held or problem.system.scene_with_multipliers.q):
        raise PhysicsError("nothing moves freely in this scene: there are no steps to an equation of motion", HINT)
    if len(scene.q) > MOST and not scene.pieces:
        raise PhysicsError(f"steps are told of up to {MOST} coordinates, and this scene has {len(scene.q)}", HINT)


def _require_small(problem: "Problem") -> None:
    """Untold of scenes whose small oscillations are not told element by element."""
    scene = problem.scene
    if scene.loops is not None and scene.timed and scene.vibrating is not scene:
        raise Untold("the steps of closed loops that are driven are not told one by one", HINT)
    if problem.system.sticking is not None or problem.spec.get("matrices"):
        raise Untold(UNTOLD, HINT)
    _require_slope(problem)


def _require_slope(problem: "Problem") -> None:
    """Kinked where forces have no slope at rest."""
    if not problem.numeric.has_free_symbols:
        require_smooth(problem.configuration)
