"""Features of motions to many digits: of small ones from M, C, K and what drives them, of full ones from the equations.

    small:  M q̈ + (C + G) q̇ + K q = Q(t), q counted from the equilibrium;      full:  M(q, t) q̈ = −h(q, q̇, t)

with numbers from the element data and the start as the file gives it; both are followed in Taylor series.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, cast

import mpmath

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.analyses.time_integration.smooth_pieces import SmoothPieces
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.blows import Blows, blows, without_impulses
from vibcli.evidence.reference.features import SignalAlongSteps, extreme, value
from vibcli.evidence.reference.features import zeros as first_zeros
from vibcli.evidence.reference.forces_along import TrueForces
from vibcli.evidence.reference.records import PiecesOfRecords, driving_records, strikes
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.evidence.reference.static_positions import equations
from vibcli.evidence.reference.switched_steps import SwitchedSteps
from vibcli.evidence.reference.switches import Switches, bends
from vibcli.evidence.reference.taylor_steps import TaylorSteps, bits_of
from vibcli.mechanics.equations_of_motion import Dynamics
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import multiprecision

if TYPE_CHECKING:
    from vibcli.base.work import Work
    from vibcli.mechanics.configuration import Configuration
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SMALL, FULL = (40, 60), (30, 45)        # digits that have to be alike, and those of the first attempt
GROWTH, LIMIT = 1.3, 240
FEW = 12                # digits: of sizes
WORK = 5e7              # products of numbers of one motion, some ten seconds


class Motion(NamedTuple):
    """The equations of a scene, `values(bits)`: {parameter: number}, `start(bits)`: [q, q̇]; floats:
    {parameter: float}; digits: that have to be alike, and first ones; rested: are coordinates counted from rest?
    blows(bits): of impulses, None without; taut: forces of ropes, which do not push."""

    scene: "Scene"
    parts: Dynamics
    values: Callable[[int], Mapping[str, Any]]
    start: Callable[[int], list[int]]
    floats: Mapping[str, float]
    digits: tuple[int, int]
    rested: bool
    blows: Callable[[int], Blows] | None = None
    taut: "Sequence[Node]" = ()

    def coordinate(self, name: str, primes: int = 0) -> "Node":
        """A coordinate as it is told, counted from where its equations do not, or a rate of it."""
        node, table = self.scene.symbol(name, primes), self.scene.table
        return node if primes or not self.rested else node + table.parameter(_rest_of(name), positive=False)

    def signal(self, node: "Node") -> SignalAlongSteps:
        """An expression of its coordinates along it."""
        scene, slopes = self.scene, gradient(node)
        jerks = [slopes[a] * scene.table.parameter(a.name + "'", positive=False) for a in scene.a if a in slopes]
        return SignalAlongSteps(node, scene.table.total([scene.rate(node), *jerks]), scene.coordinates, scene.time.name,
                                self.values, bool(jerks))

    def steps(self, until: Fraction, digits: int, work: Any, spent: float = WORK) -> TaylorSteps:
        """It, followed to an instant."""
        records = driving_records(self.scene, self.parts.nodes())

        def pieces(parts: Dynamics) -> SmoothPieces:
            return (partial(PiecesOfRecords, records) if records else SmoothPieces)(
                self.scene, parts, self.values, self.floats, float(until) * (1 + 1e-12), work)

        if self.taut or bends(self.scene, self.parts.nodes()):
            switches = Switches(self.scene, self.parts, pieces, self.floats, self.taut)
            return SwitchedSteps(switches, self.values, self.start, until, digits, spent)
        return TaylorSteps(pieces(self.parts), self.start, until, digits, spent, self.blows)

    def sizes(self, until: Fraction, work: Any) -> list[float]:
        """The largest magnitude of each of q and q̇ until an instant, where they are not all the time 0."""
        found = self.steps(until, FEW, work).sizes
        return [max(size, sum(found) * 2.0**-52) or 1.0 for size in found]


def small(problem: "Problem") -> Motion:
    """The Motion of small oscillations; PhysicsError where the data are known to floats alone, or there is none."""
    from vibcli.results.high_precision_response import given_start

    configuration, scene, n = problem.configuration, problem.scene, len(problem.scene.q)
    if configuration.sources[0] is None:
        raise PhysicsError("the equilibrium is known to the digits of floats: no reference is found")
    if configuration.linear_system.massless:
        raise PhysicsError("no reference is found of motions in which coordinates have no inertia")
    (drive, struck), table, known = without_impulses(scene, _drive(problem)), scene.table, {}
    let_go = equations(configuration.preloaded) if configuration.preloaded is not None else None
    letters = {(part, i, j): table.parameter(f"{part}[{i};{j}]", positive=False)
               for part in "MCK" for i in range(n) for j in range(n)}

    def numbers(bits: int) -> "dict[str, mpmath.mpf]":
        if bits not in known:
            with mpmath.workprec(2 * bits):
                M, C, G, K = configuration.precise_system(mpmath.mp.dps).matrices()
                found = dict(configuration.numeric.values(multiprecision()))
                for (part, i, j), letter in letters.items():
                    entries = {"M": M, "C": C, "K": K}[part]
                    found[letter.name] = entries.get((i, j), mpmath.mpf(0)) + (G.get((i, j), 0) if part == "C" else 0)
                rest = _rest(configuration, bits)
                known[bits] = {**found, **{_rest_of(name): rest[name] for name in scene.coordinates}}
        return known[bits]

    def deviations(bits: int) -> "list[int]":
        with mpmath.workprec(2 * bits):
            rest = {name: numbers(bits)[_rest_of(name)] for name in scene.coordinates}
            held = rest if let_go is None else let_go.root(numbers(bits))
            places, speeds = given_start(problem, numbers(bits), held)
            return [fixed_point(places[name] - rest[name], bits) for name in scene.coordinates] + [
                fixed_point(speeds[name], bits) for name in scene.coordinates]

    first = {name: float(x) for name, x in numbers(64).items()}
    entries = {key: letter for key, letter in letters.items() if first[letter.name]}
    h = [table.total([*(letter * (scene.v[j] if part == "C" else scene.q[j]) for (part, k, j), letter in
                        entries.items() if k == i and part != "M"), -drive.get(i, table.zero)]) for i in range(n)]
    M = {(i, j): letter for (part, i, j), letter in entries.items() if part == "M" and i <= j}

    def inertia(values: "Mapping[str, mpmath.mpf]") -> mpmath.matrix:
        return mpmath.matrix([[values[letters["M", i, j].name] for j in range(n)] for i in range(n)])

    return Motion(scene, Dynamics(M, h, [], [], [], {}, []), numbers, deviations, first, SMALL, True,
                  blows(scene, struck, numbers, inertia) if struck else None)


def _drive(problem: "Problem") -> "dict[int, Node]":
    """{i: Q(t)}, about an equilibrium that is not the drawn one in letters for its place."""
    from vibcli.mechanics.autonomous import excitation

    configuration, scene = problem.configuration, problem.scene
    if not scene.timed or configuration.equilibrium.drawn or configuration.system.is_linear:
        return cast("dict[int, Node]", problem.response.drive)
    if scene.vibrating is not scene or problem.spec.get("damping") is not None:
        raise PhysicsError("what drives it about this equilibrium is known to the digits of floats: no reference is "
                           "found")
    place = {q: scene.table.parameter(_rest_of(q.name), positive=False) for q in scene.drawn}
    return excitation(scene, configuration.system.time_dependent_linearisation, place)


def _rest_of(name: str) -> str:
    """The letter of where a coordinate rests."""
    return f"rest[{name}]"


def _rest(configuration: "Configuration", bits: int) -> dict[str, mpmath.mpf]:
    """{coordinate: number} of the equilibrium."""
    from vibcli.mechanics.high_precision import equilibrium_to, in_its_place

    with mpmath.workprec(2 * bits):
        arithmetic = multiprecision()
        values = configuration.numeric.values(arithmetic)
        if configuration.equilibrium.drawn:
            return in_its_place(configuration.scene.resting.drawn, values, arithmetic)
        return equilibrium_to(configuration.numeric, configuration.equilibrium, values, arithmetic)


def full(problem: "Problem") -> Motion:
    """The Motion of the full equations."""
    from vibcli.results.motion_in_series import MotionInSeries

    exact = MotionInSeries(problem, taut=True)
    if any(map(strikes, driving_records(exact.scene, exact.parts.nodes()))):
        raise PhysicsError("no reference is found of full motions that rates of records strike")
    ropes = [tie.signal for tie in problem.scene.constraints if tie.form == "rope"]
    forces = TrueForces(problem, exact.scene) if ropes else {}
    return Motion(exact.scene, exact.parts, exact.values, exact.start, problem.numeric.floats, FULL, False,
                  taut=[forces[rope] for rope in ropes])


def at_instant(motion: Motion, node: "Node", time: Fraction, work: Any) -> TrueValues:
    """The value of a signal; about: its largest magnitude until then."""
    return _settled(motion, time, work, lambda steps: _apart(value(motion.signal(node), steps, time)))


def _apart(found: tuple[mpmath.mpf, mpmath.mpf]) -> tuple[list[mpmath.mpf], mpmath.mpf]:
    return [found[0]], found[1]


def extremes(motion: Motion, node: "Node", until: Fraction, sense: int, instant: bool, work: Any) -> TrueValues:
    """The largest or smallest value of a signal, or the instant at which it has it; about: its largest magnitude, of
    an instant `until`."""
    def found(steps: TaylorSteps) -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        time, top, size = extreme(motion.signal(node), steps, sense)
        return ([time], until) if instant else ([top], size)

    return _settled(motion, until, work, found)


def zeros(motion: Motion, node: "Node", until: Fraction, number: int, work: Any) -> TrueValues:
    """The instant of a zero of a signal, counted from 1; about: `until`."""
    return _settled(motion, until, work, lambda steps: (
        first_zeros(motion.signal(node), steps, number)[-1:], until))


def period(motion: Motion, name: str, until: Fraction, work: Any) -> TrueValues:
    """The time after which a motion of one coordinate repeats itself: from one turn to the next but one, where of a
    full motion it is in the same place again; about: it, too."""
    place, rate = (motion.scene.symbol(name, primes) for primes in (0, 1))

    def found(steps: TaylorSteps) -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        first, _, last = first_zeros(motion.signal(rate), steps, 3)
        ends = [motion.signal(place).along(steps, [place], int(mpmath.ldexp(t, steps.bits)))[0] for t in (first, last)]
        if not motion.rested and abs(ends[1] - ends[0]) > mpmath.ldexp(abs(ends[0]), -steps.accuracy // 2):
            raise PhysicsError("the reference finds that this motion does not come back to where it was")
        return [last - first], last - first

    return _settled(motion, until, work, found)


def _settled(motion: Motion, until: Fraction, work: "Work",
             look: Callable[..., tuple[list[mpmath.mpf], mpmath.mpf]]) -> TrueValues:
    return settled_along(motion, lambda _: until, work, look)


def settled_along(motion: Motion, until: Callable[[int], Fraction], work: Any,
                  look: Callable[..., tuple[list[mpmath.mpf], mpmath.mpf]]) -> TrueValues:
    """What look(steps) finds along a motion, up to until(bits)."""
    digits, first = motion.digits

    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        return look(motion.steps(until(bits_of(mpmath.mp.dps)), mpmath.mp.dps, work))

    return settled(found, digits, first, LIMIT, GROWTH, sized=True)
