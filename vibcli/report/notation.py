"""Expressions as text, m·L²·φ̈/3, in the notation of the field: dots for time derivatives, roots as √(…)."""

import re
from fractions import Fraction
from operator import itemgetter

from vibcli.algebra.expression import reachable
from vibcli.algebra.pulses import PULSES
from vibcli.algebra.rationals import ONE
from vibcli.report.roots import LARGEST, is_constant, place, split

GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
          "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "rho": "ρ", "sigma": "σ",
          "tau": "τ", "upsilon": "υ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "pi": "π", "Gamma": "Γ",
          "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Phi": "Φ", "Psi": "Ψ",
          "Omega": "Ω"}
_NAME = re.compile(rf"({'|'.join(sorted(GREEK, key=len, reverse=True))}|[A-Za-zℓ])(.*)")
_SUBSCRIPT = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_DOTS = {"": "", "'": "\u0307", "''": "\u0308"}
_PRECOMPOSED = {"x\u0307": "ẋ", "x\u0308": "ẍ", "y\u0307": "ẏ", "y\u0308": "ÿ", "s\u0307": "ṡ", "z\u0307": "ż",
                "u\u0308": "ü", "r\u0307": "ṙ"}


def split_name(name):
    """('φ', '1', "'") of phi1': letter, subscript, primes; a word such as length stays whole."""
    bare = name.rstrip("'")
    primes = name[len(bare):]
    match = _NAME.fullmatch(bare)
    if match is None:
        return bare, "", primes
    letter, rest = match.groups()
    if not rest or rest.isdigit() or rest.startswith("_") or len(bare) == 2 or (letter in GREEK and len(rest) <= 2):
        return letter, rest, primes
    return bare, "", primes


class Notation:
    """Writes nodes; the subclasses say how symbols, products, powers and brackets look."""

    def __call__(self, node):
        return self.write(node, 0)

    def write(self, node, tightness):
        """`tightness`: 0 within a sum, 1 within a product, 2 as the base of a power or argument."""
        return getattr(self, "_" + node.op)(node, tightness)

    def _number(self, node, tightness):
        text = self.number(node.coefficient)
        loose = node.coefficient < 0 or (tightness > 1 and node.coefficient.denominator > 1)
        return self.brackets(text) if loose and tightness else text

    def _pi(self, node, tightness):
        return self.symbol("pi")

    def _symbol(self, node, tightness):
        return self.symbol(node.name)

    def _sum(self, node, tightness):
        terms = sorted(node.args, key=_rank)
        parts = [(c * part.coefficient if part.op == "product" else c, part) for part, c in terms]
        rooted = sum(_is_rooted(part) for part, _ in terms)
        below = _common_denominator(node, [value for value, _ in parts])
        pieces = [(value < 0, self._term(abs(value) * below, part)) for value, part in parts]
        if node.coefficient:
            place = 0 if all(is_constant(part) for part, _ in node.args) else len(pieces)
            pieces.insert(place, (node.coefficient < 0, self.number(abs(node.coefficient) * below)))
        if pieces[0][0]:
            pieces = _positive_first(pieces, rooted)
        turned = below > 1 and pieces[0][0]
        text = ("−" if pieces[0][0] and not turned else "") + pieces[0][1]
        text += "".join((" − " if negative is not turned else " + ") + piece for negative, piece in pieces[1:])
        if below > 1:
            text = self.minus("−" * turned) + self.over(self.minus(text), below)
            return self.brackets(text) if tightness else text
        return self.brackets(self.minus(text)) if tightness else self.minus(text)

    def over(self, text, below):
        return f"({text})/{below}"

    def _term(self, value, part):
        if part.op == "product":
            return self.product(value, part.args)
        return self.product(value, ((part, ONE),))

    def _product(self, node, tightness):
        text = self.product(abs(node.coefficient), node.args)
        if node.coefficient < 0:
            text = self.minus("−" + text)
        return self.brackets(text) if tightness > 1 or (tightness and node.coefficient < 0) else text

    def _call(self, node, tightness):
        if node.name == "power":
            return self.power(self.write(node.args[0], 2), self.write(node.args[1], 0))
        if node.name in PULSES or node.name in node.table.records:
            order = node.args[1].coefficient if len(node.args) > 1 else 0
            return self.function(node.name + "'" * order, [self.write(node.args[0], 0)])
        if len(node.args) == 1:
            return self.call(node.name, node.args[0], ONE)
        return self.function(node.name, [self.write(arg, 0) for arg in node.args])

    def factors(self, value, args):
        """(value, above, below, under the root above, below it): a rational and lists of (node, exponent)."""
        return split(value, sorted(args, key=_factor_rank))

    def powered(self, base, exponent, alone):
        if base.op == "call" and base.name in ("abs", "sign") and exponent != 1:
            return self.power(self.brackets(self.write(base, 0)), self.number(exponent))
        if base.op == "call" and base.name in ("sin", "cos", "tan", "sinh", "cosh", "tanh") and exponent != 1:
            return self.call(base.name, base.args[0], exponent)
        if exponent == 1:
            return self.write(base, 0 if alone else 1)
        if base.op == "sum" and exponent.denominator == 1 and exponent.numerator % 2 == 0:
            leading = min(base.args, key=_rank)
            base = -base if leading[1] < 0 else base
        return self.power(self.write(base, 2), self.number(exponent))


