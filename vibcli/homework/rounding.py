"""What rounding on the way does to a key: slopes along the lines of the worked solution, for all variants at once.

A student rounds what the lines tell to three figures. Of a line v = F(u, p) that is printed by letters u of earlier
lines the slopes ∂ln F/∂ln u are those of what is printed; of one in given values p alone, which follows from earlier
lines u, they are those with which the slopes of ln u along p make up that of ln v; of lines u that hang on one another
the first count. One sweep backwards over the lines then gives the error a within which each is carried to the key.
What the figures hold exactly is not rounded, what is the same in all variants always by as much, and what takes few
values by as much as these.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.homework.bands import FIGURES
from vibcli.homework.line_values import STEP, LineValues
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.homework.keys import AnswerKey
    from vibcli.language.given_values import GivenValue
    from vibcli.results.problem import Problem

EXACT = 1e-9                                    # relative: what is no rounding
FEW, SOME = 10, 50                              # values of a line, in ten times as many variants; looked at first
READ_OFF = {"frequency": "omega", "period": "omega", "period_d": "omega_d", "decrement": "zeta"}     # of a mode
ALIKE = 1e-6                                    # of slopes in logarithms
POWERS = 0.5, 1.0, 1.5, 2.0, 3.0                # of a line in a formula that other values enter as well


def shares_of(problem: "Problem", keys: "Sequence[AnswerKey]", values: "Sequence[Mapping[str, GivenValue]]"
              ) -> "list[np.ndarray | None]":
    """Of each key Σ a, Σ a², Σ a⁴ and the largest a of what lines of its solution carry to it that are rounded to 3, 4
    and 5 figures, relative to it, in variants with these values of the parameters of a scene with numbers, as an array
    3 × 4 × variants; None of a key that no line tells."""
    return Rounding(problem).shares(keys, arrays(values))


def arrays(values: "Sequence[Mapping[str, GivenValue]]") -> "dict[str, np.ndarray]":
    """{parameter: array over the variants, in SI units}."""
    return {name: np.array([float(one[name].exact) for one in values]) for name in values[0]}


class Rounding:
    """How the lines with numbers of a scene's worked solution hang on one another; none where it has none."""

    def __init__(self, problem: "Problem"):
        self.known = LineValues(problem)

    def end(self, key: "AnswerKey", values: "Sequence[np.ndarray] | None" = None
            ) -> "tuple[int, float | np.ndarray] | None":
        """(number of the line that tells a key, or from which it is read off; 0 of the first, ∂ln key/∂ln line of the
        second); None where none does. values: of the lines."""
        if (line := self.known.number(key.text)) is not None:
            while self.known.again(line):
                line = self.known.letters[line][0]
            return line, 0.0
        tree = key.asked.tree
        head = READ_OFF.get(tree.head) if isinstance(tree, QuantityRef) and len(tree.indices) == 1 else None
        line = None if head is None else self.known.number(f"{head}[{tree.indices[0]}]")
        if line is None or values is None or head != "zeta":
            return None if line is None else (line, 1.0)
        return line, 1 / (1 - values[line]**2)

    def shares(self, keys: "Sequence[AnswerKey]", given: "Mapping[str, np.ndarray]") -> "list[np.ndarray | None]":
        """The same over arrays of given values, {parameter: SI}."""
        if all(self.end(key) is None for key in keys):
            return [None] * len(keys)
        return self.carried(keys, *self.weighed(given))

    def carried(self, keys: "Sequence[AnswerKey]", values: "Sequence[np.ndarray]",
                weights: "list[list[np.ndarray]]") -> "list[np.ndarray | None]":
        """The same of lines with these values and weights."""
        rounded, found = [self.rounded(values, figures) for figures in FIGURES], []
        for key in keys:
            share, end = None, self.end(key, values)
            if end is not None and np.isfinite(values[end[0]]).all():
                line, slope = end
                ends = {line: slope} if np.any(slope) else dict(zip(self.uses[line], weights[line], strict=True))
                share = _carried(ends, self.uses, weights, rounded)
            found.append(share if share is not None and np.isfinite(share).all() else None)
        return found

    @property
    def uses(self) -> "list[list[int]]":
        """The numbers of the lines that each follows from."""
        return [letters or uses for letters, uses in zip(self.known.letters, self.known.uses, strict=True)]

    def weighed(self, given: "Mapping[str, np.ndarray]") -> "tuple[list[np.ndarray], list[list[np.ndarray]]]":
        """(the values of the lines, ∂ln F/∂ln u of each line used by each)."""
        known = self.known
        values, numbers = known.values(given), known.parameters(given)
        slopes = self._slopes(given, values) if any(known.uses) else []
        return values, [known.by_letters(i, numbers, values) if known.letters[i] else
                        _weights(slopes[i], [slopes[j] for j in known.uses[i]]) if known.uses[i] else []
                        for i in range(len(known.lines))]

    def _slopes(self, given: "Mapping[str, np.ndarray]", values: "Sequence[np.ndarray]") -> "list[np.ndarray]":
        """∂ln|v|/∂ln p of each line as an array variants × parameters."""
        found, floats = [], self.known.problem.numeric.floats
        for name in self.known.free:
            at = given.get(name, floats[name])
            up, down = (self.known.values({**given, name: at * (1 + sign * STEP)}, values) for sign in (1, -1))
            with np.errstate(all="ignore"):
                ratios = [np.log(np.abs(a / b)) / (2 * STEP) for a, b in zip(up, down, strict=True)]
            found.append([np.nan_to_num(one, nan=0.0, posinf=0.0, neginf=0.0) for one in ratios])
        return [np.stack([by[i] for by in found], axis=-1) for i in range(len(values))]

    def rounded(self, values: "Sequence[np.ndarray]", figures: int) -> "list[np.ndarray]":
        """Half a unit of the last figure of each line, relative to it; 0 where it, and what it is found from, has no
        more figures. Of those that follow from none that is rounded and take few values, what these are off by
        counts."""
        inexact: list[np.ndarray] = []
        found = []
        for i, (value, uses) in enumerate(zip(values, self.uses, strict=True)):
            half = _half_a_unit(value, figures)
            with np.errstate(all="ignore"):
                unit = 2 * half * np.abs(value)
                off = np.nan_to_num(np.abs(np.round(value / unit) * unit / value - 1))
            inexact.append(np.logical_or.reduce([off > EXACT, *(inexact[j] for j in uses)]))
            half = half if any(inexact[j].any() for j in uses) else _of_few_values(value, half, off)
            found.append(half * (inexact[-1] & (not self.known.again(i))))
        return found


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


