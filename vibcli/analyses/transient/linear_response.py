"""The response itself: any linear output and its derivatives at any times, without steps in time."""

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.mode_numbers import beyond
from vibcli.analyses.transient.decoupling import spectrum
from vibcli.analyses.transient.extremes import extreme
from vibcli.analyses.transient.following import not_held, sees_what_moves_freely
from vibcli.analyses.transient.pieces import Pieces, followed
from vibcli.analyses.transient.static_condensation import condensed
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Work

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.analyses.transient.data_errors import DataErrors
    from vibcli.analyses.transient.modal_block import ModalBlock

ROUNDING = 1e-12        # of the terms of a sum that is 0


def linear_motion(M: np.ndarray, C: np.ndarray, K: np.ndarray, forcing: "Forcing", q0: np.ndarray, v0: np.ndarray,
                  modes: "Sequence[Mode] | None" = None, work: Work | None = None,
                  doubt: "Callable[[], DataErrors] | None" = None,
                  rigid: np.ndarray | None = None) -> "LinearMotion":
    """The motion of M q̈ + C q̇ + K q = f(t) from q(0) = q0, q̇(0) = v0.

    M symmetric positive definite, but for coordinates that have no inertia; C and K any real matrices; forcing:
    segments.Forcing whose first n channels are the generalised forces. modes: undamped modes (modal.Mode) where they
    are known better than the assembled matrices tell. work: what counts its long work. doubt: gives the DataErrors,
    None: the data are exact. rigid: columns of what moves freely, where K is symmetric and they are known.
    """
    M, C, K = (np.array(matrix, float, ndmin=2) for matrix in (M, C, K))
    if not all(np.isfinite(part).all() for part in (M, C, K, q0, v0)):
        raise PhysicsError("inertia, damping, stiffness or what the motion starts from is not a finite number",
                           hint="look for a length, an angle or a law that is singular there")
    try:
        system = condensed(M, C, K)
        blocks = spectrum(M, C, K, modes, system, rigid)
        return LinearMotion((M, C, K, system), blocks, forcing, q0, v0, work, doubt=doubt)
    except (OverflowError, ZeroDivisionError):
        raise beyond() from None