class Plain(Notation):
    """Unicode text; a no-break space holds a function and its argument together."""

    def number(self, value):
        return decimal(value).replace("-", "−")

    def minus(self, text):
        return text

    def symbol(self, name):
        letter, rest, primes = split_name(name)
        letter = GREEK.get(letter, letter)
        if len(letter) > 1:
            return letter + primes
        dotted = letter + _DOTS[primes]
        return _PRECOMPOSED.get(dotted, dotted) + (rest.translate(_SUBSCRIPT) if rest.isdigit() else rest)

    def brackets(self, text):
        return f"({text})"

    def power(self, base, exponent):
        if re.fullmatch(r"-?\d+", exponent):
            return base + exponent.translate(_SUPERSCRIPT)
        return f"{base}^{exponent}" if re.fullmatch(r"\w+", exponent) else f"{base}^({exponent})"

    def function(self, name, args):
        return f"{name}({', '.join(args)})"

    def call(self, name, arg, exponent):
        if name == "abs":
            return f"|{self.write(arg, 0)}|"
        head = name if exponent == 1 else name + decimal(exponent).translate(_SUPERSCRIPT)
        inner = self.write(arg, 0)
        return f"{head}\u00a0{inner}" if arg.op in ("symbol", "pi") else f"{head}({inner})"

    def product(self, value, args):
        value, above, below, root_above, root_below = self.factors(value, args)
        single = len(above) == 1 and value.numerator == 1 and not (below or root_above or root_below)
        tops = [self.powered(base, e, single and value == 1) for base, e in above]
        bottoms = [self.powered(base, e, False) for base, e in below]
        if root_above:
            tops.insert(place(above, root_above), self.root(root_above, root_below))
        elif root_below:
            bottoms.append(self.root(root_below, []))
        if value.denominator > 1 and not shown_as_decimal(value):
            bottoms.insert(0, str(value.denominator))
            value = Fraction(value.numerator)
        if value != 1 or not tops:
            tops.insert(0, decimal(value))
        text = "·".join(tops)
        if not bottoms:
            return text
        return text + "/" + (bottoms[0] if len(bottoms) == 1 else f"({'·'.join(bottoms)})")

    def root(self, above, below):
        inner = self.product(ONE, (*above, *((base, -e) for base, e in below)))
        simple = re.fullmatch(r"[\w₀-₉]+", inner)
        return "√" + (inner if simple or enclosed(inner) else f"({inner})")


def enclosed(text):
    """Is the text one pair of brackets around everything?"""
    depth = 0
    for i, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return text.startswith("(") and i == len(text) - 1
    return False


def shown_as_decimal(value):
    """0.75 m reads better as a decimal, 3/4·m·L² as a fraction: denominators up to 48 are fractions."""
    return value.denominator > LARGEST


def decimal(value):
    """A rational as text: an integer, p/q, or a decimal where that is short enough, else 12 digits."""
    if value.denominator == 1:
        text = str(value.numerator)
        return text if len(text) < 16 else f"{float(value):.12g}"
    if not shown_as_decimal(value):
        return f"{value.numerator}/{value.denominator}".replace("-", "−")
    return f"{float(value):.12g}".replace("-", "−") if abs(value) >= 1e-4 else f"{float(value):.12g}"


def _positive_first(pieces, rooted):
    """The terms of a sum, (negative, text), the positive ones first; the `rooted` last ones stay there if others can
    begin."""
    front = pieces[:len(pieces) - rooted]
    if rooted and not all(negative for negative, _ in front):
        return sorted(front, key=itemgetter(0)) + pieces[len(pieces) - rooted:]
    return sorted(pieces, key=itemgetter(0))


def _is_rooted(node):
    """Does a term of parameters hold the root of a letter or of a sum?"""
    return not node.mask and node.op == "product" and any(
        e.denominator == 2 and not is_constant(base) for base, e in node.args)


def _common_denominator(node, values):
    """The denominator that all terms of a sum of parameters share; 1 where they do not."""
    values = [*values, node.coefficient] if node.coefficient else values
    below = {value.denominator for value in values}
    return 1 if node.mask or len(below) > 1 or shown_as_decimal(values[0]) else below.pop()


def _rank(pair):
    """Accelerations first, then velocities, then coordinates, each in the order of the coordinates; constants last."""
    node = pair[0]
    deepest = _most_primes(node)
    moving = min((base.index for base in _symbols(node) if base.mask and primes(base) == deepest), default=None)
    return -deepest, not node.mask, moving if deepest else _lowest(node.mask), *_letters(node), node.index


def _letters(node):
    """Of terms of parameters those without a root first, then in the order of letters, higher powers first."""
    if node.mask:
        return False, []
    factors = node.args if node.op == "product" else ((node, ONE),)
    return _is_rooted(node), sorted((_first_letter(base), -e) for base, e in factors)


def _first_letter(node):
    return node.index if node.op == "symbol" else min(
        (part.index for part in reachable([node]) if part.op == "symbol"), default=node.index)


def _lowest(mask):
    return (mask & -mask).bit_length()


def primes(symbol):
    """1 for x', 2 for x''."""
    return len(symbol.name) - len(symbol.name.rstrip("'"))


def _symbols(node):
    factors = [base for base, _ in node.args] if node.op == "product" else [node]
    return [base for base in factors if base.op == "symbol"]


def _most_primes(node):
    return max(map(primes, _symbols(node)), default=0)


def _factor_rank(pair):
    """Numbers, parameters, brackets, then functions and variables; velocities and accelerations last."""
    base = pair[0]
    if base.op == "number" or (base.op == "sum" and is_constant(base)):
        kind = -1 if base.op == "number" else 0
    elif base.op in ("symbol", "pi") and not base.mask:
        kind = 1
    elif base.op in ("sum", "call"):
        kind = 2 if base.op == "sum" else 3
    else:
        kind = 4 + _most_primes(base)
    return kind, base.index


plain = Plain()
