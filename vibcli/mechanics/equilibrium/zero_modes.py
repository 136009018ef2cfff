"""What a zero frequency means: free motion, or a restoring force beyond the linear one.

Along a direction d in which K vanishes, V(q + t d + w) − V(q) at a few t tells a motion that costs no energy (a
rigid-body mode) from one that terms of third and higher order hold or drive away (V = x⁴, V = −x⁴, V = x³). What has
stiffness follows: w across d is where its forces balance, since along (y − x²)² − x⁴/2 the way down is bent. Of several
such directions their mixtures are looked at too (V = x⁴ + y⁴ − 3 x² y²).
"""

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

STEPS = (-0.1, -0.02, 0.02, 0.1)
ROUNDING = 1e-11
CORRECTIONS, SETTLED = 12, 1e-13
MIXTURES = (-2.0, -1.0, -0.5, 0.5, 1.0, 2.0)        # of one direction with another
MOST_MIXED = 4
FREE, HELD, FALLING = "free", "held", "falling"


def zero_modes(configuration: "Configuration", rigid: Sequence[Any]) -> dict[int, str]:
    """{index of a mode without frequency: FREE, HELD or FALLING}."""
    if configuration.system.is_linear:
        return dict.fromkeys((mode.index for mode in rigid), FREE)
    from vibcli.mechanics.equilibrium.families import freedom, learnt

    if freedom(configuration.equilibrium, learnt(configuration.numeric)) == len(rigid):    # on curved lines too
        return dict.fromkeys((mode.index for mode in rigid), FREE)
    sizes = np.array(list(map(configuration.numeric.size_along, configuration.scene.coordinates)))
    shapes = [np.real(np.asarray(mode.shape, dtype=complex)) / sizes for mode in rigid]
    valley = Valley(configuration, sizes, shapes)
    found = {mode.index: valley.kind(shape) for mode, shape in zip(rigid, shapes, strict=True)}
    if FALLING not in found.values() and any(valley.kind(mixture) == FALLING for mixture in _mixtures(shapes)):
        found[rigid[0].index] = FALLING
    return found


def _mixtures(shapes: list[np.ndarray]) -> Iterator[np.ndarray]:
    """Mixtures of each two of the first directions."""
    unit = [shape / np.abs(shape).max() for shape in shapes[:MOST_MIXED]]
    for one, other in combinations(unit, 2):
        yield from (one + part * other for part in MIXTURES)


class Valley:
    """The bottom along which a scene moves that leaves an equilibrium in directions without stiffness, `shapes` in
    units of `sizes`, while what has stiffness follows."""

    def __init__(self, configuration: "Configuration", sizes: np.ndarray, shapes: Sequence[np.ndarray]) -> None:
        self.configuration, self.sizes, self.system = configuration, sizes, configuration.system
        self.names, self.rest = configuration.scene.coordinates, configuration.equilibrium.values
        _, _, rows = np.linalg.svd(np.array(shapes))
        self.across = rows[len(shapes):].T

    def kind(self, shape: np.ndarray) -> str:
        """FREE, HELD or FALLING along a direction."""
        direction = shape / np.abs(shape).max()
        places = [(step, self.bottom(step * direction)) for step in STEPS]
        gains = list(self._gains(places) if self.system.conservative else self._work_done(places, direction))
        if any(gain < 0 for gain in gains):
            return FALLING
        return HELD if any(gains) else FREE

    def bottom(self, z: np.ndarray) -> dict[str, Any]:
        """{symbol: float} where the forces across balance, by Newton's method; of z itself where they do not."""
        start = z
        for _ in range(CORRECTIONS if self.across.size else 0):
            numbers = in_numbers(self.system.statics, Floats, self.place(z))
            F = self.across.T @ (np.array(numbers.residual, dtype=float) * self.sizes)
            J = self.across.T @ (numbers.elements.stiffness_array() * np.outer(self.sizes, self.sizes)) @ self.across
            step = np.linalg.lstsq(J, -F, rcond=None)[0] if np.isfinite(J).all() and np.isfinite(F).all() else np.inf
            if not np.abs(step).max() < 1.0:
                return self.place(start)
            z = z + self.across @ step
            if np.abs(step).max() <= SETTLED:
                break
        return self.place(z)

    def place(self, z: np.ndarray) -> dict[str, Any]:
        """{symbol: float} of everything at rest, z away from the equilibrium, the loops closed."""
        moved = {name: self.rest[name] + float(x) for name, x in zip(self.names, z * self.sizes, strict=True)}
        closed = self.configuration.numeric.closed(self.rest, {**self.rest, **moved})
        return {**self.configuration.at_rest, **closed}

    def _gains(self, places: Sequence[tuple[float, dict[str, float]]]) -> Iterator[float]:
        """V − V(q) at each place; 0 where it is rounding."""
        scene = self.system.scene
        terms = [term.potential(scene) for term in scene.springs]
        terms += [-term.weight * term.s for term in scene.forces]
        terms += [term.potential(scene) for term in scene.weights] + [scene.energies["V"], -scene.energies["T"]]
        start = evaluate(terms, Floats, self.place(np.zeros(len(self.sizes))))
        for _, place in places:
            parts = [a - b for a, b in zip(evaluate(terms, Floats, place), start, strict=True)]
            size = sum(max(abs(part), abs(whole)) for part, whole in zip(parts, start, strict=True))
            yield _or_none(sum(parts), size)

    def _work_done(self, places: Sequence[tuple[float, dict[str, float]]], direction: np.ndarray) -> Iterator[float]:
        """t r·d at each place, where loads have no potential."""
        along = direction * self.sizes
        for step, place in places:
            numbers = in_numbers(self.system.linearisation, Floats, place)
            rows = zip(numbers.residual, numbers.residual_size, along, strict=True)
            work, size = map(sum, zip(*((r * d * step, abs(s * d * step)) for r, s, d in rows), strict=True))
            yield _or_none(work, size)


def _or_none(value: float, size: float) -> float:
    return value if abs(value) > ROUNDING * size else 0
