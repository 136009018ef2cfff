"""Random values of free symbols and random states of motion, at which scenes are compared: the same at every run."""

import random
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.language.parameter_samples import FAR_APART, sample_values, short_fraction
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    import numpy as np

    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

KNOWN: "WeakKeyDictionary[Problem, Any]" = WeakKeyDictionary()      # states that were drawn
STATES, NEAR, SEPARATE, MOST_HALVINGS, CANDIDATES = 5, 1e-4, 12, 30, 40


def random_instances(problem: "Problem") -> "Iterator[Problem]":
    """The problem with random values for its free symbols, whenever the drawing fits together; those of the second half
    far apart, for regimes of large or small ratios."""
    for attempt in range(CANDIDATES):
        values = sample_values(problem.symbolic.letters, attempt)
        spread = FAR_APART if 2 * attempt >= CANDIDATES else 1
        given = {name: short_fraction(value**spread) for name, value in values.items()}
        candidate = problem.with_values(given)
        try:
            candidate.draw()
        except (SpecError, PhysicsError):
            continue
        yield candidate


def states(problem: Any) -> "tuple[dict[str, np.ndarray], list[slice]]":
    """Random states near the drawn position, in groups: {symbol name: array} and the slices of the groups.

    All at random; at rest, near and very near; velocities alone, accelerations alone; one coordinate alone: so a term
    is seen beside those of its kind, however stiff or heavy the rest of the scene is.
    """
    if problem not in KNOWN:
        KNOWN[problem] = _states(problem)
    found: tuple[dict[str, np.ndarray], list[slice]] = KNOWN[problem]
    return found


def _states(problem: "Problem") -> "tuple[dict[str, np.ndarray], list[slice]]":
    import numpy as np

    scene, names = problem.scene, problem.scene.coordinates
    groups: list[Any] = [(1, 1, 1, names), (1, 0, 0, names), (NEAR, 0, 0, names), (0, 1, 0, names), (0, 0, 1, names)]
    if 1 < len(names) <= SEPARATE:
        groups += [(*kind, [name]) for name in names for kind in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    each, found = STATES + 3 * len(names), {}
    units, last = _units(len(names), len(groups) * each)
    for name, rows in zip(names, units, strict=True):
        scale = reach(problem, name)
        for primes, (centre, spread) in enumerate(((problem.numeric.drawn_floats[name], 1), (0.0, 3), (0.0, 9))):
            shares = np.repeat([float(group[primes] * (name in group[3])) for group in groups], each)
            found[name + "'" * primes] = centre + spread * scale * (shares * (2.0 * rows[primes] - 1.0))
    found[scene.time.name] = 3.0 * last
    return _closed(problem, found), [slice(i * each, (i + 1) * each) for i in range(len(groups))]


@lru_cache(8)
def _units(coordinates: int, count: int) -> "tuple[np.ndarray, np.ndarray]":
    """(random numbers from 0 to 1 for the places, velocities and accelerations of so many coordinates, as many for the
    time)."""
    import numpy as np

    generator = random.Random("states")
    found = (generator.random() for _ in range((3 * coordinates + 1) * count))
    rows = np.fromiter(found, float).reshape(-1, count)
    return rows[:-1].reshape(coordinates, 3, count), rows[-1]


def _closed(problem: "Problem", found: "dict[str, Any]") -> "dict[str, np.ndarray]":
    """The states with their dependent coordinates; those whose loops cannot close are drawn nearer, until they can."""
    import numpy as np

    loops, names, time = problem.scene.loops, problem.scene.coordinates, problem.scene.time.name
    if loops is None:
        return found
    start = {**problem.numeric.floats, time: 0.0, **problem.numeric.drawn_floats}
    found |= {name: [] for name in loops.names}
    for i in range(len(next(iter(found.values())))):
        for halving in range(MOST_HALVINGS):
            near = 0.5**halving
            target = {**start, **{name: start[name] + near * (found[name][i] - start[name]) for name in names},
                      **{name: found[name][i] for name in (time,) if name in found}}
            closed = loops.followed(start, target)
            if closed is not None:
                break
        else:
            raise PhysicsError("the loops of this scene do not close near the drawn position", "draw it elsewhere")
        for name in names:
            found[name][i] = closed[name]
        for name in loops.names:
            found[name].append(closed[name])
    return {name: np.array(values) for name, values in found.items()}


def at_states(problem: "Problem", nodes: "Sequence[Node]", states: "Mapping[str, np.ndarray]") -> "list[np.ndarray]":
    """The values of expressions at all states, arrays of one length."""
    import numpy as np

    from vibcli.symbolic.smoothed_functions import smooth_arrays

    count = max(map(len, states.values()))
    with np.errstate(all="ignore"):
        values = evaluate(nodes, smooth_arrays(), {**problem.numeric.floats, **states})
    if not all(np.isfinite(value).all() and np.abs(value).max() < 1e150 for value in values):
        raise PhysicsError("this has no finite value in some positions near the drawn one",
                           "look for roots of what may be negative, and for powers out of range")
    return [np.broadcast_to(value, (count,)) for value in values]


def reach(problem: "Problem", name: str) -> float:
    """How far a random state strays: a fraction of the figure, or of a radian."""
    return 0.2 * problem.numeric.size_along(name) if problem.system.dimension(name) else 0.3
