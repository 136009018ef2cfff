"""Damped modes of few shapes whose λ are one, or nearly so, as where damping is critical: what they bring to D(s)⁻¹ is
Cauchy's mean over a circle about them,

    (1/N) Σ (z − c) V (−G)⁻¹ Vᵀ/(s − z),      [D(z) Y; Yᵀ 0] [V; G] = [0; 1],

as D⁻¹ = E − V G⁻¹ Vᵀ where E, V and G have no pole next to them (Y: the shapes at their middle c). So the points z of
the circle move as modes do, of shapes V F with F Fᵀ = −G⁻¹. With G′ = −Vᵀ D′ V they tell Σ (λ − c)ᵏ as well; as many
shapes are taken as leave E none of the λ that tr D⁻¹ D′ counts within the circle.
"""

from typing import Any, cast

import numpy as np

from vibcli.analyses.continuous.counting import GUARD, SLACK
from vibcli.analyses.continuous.damped_roots import GIVEN
from vibcli.analyses.continuous.newton_of_members import Divisions, ShapesOf, placed_shapes
from vibcli.base.named_tuple import NamedTuple

POINTS = 64         # of a circle
RADII = 0.15, 0.04, 0.01        # of Re c, as tried: (rt)ᴺ/N! e^{−rt}, what they leave of e^{zt}, is below 1e-14 until
#                                 e^{ct} is below 1e-50
WITHIN, BEYOND = 0.5, 1.8       # of the radius: how far away they are at most, and all others at least
COUNTED, MIDDLE = 1e-3, 0.02    # of one, how far off their number is at most; of the radius, their middle
CENTRED = 6         # circles at most until their middle is known
UNSURE = 1e-8       # bound of a λ that may be several
LOST, ENOUGH, SURE = 1e-11, 1e-11, 1e-6     # relative errors: of modes beside another, of several; the largest that is
#                                             told
LED = 4e-3          # relative distance of a λ to which Newton's steps lead slowly
BESIDE, SAME = 8, 1e-12     # neighbours in |λ| among which the nearest λ is; relative distance of λ that are one
UNIT = 2.0**-53
SHAPES = 4          # of one circle at most
DOUBLINGS = 40      # of the digits of a square root at most


class CoincidentRoots(NamedTuple):
    """So many λ beside their middle, the radius of the circle about it, its points (Im > 0 where the middle is real),
    bounds that these have as λ, and their shapes."""

    middle: complex
    several: int
    radius: float
    points: np.ndarray
    errors: np.ndarray
    shapes: ShapesOf

    def holds(self, s: np.ndarray) -> np.ndarray:
        """Which λ lie within the circle, or its mirror image."""
        return np.minimum(abs(s - self.middle), abs(s - self.middle.conjugate())) < self.radius


class CircleOfRoots(NamedTuple):
    """Points about a middle, the matrix and units there, Y (n, m), V (points, n, m), G (points, m, m) and their number;
    lost: bounds of the relative errors of G."""

    matrix: Any
    units: np.ndarray
    middle: complex
    radius: float
    turns: np.ndarray
    Y: np.ndarray
    V: np.ndarray
    G: np.ndarray
    lost: np.ndarray
    several: int


def coincident_roots(divisions: Divisions, values: np.ndarray, errors: np.ndarray,
                     slow: np.ndarray) -> list[CoincidentRoots]:
    """Those among λ by |λ| with relative bounds, and among others to which Newton's steps lead slowly."""
    apart = nearest(values)
    unsure = (errors > UNSURE) | ((apart < 2 * WITHIN * RADII[0] * abs(values.real)) & (
        4 * errors * abs(values) > LOST * apart))
    slow = [s for s in slow if not (abs(s - values[~unsure]) < LED * abs(s)).any()]
    found: list[CoincidentRoots] = []
    for s in [*values[unsure], *slow]:
        if not any(one.holds(s) for one in found):
            one = _beside(divisions, complex(s), values)
            found += [] if one is None else [one]
    return found


