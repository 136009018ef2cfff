"""How many zeros det D(s) has within |s| < R, multiplicities counted, certain by the argument principle.

F(s) = det D(s) Π e(s) is entire; the zeros of e are the s at which a piece vibrates with its ends held. Those of F less
those of Π e are the turns that arg det D makes around the circle, twice those of its upper half as D(s̄) is D(s)
conjugate. How far the argument can change along a step from s₀ is bounded: as a function of κ = μs² + cs + k a piece is

    d(κ) = a + b κ + Σ R_j (1/(κ_j − κ) − 1/κ_j),    κ_j real, b, R_j ≥ 0 (Nevanlinna),

so that |xᴴ (d(κ) − d(κ₀)) y|² ≤ xᴴQx · yᴴQy with Q = P |κ − κ₀|/(1 − |κ − κ₀|/ρ), P = Im d(κ₀)/Im κ₀ and ρ the distance
of κ₀ to the κ_j. With Q for all that D is added from, σ_i the singular values of Q^½ D(s₀)⁻¹ Q^½,

    |Δ arg det D| ≤ −Σ ln(1 − σ_i)      (H. Weyl 1949).

Where stiffness resists rates by β the same holds of D/(1 + βs) = K + r (C − βK) + p M + Σ Sᵀ d(k + μ p + c r) S with
r = s/(1 + βs) and p = s r, for R < 1/β: at s = −1/β frequencies of held pieces pile up.
"""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.counting import GUARD
from vibcli.analyses.continuous.leaving_waves import leaving_room
from vibcli.numerics.fixed_point import count_floats
from vibcli.numerics.pieces.held_count import held_count
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.retardation import retarded_reaction

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix, EvaluatedMatrix, PieceStack

ARCS = 16           # of half a circle, to begin with
LEAST = 2.0**-32    # the shortest arc, of the whole path: something lies on it
MOST, SINGLE = 20_000, 100_000       # arcs; where D is one number, with a damper that may nearly swallow all waves
TURN = 1.4          # by which the argument changes at most between the middle of an arc and its ends: below π/2
UNIT = 2.0**-53
FADED = 1e-250      # of D: floats hardly hold what its waves bring back
HUGE = 1e100        # D is singular in floats
CLEAR = 2.0 ** -np.array([*range(10), 11, 13, 15, 17])      # relative distances at which poles are looked for


def zeros_within(matrix: "DynamicMatrix", radius: float) -> int | None:
    """The zeros of F in |s| < radius; None where one of them, or of a piece held at its ends, is next to the circle."""
    if not matrix.retardation * radius < 1 or fades(matrix, radius):
        return None
    held = sum(int(held_within(stack, radius).sum()) for stack in matrix.stacks)
    turns = _half_turns(matrix, lambda t: radius * np.exp(1j * np.pi * t), ARCS) if matrix.n else 0
    return None if turns is None else turns + held


def zeros_aside(matrix: "DynamicMatrix", inner: float, outer: float, angle: float, sign: int) -> int | None:
    """The zeros of det D between two circles within an angle of the positive (sign 1) or negative (−1) real axis;
    pieces held at their ends must have none there. None where a zero is next to the border."""
    if not matrix.n:
        return 0

    def border(t: np.ndarray) -> np.ndarray:
        # along the outer arc from the axis, along the ray, along the inner arc back to the axis
        turned = angle * np.clip(np.minimum(3 * t, 3 - 3 * t), 0, 1)
        size = outer * (inner / outer) ** np.clip(3 * t - 1, 0, 1)
        return cast("np.ndarray", size * np.exp(1j * turned))

    if sign > 0:
        return _half_turns(matrix, border, 3 * ARCS)
    return _half_turns(matrix, lambda t: -border(1 - t).conj(), 3 * ARCS)


def fades(matrix: "DynamicMatrix", radius: float) -> bool:
    """Is D so small on the circle that floats do not hold it, where dampers let no wave come back?"""
    if not matrix.n or matrix.retardation:
        return False
    s = np.array([-radius + 0j])
    with np.errstate(all="ignore"):
        return bool(np.min(sizes(matrix.at(s, steep=True), s)) < FADED)


