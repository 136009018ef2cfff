"""Steady states under loads of one frequency: amplitudes and phases, means and rms values."""

import cmath
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.evidence.plain_equations import plain_equations
from vibcli.evidence.reference import (
    harmonics,
    many_waves,
    member_responses,
    member_steady_states,
    periodic,
    rated_members,
    steady_state,
)
from vibcli.evidence.reference.frequency_response import in_floats
from vibcli.evidence.reference.motion import small
from vibcli.evidence.reference.outputs import signal
from vibcli.evidence.reference.settled import relative_error
from vibcli.evidence.subject import MethodAnswer, Subject, of_signal
from vibcli.evidence.subjects.vibrations import of_one
from vibcli.quantities.expression import measure
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.evidence.reference.motion import Motion
    from vibcli.evidence.reference.periodic import NoCommonPeriod
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.evidence.reference.steady_state import HarmonicLoads
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

TITLE = "steady state under loads of one frequency"
PERIODS = 40        # of the slowest wave, over which means without a common period are taken
FEW = 64            # bits of a period to which sizes are looked at
READ: dict[str, Any] = {"amplitude": abs, "phase": lambda X: -cmath.phase(1j * X)}     # of X in Re X e^{iΩt}


def of_wave(problem: "Problem", tree: QuantityRef) -> Subject:
    """amplitude(x) or phase(x) of a linear signal under loads of one frequency."""
    if problem.configuration.linear_system.pieces:
        return _of_members(problem, tree)
    if not problem.scene.timed:
        return of_one(problem, tree)
    known, node = _driven(problem, tree)
    true = steady_state.of_wave(known, node, tree.head)
    with mpmath.workdps(30):
        exact, Omega = steady_state.transfer(known, node)
    data = in_floats(exact), float(Omega), READ[tree.head]
    return _wave(problem, tree, "response", true, data)


def _of_members(problem: "Problem", tree: QuantityRef) -> Subject:
    """The same of a scene with members."""
    of = tree.args[0]
    if not isinstance(of, NameRef):
        raise PhysicsError("of scenes with members a reference is found of single signals")
    text = of.name + "'" * of.primes
    given = member_steady_states.given_inputs(problem)
    rated = problem.spec.get("damping") is not None
    find = member_steady_states.of_rated if rated else member_steady_states.of_wave
    true, damping = find(given, text, tree.head), rated_members.damping_of(problem, text) if rated else None
    with mpmath.workdps(30):
        Omega, inputs = member_steady_states.only(given)
    data = *member_responses.driven_in_floats(problem, text, lambda: inputs, rated), damping
    return _wave(problem, tree, "rated response" if rated else "member response", true,
                 (*data, float(Omega), READ[tree.head]))


def _wave(problem: "Problem", tree: QuantityRef, kind: str, true: "TrueValues", data: tuple[Any, ...]) -> Subject:
    def ours() -> MethodAnswer:
        value, bound = measure(problem.afresh(), tree)
        return MethodAnswer([value], float(bound) * (abs(value) if tree.head == "phase" else 1))

    return Subject(kind, tree.text, TITLE, problem, true, ours, data,
                   _turned if tree.head == "phase" else relative_error)


def harmonic(problem: "Problem", tree: QuantityRef) -> Subject:
    """harmonic[n](x) of a linear signal; the others are given what the Fourier series of the loads has."""
    motion, node = _small_signal(problem, tree)
    number = int(tree.indices[0])
    loads = harmonics.repeated(motion)
    true = harmonics.harmonic(loads, node, number)
    with mpmath.workdps(30):
        exact, Omega = harmonics.transfer(loads, node, number)
    return of_signal("response", problem, tree, "steady state under a load that repeats itself", true,
                     (in_floats(exact), float(Omega), abs))


def over_a_period(problem: "Problem", tree: QuantityRef) -> Subject:
    """mean(x) or rms(x) of a signal, be it a power or a product, under loads of one frequency, or such as repeat."""
    motion, node = _small_signal(problem, tree)
    try:
        known = steady_state.driven(motion)
        true = steady_state.over_a_period(known, node, tree.head)
    except PhysicsError:
        try:
            return _over_a_common_period(problem, tree, motion, node)
        except periodic.NoCommonPeriod as error:
            return _over_all_times(problem, tree, motion, node, error)
    with mpmath.workdps(30):
        period, start, sizes = steady_state.at_the_start(known)
    plain = plain_equations(known.motion, node, period, tree.head)._replace(
        start=np.array(start), sizes=np.array(sizes))
    return of_signal("steady motion", problem, tree, TITLE, true, plain)


def _over_a_common_period(problem: "Problem", tree: QuantityRef, motion: "Motion", node: "Node") -> Subject:
    known = periodic.steady(motion, problem.work)
    true = periodic.over_a_period(known, node, tree.head, problem.work)
    period, start = periodic.at_the_start(known)
    sizes = known.motion.sizes(known.period(FEW), problem.work)
    plain = plain_equations(known.motion, node, period, tree.head)._replace(
        start=np.array(start), sizes=np.array(sizes))
    return of_signal("steady motion", problem, tree, "steady state under loads that repeat themselves", true, plain)


def _over_all_times(problem: "Problem", tree: QuantityRef, motion: "Motion", node: "Node",
                    error: "NoCommonPeriod") -> Subject:
    """Others follow it over many periods of the slowest wave, from the steady state on; `error` where loads are no sums
    of waves."""
    try:
        known = many_waves.steady_waves(motion, node)
        true = many_waves.over_all_times(known, tree.head)
    except PhysicsError:
        raise error from None
    with mpmath.workdps(30):
        slowest, start, sizes = many_waves.at_the_start(known)
    plain = plain_equations(motion, node, PERIODS * slowest, tree.head)._replace(
        start=np.array(start), sizes=np.array(sizes))
    return of_signal("steady motion", problem, tree, "steady state under loads without a common period", true, plain)


def _driven(problem: "Problem", tree: QuantityRef) -> "tuple[HarmonicLoads, Node]":
    """(HarmonicLoads, the expression of the signal) of a quantity of one."""
    motion, node = _small_signal(problem, tree)
    return steady_state.driven(motion), node


def _small_signal(problem: "Problem", tree: QuantityRef) -> "tuple[Motion, Node]":
    if problem.response.KIND != "small":
        raise PhysicsError("no reference is found of steady states of this kind of motion")
    return signal(problem, small(problem), tree.args[0])


def _turned(found: Sequence[float], true: "TrueValues") -> float:
    """Between two angles, in full turns."""
    with mpmath.workdps(true.working):
        return float(abs(mpmath.arg(mpmath.expj(mpmath.mpf(float(found[0])) - true.values[0]))))
