"""Powers of two that bring the data of an oscillator near one, so that no choice of units changes a digit.

With q = D q̂, D = diag(2^p), M = 2^m D⁻¹ M̂ D⁻¹ and K = 2^k D⁻¹ K̂ D⁻¹ where k − m is even, every number of
the scaled problem keeps its bits when masses, lengths or times are counted in units 2^j times as large,
and λ = 2^((k − m)/2) λ̂ is exact.
"""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, Where

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath


def exponent(x: "float | Fraction | mpmath.mpf") -> int:
    """e with 2^(e-1) <= |x| < 2^(e+1), for a float, an mpf or a Fraction that is not zero."""
    if hasattr(x, "_mpf_"):
        found: int = x._mpf_[2] + x._mpf_[3]
        return found
    if hasattr(x, "numerator") and not isinstance(x, float):
        result: int = abs(x.numerator).bit_length() - x.denominator.bit_length() + 1
        return result
    return math.frexp(x)[1]


class Scaling:
    """coordinates: the p of q = 2^p q̂; mass, stiffness: m and k above; time: (k − m)/2, so λ = 2^time λ̂."""

    __slots__ = ("coordinates", "mass", "stiffness", "time")

    def __init__(self, coordinates: Sequence[int], mass: int, stiffness: int) -> None:
        self.coordinates, self.mass, self.stiffness = coordinates, mass, stiffness
        self.time = (stiffness - mass) // 2

    @property
    def damping(self) -> int:
        """The power c of C = 2^c D⁻¹ Ĉ D⁻¹, so that λ̂² M̂ + λ̂ Ĉ + K̂ is the scaled pencil."""
        return self.mass + self.time


def scaling(elements: Any) -> Scaling:
    """The Scaling read off the largest terms of the diagonals of M and K."""
    check_finite(elements)
    inertia = _diagonal_exponents(elements.inertias, elements.M)
    stiffness = _diagonal_exponents(elements.springs, elements.K)
    massless = set(elements.massless)
    for i in range(elements.n):
        if i not in inertia and i not in massless:
            raise unmoved(i)
    mass = next((inertia[i] for i in range(elements.n) if i in inertia), 0)
    moved = [i in inertia and i not in massless for i in range(elements.n)]
    p = [-((inertia[i] - mass) // 2) if moved[i] else None for i in range(elements.n)]
    held = [stiffness[i] + 2 * p[i] for i in stiffness if p[i] is not None]
    held += [exponent(x) + p[i] + p[j] for (i, j), x in elements.K.items()
             if x and p[i] is not None and p[j] is not None]
    k = max(held, default=max(stiffness.values(), default=mass))
    k += (k - mass) % 2
    damping = _diagonal_exponents(elements.dampers, elements.C)
    for i in massless:
        if i in stiffness:
            p[i] = -((stiffness[i] - k) // 2)
        elif i in damping:
            p[i] = -((damping[i] - (k + mass) // 2) // 2)
        else:
            p[i] = 0
    return Scaling(p, mass, k)


def _diagonal_exponents(terms: tuple[tuple[float, dict[int, float]], ...],
                        matrix: Mapping[tuple[int, int], float]) -> dict[int, int]:
    """For each coordinate the exponent of its largest diagonal term Σ w sᵢ²."""
    found = [(i, exponent(weight) + 2 * exponent(x)) for weight, row in terms if weight for i, x in row.items() if x]
    found += [(i, exponent(value)) for (i, j), value in matrix.items() if i == j and value]
    largest = {}
    for i, e in found:
        largest[i] = max(e, largest.get(i, e))
    return largest


def check_finite(elements: Any) -> None:
    """Refuses what is not a finite real number, with the name of the property."""
    named = (("inertia", elements.inertias, elements.M), ("stiffness", elements.springs, elements.K),
             ("damping", elements.dampers, elements.C), ("gyroscopic coupling", (), elements.G))
    for name, terms, matrix in named:
        if not all(_finite(value) for weight, row in terms for value in (weight, *row.values())):
            raise PhysicsError(f"the {name} is not a finite number at this equilibrium",
                               hint="look for a length, an angle or a law that is singular there")
        for (i, j), value in matrix.items():
            if not _finite(value):
                raise PhysicsError(f"the {name} between coordinates {i + 1} and {j + 1} is not finite",
                                   hint="look for a length, an angle or a law that is singular there")


def _finite(x: float) -> bool:
    if isinstance(x, (float, int)):
        return math.isfinite(x)
    if hasattr(x, "_mpf_"):
        return bool(x._mpf_[1]) or not x._mpf_[2]
    return hasattr(x, "numerator") or math.isfinite(x)


MECHANISM = "{} has no inertia and no spring ties it: it is a mechanism"


class UnheldCoordinate(PhysicsError):
    """The refusal of a coordinate by its number; who knows its name tells it by that."""

    def __init__(self, message: str, hint: str, number: int, name: str | None = None,
                 where: Where | None = None) -> None:
        super().__init__(message.format(name or f"coordinate {number + 1}"), hint, where)
        self.text, self.number = message, number

    def named(self, name: str, where: Where, turns: bool = False, member: str | None = None) -> "UnheldCoordinate":
        """The same with the name of the coordinate, and where it is declared; turns: is it an angle? member: on which
        it is a motion."""
        hint = self.hint
        if self.text == MECHANISM and member is not None:
            hint = f"give '{member}' inertia along its length, attach some, or hold it"
        elif self.text == MECHANISM and turns:
            hint = "give it an inertia, tie it with a torsion spring, or take it out"
        return UnheldCoordinate(self.text, hint, self.number, f"'{name}'", where)


def unmoved(i: int) -> UnheldCoordinate:
    """The refusal of a coordinate, or a combination led by it, which no inertia moves."""
    return UnheldCoordinate("no positive inertia moves with {}", "give what it moves a mass or inertia", i)


def mechanism(i: int) -> UnheldCoordinate:
    """The refusal of a massless coordinate which nothing ties."""
    return UnheldCoordinate(MECHANISM, "give it a mass, tie it with a spring, or take it out", i)
