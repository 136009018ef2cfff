"""Uniform pieces of members along which waves travel without changing their form."""

from typing import Any, cast

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.named_tuple import NamedTuple


class WavePiece(NamedTuple):
    """A uniform piece of a bar, shaft or string: N u″ = μ ü over its length. left, right: ({coordinate: slope}, channel
    of the loads that moves the end beside these or None)."""

    length: float
    tension: float
    inertia: float
    left: tuple[dict[int, float], int | None]
    right: tuple[dict[int, float], int | None]

    @property
    def speed(self) -> float:
        return cast("float", (self.tension / self.inertia) ** 0.5)

    @property
    def impedance(self) -> float:
        return cast("float", (self.tension * self.inertia) ** 0.5)


def wave_piece(placed: Any, left: tuple[dict[int, float], int | None],
               right: tuple[dict[int, float], int | None]) -> WavePiece:
    """The WavePiece of a PlacedPiece between two ends; NotByWaves where waves change their form along it."""
    length, bending, tension, gradient, inertia, drag, foundation = map(float, placed.piece)
    reasons = (("beams disperse their waves", bending), ("its tension varies along it", gradient),
               ("drag damps its waves on their way", drag), ("its foundation disperses its waves", foundation))
    for reason, coefficient in reasons:
        if coefficient:
            raise NotByWaves(f"'{placed.owner}' is not followed by travelling waves: {reason}")
    if not inertia > 0 or not tension > 0:
        raise NotByWaves(f"no waves travel along '{placed.owner}'")
    return WavePiece(length, tension, inertia, left, right)
