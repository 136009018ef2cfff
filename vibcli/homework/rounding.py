"""What rounding on the way does to a key: slopes along the lines of the worked solution, for all variants at once.

A student rounds what the lines tell to three figures. Of a line v = F(u, p), which follows from earlier lines u and
given values p, the lines themselves are known as expressions of p: the slopes ∂ln F/∂ln u are those with which the
slopes of ln u along the given values make up that of ln v; of lines u that hang on one another the first count. A key
that is a root, found from lines, counts by these likewise, its slopes being those of solutions. One sweep backwards
over the lines then gives the error a within which each is carried to the key; what three figures hold exactly is not
rounded.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import log
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.printed import with_given
from vibcli.language.given_values import giver, number_and_unit
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.homework.keys import AnswerKey
    from vibcli.language.given_values import GivenValue
    from vibcli.report.steps.step import WorkedLine
    from vibcli.results.problem import Problem

FIGURES = 3                                     # to which lines are rounded
STEP = 1e-5                                     # relative: of differences
MADE_UP = 1e-3                                  # relative: what the lines before a root leave of its slopes
EXACT = 1e-9                                    # relative: what is no rounding
FROM = {"frequency": "omega", "period": "omega", "zeta": "eigenvalue", "omega_d": "eigenvalue",
        "period_d": "eigenvalue", "decrement": "eigenvalue"}       # {quantity of a mode: by which line it is told too}
ALIKE = 1e-6                                    # of slopes in logarithms
POWERS = 0.5, 1.0, 1.5, 2.0, 3.0                # of a line in a formula that other values enter as well


def shares_of(problem: "Problem", keys: "Sequence[AnswerKey]", values: "Sequence[Mapping[str, GivenValue]]",
              looked_at: "Sequence[Mapping[str, GivenValue]]") -> "list[np.ndarray | None]":
    """Of each key Σ a, Σ a², Σ a⁴ and the largest a of what lines of its solution carry to it, relative to it, in
    variants with these values of the parameters of a scene with numbers, as an array 4 × variants; None of a key that
    no line tells. looked_at: values at which roots are looked at."""
    rounding = Rounding(problem)
    return rounding.shares(keys, _arrays(values), [rounding.root(key, looked_at) for key in keys])


def _arrays(values):
    """{parameter: array over the variants, in SI units}."""
    return {name: np.array([float(one[name].exact) for one in values]) for name in values[0]}


class Rounding:
    """The lines with numbers of a scene's worked solution, as expressions of what is given; none where it has none."""

    def __init__(self, problem: "Problem"):
        self._problem = problem
        self._lines, self._roots = _lines(problem)
        numbers = {line.number: i for i, (line, _) in enumerate(self._lines)}
        self._uses = [[numbers[one] for one in uses] for _, uses in self._lines]
        self._roots = {settles: [numbers[one] for one in uses] for settles, uses in self._roots.items()}

    def line(self, key: "AnswerKey") -> int | None:
        """The number among the lines of that which tells a key; None where none does."""
        return next((i for i, (line, _) in enumerate(self._lines) if line.settles == key.text), None)

    def root(self, key: "AnswerKey", looked_at: "Sequence[Mapping[str, GivenValue]]") -> "dict[int, float] | None":
        """{line: the largest slope ∂ln key/∂ln line at some variants} of the lines from which a key is found that none
        tells by itself; None where there are none, or they make it up nowhere, and of what is no number."""
        uses = next((self._roots[name] for name in _names(key) if name in self._roots), None)
        if self.line(key) is not None or key.form or uses is None:
            return None
        if not uses:
            return {}           # found from what is given
        found = [self._root_at(key, uses, values) for values in looked_at]
        known = [weights for weights in found if weights is not None]
        return {j: max((one[k] for one in known), key=abs) for k, j in enumerate(uses)} if known else None

    def _root_at(self, key, uses, values):
        """∂ln key/∂ln line of each of these lines at a variant; None where there is no such, or they do not make it
        up."""
        try:
            own = np.array([self._slopes_of(key, values)])
        except (PhysicsError, SpecError):
            return None
        _, slopes = self._slopes(_arrays([values]))
        weights = _weights(own, [slopes[j] for j in uses])
        left = own - sum(weight[:, None] * slopes[j] for j, weight in zip(uses, weights, strict=True))
        if np.abs(left).max() > MADE_UP * max(1.0, np.abs(own).max()):
            return None
        return [float(weight[0]) for weight in weights]

    def shares(self, keys: "Sequence[AnswerKey]", given: "Mapping[str, np.ndarray]",
               roots: "Sequence[dict[int, float] | None]") -> "list[np.ndarray | None]":
        """The same over arrays of given values, {parameter: SI}; roots: what `root` gives of each key."""
        ends = [self.line(key) for key in keys]
        if not self._lines or all(end is None and root is None for end, root in zip(ends, roots, strict=True)):
            return [None] * len(keys)
        values, slopes = self._slopes(given)
        weights = [_weights(slopes[i], [slopes[j] for j in uses]) for i, uses in enumerate(self._uses)]
        rounded = self._rounded(values)
        found = []
        for end, root in zip(ends, roots, strict=True):
            if end is not None:
                root = dict(zip(self._uses[end], weights[end], strict=True))
            found.append(None if root is None else _carried(root, self._uses, weights, rounded))
        return found

    def _rounded(self, values):
        """Half a unit of the third figure of each line, relative to it; 0 where it, and what it is found from, has no
        more figures."""
        inexact: list[np.ndarray] = []
        for value, uses in zip(values, self._uses, strict=True):
            unit = 2 * _half_a_unit(value) * np.abs(value)
            with np.errstate(all="ignore"):
                off = np.nan_to_num(np.abs(np.round(value / unit) * unit - value)) > EXACT * np.abs(value)
            inexact.append(np.logical_or.reduce([off, *(inexact[j] for j in uses)]))
        return [_half_a_unit(value) * off for value, off in zip(values, inexact, strict=True)]

    def _slopes_of(self, key, values):
        """∂ln key/∂ln p of a variant along the parameters, by solutions."""
        at = with_given(self._problem, values)
        found = []
        for name in self._free(values):
            number, unit = number_and_unit(at.spec.parameters[name]["value"])
            up, down = (key.value(with_given(at, {name: giver(unit, name)(number * (1 + step))}))[0]
                        for step in (Fraction(STEP), -Fraction(STEP)))
            found.append(log(abs(up / down)) / (2 * STEP) if up and down else 0.0)
        return found

    def _free(self, given):
        return [name for name in self._problem.spec.independent_parameters
                if name in given or name in self._problem.numeric.floats]

    def _slopes(self, given):
        """(values of the lines, ∂ln|v|/∂ln p of each as an array variants × parameters)."""
        values = self._values(given)
        slopes = []
        for name in self._free(given):
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


