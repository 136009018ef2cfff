"""Signs and groups of digits that are written elsewhere and not here, and what to write for them: hints of messages."""

import re

_WRITTEN = {sign: hint for signs, hint in (
    ("′″´’‘`\"”“ẋẍẏÿż\u0307\u0308", "derivatives are written with ': x' and x''"),
    ("–−—", "minus is written -"), ("×⋅∙•∗", "a product is written with *"), ("÷:", "a quotient is written with /"),
    ("√", "a root is written sqrt(…)"), ("½", "write 1/2"), ("{}", "brackets are round: ( )"),
    ("\\", r"functions and Greek letters are written without \: sqrt(…), alpha"),
    ("[]", "brackets are round, and units have none"), ("²³⁴", "a power is written with ^: x^2"),
    ("₀₁₂₃₄₅₆₇₈₉", "digits of a name stand in the line, x1, an index in brackets, omega[1]"),
    ("≈±", "write the number alone; `rtol` says how far it may be off"), ("#", "a comment has a blank before its #"),
) for sign in signs}
_KNOWN = "expressions are made of numbers, units, names, + - * / ^ ( ) and functions"
_GROUPED = re.compile(r"(?<![\w.])\d{1,3}(?:[ ,.'’\u00a0\u202f]\d{3})+(?![\d])(?:[.,]\d+)?")
_OF_TEN = re.compile(r"[xX×]\s*10\s*(?:\^|\*\*|[⁻⁰¹²³⁴-⁹])")
_FRACTION = re.compile(r"(\d[\d.]*)\s*/\s*(\d[\d.]*)\s*([A-Za-zµ°][\w/*^µ°]*)")
_ROOT = re.compile(r"(?:\^|\*\*)\s*1\s*/\s*(\d)")
_POINT = "decimals are written with a point: 0.5"


def of_sign(text: str, at: int) -> str:
    """The hint where the sign at a place is none of expressions."""
    if text[at] == "[" and text[at - 1:at] == " " and text[:at].rstrip()[-1:].isidentifier():
        return "an index follows its name at once, as in omega[1]"
    return of_digits(text, at) or _WRITTEN.get(text[at], _KNOWN)


def of_digits(text: str, at: int) -> str | None:
    """The hint where a number is grouped by threes, or has a power of ten or a decimal comma, at a place; None
    elsewhere."""
    if _OF_TEN.match(text, at) and text[:at].rstrip()[-1:].isdigit():
        return "powers of ten are written with e: 2e3"
    for found in _GROUPED.finditer(text):
        if found.start() < at <= found.end():
            return _ungrouped(found.group())
    return _POINT if text[at] == "," else None


def _ungrouped(number: str) -> str:
    """1,500 and 1.500,0 as they are written here; one comma alone may be that of a decimal."""
    *groups, last = re.split(r"[ ,.'’\u00a0\u202f]", number)
    signs = re.findall(r"\D", number)
    if signs == [","] and int(groups[0]):
        return f"write {groups[0]}{last} without a comma, or {groups[0]}.{last} where it is that of a decimal"
    if signs == [","]:
        return _POINT
    decimal = signs[-1] in ",." and signs[-1] != signs[0]
    return f"digits are not grouped: write {''.join(groups)}{'.' * decimal}{last}"


def of_form(text: str) -> str | None:
    """The hint where a text has another dimension than it looks: 4/5 m is 4/(5 m), and x^1/2 is x/2."""
    if fraction := _FRACTION.fullmatch(text.strip()):
        above, below, unit = fraction.groups()
        return f"{above}/{below} {unit} is {above}/({below} {unit}): write {above} {unit}/{below}"
    root = _ROOT.search(text)
    return f"{root.group()} is the power 1, divided by {root[1]}: write ^(1/{root[1]})" if root else None