def held_within(stack: "PieceStack", radius: float) -> np.ndarray:
    """How many s in |s| < radius there are at which pieces vibrate with all end values 0, drag and all: (pieces, 1)."""
    return _held_retarded(stack, radius) if stack.beta.any() else _held(stack.piece, radius)


def _held(piece: Piece, radius: float) -> np.ndarray:
    mu, c, k = piece.inertia, np.abs(piece.drag), piece.foundation

    def beyond(kappa: np.ndarray) -> np.ndarray:
        return held_count(piece._replace(foundation=kappa), 0)

    left, right = beyond(k + (mu * radius - c) * radius), beyond(k + (mu * radius + c) * radius)
    turning = np.where(mu > 0, c * c / (4 * np.where(mu > 0, mu, 1.0)), 0.0)
    double = beyond(k - turning)                    # these decay without swinging
    slow = c < 2 * mu * radius
    swinging = np.maximum(beyond(k - mu * radius * radius) - double, 0)
    return cast("np.ndarray", np.where(slow, 2 * swinging + 2 * double - right - left, left - right))


def _held_retarded(stack: "PieceStack", radius: float) -> np.ndarray:
    """The same where μs² + cs + K (1 + βs) = 0 has two, one or no roots in |s| < radius, K = k − κ_j > 0 of each
    frequency of a held piece: between the K at which that changes it is what it is in their middle."""
    piece, found = stack.piece, np.zeros((len(stack.ends), 1), int)
    for p in range(len(found)):
        one = Piece(*(float(part[p, 0]) for part in piece))
        mu, c, beta = float(one.inertia), float(one.drag), float(stack.beta[p, 0])
        turns = np.roots([beta**2, 2 * beta * c - 4 * mu, c**2]) if mu else np.zeros(0)
        places = [radius * (c - mu * radius) / (1 - beta * radius), -radius * (c + mu * radius) / (1 + beta * radius),
                  mu * radius**2, -mu * radius**2, *turns[abs(turns.imag) <= 1e-9 * abs(turns)].real]
        places = sorted({0.0, *places})
        beyond = [int(held_count(one._replace(foundation=np.array([one.foundation - K])), 0)[0]) for K in places]
        places = [2 * min(places) - 1.0, *places, 2 * max(places) + 1.0]
        for low, high, many in zip(places, places[1:], np.diff([0, *beyond]), strict=False):
            roots = np.roots([mu, c + beta * float(low + high) / 2, float(low + high) / 2])
            found[p] += many * int((abs(roots) < radius).sum())
    return found


def _half_turns(matrix: "DynamicMatrix", path: "Callable[..., np.ndarray]", arcs: int) -> int | None:
    """Those of det D."""
    return turned(lambda s, step: _phases(matrix, s, step), path, arcs, MOST if matrix.n > 1 else SINGLE)


def turned(phases: "Callable[..., tuple[np.ndarray, np.ndarray]]", path: "Callable[[np.ndarray], np.ndarray]",
           arcs: int, most: int) -> int | None:
    """By how many half turns the argument of phases(s, step)[0] changes along path(t), 0 ≤ t ≤ 1, from the real axis
    back to it; phases(s, step)[1] bounds what it changes by within so long a step. None where `most` arcs do not
    tell."""
    arguments = _arguments(phases, path, arcs, most)
    if arguments is None:
        return None
    steps = np.angle(arguments[1:] / arguments[:-1])
    return cast("int | None", round((_to_real(arguments[0]) + steps.sum() - _to_real(arguments[-1])) / np.pi))


def _to_real(value: complex) -> float:
    """The angle from the nearest part of the real axis, where D is real."""
    angle = np.angle(value)
    return cast("float", angle - np.pi * np.rint(angle / np.pi))