def _independent(used: "list[np.ndarray]") -> list[int]:
    """The numbers of the lines, the first first, whose slopes do not make up one another."""
    found: list[int] = []
    for j, one in enumerate(used):
        basis = np.stack([used[i][0] for i in found] + [one[0]], axis=-1)
        if np.linalg.matrix_rank(basis, tol=ALIKE * max(1.0, float(np.abs(basis).max()))) > len(found):
            found.append(j)
    return found


def _power(slope: np.ndarray, one: np.ndarray) -> float:
    """The power of a line for which most given values drop out of what is left; 1 where none does."""
    powers = [sign * power for power in POWERS for sign in (1, -1)]
    here = np.abs(one) > ALIKE
    gone = [int(np.sum(here & (np.abs(slope - power * one) <= ALIKE))) for power in powers]
    return abs(powers[int(np.argmax(gone))]) if max(gone) else 1.0


def _half_a_unit(value: np.ndarray, figures: int) -> np.ndarray:
    """Half a unit of the last figure, relative to the value."""
    size = np.abs(value)
    with np.errstate(all="ignore"):
        found = 0.5 * 10.0**(np.floor(np.log10(size)) - figures + 1) / size
    return cast("np.ndarray", np.nan_to_num(found, nan=0.0, posinf=0.0))


def _of_few_values(value: np.ndarray, half: np.ndarray, off: np.ndarray) -> np.ndarray:
    """By how much a line with few values in all variants is off: with one value as much as that; with few in many
    variants as an even error with their mean square. Half a unit of others."""
    if len(value) == 1:
        return half
    count = _distinct(value[::max(1, len(value) // SOME)])
    count = count if count > FEW else _distinct(value)
    if count == 1:
        return off
    if not 1 < count <= FEW <= len(value) / FEW:
        return half
    size: float = np.sqrt(3 * np.mean((off / half)**2))
    return half * size


def _distinct(value: np.ndarray) -> int:
    """How many values there are but for rounding; 0 where one is unknown or all are zero."""
    largest = np.max(np.abs(value))
    return len(np.unique(np.round(value / (EXACT * largest)))) if largest > 0 else 0


def _carried(ends: "Mapping[int, float | np.ndarray]", uses: "list[list[int]]", weights: "list[list[np.ndarray]]",
             rounded: "list[list[np.ndarray]]") -> np.ndarray:
    """Σ a, Σ a², Σ a⁴ and the largest a of what the lines carry to what hangs on some of them, {line: slope}, relative
    to it: an array 4 × variants for each way to round."""
    carry = [np.zeros_like(one) + ends.get(i, 0.0) for i, one in enumerate(rounded[0])]
    for i in (i for i in reversed(range(len(carry))) if np.any(carry[i])):
        for j, weight in zip(uses[i], weights[i], strict=True):
            carry[j] = carry[j] + carry[i] * weight
    parts = [np.abs(np.array(carry)) * np.array(one) for one in rounded]
    return np.array([[a.sum(0), (a**2).sum(0), (a**4).sum(0), a.max(0)] for a in parts])
