"""Typeset formulas read back: LaTeX, that of Markdown too, MathML and Typst to the tokens of formulas.py."""

import re
import unicodedata
import xml.etree.ElementTree as ET

from support.formulas import FUNCTIONS, Unreadable, bracketed, symbol

GREEK = {"varphi": "φ", "varepsilon": "ε", "ell": "ℓ", "partial": "∂", "Sigma": "Σ", "sum": "Σ"} | {
    name: unicodedata.lookup(f"GREEK {case} LETTER {word.upper().replace('LAMBDA', 'LAMDA')}")
    for word in ("alpha", "beta", "gamma", "delta", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
                 "rho", "sigma", "tau", "upsilon", "chi", "psi", "omega", "pi", "phi")
    for case, name in (("SMALL", word), ("CAPITAL", word.capitalize()))}


# LaTeX

_LATEX = re.compile(r"\\left|\\right|\\[a-zA-Z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.DOTALL)
_SPACES = {r"\,", r"\;", r"\quad", r"\mkern"}
_SIGNS = {r"\pm": "+", r"\mp": "-", r"\le": "≤", r"\ge": "≥", r"\cdot": "*", ".": "*"} | {
    sign: sign for sign in "-+=<>()|,/"}
_DOTTED = {r"\dot": "'", r"\ddot": "''"}
_OURS = {r"\arcsin", r"\arccos", r"\arctan"} | {"\\" + name for name in FUNCTIONS}


def latex(text):
    """The tokens of LaTeX."""
    text = re.sub(r"\\mkern\dmu", r"\\,", text)
    text = re.sub(r"(?<=\d) \\text\{ (?:[^{}]|\\ensuremath\{(?:[^{}]|\{[^{}]*\})*\})*\}", "", text)       # a unit
    text = re.sub(r"\\(?:begin|end)\{aligned\}|(?:\\\\|\\cr) & \\quad \{\}|& ", " ", text)       # rows are one
    return bracketed(_latex([part for part in _LATEX.findall(text) if not part.isspace()]))


def _latex(parts):
    found = []
    while parts and parts[0] != "}":
        part = parts.pop(0)
        if part in _SPACES or part in (r"\left", r"\right"):
            continue
        if part in _SIGNS:
            found.append(_SIGNS[part])
        elif part[0].isdigit():
            found.append(("number", part))
        elif part == r"\frac":
            found.append(("fraction", _braced(parts), _braced(parts)))
        elif part == r"\sqrt":
            found.append(("root", _braced(parts)))
        elif part == "^":
            found.append(("power", _braced(parts)))
        elif part in _OURS or part == r"\operatorname":
            found.append(("function", part[1:] if part in _OURS else _word(parts)))
        else:
            found.append(("symbol", _letter(part, parts)))
    return found


def _braced(parts):
    if parts.pop(0) != "{":
        raise Unreadable("a brace is missing")
    found = bracketed(_latex(parts))
    parts.pop(0)
    return found


def _word(parts):
    """The letters between braces, indices in a row."""
    if parts.pop(0) != "{":
        raise Unreadable("a brace is missing")
    found = ""
    while parts[0] != "}":
        if parts[0] == "{":
            found += _word(parts)
            continue
        part = parts.pop(0)
        found += "" if part in (r"\_", "_", ",") else _letter(part, parts) if part[0] == "\\" else part
    parts.pop(0)
    return found


def _letter(part, parts):
    primes = _DOTTED.get(part, "")
    if primes or part in (r"\mathrm", r"\text"):
        found = _word(parts)
    elif part[0] == "\\" and part[1:] in GREEK:
        found = GREEK[part[1:]]
    elif part.isalpha():
        found = part
    else:
        raise Unreadable(part)
    while parts[:1] == ["_"]:
        parts.pop(0)
        found += _word(parts)
    return found + primes


# MathML

UNIT = "\u00a0"     # begins what stands behind a number
_OPERATORS = {"\u2062": "*", "·": "*", "−": "-", "±": "+", "∓": "-", ".": "*"}


def mathml(text):
    """The tokens of the inside of a <math> element."""
    return bracketed(_row(ET.fromstring(f"<math>{text}</math>")))


def _row(element):
    found, parts = [], [part for part in element if part.tag != "mtext" or not (part.text or "").startswith(UNIT)]
    for part, after in zip(parts, [*parts[1:], None], strict=True):
        if after is not None and after.text == "\u2061" and part.tag == "mi":
            found.append(("function", _name(part)))
        else:
            found += _element(part)
    return found


def _element(part):
    text = part.text or ""
    if part.tag in ("mrow", "math"):
        return _row(part)
    if part.tag == "mn":
        return [("number", text)]
    if part.tag == "mo":
        if text == "∑":
            return [("symbol", "Σ")]
        return [] if text == "\u2061" else [_OPERATORS.get(text, text)]
    if part.tag == "mspace":
        return []
    if part.tag in ("mtable", "mtr", "mtd"):
        return _row(part)
    if part.tag == "mfrac":
        return [("fraction", *(bracketed(_element(one)) for one in part))]
    if part.tag == "msqrt":
        return [("root", bracketed(_row(part)))]
    if part.tag == "msup":
        return [*_element(part[0]), ("power", bracketed(_element(part[1])))]
    if part.tag == "msubsup":
        return [("symbol", _name(part)), ("power", bracketed(_element(part[2])))]
    name = _name(part)
    return [("function", name) if part.tag == "mi" and name in FUNCTIONS else ("symbol", name)]


def _name(part):
    if part.tag in ("mi", "mn"):
        return symbol(part.text)
    if part.tag == "mover":
        return _name(part[0]) + "'" * len(part[1].text)
    if part.tag in ("msub", "msubsup"):
        inner = "".join(_name(one) for one in part[1]) if part[1].tag == "mrow" else _name(part[1])
        bare = _name(part[0])
        return bare.rstrip("'") + inner + "'" * (len(bare) - len(bare.rstrip("'")))
    raise Unreadable(part.tag)


# Typst

_TYPST = re.compile(r'"(?:\\.|[^"\\])*"|[a-z]+(?:\.[a-z]+)+|[a-z]{2,}|\d+(?:\.\d+)?|\\.|\s+|.', re.DOTALL)
_TYPST_SPACES = {"thin", "thick", "quad"}
_TYPST_SIGNS = {"⋅": "*", ".": "*", "±": "+", "∓": "-", "\\/": "/"} | {sign: sign for sign in "-+=<>≤≥,|"}
_TYPST_DOTTED = {"dot": "'", "dot.double": "''"}
_TYPST_FUNCTIONS = {"arcsin", "arccos", "arctan", *FUNCTIONS}


def typst(text):
    """The tokens of Typst between dollar signs."""
    text = re.sub(r'(?<=\d)" [^"]*"', "", text)       # a unit
    return _typst([part for part in _TYPST.findall(text) if not part.isspace()], "")


def _typst(parts, ends):
    """Tokens up to one of the marks that end what they stand in."""
    found = []
    while parts and parts[0] not in ends:
        part = parts.pop(0)
        if part in _TYPST_SPACES:
            continue
        if part in _TYPST_SIGNS:
            found.append(_TYPST_SIGNS[part])
        elif part[0].isdigit():
            found.append(("number", part))
        elif part == "(":
            found.append(("bracket", _until(parts)))
        elif part == "^":
            found.append(("power", _opened(parts)))
        elif part == "frac":
            found.append(("fraction", *_two(parts)))
        elif part == "sqrt":
            found.append(("root", _opened(parts)))
        elif part == "mat":
            found += _rows(parts)
        elif part in ("inline", "lr"):
            found += _opened(parts)
        elif part in _TYPST_FUNCTIONS or part == "op":
            found.append(("function", part if part != "op" else _plain_word(parts)))
        else:
            found.append(("symbol", _typst_letter(part, parts)))
    return bracketed(found)


def _opened(parts):
    """The tokens in the brackets that open here."""
    if parts.pop(0) != "(":
        raise Unreadable("a bracket is missing")
    return _until(parts)


def _until(parts):
    found = _typst(parts, ")")
    parts.pop(0)
    return found


def _rows(parts):
    """The tokens of all rows of a column."""
    found = []
    del parts[:parts.index("display")]
    while parts.pop(0) != ")":
        if parts[0] == "(":
            found += _opened(parts)
    return found


def _two(parts):
    parts.pop(0)
    above = _typst(parts, ",")
    parts.pop(0)
    return above, _until(parts)


def _plain_word(parts):
    """The letters in brackets, indices in a row."""
    if parts.pop(0) != "(":
        raise Unreadable("a bracket is missing")
    found = ""
    while parts[0] != ")":
        part = parts.pop(0)
        found += "" if part == "," else part if part[0].isdigit() else _typst_letter(part, parts)
    parts.pop(0)
    return found


def _typst_letter(part, parts):
    primes = _TYPST_DOTTED.get(part, "")
    if primes:
        found = _plain_word(parts)
    elif part[0] == '"':
        found = part[1:-1].replace("_", "")
    elif part.isalpha() or part in "∂ℓΣ∑":
        found = part.replace("∑", "Σ")
    else:
        raise Unreadable(part)
    while parts[:1] == ["_"]:
        parts.pop(0)
        found += _plain_word(parts)
    return found + primes
