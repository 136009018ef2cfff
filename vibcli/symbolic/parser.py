"""Text to syntax tree (syntax.py): a Pratt parser over numbers with units, names, + - * / ^ and a closed list of
functions.

A name may have parts, as in `tip.x`. Sums and products are flat, so depth is that of the parentheses, and bounded.
Nothing is ever evaluated as code.
"""

import re
from functools import lru_cache
from operator import methodcaller
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.symbolic.literals import literal
from vibcli.symbolic.syntax import Call, Equation, ExpressionError, NameRef, Power, Product, QuantityRef, Sum

if TYPE_CHECKING:
    from collections.abc import Callable
    from re import Match

LONGEST, DEEPEST, PARTS = 2000, 64, 400
REMEMBERED = 1024           # texts
FUNCTIONS = {"sin": 1, "cos": 1, "tan": 1, "asin": 1, "acos": 1, "atan": 1, "atan2": 2, "sinh": 1, "cosh": 1,
             "tanh": 1, "exp": 1, "log": 1, "sqrt": 1, "abs": 1, "sign": 1, "min": 2, "max": 2, "step": 1,
             "ramp": 1, "impulse": 1, "square": 1, "sawtooth": 1}
OF_SIGNALS = ("abs", "amplitude", "arg", "argmax", "argmin", "beat_period", "decrement", "envelope", "final", "im",
              "max", "mean", "min", "overshoot", "period", "phase", "re", "rms", "steady", "transient")
IN_TWO_BRACKETS = ("backbone",)     # quantities of a signal and of a number: backbone[1](x)(10 cm)
VALUE = "value"         # the head of x(2 s), and of what is written like a function and is none
GREEK = dict(zip("αβγδεζηθικλμνξοπρστυφχψωΓΔΘΛΞΠΣΦΨΩϕϑϵ", (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi "
    "chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega phi theta epsilon").split(), strict=True))
# of a name with Greek letters, these spelt out: φ1 is phi1
plain_name: "Callable[[str], str]" = methodcaller("translate", str.maketrans(GREEK))

_NUMBER = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_WORD = re.compile(r"[^\W\d]\w*")             # a name, where its letters are those below
# Patterns that few scenes need, the first of a table of all characters: each is compiled where it is first matched.
_NAME = r"[A-Za-z_α-ωΑ-Ωϕϑϵ][A-Za-z0-9_α-ωΑ-Ωϕϑϵ]*"
_PER_UNIT = r"1\s*/\s*[A-Za-z]"
_PART = r"\.(?:[A-Za-z_][A-Za-z0-9_]*|[0-9]{1,3})"
LONGEST_INDEX = 80
_BETWEEN = r",(?![^()]*\))"                    # commas that no brackets hold
_SPACES = " ", "\t", "\n"
_SIGNS, _FACTORS = {"+": 1, "-": -1}, {"*": 1, "·": 1, "/": -1}


@lru_cache(REMEMBERED)
def parse(text: str, equation: str | None = None) -> Any:
    """The syntax tree of `text`, one tree for texts that are alike; of `left = right` where `equation` gives an example
    of one."""
    if len(text) > LONGEST:
        raise ExpressionError(0, 1, f"this expression has {len(text)} characters; the limit is {LONGEST}",
                              "give parts of it names under parameters")
    if not equation and (number := _NUMBER.fullmatch(text)):
        return literal(text, number)
    parser = _Parser(text)
    tree = parser.expression(0)
    if equation:
        parser.skip()
        if not parser.take("="):
            if text[parser.at:parser.at + 1] not in "<>":
                parser.fail_after()
            raise ExpressionError(parser.at, 1, "expected an equation, found an expression",
                                  "write it as left = right, for example " + equation)
        if parser.text.startswith("=", parser.at):
            raise ExpressionError(parser.at, 1, "an equation has one '='", "write left = right")
        right = parser.expression(0)
        parser.skip()
        if parser.text.startswith("=", parser.at):
            raise ExpressionError(parser.at, 1, "an equation has one '='", "write left = right")
        tree = Equation(0, len(text), tree, right)
    parser.skip()
    if parser.at < len(text):
        parser.fail_after()
    return tree


def _name(text: str, at: int) -> "Match[str] | None":
    """The match of a name at a place, None where there is none."""
    word = _WORD.match(text, at)
    return word if word is None or word.group().isascii() else re.compile(_NAME).match(text, at)


