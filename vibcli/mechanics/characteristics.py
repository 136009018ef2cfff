"""The law of a spring or damper as it stands in the scene: F(D), D being its deflection, of a damper the rate of that,
and the coefficients of F = Σ aₙ Dⁿ (Kovacić & Radomirović 2018, 9.3)."""

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.scene.laws import Law
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import evaluable, reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.truncated_polynomials import NodeArithmetic, NoDerivative, Polynomials, sign

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class ForceLaw(NamedTuple):
    """The force of the element `owner` as a function of the symbol x."""

    owner: str
    force: Any
    x: Any

    def at(self, arithmetic: Any, values: "Mapping[str, Any]", D: Any) -> Any:
        """F(D) in the numbers of an arithmetic."""
        return evaluate([self.force], arithmetic, {**values, self.x.name: D})[0]

    def in_letters(self, D: "Node") -> "Node":
        """F(D), of a linear spring in series with a cubic one by Cardano's formula."""
        from vibcli.symbolic.cubic_in_series import in_closed_form

        closed = in_closed_form(self.force)
        return substitute([closed if closed is not self.force else textbook(closed)], {self.x: D})[0]

    def coefficient(self, n: int, arithmetic: Any, values: "Mapping[str, Any]", side: Any = sign) -> Any:
        """aₙ in the numbers of an arithmetic; PhysicsError where there is no series."""
        ring = Polynomials(arithmetic, 1, lambda powers: powers[0] <= n, n, side)
        inner = {name: ring.still(value) for name, value in values.items()}
        inner[self.x.name] = ring.variable(0, arithmetic.number(Fraction(0)))
        try:
            found = evaluate([self.force], ring, inner)[0]
        except NoDerivative as cause:
            raise self._without_series(cause.name) from None
        except ZeroDivisionError:
            raise self._without_series("power") from None
        zero = arithmetic.number(Fraction(0))
        c = found.terms.get((n,), zero)
        return zero if ring.side(c) == 0 else c

    def _without_series(self, name: str) -> PhysicsError:
        """The refusal, with the function that keeps it from having one."""
        what = "grows like a broken power of its deflection" if name == "power" else (
            f"has a {'jump' if name in ('sign', 'step') else 'kink'} of {name} there")
        return PhysicsError(f"the law of '{self.owner}' has no series about zero deflection: it {what}",
                            f"ask for its force, as in law[{self.owner}](0.1 m)")

    def coefficient_in_letters(self, n: int) -> "Node":
        """aₙ in letters."""
        from vibcli.mechanics.expansion import side_in_letters

        table = self.force.table
        values = {node.name: node for node in evaluable([self.force]) if node.op == "symbol"}
        return textbook(self.coefficient(n, NodeArithmetic(table, list(Floats.functions)), values, side_in_letters))


def characteristic(scene: "Scene", name: str) -> ForceLaw:
    """That of a spring or damper; PhysicsError of one whose force is not a function of its deflection alone."""
    terms = scene.terms_of(name)
    x = scene.table.variable("the deflection")
    found = _of(terms[0], x)
    if any(part.op == "symbol" and part.mask and part is not found.x for part in reachable([found.force])):
        raise PhysicsError(f"the force of '{name}' hangs on more than its own "
                           + ("rate" if terms[0] in scene.dampers or getattr(terms[0], "damper", False)
                              else "deflection"), f"ask for {name}.force")
    return found


def _of(term: Law, x: "Node") -> ForceLaw:
    return ForceLaw(term.owner, term.derivative, term.x) if isinstance(term, Law) else ForceLaw(
        term.owner, term.weight * x, x)