class LinearMotion:
    """q(t) for t >= 0; outputs are LinearOutputs. matrices: (M, C, K, Condensed or None). constants: whether the
    constants of outputs count."""

    def __init__(self, matrices: tuple[np.ndarray, np.ndarray, np.ndarray, Any], blocks: "Sequence[ModalBlock]",
                 forcing: "Forcing", q0: np.ndarray, v0: np.ndarray, work: Work | None = None, constants: bool = True,
                 doubt: "Callable[[], DataErrors] | None" = None) -> None:
        self.work, self.constants, self.doubt = work or Work(), constants, doubt
        self.matrices, self.blocks, self.forcing = matrices, blocks, forcing
        self.M, self.C, self.K, self.system = matrices
        self.q0, self.v0 = np.array(q0, float), np.array(v0, float)
        self._pieces: Any = None
        self._extremes: dict[tuple[Any, ...], tuple[float, float]] = {}

    def values(self, output: "LinearOutput", times: Sequence[float] | np.ndarray, order: int = 0) -> np.ndarray:
        """The order-th derivative of the output at an array of times; just after what jumps there."""
        times = np.asarray(times, float)
        t = times.ravel()
        pieces = self.pieces(t.max(initial=0.0))
        return np.asarray(pieces.terms(output, order).at(*pieces.timeline.place(t)).reshape(times.shape))

    def errors(self, output: "LinearOutput", times: np.ndarray, order: int = 0) -> np.ndarray:
        """First-order bounds of the errors of the same values."""
        return self.pieces(times.max(initial=0.0)).errors.of(output, times, order)

    @cached_property
    def data_errors(self) -> "DataErrors":
        """How far what it was computed from may be off."""
        from vibcli.analyses.transient.data_errors import of_matrices

        return of_matrices(self.M, self.C, self.K) if self.doubt is None else self.doubt()

    def extreme(self, output: Any, start: float, end: float, sense: str = "max") -> tuple[float, float]:
        """(t, value) of the largest ("max") or smallest ("min") value for start <= t <= end, the earliest of equals."""
        place = (output.told, start, end, sense)
        if place not in self._extremes:
            self._extremes[place] = extreme(self.pieces(end), output, start, end, sense, self.work)
        return self._extremes[place]

    def zeros(self, output: "LinearOutput", start: float, end: float) -> np.ndarray:
        """All times from `start` to `end` where the output passes or touches zero, ascending."""
        from vibcli.analyses.transient.zeros import zeros

        return zeros(self.pieces(end), output, start, end, self.work)

    def final(self, output: "LinearOutput") -> float:
        """The limit of the output as t → ∞; PhysicsError where there is none."""
        from vibcli.analyses.transient.final_value import final

        return final(self, output)

    @cached_property
    def steady(self) -> "SteadyMotion":
        """The SteadyMotion that is reached; PhysicsError where there is none."""
        from vibcli.analyses.transient.steady_state import check_stable, steady_forcing

        check_stable(self.blocks)
        return SteadyMotion(self, steady_forcing(self.forcing))

    @cached_property
    def transient(self) -> "LinearMotion":
        """The motion less its steady state, a free motion in the end."""
        from vibcli.analyses.transient.steady_state import transient_forcing

        steady = self.steady
        forcing = transient_forcing(self.forcing, steady.forcing)
        return LinearMotion(self.matrices, self.blocks, forcing, self.q0 - steady.q0, self.v0 - steady.v0, self.work,
                            constants=False, doubt=lambda: self.data_errors.besides(steady.data_errors))

    @property
    def start(self) -> np.ndarray:
        """q at t = 0, before any blow: what nothing holds back has followed the forces."""
        if self.system is None:
            return self.q0
        forces = np.zeros(len(self.M))
        for wave in self.forcing.segments(0.0)[0].waves:
            if wave.channel < len(forces) and not wave.power:
                forces[wave.channel] += complex(wave.coefficient).real
        found: np.ndarray = self.system.T @ (self.system.places @ self.q0) + self.system.follow @ forces
        return found

    def like(self, forcing: "Forcing", q0: np.ndarray, v0: np.ndarray,
             blocks: "Sequence[ModalBlock] | None" = None) -> "LinearMotion":
        """The same system, driven and started otherwise; blocks: in place of its own."""
        return LinearMotion(self.matrices, blocks or self.blocks, forcing, q0, v0, self.work,
                            doubt=lambda: self.data_errors.started(np.zeros(len(self.M)), np.zeros(len(self.M))))

    @property
    def is_followed(self) -> bool:
        """Was it followed already, from one segment of its loads to the next?"""
        return self._pieces is not None

    def pieces(self, until: Any) -> Pieces:
        """The Pieces of the motion up to a time."""
        if self._pieces is None or until > self._pieces.until:
            if self.forcing.listed:
                until = math.inf
            further = until if self._pieces is None else max(until, 2 * self._pieces.until)
            try:
                self._pieces = self._followed(further)
            except PhysicsError:
                if further == until:
                    raise
                self._pieces = self._followed(until)
        found: Pieces = self._pieces
        return found

    def _followed(self, until: float) -> Pieces:
        if not self.forcing.recorded:
            return followed(self, until)
        from vibcli.analyses.transient.recorded_pieces import recorded

        return recorded(self)


