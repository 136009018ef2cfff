"""What estimates by assumed shapes are made of: combinations that are orthonormal, and when they are bounds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    import mpmath

    from vibcli.base.errors import Where
    from vibcli.language.reader import Expression
    from vibcli.mechanics.factored_system import FactoredSystem

NOTHING, FAR = 1e-30, 10**30       # of numbers with 60 digits: what cancels leaves 30 of them


class RitzEstimates(NamedTuple):
    """shapes: the columns of Φ; M, K: M̂ and K̂ as rows; modes: the estimates by ascending ω̃²."""

    shapes: list[list[Any]]
    M: list[list[Any]]
    K: list[list[Any]]
    modes: "list[RitzMode]"


class RitzMode(NamedTuple):
    """square: ω̃²; omega: ω̃ [rad/s], None where ω̃² < 0; shape: Φc with cᵀM̂c = 1; exact: the ω that it is a bound of,
    None of an unstable mode; weights: c, in scenes with members."""

    index: int  # type: ignore[assignment]
    square: float
    omega: float | None
    shape: list[Any]
    exact: float | None
    weights: list[Any] | None = None


def require_bounds(elements: "FactoredSystem", M: Any, K: Any) -> None:
    """Refuse matrices for which the minimax principle does not hold: K + sM of a great s is positive definite where K
    is on what has no inertia (Finsler)."""
    import mpmath

    if any(elements.G.values()):
        raise PhysicsError("Ritz estimates need a system without gyroscopic terms: they are bounds of M and K alone",
                           "see `vibcli frequencies` for the modes themselves")
    if elements.circulatory:
        raise PhysicsError("Ritz estimates need a symmetric stiffness matrix: without one they are no bounds",
                           "see `vibcli frequencies` for the modes themselves")
    n = M.rows
    inertia = [abs(M[i, i]) for i in range(n) if M[i, i]]
    stiffness = max(abs(K[i, j]) for i in range(n) for j in range(n))
    try:
        mpmath.cholesky(K + M * (FAR * (stiffness or 1) / min(inertia)))
    except ValueError:
        raise PhysicsError("Ritz estimates need a stable stiffness along what has no inertia: without it they are no "
                           "bounds", "see `vibcli frequencies` for the modes themselves") from None


def amplitude_of(modal: Any, name: str, expression: "Expression") -> tuple[int, Any]:
    """(index, amplitude) of a coordinate in a shape as it is written."""
    from vibcli.symbolic.evaluation import evaluate, multiprecision

    names, arithmetic = modal.scene.coordinates, multiprecision()
    if "." in name:
        raise PhysicsError(f"'{name.partition('.')[0]}' has no inertia: it deflects as at rest, not as assumed",
                           "leave it out, or give it its inertia per length", expression.where)
    if name not in names:
        raise PhysicsError(f"the coordinate '{name}' follows from the others: shapes are those of the others",
                           "leave it out; shapes are made of " + ", ".join(names), expression.where)
    try:
        amplitude, = evaluate([modal.scene.lower(expression)], arithmetic, modal.numeric.values(arithmetic))
    except ZeroDivisionError:
        amplitude = None
    if amplitude is None or not _is_real(amplitude):
        raise PhysicsError(f"the amplitude of '{name}' is no real number", "give a number", expression.where)
    return list(names).index(name), amplitude


def _is_real(value: "mpmath.mpf") -> bool:
    import mpmath

    return mpmath.isfinite(value) and not mpmath.im(value)


def orthonormal(shapes: "Sequence[list[mpmath.mpf]]", M: Any, places: "Sequence[Where]") -> "list[list[mpmath.mpf]]":
    """Combinations of the shapes with qᵢᵀMqⱼ = δᵢⱼ, one after the other; PhysicsError where there are fewer."""
    import mpmath

    found = []
    for number, (shape, place) in enumerate(zip(shapes, places, strict=True), 1):
        rest, whole = shape, product_of(M, shape, shape, abs)
        for other in found * 2:
            share = product_of(M, other, rest)
            rest = [x - share * y for x, y in zip(rest, other, strict=True)]
        left = product_of(M, rest, rest)
        if left <= NOTHING * whole:
            raise _dependent(number, shape, rest, place)
        found.append([x / mpmath.sqrt(left) for x in rest])
    return found


def _dependent(number: int, shape: "list[mpmath.mpf]", rest: "list[mpmath.mpf]", place: "Where") -> PhysicsError:
    """Why a shape adds no motion with inertia to those before it, of which `rest` is left."""
    if not any(shape):
        return PhysicsError(f"shape {number} is zero: nothing moves in it", "give an amplitude that is not zero", place)
    if all(abs(x) <= NOTHING * max(map(abs, shape)) for x in rest):
        return PhysicsError(f"shape {number} is a combination of those before it", "leave it out", place)
    before = " but for a combination of those before it" if number > 1 else ""
    return PhysicsError(f"nothing that has inertia moves in shape {number}{before}",
                        "let a coordinate with inertia move", place)


def product_of(matrix: Any, a: Any, b: Any, of: Any = lambda x: x) -> Any:
    """aᵀ matrix b; `of` abs: the sum of the sizes of its terms."""
    return sum(of(x * matrix[i, j] * y) for i, x in enumerate(a) if x for j, y in enumerate(b) if y)
