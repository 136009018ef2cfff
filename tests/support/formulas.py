"""Formulas read back from what is printed: tokens to a value, and Unicode text to tokens (typeset.py: LaTeX, MathML).

A notation becomes a list of tokens as the eye reads them; one grammar reads those of all:

    sum      [−] term {± term}                 term    factor {[· or /] factor}: side by side they are multiplied
    factor   atom [power], function [power] argument, √ atom
    atom     number, symbol, bracket, |sum|, fraction, root

A symbol is its letters in a row: l₁, l_{1} and <msub> are all "l1"; its dots are primes.
"""

import cmath
import re
import unicodedata
from functools import lru_cache

FUNCTIONS = {"sin": cmath.sin, "cos": cmath.cos, "tan": cmath.tan, "exp": cmath.exp, "ln": cmath.log, "log": cmath.log,
             "sinh": cmath.sinh, "cosh": cmath.cosh, "tanh": cmath.tanh, "sqrt": cmath.sqrt, "abs": abs,
             "sign": lambda x: (x.real > 0) - (x.real < 0), "min": lambda *x: min(x, key=lambda y: y.real),
             "max": lambda *x: max(x, key=lambda y: y.real),
             "atan2": lambda y, x: cmath.phase(complex(x.real, y.real))}
FUNCTIONS |= {prefix + name: getattr(cmath, "a" + name) for name in ("sin", "cos", "tan") for prefix in ("a", "arc")}
PULSES = ("step", "ramp", "impulse", "square", "sawtooth")
RELATIONS = "=<>≤≥≈,"
KEPT = 1000     # texts


class Unreadable(Exception):
    """This is no formula that the readers know."""


def agree(found, wanted):
    return abs(found - wanted) <= 1e-6 * max(abs(wanted), abs(found)) + 1e-9


# from tokens to a value

def value(tokens, values):
    """The number that tokens stand for; `values(symbol)` is that of a symbol."""
    found, rest = _sum(list(tokens), values)
    if rest:
        raise Unreadable(rest)
    return found


def _sum(tokens, values):
    negative, signed = bool(tokens) and tokens[0] == "-", bool(tokens) and tokens[0] in ("+", "-")
    total, tokens = _term(tokens[signed:], values)
    total = -total if negative else total
    while tokens and tokens[0] in ("+", "-"):
        term, rest = _term(tokens[1:], values)
        total, tokens = total + (term if tokens[0] == "+" else -term), rest
    return total, tokens


def _term(tokens, values):
    total, tokens = _factor(tokens, values)
    while tokens and tokens[0] not in ("+", "-"):
        below = tokens[0] == "/"
        factor, tokens = _factor(tokens[tokens[0] in ("*", "/"):], values)
        total = total / factor if below else total * factor
    return total, tokens


def _factor(tokens, values):
    if not tokens:
        raise Unreadable("nothing where a factor is due")
    first, rest = tokens[0], tokens[1:]
    if first == "√":
        found, rest = _atom(rest, values)
        return cmath.sqrt(found), rest
    if first[0] != "function":
        found, rest = _atom(tokens, values)
        return _powered(found, rest, values)
    outer = [1, []]
    if rest and rest[0][0] == "power":
        outer, rest = [value(rest[0][1], values), []], rest[1:]
    if rest and rest[0][0] == "bracket":
        args, rest = [value(part, values) for part in _parts(rest[0][1])], rest[1:]
    else:
        arg, rest = _atom(rest, values)
        arg, rest = _powered(arg, rest, values)     # sin φ² is that of φ²
        args = [arg]
    found = FUNCTIONS[first[1]](*args) if first[1] in FUNCTIONS else values(first[1]) * args[0]
    found = found ** outer[0]
    return _powered(found, rest, values)


def _powered(found, rest, values):
    if rest and rest[0][0] == "power":
        return found ** value(rest[0][1], values), rest[1:]
    return found, rest


