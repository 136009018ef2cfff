"""Natural frequencies of bodies, springs and continuous members: none missed, none invented, coincident ones as many.

Counts part them (brackets.py). Within a bracket without a pole of D a Rayleigh quotient of D leads to the frequency,

    z ← z + xᵀD x / xᵀD′x        x ← D⁻¹ D′ x        D′ = ∂D/∂s²

(an eigenvalue of D through zero; its determinant has poles that look like roots). Where frequencies lie as close as
nothing, or at one of a held piece, pieces get further nodes and several x are taken at a time. Last the count on both
sides of each value, √z (1 ± error), proves it.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.brackets import Bracket, KnownCounts, parted, reached
from vibcli.analyses.continuous.counting import GUARD, SLACK, count, rounding, scales
from vibcli.analyses.continuous.local_modes import local_modes
from vibcli.analyses.continuous.rayleigh_steps import beside, rayleigh_step, settled, start
from vibcli.analyses.continuous.refinement import PARTS, divided_at_poles
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.sparse_elimination import quadratic

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.analyses.continuous.uniform_curves import UniformCurves

STEPS, PASSES = 12, 4
WIDEST = 1e-9       # a bound that is not worth a proof
SURE = 1e-12        # a relative bound that is good enough
NOTHING = 256       # roundings of the largest, below which a part of a shape is zero
DOUBTED = 0.5       # the bound of what counts do not prove
WIDTHS = 1.3, 1.04, 1.001, 1.0      # of z: from where on a Rayleigh quotient is tried,
NEXT, NEAR_POLE = 0.2, 0.02     # and of the spacing of high frequencies, which is about 4/n, last and by a pole
MANY = 4            # brackets by a pole that are worth being served together
TIGHT = 1 + 1e-6    # where there are several
NIL = 2.0**-50      # of the largest tension: an end with less has none


class NaturalFrequency(NamedTuple):
    """A natural frequency: z = ω² (negative: growth rate √−z), the relative bound of √|z|, the shape, xᵀD′x = 1, over
    the coordinates of `system`, which begin with those of the scene; curves: it along a uniform member; whole: it
    over the coordinates of D, small parts not taken as zero; blurred: √ of what rounds there,
    Σ blurred² being a relative bound of √|z|."""

    index: int      # type: ignore[assignment]
    z: Any
    error: float
    shape: np.ndarray
    system: "ContinuousSystem"
    curves: "UniformCurves | None" = None
    whole: np.ndarray | None = None
    blurred: np.ndarray | None = None


def natural_frequencies(counts: KnownCounts, first: int, last: int) -> dict[int, NaturalFrequency]:
    """Those whose index lies from first to last, as far as this arithmetic tells them; none of them is rigid."""
    reached(counts, first, last)
    indices, found = list(range(first, last + 1)), {}
    brackets: dict[int, Bracket] = {}
    for width in WIDTHS:
        left = [i for i in indices if not _sure(found, i)]
        brackets = parted(counts, left, lambda bracket, width=width: _ready(bracket, width))
        regular = {i: bracket for i, bracket in brackets.items() if bracket.single and not bracket.pole}
        found = better(found, _polished(counts.system, regular))
        if len(found) == len(indices) and all(root.error < SURE for root in found.values()):
            return found
    found = better(found, _beside_poles(counts.system, {
        i: bracket for i, bracket in brackets.items() if bracket.single and not _sure(found, i)}))
    rest: dict[Bracket, list[int]] = {}
    for i in indices:
        if i in brackets and not _sure(found, i):
            rest.setdefault(brackets[i], []).append(i)
    for bracket, members in rest.items():
        found = better(found, _local(counts, bracket, members))
    return found


def better(one: dict[int, NaturalFrequency], other: dict[int, NaturalFrequency]) -> dict[int, NaturalFrequency]:
    """The roots of two searches, of one index that with the narrower bound."""
    return one | {i: root for i, root in other.items() if i not in one or root.error < one[i].error}


def _sure(found: Mapping[int, NaturalFrequency], index: int) -> bool:
    return index in found and found[index].error < SURE


def _ready(bracket: Bracket, width: float) -> bool:
    """Is a bracket narrow enough to leave counting?"""
    if not bracket.single:
        return _ratio(bracket) < TIGHT
    return _ratio(bracket) < 1 + max((NEAR_POLE if bracket.pole else NEXT) / (20 + bracket.above),
                                     0.0 if bracket.pole else width - 1)


def _ratio(bracket: Bracket) -> "float | mpmath.mpf":
    near, far = sorted((abs(bracket.low), abs(bracket.high)))
    return far / near if near and (bracket.low > 0) == (bracket.high > 0) else float("inf")


def _polished(system: "ContinuousSystem", brackets: Mapping[int, Bracket]) -> dict[int, NaturalFrequency]:
    """The roots of brackets with one frequency and no pole, all at a time; those that fail are left out. Each step
    tells by the signs of its pivots on which side of the root it lies, so that brackets narrow too."""
    if not brackets or not system.n:
        return {}
    indices = np.array(list(brackets))
    low, high = (system.numbers(getattr(one, end) for one in brackets.values()) for end in ("low", "high"))
    z, x, last = (low + high) / 2, start(system, len(indices)), system.aside ** 1.5
    held = system.held(z).sum(axis=0)
    for _ in range(STEPS):
        here, before = beside(system, z), z
        z, x, negative = rayleigh_step(system, here, x)
        close = abs(z - before) <= last * abs(z)
        above = held + negative >= indices
        low, high = np.where(above, low, np.maximum(low, here)), np.where(above, np.minimum(high, here), high)
        z = np.where((z > low) & (z < high), z, (low + high) / 2)
        if close.all():
            break
    within = (z > low) & (z < high) & close
    return certified(system, z[within], x[:, within], indices[within].tolist(), within[within]) if within.any() else {}


def _beside_poles(system: "ContinuousSystem", brackets: dict[int, Bracket]) -> dict[int, NaturalFrequency]:
    """The roots of brackets with one frequency and a pole in or near them, all at a time: a node within the pieces
    parts them."""
    found: dict[int, NaturalFrequency] = {}
    if len(brackets) < MANY:
        return found
    for part in PARTS:
        low, high = (system.numbers(getattr(one, end) for one in brackets.values()) for end in ("low", "high"))
        nodes = divided_at_poles(system, low, high, part)
        near = (high - low) / 2
        clear = (nodes.held(low - near) == nodes.held(high + near)).all(axis=0)
        apart = {i: brackets[i] for i, free in zip(list(brackets), clear, strict=True) if free}
        found = better(found, _polished(nodes, apart))
        brackets = {i: one for i, one in brackets.items() if not _sure(found, i)}
        if len(brackets) < MANY:
            break
    return found


def certified(system: "ContinuousSystem", z: np.ndarray, x: np.ndarray, indices: Sequence[int],
              wanted: np.ndarray) -> dict[int, NaturalFrequency]:
    """Roots with the bound that counts on both sides of each prove; without those they do not."""
    chosen = np.flatnonzero(wanted)
    z, x, numbers, sound = z[chosen], x[:, chosen], np.array(indices)[chosen], np.ones(len(chosen), bool)
    for _ in range(PASSES):     # the shape and the inertia are those at the last z
        entries, sizes, slope = system.dynamic_stiffness(z)
        x = settled(system, z, entries, x)
        inertia = abs(quadratic(system.pattern, slope, x))
        sound &= inertia > 0                    # a step that ran into a pole leaves no shape
        inertia = np.where(inertia > 0, inertia, 1)
        moved = quadratic(system.pattern, entries, x) / inertia
        z = z + moved
        if (abs(moved) <= 16 * system.unit * abs(z)).all():
            break
    scale = scales(system, z, sizes, slope)
    whole = x / np.sqrt(inertia)
    blurred, felt = blurring(system, z, whole, sizes, scale), abs(x) * scale
    x = np.where(felt > NOTHING * system.unit * felt.max(axis=0, initial=0), x, 0 * x)
    error = np.maximum(system.fine + _rounded_tension(system, z), blurred.sum(axis=0))
    proved, left = np.zeros(len(numbers), bool), np.flatnonzero(sound & (z != 0))
    while len(left := left[error[left] < WIDEST]):
        away = 2 * error[left] * abs(z[left])
        beside = count(system, np.concatenate([z[left] - away, z[left] + away]))
        good = (beside.above[:len(left)] < numbers[left]) & (beside.below[len(left):] >= numbers[left])
        proved[left[good]] = True
        left = left[~good]
        error[left] *= 2
    bounds = np.where(proved, error + GUARD * system.unit / 3, DOUBTED).astype(float)
    shapes = x / np.sqrt(inertia)
    return {number: NaturalFrequency(number, z[at], float(bounds[at]), system.in_scene(shapes[:, at]), system,
                                     whole=whole[:, at],
                                     blurred=np.sqrt(blurred[:, at].astype(float)))
            for at, number in enumerate(numbers.tolist())}


def blurring(system: "ContinuousSystem", z: np.ndarray, x: np.ndarray, sizes: np.ndarray, scale: np.ndarray
             ) -> np.ndarray:
    """What rounds in each coordinate of shapes x, xᵀD′x = 1, as a part of √|z|, (n, number of z)."""
    return cast("np.ndarray", abs(x) ** 2 * rounding(system, sizes, scale) * SLACK / abs(z))


def _rounded_tension(system: "ContinuousSystem", z: np.ndarray) -> np.ndarray:
    """What the rounding of the largest tension along a piece is of √z where it nearly vanishes at an end: waves, whose
    u′² there goes with N^(−3/2), feel it by √(N₁/N₀), as long as there is one of them between."""
    found = np.zeros(len(z))
    for piece in (placed.piece for placed in system.pieces if placed.piece.order == 2 and placed.piece.gradient):
        least, most = sorted(abs(float(x)) for x in (piece.tension, piece.tension + piece.gradient * piece.length))
        if least > NIL * most:
            waves = 2 * np.sqrt(abs(z).astype(float) * float(piece.inertia) * most) / abs(float(piece.gradient))
            found = np.maximum(found, np.minimum(np.sqrt(most / least), waves))
    return system.unit * found


def _local(counts: KnownCounts, bracket: Bracket, members: Sequence[int]) -> dict[int, NaturalFrequency]:
    """The roots within a tight bracket, or one with a pole; PhysicsError where the kinetic energy of shapes is no
    number."""
    try:
        system, z, x, indices = local_modes(counts.system, bracket)
    except np.linalg.LinAlgError:
        raise PhysicsError("the data are so far apart that floats do not hold what the modes of members are found by",
                           "look for lengths and stiffnesses of very different size") from None
    if len(z) < len(indices):
        return {}
    wanted = np.array([i in members for i in indices])
    return certified(system, z, x, indices, wanted)
