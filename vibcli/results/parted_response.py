"""The motion in time of scenes whose members move apart: a straight beam that stretches, a bar beside a beam.
What waves travel through is followed by these, the rest is found by its own modes."""

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

    Followed = tuple[Any, Callable[[LinearOutput], LinearOutput]]

FEW = 1_000     # fronts of what modes tell too


class PartedResponse(ResponseOfMembers):
    """Small oscillations about the equilibrium: of what waves travel through, and of the rest, each a response and what
    an output reads of it. `waves`: what values at instants are read off as long as fronts stay few."""

    KIND = "parts"
    WORDS = "small oscillations about the equilibrium, by travelling waves where these keep their form, else by modes"

    def __init__(self, whole: ModalResponse, first: "Followed", rest: "Followed",
                 waves: "PartedResponse | None" = None):
        super().__init__(whole.problem, waves)
        self.whole, self.parts, self.estimated = whole, (first, rest), whole.estimated

    @property
    def words(self) -> str:
        return self.WORDS if self._waves is None else self.whole.words

    @property
    def alone(self) -> "ModalMotion | EstimatedMotion":
        """The motion of all by modes."""
        return self.whole.alone

    @property
    def modal(self) -> ModalResponse:
        """All by modes."""
        return self.whole

    @property
    def _forces(self):
        return self.whole._forces

    def reach(self, until: float) -> None:
        """Follow the waves up to an instant; NotByWaves where fronts are too many."""
        self.parts[0][0].reach(until)

    def instants(self, signals: "Sequence[Any]", points: int) -> "np.ndarray":
        return self.parts[0][0].instants(signals, points)

    def _linear(self, constant, terms, source=()):
        constant += sum(factor * output.constant for factor, (output, _) in terms)
        (first, read), (rest, read_of_rest) = self.parts
        here = [(factor, (read(output), None)) for factor, (output, _) in terms]
        there = [(factor, (read_of_rest(output), node)) for factor, (output, node) in terms]
        if not any(any(output[1:]) for _, (output, _) in here):
            return rest._linear(constant, there, source)
        if not any(node is not None or any(output[1:]) for _, (output, node) in there):
            return first._linear(constant, here, source)
        one, other = map(self.problem.scene.table.variable, ("signal of the first", "signal of the rest"))
        return self.whole.composed_of({one.name: first._linear(constant, here, source),
                                       other.name: rest._linear(0.0, there, source)}, one + other, source)

    def _composed(self, node, parts, source=()):
        return self.whole.composed_of({symbol.name: self._one(part) for symbol, part in parts.items()}, node, source)


def parted(whole: ModalResponse) -> ResponseOfMembers:
    """The response whose parts that waves travel through are followed by these, or the whole where there are none."""
    problem, (inside, outside) = whole.problem, _divided(whole)
    if problem.spec.get("damping") is not None or not inside.pieces or not outside.pieces:
        return whole
    waves, rest = WaveResponse(problem, inside), (_by_own_modes(whole, outside), outside.read)
    found = PartedResponse(whole, (waves, inside.read), rest)
    try:
        march = waves.alone.march
    except NotByWaves:
        return whole
    try:
        march.require_few(found.until, FEW)
    except NotByWaves:
        return PartedResponse(whole, (whole, inside.read_among_all), rest, found)
    return found


def _by_own_modes(whole, part):
    """The response of a part by its own modes, damped ones where dampers couple these."""
    found = ModalResponse(whole.problem, part=part)
    try:
        found.alone  # noqa: B018 - is its motion one of modes by themselves?
    except CoupledModes:
        found = type(whole)(whole.problem, part=part)
    return found


def _divided(whole):
    """The part that waves travel through, and the rest."""
    from vibcli.analyses.continuous.uncoupled_parts import tied_parts

    parts = tied_parts(whole.matrices, [placed.rows for placed in whole.placed])
    chosen = {number for number in set(parts.pieces)
              if all(_travels(whole.placed[p]) for p, part in enumerate(parts.pieces) if part == number)}
    return [PartOfMembers(*([i for i, part in enumerate(numbers) if (part in chosen) == within] for numbers in parts))
            for within in (True, False)]


def _travels(placed):
    """Do waves keep their form along a piece?"""
    from vibcli.analyses.continuous.travelling_waves_march import wave_piece

    try:
        wave_piece(placed, ({}, None), ({}, None))
    except NotByWaves:
        return False
    return True
