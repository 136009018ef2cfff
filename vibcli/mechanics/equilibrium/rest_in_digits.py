"""Where linear forces balance, K q = f, in more digits than floats have: of stiffnesses so different, as of places next
to each other on a beam, that floats do not tell what holds a motion from what nothing holds."""

from typing import TYPE_CHECKING

from vibcli.mechanics.nonsmooth import KINKED
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.numeric_linearisation import Numbers
    from vibcli.mechanics.numeric_system import NumericSystem

DIGITS, HELD = 80, 1e-35        # what is left of a stiffness, as a part, when all else gives way: less is none


def rest_in_digits(numeric: "NumericSystem", held: bool = True) -> dict[str, float] | None:
    """{coordinate: float} where all forces vanish; None of what is not linear, where they do so at no place or at many,
    and where not every motion is held, if it is to be."""
    scene = numeric.scene
    if not numeric.system.is_linear or scene.table.called.intersection(KINKED) or scene.resting.loops is not None:
        return None
    import mpmath

    names = scene.coordinates
    with mpmath.workdps(DIGITS):
        values = numeric.values(multiprecision())
        start = {name: mpmath.mpf(x) for name, x in numeric.start().items()}
        numbers = in_numbers(numeric.system.statics, multiprecision(), values | start)
        moved = (_solved if held else _balanced)(_matrix(numbers), [-force for force in numbers.residual])
        if moved is None:
            return None
        place = start | {name: start[name] + q for name, q in zip(names, moved, strict=True)}
        there = in_numbers(numeric.system.statics, multiprecision(), values | place)
        if max(map(abs, there.residual)) > HELD * max(numbers.residual_size):
            return None
        return {name: float(x) for name, x in place.items()}


def holds(numbers: "Numbers") -> bool:
    """Is K positive, at the working precision? It is that of a place from which all ways lead up."""
    return _solved(_matrix(numbers), [0] * len(numbers.residual)) is not None


def _matrix(numbers: "Numbers") -> "mpmath.matrix":
    """K."""
    import mpmath

    entries, n = numbers.elements.stiffness(), len(numbers.residual)
    return mpmath.matrix([[entries.get((i, j), 0) for j in range(n)] for i in range(n)])


def _balanced(K: "mpmath.matrix", force: "list[mpmath.mpf]") -> "list[mpmath.mpf] | None":
    """K⁻¹ f; None where K is singular."""
    import mpmath

    try:
        moved = list(mpmath.lu_solve(K, mpmath.matrix(force)))
    except ZeroDivisionError:
        return None
    largest = max(abs(K[i, j] * q) for i in range(len(force)) for j, q in enumerate(moved))
    return None if HELD * largest > max(map(abs, force)) else moved


def _solved(K: "mpmath.matrix", force: "list[mpmath.mpf]") -> "list[mpmath.mpf] | None":
    """K⁻¹ f by elimination; None where K is not positive."""
    n, own = len(force), [K[i, i] for i in range(len(force))]
    for k in range(n):
        if not K[k, k] > HELD * own[k]:
            return None
        for i in range(k + 1, n):
            share = K[i, k] / K[k, k]
            for j in range(k, n if share else k):
                K[i, j] -= share * K[k, j]
            force[i] -= share * force[k]
    for k in reversed(range(n)):
        force[k] = (force[k] - sum(K[k, j] * force[j] for j in range(k + 1, n))) / K[k, k]
    return force
