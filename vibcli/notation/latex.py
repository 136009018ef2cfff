"""Expressions as LaTeX, for math mode."""

import re
from collections.abc import Sequence
from typing import Any

from vibcli.notation.names import COMMANDS, GREEK, NAMES
from vibcli.notation.typeset import Stacked

FUNCTIONS = {"sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "ln"}
OPERATORS = {"−": "-", "≤": r"\le", "≥": r"\ge", "∓": r"\mp", "±": r"\pm", "∞": r"\infty", "Σ": r"\sum",
             "…": r"\ldots", "∠": r"\angle", "∫": r"\int", "≠": r"\ne", "½": r"\tfrac{1}{2}"}


def _escaped(name: str) -> str:
    return name.replace("_", r"\_")


class Latex(Stacked):
    """LaTeX, for math mode."""

    minus, thin, thick, newline = "-", r"\,", r"\;", r"\\"
    markup = re.compile(r"\\mkern\dmu|\\[a-zA-Z]+|\\.|[{}_^ ]")

    def numeral(self, text: str) -> str:
        text, _, power = text.replace("−", "-").partition("e")
        return rf"{text} \cdot 10^{{{int(power)}}}" if power else text.replace("°", r"^{\circ}")

    def marked(self, text: str, marks: int) -> str:
        return text + "'" * marks

    def lettered(self, letter: Any, below: Any, primes: Any) -> str:
        letter = NAMES.get(letter, letter)
        if letter == "ℓ":
            letter = r"\ell"
        elif letter == "∂":
            letter = r"\partial"
        elif letter in GREEK:
            letter = "\\" + COMMANDS.get(letter, letter)
        elif len(letter) > 1:
            letter = self.word(letter)
        accent = {"": "{}", "'": r"\dot{{{}}}", "''": r"\ddot{{{}}}"}[primes]
        if below and not below.isascii():
            below = self.notation(below)
        elif len(below) > 1 and not below.replace(",", "").isdigit():
            below = self.word(below)
        letter = accent.format(letter)
        return self.indexed(letter, below) if below else letter

    def word(self, text: str) -> str:
        return rf"\mathrm{{{_escaped(text)}}}"

    def indexed(self, letter: str, below: str) -> str:
        return f"{letter}_{{{below}}}"

    def brackets(self, text: str) -> str:
        return rf"\left({text}\right)"

    def flat(self, text: str) -> str:
        return f"( {text} )"

    def magnitude(self, text: str) -> str:
        return rf"\left|{text}\right|"

    def power(self, base: str, exponent: str) -> str:
        return f"{base}^{{{exponent}}}"

    def function(self, name: str, args: Sequence[str]) -> str:
        return rf"{self.functional(name)}\left({', '.join(args)}\right)"

    def functional(self, name: str) -> str:
        return "\\" + name if name in FUNCTIONS else rf"\operatorname{{{_escaped(name)}}}"

    def applied(self, head: str, text: str, bare: bool) -> str:
        return head + " " * bare + text

    def times(self, texts: Sequence[str]) -> str:
        return (r" \cdot " if self.values else f" {self.thin} ").join(texts)        # numbers side by side are one

    def fraction(self, above: str, below: str) -> str:
        return rf"\frac{{{above}}}{{{below}}}"

    def rows(self, texts: list[str]) -> str:
        lines = f" {self.newline} & \\quad {{}}".join(texts)
        return rf"\begin{{aligned}} & {lines} \end{{aligned}}"

    def matrix(self, rows: list[list[str]]) -> str:
        lines = f" {self.newline} ".join(map(" & ".join, rows))
        return rf"\begin{{pmatrix}} {lines} \end{{pmatrix}}"

    def sqrt(self, text: str) -> str:
        return rf"\sqrt{{{text}}}"

    def operator(self, symbol: str) -> str:
        return self.thin if symbol == "·" else OPERATORS.get(symbol, symbol)

    def gap(self, columns: int) -> str:
        return r"\quad" if columns > 1 else self.thick

    def words(self, text: str) -> str:
        from vibcli.notation.latex_text import escaped

        return rf"\text{{{escaped(text)}}}" if text else ""

    def beside(self, *texts: str) -> str:
        return " ".join(filter(None, map(str.strip, texts)))


class InOneLine(Latex):
    """LaTeX without rows, however wide, for programs that read it."""

    def rows(self, texts: list[str]) -> str:
        return "".join(texts)


latex, in_one_line = Latex(), InOneLine()
