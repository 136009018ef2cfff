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
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm, end_loads, loaded_fields
from vibcli.numerics.pieces.stiffness import dynamic_stiffness, stiffness_and_slope

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

NODES, DIVISIONS, LISTED, POINTS, LEAST = 256, (1, 2, 4, 8), 3, 12, 8
COARSE, FINE = 16, 24       # points on a piece
EPSILON, LARGEST = 2.2e-16, 1e-4      # relative errors: of rounding, of what is told
NOTHING = 1e-12         # of the largest part of a deflection: what is only rounding


class Lumped(NamedTuple):
    """One coordinate alone moves, the rest following as at rest: its mass, of which members have the part `of_members`
    of their own (33/140 of a cantilever by its tip), its stiffness, and √(k/m)."""

    mass: float
    of_members: float | None
    stiffness: float
    omega: float


class MemberEstimates(NamedTuple):
    """lumped: {coordinate: Lumped}; elements: [(elements to a piece, [ω])]; exact: the frequencies they are for."""

    lumped: dict[Any, Any]
    elements: list[Any]
    exact: list[Any]


def bounds(modal: "ModalAnalysis", ones: "Sequence[int]") -> "tuple[float, np.ndarray, dict[str, float], float]":
    """(Rayleigh's ω, the deflection δ of the coordinates, {member: its part of Σ 1/ω_n²}, their relative error);
    `ones`: the coordinates that count as pulled; what lies within members is pulled across."""
    elements, alone = modal.configuration.linear_system, {}
    found = _by_elements if any(map(slack_ends, elements.pieces)) else _by_fields
    rayleigh, deflection, error = found(elements, np.array(ones, float))
    if not error < LARGEST:
        raise PhysicsError("the estimates of Rayleigh and Dunkerley lose their digits, as parts of a member are so "
                           "short beside others", "leave small distances out, or see `vibcli frequencies`")
    deflection = np.where(abs(deflection) > NOTHING * abs(deflection).max(initial=0.0), deflection, 0.0)
    flexibility = np.linalg.inv(static_stiffness(elements))
    for placed in elements.pieces:
        alone[placed.owner] = alone.get(placed.owner, 0.0) + _of_piece(elements, placed, flexibility)
    return rayleigh, deflection[:elements.n], alone, error


def _by_fields(elements: "FactoredSystem", ones: np.ndarray) -> tuple[float, np.ndarray, float]:
    """(ω, δ, the relative error) by exact deflections: δ of the coordinates, along pieces ∫ μ u dx and ∫ μ u² dx by
    Gauss's rule; what fewer points give is their error."""
    M, K = elements.with_parts(pieces=()).arrays()[0], static_stiffness(elements)
    loaded = [(placed.piece, rows_as_array(placed.rows, elements.n), _even_load(placed.piece))
              for placed in elements.pieces if placed.piece.inertia]
    pulled = M @ ones + sum((S.T @ end_loads(piece, piece.foundation, form) for piece, S, form in loaded), 0.0 * ones)
    scale = np.sqrt(np.diag(K))
    deflection, rounding = np.linalg.solve(K, pulled), EPSILON
    if len(K):
        rounding *= 8 * np.linalg.cond(K / np.outer(scale, scale))
    found = []
    for points in (COARSE, FINE):
        work, inertia = deflection @ M @ ones, deflection @ M @ deflection
        for piece, S, form in loaded:
            u, weights = _deflection(piece, S @ deflection, form, points)
            work, inertia = work + weights @ u, inertia + weights @ u**2
        with np.errstate(all="ignore"):     # where rounding is all that is left the error is no number
            found.append(np.sqrt(work / inertia))
    return float(found[1]), deflection, float(rounding + abs(found[1] / found[0] - 1))


def _even_load(piece: "Piece") -> LoadForm:
    """Its inertia as a load along it."""
    return LoadForm((LoadStretch(0.0, piece.length, 0.0, (LoadTerm(piece.inertia, 0, 0.0),)),))


def _deflection(piece: "Piece", ends: np.ndarray, form: LoadForm, points: int) -> tuple[np.ndarray, np.ndarray]:
    """(u at the points of a rule, its weights times the inertia there) of a piece at rest under a load."""
    at, weights = np.polynomial.legendre.leggauss(points)
    x = (at + 1) / 2 * piece.length
    u = fields(piece, piece.foundation, np.tile(ends, (points, 1)), x)[:, 0]
    held = [loaded_fields(piece, piece.foundation, form, float(place))[0] for place in x]
    return u + np.array(held), piece.inertia * piece.length / 2 * weights