def _beside(divisions: Divisions, s: complex, values: np.ndarray) -> CoincidentRoots | None:
    """The CoincidentRoots beside s; None where there are not several."""
    best = None
    for share in RADII:
        circle = _centred(divisions, s, share)
        if circle is not None and _apart(circle, values):
            one = _roots(circle)
            if one[0] <= SURE and (best is None or one[0] < best[0]):
                best = one
            if best is not None and best[0] <= ENOUGH:
                break
    return None if best is None else best[1]


def _apart(circle: CircleOfRoots, values: np.ndarray) -> bool:
    """Are all other λ far from the circle?"""
    away = np.concatenate([abs(values - circle.middle), abs(values.conj() - circle.middle)])
    return not ((away > circle.radius) & (away < BEYOND * circle.radius)).any()


def _centred(divisions: Divisions, s: complex, share: float) -> CircleOfRoots | None:
    """The CircleOfRoots about several λ beside s; None where there are not several within."""
    for _ in range(CENTRED):
        s = complex(s.real, 0.0) if abs(s.imag) < share * abs(s.real) else s
        circle, sums = _circle(divisions, s, share * abs(s.real))
        if not np.isfinite(sums).all() or circle.several < 2 or abs(sums[0] - circle.several) > COUNTED:
            return None
        middle = sums / circle.several / circle.radius ** np.arange(len(sums))
        if abs(middle[1]) < MIDDLE:
            spread = abs(middle[2:]) ** (1 / np.arange(2, len(sums)))
            return circle if spread.max() < WITHIN else None
        s += complex(middle[1]) * circle.radius
    return None


def _circle(divisions: Divisions, s: complex, radius: float) -> tuple[CircleOfRoots, np.ndarray]:
    """(the CircleOfRoots, Σ (λ − s)ᵏ of the λ within for k = 0 … 4, not finite where these are of too many shapes)."""
    (matrix, _, (D,), _, (units,), _), = divisions.parts(np.array([s]))
    shapes = np.linalg.svd(D if s.imag else D.real)[2].conj()[::-1]
    turns = np.exp(2j * np.pi * (np.arange(POINTS) + 0.5) / POINTS)
    one = matrix.at(s + radius * turns, steep=True)
    D, slope = (np.moveaxis(part, -1, 0) * units[:, None] * units for part in (one.D, one.slope))
    felt = units * np.sqrt(one.given.T)
    with np.errstate(all="ignore"):
        within = _within(D, slope, radius * turns)
        for m in range(1, min(SHAPES, len(shapes)) + 1):
            V, G = _bordered(D, shapes[:m].T)
            flow, lost = _flow(V, G, slope, felt)
            sums = np.array([np.mean((radius * turns)**(k + 1) * flow) for k in range(5)])
            if not np.isfinite(sums).all() or abs(sums[0] - within) <= COUNTED:
                break
        else:
            sums = np.full(5, np.nan)
    several = round(sums[0].real) if np.isfinite(sums[0]) else 0
    return CircleOfRoots(matrix, units, s, radius, turns, shapes[:m].T, V, G, lost, several), sums


def _within(D: np.ndarray, slope: np.ndarray, steps: np.ndarray) -> complex:
    """How many λ there are within a circle, as tr D⁻¹ D′ tells."""
    try:
        return cast("complex", np.mean(steps * np.trace(np.linalg.solve(D, slope), axis1=1, axis2=2)))
    except np.linalg.LinAlgError:
        return np.nan


