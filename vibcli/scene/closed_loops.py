"""Closed loops in numbers: the dependent coordinates z(q) of G(q, z, t) = 0, by Newton's method along a path.

A step from a known position is taken whole where Newton's steps contract fast, and halved where they do not, or where
z or det ∂G/∂z change by much; det ∂G/∂z keeps its sign. So a linkage does not jump from one way of closing to another,
nor pass a dead centre or places at which it does not close.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

CONTRACTION, SHORTEST, ROUNDS = 0.25, 2.0**-12, 40
FINE, CHANGE, CALM = 2.0**-10, 0.7, 0.2     # a step that need not be near its end; of log |det ∂G/∂z|
FAR, BEND = 0.5, 0.1        # of a size: by which z moves, and by which it does so differently, at one of many instants
ALONG = 1e-14       # of its size: what is left of a step


class Loops:
    """Conditions G = 0 in the plain symbols of coordinates, unknowns z, slopes ∂G/∂z in one list, row by row, and the
    size of each unknown; `used`: the names of all symbols in them."""

    __slots__ = ("_used", "conditions", "names", "sizes", "slopes")

    def __init__(self, names: Sequence[str], conditions: "Sequence[Node]", slopes: "Sequence[Node]",
                 sizes: Sequence[float], used: set[str] | None = None) -> None:
        self.names, self.conditions, self.slopes, self.sizes = list(names), conditions, slopes, sizes
        self._used = used or {node.name for node in reachable([*conditions, *slopes]) if node.op == "symbol"}

    def with_sizes(self, unit_of: "Callable[[str], float]") -> "Loops":
        """The same with other sizes, unit_of(unknown)."""
        return Loops(self.names, self.conditions, self.slopes, list(map(unit_of, self.names)), self._used)

    def followed(self, start: Mapping[str, float], target: Mapping[str, float]) -> dict[str, float]:
        """{name: float} of `target` ({name: float}) with z, along the straight path from the position `start`; None
        where the loops cannot follow. What `start` leaves open, as a drawn position that is driven away from at once,
        is closed on the way."""
        start, target = self._in_floats(start), self._in_floats(target)
        n, gaps = len(self.names), evaluate(self.conditions, Floats, start)
        moving = [name for name in target if name not in self.names and target[name] != start.get(name, target[name])]
        here, done, step, (sense, log) = dict(start), 0.0, 1.0, self._determinant(start)
        through = (0.5, 1.0) if self._time in moving else (1.0,)        # what swings may be back at the end of a step
        while done < 1.0:
            trial, last, reach = here, log, min(1.0, done + step)
            for share in through:
                at = reach if share == 1.0 else done + share * (reach - done)
                place = {name: target[name] if at == 1.0 else (1 - at) * start[name] + at * target[name]
                         for name in moving}
                before, trial = trial, {**target, **{name: trial[name] for name in self.names}, **place}
                turned, found = self._determinant(trial) if self._closed(
                    trial, n, [(1.0 - at) * gap for gap in gaps]) else (None, 0.0)
                if turned != sense or not (step <= FINE or self._is_near(before, trial, found - last)):
                    step *= 0.5
                    break
                last = found
            else:
                step = 2 * step if abs(last - log) <= CALM else step
                here, done, log = trial, reach, last
            if step < SHORTEST:
                return None
        if moving or not n:
            return here
        polished = {**target, **{name: here[name] for name in self.names}}
        return polished if self._closed(polished, n) else None

    @property
    def _time(self) -> str | None:
        """The name of the time, None where there is none."""
        time = self.conditions[0].table.time if self.conditions else None
        return None if time is None else time.name

    def _in_floats(self, values: Mapping[str, float]) -> dict[str, float]:
        """The values with those on which the conditions hang taken as they are."""
        return {name: float(value) if name in self._used else value for name, value in values.items()}

    def _determinant(self, values: Mapping[str, float]) -> tuple[float, float]:
        """The sign of det ∂G/∂z, which changes where the loops are singular, and log |det ∂G/∂z|; NaN where that is no
        number."""
        import numpy as np

        n = len(self.names)
        flat = evaluate(self.slopes, Floats, values)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.linalg.slogdet(np.array(flat).reshape(n, n))

    def _is_near(self, here: Mapping[str, float], there: Mapping[str, float], change: float) -> bool:
        """Do z and det ∂G/∂z, whose logarithm changes by so much, differ little between two positions?"""
        moves = (abs(there[name] - here[name]) / size for name, size in zip(self.names, self.sizes, strict=True))
        return abs(change) <= CHANGE and all(move <= FAR for move in moves)

    def _closed(self, values: dict[str, float], n: int, gaps: float | list[float] = 0.0) -> bool:
        """Newton's method for G = gaps, in place; False where it does not contract from the first step on."""
        import numpy as np

        before = None
        for _ in range(12):
            flat = evaluate([*self.conditions, *self.slopes], Floats, values)
            G, Gz = np.array(flat[:n]), np.array(flat[n:]).reshape(n, n)
            if not np.isfinite(flat).all():
                return False
            try:
                step = self._step(Gz[None], (gaps - G)[None])[0]
            except np.linalg.LinAlgError:
                return False
            for name, change in zip(self.names, step, strict=True):
                values[name] += float(change)
            size = float(np.max(np.abs(step) / np.array(self.sizes, float)))
            if size <= 1e-16:
                return True
            if before is not None and size > CONTRACTION * before:
                return size <= 1e-12
            before = size
        return False

    def _step(self, Gz: "np.ndarray", right: "np.ndarray") -> "np.ndarray":
        """z of Gz z = right, one or more: with pivots that are the same in all units."""
        import numpy as np

        columns = np.ldexp(1.0, np.frexp(np.array(self.sizes, float))[1])
        scaled = Gz * columns
        rows = np.ldexp(1.0, -np.frexp(np.abs(scaled).max(axis=2))[1])
        z: np.ndarray = columns * np.linalg.solve(scaled * rows[:, :, None], (right * rows)[:, :, None])[:, :, 0]
        return z

    def through(self, start: Mapping[str, float], path: "Mapping[str, np.ndarray]") -> "np.ndarray":
        """The unknowns at positions {name: array} one after the other, (unknowns, positions), from a closed one on: at
        as many at once as a whole step reaches. Fewer positions where the loops cannot follow to the next."""
        import numpy as np

        here, count, reach = self._in_floats(start), len(next(iter(path.values()))), 1
        found, first = np.empty((len(self.names), count)), 0
        while first < count:
            near = {name: values[first:first + reach] for name, values in path.items()}
            z = self._closed_at_once(here, found[:, first - 2], near) if first > 1 else found[:, :0]
            if z.shape[1]:
                here.update({name: float(values[z.shape[1] - 1]) for name, values in near.items()})
                here.update(zip(self.names, map(float, z[:, -1]), strict=True))
            else:
                one = self.followed(here, {**here, **{name: float(values[0]) for name, values in near.items()}})
                if one is None:
                    return found[:, :first]
                here, z = one, np.array([[one[name]] for name in self.names])
            found[:, first:first + z.shape[1]] = z
            first, reach = first + z.shape[1], 2 * reach if z.shape[1] == reach else max(1, z.shape[1])
        return found

    def _closed_at_once(self, here: Mapping[str, float], earlier: "np.ndarray",
                        path: "Mapping[str, np.ndarray]") -> "np.ndarray":
        """The unknowns at positions to which Newton's method leads from one in whole steps, up to the first to which it
        does not, or at which they do not go on as from an `earlier` one."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays

        n, count = len(self.names), len(next(iter(path.values())))
        z, closed, size = np.array([np.full(count, here[name]) for name in self.names]), np.zeros(count, bool), np.inf
        lost, sizes = np.zeros(count, bool), np.array(self.sizes, float)[:, None]
        for _ in range(12):
            at = {**here, **path, **dict(zip(self.names, z, strict=True))}
            flat = np.array([np.broadcast_to(x, count) for x in evaluate([*self.conditions, *self.slopes], Arrays, at)])
            lost |= ~np.isfinite(flat).all(axis=0)
            Gz = np.where(lost, np.eye(n).reshape(-1, 1), flat[n:]).T.reshape(count, n, n)
            try:
                step = self._step(Gz, -np.where(lost, 0.0, flat[:n]).T).T
            except np.linalg.LinAlgError:
                return z[:, :0]
            z, before, size = np.where(closed, z, z + step), size, np.abs(step / sizes).max(axis=0)
            slow = size > CONTRACTION * before
            closed |= ~lost & ((size <= 1e-16) | (slow & (size <= 1e-12)))
            lost |= ~closed & slow
            if (closed | lost).all():
                break
        at = {**here, **path, **dict(zip(self.names, z, strict=True))}
        flat = np.array([np.broadcast_to(x, count) for x in evaluate(self.slopes, Arrays, at)])
        sense, first = self._determinant(here)
        with np.errstate(invalid="ignore", divide="ignore"):
            turned, last = np.linalg.slogdet(flat.T.reshape(count, n, n))
            calm = abs(np.diff(last, prepend=first)) <= CHANGE
        known = np.array([[x, here[name]] for name, x in zip(self.names, earlier, strict=True)])
        moves = np.diff(z, axis=1, prepend=known)
        bends = np.abs(np.diff(moves / sizes, axis=1)) <= BEND
        good = closed & (turned == sense) & calm & (np.abs(moves[:, 1:] / sizes) <= FAR).all(axis=0) & bends.all(axis=0)
        return z[:, :count if good.all() else int(np.argmin(good))]

    def along(self, start: Mapping[str, float], values: Mapping[str, float]) -> "dict[str, np.ndarray] | None":
        """{name: array} of the unknowns for arrays of coordinates and instants near the closed position `start`; None
        where Newton's method does not find them."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays

        n, shape = len(self.names), np.broadcast_shapes(*(np.shape(value) for value in values.values()))
        z = np.array([np.full(shape, start[name]) for name in self.names])
        for _ in range(ROUNDS):
            at = {**values, **dict(zip(self.names, z, strict=True))}
            flat = [np.broadcast_to(x, shape) for x in evaluate([*self.conditions, *self.slopes], Arrays, at)]
            G, Gz = np.array(flat[:n]).T, np.array(flat[n:]).reshape(n, n, *shape).transpose(2, 0, 1)
            step = self._step(Gz, -G).T
            z = z + step
            if not np.isfinite(z).all():
                return None
            if not (ALONG * (np.array(self.sizes) + np.abs(z.T)) < np.abs(step).T).any():
                return dict(zip(self.names, z, strict=True))
        return None

    def refined(self, values: "dict[str, mpmath.mpf]", arithmetic: Any) -> "dict[str, mpmath.mpf]":
        """The same in mpmath at the working precision, from float values close to the solution; in place."""
        import mpmath

        n = len(self.names)
        for _ in range(ROUNDS):
            flat = evaluate([*self.conditions, *self.slopes], arithmetic, values)
            matrix = mpmath.matrix([[flat[n + i * n + j] for j in range(n)] for i in range(n)])
            step = mpmath.lu_solve(matrix, mpmath.matrix([-g for g in flat[:n]]))
            for name, change in zip(self.names, step, strict=True):
                values[name] += change
            if max(map(abs, step)) <= 100 * mpmath.eps * (1 + max(abs(values[name]) for name in self.names)):
                return values
        raise PhysicsError("the loops of this scene do not close to more digits", "ask for fewer digits")


def nearby(scene: "Scene", attempt: int) -> dict[str, float]:
    """A closed position near the drawn one, other at each attempt; None where the loops do not close there."""
    start = scene.drawn_values
    target = dict(start)
    for i, q in enumerate(q for q in scene.q if q not in scene.inputs):
        target[q.name] += 0.01 * (1 + (7 * i + 3 * attempt) % 5) * (-1) ** (i + attempt) * scene.unit_of(q.name)
    return scene.loops.followed(start, target) if scene.loops else target