class SteadyMotion(LinearMotion):
    """The steady state of a motion, continued back to t = 0.

    lasting: free vibrations or a drift that nothing damps remain beside it. period: of periodic forcing, or None; then
    waves: [(s, Q, F)] of q = Re(Q e^{st}) under the forces Re(F e^{st}). powers: [(Qₖ, Fₖ)] of Σ Qₖ tᵏ beside these, of
    periodic forcing where its mean drives off what nothing holds; lost: how far the first Fₖ may be off beside a
    rounding.
    """

    lost: Sequence[np.ndarray] | np.ndarray = ()

    def __init__(self, motion: LinearMotion, forcing: "Forcing") -> None:
        from vibcli.analyses.transient import steady_state

        self.lasting, self.period, self.waves = steady_state.undying(motion.blocks), forcing.period, None
        self.powers: list[tuple[np.ndarray, np.ndarray]] = []
        if self.period is None:
            self.waves = steady_state.amplitudes(motion, forcing)
            self.powers = steady_state.following(motion, forcing)
            q0, v0 = (sum((np.real(s**order * Q) for s, Q, _ in self.waves), np.zeros(len(motion.M)))
                      + sum(Q for Q, _ in self.powers[order:order + 1]) for order in range(2))
        else:
            from vibcli.analyses.transient.repeating_motion import drive_off, repeating

            self.powers, self.lost = drive_off(motion, forcing)
            self.repeated = repeating(motion, forcing, self.powers)
            q0, v0 = (row + sum(Q for Q, _ in self.powers[order:order + 1]) for order, row in enumerate(self.repeated))
        super().__init__(motion.matrices, motion.blocks, forcing, q0, v0, motion.work, doubt=self._doubt(motion))

    def _doubt(self, motion: LinearMotion) -> "Callable[[], DataErrors]":
        """Gives the DataErrors with those of the start that was found."""
        def doubt() -> "DataErrors":
            if self.period is None:
                from vibcli.analyses.transient.steady_errors import of_waves

                return motion.data_errors.started(*of_waves(motion, self.waves, self.powers))
            from vibcli.analyses.transient.repeating_motion import errors_of

            return motion.data_errors.started(*errors_of(motion, self))

        return doubt

    def off(self, wave: tuple[complex, np.ndarray, np.ndarray]) -> np.ndarray | None:
        """By how much the forces of a wave (s, Q, F) may be off beside a rounding: |δF|; None: not at all."""
        return None

    @cached_property
    def errors_of_waves(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """(|δQ|, |δF|) of each wave, which all outputs share."""
        from vibcli.analyses.transient.steady_errors import of_wave

        return [of_wave(self, wave, self.off(wave)) for wave in self.waves]

    def phasors(self, output: "LinearOutput") -> list[tuple[float, complex]]:
        """[(Ω, X)] with Re Σ X e^{iΩt} the output, Ω ascending; a constant has Ω = 0. Not of periodic forcing;
        PhysicsError of an output that grows."""
        still = self._mean(output)
        return [*([(0.0, complex(still))] if still else []), *self.oscillating(output)]

    def _mean(self, output: "LinearOutput") -> float:
        """What a polynomial is that does not grow; PhysicsError of one that does."""
        still, *growing = self.polynomial(output)
        self.require_held(output)
        if any(growing):
            raise PhysicsError("this steady state grows without end", "ask for its value at a time")
        return still

    def require_held(self, output: "LinearOutput") -> None:
        """Refuses an output that sees what loads drive off, which nothing holds."""
        if any(self.polynomial(output)[1:]) and self._sees_drift(output):
            raise not_held()

    def _sees_drift(self, output: "LinearOutput") -> bool:
        """Does an output that grows see what nothing holds?"""
        return sees_what_moves_freely(self.blocks, output)

    def oscillating(self, output: "LinearOutput") -> list[tuple[float, complex]]:
        """Those of them that oscillate, beside whatever grows."""
        return [(s.imag, complex(read(output, s, Q, F))) for s, Q, F in self.waves]

    def polynomial(self, output: "LinearOutput") -> list[float]:
        """[cₖ] of the part Σ cₖ tᵏ of the output, from k = 1 on 0 of what its bound does not tell from rounding."""
        from vibcli.analyses.transient.steady_errors import of_powers_in

        nothing, found = (np.zeros(len(self.M)), np.zeros(self.forcing.channels)), []
        powers = [*self.powers, nothing, nothing]
        bounds = of_powers_in(self, output) if len(self.powers) > 1 else [0.0]
        for k in range(max(1, len(self.powers))):
            (q, F), (v, _), (a, _) = powers[k:k + 3] if self.powers else [nothing] * 3
            parts = ((output.q, q), (output.v, (k + 1) * v), (output.a, (k + 2) * (k + 1) * a), (output.channels, F))
            terms = [x * values[i] for coefficients, values in parts for i, x in coefficients.items()]
            terms += [output.constant] if not k else []
            total = math.fsum(terms)
            rounding = max(ROUNDING * sum(map(abs, terms)), bounds[k]) if k else 0.0
            found.append(total if not k or abs(total) > rounding else 0.0)
        return found

    def harmonic(self, output: "LinearOutput", n: int) -> complex:
        """X of the n-th harmonic Re(X e^{inωt}) of the output under periodic forcing, ω = 2π/period; X of n = 0 is the
        mean."""
        from vibcli.analyses.transient.steady_state import harmonic

        return read(output, *harmonic(self, self.forcing, n)) + (output.constant if not n else 0.0)

    def mean(self, output: "LinearOutput") -> float:
        """The mean of the output."""
        if self.period is None or self.powers:
            return self._mean(output)
        return self.harmonic(output, 0).real

    def rms(self, output: "LinearOutput") -> float:
        """The root of the mean square of the output."""
        self.require_held(output)
        if self.period is None:
            return math.sqrt(sum(abs(X) ** 2 / (2 if rate else 1) for rate, X in self.phasors(output)))
        from vibcli.analyses.transient.steady_state import mean_square

        return math.sqrt(mean_square(self, output, 0.0, self.period))


def read(output: "LinearOutput", s: complex, Q: np.ndarray, F: np.ndarray) -> complex:
    """The output of q = Re(Q e^{st}) under the forces Re(F e^{st}), without its constant."""
    parts = ((output.q, 1.0), (output.v, s), (output.a, s * s))
    return complex(sum(x * factor * Q[i] for coefficients, factor in parts for i, x in coefficients.items())
                   + sum(x * F[channel] for channel, x in output.channels.items()))

