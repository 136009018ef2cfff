"""The steady state of scenes with members under loads and driven ends that are sums of sines and cosines: of a signal

    y = y₀ + Σ Re X e^{iΩt},

each X by the equations of power series at its Ω (member_responses.py).
"""

from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference import rated_members
from vibcli.evidence.reference.member_responses import driven_members
from vibcli.evidence.reference.members import START
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.evidence.reference.waves import WavesInTime, in_frequencies, waves
from vibcli.mechanics.linearise import load_at_rest
from vibcli.mechanics.precise_configuration import PreciseConfiguration

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

_READ = {"amplitude": abs, "phase": lambda X: -mpmath.arg(mpmath.mpc(0, 1) * X)}
NOTHING = 8             # beyond half of the working digits a wave is rounding


class GivenInputs(NamedTuple):
    """The WavesInTime of the inputs of these numbers of a Problem."""

    problem: "Problem"
    numbers: list[int]
    waves: WavesInTime

    def phasors(self) -> list[tuple[Any, dict[int, Any]]]:
        """[(Ω, {input: phasor})] at the working precision."""
        known = PreciseConfiguration(self.problem.configuration).with_inputs.values
        known = {**known, self.problem.scene.time.name: mpmath.mpf(0)}
        return [(Omega, dict(zip(self.numbers, parts, strict=True)))
                for Omega, parts in in_frequencies(self.waves, known)[1]]


def given_inputs(problem: "Problem") -> GivenInputs:
    """What moves the inputs of a scene with members."""
    opened = problem.configuration.with_inputs
    scene, nodes = opened.scene, {}
    for number, one in enumerate(scene.inputs.values(), opened.n):
        if one.node is not None:
            nodes[number] = one.node
        elif one.spread is not None:
            nodes[number] = scene.spread_forces[one.spread].weight
        elif one.load is not None:
            _, turning, waving, constant = load_at_rest(scene, scene.forces[one.load])
            if turning.mask:
                raise PhysicsError("no reference is found of a load that turns with what is driven")
            nodes[number] = waving + constant
    return GivenInputs(problem, list(nodes), waves(list(nodes.values()), scene))


def of_rated(given: GivenInputs, signal: str, head: str) -> TrueValues:
    """The amplitude or lag of a signal of members that `damping:` damps."""
    return rated_members.at_frequency(given.problem, signal, lambda: only(given)[0], lambda: only(given)[1],
                                      _READ[head])


def only(given: GivenInputs) -> tuple[Any, dict[int, Any]]:
    """(Ω, {input: phasor}) of loads of one frequency."""
    every = given.phasors()
    if len(every) != 1:
        raise PhysicsError("a reference of steady states of members is found of loads of one frequency")
    return every[0]


def phasor(given: GivenInputs, signal: str) -> tuple[Any, Any, Any]:
    """(X of a signal, Ω, the size of what X is summed of) at the working precision; PhysicsError of several Ω."""
    Omega, inputs = only(given)
    X, size = driven_members(given.problem, signal).at(Omega, inputs)
    return (X if abs(X) > mpmath.mpf(10) ** (NOTHING - mpmath.mp.dps // 2) * size else mpmath.mpc(0)), Omega, size


def of_wave(given: GivenInputs, signal: str, head: str) -> TrueValues:
    """The amplitude |X| of a signal, or the lag θ of X sin(Ωt − θ), −π < θ ≤ π."""
    def found() -> "tuple[list[mpmath.mpf], None]":
        X, _, _ = phasor(given, signal)
        return [_READ[head](X)], None

    return settled(found, DIGITS, START)
