"""Steady states of scenes with members by D(iΩ) at each frequency of their loads, where their motion in time is not
followed from its start."""

from functools import cached_property
from math import inf, tau
from typing import TYPE_CHECKING, Any, NoReturn

from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.transient.steady_state import harmonic_forces, lost_forces, resonance, steady_forcing
from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.results.responses import SmallResponse
from vibcli.results.steady_features import common
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np

    from vibcli.analyses.continuous.kept_up_motion import Harmonic, KeptUpMotion
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.frequency_response.driven_fields import DrivenFields
    from vibcli.analyses.transient.data_errors import DataErrors
    from vibcli.results.problem import Problem
    from vibcli.results.responses import PartOfSignal
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree

MOST = 10_000       # steps of a million products


class SteadyResponse(SmallResponse):
    """What loads keep up; `reason`: why nothing else is found; `only`: of which harmonic of periodic loads alone."""

    KIND = "steady"

    def __init__(self, problem: "Problem", reason: PhysicsError, only: int | None = None) -> None:
        super().__init__(problem)
        self.reason, self.only = reason, only
        self._channels: dict[str, int] = {}
        self._harmonics: list[Harmonic] = []

    @property
    def start(self) -> tuple[dict[str, float], dict[str, float]]:
        return self.problem.initial.start

    def of_harmonic(self, number: int) -> "SteadyResponse":
        """What one harmonic of loads with harmonics without end keeps up, 0 of their mean; of all others it itself."""
        if self.input_forcing.period is None:
            return self
        return SteadyResponse(self.problem, self.reason, number)

    @property
    def drives(self) -> bool:
        """Do loads that oscillate without end drive the scene?"""
        from vibcli.analyses.excitation.forcing import oscillates

        try:
            return self.input_forcing.period is not None or oscillates(self.input_forcing)
        except PhysicsError:
            return False

    @property
    def alone(self) -> "NotFollowed":
        return NotFollowed(self)

    def lasting(self) -> float:
        from vibcli.analyses.transient.duration import duration

        if self.only is None and self.input_forcing.period is not None:
            return float(self.input_forcing.period)
        speeds = [Omega for waves in self.waves.values() for Omega, _ in waves if Omega]
        if not speeds:
            raise self.reason
        return max(duration((), None, 0.0, speeds), tau / (common(speeds) or inf))

    @property
    def precise(self) -> NoReturn:
        raise PhysicsError("more digits of steady states of members are not found", "leave --digits out")

    def state_signal(self, node: Any) -> NoReturn:
        """Energies of members are spread along them: they are not found."""
        raise self.reason

    def _one(self, part: "PartOfSignal", source: tuple[Any, ...] = ()) -> Any:
        if self.only is None and self.input_forcing.period is not None and len(part) == 1 and part[0].head == "steady":
            from vibcli.results.repeating_signal import repeating

            return repeating(self, part[0].args[0])
        return super()._one(part, source)

    def _part(self, parts: "dict[Node, PartOfSignal]", name: str, primes: int,
              part: "SyntaxTree | tuple[str]") -> "Node":
        if name in self.problem.scene.parameters.nodes or isinstance(part, QuantityRef):
            return super()._part(parts, name, primes, part)
        text = name + "'" * primes
        if text not in self._channels:
            found = self._found(text, len(self._channels))
            self._channels[text] = len(self._channels)
            self._harmonics += found
        return self._named(parts, f"signal {text}", (LinearOutput(0.0, channels={self._channels[text]: 1.0}), None))

    def _found(self, text: str, channel: int) -> "list[Harmonic]":
        """The Harmonics of a signal, Σ H(iΩ) times what each input has of the frequency, and its value at rest."""
        import numpy as np

        from vibcli.analyses.continuous.kept_up_motion import Harmonic

        found = [] if signal_name(text).primes else [Harmonic(channel, 0.0, self._at_rest(text), 0.0)]
        drifting = {}       # inputs that alone drive at rest what nothing holds
        for number, waves in self.waves.items():
            parts = self._answered(text, {number: 1.0}, np.array([Omega for Omega, _ in waves]))
            for (Omega, A), (H, error, lost) in zip(waves, parts, strict=True):
                if lost and Omega:
                    raise resonance(1j * Omega)
                if lost:
                    drifting[number] = A
                else:
                    size = abs(A) * (error + 1e-15 * abs(H)) + self._lost[number] * abs(H)
                    found.append(Harmonic(channel, Omega, complex(H * A), size))
        if drifting:
            (H, error, lost), = self._answered(text, drifting, np.zeros(1))
            found += self._drifting(text, channel, drifting) if lost else [Harmonic(channel, 0.0, complex(H), error)]
        return found

    def _drifting(self, text: str, channel: int, weights: dict[int, complex]) -> "list[Harmonic]":
        """The Harmonics of what a signal has of a motion that nothing holds, t and t²/2, and beside it."""
        from vibcli.analyses.continuous.kept_up_motion import Harmonic

        rest = self._curve(text, weights).drifting
        if rest is None:
            raise resonance(0j)
        return [Harmonic(channel, 0.0, c / max(k, 1), off / max(k, 1), k)
                for k, (c, off) in enumerate([(rest.value, rest.error), *rest.drift])]

    def _curve(self, text: str, weights: dict[int, complex]) -> Any:
        from vibcli.analyses.frequency_response.member_system import MemberInput
        from vibcli.analyses.frequency_response.member_transfer import transfer_to

        return transfer_to(self.configuration, signal_name(text), MemberInput(weights), 0, self.problem.modal)

    def _answered(self, text: str, weights: dict[int, complex],
                  Omega: "np.ndarray") -> list[tuple[complex, float, bool]]:
        """[(H, how far it may be off, whether there is a pole)] of a signal to some inputs at once."""
        from vibcli.analyses.frequency_response.evaluate import sampled

        curve = self._curve(text, weights)
        with self.problem.work.task("steady states at the frequencies of loads", MOST):
            values, resonant = sampled(curve, Omega)
            return [(H, 0.0 if lost else curve.error(one), lost)
                    for one, H, lost in zip(Omega.tolist(), values, resonant, strict=True)]

    def amplitudes_along(self, text: str, between: tuple[float, float]) -> "Callable[[np.ndarray], np.ndarray] | None":
        """places → amplitudes of a signal there, from one solution for all; text: itself at a place between the two
        stations. None where it is found place by place alone."""
        from vibcli.mechanics.inputs_outputs.place_signals import place_output

        found = place_output(self.configuration, text)
        if found is None or found.primes or None in self._fields.values():
            return None

        def amplitudes(places: "np.ndarray") -> "np.ndarray":
            import numpy as np

            from vibcli.results.amplitude_of_waves import amplitude_of_waves

            waves = {Omega: field.along(found.owner, between, places, found.order) * float(found.factor)
                     for Omega, field in self._fields.items() if Omega}
            if len(waves) < 2:
                return np.abs(sum(waves.values(), np.zeros(len(places))))
            return np.array([amplitude_of_waves({Omega: X[i] for Omega, X in waves.items()}, self.problem.work)
                             for i in range(len(places))])
        return amplitudes

    @cached_property
    def _fields(self) -> "dict[float, DrivenFields | None]":
        """{Ω: the DrivenFields of what all inputs have of it, or None where these are not found at once}."""
        from vibcli.analyses.frequency_response.driven_fields import driven_fields

        together: dict[float, dict[int, complex]] = {}
        for number, waves in self.waves.items():
            for Omega, A in waves:
                together.setdefault(Omega, {})[number] = A
        damped = self.problem.modal.member_damping is not None
        return {Omega: None if damped else driven_fields(self.configuration, weights, Omega)
                for Omega, weights in together.items() if Omega}

    def _at_rest(self, text: str) -> float:
        """A signal in equilibrium."""
        from vibcli.analyses.excitation.signal_outputs import linear_output
        from vibcli.mechanics.inputs_outputs.place_signals import place_output
        from vibcli.mechanics.rest_curves import value_at_rest

        if place_output(self.configuration, text) is None:
            return linear_output(self.configuration, text)[0].constant
        return value_at_rest(self.configuration, text)

    @cached_property
    def input_forcing(self) -> "Forcing":
        """What the inputs do, each on a channel of its own."""
        from vibcli.analyses.excitation.decompose import forcing_of
        from vibcli.mechanics.linearise import load_at_rest
        from vibcli.notation.plain import plain
        from vibcli.symbolic.transfer_between_tables import copied

        opened = self.configuration.with_inputs
        nodes = {}
        for number, one in enumerate(opened.scene.inputs.values()):
            if one.node is not None:
                nodes[number] = one.node
            elif one.spread is not None:
                nodes[number] = opened.scene.spread_forces[one.spread].weight
            elif one.load is not None:
                _, turning, waving, constant = load_at_rest(opened.scene, opened.scene.forces[one.load])
                if turning.mask:
                    raise self.reason
                nodes[number] = waving + constant
        nodes = dict(zip(nodes, copied(list(nodes.values()), self.problem.scene.table), strict=True))
        return forcing_of(nodes, self.problem.scene.time, self.problem.numeric.floats, len(opened.scene.inputs),
                          write=plain, work=self.problem.work)

    @cached_property
    def waves(self) -> dict[int, list[tuple[float, complex]]]:
        """{coordinate of an input: [(Ω, A)]} of what the inputs do in the end, Re Σ A e^{iΩt}."""
        if self.problem.modal.modes.grow:
            raise PhysicsError("there is no steady state: the free motion grows", "the equilibrium is unstable")
        forcing, n = steady_forcing(self.input_forcing), self.configuration.with_inputs.n
        if forcing.period is not None:
            return self._of_harmonic(forcing)
        found: dict[int, dict[float, complex]] = {}
        for wave in forcing.pieces[0].waves:
            if wave.power:
                raise PhysicsError("a load that grows with the time keeps up no steady state of a scene with members",
                                   "let it end")
            rate, A = wave.exponent.imag, complex(wave.coefficient)
            rate, A = (-rate, A.conjugate()) if rate < 0 else (rate, A if rate else A.real)
            waves = found.setdefault(n + wave.channel, {})
            waves[rate] = waves.get(rate, 0.0) + A
        return {number: list(waves.items()) for number, waves in found.items()}

    def _of_harmonic(self, forcing: "Forcing") -> dict[int, list[tuple[float, complex]]]:
        """The waves of one harmonic."""
        if self.only is None:
            all_of_them = "max(steady(x)), amplitude(x), or for " if self.problem.modal.damped is not None else ""
            raise PhysicsError("this load has harmonics without end, and of members this is found of one at a time",
                               f"ask for {all_of_them}harmonic[1](x), harmonic[2](x) and so on of single signals, "
                               "or for abs(frf[…](Ω))")
        s, forces = harmonic_forces(forcing, self.only)
        return {number: [(s.imag, complex(A) if self.only else float(A))]
                for number, A in enumerate(forces, self.configuration.with_inputs.n) if A}

    @cached_property
    def _lost(self) -> dict[int, float]:
        """{coordinate of an input: how far what it does may be off by rounding}."""
        if self.only is None:
            return dict.fromkeys(self.waves, 0.0)
        lost = lost_forces(steady_forcing(self.input_forcing), self.only)
        return dict(enumerate(lost.tolist(), self.configuration.with_inputs.n))

    @property
    def kept(self) -> "KeptUpMotion":
        """The steady state of all signals asked so far."""
        from vibcli.analyses.continuous.kept_up_motion import KeptUpMotion

        return KeptUpMotion(len(self._channels), self._harmonics, self.problem.work)


class NotFollowed:
    """A motion of which only the steady state is found."""

    def __init__(self, response: SteadyResponse) -> None:
        self._response = response

    @property
    def forcing(self) -> "Forcing":
        """What drives it."""
        return self._response.input_forcing

    @property
    def steady(self) -> "KeptUpMotion":
        """What loads keep up."""
        return self._response.kept

    @property
    def data_errors(self) -> "DataErrors":
        """Those of the steady state."""
        return self.steady.data_errors

    def __getattr__(self, name: str) -> Any:
        raise self._response.reason
