"""What rounding on the way does to a key: slopes along the lines of the worked solution, for all variants at once.

A student rounds what the lines tell to three figures. Of a line v = F(u, p), which follows from earlier lines u and
given values p, the lines themselves are known as expressions of p: the slopes ∂ln F/∂ln u are those with which the
slopes of ln u along the given values make up that of ln v; of lines u that hang on one another the first count. One
sweep backwards over the lines then gives the error a within which each is carried to the key.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.homework.keys import AnswerKey
    from vibcli.language.given_values import GivenValue
    from vibcli.report.steps.step import WorkedLine
    from vibcli.results.problem import Problem

FIGURES = 3                                     # to which lines are rounded
STEP = 1e-5                                     # relative: of differences
ALIKE = 1e-6                                    # of slopes in logarithms
POWERS = 0.5, 1.0, 1.5, 2.0, 3.0                # of a line in a formula that other values enter as well


def shares_of(problem: "Problem", keys: "Sequence[AnswerKey]",
              values: "Sequence[Mapping[str, GivenValue]]") -> "list[np.ndarray | None]":
    """Of each key Σ a and Σ a² of what lines of its solution carry to it, relative to it, in variants with these values
    of the parameters of a scene with numbers, as an array 2 × variants; None of a key that no line tells."""
    given = {name: np.array([float(one[name].exact) for one in values]) for name in values[0]}
    return Rounding(problem).shares(keys, given)


class Rounding:
    """The lines with numbers of a scene's worked solution, as expressions of what is given; none where it has none."""

    def __init__(self, problem: "Problem"):
        self._problem, self._lines = problem, _lines(problem)
        numbers = {line.number: i for i, (line, _) in enumerate(self._lines)}
        self._uses = [[numbers[one] for one in uses] for _, uses in self._lines]

    def line(self, key: "AnswerKey") -> int | None:
        """The number among the lines of that which tells a key; None where none does."""
        return next((i for i, (line, _) in enumerate(self._lines) if line.settles == key.text), None)

    def shares(self, keys: "Sequence[AnswerKey]", given: "Mapping[str, np.ndarray]") -> "list[np.ndarray | None]":
        """The same over arrays of given values, {parameter: SI}."""
        ends = [self.line(key) for key in keys]
        if not self._lines or all(end is None for end in ends):
            return [None] * len(keys)
        values, slopes = self._slopes(given)
        weights = [_weights(slopes[i], [slopes[j] for j in uses]) for i, uses in enumerate(self._uses)]
        rounded = [_half_a_unit(value) for value in values]
        return [None if end is None else _carried(end, self._uses, weights, rounded) for end in ends]

    def _slopes(self, given):
        """(values of the lines, ∂ln|v|/∂ln p of each as an array variants × parameters)."""
        free = [name for name in self._problem.spec.independent_parameters
                if name in given or name in self._problem.numeric.floats]
        values = self._values(given)
        slopes = []
        for name in free:
            at = given.get(name, self._problem.numeric.floats[name] if name not in given else None)
            up, down = (self._values({**given, name: at * (1 + sign * STEP)}) for sign in (1, -1))
            with np.errstate(all="ignore"):
                ratios = [np.log(np.abs(a / b)) / (2 * STEP) for a, b in zip(up, down, strict=True)]
            slopes.append([np.nan_to_num(one, nan=0.0, posinf=0.0, neginf=0.0) for one in ratios])
        return values, [np.stack([by[i] for by in slopes], axis=-1) for i in range(len(values))]

    def _values(self, given):
        scene = self._problem.scene
        known = {name: float(value) for name, value in self._problem.numeric.given.items()}
        numbers = scene.parameters.values(Arrays, {**known, **given})
        count = max((np.size(value) for value in given.values()), default=1)
        with np.errstate(all="ignore"):
            found = evaluate([line.node for line, _ in self._lines], Arrays, numbers)
        return [np.broadcast_to(np.asarray(value, dtype=float), (count,)) for value in found]


