"""How far what TiedModes leave out puts off displacements, a true upper bound.

Of a free motion u let w be what the first modes do in it as these are followed, and all others, driven by the forces
Σ U √Λ f e^{λt} that dampers have in it, as e^{λt} are. M ë + C ė + K e = −U Λ g of the rest e = u − w, g being how much
faster w moves the dampers than what is followed does: e begins with y₀, what w does not begin with, and

    ‖e‖² ≤ ‖y₀‖² + ½ ∫ g Λ g dt,      √∫ ė Λ ė dt ≤ √∫ g Λ g dt + ‖y₀‖/√2,      ‖e‖² = e K e + ė M ė

as dampers take ė Λ ė. What is read of e at T is [p(T), y₀] and ∫ ṗ(T − t) Λ g dt, p being the free motion that begins
as a unit load there holds it (reciprocity): it is known likewise, and y₀ is of none of the first modes, so that nothing
but products of what is left out of both is felt. Sums over others are by Cauchy and Schwarz (UncountedModes).
"""

from functools import cached_property
from math import inf
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.disturbances import FALL
from vibcli.analyses.continuous.load_changes import changes
from vibcli.analyses.continuous.modal_reads import key_of
from vibcli.analyses.continuous.uncounted_modes import POWERS, size_of
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.coupled_modes import TiedModes
    from vibcli.analyses.continuous.coupled_transfer import CoupledTransfer
    from vibcli.analyses.continuous.disturbances import Disturbances
    from vibcli.analyses.continuous.given_denominators import GivenDenominators
    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.analyses.excitation.linear_output import LinearOutput

ROUNDED = 1e-12     # of a flexibility: what means over circles leave of it
FAST = 0.5          # of the highest frequency that is counted: exponents of loads
COUPLED = "and dampers couple the modes that `damping:` damps"
RATE = f"as it is a force, or a rate, {COUPLED}"
MOST = 1_000        # segments of a load
NEXT = 1e12         # κ of states next to which others are
LOAD = f"as a load is none of few steps, ramps, blows on a mass and slow oscillations, {COUPLED}"


class FreeCoupledMotion(NamedTuple):
    """states as they begin; forces: |f| of each that w has; rest: ‖y₀‖ among others; off: among the first modes."""

    states: np.ndarray
    forces: np.ndarray
    rest: float
    off: float


