"""Expressions as LaTeX, for math mode."""

from vibcli.algebra.rationals import ONE
from vibcli.report.notation import GREEK, Notation, decimal, shown_as_decimal, split_name
from vibcli.report.roots import place


def _escaped(word):
    return word.replace("_", r"\_")


class Latex(Notation):
    """LaTeX, for math mode."""

    minus = "-"

    def number(self, value):
        if value.denominator == 1 or shown_as_decimal(value):
            return decimal(value).replace("−", "-")
        sign = "-" if value < 0 else ""
        return rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"

    def symbol(self, name):
        letter, rest, primes = split_name(name)
        if letter == "ℓ":
            letter = r"\ell"
        elif letter in GREEK:
            letter = "\\" + {"phi": "varphi", "epsilon": "varepsilon"}.get(letter, letter)
        elif len(letter) > 1:
            letter = rf"\mathrm{{{_escaped(letter)}}}"
        accent = {"": "{}", "'": r"\dot{{{}}}", "''": r"\ddot{{{}}}"}[primes]
        below = rest.removeprefix("_")
        if len(below) > 1 and not below.isdigit():
            below = rf"\mathrm{{{_escaped(below)}}}"
        return accent.format(letter) + (f"_{{{below}}}" if below else "")

    def brackets(self, text):
        return rf"\left({text}\right)"

    def power(self, base, exponent):
        return f"{base}^{{{exponent}}}"

    def function(self, name, args):
        return rf"\operatorname{{{name}}}\left({', '.join(args)}\right)"

    def call(self, name, arg, exponent):
        known = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln"}.get(name, name)
        if known == "abs":
            return rf"\left|{self.write(arg, 0)}\right|"
        head = rf"\operatorname{{{known}}}" if known == "sign" else "\\" + known
        head += "" if exponent == 1 else f"^{{{decimal(exponent)}}}"
        inner = self.write(arg, 0)
        return f"{head} {inner}" if arg.op in ("symbol", "pi") else rf"{head}\left({inner}\right)"

    def over(self, text, below):
        return rf"\frac{{{text}}}{{{below}}}"

    def product(self, value, args):
        value, above, below, root_above, root_below = self.factors(value, args)
        alone = len(above) == 1 and value.numerator == 1 and not (root_above or root_below)
        thin = r" \, "
        lone_root = root_below and not root_above
        plain = not below and not lone_root and (value.denominator == 1 or shown_as_decimal(value))
        tops = [self.powered(base, e, alone and (not plain or value == 1)) for base, e in above]
        if root_above:
            tops.insert(place(above, root_above), self.root(root_above, root_below))
        if plain:
            if value != 1 or not tops:
                tops.insert(0, decimal(value))
            return thin.join(tops)
        bottoms = [self.powered(base, e, len(below) == 1 and value.denominator == 1) for base, e in below]
        if lone_root:
            bottoms.append(self.root(root_below, []))
        if value.denominator > 1:
            bottoms.insert(0, str(value.denominator))
        if value.numerator != 1 or not tops:
            tops.insert(0, str(value.numerator))
        return rf"\frac{{{thin.join(tops)}}}{{{thin.join(bottoms)}}}"

    def root(self, above, below):
        return rf"\sqrt{{{self.product(ONE, (*above, *((base, -e) for base, e in below)))}}}"


latex = Latex()
