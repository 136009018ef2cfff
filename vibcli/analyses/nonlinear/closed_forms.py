"""The frequency of one degree of freedom at any amplitude A in closed form; T₀ is constant, V = 0 in equilibrium:

    pendulum     V = V₀ (1 − cos nξ)        ω = π n √(V₀/2T₀) / 2K(m)         m = sin²(nA/2)
    Duffing      V = V₂ξ² + V₄ξ⁴            ω = π √((V₂ + 2V₄A²)/T₀) / 2K(m)   m = V₄A²/(V₂ + 2V₄A²)
    pure power   V = c |ξ|ᵖ                 ω = √(V(A)/T₀)/A · √π Γ(½ + 1/p) / 2Γ(1 + 1/p)

K(m) = ∫₀^½π dθ/√(1 − m sin²θ), the complete elliptic integral of the first kind (Kovacic and Brennan 2011, 2 and 4).
"""

from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.errors import Kinked
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import effective_potential, kinetic
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node

HALF = Fraction(1, 2)


class ByEllipticIntegral(NamedTuple):
    """ω = ½π · rate / K(m), of motions with this energy above that of the equilibrium."""

    rate: "Node"
    m: "Node"
    energy: "Node"


class ByGamma(NamedTuple):
    """ω = rate · √π Γ(½ + 1/p) / (2 Γ(1 + 1/p)), of motions with this energy."""

    rate: "Node"
    p: "Node"
    energy: "Node"


def closed_form(symbolic: "SymbolicSystem", A: "Node") -> ByEllipticIntegral | ByGamma | None:
    """That of a scene whose equilibrium is known in letters, A being the amplitude; None of other ones."""
    scene = symbolic.scene.resting
    (q,), (v,), table = scene.q, scene.v, scene.table
    place = _place(symbolic, q)
    V, T = (substitute([node], {q: place + q})[0] for node in (effective_potential(scene), kinetic(scene)))
    T0 = textbook(gradient(gradient(T)[v])[v] / 2)
    if T0.mask & (q.mask | v.mask):
        return None
    V = V - substitute([V], {q: table.zero})[0]
    try:
        if _falls(V, q, A):
            return None
        found = next(filter(None, (form(V, T0, q, A) for form in (_power, _duffing, _pendulum))), None)
    except ZeroDivisionError:       # a slope of V is infinite in the equilibrium
        return None
    return None if found is None else found._replace(energy=textbook(found.energy))


def _falls(V: "Node", q: "Node", A: "Node") -> bool:
    """Does V fall from 0?"""
    table = V.table
    if table.is_positive(textbook(-_at(V, q, A))):
        return True
    try:
        return table.is_positive(textbook(-_at(_derivative(V, q, 2), q, table.zero)))
    except ZeroDivisionError:       # its slope has no bound there, and it rises to A
        return False


def _place(symbolic: "SymbolicSystem", q: "Node") -> "Node":
    """The equilibrium; where V has a kink there, as drawn: what is a pure power of the deviation rests there."""
    try:
        return symbolic.equilibrium_position[q.name]
    except Kinked:
        return symbolic.scene.resting.drawn_position.get(q, q.table.zero)


def _duffing(V: "Node", T0: "Node", q: "Node", A: "Node") -> ByEllipticIntegral | None:
    V2, V4 = (textbook(_at(_derivative(V, q, n), q, V.table.zero) / of) for n, of in ((2, 2), (4, 24)))
    if V4.is_zero or not is_zero(V - V2 * q**2 - V4 * q**4):
        return None
    hard = textbook(2 * V2 + 4 * V4 * A**2)
    return ByEllipticIntegral((hard / (2 * T0)) ** HALF, 2 * V4 * A**2 / hard, _at(V, q, A))


def _pendulum(V: "Node", T0: "Node", q: "Node", A: "Node") -> ByEllipticIntegral | None:
    table = V.table
    stiffness, fourth = (_at(_derivative(V, q, n), q, table.zero) for n in (2, 4))
    if is_zero(stiffness) or is_zero(fourth):
        return None
    n = textbook(textbook(-fourth / stiffness) ** HALF)
    if not is_zero(V - stiffness / n**2 * (1 - table.call("cos", n * q))):
        return None
    return ByEllipticIntegral((stiffness / (2 * T0)) ** HALF, table.call("sin", n * A / 2) ** 2, _at(V, q, A))


def _power(V: "Node", T0: "Node", q: "Node", A: "Node") -> ByGamma | None:
    right, left, slope = (_at(node, q, place) for node, place in ((V, A), (V, -A), (_derivative(V, q, 1), A)))
    p = textbook(A * _at(slope, V.table.call("sign", A), V.table.number(1)) / right)
    if A in reachable([p]) or is_zero(p - 2) or not is_zero(right - left):
        return None
    return ByGamma((right / T0) ** HALF / A, p, right)


def _derivative(V: "Node", q: "Node", order: int) -> "Node":
    for _ in range(order):
        V = gradient(V).get(q, V.table.zero)
    return V


def _at(node: "Node", q: "Node", place: "Node") -> "Node":
    return substitute([node], {q: place})[0]
