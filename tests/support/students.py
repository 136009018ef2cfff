"""Students who follow the lines of a worked solution, and round some of what these tell; each has a variant.

A line that is printed by letters of earlier lines, as ω_d = √(ω² − δ²), is evaluated anew with the student's values of
these, and what a search finds is searched anew; where no letters are printed, earlier lines enter by the powers with
which the line hangs on them.
"""

import hashlib
from math import tau

import numpy as np

from vibcli.homework.rounding import EXACT, Rounding, arrays
from vibcli.report.blocks import Factor, Name, SumOfTerms, WithNumbers
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable

READ = {"frequency": lambda omega: omega / tau, "period": lambda omega: tau / omega,
        "period_d": lambda omega_d: tau / omega_d, "decrement": lambda zeta: tau * zeta / np.sqrt(1 - zeta**2)}


def rounded(x, figures):
    """To so many figures, of each."""
    with np.errstate(all="ignore"):
        unit = 10.0 ** (np.where(x != 0, np.floor(np.log10(np.abs(x))), 0) - figures + 1)
    return np.round(x / unit) * unit


class Students:
    """As many as values of the parameters that are given, one variant each; the lines that each rounds are drawn by the
    problem, where there is something to round. problem: that of the first."""

    def __init__(self, problem, values):
        self.count, self.rounding = len(values), Rounding(problem)
        self.known, self.given = self.rounding.known, arrays(values)
        self.numbers = self.known.parameters(self.given)
        self.values, self.weights = self.rounding.weighed(self.given)
        seed = hashlib.blake2b(repr((problem.spec.get("title"), self.count)).encode(), digest_size=8).digest()
        self.draw = np.random.default_rng(int.from_bytes(seed, "big"))

    def right(self, key):
        """The right answer to each one's key, in its unit, by the line that tells it, or from which it is read off."""
        line, is_read = self.rounding.end(key)
        return (READ[key.asked.tree.head](self.values[line]) if is_read else self.values[line]) / key.factor

    def answers(self, key, figures):
        """(each one's answer over the right one, how many lines were evaluated by letters); None where no line tells
        the key. figures: to how many each rounds."""
        end = self.rounding.end(key)
        if end is None:
            return None
        line, is_read = end
        found, by_letters = self._lines(line, None if is_read else line, figures)
        if not is_read:
            return found[line] / self.values[line], by_letters
        read = READ[key.asked.tree.head]
        return read(found[line]) / read(self.values[line]), by_letters

    def _lines(self, last, end, figures):
        """(what each student has of each line, how many lines were evaluated by letters)."""
        found, letters, by_letters = [], {}, 0
        for i, line in enumerate(self.known.lines[:last + 1]):
            value = self._line(i, line, found, letters)
            by_letters += value is not None
            if value is None:
                value = np.array(self.values[i])
                for j, weight in zip(self.rounding.uses[i], self.weights[i], strict=True):
                    some = self.values[j] != 0
                    value = value * np.where(some, found[j] / np.where(some, self.values[j], 1.0), 1.0) ** weight
            shorter = rounded(value, figures)
            is_exact = np.allclose(shorter, value, rtol=EXACT, atol=0)      # as most entries of matrices are
            rounds = self.draw.random(self.count) < 0.5 if i != end and not is_exact else False
            found.append(np.where(rounds, shorter, value))
            letters |= dict.fromkeys(_head(line), found[-1])
        return found, by_letters

    def _line(self, i, line, found, letters):
        """A line by the letters of lines before it; None where none stands in it."""
        if self.known.letters[i]:
            return self.known.at(i, self.numbers, [*found, *self.values[i:]], self.values)[
                self.known.place_in_group(i)] + np.zeros(self.count)
        for node in map(_node, line.parts):
            names = {part.name for part in reachable([node]) if part.op == "symbol"} if hasattr(node, "op") else set()
            if names & set(letters) and names <= {*letters, *self.numbers} and not names & set(_head(line)):
                with np.errstate(all="ignore"):
                    value = evaluate([node], Arrays, {**self.numbers, **letters})[0]
                    if np.median(np.abs(value / self.values[i] - 1)) < 0.05:
                        return value
        return None


def _node(part):
    part = part.node if isinstance(part, (WithNumbers, Factor)) else part
    return part.nodes[0].table.total(part.nodes) if isinstance(part, SumOfTerms) else part


def _head(line):
    """The letter that a line begins with, of its square too."""
    for part in line.parts:
        if isinstance(part, Name):
            return [part.text]
        if getattr(part, "op", None) == "product" and len(part.args) == 1:
            part = part.args[0][0]
        if getattr(part, "op", None) == "symbol":
            return [part.name]
    return []