def _flow(V: np.ndarray, G: np.ndarray, slope: np.ndarray, felt: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(tr G⁻¹ G′ at each point, bounds of the relative errors of G)."""
    try:
        inverse = np.linalg.inv(G)
    except np.linalg.LinAlgError:
        return np.full(len(G), np.nan), np.full(len(G), np.inf)
    given = (abs(V) * felt[:, :, None]).sum(axis=1)
    off = SLACK * GUARD * (abs(V).sum(axis=1)**2).sum(axis=1) + GIVEN * (given**2).sum(axis=1)
    return -np.einsum("kab,kia,kij,kjb->k", inverse, V, slope, V, optimize=True), UNIT * off * np.linalg.norm(
        inverse, axis=(1, 2))


def _bordered(D: np.ndarray, Y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(V, G) of each D."""
    n, m = Y.shape
    whole, end = np.zeros((len(D), n + m, n + m), complex), np.zeros((n + m, m))
    whole[:, :n, :n], whole[:, n:, :n], whole[:, :n, n:], end[n:] = D, Y.T, Y, np.eye(m)
    try:
        found = np.linalg.solve(whole, np.broadcast_to(end, (len(D), n + m, m)))
    except np.linalg.LinAlgError:
        found = np.full((len(D), n + m, m), np.nan)
    return found[:, :n], found[:, n:]


def _halved(A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(symmetric F with F Fᵀ = A of each symmetric A, relative residuals): as Denman and Beavers (1976), turned so that
    no eigenvalue is next to the cut of the root."""
    angles = np.sort(np.angle(np.linalg.eigvals(A)), axis=1)
    gaps = np.diff(angles, axis=1, append=angles[:, :1] + 2 * np.pi)
    widest = np.argmax(gaps, axis=1)[:, None]
    cut = np.take_along_axis(angles + gaps / 2, widest, axis=1)
    turn = -np.exp(1j * cut)[:, :, None] * np.linalg.norm(A, axis=(1, 2))[:, None, None]
    F, other = A / turn, np.broadcast_to(np.eye(A.shape[1]), A.shape)
    for _ in range(DOUBLINGS):
        next_one, other = (F + np.linalg.inv(other)) / 2, (other + np.linalg.inv(F)) / 2
        moved, F = np.abs(next_one - F).max(), next_one
        if moved <= 4 * UNIT:
            break
    F = (F + np.swapaxes(F, 1, 2)) / 2 * np.sqrt(turn)
    return F, np.linalg.norm(F @ F - A, axis=(1, 2)) / np.linalg.norm(A, axis=(1, 2))


def _roots(circle: CircleOfRoots) -> tuple[float, CoincidentRoots]:
    """(the largest relative error of what they bring, the CoincidentRoots)."""
    c, r = circle.middle, circle.radius
    points = c + r * circle.turns
    inverse, m = np.linalg.inv(circle.G), circle.Y.shape[1]
    powers = abs(np.fft.fft(circle.V @ inverse, axis=0)).max(axis=(1, 2))
    cut = powers[POINTS // 2 - 1:POINTS // 2 + 2].max() / powers.max()
    kept = np.full(POINTS, True) if c.imag else points.imag > 0
    F, off = _halved(-inverse[kept])
    lost = (circle.lost + cut**2)[kept] + off
    F = F * np.sqrt(r * circle.turns[kept] / POINTS)[:, None, None]
    shapes, put = (np.swapaxes(part, 1, 2).reshape(-1, len(circle.Y)) for part in (
        circle.V[kept] @ F, -circle.Y @ circle.G[kept] @ F))
    errors, points = (np.repeat(part, m) for part in (
        lost * nearest(points[kept]) / (4 * abs(points[kept])), points[kept]))
    found = placed_shapes(circle.matrix, np.arange(len(points)), circle.units * shapes, points, put / circle.units)
    return float(lost.max()), CoincidentRoots(c, circle.several, r, points, errors, found)


def nearest(rates: np.ndarray) -> np.ndarray:
    """The distance of each λ to the next one, conjugates too."""
    found = np.where(rates.imag > 0, 2 * rates.imag, np.inf)
    for away in range(1, min(BESIDE, len(rates) - 1) + 1):
        one, other = rates[away:], rates[:-away]
        apart = np.minimum(abs(one - other), abs(one - other.conj()))
        apart = np.where(apart > SAME * abs(one), apart, np.inf)
        found[away:], found[:-away] = np.minimum(found[away:], apart), np.minimum(found[:-away], apart)
    return np.where(np.isfinite(found), found, np.maximum(abs(rates), 1e-300))
