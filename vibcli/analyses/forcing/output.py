"""What is read off a linear system: y = constant + q·δ + v·δ̇ + a·δ̈ + channels, δ the deviation from equilibrium."""

from typing import NamedTuple


class Output(NamedTuple):
    """Coefficients {i: number} of the deviations, their rates and accelerations, {channel: number} of the forcing."""

    constant: float = 0.0
    q: dict = {}
    v: dict = {}
    a: dict = {}
    channels: dict = {}
