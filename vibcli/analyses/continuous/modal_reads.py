"""What outputs read of a motion by modes."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.mechanics.factored_system import PlacedPiece

SHARES = 0.11, 0.29, 0.52, 0.73, 0.93       # of a length: places that no symmetry keeps at rest together


class Read:
    """What an output reads of a ModalMotion, in a rate: rows over states and over (η, η̇) of what nothing holds."""

    def __init__(self, motion: "ModalMotion", output: "LinearOutput", order: int) -> None:
        states, (rows, rigid) = motion.states, motion.rows_of(output)
        self.output, self.order, self._motion = output, order, motion
        self.states = sum((rows[m] * states.rates ** (m + order) for m in range(3)), 0 * states.rates)
        self.rigid = np.zeros((2, rigid.shape[1]))
        for m in range(3):
            if m + order < 2:
                self.rigid[m + order] += rigid[m]

    @cached_property
    def off(self) -> Any:
        """What rounding leaves of the rows over states."""
        pace = np.abs(self._motion.states.rates)
        return sum(part * pace ** (m + self.order) for m, part in enumerate(self._motion.off_of(self.output)))


def key_of(output: "LinearOutput") -> tuple[tuple[tuple[Any, float], ...], ...]:
    """What tells an output from others, but for its constant and channels."""
    return tuple(tuple(sorted(part.items())) for part in (output.q, output.v, output.a, output.places))


def elsewhere(output: "LinearOutput", pieces: "Sequence[PlacedPiece]") -> "list[LinearOutput]":
    """What an output reads of one place of members or of one of their ends, of places of all pieces of that kind; none
    of sums, and of what else moves."""
    read = [(pieces[place.piece].piece.order, place.along, place.rates, x) for place, x in output.places.items() if x]
    for rates, row in enumerate((output.q, output.v, output.a)):
        for i, x in row.items():
            ends = [(one.piece.order, end % (one.piece.order // 2)) for one in pieces
                    for end, ties in enumerate(one.rows) if ties.get(i)]
            read += [(*ends[0], rates, x)] if ends and x else []
    if len(read) != 1:
        return []
    (order, along, rates, x), = read
    return [LinearOutput(places={FieldPoint(p, share * float(one.piece.length), along, rates): x})
            for p, one in enumerate(pieces) if one.piece.order == order for share in SHARES]
