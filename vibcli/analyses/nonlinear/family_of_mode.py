"""The family of free motions that starts at a mode of small vibrations, followed by arc-length (Keller 1977).

Each step goes along the tangent of the family and back to it square to that, so that folds are passed; where a wanted
amplitude is near, the amplitude closes the equations instead. Harmonics are doubled until they do not matter.
"""

from collections.abc import Callable, Sequence
from math import inf

import numpy as np

from vibcli.analyses.nonlinear.balance import ClosingCondition, ConvergedMotion, HarmonicBalance
from vibcli.analyses.nonlinear.free_equations import SAME, FreeEquations
from vibcli.analyses.nonlinear.harmonics import AmplitudeOfSignal, CosineMotion
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

FIRST, MOST, UNKNOWNS = 8, 128, 400         # harmonics, and their product with the number of coordinates
SMALL, LINEAR, SMALLER, TRIALS = 0.02, 0.05, 8.0, 12    # a first motion, how near it is to that of the linear mode
WIDEST, SHORTEST, STEPS, NEAR = 0.5, 1e-4, 300, 0.15    # steps, relative to the motion, and by how much they may miss
STRAIGHT = 0.85             # cosine of the angle by which the tangent may turn: families that cross are not mixed up
COARSE, GOOD, ENOUGH = 1e-6, 1e-12, 1e-6    # share of the last harmonics on the way; errors aimed at, borne
STILL, GROWN = 1e-9, 0.3                    # of the scale of a signal and of the scene: less does not move, it should
SHARED, TUNED = 0.05, 0.25                  # of the kinetic energy, and of a frequency, where a resonance is told


class MotionOfAmplitude(NamedTuple):
    """A motion of a wanted amplitude, and a bound of the relative error of ω."""

    motion: CosineMotion
    amplitude: float
    error: float


class _State(NamedTuple):
    """A motion of the family, the unit tangent and how it turns, the amplitude and its rate along the tangent."""

    motion: CosineMotion
    tangent: CosineMotion
    turning: CosineMotion | None
    amplitude: float
    rate: float


class EndOfFamily(PhysicsError):
    """A family is not followed to an amplitude; `largest`: that which was reached."""

    def __init__(self, largest: float, why: str) -> None:
        super().__init__("no free motion of this family with this amplitude is found", why)
        self.largest = largest


