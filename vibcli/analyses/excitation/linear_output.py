"""What is read off a linear system: y = constant + q·δ + v·δ̇ + a·δ̈ + channels + places, δ the deviation from
equilibrium."""

from typing import Any

from vibcli.base.named_tuple import NamedTuple


class FieldPoint(NamedTuple):
    """u at the distance x from the left end of a piece of a member, `along` of its derivatives by x and `rates` by the
    time; piece: its number among those of the system."""

    piece: int
    x: float
    along: int = 0
    rates: int = 0


class LinearOutput(NamedTuple):
    """Coefficients {i: number} of the deviations, their rates and accelerations, {channel: number} of the forcing,
    {FieldPoint: number} of what members do between their stations."""

    constant: float = 0.0
    q: dict = {}
    v: dict = {}
    a: dict = {}
    channels: dict = {}
    places: dict = {}

    @property
    def told(self) -> tuple:
        """What tells it apart, by which it is found in tables."""
        return (self.constant, *(tuple(part.items()) for part in self[1:]))


def combined(terms: Any) -> LinearOutput:
    """Σ factor·output of (factor, LinearOutput) pairs."""
    constant, parts = 0.0, ({}, {}, {}, {}, {})
    for factor, output in terms:
        constant += factor * output.constant
        for part, entries in zip(parts, output[1:], strict=True):
            for key, value in entries.items():
                part[key] = part.get(key, 0.0) + factor * value
    return LinearOutput(constant, *parts)