class CoupledLeftOut:
    """Of TiedModes of a CoupledTransfer under segments of a load; beyond: the GivenDenominators of the others, known:
    Disturbances of these. ALONE: as of Disturbances."""

    ALONE = False

    def __init__(self, modes: "TiedModes", transfer: "CoupledTransfer", beyond: "GivenDenominators",
                 known: "Disturbances", segments: "Sequence[Segment]") -> None:
        self.modes, self.transfer, self.beyond, self._known = modes, transfer, beyond, known
        self._segments, self.times = segments, np.array([one.start for one in segments])
        self.uncounted, self._rates = known.modes, modes.states.rates
        self._reads: dict[Any, Any] = {}

    def bound(self, output: "LinearOutput", t: float, order: int = 0) -> float:
        """Of what they add to an output up to an instant; inf where none is known."""
        if not self.bounds(output, t, order):
            return inf
        begun = np.flatnonzero(self.times <= max(t, float(self.times[0])))
        return float(sum(self._of(output, number) for number in begun.tolist()))

    def bounds(self, output: "LinearOutput", _: float, order: int = 0) -> bool:
        """Is that bound finite?"""
        return not order and self._is_displacement(output) and self._taken and self._until_the_end(output) < inf

    def reason(self, output: "LinearOutput") -> str:
        """Why no bound is known of it, in words."""
        return LOAD if self._is_displacement(output) else RATE

    def obstacle(self, _: "LinearOutput", __: float) -> str:
        """Why it is not, where amplitudes tell nothing either."""
        return FALL

    def _is_displacement(self, output: "LinearOutput") -> bool:
        return not any((*output.v.values(), *output.a.values())) and not any(
            place.rates for place in output.places) and self.uncounted.reaches(output, 1.0, 0) < inf

    def _takes(self, key: tuple[int, complex, int]) -> bool:
        channel, s, power = key
        begins = self.uncounted.begins[channel]
        if power < 0:
            return bool(begins < 0)
        return bool(begins < 1 and abs(s) <= FAST * self.beyond.omega and (power == 0 or (power == 1 and s == 0)))

    @cached_property
    def _begun(self) -> list[dict[tuple[int, complex, int], complex]]:
        """What each segment begins with."""
        return [changes(self._segments, number).kept() for number in range(min(len(self._segments), MOST + 1))]

    @cached_property
    def _taken(self) -> bool:
        return len(self._begun) <= MOST and all(self._takes(key) for part in self._begun for key in part)

    def _until_the_end(self, output: "LinearOutput") -> float:
        key = key_of(output), None
        if key not in self._reads:
            self._reads[key] = sum(self._of(output, number) for number in range(len(self._segments)))
        return float(self._reads[key])

    @cached_property
    def _roots(self) -> np.ndarray:
        """√Λ of the dampers, (r,)."""
        return cast("np.ndarray", np.sqrt(self.transfer.dampers.rates))

    @cached_property
    def _strokes(self) -> np.ndarray:
        """√Λ times how far each state moves the dampers, (r, states)."""
        rows = [self.modes.rows(one)[0][0] for one in self.transfer.dampers.outputs]
        moved = np.array(rows).reshape(len(self._roots), -1 if rows else len(self._rates))
        return cast("np.ndarray", self._roots[:, None] * moved)

    @cached_property
    def _sums(self) -> dict[float, np.ndarray]:
        """Σ b bᵀ/ω²ᵖ of all channels."""
        return self.uncounted.load_sums(range(len(self.uncounted.begins)))

    def _sizes(self, b: np.ndarray, powers: "Sequence[float]" = (1.0, 2.0)) -> np.ndarray:
        """√Σ b²/ω²ᵖ of a vector over channels, inf where it is not finite."""
        acting = self.uncounted.begins[np.abs(b) > 0]
        return np.array([size_of(b, self._sums[p]) if (acting < p).all() else inf for p in powers])

    @cached_property
    def _of_dampers(self) -> np.ndarray:
        """The same of U √Λ together."""
        n = len(self.transfer.dampers.rows)
        acting = self.transfer.dampers.rows * self._roots
        return np.sqrt([np.linalg.eigvalsh(acting.T @ self._sums[p][:n, :n] @ acting).max(initial=0.0)
                        for p in (1.0, 2.0)])

    @cached_property
    def _paces(self) -> tuple[np.ndarray, np.ndarray]:
        """(|√Λ g| of a unit f of each state, √∫ of its square over all t)."""
        s, low, following = self._rates, self._of_dampers, self.modes.following
        felt = np.linalg.norm(following.felt * self._roots, axis=1)
        size = np.where(self._kept, np.abs(s) * self._apart(low, low, felt**2), 0.0)
        with np.errstate(divide="ignore"):
            return size, size / np.sqrt(-2 * s.real)

    def _apart(self, first: np.ndarray, second: np.ndarray, followed: np.ndarray) -> np.ndarray:
        """How far what two sizes show of others in each state is from what `followed`, of following shapes, do."""
        squares, s = self.modes.following.squares, self._rates
        still, answers = 1 + self.beyond.beta * s, 1 / self.beyond.at(np.sqrt(squares), s)
        missed = self._missed(first[0] * second[0], float((followed / squares).sum()))
        beside = np.abs(answers - 1 / (squares * still[:, None])) @ followed
        with np.errstate(divide="ignore", invalid="ignore"):
            found = self.beyond.from_rest(s, first, second) + beside + missed / np.abs(still)
        whole = self.beyond.inverse(s) * first[0] * second[0] + np.abs(answers) @ followed
        return cast("np.ndarray", np.fmin(found, whole))

    def _missed(self, left: float, followed: float) -> float:
        """What following shapes lack of a flexibility at rest."""
        if len(self.modes.following.squares) < len(self._roots):
            return left + followed
        basis, rows = self.modes.basis, self.transfer.dampers.rows * self._roots
        return float(ROUNDED * (left + followed + ((basis.shapes.T @ rows) ** 2 / basis.squares[:, None]).sum()))

    def _free(self, static: float, states: np.ndarray, forces: np.ndarray, more: float) -> FreeCoupledMotion:
        """A FreeCoupledMotion: ‖·‖ of static loads on the others, states as they begin, steady f of dampers, and what
        else ‖y₀‖ holds."""
        acting = np.where(self._kept, -self._strokes * self._rates * states, 0.0)
        size = np.linalg.norm(acting, axis=0)
        left = np.linalg.norm(forces - acting.sum(axis=1).real)
        rest = static + left * self._of_dampers[0] + float(size[self._kept] @ self._energies[self._kept])
        return FreeCoupledMotion(states, size, rest + more, float(self.modes.energies(states)[~self._kept].sum()))

    @cached_property
    def _kept(self) -> np.ndarray:
        """Which states w has: not those next to which others are."""
        return ~self.modes.follows & (self.beyond.inverse(self._rates) < NEXT)

    @cached_property
    def _energies(self) -> np.ndarray:
        """‖·‖ of what a unit f of each state moves others by, beside what it does at rest."""
        return self.beyond.energies(self._rates, self._of_dampers)

    def _motion(self, number: int) -> FreeCoupledMotion:
        """The FreeCoupledMotion that begins with a segment."""
        channels, begun = len(self.uncounted.begins), self._begun[number]
        static, forces, more, off = np.zeros(channels), np.zeros(len(self._roots)), 0.0, 0.0
        states = np.zeros(len(self._rates), complex)
        if not number:
            states, more = states + self.modes.states.begin, self._of_start()
        for (channel, s, power), size in begun.items():
            unit, own = np.eye(channels)[channel], self.modes.states.inputs[:, channel]
            if power < 0:
                states = states + own * size.real
                more += abs(size) * float(self._sizes(unit, (0.0,))[0])
                continue
            low = self._sizes(unit)
            for part, x in ((s, size / 2), (s.conjugate(), size.conjugate() / 2)):
                gap = part - self._rates
                states = states + x * own * (1 / gap if not power else -1 / gap**2)
            static[channel] += 0.0 if power else size.real
            followed, exact = size * self._steady(channel, s, power)
            forces, apart = forces + followed.real, float(np.linalg.norm(exact - followed))
            off += apart * self._of_forces(s)
            if power:
                beyond = self.beyond
                more += abs(size) * (beyond.beta * low[0] + (beyond.double + beyond.alpha / beyond.omega + 1) * low[1])
            else:
                at, both = np.array([s]), abs(size) * low + np.linalg.norm(followed) * self._of_dampers
                more += float(self.beyond.energies(at, both)[0])
        found = self._free(float(self._sizes(static)[0]), states, forces, more)
        return found._replace(off=found.off + off)

    def _of_start(self) -> float:
        """‖y₀‖ of what a motion starts with."""
        start, spread = self._known.start, self._known.start.spread
        held = [self._sizes(part)[k] for k, part in enumerate(start.held)]
        return float(sum(held) + spread[0, POWERS.index(1.0)] + spread[1, POWERS.index(2.0)])

    def _steady(self, channel: int, s: complex, power: int) -> np.ndarray:
        """f in a motion under a unit load, as states tell it and as it is, (2, r); of a ramp those of its rate."""
        if (channel, s, power) in self._reads:
            return cast("np.ndarray", self._reads[channel, s, power])
        at = np.array([s])
        exact = np.array([self.transfer.at(one, at)[channel, 0] for one in self.transfer.dampers.outputs])
        own = self.modes.states.inputs[:, channel]
        told = sum((strokes / (s - rates)) @ inputs for strokes, rates, inputs in (
            (self._strokes, self._rates, own), (self._strokes.conj(), self._rates.conj(), own.conj()))) / 2
        self._reads[channel, s, power] = -(1.0 if power else s) * np.array([told, self._roots * exact])
        return cast("np.ndarray", self._reads[channel, s, power])

    def _of_forces(self, s: complex) -> float:
        """‖·‖ of all modes that a unit f at a place s moves."""
        basis, at = self.modes.basis, np.array([s])
        felt = np.linalg.norm((basis.shapes.T @ self.transfer.dampers.rows) * self._roots, axis=1)
        answers = felt / np.abs(basis.squares + s * self.modes.given + s * s)
        own = np.linalg.norm(np.sqrt(basis.squares + abs(s) ** 2) * answers)
        return float(own + self._of_dampers[0] + self.beyond.energies(at, self._of_dampers)[0])

    @cached_property
    def _motions(self) -> list[FreeCoupledMotion]:
        return [self._motion(number) for number in range(len(self._segments))]

    def _of(self, output: "LinearOutput", number: int) -> float:
        """What is read of e, and of w, of one."""
        key = key_of(output), number
        if key not in self._reads:
            motion, (read, dual, flexibility, reach) = self._motions[number], self._dual(output)
            size, lasting = self._paces
            moved, shown = float(motion.forces @ lasting), float(dual.forces @ lasting)
            begun, slow = dual.rest + dual.off, float(dual.forces @ self._overlaps @ (size * motion.forces))
            dropped = np.abs(self.modes.rows(output)[0][0] * motion.states)[~self._kept].sum()
            rest = (reach + begun + shown / np.sqrt(2)) * motion.rest + flexibility * motion.off
            fast = (2 * shown + begun / np.sqrt(2)) * moved
            self._reads[key] = float(motion.forces @ read + dropped) + rest + slow + fast
        return float(self._reads[key])

    @cached_property
    def _overlaps(self) -> np.ndarray:
        """The largest |∫ Re e^{λ(T − t)} Re e^{λ′ t} dt| of any T, (states, states)."""
        s, slower = self._rates, np.minimum.outer(-self._rates.real, -self._rates.real)
        with np.errstate(divide="ignore"):
            most = 1 / (np.e * slower)
            both = [np.minimum(2 / np.abs(one[:, None] - s), most) for one in (s, s.conj())]
            return cast("np.ndarray", (both[0] + both[1]) / 2)

    def _dual(self, output: "LinearOutput") -> tuple[np.ndarray, FreeCoupledMotion, float, float]:
        """(what is read of w less what is followed of a unit f of each state, the FreeCoupledMotion that begins as a
        unit load there holds it, √ of what that load moves itself, the largest of ‖w‖ among others in that motion)."""
        key = key_of(output)
        if key not in self._reads:
            basis, following, low = self.modes.basis, self.modes.following, self._of_dampers
            own = np.array([self.uncounted.reach(output, p, 0) for p in (1.0, 2.0)])
            row, more = basis.rows(output)[0], following.rows(output)[0]
            states = -(self.modes.drives @ np.append(row, more)) / self._rates
            found = self._free(own[0], states, 0 * self._roots, 0.0)
            felt = np.linalg.norm(following.felt * self._roots, axis=1)
            read = np.where(self._kept, self._apart(own, low, np.abs(more) * felt), 0.0)
            reach = float(found.forces @ np.where(self._kept, self._energies + low[0], 0.0))
            flexibility = float(np.sqrt((row**2 / basis.squares).sum() + own[0] ** 2))
            self._reads[key] = read, found, flexibility, reach
        return cast("tuple[np.ndarray, FreeCoupledMotion, float, float]", self._reads[key])
