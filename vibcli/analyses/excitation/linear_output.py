"""What is read off a linear system: y = constant + q·δ + v·δ̇ + a·δ̈ + channels + places, δ the deviation from
equilibrium."""

from collections.abc import Iterable
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
    q: dict[int, Any] = {}
    v: dict[int, Any] = {}
    a: dict[int, Any] = {}
    channels: dict[int, Any] = {}
    places: dict[FieldPoint, Any] = {}

    @property
    def told(self) -> tuple[Any, ...]:
        """What tells it apart, by which it is found in tables."""
        return (self.constant, *(tuple(part.items()) for part in self[1:]))


def combined(terms: Iterable[tuple[Any, LinearOutput]]) -> LinearOutput:
    """Σ factor·output of (factor, LinearOutput) pairs."""
    constant, parts = 0.0, ({}, {}, {}, {}, {})
    for factor, output in terms:
        constant += factor * output.constant
        kinds: tuple[dict[Any, Any], ...] = output[1:]
        for part, entries in zip(parts, kinds, strict=True):
            for key, value in entries.items():
                part[key] = part.get(key, 0.0) + factor * value
    return LinearOutput(constant, *parts)
