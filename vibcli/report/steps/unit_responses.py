"""What a unit impulse, step or ramp at τ = 0, or a wave from then on, brings about from rest in

    M ẍ + 2δM ẋ + K x = f,  ω² = K/M,

with R = K − MΩ² and S = 2δMΩ of waves sin Ωτ and cos Ωτ; and what a place and no speed goes on as (Thomson & Dahleh
1998, chapter 4)."""

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

    @property
    def _waves(self) -> "tuple[Node, Node, Node, Node]":
        """sin ω_dτ/ω_d, cos ω_dτ, e^{−δτ} and δ."""
        tau, table = self.tau, self.tau.table
        rate, delta = (self.omega_d, self.delta) if self.damped else (self.omega, table.zero)
        decay = table.call("exp", -(delta * tau)) if self.damped else table.one
        return table.call("sin", rate * tau) / rate, table.call("cos", rate * tau), decay, delta

    def of(self, kind: str) -> "Node":
        """That to an impulse, a step or a ramp, or from the place 1."""
        square, (sine, cosine, decay, delta) = self.omega ** 2, self._waves
        if kind == "impulse":
            return decay * sine / self.mass
        if kind == "place":
            return decay * (cosine + delta * sine)
        if kind == "step":
            return (1 - decay * (cosine + delta * sine)) / self.stiffness
        rate = self.omega_d if self.damped else self.omega
        return (self.tau - 2 * delta / square + decay * (2 * delta * cosine / square + (
            delta ** 2 - rate ** 2) * sine / square)) / self.stiffness

    def to_wave(self, kind: str, Omega: "Node", R: "Node", S: "Node") -> "Node":
        """That to a wave."""
        call, turned, (sine, cosine, decay, delta) = self.tau.table.call, Omega * self.tau, self._waves
        factor, size = (R, R ** 2 + S ** 2) if self.damped else (self.tau.table.one, R)
        if kind == "sin":
            kept = factor * call("sin", turned) - S * call("cos", turned)
            return (kept + decay * (S * cosine + (delta * S - Omega * factor) * sine)) / size
        kept = factor * call("cos", turned) + S * call("sin", turned)
        return (kept - decay * (factor * cosine + (delta * factor + Omega * S) * sine)) / size

    def to_own_wave(self, kind: str) -> "Node":
        """That to a wave of the frequency ω, where nothing damps."""
        sine, cosine, *_ = self._waves
        grows, turned = self.omega * sine, self.omega * self.tau
        return (turned * grows if kind == "cos" else grows - turned * cosine) / (2 * self.stiffness)


def moving_freely(kind: str, tau: "Node", Omega: "Node") -> "Node":
    """That in ẍ = f."""
    call, turned = tau.table.call, Omega * tau
    if kind in ("sin", "cos"):
        return (tau - call("sin", turned) / Omega) / Omega if kind == "sin" else (1 - call("cos", turned)) / Omega ** 2
    return {"place": tau.table.one, "impulse": tau, "step": tau ** 2 / 2, "ramp": tau ** 3 / 6}[kind]
