"""What an output reads of vibrations z, ż = A z, that are left out: [A⁻ᵏ a, Aᵏ z], a being what goes with displacements
of a place, and k the least at which A⁻ᵏ a has an energy."""

from collections.abc import Sequence
from math import comb, factorial
from typing import TYPE_CHECKING

from vibcli.analyses.continuous.left_out_columns import Column
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece


class Reading(NamedTuple):
    """The rate-th rate of displacements that an output reads; level: that k."""

    output: LinearOutput
    rate: int
    level: int

    def columns(self, k: int, fading: float) -> tuple[list[Column], list[float]]:
        """(Columns, factors) of A⁻ᵏ a: sᵐ/(s + δ)ᵏ⁺¹, divided in powers of s + δ."""
        columns, e = [], []
        for j in range(self.rate + 1):
            factor, power = comb(self.rate, j) * (-fading) ** (self.rate - j), k - j
            if factor:
                columns.append(Column(0, 0j if power < 0 else complex(-fading), power))
                e.append(-factor if power < 0 else factor / factorial(power))
        return columns, e


def readings(output: LinearOutput, order: int, pieces: "Sequence[PlacedPiece]",
             massive: "Sequence[bool]") -> list[Reading]:
    """What makes up an output's order-th rate; massive: which coordinates have mass."""
    found = [(LinearOutput(q=row), rate + order) for rate, row in enumerate((output.q, output.v, output.a))
             if any(row.values())]
    found += [(LinearOutput(places={place._replace(rates=0): factor}), place.rates + order)
              for place, factor in output.places.items() if factor]
    return [Reading(*one, _level(*one, pieces, massive)) for one in found]


def _level(output: LinearOutput, rate: int, pieces: "Sequence[PlacedPiece]", massive: Sequence[int]) -> int:
    """0 of displacements and slopes, of the first rate of what has mass; 1 of forces; by 1 more of each rate."""
    if any(place.along >= pieces[place.piece].piece.order // 2 for place in output.places):
        return 1 + rate
    return max(rate - (not output.places and all(massive[i] for i in output.q)), 0)
