"""The motion in time of scenes whose members move apart: a straight beam that stretches, a bar beside a beam.
What waves travel through is followed by these, the rest is found by its own modes."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.results.modal_response import ModalResponse
from vibcli.results.not_by_modes import CoupledModes
from vibcli.results.part_of_members import PartOfMembers
from vibcli.results.response_of_members import ResponseOfMembers
from vibcli.results.wave_response import WaveResponse

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import numpy as np

    from vibcli.analyses.continuous.estimated_motion import EstimatedMotion
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.responses import PartOfSignal, Terms
    from vibcli.results.signal import Signal
    from vibcli.symbolic.node import Node

    Followed = tuple[Any, Callable[[LinearOutput], LinearOutput]]

FEW = 1_000     # fronts of what modes tell too


class PartedResponse(ResponseOfMembers):
    """Small oscillations about the equilibrium: of what waves travel through, if they are `followed`, and of the rest,
    each a response and what an output reads of it. `waves`: what values at instants are read off as long as fronts
    stay few."""

    KIND = "parts"
    WORDS = "small oscillations about the equilibrium, by travelling waves where these keep their form, else by modes"

    def __init__(self, whole: ModalResponse, parts: "Sequence[Followed]", followed: WaveResponse | None = None,
                 waves: "PartedResponse | None" = None) -> None:
        super().__init__(whole.problem, waves)
        self.whole, self.parts, self.followed, self.estimated = whole, parts, followed, whole.estimated

    @property
    def words(self) -> str:
        return self.whole.words if self.followed is None else self.WORDS

    @property
    def alone(self) -> "ModalMotion | EstimatedMotion":
        """The motion of all by modes."""
        return self.whole.alone

    @property
    def modal(self) -> ModalResponse:
        """All by modes."""
        return self.whole

    @property
    def _forces(self) -> Any:
        return self.whole._forces

    def reach(self, until: float) -> None:
        """Follow the waves up to an instant; NotByWaves where fronts are too many."""
        self.followed.reach(until)

    def instants(self, signals: "Sequence[Any]", points: int) -> "np.ndarray":
        return super().instants(signals, points) if self.followed is None else self.followed.instants(signals, points)

    def _linear(self, constant: float, terms: "Terms", source: tuple[Any, ...] = ()) -> "Signal":
        constant += sum(factor * output.constant for factor, (output, _) in terms)
        found = []
        for number, (one, read) in enumerate(self.parts, 1):
            own = [(factor, (read(output), node if number == len(self.parts) else None))
                   for factor, (output, node) in terms]
            if any(node is not None or any(output[1:]) for _, (output, node) in own):
                found.append((one, own))
        if len(found) < 2:
            one, own = found[0] if found else (self.parts[-1][0], [])
            result: Signal = one._linear(constant, own, source)
            return result
        symbols = [self.problem.scene.table.variable(f"signal of part {k}") for k in range(len(found))]
        signals = {symbol.name: one._linear(0.0 if k else constant, own, source)
                   for k, (symbol, (one, own)) in enumerate(zip(symbols, found, strict=True))}
        return self.whole.composed_of(signals, sum(symbols[1:], symbols[0]), source)

    def _composed(self, node: "Node", parts: "Mapping[Node, PartOfSignal]", source: tuple[Any, ...] = ()) -> "Signal":
        return self.whole.composed_of({symbol.name: self._one(part) for symbol, part in parts.items()}, node, source)


def parted(whole: ModalResponse) -> ResponseOfMembers:
    """The response whose parts that waves travel through are followed by these, and of parts with dampers each by its
    own modes, or the whole where there are no such parts."""
    problem, (inside, outside) = whole.problem, _divided(whole)
    if problem.spec.get("damping") is not None or not outside or not (inside or (whole.estimated and outside[1:])):
        return whole
    rest = [(_by_own_modes(whole, part), part.read) for part in (outside if whole.estimated else [_joined(outside)])]
    if not inside:
        return PartedResponse(whole, rest)
    together = _joined(inside)
    waves = WaveResponse(problem, together)
    found = PartedResponse(whole, [(waves, together.read), *rest], waves)
    try:
        march = waves.alone.march
    except NotByWaves:
        return whole
    try:
        march.require_few(found.until, FEW)
    except NotByWaves:
        first = [(_by_own_modes(whole, part), part.read) for part in inside] if whole.estimated else [
            (whole, together.read_among_all)]
        return PartedResponse(whole, [*first, *rest], waves=found)
    return found


def _by_own_modes(whole: ModalResponse, part: PartOfMembers) -> ModalResponse:
    """The response of a part by its own modes, damped ones where dampers couple these."""
    found = ModalResponse(whole.problem, part=part)
    try:
        found.alone  # noqa: B018 - is its motion one of modes by themselves?
    except CoupledModes:
        found = type(whole)(whole.problem, part=part)
    return found


def _divided(whole: ModalResponse) -> tuple[list[PartOfMembers], list[PartOfMembers]]:
    """The parts with pieces that waves travel through, and the others, coordinates of no piece among these."""
    from vibcli.analyses.continuous.uncoupled_parts import tied_parts

    parts = tied_parts(whole.matrices, [placed.rows for placed in whole.placed])
    found = [], []
    for number in sorted(set(parts.pieces)):
        own = PartOfMembers(*([i for i, part in enumerate(numbers) if part == number] for numbers in parts))
        found[not all(_travels(whole.placed[p]) for p in own.pieces)].append(own)
    loose = PartOfMembers([i for i, part in enumerate(parts.coordinates) if part not in parts.pieces], [])
    if loose.coordinates and found[1]:
        found[1][0] = _joined([found[1][0], loose])
    return found


def _joined(parts: "Sequence[PartOfMembers]") -> PartOfMembers:
    """Several parts as one."""
    return PartOfMembers(*(sorted(i for part in parts for i in numbers(part)) for numbers in (
        lambda part: part.coordinates, lambda part: part.pieces)))


def _travels(placed: "PlacedPiece") -> bool:
    """Do waves keep their form along a piece?"""
    from vibcli.analyses.continuous.travelling_waves_piece import wave_piece

    try:
        wave_piece(placed, ({}, None), ({}, None))
    except NotByWaves:
        return False
    return True
