"""The lines of a worked solution that tell numbers, at many values of what is given: their values, and how they hang on
the lines before them.

A line v = F(u, p) is printed by letters u of earlier lines and given values p, or by p alone; what a search found makes
F(v, u, p) vanish, and is found for all values at once by Newton's method, from the values of the file on.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import UNITS

if TYPE_CHECKING:
    from vibcli.report.steps.step import WorkedLine
    from vibcli.results.problem import Problem

STEP = 1e-5             # relative: of differences
WAY, NEWTON = 8, 30     # parts of the way from the values of the file, and steps in each
SMALL = 1e-3            # of the value that was told: what passes zero is of that size
THERE, CLOSE = 1e-13, 1e-6      # relative: of the last step of a search, and of the value that was told


class LineValues:
    """lines: those that tell a number which is known for all given values, in order; letters: of each the numbers,
    among them, of those whose letters stand in it; uses: those that it follows from without their letters. There are
    none where a scene has no such solution."""

    def __init__(self, problem: "Problem"):
        self.problem = problem
        self.lines: list[WorkedLine] = []
        self.letters: list[list[int]] = []
        self.uses: list[list[int]] = []
        self._groups: list[list[int]] = []      # of each line those that are found together with it
        self._still = dict.fromkeys(UNITS.values(), 1.0)        # {letter: number}, of what vanishes as well
        self._read(_told(problem))

    @property
    def free(self) -> list[str]:
        """The parameters with numbers that are no others' expressions."""
        return [name for name in self.problem.spec.independent_parameters if name in self.problem.numeric.floats]

    def number(self, text: str) -> int | None:
        """That of the line which tells a quantity; None where none does."""
        return next((i for i, line in enumerate(self.lines) if line.settles == text), None)

    def again(self, i: int) -> bool:
        """Does a line tell once more what another one told, perhaps with the other sign?"""
        node = self.lines[i].node
        return node is not None and len(self.letters[i]) == 1 and any(
            one.op == "symbol" and one.name == _letter(self.lines[self.letters[i][0]]) for one in (node, -node))

    def parameters(self, given: "Mapping[str, np.ndarray | float]") -> dict[str, Any]:
        """{parameter: number, or array where it hangs on what is given}, letters of units, and of what vanishes."""
        known = {name: float(value) for name, value in self.problem.numeric.given.items()}
        return {**self._still, **self.problem.scene.parameters.values(Arrays, {**known, **given})}

    def values(self, given: "Mapping[str, np.ndarray | float]", near: "Sequence[np.ndarray] | None" = None
               ) -> "list[np.ndarray]":
        """Of each line, NaN where a search does not find it; near: where searches begin, the file's unless given."""
        if near is None and any(self._groups):
            own = {name: self.problem.numeric.floats[name] for name in given}
            near = [np.array([line.value]) for line in self.lines]
            for part in range(1, WAY):
                on_the_way = {name: own[name] + (values - own[name]) * part / WAY for name, values in given.items()}
                near = self._values(on_the_way, near)
        return self._values(given, near)

    def place_in_group(self, i: int) -> int:
        """The place of a line among those that are found together with it."""
        return self._groups[i].index(i) if self._groups[i] else 0

    def _values(self, given: "Mapping[str, np.ndarray | float]",
                near: "Sequence[np.ndarray] | None") -> "list[np.ndarray]":
        numbers, found = self.parameters(given), []
        count = max((np.size(value) for value in given.values()), default=1)
        for i in range(len(self.lines)):
            if i == len(found):
                found += [np.broadcast_to(np.asarray(value, dtype=float), (count,))
                          for value in self.at(i, numbers, found, near)]
        return found

    def at(self, i: int, numbers: "Mapping[str, Any]", found: "Sequence[np.ndarray]",
           near: "Sequence[np.ndarray] | None") -> "list[np.ndarray]":
        """The value of a line, or of those that are found together with it: numbers: {parameter: array}; found: the
        values of the lines before."""
        known = {**numbers, **{_letter(self.lines[j]): found[j] for j in self.letters[i]}}
        with np.errstate(all="ignore"):
            if not self._groups[i]:
                return evaluate([self.lines[i].node], Arrays, known)
            return list(self._search(self._groups[i], known, [near[j] for j in self._groups[i]]))

    def _search(self, group: list[int], known: Mapping[str, Any], near: "Sequence[np.ndarray]") -> np.ndarray:
        """Newton's method for what vanishes together."""
        x = np.array(np.broadcast_arrays(*near, *(value for value in known.values() if np.ndim(value)))[:len(near)])
        for _ in range(NEWTON):
            left, slopes = self._slopes(group, known, x)
            step = -_solved(slopes, left)
            x = x + step
            if np.all(np.abs(step) <= THERE * self._sizes(group, x)):
                break
        return np.where(np.abs(step) <= CLOSE * self._sizes(group, x), x, np.nan)

    def _sizes(self, group: list[int], x: np.ndarray) -> np.ndarray:
        """Of the unknowns, which may pass zero."""
        return np.array([np.maximum(np.abs(one), SMALL * abs(self.lines[j].value))
                         for j, one in zip(group, x, strict=True)])

    def _left(self, group: list[int], known: Mapping[str, Any], x: np.ndarray) -> np.ndarray:
        """What is left of each equation."""
        values = {**known, **{_letter(self.lines[j]): one for j, one in zip(group, x, strict=True)}}
        return np.array([np.broadcast_to(one, x.shape[1:]) for one in evaluate(
            [self.lines[j].vanishes for j in group], Arrays, values)])

    def _slopes(self, group: list[int], known: Mapping[str, Any], x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(what is left of each equation, its slopes by the unknowns as unknowns × equations); both sides of each
        unknown are evaluated with the place itself."""
        aside = np.zeros((len(group), *x.shape))
        diagonal = range(len(group)), range(len(group))
        aside[diagonal] = STEP * self._sizes(group, x)
        states = np.concatenate([x[:, None], x[:, None] + aside, x[:, None] - aside], axis=1)
        left = self._left(group, known, states)
        up, down = np.split(left[:, 1:], 2, axis=1)
        return left[:, 0], np.moveaxis(up - down, 1, 0) / (2 * aside[diagonal])[:, None]

    def by_letters(self, i: int, numbers: "Mapping[str, Any]", values: "Sequence[np.ndarray]") -> "list[np.ndarray]":
        """∂ln v/∂ln u of a line by those whose letters stand in it."""
        known = {**numbers, **{_letter(self.lines[j]): values[j] for j in self.letters[i]}}
        found, group = [], self._groups[i]
        with np.errstate(all="ignore"):
            if group:
                x = np.array([values[j] for j in group])
                _, slopes = self._slopes(group, known, x)
            for j in self.letters[i]:
                name = _letter(self.lines[j])
                ways = [{**known, name: known[name] * (1 + sign * STEP)} for sign in (1, -1)]
                if group:
                    up, down = (self._left(group, way, x) for way in ways)
                    moved = -_solved(slopes, (up - down) / (2 * STEP))
                    found.append(moved[self.place_in_group(i)] / values[i])
                else:
                    up, down = (evaluate([self.lines[i].node], Arrays, way)[0] for way in ways)
                    found.append(np.log(np.abs(up / down)) / (2 * STEP) + np.zeros_like(values[i]))
        return found

    def _read(self, told: "list[WorkedLine]") -> None:
        """Take the lines that are known, with what they follow from."""
        numbered: dict[int, list[int]] = {}
        reach: dict[int, dict[int, None]] = {}
        by_letter: dict[str, int] = {}
        taken = set(self.problem.spec.parameters)
        for group in _together(told):
            before: dict[int, None] = {}
            for one in group[0].uses:
                before |= dict.fromkeys(numbered.get(one, reach.get(one, {})))
            reach.setdefault(group[0].number, {}).update(before)
            if all(line.node is None and line.vanishes is None for line in group):
                continue
            if group[0].value == 0 and group[0].node is not None and group[0].node.is_zero:
                self._still[_letter(group[0])] = 0.0
            first = len(self.lines)
            if not self._take(group, before, by_letter):
                continue
            for i, line in enumerate(group, first):
                if not line.aside:
                    numbered.setdefault(line.number, []).append(i)
                if _letter(line) not in taken:
                    by_letter[_letter(line)] = i

    def _take(self, group: "list[WorkedLine]", before: dict[int, None], by_letter: dict[str, int]) -> bool:
        """Are the values of a line, or of those that are found together, known? Then they are taken."""
        if not all(line.value for line in group):
            return False
        searched = group[0].node is None
        inside = {part.name for part in reachable([line.vanishes if searched else line.node for line in group])
                  if part.op == "symbol"} - ({_letter(line) for line in group} if searched else set())
        letters = sorted({by_letter[name] for name in inside if name in by_letter})
        first = len(self.lines)
        for line in group:
            self.lines.append(line)
            self.letters.append(letters)
            self.uses.append([] if letters or searched else list(before))
            self._groups.append(list(range(first, first + len(group))) if searched else [])
        own = {name: np.array([value]) for name, value in self.problem.numeric.floats.items()}
        values = [np.array([line.value]) for line in self.lines]
        try:
            found = self.at(first, {**own, **self._still}, values, values)
        except KeyError:
            found = [np.array([np.nan])]
        if all(np.abs(one - line.value) <= CLOSE * abs(line.value) for one, line in zip(found, group, strict=False)):
            return True
        for part in (self.lines, self.letters, self.uses, self._groups):
            del part[first:]
        return False


def _told(problem: "Problem") -> "list[WorkedLine]":
    from vibcli.report.steps.worked import worked

    try:
        return worked(problem)
    except (PhysicsError, SpecError):
        return []


def _letter(line: "WorkedLine") -> str:
    return line.letter or line.settles


def _together(told: "list[WorkedLine]") -> "list[list[WorkedLine]]":
    """Lists of the lines, alone or found together by a search."""
    found: list[list[WorkedLine]] = []
    for line in told:
        joins = line.vanishes is not None and found and found[-1][-1].vanishes is not None
        if joins and found[-1][-1].number == line.number:
            found[-1].append(line)
        else:
            found.append([line])
    return found


def _solved(slopes: np.ndarray, left: np.ndarray) -> np.ndarray:
    """x of Σ slopes xₖ = left, at all values at once."""
    A, b = np.moveaxis(slopes, (0, 1), (-1, -2)), np.moveaxis(left, 0, -1)[..., None]
    usable = np.isfinite(A).all((-1, -2)) & np.isfinite(b).all((-1, -2))
    A = np.where(usable[..., None, None], A, np.eye(A.shape[-1]))
    try:
        x = np.linalg.solve(A, b)
    except np.linalg.LinAlgError:       # one of them is singular
        x = np.linalg.pinv(A) @ b
    return np.moveaxis(np.where(usable[..., None, None], x, np.nan)[..., 0], -1, 0)
