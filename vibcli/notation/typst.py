"""Expressions as Typst writes them between dollar signs: letters apart, words in quotes, brackets that grow."""

import re
from collections.abc import Sequence
from typing import Any

from vibcli.base.decoding import on_one_line
from vibcli.notation.names import GREEK
from vibcli.notation.typeset import Stacked

FUNCTIONS = {"sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "ln"}
OPERATORS = {"·": "thin", "−": "-", "Σ": "∑", "½": "inline(frac(1, 2))"}
ACCENTS = {"": "{}", "'": "dot({})", "''": "dot.double({})"}
PLAIN = "()[]+-=<>,.;:!?|*"     # signs that stand for themselves


def quoted(text: str) -> str:
    """Words as a string of Typst, which nothing in them ends or changes."""
    return '"' + re.sub(r'[\\"]', r"\\\g<0>", on_one_line(text)) + '"'


class Typst(Stacked):
    """The inside of $…$."""

    minus, markup = "-", re.compile(r'(?<!")\b[a-z.]{2,}\b(?!")|["{}()_^ ]')

    def numeral(self, text: str) -> str:
        text, _, power = text.replace("−", "-").partition("e")
        return f"{text} ⋅ 10^({int(power)})" if power else text

    def marked(self, text: str, marks: int) -> str:
        return f"{text}^({' '.join(['prime'] * marks)})" if marks else text

    def lettered(self, letter: Any, below: Any, primes: Any) -> str:
        letter = ACCENTS[primes].format(self.word(letter))
        if not below:
            return letter
        if not below.isascii():
            return f"{letter}_({self.notation(below)})"
        return f"{letter}_({below if below.replace(',', '').isdigit() else self.word(below)})"

    def word(self, text: str) -> str:
        text = GREEK.get(text, text)
        return text if len(text) == 1 and (text.isalpha() or not text.isascii()) else quoted(text)

    def brackets(self, text: str) -> str:
        return f"({text})"

    def flat(self, text: str) -> str:
        return self.brackets(text)

    def magnitude(self, text: str) -> str:
        return f"lr(|{text}|)"

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^({exponent})"

    def function(self, name: str, args: Sequence[str]) -> str:
        return f"{self.functional(name)} ({', '.join(args)})"

    def functional(self, name: str) -> str:
        return name if name in FUNCTIONS else f"op({quoted(name)})"

    def applied(self, head: str, text: str, bare: bool) -> str:
        return f"{head} {text}"

    def times(self, texts: Sequence[str]) -> str:
        return (" ⋅ " if self.values else " thin ").join(texts)        # numbers side by side are one

    def fraction(self, above: str, below: str) -> str:
        return f"frac({above}, {below})"

    def rows(self, texts: list[str]) -> str:
        cells = "; ".join(f"display({text})" for text in [texts[0], *(f"quad {text}" for text in texts[1:])])
        return f"mat(delim: #none, align: #left, row-gap: #0.5em, {cells})"

    def matrix(self, rows: list[list[str]]) -> str:
        return f'mat(delim: "(", {"; ".join(map(", ".join, rows))})'

    def sqrt(self, text: str) -> str:
        return f"sqrt({text})"

    def operator(self, symbol: str) -> str:
        if symbol in OPERATORS:
            return OPERATORS[symbol]
        return symbol if symbol in PLAIN or not symbol.isascii() else f"\\{symbol}"

    def gap(self, columns: int) -> str:
        return "quad" if columns > 1 else "thick"

    def words(self, text: str) -> str:
        return quoted(text) if text else ""

    def beside(self, *texts: str) -> str:
        """Letters stand apart, words have spaces of their own."""
        found = ""
        for text in filter(None, map(str.strip, texts)):
            found += " " * bool(found and '"' not in (found[-1], text[0])) + text
        return found


typst = Typst()
