"""What bends or jumps with the motion: the switches of a system, and which sense each has at an instant.

A switch is the sign σ of an argument g(t, q, q̇). Where g vanishes, its sense follows from where g is going. Where both
senses drive g back to zero, as dry friction does at rest, the switch slides: −σ₀ ≤ σ ≤ σ₀ is what keeps ġ = 0 (Filippov
1988, §4); q̈ is linear in it. A switch leaves its slide where that σ passes the bound σ₀, 1 if nothing else is given.
"""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.compiled_arrays import Compiled
    from vibcli.symbolic.node import Node

NOTHING = 1e-12         # of what an argument is made of: zero but for rounding
MOST_TOGETHER = 6
SHARED, SLACK = 1e-10, 1e-6     # singular values of switches that hold the same thing; of what they cannot balance


class Switching:
    """The arguments of a system's switches with their rates; bounds: σ₀ of each; names: of what bends with each."""

    def __init__(self, system: "NumericEquations", bounds: "Mapping[Node, Node] | None" = None,
                 names: "Mapping[Node, str] | None" = None) -> None:
        self.system, self.arguments = system, system.switches
        self.names = [(names or {}).get(node, "") for node in self.arguments]
        count = len(self.arguments)
        self.count = count
        if not count:
            return
        found = [system.rate_of(node) for node in self.arguments]
        again = [system.rate_of(drift) for drift, _ in found]
        self._at_speed = [bool(slopes) for _, slopes in found]
        self._rates = [self._compiled(*rate) for rate in found]
        self._seconds = [None if fast else self._compiled(*rate)
                         for fast, rate in zip(self._at_speed, again, strict=True)]
        self._values = system.compiled(self.arguments)
        self._slopes = system.compiled([slope for node in self.arguments for slope in _slopes(system.scene, node)])
        limits = bounds or {}
        limits = dict(zip(limits, evaluate(list(limits.values()), Floats, system.floats), strict=True))
        self.bounds = np.array([limits.get(node, 1.0) for node in self.arguments])
        if len(system.switches) != count:
            raise PhysicsError("a force of this scene bends where another one bends: its rate has kinks of its own",
                               "write it with fewer of abs, sign, min and max")

    def _compiled(self, drift: "Node", slopes: "Mapping[int, Node]") -> "tuple[list[int], Compiled]":
        return list(slopes), self.system.compiled([drift, *slopes.values()])

    def values(self, t: np.ndarray, q: np.ndarray, v: np.ndarray, g: Sequence[float] | np.ndarray) -> np.ndarray:
        """The arguments at instants, of shape (count, instants)."""
        found = np.empty((self.count, q.shape[1]))
        for k, value in enumerate(self._values(t, q, v, g)):
            found[k] = value
        return found

    def rates(self, which: Sequence[int], t: np.ndarray, q: np.ndarray, v: np.ndarray, a: np.ndarray,
              g: Sequence[float | np.ndarray] | np.ndarray) -> np.ndarray:
        """ġ of the switches `which`, of shape (len(which), instants)."""
        return self._along(which, self._terms(which, t, q, v, g), a)

    def _terms(self, which: Sequence[int], t: np.ndarray, q: np.ndarray, v: np.ndarray,
               g: Sequence[float | np.ndarray] | np.ndarray) -> list[tuple[float | np.ndarray, ...]]:
        """What ġ of each switch is made of: its drift, its slopes by q̈."""
        return [self._rates[k][1](t, q, v, g) for k in which]

    def _along(self, which: Sequence[int], terms: Sequence[tuple[float | np.ndarray, ...]],
               a: np.ndarray) -> np.ndarray:
        """ġ of the switches for accelerations."""
        found = np.zeros((len(which), a.shape[1]))
        for row, k, of in zip(found, which, terms, strict=True):
            _add(row, self._rates[k][0], of, a)
        return found

    def sizes(self, t: float, q: np.ndarray, v: np.ndarray, g: Sequence[float] | np.ndarray) -> np.ndarray:
        """What each argument is made of: Σ |∂g/∂x|·|x| at one instant."""
        n = len(q)
        slopes = np.array([float(np.max(value)) for value in self._slopes(np.array([t]), q[:, None], v[:, None], g)])
        found: np.ndarray = np.abs(slopes.reshape(self.count, 2 * n)) @ np.abs(np.concatenate([q, v]))
        return found

    def sliding(self, which: Sequence[int], t: np.ndarray, q: np.ndarray, v: np.ndarray,
                g: Sequence[float] | np.ndarray,
                c: Sequence[np.ndarray] | None = None) -> tuple[np.ndarray, np.ndarray]:
        """(q̈, σ of the switches that slide) at instants: σ of shape (len(which), instants)."""
        accelerations = self.system.accelerations
        g = [0.0 if k in which else sense for k, sense in enumerate(g)]
        a0 = accelerations(t, q, v, g, c)
        turned = []
        for k in which:
            g[k] = 1.0
            turned.append(accelerations(t, q, v, g, c) - a0)
            g[k] = 0.0
        terms = self._terms(which, t, q, v, g)
        held = self._along(which, terms, a0)
        rates = [(0.0, *slopes) for _, *slopes in terms]
        slope = np.array([self._along(which, rates, turn) for turn in turned]).transpose(2, 1, 0)
        sigma = _balancing(slope, -held.T).T
        return a0 + sum(turn * s for turn, s in zip(turned, sigma, strict=True)), sigma

    def settled(self, t: float, q: np.ndarray, v: np.ndarray, before: Sequence[float] | None = None,
                zero: Sequence[int] = (), slides: Sequence[int] = ()) -> tuple[tuple[float, ...], tuple[int, ...]]:
        """(senses, switches that slide) at an instant; `before`: senses until then, None at the start; `zero`: switches
        whose argument is known to vanish, or which leave their slide, being among those that `slides` until then: the
        arguments of these vanish but for drift."""
        if not self.count:
            return (), ()
        g = np.array(before if before is not None else np.ones(self.count))
        q1, v1, t1 = q[:, None], v[:, None], np.array([t])
        values = self.values(t1, q1, v1, g)[:, 0]
        tiny = np.abs(values) <= NOTHING * self.sizes(t, q, v, g)
        tiny[[*zero, *slides]] = True
        g = np.where(tiny, g, np.where(values < 0, -1.0, 1.0))
        slow = [k for k in np.flatnonzero(tiny) if not self._at_speed[k]]
        for k in slow:
            rate = _rate(*self._rates[k], t1, q1, v1, q1, g)[0]
            g[k] = np.sign(rate) or g[k]
        leaving = [k for k in zero if k in slides]
        if leaving:
            sigma = dict(zip(slides, self.sliding(slides, t1, q1, v1, g)[1][:, 0], strict=True))
            g[leaving] = [np.sign(sigma[k]) for k in leaving]
        fast = [k for k in np.flatnonzero(tiny).tolist() if self._at_speed[k]]
        g, slides = self._released(fast, leaving, t1, q1, v1, g) if fast else (g, ())
        for k in slow:
            if not _rate(*self._rates[k], t1, q1, v1, q1, g)[0]:
                a = self.sliding(slides, t1, q1, v1, g)[0] if slides else self.system.accelerations(t1, q1, v1, g)
                g[k] = np.sign(_rate(*self._seconds[k], t1, q1, v1, a, g)[0]) or g[k]
        return tuple(g), tuple(slides)

    def _released(self, fast: list[int], leaving: Sequence[int], t: np.ndarray, q: np.ndarray, v: np.ndarray,
                  g: np.ndarray) -> tuple[np.ndarray, tuple[int, ...]]:
        """Senses of switches of velocities that vanish, and which of them slide: as few are let go as can be, those
        that leave their slide with the sense that they have."""
        if len(fast) > MOST_TOGETHER:
            raise PhysicsError(f"{len(fast)} elements with friction come to rest at the same instant",
                               "friction is followed for at most six at once")
        opposed = self._opposed(fast, t, q, v, g)
        choices = [(g[k],) if k in leaving else (0, 1, -1) if k in opposed else (1, -1) for k in fast]
        ranked = sorted(product(*choices), key=lambda senses: sum(map(abs, senses)))
        for senses in ranked:
            trial = g.copy()
            trial[fast] = [sense or 1.0 for sense in senses]
            slides = tuple(k for k, sense in zip(fast, senses, strict=True) if not sense)
            if slides:
                try:
                    a, sigma = self.sliding(slides, t, q, v, trial)
                except np.linalg.LinAlgError:
                    continue
                if (np.abs(sigma[:, 0]) > self.bounds[list(slides)] * (1 + NOTHING)).any():
                    continue
            else:
                a = self.system.accelerations(t, q, v, trial)
            if all(self._goes(k, t, q, v, a, trial) for k, sense in zip(fast, senses, strict=True)
                   if sense and k not in leaving):
                return trial, slides
        raise PhysicsError(f"at t = {t[0]:.6g} s the forces of friction and what they hang on contradict each other",
                           "mind the normal forces: friction that grows with itself locks")

    def _goes(self, k: int, t: np.ndarray, q: np.ndarray, v: np.ndarray, a: np.ndarray, g: np.ndarray) -> bool:
        """Does the argument of a switch go where its sense says, but for rounding?"""
        places, compiled = self._rates[k]
        drift, *slopes = compiled(t, q, v, g)
        terms = [np.max(drift), *(np.max(slope * a[i]) for i, slope in zip(places, slopes, strict=True))]
        return bool(sum(terms) * g[k] >= -NOTHING * sum(map(abs, terms)))

    def _opposed(self, fast: Sequence[int], t: np.ndarray, q: np.ndarray, v: np.ndarray, g: np.ndarray) -> list[int]:
        """The switches whose σ drives their own argument back."""
        found, state = [], (np.repeat(t, 2), np.repeat(q, 2, axis=1), np.repeat(v, 2, axis=1))
        for k in fast:
            sides = list(g)
            sides[k] = np.array([1.0, -1.0])
            up, down = self.rates([k], *state, self.system.accelerations(*state, sides), sides)[0]
            if up < down:
                found.append(k)
        return found


