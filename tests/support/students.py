"""Students who follow the lines of a worked solution, and round some of what these tell.

A line that is printed by letters of earlier lines, as ω_d = √(ω² − δ²), is evaluated anew with the student's values of
these; of one that is not, earlier lines enter by the powers with which the line hangs on them.
"""

import hashlib

import numpy as np

from vibcli.homework.printed import with_given
from vibcli.homework.rounding import Rounding, _weights
from vibcli.inverse import settled
from vibcli.report.blocks import Factor, Name, SumOfTerms, WithNumbers
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable


def rounded(x, figures):
    """To so many figures."""
    with np.errstate(all="ignore"):
        unit = 10.0 ** (np.where(x != 0, np.floor(np.log10(np.abs(x))), 0) - figures + 1)
    return np.round(x / unit) * unit


class Students:
    """So many of them, with one variant of a problem; the lines that each rounds are drawn by the variant."""

    def __init__(self, problem, variant, count):
        self.scene = settled(with_given(problem, variant.values))
        self.rounding, self.count, self.at = Rounding(self.scene), count, variant.values
        self.values, slopes = self.rounding._slopes({name: np.array([float(one.exact)])
                                                     for name, one in variant.values.items()})
        self.weights = [_weights(slopes[i], [slopes[j] for j in uses]) for i, uses in enumerate(self.rounding._uses)]
        seed = hashlib.blake2b(repr((self.scene.spec.get("title"), variant.place)).encode(), digest_size=8).digest()
        self.draw = np.random.default_rng(int.from_bytes(seed, "big"))
        self.known = {name: float(x) for name, x in self.scene.numeric.floats.items()}

    def answers(self, key, figures):
        """(relative error of each one's answer to so many figures, how many lines were evaluated by their letters);
        None where no line tells the key, nor what it is the root of."""
        end = self.rounding.line(key)
        root = None if end is not None else self.rounding.root(key, [self.at])
        if end is None and root is None:
            return None
        last = end if end is not None else max(root, default=-1)
        found, letters, by_letters = [], {}, 0
        for i, (line, _) in enumerate(self.rounding._lines[:last + 1]):
            value = self._by_letters(line, letters, float(self.values[i][0]))
            by_letters += value is not None
            if value is None:
                value = np.full(self.count, float(self.values[i][0]))
                for j, weight in zip(self.rounding._uses[i], self.weights[i], strict=True):
                    value = value * (found[j] / float(self.values[j][0])) ** float(weight[0])
            rounds = self.draw.random(self.count) < 0.5 if i != end else True
            found.append(np.where(rounds, rounded(value, figures), value))
            letters |= dict.fromkeys(_head(line), found[-1])
        if end is not None:
            return found[end] / float(self.values[end][0]) - 1, by_letters
        right = key.value(self.scene)[0]
        return rounded(right * self._root(key, root, found), figures) / right - 1, by_letters

    def _root(self, key, root, found):
        """What each one's root is beside the right one: ω of a polynomial in ω² with their coefficients, else by the
        powers with which it hangs on the lines."""
        names = {self.rounding._lines[j][0].settles: j for j in root}
        right = {j: float(self.values[j][0]) for j in root}
        is_root = key.asked.tree.indices and set(names) == {f"a{power}" for power in range(len(names))}
        if not is_root or len(names) < 3:
            return np.prod([(found[j] / right[j]) ** power for j, power in root.items()], axis=0)
        signs = {f"a{power}": (-1) ** power for power in range(len(names))}
        number = int(key.asked.tree.indices[0]) - 1

        def omega(row):
            squares = np.roots([signs[name] * row[names[name]] for name in sorted(names)[::-1]]).real
            return np.sqrt(np.sort(squares)[number])

        return np.array([omega({j: found[j][k] for j in root}) for k in range(self.count)]) / omega(right)

    def _by_letters(self, line, letters, right):
        """What the first side of a line gives that earlier letters stand in; None where none does."""
        for node in map(_node, line.parts):
            names = {part.name for part in reachable([node]) if part.op == "symbol"} if hasattr(node, "op") else set()
            if names & set(letters) and names <= {*letters, *self.known} and not names & set(_head(line)):
                value = evaluate([node], Arrays, {**self.known, **letters})[0]
                if abs(np.median(value) / right - 1) < 0.05:
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