class FamilyOfMode:
    """That of mode `number`, counted from 0, about the equilibrium of the equations."""

    def __init__(self, equations: FreeEquations, number: int, signal: AmplitudeOfSignal) -> None:
        self.equations, self.number, self.signal = equations, number, signal
        self.found: list[MotionOfAmplitude] = []
        self.balance, self.most = HarmonicBalance(equations, number), min(MOST, UNKNOWNS // equations.n)
        self._require_alone()

    def _require_alone(self) -> None:
        """PhysicsError where another mode has the same frequency, or a multiple of it."""
        omegas = self.equations.omegas
        for m, omega in enumerate(omegas):
            ratio = omega / omegas[self.number]
            times = round(ratio)
            if m != self.number and times and abs(ratio / times - 1) < SAME:
                told = "the same frequency as" if times == 1 else f"{times} times the frequency of"
                raise PhysicsError(f"mode {m + 1} has {told} mode {self.number + 1}: no single family of free motions "
                                   "starts there", "change a parameter a little, or ask about another mode")

    def motions(self, amplitudes: Sequence[float]) -> list[MotionOfAmplitude]:
        """Those with the amplitudes, in the order in which the family passes them, up to the largest for the first
        time; EndOfFamily where it is not reached. `found` has those that were found when it is interrupted."""
        wanted, found = sorted(amplitudes), self.found
        state, step = self._start(wanted[0]), WIDEST
        largest = state.amplitude
        for _ in range(STEPS):
            step, state, met = self._further(state, step, wanted)
            found += met
            largest = max(largest, state.amplitude)
            if met and met[-1].amplitude == wanted[-1]:
                return found
            if step < SHORTEST or (found and state.amplitude < 0.5 * wanted[0]):
                break
            self._require_movement(state)
        raise EndOfFamily(largest, self._why(state, step))

    def _why(self, state: _State, step: float) -> str:
        """Why a family is not followed beyond a state."""
        if step >= SHORTEST:
            return "the family turns back before: ask for a smaller amplitude"
        if self.equations.bent:
            return ("forces of this scene bend or jump: harmonics of motions across that fall off slowly, and the "
                    "family is not followed; ask for a smaller amplitude, or for period(x) of a motion from `initial`")
        count = len(state.motion.a) - 1
        if 2 * count >= self.most:
            return (f"beyond that the motions need more than {count} harmonics, as next to a top of V, where forces "
                    "bend, or in internal resonances: ask for a smaller amplitude")
        return "beyond that the family bends too sharply to be followed: ask for a smaller amplitude"

    def _require_movement(self, state: _State) -> None:
        size = state.motion.size
        scale = max(self.signal.by_mode(m) for m in range(self.equations.n)) * size
        if state.amplitude <= STILL * scale and size > GROWN * self.equations.reach:
            raise PhysicsError(f"this signal does not move in the family of mode {self.number + 1}",
                               "ask for the amplitude of what moves in it, or for another family")

    def _start(self, least: float) -> _State:
        """A motion next to the linear mode, of an amplitude less than the least wanted."""
        by_mode = self.signal.by_mode(self.number)
        others = max(self.signal.by_mode(m) for m in range(self.equations.n))
        size = SMALL * self.equations.reach
        if by_mode > STILL * others:
            size = min(size, 0.5 * least / by_mode)
        for _ in range(TRIALS):
            a = np.zeros((FIRST + 1, self.equations.n))
            a[1, self.number] = size
            found = self.balance.solved(CosineMotion(a, 1.0), _as_large_as(a))
            if found is not None and found.moved < LINEAR:
                state = self._state(found, None, 0.0)
                if state.amplitude < least:
                    return state
            size /= SMALLER
        raise PhysicsError(f"no free motions next to those of mode {self.number + 1} are found: the forces bend or "
                           "jump at the equilibrium", "ask for period(x) of a motion from `initial`, with motion: full")

    def _state(self, solved: ConvergedMotion, before: _State | None, step: float) -> _State:
        """With the tangent in the sense of that before."""
        motion, tangent = solved.motion, solved.tangent
        length = _length(tangent, motion)
        if before is not None and _dot(tangent, before.tangent, motion) < 0:
            length = -length
        tangent = CosineMotion(tangent.a / length, tangent.w / length)
        turning = None
        if step:
            old = before.tangent.with_harmonics(len(motion.a) - 1)
            turning = CosineMotion((tangent.a - old.a) / step, (tangent.w - old.w) / step)
        amplitude, slopes = self.signal.of(motion)
        return _State(motion, tangent, turning, amplitude, float((slopes * tangent.a).sum()))

    def _further(self, state: _State, step: float,
                 wanted: list[float]) -> tuple[float, _State, list[MotionOfAmplitude]]:
        """(the length of the next step, the next state, [MotionOfAmplitude] that were met on the way)."""
        target = _next(state, wanted)
        if target is not None and 0 < (needed := (target - state.amplitude) / state.rate) <= step:
            landed = self._landed(_predicted(state, needed), target, needed)
            following = landed and self._state(landed[0], state, needed)
            if following is not None and _goes_on(state, following):
                return min(WIDEST, 2 * step), following, [landed[1]]
        solved = self._along(state, step)
        following = solved and self._state(solved, state, step)
        if following is None or not _goes_on(state, following):
            return step / 3, state, []
        met = []
        for target in _passed(state.amplitude, following.amplitude, wanted):
            landed = self._landed(_between(state, following, target), target, step)
            if landed is None:
                return step / 3, state, []
            met.append(landed[1])
        eased = step * float(np.clip((0.1 * step / max(solved.moved, 1e-9)) ** 0.5, 0.5, 2.0))
        return min(WIDEST, eased), following, met

    def _along(self, state: _State, step: float) -> ConvergedMotion | None:
        """A step along the tangent; None where it is too long."""
        start = _predicted(state, step)
        while True:
            found = self.balance.solved(start, _square_to(start, state))
            if found is None or found.moved > NEAR * step:
                return None
            if _tail(found.motion) <= COARSE:
                return found
            if 2 * len(start.a) > self.most:
                return None
            start = start.with_harmonics(min(self.most, 2 * (len(start.a) - 1)))

    def _landed(self, start: CosineMotion, target: float,
                step: float) -> tuple[ConvergedMotion, MotionOfAmplitude] | None:
        """The motion of an amplitude near a start, with harmonics enough."""
        def closing(motion: CosineMotion) -> ClosingCondition:
            amplitude, slopes = self.signal.of(motion)
            return ClosingCondition(amplitude / target - 1, slopes / target, 0.0)

        solved, error = self.balance.solved(start, closing), inf
        if solved is None or solved.moved > NEAR * step:
            return None
        while True:
            motion, before = self.balance.refined(solved.motion, closing), error
            error = self.balance.error(motion, closing)
            if error <= GOOD or not len(motion.a) - 1 < self.most or 0.5 * before < error <= ENOUGH:
                break
            finer = motion.with_harmonics(min(self.most, 2 * (len(motion.a) - 1)))
            solved = self.balance.solved(finer, closing) or solved
            if len(solved.motion.a) < len(finer.a):
                return None
        return (solved, MotionOfAmplitude(motion, target, error)) if error <= ENOUGH else None

    def resonance(self, motion: CosineMotion) -> tuple[int, int, float] | None:
        """(k, m, share of the kinetic energy) of the harmonic k in which another mode m, counted from 0, moves with
        about its own frequency; None where none takes much part."""
        k = np.arange(len(motion.a))[:, None]
        energy = (k * motion.a) ** 2
        share = energy / energy.sum()
        share[:2], share[:, self.number] = 0.0, 0.0
        near = np.abs(k * motion.w * self.balance.scale / self.equations.omegas - 1) < TUNED
        share = np.where(near, share, 0.0)
        order, mode = np.unravel_index(int(share.argmax()), share.shape)
        return (int(order), int(mode), float(share[order, mode])) if share[order, mode] > SHARED else None


def _goes_on(state: _State, following: _State) -> bool:
    """Does the tangent turn little from one motion to the next?"""
    one, other, motion = state.tangent, following.tangent, following.motion
    return _dot(one, other, motion) > STRAIGHT * _length(one, motion) * _length(other, motion)


def _dot(one: CosineMotion, other: CosineMotion, motion: CosineMotion) -> float:
    count = min(len(one.a), len(other.a))
    return float((one.a[:count] * other.a[:count]).sum()) / motion.size**2 + one.w * other.w / motion.w**2


def _length(tangent: CosineMotion, motion: CosineMotion) -> float:
    found: float = _dot(tangent, tangent, motion) ** 0.5
    return found


def _predicted(state: _State, step: float) -> CosineMotion:
    motion, tangent, turning = state[:3]
    a, w = motion.a + step * tangent.a, motion.w + step * tangent.w
    if turning is not None:
        a, w = a + 0.5 * step**2 * turning.a, w + 0.5 * step**2 * turning.w
    return CosineMotion(a, w)


def _as_large_as(a: np.ndarray) -> Callable[..., ClosingCondition]:
    """The condition of a motion whose part along coefficients is as large as these."""
    along = a / (a * a).sum()
    return lambda motion: ClosingCondition(float((motion.a * along).sum()) - 1, along, 0.0)


def _square_to(start: CosineMotion, state: _State) -> Callable[[CosineMotion], ClosingCondition]:
    """The condition of a motion that lies square to the tangent of a state at another one."""
    along = state.tangent.with_harmonics(len(start.a) - 1).a / state.motion.size**2
    by_w = state.tangent.w / state.motion.w**2

    def closing(motion: CosineMotion) -> ClosingCondition:
        return ClosingCondition(float(((motion.a - start.a) * along).sum()) + (motion.w - start.w) * by_w, along, by_w)

    return closing


def _next(state: _State, wanted: Sequence[float]) -> float | None:
    """The next amplitude in the sense in which it changes; None where there is none."""
    sense = 1 if state.rate > 0 else -1
    left = [one for one in wanted if sense * (one - state.amplitude) > 1e-9 * state.amplitude]
    return (left[0] if sense > 0 else left[-1]) if left and state.rate else None


def _passed(before: float, after: float, wanted: list[float]) -> list[float]:
    """The amplitudes between two others, in their order."""
    slack, sense = 1e-9 * before, 1 if after > before else -1
    return [one for one in wanted[::sense] if sense * (one - before) > slack and sense * (after - one) >= 0]


def _between(state: _State, following: _State, target: float) -> CosineMotion:
    share = (target - state.amplitude) / (following.amplitude - state.amplitude)
    harmonics = len(following.motion.a) - 1
    a, b = state.motion.with_harmonics(harmonics), following.motion
    return CosineMotion(a.a + share * (b.a - a.a), a.w + share * (b.w - a.w))


def _tail(motion: CosineMotion) -> float:
    """The size of the last quarter of the harmonics, relative."""
    last = max(2, len(motion.a) // 4)
    return float(np.abs(motion.a[-last:]).max()) / motion.size