def _lines(problem: "Problem") -> "list[tuple[WorkedLine, list[int]]]":
    """(line, numbers of the lines with numbers that it follows from, by others without numbers too)."""
    from vibcli.report.steps.worked import worked

    try:
        told = worked(problem)
    except (PhysicsError, SpecError):
        return []
    with_numbers = [line for line in told if line.value and line.node is not None and _known(problem, line.node)]
    valued = {line.number for line in with_numbers}
    reach: dict[int, dict[int, None]] = {}
    found = []
    for line in told:
        uses: dict[int, None] = {}
        for one in line.uses:
            uses |= {one: None} if one in valued else reach.get(one, {})
        reach[line.number] = uses
        if line in with_numbers:
            found.append((line, list(uses)))
    return found


def _known(problem: "Problem", node: Any) -> bool:
    """Is an expression one of the parameters of the scene alone, with the value that it has there?"""
    try:
        value, = evaluate([node], Arrays, problem.numeric.floats)
    except KeyError:
        return False
    return bool(np.isfinite(value))


def _weights(slope: np.ndarray, used: "list[np.ndarray]") -> "list[np.ndarray]":
    """∂ln F/∂ln u of each line used, over the variants: exactly, where the lines make it up; else by the power that
    leaves most of the given values out."""
    if not used:
        return []
    first = _independent(used)
    if len(first) < len(used):
        known = iter(_weights(slope, [used[j] for j in first]))
        return [next(known) if j in first else np.zeros(slope.shape[0]) for j in range(len(used))]
    basis = np.stack(used, axis=-1)
    found = np.einsum("vup,vp->vu", np.linalg.pinv(basis, rcond=1e-7), slope)
    left = slope - np.einsum("vpu,vu->vp", basis, found)
    if np.max(np.abs(left)) <= ALIKE * max(1.0, float(np.max(np.abs(slope)))):
        return list(np.moveaxis(found, -1, 0))
    return [np.full(slope.shape[0], _power(slope, one)) for one in used]


def _independent(used):
    """The numbers of the lines, the first first, whose slopes do not make up one another."""
    found: list[int] = []
    for j, one in enumerate(used):
        basis = np.stack([used[i][0] for i in found] + [one[0]], axis=-1)
        if np.linalg.matrix_rank(basis, tol=ALIKE * max(1.0, float(np.abs(basis).max()))) > len(found):
            found.append(j)
    return found


def _power(slope, one):
    """The power of a line for which most given values drop out of what is left; 1 where none does."""
    powers = [sign * power for power in POWERS for sign in (1, -1)]
    here = np.abs(one) > ALIKE
    gone = [int(np.sum(here & (np.abs(slope - power * one) <= ALIKE))) for power in powers]
    return abs(powers[int(np.argmax(gone))]) if max(gone) else 1.0


def _half_a_unit(value: np.ndarray) -> np.ndarray:
    """Half a unit of the third figure, relative to the value."""
    size = np.abs(value)
    with np.errstate(all="ignore"):
        found = 0.5 * 10.0**(np.floor(np.log10(size)) - FIGURES + 1) / size
    return np.nan_to_num(found, nan=0.0, posinf=0.0)


def _carried(end: int, uses: "list[list[int]]", weights: "list[list[np.ndarray]]",
             rounded: "list[np.ndarray]") -> np.ndarray:
    """Σ a and Σ a² of what the lines before carry to the line `end`, relative to it: an array 2 × variants."""
    carry = [np.zeros_like(one) for one in rounded]
    carry[end] = np.ones_like(rounded[end])
    for i in range(end, -1, -1):
        for j, weight in zip(uses[i], weights[i], strict=True):
            carry[j] = carry[j] + carry[i] * weight
    parts = np.array([np.abs(carry[j]) * rounded[j] for j in range(end)]) if end else np.zeros((1, len(carry[end])))
    return np.array([parts.sum(0), (parts**2).sum(0)])