def _atom(tokens, values):
    if not tokens or isinstance(tokens[0], str):
        raise Unreadable(tokens[:1])
    kind, *parts = tokens[0]
    if kind == "number":
        found = float(parts[0])
    elif kind == "symbol":
        found = values(parts[0])
    elif kind == "fraction":
        found = value(parts[0], values) / value(parts[1], values)
    elif kind in ("bracket", "magnitude", "root"):
        found = value(parts[0], values)
        found = abs(found) if kind == "magnitude" else cmath.sqrt(found) if kind == "root" else found
    else:
        raise Unreadable(kind)
    return complex(found), tokens[1:]


def _parts(tokens):
    found = [[]]
    for token in tokens:
        if token == ",":
            found.append([])
        else:
            found[-1].append(token)
    return found


def sides(tokens):
    """Tokens between relations and commas."""
    found = [[]]
    for token in tokens:
        if isinstance(token, str) and token in RELATIONS:
            found.append([])
        else:
            found[-1].append(token)
    return [side for side in found if side]


def bracketed(flat):
    """Tokens in which ( … ), and bars, are one token each."""
    stack = [["", []]]
    for token in flat:
        opens = token == "|" and (not stack[-1][1] or stack[-1][1][-1] in ("+", "-", "*", "/", ",")
                                  or stack[-1][0] != "|")
        if token == "(" or (token == "|" and opens):
            stack.append([token, []])
        elif token in (")", "|"):
            opened, inside = stack.pop()
            if opened != {")": "(", "|": "|"}[token]:
                raise Unreadable("brackets")
            stack[-1][1].append(("bracket" if token == ")" else "magnitude", inside))
        else:
            stack[-1][1].append(token)
    if len(stack) != 1:
        raise Unreadable("brackets")
    return stack[0][1]


# plain text

_PLAIN = re.compile(r"(?P<number>\d+(?:\.\d+)?(?:e[-−+]?\d+)?)|(?P<raised>[⁻⁰¹²³⁴-⁹]+)|(?P<mark>[-+−·.*/(),|√^<>=≤≥≈])"
                    r"|(?P<name>[^\W\d_](?:[^\W⁰¹²³⁴-⁹]|['\u0307\u0308])*)|(?P<gap>\s+)")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_MARKS = {"−": "-", "·": "*", ".": "*"}


@lru_cache(KEPT)
def plain(text):
    """The tokens of a text, which whoever finds roots of it reads again and again."""
    return raised(bracketed(flattened(re.sub(r"(?<=[0-9])\u00a0[\w·²³/]+(?=[)/ ]|$)", "", text))))       # without units


def flattened(text):
    """The tokens of a text, each bracket one; ± is read as +, ∓ as −, and δx as a product."""
    flat, at = [], 0
    text = re.sub("(?<=[₀-₉]),(?=[₀-₉])", "", text)
    text = re.sub("δ(?=[^\\W\\d_])", "δ·", text.replace("∓", "−").replace("±", "+"))
    while at < len(text):
        token = _PLAIN.match(text, at)
        if token is None:
            raise Unreadable(text[at:])
        at = token.end()
        if token["number"]:
            flat.append(("number", token["number"].replace("−", "-")))
        elif token["raised"]:
            flat.append(("power", plain(token["raised"].translate(_RAISED))))
        elif token["name"]:
            name = symbol(token["name"])
            flat.append(("function" if name in FUNCTIONS or name in PULSES else "symbol", name))
        elif token["mark"]:
            flat.append(_MARKS.get(token["mark"], token["mark"]))
    return flat


def raised(tokens):
    """Tokens in which ^ and what follows it is a power."""
    found, tokens = [], list(tokens)
    while tokens:
        token = tokens.pop(0)
        if token == "^":
            token = ("power", tokens[0][1] if tokens[0][0] == "bracket" else tokens[:1])
            tokens.pop(0)
        elif token[0] in ("bracket", "magnitude"):
            token = (token[0], raised(token[1]))
        found.append(token)
    return found


def symbol(text):
    """Letters and indices in a row, then primes for dots."""
    letters = "".join(letter for letter in unicodedata.normalize("NFD", text)
                      if letter not in "_,'\u0307\u0308").translate(_LOWERED)
    dotted = unicodedata.normalize("NFD", text)
    return letters + "'" * (dotted.count("\u0307") + 2 * dotted.count("\u0308") + dotted.count("'"))