def _by_elements(elements: "FactoredSystem", ones: np.ndarray) -> tuple[float, np.ndarray, float]:
    """The same by finite elements, of strings that hang slack; the error by half as many."""
    found = []
    for nodes in (NODES // 2, NODES):
        divisions = max(nodes // len(elements.pieces), LEAST)
        K, M = finite_elements(elements, divisions)
        pulled = M @ np.array([*ones, *_displacements(elements, divisions)])
        deflection = np.linalg.solve(K, pulled)
        found.append(float(np.sqrt(deflection @ pulled / (deflection @ M @ deflection))))
    return found[1], deflection, 4 * abs(found[1] / found[0] - 1)


def static_stiffness(elements: "FactoredSystem") -> np.ndarray:
    """K with the exact static stiffness of all pieces."""
    K = elements.with_parts(pieces=()).arrays()[3]
    for placed in elements.pieces:
        S = rows_as_array(placed.rows, elements.n)
        K = K + S.T @ dynamic_stiffness(placed.piece, 0.0) @ S
    return K


def further(modal: "ModalAnalysis") -> MemberEstimates:
    """What stands beside the bounds."""
    return MemberEstimates(_lumped(modal, modal.configuration.linear_system), *beside_elements(modal))


def beside_elements(modal: "ModalAnalysis", rigid: int = 0) -> tuple[list[tuple[int, list[float]]], list[float]]:
    """[(elements to a piece, [ω])] without the rigid ones, and the exact ω that these are for."""
    exact, found = [float(mode.omega) for mode in modal.modes.first(LISTED + rigid)[rigid:]], []
    for divisions in DIVISIONS:
        K, M = finite_elements(modal.configuration.linear_system, divisions)
        omegas = _frequencies(K, M, exact[0] ** 2 if rigid else 0.0)[rigid:] if len(K) > rigid else []
        if omegas:
            found.append((divisions, omegas[:LISTED]))
    return found, exact


def _displacements(elements: "FactoredSystem", divisions: int) -> list[float]:
    """1 of displacements and 0 of slopes of slack ends and inner nodes, in the order of finite_elements."""
    found: list[float] = []
    for placed in elements.pieces:
        half = len(placed.rows) // 2
        slack = len(slack_ends(placed))
        found += [1.0] * slack + [1.0 - i for _ in range(divisions - 1) for i in range(half)]
    return found


def _frequencies(K: np.ndarray, M: np.ndarray, held: float) -> list[float]:
    """ω ascending, of K x = ω² M x with K + held M positive definite."""
    L = np.linalg.cholesky(K + held * M)
    flexible = np.linalg.solve(L, np.linalg.solve(L, M).T)
    squares = np.linalg.eigvalsh((flexible + flexible.T) / 2)[::-1]
    return [float(np.sqrt(max(1 / x - held, 0.0))) for x in squares if x > 1e-14 * squares[0]]


def _of_piece(elements: "FactoredSystem", placed: "PlacedPiece", flexibility: np.ndarray) -> float:
    """∫ μ G(x, x) dx of a piece: G is what it gives between ends that are held, and what those give."""
    piece, total = placed.piece, 0.0
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    at, weights = (at + 1) / 2, weights / 2
    slack = slack_ends(placed)
    if slack:      # G grows like a logarithm there
        at, weights = at**3 * (10 - 15 * at + 6 * at**2), weights * 30 * at**2 * (1 - at)**2
    others = [other for other in elements.pieces if other is not placed]
    half, S = len(placed.rows) // 2, rows_as_array(placed.rows, elements.n)
    for x, weight in zip(at * piece.length, weights * piece.length, strict=True):
        if slack:
            K = static_stiffness(_grown(elements, [*others, *divided_at(placed, x, elements.n)], half))
            unit = np.zeros(len(K))
            unit[elements.n] = 1.0
            total += weight * piece.inertia * np.linalg.solve(K, unit)[elements.n]
        else:
            left, right = (part.piece for part in divided_at(placed, x, elements.n))
            own = dynamic_stiffness(left, 0.0)[half:, half:] + dynamic_stiffness(right, 0.0)[:half, :half]
            row = np.array([fields(piece, piece.foundation, end, x)[0] for end in np.eye(2 * half)]) @ S
            total += weight * piece.inertia * (np.linalg.inv(own)[0, 0] + row @ flexibility @ row)
    return float(total)


def _grown(elements: "FactoredSystem", pieces: "Sequence[PlacedPiece]", half: int) -> "FactoredSystem":
    return elements.with_parts(n=elements.n + half, pieces=tuple(pieces))


def _lumped(modal: "ModalAnalysis", elements: "FactoredSystem") -> dict[str, Lumped]:
    """{coordinate: Lumped}; the coordinates of the scene, then places of members, displacements alone."""
    if not elements.n:
        return {}
    flexible, lengths = np.linalg.inv(static_stiffness(elements)), _masses(elements)
    bare = elements.with_parts(pieces=()).arrays()[0]
    M = bare + sum(_static_inertia(placed, elements.n) for placed in elements.pieces)
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


def _static_inertia(placed: "PlacedPiece", n: int) -> Any:
    """∫ μ φφᵀ dx of a piece, φ the static deflections by one end value each: ∂d/∂s² at rest."""
    piece, S = placed.piece, rows_as_array(placed.rows, n)
    return float(piece.inertia) * S.T @ stiffness_and_slope(piece, np.array([float(piece.foundation)]))[1][0] @ S


def _masses(elements: "FactoredSystem") -> float | None:
    """The inertia of the one member that there is, else None."""
    if len({placed.owner for placed in elements.pieces}) > 1:
        return None
    return float(sum(placed.piece.inertia * placed.piece.length for placed in elements.pieces))
