"""The motion in time of scenes of which some members are followed by travelling waves and the rest is found by modes,
as neither moves the other: a straight beam that stretches, a bar beside a beam."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.results.response_of_members import ResponseOfMembers
from vibcli.results.wave_response import WaveResponse

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from vibcli.results.modal_response import ModalResponse
    from vibcli.results.problem import Problem


class WavesOfParts(WaveResponse):
    """The motion of some coordinates and pieces of a scene by travelling waves; `whole` is the response of all."""

    def __init__(self, problem: "Problem", whole: "ModalResponse", coordinates: "Sequence[int]",
                 pieces: "Sequence[int]"):
        super().__init__(problem)
        self.whole, self._pieces = whole, list(pieces)
        self._own = {i: number for number, i in enumerate(coordinates)}

    @cached_property
    def matrices(self):
        import numpy as np

        own = list(self._own)
        return tuple(matrix[np.ix_(own, own)] for matrix in self.whole.matrices)

    @cached_property
    def placed(self):
        return [self.whole.placed[p] for p in self._pieces]

    @cached_property
    def ends_of_pieces(self):
        ends = iter(self.whole.ends_of_pieces)
        found = [[next(ends) for _ in placed.rows] for placed in self.whole.placed]
        return [(self._renumbered(row), node) for p in self._pieces for row, node in found[p]]

    @cached_property
    def loads(self):
        return self._renumbered(self.whole.loads)

    @cached_property
    def deviations(self):
        own = list(self._own)
        return tuple(part[own] for part in self.whole.deviations)

    @cached_property
    def fields(self):
        from vibcli.mechanics.initial_fields import member_fields

        given, waves = member_fields(self.problem.scene), WaveResponse(self.problem)
        return [waves._field(piece, given.get(piece.owner)) for piece in self.placed]

    @property
    def spread_forces(self):
        owners = {placed.owner for placed in self.placed}
        return [force for force in self.whole.spread_forces if force.member in owners]

    def _renumbered(self, row):
        return {self._own[i]: x for i, x in row.items() if i in self._own}

    def split(self, output: "LinearOutput") -> "tuple[LinearOutput, LinearOutput]":
        """(what an output reads of these parts, in their own numbers, what it reads of all else)."""
        numbers = {p: number for number, p in enumerate(self._pieces)}
        own = {place._replace(piece=numbers[place.piece]): x
               for place, x in output.places.items() if place.piece in numbers}
        rest = {place: x for place, x in output.places.items() if place.piece not in numbers}
        here, there = ([{i: x for i, x in row.items() if (i in self._own) == inside} for row in (
            output.q, output.v, output.a)] for inside in (True, False))
        return (LinearOutput(0.0, *map(self._renumbered, here), {}, own),
                LinearOutput(output.constant, *there, output.channels, rest))


class PartedResponse(ResponseOfMembers):
    """Small oscillations about the equilibrium, each part of a scene that moves by itself in its own way."""

    KIND = "parts"
    WORDS = "small oscillations about the equilibrium, by travelling waves where these stay as they are, else by modes"

    def __init__(self, modes: "ModalResponse", waves: WavesOfParts):
        super().__init__(modes.problem)
        self.modes, self.waves, self.estimated = modes, waves, modes.estimated

    @property
    def alone(self):
        """The motion by modes."""
        return self.modes.alone

    def reach(self, until: float) -> None:
        """Follow the waves up to an instant; NotByWaves where fronts are too many."""
        self.waves.reach(until)

    def instants(self, signals: "Sequence[Any]", points: int) -> "np.ndarray":
        """With those of fronts, each twice."""
        return self.waves.instants(signals, points)

    def _linear(self, constant, terms, source=()):
        split = [(factor, *self.waves.split(output), node) for factor, (output, node) in terms]
        here = [(factor, (own, None)) for factor, own, _, _ in split if any(own[1:])]
        there = [(factor, (other, node)) for factor, _, other, node in split if node is not None or any(other[1:])]
        if not here:
            return self.modes._linear(constant, terms, source)
        constant += sum(factor * other.constant for factor, _, other, node in split
                        if node is None and not any(other[1:]))
        if not there:
            return self.waves._linear(constant, here)
        table = self.problem.scene.table
        waves, modes = table.variable("signal by waves"), table.variable("signal by modes")
        return self.modes.composed_of({waves.name: self.waves._linear(0.0, here),
                                       modes.name: self.modes._linear(constant, there, source)}, waves + modes)

    def _composed(self, node, parts, source=()):
        return self.modes.composed_of({symbol.name: self._one(part) for symbol, part in parts.items()}, node, source)


def parted(modes: "ModalResponse") -> "PartedResponse | None":
    """The response whose parts that waves travel through are followed by these; None where there are none."""
    from vibcli.analyses.continuous.uncoupled_parts import tied_parts

    if modes.problem.spec.get("damping") is not None:
        return None
    parts = tied_parts(modes.matrices, [placed.rows for placed in modes.placed])
    chosen = {number for number in set(parts.pieces)
              if all(_travels(modes.placed[p]) for p, part in enumerate(parts.pieces) if part == number)}
    if not chosen:
        return None
    waves = WavesOfParts(modes.problem, modes, *([i for i, part in enumerate(numbers) if part in chosen]
                                                 for numbers in parts))
    try:
        waves.alone  # noqa: B018 - is its motion one of waves?
    except NotByWaves:
        return None
    return PartedResponse(modes, waves)


def _travels(placed):
    """Do waves keep their form along a piece?"""
    from vibcli.analyses.continuous.travelling_waves_march import wave_piece

    try:
        wave_piece(placed, ({}, None), ({}, None))
    except NotByWaves:
        return False
    return True
