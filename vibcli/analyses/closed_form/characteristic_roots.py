"""The roots λ of a factor of the characteristic polynomial as expressions, and of what is rational in λ.

Degree one: a quotient. Degree two: (B ∓ S√D)/A. Higher: s + t·2cos(jπ/N) where the polynomial is one of those
(cosines.py), else unsolved.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.algebraic_extension import Extension, unless_long
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.radicals import positive, root
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.surds import Pair

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.toeplitz_chains import Cosine
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.rational_functions import Quotients


class Simple:
    """λ = −p₀/p₁."""

    pair = None

    def __init__(self, quotients: "Quotients", modulus: Sequence[Any]) -> None:
        self.quotients, self.square = quotients, quotients.node(-modulus[0] / modulus[1])

    def value(self, element: Sequence[Any]) -> "Node":
        """u₀ as an expression."""
        return self.quotients.node(element[0]) if element else self.quotients.table.zero

    def omega(self, samples: Sequence[dict[str, float]], sign: int = 1) -> "Node":
        """√(±λ)."""
        return root(sign * self.square, samples)


class Surd:
    """One of the two roots of p₂λ² + p₁λ + p₀."""

    def __init__(self, pair: Pair, sign: int) -> None:
        self.pair, self.sign = pair, sign
        self.front, self.rest = pair.written(pair.rational, pair.factor * sign)
        self.square = self.front * self.rest

    def value(self, element: Sequence[Any]) -> "Node":
        """u₀ + u₁λ as an expression."""
        u, v = (list(element) + [self.pair.quotients.field(0)] * 2)[:2]
        front, rest = self.pair.written(u + v * self.pair.rational, v * self.pair.factor * self.sign)
        return front * rest

    def omega(self, samples: Sequence[dict[str, float]], sign: int = 1) -> "Node":
        """√(±λ)."""
        return root(self.front, samples) * (sign * self.rest) ** HALF


class Turning:
    """ω itself a root of a quadratic equation, as of gyroscopic systems: ω = |rational ± factor·√D|."""

    pair = None

    def __init__(self, pair: Pair, modulus: Sequence[Any], sign: int) -> None:
        self.parts, self.modulus = pair, modulus
        front, rest = pair.written(pair.rational, pair.factor * sign)
        self.sign = 1 if evaluate([front * rest], Floats, pair.sample)[0] > 0 else -1
        self.frequency = front * (self.sign * rest)
        self.square = self.frequency * self.frequency

    def ratio(self, above: str, below: Any) -> "Node | None":
        """Σ aᵢωⁱ/Σ bᵢωⁱ of nodes where it does not depend on ω, else None."""
        quotients = self.parts.quotients
        field = Extension(quotients.field, self.modulus)
        a, b = ([quotients(node) * self.sign ** i for i, node in enumerate(nodes)] for nodes in (above, below))
        found = unless_long(field.quotient, a, b)
        result: Node | None = quotients.node(found[0]) if found is not None and len(found) == 1 else None
        return result

    def omega(self, samples: Sequence[dict[str, float]], sign: int = 1) -> "Node":
        return positive(self.frequency, samples)


def solutions(quotients: "Quotients", modulus: Sequence[Any], sample: Mapping[str, float],
              turns: bool = False) -> "Sequence[Simple | Surd | Turning | Cosine] | None":
    """The roots of a factor with these coefficients, from the lowest; None where they are not solved. `turns`: try ω
    before ω²."""
    if len(modulus) == 2:
        return [Simple(quotients, modulus)]
    if len(modulus) == 3:
        if turns and (found := _turning(quotients, modulus, sample)):
            return found
        pair = Pair(quotients, modulus, sample)
        return [Surd(pair, sign) for sign in (-1, 1)]
    from vibcli.analyses.closed_form.toeplitz_chains import cosines

    return cosines(quotients, modulus)


def _turning(quotients: "Quotients", modulus: Sequence[Any], sample: Mapping[str, float]) -> list[Turning] | None:
    """The roots of p(ω²) where it falls into two quadratic factors q(ω)·q(−ω), else None."""
    unknown = quotients.unknown.numer
    whole = sum((c.numer * unknown ** (2 * i) for i, c in enumerate(modulus)), quotients.ring(0))
    factors = [factor for factor, _ in quotients.factors(whole)[1] if factor.degree(unknown)]
    if len(factors) != 2 or factors[0].degree(unknown) != 2:
        return None
    modulus = quotients.coefficients(factors[0])
    pair = Pair(quotients, modulus, sample)
    return [Turning(pair, modulus, sign) for sign in (-1, 1)]
