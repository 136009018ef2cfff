"""Two estimates of the lowest natural frequency beside its exact value, an upper and a lower bound.

    Rayleigh    ω² ≤ δᵀKδ / δᵀMδ     with the static deflection K δ = M d, all coordinates pulled alike by their inertia
    Dunkerley   1/ω² ≤ tr(K⁻¹M) = Σ 1/ωⱼⱼ²     ωⱼⱼ the frequency with the inertia of body j alone

Both hold where K is positive definite and nothing gyroscopic acts (Rayleigh 1873; Dunkerley 1894). d is 1 in each
coordinate that measures what the first one with inertia does, lengths or angles, and 0 in the others.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.modal.modes_precise import WORKING
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.units import LENGTH, parse_unit
from vibcli.mechanics.element_contributions import owned_forms
from vibcli.mechanics.inner_products import along

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.system import MechanicalSystem

ROUNDING = 1e-14        # relative, of what is evaluated in floats


class Estimates(NamedTuple):
    """omega, rayleigh, dunkerley in rad/s; deflection: δ by coordinate, its largest part 1; alone: {body: ωⱼⱼ};
    members: MemberEstimates of scenes that have such; error: the relative one of both bounds."""

    omega: float
    rayleigh: float
    dunkerley: float
    deflection: dict[str, float]
    alone: dict[str, float]
    members: Any = None
    error: float = ROUNDING


def estimates(modal: "ModalAnalysis", _: Any) -> Estimates:
    """The Estimates of a system; PhysicsError where the bounds do not hold."""
    if modal.scene.pieces:
        return _with_members(modal)
    with mpmath.workdps(WORKING):
        _require_bounds(modal)
        elements = modal.configuration.precise_system(WORKING)
        M, _, _, K = (matrix_of(entries, elements.n) for entries in elements.matrices())
        flexibility = _flexibility(K)
        pulled = M * mpmath.matrix(_unit_displacement(modal.system, elements))
        deflection = flexibility * pulled
        rayleigh = mpmath.sqrt((deflection.T * pulled)[0] / (deflection.T * M * deflection)[0])
        alone = {name: _trace(rows, matrix, flexibility)
                 for name, (rows, matrix) in owned_forms(modal.configuration).kinetic.items()}
        return Estimates(
            float(modal.sharp_modes[0].omega), float(rayleigh), float(1 / mpmath.sqrt(sum(alone.values()))),
            _relative(modal, deflection, mpmath.sqrt(mpmath.eps)),
            {name: float(1 / mpmath.sqrt(square)) for name, square in alone.items() if square > 0})


def _relative(modal: "ModalAnalysis", deflection: "Sequence[mpmath.mpf]", rounded: "mpmath.mpf") -> dict[str, float]:
    """{coordinate: its part of the largest}, 0 of what `rounded` is not beside it."""
    largest = max(deflection, key=abs, default=1.0)
    return {name: float(mpmath.chop(x / largest, rounded))
            for name, x in zip(modal.scene.coordinates, deflection, strict=True)}


def _with_members(modal: "ModalAnalysis") -> Estimates:
    """The Estimates of a scene with members."""
    import numpy as np

    from vibcli.analyses.continuous.member_estimates import bounds, further, static_stiffness

    _require_bounds(modal)
    elements = modal.configuration.linear_system
    torsional = all(member.kind.torsional for member in modal.scene.members.values())
    across = parse_unit("rad").dimension if torsional else LENGTH
    pulled = [int(modal.system.dimension(name) == across) for name in modal.scene.coordinates]
    rayleigh, deflection, squares, error = bounds(modal, pulled)
    if elements.n:
        with mpmath.workdps(WORKING):
            flexibility = mpmath.matrix(np.linalg.inv(static_stiffness(elements)).tolist())
            for name, (rows, matrix) in owned_forms(modal.configuration).kinetic.items():
                squares[name] = squares.get(name, 0.0) + float(_trace(rows, matrix, flexibility))
    return Estimates(
        float(modal.modes[0].omega), rayleigh, sum(squares.values()) ** -0.5,
        _relative(modal, deflection, 2.0**-52),
        {name: square**-0.5 for name, square in squares.items() if square > 0}, further(modal), max(error, ROUNDING))


def _require_bounds(modal: "ModalAnalysis") -> None:
    """Refuse a scene of which K is not positive definite, or which has gyroscopic terms."""
    what = "the estimates of Rayleigh and Dunkerley need "
    if any(modal.configuration.linear_system.G.values()):
        raise PhysicsError(what + "a system without gyroscopic terms", "their bounds hold for M and K alone")
    first = modal.modes[0] if modal.scene.pieces else modal.sharp_modes[0]
    if first.rigid:
        raise PhysicsError(what + "a stiffness along every motion, and mode 1 is a rigid-body mode",
                           "hold the scene by a spring, or ask for omega[i]")
    if first.omega is None:
        raise PhysicsError(what + "a stable equilibrium, and mode 1 is unstable", "see `vibcli frequencies`")


def _flexibility(K: mpmath.matrix) -> mpmath.matrix:
    """K⁻¹; PhysicsError where K is not positive definite, which massless coordinates may hide from the modes."""
    try:
        mpmath.cholesky(K)
    except ValueError:
        raise PhysicsError("the estimates of Rayleigh and Dunkerley need a positive definite stiffness matrix, and a "
                           "massless coordinate has none", "see `vibcli frequencies`") from None
    return mpmath.inverse(K)


def _unit_displacement(system: "MechanicalSystem", elements: "FactoredSystem") -> list[int]:
    heavy = [i for i in range(elements.n) if i not in elements.massless]
    kinds = [system.dimension(name) for name in system.scene.coordinates]
    return [int(kind == kinds[heavy[0]]) for kind in kinds]


def matrix_of(entries: Mapping[tuple[int, int], Any], n: int) -> mpmath.matrix:
    """{(i, j): number} as a matrix of mpmath's."""
    found = mpmath.zeros(n)
    for pair, entry in entries.items():
        found[pair] = entry
    return found


def _trace(rows: Sequence[tuple[mpmath.mpf, dict[int, mpmath.mpf]]], matrix: Mapping[Any, Any],
           flexibility: mpmath.matrix) -> mpmath.mpf:
    """tr(K⁻¹M) of a part Σ w ∇s ∇sᵀ + M₊ of the inertia: the 1/ω² of that part alone."""
    n = flexibility.rows
    total = sum(entry * flexibility[i, j] for (i, j), entry in matrix.items())
    for weight, row in rows:
        bent = {i: along(row, [flexibility[i, j] for j in range(n)]) for i in row}
        total += weight * along(row, bent)
    return total
