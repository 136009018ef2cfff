"""Approximations of the lowest frequencies of scenes with members, beside the exact ones.

    Rayleigh     ω² ≤ δᵀKδ / δᵀMδ             δ the static deflection under forces in proportion to the inertia
    Dunkerley    1/ω² ≤ ∫ μ(x) G(x, x) dx + tr(K⁻¹M) = Σ 1/ω_n²         G the static deflection under a unit force
    lumped       m = φᵀMφ, k = φᵀKφ           φ the static deflection whose displacement of one coordinate is 1
    elements     cubic or linear finite elements, so many to each piece, from above

As a spring with a part of its mass a cantilever counts 33/140 at its tip, a bar 1/3 at its end (Rayleigh 1877, §§ 156,
182). All hold where K is positive definite.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.continuous.finite_elements import finite_elements, rows_as_array, slack_ends
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.stiffness import dynamic_stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.factored_system import FactoredSystem

NODES, DIVISIONS, LISTED, POINTS, LEAST = 256, (1, 2, 4, 8), 3, 12, 8
REFINED, NOTHING = 2, 1e-12     # times that a deflection is; of its largest part: what is only rounding


class Lumped(NamedTuple):
    """One coordinate alone moves, the rest following as at rest: its mass, of which members have the part `of_members`
    of their own (33/140 of a cantilever by its tip), its stiffness, and √(k/m)."""

    mass: float
    of_members: float | None
    stiffness: float
    omega: float


class MemberEstimates(NamedTuple):
    """lumped: {coordinate: Lumped}; elements: [(elements to a piece, [ω])]; exact: the frequencies they are for."""

    lumped: dict
    elements: list
    exact: list


def bounds(modal: "ModalAnalysis", ones: "Sequence[int]") -> tuple[float, np.ndarray, dict[str, float]]:
    """(Rayleigh's ω, the deflection δ of the coordinates, {member: its part of Σ 1/ω_n²}); `ones`: the coordinates that
    count as pulled; what lies within members is pulled across."""
    elements = modal.configuration.linear_system
    divisions = max(NODES // len(elements.pieces), LEAST)
    K, M = finite_elements(elements, divisions)
    pull = np.zeros(len(K))
    pull[:elements.n] = ones
    pull[elements.n:] = _displacements(elements, divisions)
    pulled = M @ pull
    deflection = np.linalg.solve(K, pulled)
    for _ in range(REFINED):        # very many elements are stiff beside the whole
        deflection = deflection + np.linalg.solve(K, np.asarray(pulled - K.astype(np.longdouble) @ deflection, float))
    deflection = np.where(abs(deflection) > NOTHING * abs(deflection).max(initial=0.0), deflection, 0.0)
    rayleigh = float(np.sqrt(deflection @ pulled / (deflection @ M @ deflection)))
    alone: dict[str, float] = {}
    for placed in elements.pieces:
        alone[placed.owner] = alone.get(placed.owner, 0.0) + _of_piece(elements, placed)
    return rayleigh, deflection[:elements.n], alone


def static_stiffness(elements: "FactoredSystem") -> np.ndarray:
    """K with the exact static stiffness of all pieces."""
    K = elements.with_parts(pieces=()).arrays()[3]
    for placed in elements.pieces:
        S = rows_as_array(placed.rows, elements.n)
        K = K + S.T @ dynamic_stiffness(placed.piece, 0.0) @ S
    return K


def further(modal: "ModalAnalysis") -> MemberEstimates:
    """What stands beside the bounds."""
    elements = modal.configuration.linear_system
    exact = [float(mode.omega) for mode in modal.modes.first(LISTED)]
    found = []
    for divisions in DIVISIONS:
        K, M = finite_elements(elements, divisions)
        if len(K):
            found.append((divisions, _frequencies(K, M)[:LISTED]))
    return MemberEstimates(_lumped(modal, elements), found, exact)


def _displacements(elements, divisions):
    """1 of displacements and 0 of slopes of slack ends and inner nodes, in the order of finite_elements."""
    found: list[float] = []
    for placed in elements.pieces:
        half = len(placed.rows) // 2
        slack = len(slack_ends(placed))
        found += [1.0] * slack + [1.0 - i for _ in range(divisions - 1) for i in range(half)]
    return found


def _frequencies(K, M):
    """ω ascending, of K x = ω² M x with K positive definite."""
    L = np.linalg.cholesky(K)
    flexible = np.linalg.solve(L, np.linalg.solve(L, M).T)
    squares = np.linalg.eigvalsh((flexible + flexible.T) / 2)[::-1]
    return [float(1 / np.sqrt(x)) for x in squares if x > 1e-14 * squares[0]]


def _of_piece(elements, placed):
    """∫ μ G(x, x) dx of a piece; G at x with a node there."""
    piece, total = placed.piece, 0.0
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    at, weights = (at + 1) / 2, weights / 2
    if slack_ends(placed):      # G grows like a logarithm there
        at, weights = at**3 * (10 - 15 * at + 6 * at**2), weights * 30 * at**2 * (1 - at)**2
    others = [other for other in elements.pieces if other is not placed]
    half = len(placed.rows) // 2
    for x, weight in zip(at * piece.length, weights * piece.length, strict=True):
        K = static_stiffness(_grown(elements, [*others, *divided_at(placed, x, elements.n)], half))
        unit = np.zeros(len(K))
        unit[elements.n] = 1.0
        total += weight * piece.inertia * np.linalg.solve(K, unit)[elements.n]
    return float(total)


def _grown(elements, pieces, half):
    return elements.with_parts(n=elements.n + half, pieces=tuple(pieces))


def _lumped(modal, elements):
    """{coordinate: Lumped}; the coordinates of the scene, then places of members, displacements alone."""
    if not elements.n:
        return {}
    K, M = static_stiffness(elements), finite_elements(elements, 1)[1][:elements.n, :elements.n]
    flexible, lengths = np.linalg.inv(K), _masses(elements)
    bare = elements.with_parts(pieces=()).arrays()[0]
    found: dict[str, Any] = {}
    for i, name in enumerate(modal.scene.coordinates):
        if ".slope(" in name:
            continue
        shape = flexible[:, i] / flexible[i, i]
        mass, discrete = float(shape @ M @ shape), float(shape @ bare @ shape)
        stiffness = 1 / float(flexible[i, i])
        found[name] = Lumped(mass, (mass - discrete) / lengths if lengths else None, stiffness,
                             float(np.sqrt(stiffness / mass)))
    return found


def _masses(elements):
    """The inertia of the one member that there is, else None."""
    if len({placed.owner for placed in elements.pieces}) > 1:
        return None
    return float(sum(placed.piece.inertia * placed.piece.length for placed in elements.pieces))
