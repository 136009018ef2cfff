"""Upper bounds of the lowest natural frequencies by assumed shapes (Rayleigh 1877, Ritz 1909).

    q = Φ c     M̂ = ΦᵀMΦ, K̂ = ΦᵀKΦ     K̂ c = ω̃² M̂ c     the columns of Φ are the assumed shapes

Shapes constrain the motion, and constraints lower no frequency: ω̃ᵢ² ≥ ωᵢ² (minimax principle of Courant and Fischer),
where M and K are symmetric and what has no inertia is held. One shape gives Rayleigh's quotient φᵀKφ/φᵀMφ.
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.assumed_motions import (
    NOTHING,
    RitzEstimates,
    RitzMode,
    amplitude_of,
    orthonormal,
    product_of,
    require_bounds,
)
from vibcli.base.errors import PhysicsError
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity
from vibcli.language.sections.equilibrium import ByCoordinate

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.base.errors import Where
    from vibcli.language.reader import ByName, Record

ELEMENT = Element(
    "Ritz estimate",
    "Upper bounds of the lowest natural frequencies: the scene is to move in combinations of the assumed shapes alone "
    "(Rayleigh and Ritz), its dampers left out. k shapes give k bounds, each beside the exact frequency, and the "
    "combination of the shapes that belongs to it; one shape gives Rayleigh's quotient. Members deflect as functions "
    "of the place x, {wing.u: x^2}, shafts {line.phi: x}; what holds to them goes along.",
    {
        "shapes": Field(Many(ByCoordinate(Quantity(), "a shape {coordinate: amplitude}, such as {x1: 1, x2: 2}",
                                          scaled=True), 1, 20, "a list of shapes"),
                        "displacements of coordinates, of any size; those left out rest. With units where lengths and "
                        "angles are in one shape: {x: 1 m, phi: 0.5 rad}", required=True),
    },
    example="shear_frame_by_ritz",
)


def ritz(modal: Any, asked: Any) -> RitzEstimates:
    """The RitzEstimates of a system; PhysicsError where its shapes or its matrices give no bounds."""
    import mpmath

    from vibcli.analyses.modal.estimates import matrix_of
    from vibcli.analyses.modal.modes_precise import WORKING

    if asked is None:
        raise PhysicsError("no shapes are assumed for the Ritz estimates",
                           "ask with find: [{ritz: {shapes: [{"
                           + next((f"{name}: 1" for name in modal.scene.coordinates), "wing.u: x^2") + "}]}}]")
    if modal.scene.pieces:
        from vibcli.analyses.continuous.assumed_bounds import member_bounds

        return member_bounds(modal, asked)
    natural = modal.sharp_modes         # refused where there are none, or too many coordinates
    with mpmath.workdps(WORKING):
        elements = modal.configuration.precise_system(WORKING)
        M, _, _, K = (matrix_of(entries, elements.n) for entries in elements.matrices())
        require_bounds(modal.configuration.linear_system, M, K)
        shapes = [_shape(modal, shape) for shape in asked["shapes"]]
        basis = orthonormal(shapes, M, [_place(shape, asked) for shape in asked["shapes"]])
        squares, mixed = mpmath.eigsy(mpmath.matrix([[product_of(K, a, b) for b in basis] for a in basis]))
        modes, least = [], mpmath.mpf(10) ** (5 - WORKING) * max(map(abs, squares))     # that eigsy tells from zero
        for i, (square, exact) in enumerate(zip(squares, natural, strict=False)):
            shape = _combined(basis, mixed[:, i])
            if abs(square) <= max(least, NOTHING * product_of(K, shape, shape, abs)):
                square = mpmath.mpf(0)
            modes.append(RitzMode(i + 1, float(square), float(mpmath.sqrt(square)) if square >= 0 else None,
                                  _floats(shape), None if exact.omega is None else float(exact.omega)))
        mass, stiffness = ([_floats(product_of(matrix, a, b) for b in shapes) for a in shapes] for matrix in (M, K))
        return RitzEstimates([_floats(shape) for shape in shapes], mass, stiffness, modes)


def _shape(modal: "ModalAnalysis", written: "ByName") -> "list[mpmath.mpf]":
    """A shape that is written as numbers, one a coordinate."""
    found = [0] * len(modal.scene.coordinates)
    for name, expression in written.items():
        i, amplitude = amplitude_of(modal, name, expression)
        found[i] = amplitude
    return found


def _place(written: "ByName", asked: "Record") -> "Where":
    return next((expression.where for expression in written.values()), asked.where)


def _combined(basis: "Sequence[list[mpmath.mpf]]", weights: "mpmath.matrix") -> "list[mpmath.mpf]":
    return [sum(weight * shape[i] for weight, shape in zip(weights, basis, strict=True))
            for i in range(len(basis[0]))]


def _floats(numbers: "Iterator[Any] | Sequence[mpmath.mpf]") -> list[float]:
    return [float(x) for x in numbers]
