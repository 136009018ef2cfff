"""Masses, mass centres and moments of inertia by integrals over the shapes of a body, as the file gives these,

    ∫ σ (1, x, y, (x − x₀)² + (y − y₀)²) dA,        σ the density, or the mass over ∫ dA, negative of holes,

in numbers of any kind, over the nodes of a rule: Gauss's, with more of them the more digits there are. In products of
an array with a number of mpmath the array stands first: the other way round mpmath would write it out as a text.
"""

from collections.abc import Callable, Sequence
from functools import cache
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np
from mpmath.calculus.quadrature import GaussLegendre

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Record
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

GROWTH = 1.4        # of the digits
NODES = 0.7         # of Gauss's rule a digit
LINES = ("ring", "arch")
STRAIGHT = 2        # the degree of Gauss's rule along what polynomials of the third power are integrated over
Rule = Callable[[bool], tuple[np.ndarray, ...]]      # of what turns or not: nodes between −1 and 1, and weights


class ShapeInNumbers(NamedTuple):
    """at(*parameters), each within its reach (from, to, is it an angle?), gives (x, y, dA by these); of mass and
    density one or neither; sign: −1 of a hole."""

    reaches: Sequence[tuple[Any, Any, bool]]
    at: Callable[..., tuple[Any, Any, Any]]
    mass: Any
    density: Any
    sign: int

    def integrals(self, rule: Rule, about: tuple[Any, Any]) -> np.ndarray:
        """Mass, its moments by x and y, and moment of inertia about a place."""
        if self.mass is None and self.density is None:
            return np.zeros(4)
        weights, parameters = 1, []
        for axis, (low, high, turns) in enumerate(self.reaches):
            along = [-1 if k == axis else 1 for k in range(len(self.reaches))]
            nodes, shares = (part.reshape(along) for part in rule(turns))
            parameters.append(nodes * ((high - low) / 2) + (low + high) / 2)
            weights = shares * ((high - low) / 2) * weights
        x, y, area = self.at(*parameters)
        areas = weights * area
        found = [np.sum(areas * f) for f in (1, x, y, (x - about[0]) ** 2 + (y - about[1]) ** 2)]
        density = self.mass / found[0] if self.density is None else self.density
        return np.array([self.sign * density * part for part in found])