def _balancing(slope: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """σ with slope·σ = wanted, at all instants: (instants, n, n) and (instants, n). Where several switches share in any
    proportion what is wanted, so that σ is not unique, that with the least Σ |slopeₖₖ| σₖ². LinAlgError where there is
    none."""
    if slope.shape[-1] == 1:
        if not np.all(slope):
            raise np.linalg.LinAlgError
        found: np.ndarray = wanted / slope[:, :, 0]
        return found
    sizes = np.sqrt(np.abs(np.diagonal(slope, axis1=1, axis2=2)))
    if not np.all(sizes):
        return np.linalg.solve(slope, wanted[:, :, None])[:, :, 0]
    scaled = slope / (sizes[:, :, None] * sizes[:, None, :])
    u, s, v = np.linalg.svd(scaled)
    part = np.einsum("tji,tj->ti", u, wanted / sizes)
    alone = s > SHARED * s[:, :1]
    if np.any(np.abs(np.where(alone, 0.0, part)) > SLACK * np.abs(part).max(axis=1, keepdims=True)):
        raise np.linalg.LinAlgError
    part = np.where(alone, part / np.where(alone, s, 1.0), 0.0)
    result: np.ndarray = np.einsum("tji,tj->ti", v, part) / sizes
    return result


def _rate(places: list[Any], compiled: "Compiled", t: np.ndarray, q: np.ndarray, v: np.ndarray, a: np.ndarray,
          g: np.ndarray) -> np.ndarray:
    found = np.zeros(a.shape[1])
    _add(found, places, compiled(t, q, v, g), a)
    return found


def _add(total: np.ndarray, places: Sequence[int], terms: tuple[float | np.ndarray, ...], a: np.ndarray) -> None:
    drift, *slopes = terms
    total += drift
    for i, slope in zip(places, slopes, strict=True):
        total += slope * a[i]


def _slopes(scene: "Scene", node: "Node") -> "list[Node]":
    found = gradient(node)
    return [found.get(x, scene.table.zero) for x in (*scene.q, *scene.v)]
