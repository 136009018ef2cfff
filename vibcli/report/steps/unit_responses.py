"""What a unit impulse, step or ramp at τ = 0 brings about from rest in M ẍ + 2δM ẋ + K x = f,  ω² = K/M."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


class UnitResponses(NamedTuple):
    """M, K, the letters ω, δ, ω_d and τ, and whether it is damped."""

    mass: "Node"
    stiffness: "Node"
    omega: "Node"
    delta: "Node"
    omega_d: "Node"
    tau: "Node"
    damped: bool

    def of(self, kind: str) -> "Node":
        """That to an impulse, a step or a ramp."""
        omega, tau, table = self.omega, self.tau, self.tau.table
        rate, delta = (self.omega_d, self.delta) if self.damped else (omega, table.zero)
        sine, cosine = table.call("sin", rate * tau), table.call("cos", rate * tau)
        decay, square = table.call("exp", -(delta * tau)) if self.damped else table.one, omega ** 2
        if kind == "impulse":
            return decay * sine / (self.mass * rate)
        if kind == "step":
            return (1 - decay * (cosine + delta * sine / rate)) / self.stiffness
        return (tau - 2 * delta / square + decay * (2 * delta * cosine / square + (delta ** 2 - rate ** 2) * sine / (
            square * rate))) / self.stiffness