class BodyInNumbers:
    """A body as drawn, in the numbers of an arithmetic."""

    def __init__(self, problem: "Problem", name: str, arithmetic: Any) -> None:
        self.problem, self.arithmetic = problem, arithmetic
        self.record = problem.spec.get("bodies")[name]
        self.known = problem.numeric.values(arithmetic)
        self.shapes = [self._shape(part) for part in self.record.get("parts", [self.record])]

    def asked(self, tree: "QuantityRef", rule: Rule) -> Any:
        """mass[b], centre[b].x, J[b] or J[b, P]."""
        if tree.head == "mass":
            return self._integrals(rule)[0]
        if tree.head == "centre":
            return self._centre(rule)["xy".index(tree.component)]
        if "inertia" not in self.record and "gyration" not in self.record:
            return self._integrals(rule, self._about(tree, rule))[3]
        m = self._integrals(rule)[0]
        own = self._number("inertia") if "inertia" in self.record else m * self._number("gyration") ** 2
        if len(tree.indices) == 1 or not m:
            return own
        return own + m * sum((a - b) ** 2 for a, b in zip(self._centre(rule), self._about(tree, rule), strict=True))

    def _integrals(self, rule: Rule,
                   about: tuple[float | mpmath.mpf, float | mpmath.mpf] = (0, 0)) -> Any:
        return sum(shape.integrals(rule, about) for shape in self.shapes)

    def _centre(self,
                rule: Rule) -> tuple[float | mpmath.mpf, float | mpmath.mpf]:
        m, x, y, _ = self._integrals(rule)
        if not m:
            raise PhysicsError("no reference is found of where the centre of what has no mass is")
        return x / m, y / m

    def _about(self, tree: "QuantityRef",
               rule: Rule) -> tuple[float | mpmath.mpf, float | mpmath.mpf]:
        """The mass centre, or the place of a point or of the centre of another body."""
        if len(tree.indices) == 1:
            return self._centre(rule)
        place = tree.indices[1]
        if place in self.problem.scene.bodies:
            return BodyInNumbers(self.problem, place, self.arithmetic)._centre(rule)
        return self._pair(self.problem.spec.get("points")[place]["at"])

    def _shape(self, record: "Record") -> ShapeInNumbers:
        mass, density = (self._number(key, record) if key in record else None for key in ("mass", "density"))
        return ShapeInNumbers(*self._spread(record), mass, density, -1 if record.get("cut") else 1)

    def _spread(self, record: Any) -> tuple[list[Any], Callable[..., Any]]:
        """(reaches of the parameters, what they give)."""
        shape, functions = record.get("shape", "particle"), _functions(self.arithmetic)
        if shape == "rod":
            return self._rod(record)
        x, y = self._pair(record["at"]) if "at" in record else (self.arithmetic.number(0),) * 2
        angle = self._number("angle", record) if "angle" in record else self.arithmetic.number(0)
        cos, sin = functions.cos(angle), functions.sin(angle)

        def turned(u: Any, v: Any, area: Any) -> tuple[Any, Any, Any]:
            return u * cos - v * sin + x, u * sin + v * cos + y, area

        if shape == "particle":
            return [], lambda: (x, y, 1)
        if shape == "rectangle":
            halves = [self._number(key, record) / 2 for key in ("width", "height")]
            return [(-half, half, False) for half in halves], lambda u, v: turned(u, v, 1)
        a, b = (self._number(key if shape == "ellipse" else "radius", record) for key in "ab")
        half = self._number("half_angle", record) if "half_angle" in record else functions.pi
        if shape in LINES:
            return [(-half, half, True)], lambda phi: turned(functions.cos(phi) * a, functions.sin(phi) * a, a)
        return [(0 * a, a / a, False), (-half, half, True)], lambda r, phi: turned(
            r * functions.cos(phi) * a, r * functions.sin(phi) * b, r * (a * b))

    def _rod(self, record: "Record | None") -> tuple[list[Any], Callable[..., Any]]:
        (ax, ay), (bx, by) = self._pair(record["from"]), self._pair(record["to"])
        length = ((bx - ax) ** 2 + (by - ay) ** 2) ** (self.arithmetic.number(1) / 2)
        return [(0 * length, length / length, False)], lambda s: (s * (bx - ax) + ax, s * (by - ay) + ay, length)

    def _number(self, key: str, record: "Record | None" = None) -> Any:
        return self._numbers([(record or self.record)[key]])[0]

    def _pair(self, expressions: "list[Expression]") -> tuple[Any, ...]:
        return tuple(self._numbers(expressions))

    def _numbers(self, expressions: "Sequence[Expression]") -> list[float | mpmath.mpf]:
        scene = self.problem.scene
        nodes = scene.at_drawn(*map(scene.lower, expressions))
        return evaluate(nodes, self.arithmetic, self.known)


def _functions(arithmetic: Any) -> Any:
    """cos, sin and π for arrays of its numbers."""
    if arithmetic is Floats:
        return np
    return SimpleNamespace(pi=+mpmath.pi, **{name: np.frompyfunc(getattr(mpmath, name), 1, 1)
                                             for name in ("cos", "sin")})


def gauss(turns: bool) -> tuple[np.ndarray, ...]:
    """Gauss's rule at the working precision, over angles for functions of a whole turn."""
    degree = STRAIGHT
    while turns and 3 * 2 ** (degree - 1) < NODES * mpmath.mp.dps:
        degree += 1
    return _nodes(degree, mpmath.mp.prec)


@cache
def _nodes(degree: int, precision: int) -> tuple[np.ndarray, ...]:
    found = GaussLegendre(mpmath.mp).get_nodes(-1, 1, degree, precision)
    return tuple(np.array(column, dtype=object) for column in zip(*found, strict=True))


def true_moment(problem: "Problem", tree: "QuantityRef", size: float) -> TrueValues:
    """What is asked of a body, digits counting from a size on where it is smaller."""
    def found() -> "tuple[list[mpmath.mpf], float | mpmath.mpf]":
        value = BodyInNumbers(problem, tree.indices[0], multiprecision()).asked(tree, gauss)
        nothing = abs(value) <= size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
        return [mpmath.mpf(0) if nothing else value], max(size, abs(value))

    return settled(found, growth=GROWTH, sized=True)