def _arguments(phases: "Callable[..., tuple[np.ndarray, np.ndarray]]", path: "Callable[..., np.ndarray]", arcs: int,
               most: int) -> np.ndarray | None:
    """Values of size 1 at the middles of arcs, in order, between which it changes by less than half a turn."""
    ends = np.linspace(0, 1, arcs + 1)
    low, high = ends[:-1], ends[1:]
    places, values, spent = [np.zeros(0)], [np.zeros(0, complex)], 0
    while len(low):
        spent += len(low)
        if spent > most or (high - low).min() < LEAST:
            return None
        middle = (low + high) / 2
        s = path(middle)
        phase, change = phases(s, np.maximum(abs(path(high) - s), abs(s - path(low))))
        good = change <= TURN
        places.append(middle[good])
        values.append(phase[good])
        low, middle, high = low[~good], middle[~good], high[~good]
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    order = np.argsort(np.concatenate(places))
    return np.concatenate(values)[order]


def _phases(matrix: "DynamicMatrix", s: np.ndarray, step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """det D/|det D| at each s, and how far its argument can be from that within so long a step."""
    count_floats(matrix.n, len(s))
    with np.errstate(all="ignore"):
        found = matrix.at(s, steep=True)
        room = _room(matrix, found, s, step)
        D = np.moveaxis(found.D, -1, 0).astype(complex) / (1 + matrix.retardation * s)[:, None, None]
        scale = 1 / np.sqrt(np.maximum(sizes(found, s).T, 1e-300))
        D = D * scale[:, :, None] * scale[:, None, :]
        room = room * scale[:, :, None] * scale[:, None, :]
        usable = np.isfinite(D).all(axis=(1, 2)) & np.isfinite(room).all(axis=(1, 2))
        phase, change = np.ones(len(s), complex), np.full(len(s), np.inf)
        if not usable.any():
            return phase, change
        phase[usable] = np.linalg.slogdet(D[usable])[0]
        usable &= phase != 0
        values, basis = np.linalg.eigh(room[usable])
        root = basis * np.sqrt(np.maximum(values, 0))[:, None, :]
        moved = np.swapaxes(root, 1, 2) @ np.linalg.solve(D[usable], root.astype(complex))
        small = (abs(moved) < HUGE).all(axis=(1, 2))
        sigma = np.full(moved.shape[:2], np.inf)
        sigma[small] = np.linalg.svd(moved[small], compute_uv=False)
        change[usable] = np.where(sigma.max(axis=1) < 1, -np.log1p(-sigma).sum(axis=1), np.inf)
    return phase, np.where(np.isfinite(change), change, np.inf)


def sizes(found: "EvaluatedMatrix", s: Any) -> np.ndarray:
    """What the diagonal of D was added from, and what it changes by as s does by itself: also where all parts are 0."""
    return cast("np.ndarray", np.abs(found.size) + abs(s) * np.abs(np.moveaxis(np.diagonal(found.slope), -1, 0)))


def _room(matrix: "DynamicMatrix", found: "EvaluatedMatrix", s: np.ndarray, step: np.ndarray) -> np.ndarray:
    """Q of a step from each s: (N, n, n)."""
    beta = matrix.retardation
    C, M = (_majorant(part) for part in (matrix.polynomial[1] - beta * matrix.polynomial[0], matrix.polynomial[2]))
    drag, inertia = _steps(beta, s, step)
    room, away = inertia[:, None, None] * M, matrix.leaves(s)
    if away.any():
        room = room + drag[:, None, None] * np.where(away[:, None, None], _majorant(matrix.damping_left), C)
    else:
        room = room + drag[:, None, None] * C
    n = matrix.n
    room[:, range(n), range(n)] += GUARD * n * UNIT * sizes(found, s).T / np.abs(1 + beta * s)[:, None]
    for stack, Z, (d, _) in zip(matrix.stacks, matrix.impedances, found.ends, strict=True):
        kappa = retarded_reaction(stack.piece, s, stack.beta)
        if beta:
            moved = stack.piece.inertia * inertia + stack.piece.drag * drag
        else:
            moved = (abs(2 * stack.piece.inertia * s + stack.piece.drag) + stack.piece.inertia * step) * step
        left = 1 - moved / _distance(stack, kappa)
        share = np.where(left > 0, moved / np.where(left > 0, left, 1), np.inf)
        power = (d / (1 + beta * s)).imag / kappa.imag * share
        if away.any() and Z.any():
            power = _leaving_power(stack, Z, found, s, step, away, power)
        for p, rows in enumerate(stack.ends):
            for a, b in np.ndindex(len(rows), len(rows)):
                for i, x in rows[a].items():
                    for j, y in rows[b].items():
                        room[:, i, j] += float(x * y) * power[a, b, p]
    return cast("np.ndarray", room)


def _leaving_power(stack: "PieceStack", Z: np.ndarray, found: "EvaluatedMatrix", s: np.ndarray, step: np.ndarray,
                   away: np.ndarray, power: np.ndarray) -> np.ndarray:
    """Q of pieces whose leaving waves are taken off: of what ends answer themselves, and of what one answers the
    other, b, |b (x̄₀ y₁ + x̄₁ y₀)|² ≤ (b t |x₀|² + b/t |x₁|²)(b t |y₀|² + b/t |y₁|²) for any t > 0; near poles as
    without, and of the damper taken off."""
    own, across = leaving_room(stack.piece, np.where(Z, Z, 1.0), s, step)
    here = away & (Z > 0)
    far = here & np.isfinite(own)
    size = np.sqrt(np.maximum(found.size, 1e-300))
    power = np.where(far, 0.0, power)
    for p, rows in enumerate(stack.ends):
        felt = [sum((abs(float(x)) * size[i] for i, x in row.items()), 0 * step) for row in rows]
        both = (felt[0] > 0) & (felt[1] > 0)        # else one end is held
        t = np.where(both, felt[0] / np.where(both, felt[1], 1), 1.0)
        for end, share in enumerate((np.where(both, t, 0.0), np.where(both, 1 / t, 0.0))):
            leaves = np.where(far[p], own[p] + across[p] * share, np.where(here[p], Z[p] * step, 0.0))
            power[end, end, p] += leaves
    return power


def _steps(beta: float, s: np.ndarray, step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Bounds of |Δr| and |Δp| within so long a step from each s."""
    size, factor = abs(s), np.abs(1 + beta * s)
    left = factor - beta * step
    drag = np.where(left > 0, step / (factor * np.where(left > 0, left, 1.0)), np.inf)
    return drag, step * size / factor + (size + step) * drag


def _majorant(part: np.ndarray) -> np.ndarray:
    """|A| + |Aᵀ| of a matrix, |A| where it is symmetric: |xᴴAy|² ≤ xᴴQx · yᴴQy."""
    if not part.any():
        return part
    if (part == part.T).all():
        return _magnitude(part)
    return cast("np.ndarray", _magnitude(part) + _magnitude(part.T))


def _magnitude(part: np.ndarray) -> np.ndarray:
    """√(AᵀA)."""
    _, values, basis = np.linalg.svd(part)
    return cast("np.ndarray", (basis.T * values) @ basis)


def _distance(stack: "PieceStack", kappa: np.ndarray) -> np.ndarray:
    """A distance of κ within which there is no frequency of pieces held at their ends."""
    free = np.zeros(kappa.shape)
    for part in CLEAR[::-1]:
        width = part * abs(kappa)
        ends = (held_count(stack.piece._replace(foundation=kappa.real + side * width), 0) for side in (-1, 1))
        free = np.where(np.equal(*ends), width, free)
    return cast("np.ndarray", np.hypot(kappa.imag, free) * 0.999)


def newton_steps(D: np.ndarray, slope: np.ndarray) -> np.ndarray:
    """All δ with det(D + δ D′) = 0."""
    try:
        nu = np.linalg.eigvals(np.linalg.solve(D, slope))
    except np.linalg.LinAlgError:       # D is singular in floats: a root
        return np.zeros(1)
    return -1 / nu[abs(nu) > 0]
