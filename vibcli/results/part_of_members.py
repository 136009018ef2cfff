"""Some coordinates and pieces of a scene that nothing else of it moves."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation.linear_output import LinearOutput

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.factored_system import FactoredSystem


class PartOfMembers:
    """coordinates, pieces: their numbers in the scene, by which they are numbered anew."""

    def __init__(self, coordinates: Sequence[int], pieces: Sequence[int]) -> None:
        self.coordinates, self.pieces = list(coordinates), list(pieces)

    @cached_property
    def _numbers(self) -> tuple[dict[int, int], ...]:
        return tuple({old: new for new, old in enumerate(one)} for one in (self.coordinates, self.pieces))

    def row(self, row: Mapping[int, Any]) -> dict[int, Any]:
        """{coordinate: x} of its own, in new numbers."""
        numbers = self._numbers[0]
        return {numbers[i]: x for i, x in row.items() if i in numbers}

    def block(self, matrix: "np.ndarray") -> "np.ndarray":
        """Of a matrix over all coordinates."""
        return matrix[self.coordinates][:, self.coordinates]

    def elements(self, found: "FactoredSystem") -> "FactoredSystem":
        """Of the element data of all."""
        return found.among(self._numbers[0], self.pieces)

    def read(self, output: LinearOutput) -> LinearOutput:
        """What an output reads of it, in new numbers."""
        numbers = self._numbers[1]
        places = {place._replace(piece=numbers[place.piece]): x
                  for place, x in output.places.items() if place.piece in numbers}
        return LinearOutput(0.0, self.row(output.q), self.row(output.v), self.row(output.a), {}, places)

    def read_among_all(self, output: LinearOutput) -> LinearOutput:
        """The same in the numbers of the scene."""
        own, pieces = self._numbers
        q, v, a = ({i: x for i, x in row.items() if i in own} for row in (output.q, output.v, output.a))
        return LinearOutput(0.0, q, v, a, {}, {place: x for place, x in output.places.items() if place.piece in pieces})
