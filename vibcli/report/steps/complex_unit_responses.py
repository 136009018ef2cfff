"""What a unit of each kind of load that begins at τ = 0 brings about in ż − λz = f from z = 0,  λ = −δ + iω:

    impulse   e^{λτ}
    step      (e^{λτ} − 1)/λ
    ramp      (e^{λτ} − 1 − λτ)/λ²
    sin Ωτ    (Ω e^{λτ} − λ sin Ωτ − Ω cos Ωτ)/(λ² + Ω²)
    cos Ωτ    (λ e^{λτ} − λ cos Ωτ + Ω sin Ωτ)/(λ² + Ω²),

the particular part and, as they cancel at τ = 0, its constant times e^{λτ}; of λ = 0 what it adds up to by then."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.steps.complex_nodes import ComplexNode

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

WAVES = "sin", "cos"

class ComplexUnitResponses(NamedTuple):
    """The letters δ, ω, τ, and Ω, which is zero where no load swings; ω is of a mode that does not, both of λ = 0."""

    delta: "Node"
    omega: "Node"
    tau: "Node"
    Omega: "Node"

    @property
    def drifts(self) -> bool:
        """Is λ zero?"""
        return self.delta.is_zero and self.omega.is_zero

    def added_up(self, kind: str) -> "Node":
        """The integral of a unit of a kind from 0 to τ."""
        tau, Omega, call = self.tau, self.Omega, self.tau.table.call
        if kind in WAVES:
            return (1 - call("cos", Omega * tau)) / Omega if kind == "sin" else call("sin", Omega * tau) / Omega
        return {"impulse": tau.table.one, "step": tau, "ramp": tau ** 2 / 2}[kind]

    def of(self, kind: str) -> ComplexNode:
        """That to a unit of a kind."""
        tau, root = self.tau, ComplexNode(-self.delta, self.omega)
        table, turned = tau.table, self.omega * tau
        decay = table.call("exp", -(self.delta * tau))
        free = ComplexNode(decay * table.call("cos", turned), decay * table.call("sin", turned))
        if kind == "impulse":
            return free
        if self.drifts:
            return ComplexNode(self.added_up(kind), table.zero)
        if kind in ("step", "ramp"):
            step = free.plus(-table.one).over(root)
            return step if kind == "step" else step.plus(-tau).over(root)
        along, Omega = ComplexNode(self.Omega, table.zero), self.Omega
        sine, cosine = table.call("sin", Omega * tau), table.call("cos", Omega * tau)
        one, other = (along, root) if kind == "sin" else (root, ComplexNode(-Omega, table.zero))
        begun, swings = one.times(free.plus(-cosine)), other.times(ComplexNode(-sine, table.zero))
        return ComplexNode(begun.real + swings.real, begun.imaginary + swings.imaginary).over(
            root.times(root).plus(Omega ** 2))


def particular_and_constant(kind: str, root: "Node", tau: "Node", Omega: "Node") -> "tuple[Node, Node]":
    """(the particular part, the constant of e^{λτ}) of the same by the letter of λ; of an impulse 0 and 1."""
    table, turned = root.table, Omega * tau
    if kind in ("step", "ramp"):
        return (-1 / root, 1 / root) if kind == "step" else (-(1 + root * tau) / root ** 2, 1 / root ** 2)
    if kind == "impulse":
        return table.zero, table.one
    below, sine, cosine = root ** 2 + Omega ** 2, table.call("sin", turned), table.call("cos", turned)
    return (-(root * sine + Omega * cosine) / below, Omega / below) if kind == "sin" else (
        (Omega * sine - root * cosine) / below, root / below)
