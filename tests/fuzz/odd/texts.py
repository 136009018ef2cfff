"""The texts of a scene in numbers: its parameters, expressions, functions of the time, measured ones too."""

import mpmath
import numpy as np

from . import jets, records, words


def floating(above, below, pi):
    return above / below * float(np.pi) ** pi if pi else above / below


def precise(above, below, pi):
    return mpmath.mpf(above) / below * mpmath.pi**pi


class Texts:
    """Values of what stands in a scene. `literal`: what numbers are."""

    def __init__(self, scene, given, literal, folder):
        self.scene, self.literal, self.trees, self.parameters = scene, literal, {}, {}
        self.records = {name: records.read(words_, folder) for name, words_ in scene.get("records", {}).items()}
        self.functions = {**words.FUNCTIONS, "impulse": lambda x: 0, **self.records}
        self.functions |= {name + "__1": record.rate for name, record in self.records.items()}
        self.functions |= {name + "__2": lambda x: 0 for name in self.records}      # between its samples
        self.pi = literal(1, 1, 1)
        written = {name: v.get("value") if isinstance(v, dict) else v
                   for name, v in self.scene.get("parameters", {}).items()}
        self.written = {**written, **dict(given)}
        for name in self.written:
            self._parameter(name)

    def tree(self, text):
        text = str(text)
        if text not in self.trees:
            self.trees[text] = words.read(text)
        return self.trees[text]

    def _parameter(self, name):
        if name not in self.parameters:
            tree = self.tree(self.written[name])
            for other in words.names(tree):
                if other in self.written:
                    self._parameter(other)
            self.parameters[name] = words.value(tree, self.parameters, self.literal)
        return self.parameters[name]

    def number(self, text):
        return words.value(self.tree(text), self.parameters, self.literal)

    def value(self, text, known, functions=None):
        """The value of a text, or of a list of signed terms."""
        terms = text if isinstance(text, list) else [(1, self.tree(text))]
        return sum(sign * words.value(tree, known, self.literal, functions or self.functions) for sign, tree in terms)

    def terms_of(self, text):
        """(terms without the time, terms that hold it) of an expression."""
        parts = [], []
        for sign, tree in words.terms(self.tree(text)):
            parts["t" in words.names(tree)].append((sign, tree))
        return parts

    def place(self, pair):
        return tuple(self.number(text) for text in pair)

    def curve(self, surface, x):
        return words.value(self.tree(surface["curve"]), {**self.parameters, surface["in"]: x}, self.literal)

    def of_time(self, terms, t):
        """A sum of functions of the time with its first two rates."""
        (now,) = jets.variables([t])
        total = sum(sign * words.value(tree, {**self.parameters, "t": now}, self.literal, self.functions)
                    for sign, tree in terms)
        return (total.v, total.g[0], total.h[0, 0]) if isinstance(total, jets.Jet) else (total, 0 * t, 0 * t)
