"""The motion in time of scenes with bars, shafts and strings, by the waves that travel along them."""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.errors import PhysicsError
from vibcli.results.response_of_members import ResponseOfMembers

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import numpy as np

    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.analyses.continuous.travelling_waves_piece import WavePiece
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.part_of_members import PartOfMembers
    from vibcli.results.problem import Problem
    from vibcli.results.responses import PartOfSignal, SmallResponse, Terms
    from vibcli.results.signal import Signal
    from vibcli.results.wave_signals import ComposedOfWaves, WaveSignal
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree


class WaveResponse(ResponseOfMembers):
    """Small oscillations about the equilibrium, followed from front to front. NotByWaves where a member disperses its
    waves or loses them on their way, or where the fronts are too many. by_modes(problem, waves): the response by modes
    beside these waves, None where there is none."""

    KIND, WORDS = "waves", "small oscillations about the equilibrium, by travelling waves"

    def __init__(self, problem: "Problem", part: "PartOfMembers | None" = None,
                 by_modes: "Callable[..., SmallResponse] | None" = None) -> None:
        super().__init__(problem, part=part)
        self._by_modes = by_modes

    @cached_property
    def alone(self) -> "WaveMotion":
        """The WaveMotion under the excitation."""
        if self.problem.spec.get("damping") is not None:
            raise NotByWaves("damping that is given of modes acts on modes, not on travelling waves")
        pieces = self._pieces(self.placed)
        return self._followed(pieces, self._forces, self.deviations, self.fields)

    def _pieces(self, placed: "Sequence[PlacedPiece]") -> "list[WavePiece]":
        """The WavePieces of PlacedPieces."""
        from vibcli.analyses.continuous.travelling_waves_piece import wave_piece

        numbered = self._numbered_ends
        return [wave_piece(one, *(end[:2] for end in numbered[2 * k:2 * k + 2])) for k, one in enumerate(placed)]

    def _followed(self, pieces: "list[WavePiece]", forces: "Forcing", start: "tuple[np.ndarray, np.ndarray]",
                  fields: "list[Forcing | None] | None") -> "WaveMotion":
        """The WaveMotion of WavePieces under a Forcing from (q, v) and fields of pieces on."""
        from vibcli.analyses.continuous.travelling_waves import wave_motion
        from vibcli.analyses.continuous.travelling_waves_loads import LoadAlong

        first = self._numbered_loads
        loads = [[LoadAlong(form, first + k) for k, drive in enumerate(self.spread_drives[:len(self.spread_forces)])
                  if (form := drive.on(one)) is not None] for one in self.placed]
        return wave_motion(*self.matrices, pieces, forces, *start, fields, self.problem.work, loads)

    @property
    def _numbered_ends(self) -> "list[tuple[dict[int, float], int | None, Node | None]]":
        """[(row, channel of what the time moves it by, its node)] of ends of pieces, None where it does not."""
        channels = iter(range(len(self.matrices[0]), len(self.matrices[0]) + len(self.ends_of_pieces)))
        return [(row, None if node is None else next(channels), node) for row, node in self.ends_of_pieces]

    @property
    def _numbered_loads(self) -> int:
        """The channel of the first load along members."""
        return len(self.matrices[0]) + len(self.ends_of_pieces)

    @cached_property
    def _forces(self) -> "Forcing":
        """The Forcing of all channels."""
        from vibcli.analyses.excitation.decompose import forcing_of
        from vibcli.notation.plain import plain

        return forcing_of(self._moving, self.problem.scene.time, self.problem.numeric.floats,
                          self._numbered_loads + len(self.spread_forces), write=plain, work=self.problem.work)

    @cached_property
    def _moving(self) -> "dict[int, Node]":
        """{channel: node of the time} of coordinates, ends of pieces and loads along them."""
        ends = {channel: node for _, channel, node in self._numbered_ends if channel is not None}
        return self.loads | ends | dict(enumerate((one.weight for one in self.spread_forces), self._numbered_loads))

    def reach(self, until: float) -> None:
        """Follow the waves up to an instant; NotByWaves where their fronts are too many."""
        self.alone.march.reach(until)

    def without_bound(self, constant: float, terms: "Terms",
                      motion: "ModalMotion", asked: tuple[Any, ...]) -> "Signal | None":
        """The signal of a linear function that modes give no bound, which is followed by waves as long as it is looked
        at; None where it is not."""
        return None

    def best_at(self, signal: "Signal", t: float) -> "Signal":
        """A signal of its own as it is found at an instant: by modes where the fronts up to then are too many."""
        if self._by_modes is None:
            return signal
        try:
            self.reach(t)
        except NotByWaves:
            if self.modal.KIND == "steady":
                raise
            by_modes: Signal = self.modal.signal(signal.asked[1])
            return by_modes.read_at(t)
        return signal

    @cached_property
    def modal(self) -> "SmallResponse":
        """The response by modes beside these waves."""
        return self._by_modes(self.problem, self)

    def moved(self, direct: Any = ()) -> "WaveMotion":
        """The same motion, read with nodes of the time on further channels."""
        return self.alone.under(self.forcing(direct)) if direct else self.alone

    def instants(self, signals: "Sequence[Any]", points: int) -> "np.ndarray":
        """With those of fronts, each twice."""
        import numpy as np

        found = sorted({t for signal in signals for t, *_ in signal.leaps(self.known)})[:points]
        return np.sort(np.concatenate([super().instants(signals, points), found, found]))

    def _linear(self, constant: float, terms: "Terms", source: tuple[Any, ...] = ()) -> "WaveSignal":
        from vibcli.results.wave_signals import WaveSignal

        return WaveSignal(*self._driven(constant, terms), self._of_its_own(source))

    def _composed(self, node: "Node", parts: "Mapping[Node, PartOfSignal]",
                  source: tuple[Any, ...] = ()) -> "ComposedOfWaves":
        from vibcli.results.wave_signals import ComposedOfWaves

        if self._closing(node) is not None:
            raise PhysicsError("signals of loops that close are not found where waves travel", "ask for coordinates")
        signals = {symbol.name: self._one(part) for symbol, part in parts.items()}
        return ComposedOfWaves(node, signals, self.values, self.problem.scene.time, None, self.problem.work,
                               asked=self._of_its_own(source))

    def _of_its_own(self, source: "tuple[SyntaxTree | WaveResponse, ...]") -> "tuple[SyntaxTree | WaveResponse, ...]":
        return source if source and source[0] is self else ()