class _Parser:
    def __init__(self, text: str) -> None:
        self.text, self.at, self.depth = text, 0, 0

    def skip(self) -> None:
        while self.text.startswith(_SPACES, self.at):
            self.at += 1

    def take(self, token: str) -> bool:
        self.skip()
        if self.text.startswith(token, self.at):
            self.at += len(token)
            return True
        return False

    def fail_after(self) -> None:
        """Something stands where an operator or the end was expected."""
        found = self.text[self.at]
        word = _name(self.text, self.at)
        if found == "=":
            raise ExpressionError(self.at, 1, "expected an expression, found an equation", "write what one side is")
        if found in "<>":
            raise ExpressionError(self.at, 1, f"expected an expression, found a comparison with '{found}'",
                                  "comparisons stand under `require` of `variants`")
        if word or found in "(" or found.isdecimal():
            what = word.group() if word else found
            raise ExpressionError(self.at, len(what), f"expected an operator before {quoted(what)}", self._joined(what))
        from vibcli.symbolic.foreign_signs import of_sign

        raise ExpressionError(self.at, 1, f"found {quoted(found)} where the expression should go on or end",
                              of_sign(self.text, self.at))

    def _joined(self, what: str) -> str:
        """The hint where a number or name is followed by another."""
        if re.compile(_PER_UNIT).match(self.text, self.at):
            return "the unit 1/s is written s^-1: 3 s^-1"
        from vibcli.symbolic.foreign_signs import of_digits

        if hint := of_digits(self.text, self.at):
            return hint
        if what == "(" and (word := re.compile(r"[A-Za-z]\w*(?= +$)").search(self.text, 0, self.at)):
            return f"the bracket follows the name at once: {word.group()}(…); a product is written with *"
        if self.text[self.at - 1].isdigit() and what[0] in "_xXob":
            return "numbers are written in decimal digits alone: 1000"
        return "there is no implicit multiplication: write a * between factors"

    def expression(self, depth: int) -> Any:
        """A sum of products."""
        if depth > DEEPEST:
            raise ExpressionError(self.at, 1, f"more than {DEEPEST} levels of parentheses", "name the inner parts")
        self.skip()
        start, terms = self.at, []
        sign = -1 if self.take("-") else 1
        if sign == 1:
            self.take("+")
        while True:
            terms.append((sign, self.product(depth)))
            if len(terms) > PARTS:
                raise ExpressionError(start, 1, f"more than {PARTS} terms in one sum", "name parts of it")
            self.skip()
            sign = _SIGNS.get(self.text[self.at:self.at + 1], 0)
            if not sign:
                break
            self.at += 1
        if len(terms) == 1 and terms[0][0] == 1:
            return terms[0][1]
        return Sum(start, self.at, tuple(terms))

    def product(self, depth: int) -> Any:
        self.skip()
        start, factors, power = self.at, [], 1
        while True:
            factors.append((power, self.power(depth)))
            if len(factors) > PARTS:
                raise ExpressionError(start, 1, f"more than {PARTS} factors in one product", "name parts of it")
            self.skip()
            power = _FACTORS.get(self.text[self.at:self.at + 1], 0)
            if not power or self.text.startswith("**", self.at):
                break
            self.at += 1
        return factors[0][1] if len(factors) == 1 else Product(start, self.at, tuple(factors))

    def power(self, depth: int) -> Any:
        self.skip()
        start = self.at
        base = self.atom(depth)
        self.skip()
        if self.text.startswith(("^", "**"), self.at):
            self.at += 1 + self.text.startswith("*", self.at)
            if depth > DEEPEST:
                raise ExpressionError(self.at, 1, f"more than {DEEPEST} powers of powers", "name the inner parts")
            self.skip()
            inner = self.at
            negative = self.take("-")
            exponent = self.power(depth + 1)
            if negative:
                exponent = Sum(inner, self.at, ((-1, exponent),))
            return Power(start, self.at, base, exponent)
        return base

    def atom(self, depth: int) -> Any:
        self.skip()
        start = self.at
        number = _NUMBER.match(self.text, start)
        if number:
            found = literal(self.text, number)
            self.at = found.end
            return found
        word = _name(self.text, start)
        if word:
            return self.applied(self.word(word, depth), start, depth)
        if self.take("("):
            inner = self.expression(depth + 1)
            self.close(start, ")")
            return self.applied(inner, start, depth)
        if start >= len(self.text):
            raise ExpressionError(max(start - 1, 0), 1, "the expression ends too early",
                                  "a number, a name or a bracket is missing at its end")
        if self.text[start] in "+-":
            raise ExpressionError(start, 1, "two operators in a row", "put the signed factor in parentheses")
        from vibcli.symbolic.foreign_signs import of_sign

        raise ExpressionError(start, 1, f"expected a number, a name or '(', found {quoted(self.text[start])}",
                              of_sign(self.text, start))

    def applied(self, tree: Any, start: int, depth: int) -> Any:
        """x(2 s) of a tree x that is no function; `start` is where its text starts."""
        while self.text.startswith("(", self.at):
            if depth > DEEPEST:
                raise ExpressionError(self.at, 1, f"more than {DEEPEST} levels of parentheses", "name the inner parts")
            depth += 1
            args = self.arguments(depth)
            component = self.component()
            tree = QuantityRef(start, self.at, self.text[start:self.at], VALUE, (), component, (tree, *args))
        return tree

    def arguments(self, depth: int) -> list[Any]:
        """The trees within round brackets."""
        start, self.at = self.at, self.at + 1
        args = [self.expression(depth + 1)]
        while self.take(","):
            args.append(self.expression(depth + 1))
        self.close(start, ")")
        return args

    def close(self, start: int, bracket: str) -> None:
        if not self.take(bracket):
            self.skip()
            if self.at >= len(self.text):
                raise ExpressionError(start, 1, "this bracket is never closed", f"write '{bracket}' where it ends")
            self.fail_after()

    def word(self, match: "Match[str]", depth: int) -> Call | NameRef | QuantityRef:
        start, self.at = match.start(), match.end()
        name = match.group()
        if len(name) > 32:
            raise ExpressionError(start, len(name), "a name has at most 32 characters", "shorten it")
        if self.text.startswith("(", self.at) and (name in FUNCTIONS or name in OF_SIGNALS):
            return self.call(start, name, depth)
        if self.text.startswith("[", self.at):
            return self.quantity(start, name, depth)
        while self.text.startswith(".", self.at) and (part := re.compile(_PART).match(self.text, self.at)):
            self.at = part.end()
        name = self.text[start:self.at]
        primes = 0
        while primes < 3 and self.text.startswith("'", self.at):
            primes, self.at = primes + 1, self.at + 1
        if primes > 2:
            raise ExpressionError(start, self.at - start, "derivatives go up to the second", "write x' or x''")
        if primes and plain_name(name) == "pi":
            raise ExpressionError(start, self.at - start, "pi has no derivative", "only coordinates move")
        return NameRef(start, self.at, plain_name(name), primes)

    def call(self, start: int, name: str, depth: int) -> Call | QuantityRef:
        args = self.arguments(depth)
        wanted = FUNCTIONS.get(name, 1)
        if len(args) == 1 and name in OF_SIGNALS and (wanted != 1 or name not in FUNCTIONS):
            return QuantityRef(start, self.at, self.text[start:self.at], name, (), "", tuple(args))
        if len(args) != wanted:
            raise ExpressionError(start, self.at - start, f"{name} takes {wanted} argument"
                                  + ("s" if wanted > 1 else "") + f", found {len(args)}",
                                  f"write {name}(" + ", ".join("xy"[:wanted]) + ")")
        return Call(start, self.at, name, tuple(args))

    def quantity(self, start: int, head: str, depth: int) -> QuantityRef:
        if head in FUNCTIONS:
            raise ExpressionError(self.at, 1, f"{head} takes its argument in round brackets", f"write {head}(…)")
        indices, last = [], ()
        while index := self._index():
            last = re.split(_BETWEEN, index) if "," in index else [index]
            indices.extend(plain_name(part.strip()) for part in last)
            self.at += len(index) + 2
        if self.text.startswith("[", self.at):
            raise ExpressionError(self.at, 1, "this index is not closed or empty", "write it as omega[1] or J[disc, O]")
        args = self.arguments(depth) if self.text.startswith("(", self.at) else []
        if head in IN_TWO_BRACKETS and self.text.startswith("(", self.at):
            args += self.arguments(depth)
        component = self.component()
        return QuantityRef(start, self.at, self.text[start:self.at], plain_name(head), tuple(indices), component,
                           tuple(args), alone=len(last) == 1)

    def _index(self) -> str:
        """What stands between square brackets at this place; '' where there is nothing, or too much."""
        if not self.text.startswith("[", self.at):
            return ""
        found, closed, _ = self.text[self.at + 1:self.at + LONGEST_INDEX + 2].partition("]")
        return found if closed and "[" not in found else ""

    def component(self) -> str:
        """The word after a dot, such as x of centre[rod].x, or nothing."""
        if self.text.startswith(".", self.at) and (word := _name(self.text, self.at + 1)):
            self.at = word.end()
            return word.group()
        return ""