def _names(key):
    """What the line settles that tells a key, or from which it is read off."""
    tree = key.asked.tree
    head = FROM.get(tree.head) if isinstance(tree, QuantityRef) and len(tree.indices) == 1 else None
    return [key.text] if head is None else [key.text, f"{head}[{tree.indices[0]}]"]


def _lines(problem: "Problem") -> "tuple[list[tuple[WorkedLine, list[int]]], dict[str, list[int]]]":
    """[(line, numbers of the lines with numbers that it follows from, by others without numbers too)]; {what a line
    settles that is no expression of the parameters, or may be read off: such numbers}."""
    from vibcli.report.steps.worked import worked

    try:
        told = worked(problem)
    except (PhysicsError, SpecError):
        return [], {}
    with_numbers = [line for line in told if line.value and line.node is not None and _known(problem, line.node)]
    valued = {line.number for line in with_numbers}
    reach: dict[int, dict[int, None]] = {}
    found, roots = [], {}
    for line in told:
        uses: dict[int, None] = {}
        for one in line.uses:
            uses |= {one: None} if one in valued else reach.get(one, {})
        reach[line.number] = uses
        if line in with_numbers:
            found.append((line, list(uses)))
        roots[line.settles] = [line.number] if line in with_numbers else list(uses)
    searched = {line.settles for line in told if line.value is not None and line.node is None}
    return found, {settles: uses for settles, uses in roots.items() if settles and (uses or settles in searched)}


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


def _carried(ends: "Mapping[int, float | np.ndarray]", uses: "list[list[int]]", weights: "list[list[np.ndarray]]",
             rounded: "list[np.ndarray]") -> np.ndarray:
    """Σ a, Σ a², Σ a⁴ and the largest a of what the lines carry to what hangs on some of them, {line: slope}, relative
    to it: an array 4 × variants."""
    carry = [np.zeros_like(one) + ends.get(i, 0.0) for i, one in enumerate(rounded)]
    for i in reversed(range(len(carry))):
        for j, weight in zip(uses[i], weights[i], strict=True):
            carry[j] = carry[j] + carry[i] * weight
    parts = np.abs(np.array(carry)) * np.array(rounded)
    return np.array([parts.sum(0), (parts**2).sum(0), (parts**4).sum(0), parts.max(0)])
