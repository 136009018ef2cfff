"""Expressions as MathML: presentation markup as in MathML Core, which browsers show without help.

Every text is a row of elements; an element that takes a fixed number of arguments gets them in an mrow.
"""

import re
from collections.abc import Sequence
from html import escape
from typing import Any

from vibcli.notation.names import GREEK
from vibcli.notation.typeset import Stacked

TIMES = '<mo>&#x2062;</mo><mspace width="0.17em"/>'       # invisible, with the space by which letters stand apart
APPLY = "<mo>&#x2061;</mo>"
TALL = "<mfrac", "<msqrt", "<munder", "<mtable"        # what brackets grow with
_LEAF = re.compile(r"<(m[ion])[^<>]*>[^<>]*</\1>")


def row(text: str) -> str:
    """One element that holds a row."""
    return text if _LEAF.fullmatch(text) else f"<mrow>{text}</mrow>"


def _operator(symbol: str, form: str | None = None) -> str:
    kept = ' stretchy="false"' if symbol == "|" and not form else ""        # of two in words both would open
    return f'<mo form="{form}">{escape(symbol)}</mo>' if form else f"<mo{kept}>{escape(symbol)}</mo>"


class MathML(Stacked):
    """The inside of a <math> element."""

    markup = re.compile(r"<[^>]*>|&#x206\d;")

    def numeral(self, text: str) -> str:
        text, _, power = text.replace("−", "-").partition("e")
        found = f"<mn>{text}</mn>" if text[0] != "-" else f"{_operator('−', 'prefix')}<mn>{text[1:]}</mn>"
        return f"{found}<mo>·</mo>{self.power('<mn>10</mn>', self.numeral(str(int(power))))}" if power else found

    def marked(self, text: str, marks: int) -> str:
        return f"<msup>{row(text)}<mo>{'′' * marks}</mo></msup>"

    def lettered(self, letter: Any, below: Any, primes: Any) -> str:
        found = f"<mi>{escape(GREEK.get(letter, letter))}</mi>"
        if primes:
            found = f"<mover>{found}<mtext>{'.' * len(primes)}</mtext></mover>"      # accents fall into the letter
        if not below:
            return found
        if not below.isascii():
            below = row(self.notation(below))
        elif below.replace(",", "").isdigit():
            below = f"<mn>{below}</mn>"
        else:
            below = f"<mi>{GREEK.get(below, below)}</mi>"
        return f"<msub>{found}{below}</msub>"

    def brackets(self, text: str) -> str:
        """Those that need not grow do not: some fonts set those that may apart from what they enclose."""
        if not any(tall in text for tall in TALL):
            return self.flat(text)
        return f"<mrow><mo>(</mo>{text}<mo>)</mo></mrow>"

    def flat(self, text: str) -> str:
        return f'<mrow><mo stretchy="false">(</mo>{text}<mo stretchy="false">)</mo></mrow>'

    def magnitude(self, text: str) -> str:
        return f"<mrow>{_operator('|', 'prefix')}{text}{_operator('|', 'postfix')}</mrow>"

    def power(self, base: str, exponent: str) -> str:
        if base.startswith("<msub>") and base.find("</msub>") == len(base) - len("</msub>"):
            return f"<msubsup>{base[len('<msub>'):-len('</msub>')]}{row(exponent)}</msubsup>"
        return f"<msup>{row(base)}{row(exponent)}</msup>"

    def function(self, name: str, args: Sequence[str]) -> str:
        return self.functional(name) + APPLY + self.brackets("<mo>,</mo>".join(args))

    def functional(self, name: str) -> str:
        return f"<mi>{escape(name)}</mi>"

    def applied(self, head: str, text: str, bare: bool) -> str:
        return head + APPLY + '<mspace width="0.17em"/>' * bare + text

    def times(self, texts: Sequence[str]) -> str:
        return ("<mo>·</mo>" if self.values else TIMES).join(texts)        # numbers side by side are one

    def fraction(self, above: str, below: str) -> str:
        return f"<mfrac>{row(above)}{row(below)}</mfrac>"

    def rows(self, texts: list[str]) -> str:
        cells = "".join(f"<mtr><mtd>{row(text)}</mtd></mtr>" for text in [
            texts[0], *(f'<mspace width="1em"/>{text}' for text in texts[1:])])
        return f'<mtable columnalign="left" displaystyle="true">{cells}</mtable>'

    def matrix(self, rows: list[list[str]]) -> str:
        lines = "".join(f"<mtr>{''.join(f'<mtd>{row(cell)}</mtd>' for cell in cells)}</mtr>" for cells in rows)
        return f'<mrow><mo>(</mo><mtable class="matrix">{lines}</mtable><mo>)</mo></mrow>'

    def sqrt(self, text: str) -> str:
        return f"<msqrt>{text}</msqrt>"

    def signed(self, negative: bool, text: str, first: bool = False) -> str:
        if first:
            return (_operator("−", "prefix") if negative else "") + text
        return _operator("−" if negative else "+") + text

    def operator(self, symbol: str) -> str:
        if symbol == "·":
            return TIMES
        if symbol == "½":
            return '<mstyle displaystyle="false"><mfrac><mn>1</mn><mn>2</mn></mfrac></mstyle>'
        if symbol == "/":
            return '<mo lspace="0em" rspace="0em">/</mo>'
        return _operator("∑" if symbol == "Σ" else symbol)

    def gap(self, columns: int) -> str:
        return f'<mspace width="{1 if columns > 1 else 0.3}em"/>'

    def words(self, text: str) -> str:
        return f"<mtext>{escape(text).replace(' ', '&#xA0;')}</mtext>" if text else ""

    def beside(self, *texts: str) -> str:
        return "".join(texts)


mathml = MathML()
