"""Upper bounds of the lowest natural frequencies by assumed shapes (Rayleigh 1877, Ritz 1909).

    q = Φ c     M̂ = ΦᵀMΦ, K̂ = ΦᵀKΦ     K̂ c = ω̃² M̂ c     the columns of Φ are the assumed shapes

Shapes constrain the motion, and constraints lower no frequency: ω̃ᵢ² ≥ ωᵢ² (minimax principle of Courant and Fischer),
where M and K are symmetric and what has no inertia is held. One shape gives Rayleigh's quotient φᵀKφ/φᵀMφ.
"""

from typing import Any, NamedTuple

from vibcli.base.errors import PhysicsError
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity
from vibcli.language.sections.equilibrium import ByCoordinate

NOTHING, FAR = 1e-30, 10**30       # of numbers with 60 digits: what cancels leaves 30 of them

ELEMENT = Element(
    "Ritz estimate",
    "Upper bounds of the lowest natural frequencies: the scene is to move in combinations of the assumed shapes alone "
    "(Rayleigh and Ritz), its dampers left out. k shapes give k bounds, each beside the exact frequency, and the "
    "combination of the shapes that belongs to it; one shape gives Rayleigh's quotient.",
    {
        "shapes": Field(Many(ByCoordinate(Quantity(), "a shape {coordinate: amplitude}, such as {x1: 1, x2: 2}",
                                          scaled=True), 1, 20, "a list of shapes"),
                        "displacements of coordinates, of any size; those left out rest. With units where lengths and "
                        "angles are in one shape: {x: 1 m, phi: 0.5 rad}", required=True),
    },
    example="shear_frame_by_ritz",
)


class RitzEstimates(NamedTuple):
    """shapes: the columns of Φ; M, K: M̂ and K̂ as rows; modes: the estimates by ascending ω̃²."""

    shapes: list
    M: list
    K: list
    modes: list


class RitzMode(NamedTuple):
    """square: ω̃²; omega: ω̃ [rad/s], None where ω̃² < 0; shape: Φc with cᵀM̂c = 1; exact: the ω that it is a bound of,
    None of an unstable mode."""

    index: int  # type: ignore[assignment]
    square: float
    omega: float | None
    shape: list
    exact: float | None


def ritz(modal: Any, asked: Any):
    """The RitzEstimates of a system; PhysicsError where its shapes or its matrices give no bounds."""
    import mpmath

    from vibcli.analyses.modal.estimates import matrix_of
    from vibcli.analyses.modal.modes_precise import WORKING

    if asked is None:
        raise PhysicsError("no shapes are assumed for the Ritz estimates",
                           "ask with find: [{ritz: {shapes: [{" + modal.scene.coordinates[0] + ": 1}]}}]")
    natural = modal.sharp_modes         # refused where there are none, or too many coordinates
    with mpmath.workdps(WORKING):
        elements = modal.configuration.precise_system(WORKING)
        M, _, _, K = (matrix_of(entries, elements.n) for entries in elements.matrices())
        _require_bounds(modal.configuration.linear_system, M, K)
        shapes = [_shape(modal, shape) for shape in asked["shapes"]]
        basis = _orthonormal(shapes, M, [_place(shape, asked) for shape in asked["shapes"]])
        squares, mixed = mpmath.eigsy(mpmath.matrix([[_form(K, a, b) for b in basis] for a in basis]))
        modes, least = [], mpmath.mpf(10) ** (5 - WORKING) * max(map(abs, squares))     # that eigsy tells from zero
        for i, (square, exact) in enumerate(zip(squares, natural, strict=False)):
            shape = _combined(basis, mixed[:, i])
            if abs(square) <= max(least, NOTHING * _form(K, shape, shape, abs)):
                square = mpmath.mpf(0)
            modes.append(RitzMode(i + 1, float(square), float(mpmath.sqrt(square)) if square >= 0 else None,
                                  _floats(shape), None if exact.omega is None else float(exact.omega)))
        return RitzEstimates([_floats(shape) for shape in shapes], *(
            [_floats(_form(matrix, a, b) for b in shapes) for a in shapes] for matrix in (M, K)), modes)


def _require_bounds(elements, M, K):
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


def _shape(modal, written):
    """A shape that is written as numbers, one a coordinate."""
    from vibcli.symbolic.evaluation import evaluate, multiprecision

    names, arithmetic = modal.scene.coordinates, multiprecision()
    values = modal.numeric.values(arithmetic)
    found = dict.fromkeys(names, 0)
    for name, expression in written.items():
        if name not in found:
            raise PhysicsError(f"the coordinate '{name}' follows from the others: shapes are those of the others",
                               "leave it out; shapes are made of " + ", ".join(names), expression.where)
        try:
            amplitude, = evaluate([modal.scene.lower(expression)], arithmetic, values)
        except ZeroDivisionError:
            amplitude = None
        if amplitude is None or not _is_real(amplitude):
            raise PhysicsError(f"the amplitude of '{name}' is no real number", "give a number", expression.where)
        found[name] = amplitude
    return list(found.values())


def _is_real(value):
    import mpmath

    return mpmath.isfinite(value) and not mpmath.im(value)


def _place(written, asked):
    return next((expression.where for expression in written.values()), asked.where)


def _orthonormal(shapes, M, places):
    """Combinations of the shapes with qᵢᵀMqⱼ = δᵢⱼ, one after the other; PhysicsError where there are fewer."""
    import mpmath

    found = []
    for number, (shape, place) in enumerate(zip(shapes, places, strict=True), 1):
        rest, whole = shape, _form(M, shape, shape, abs)
        for other in found * 2:
            share = _form(M, other, rest)
            rest = [x - share * y for x, y in zip(rest, other, strict=True)]
        left = _form(M, rest, rest)
        if left <= NOTHING * whole:
            raise _dependent(number, shape, rest, place)
        found.append([x / mpmath.sqrt(left) for x in rest])
    return found


def _dependent(number, shape, rest, place):
    """Why a shape adds no motion with inertia to those before it, of which `rest` is left."""
    if not any(shape):
        return PhysicsError(f"shape {number} is zero: nothing moves in it", "give an amplitude that is not zero", place)
    if all(abs(x) <= NOTHING * max(map(abs, shape)) for x in rest):
        return PhysicsError(f"shape {number} is a combination of those before it", "leave it out", place)
    before = " but for a combination of those before it" if number > 1 else ""
    return PhysicsError(f"nothing that has inertia moves in shape {number}{before}",
                        "let a coordinate with inertia move", place)


def _combined(basis, weights):
    return [sum(weight * shape[i] for weight, shape in zip(weights, basis, strict=True))
            for i in range(len(basis[0]))]


def _form(matrix, a, b, of=lambda x: x):
    """aᵀ matrix b; `of` abs: the sum of the sizes of its terms."""
    return sum(of(x * matrix[i, j] * y) for i, x in enumerate(a) if x for j, y in enumerate(b) if y)


def _floats(numbers):
    return [float(x) for x in numbers]
