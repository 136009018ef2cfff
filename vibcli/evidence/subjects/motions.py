"""Numbers of a motion in time: values at instants, extremes and where they are, of coordinates and their rates."""

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.evidence.meshed_members import members_in_time
from vibcli.evidence.plain_equations import PlainEquations, plain_equations
from vibcli.evidence.reference import member_fronts, member_vibrations, periodic, swings
from vibcli.evidence.reference import motion as reference
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.outputs import signal
from vibcli.evidence.reference.taylor_steps import TakesMinutes
from vibcli.evidence.subject import Subject, of_signal
from vibcli.evidence.subjects.long_after import steady_value
from vibcli.evidence.subjects.vibrations import exact, of_envelope
from vibcli.quantities.expression import measure, number_of
from vibcli.symbolic.evaluation import evaluate_rational
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.base.work import Work
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SENSES = {"max": 1, "min": -1, "argmax": 1, "argmin": -1}
AHEAD = 2.05        # periods, in which three turns of a rate are
STEADY = "steady"
KINDS = {"small": "motion", "full": "full motion", "prescribed": "full motion", STEADY: "steady motion"}


def of_motion(problem: "Problem", tree: QuantityRef) -> Subject:
    """A value, max, min, argmax, argmin or zero of a signal."""
    if problem.scene.pieces:
        return of_member_motion(problem, tree)
    if getattr(tree.args[0], "head", "") == "envelope":
        return of_envelope(problem, tree)
    kind, motion = followed(problem)
    of, feature, keeps_on = tree.args[0], tree.head, getattr(tree.args[0], "head", "") == "steady"
    if keeps_on:
        try:
            of, motion = of.args[0], _kept_up(kind, motion, problem.work)
        except PhysicsError as error:           # of loads that do not repeat themselves
            return _long_after(problem, tree, error)
    motion, node = signal(problem, motion, of)
    if tree.head in SENSES:
        until = Fraction(problem.response.until)
        problem, until, true, cut = _until(problem, until, lambda end: reference.extremes(
            motion, node, end, SENSES[tree.head], tree.head.startswith("arg"), problem.work))
    elif tree.head == "zero":
        until, cut, feature = Fraction(problem.response.until), "", f"zero {tree.indices[0]}"
        true = reference.zeros(motion, node, until, int(tree.indices[0]), problem.work)
    else:
        until, cut, feature = instant(problem, tree.args[1]), "", "value"
        true = reference.at_instant(motion, node, until, problem.work)
    plain = None if motion.parts.gaps or motion.blows else compared_with(problem, motion, node, until, feature)
    kind = STEADY if keeps_on else kind
    return of_signal(KINDS[kind], problem, tree, f"of {problem.response.words}{cut}", true, plain)


def of_member_motion(problem: "Problem", tree: QuantityRef) -> Subject:
    """A value, max, min, argmax or argmin of a single signal."""
    of = tree.args[0]
    if not isinstance(of, NameRef) or tree.head not in (*SENSES, "value"):
        raise PhysicsError("of motions of members a reference is found of values and extremes of single signals")
    name = of.name + "'" * of.primes
    bends = problem.spec.get("damping") is not None or any(
        placed.piece.order == 4 for placed in problem.configuration.linear_system.pieces)
    until = problem.response.until
    if tree.head == "value":
        until = number_of(problem, tree.args[1])
        true = (member_vibrations.at_instant if bends else member_fronts.at_instant)(
            problem, name, exact(problem, tree.args[1]))
    else:
        true = (member_vibrations.extremes if bends else member_fronts.extremes)(
            problem, name, until, SENSES[tree.head], tree.head.startswith("arg"))
    return of_signal("member motion", problem, tree, f"of {problem.response.words}", true,
                     members_in_time(problem, name, until, tree.head))


def period(problem: "Problem", tree: QuantityRef) -> Subject:
    """period(x) of the only coordinate, where nothing drives it and nothing strikes."""
    kind, motion = followed(problem)
    if problem.scene.timed or len(problem.scene.q) > 1 or not isinstance(tree.args[0], NameRef):
        raise PhysicsError("of periods a reference is found where nothing drives the only coordinate, and of it alone")
    if motion.blows:
        raise PhysicsError("no reference is found of periods of what strikes or is struck")
    about = measure(problem, tree)[0]
    until = Fraction(AHEAD * about)
    try:
        true = reference.period(motion, tree.args[0].name, until, problem.work)
        plain = None if motion.parts.gaps else compared_with(problem, motion, motion.scene.v[0], until, "period")
    except PhysicsError:            # of what bends or jumps with the motion
        true = swings.period(motion, problem.numeric.size_along(motion.scene.coordinates[0]))
        plain = plain_equations(motion, motion.scene.v[0], float(until), "period")
    return of_signal(KINDS[kind], problem, tree, f"of {problem.response.words}", true, plain)


def compared_with(problem: "Problem", motion: Motion, node: "Node", until: Fraction, feature: str) -> PlainEquations:
    """What others are given, with the sizes of what they integrate."""
    sizes = np.array(motion.sizes(until, problem.work))
    return plain_equations(motion, node, float(until), feature)._replace(sizes=sizes)


def _kept_up(kind: str, motion: Motion, work: "Work") -> Motion:
    """The motion that is left of one when all else has died out."""
    if kind != "small":
        raise PhysicsError("no reference is found of the steady state of a full motion")
    return periodic.steady(motion, work).motion


def _long_after(problem: "Problem", tree: QuantityRef, error: PhysicsError) -> Subject:
    """Of loads that are powers of the time; `error` of others."""
    if tree.head != "value":
        raise error
    try:
        return steady_value(problem, tree)
    except PhysicsError:
        raise error from None


def followed(problem: "Problem") -> tuple[str, Motion]:
    """(what kind of motion it is, the Motion of the reference)."""
    from vibcli.results.expanded_response import ExpandedResponse

    kind = problem.response.KIND
    if isinstance(problem.response, ExpandedResponse):
        if not problem.configuration.equilibrium.drawn:
            raise PhysicsError("these equations are expanded about a place that is known to the digits of floats: no "
                               "reference is found")
        return kind, reference.full(problem.about(problem.response.expanded))
    if kind not in KINDS:
        raise PhysicsError("no reference is found of this kind of motion")
    return kind, (reference.small if kind == "small" else reference.full)(problem)


def _until(problem: "Problem", end: Fraction,
           found: "Callable[..., TrueValues]") -> "tuple[Problem, Fraction, TrueValues, str]":
    """(problem, end, true values, words) of a motion up to an end; up to an earlier one where that takes minutes."""
    try:
        return problem, end, found(end), ""
    except TakesMinutes as error:
        cut = Fraction(round(error.reached * 0.4, 3)).limit_denominator(1000)
        return problem.until(float(cut)), Fraction(float(cut)), found(Fraction(float(cut))), (
            f", cut at t = {float(cut):.6g} s: beyond, the reference takes minutes")


def instant(problem: "Problem", tree: Any) -> Fraction:
    """An instant, exactly where it is rational."""
    found = evaluate_rational([lower(tree, problem.scene.table, lambda name, *_: problem.scene.parameters.nodes[name])],
                              problem.numeric.rational)
    return Fraction(number_of(problem, tree)) if found is None else found[0]
