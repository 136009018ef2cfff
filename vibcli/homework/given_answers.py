"""Answers as students write them: numbers with a unit or without, decimal points or commas."""

import re
import unicodedata
from math import isfinite

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.given_values import unit_of_text
from vibcli.symbolic.parser import parse, plain_name
from vibcli.symbolic.syntax import ExpressionError, Number

LONGEST = 200
NUMBER = re.compile(r"\s*(?P<sign>[-+−]?)\s*(?P<whole>\d+(?:[ _]\d{3})*)?(?:(?P<mark>[.,])(?P<part>\d*))?"
                    r"(?:\s*(?:[eE]|[×x*·⋅]\s*10\s*\^)\s*(?P<power>[-+−]?\d{1,3})"
                    r"|\s*[×x*·⋅]\s*10(?P<raised>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3}))?\s*(?P<unit>.*)$", re.DOTALL)
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−·", "0123456789--*")
GROUPED = re.compile(r"[.,'’]\d")
NAMED = re.compile(r"\s*([^\W\d][^=≈]*?)\s*[=≈](.*)", re.DOTALL)
OF_ONE = re.compile(r"([^\W\d][\w.']*)[\[(][^\[\]()]*[\])]")       # omega_d[1], amplitude(x)
RAISED = re.compile(r"([⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)")


class GivenAnswer(NamedTuple):
    """What was read: the number in the unit that is asked, None where it is none; reason: why it is none; unit: that in
    which it was given, '' where none stands; half: of the last figure, in the unit that is asked."""

    value: float | None
    reason: str = ""
    unit: str = ""
    half: float = 0.0


def read_answer(text: str, unit: str) -> GivenAnswer:
    """The GivenAnswer of a text, where the answer is asked in a unit ('' of pure numbers). A number of cycles is taken
    for one of radians: that is a mistake of its own, and named so."""
    text = text.strip()
    if not text:
        return GivenAnswer(None, "there is no answer")
    match = NUMBER.match(text) if len(text) <= LONGEST else None
    if match is None or (match["whole"] is None and not match["part"]):
        return GivenAnswer(None, "this is no number with a unit")
    if GROUPED.match(match["unit"]):
        return GivenAnswer(None, "write the number without signs between its thousands")
    if match["mark"] == "," and len(match["part"]) == 3 and match["whole"] not in (None, "0"):
        return GivenAnswer(None, f"'{match['whole']},{match['part']}' may mean {match['whole']}.{match['part']} or "
                                 f"{match['whole']}{match['part']}: write it with a point, or without a comma")
    digits = re.sub(r"[ _]", "", match["whole"] or "0") + "." + (match["part"] or "0")
    power = (match["power"] or (match["raised"] or "0").translate(SUPERSCRIPTS)).replace("−", "-")
    number = float(f"{'-' if match['sign'] in ('-', '−') else ''}{digits}e{power}")
    if not isfinite(number):
        return GivenAnswer(None, "this number is too large")
    half = 0.5 * 10.0 ** (int(power) - len(match["part"] or ""))
    return _in_unit(number, half, _plain(match["unit"]), unit)


def without_name(text: str, quantity: str) -> str:
    """What stands behind the name in ζ = 0.2 or omega_1 = 3 rad/s, where it is that of what is asked, its index or
    argument told or not; any other text as it is."""
    found, of_one = NAMED.fullmatch(text[:LONGEST + 1]), OF_ONE.fullmatch(quantity)
    names = {_bare(quantity), _bare(of_one[1] if of_one else quantity)}
    return found[2] if found and _bare(found[1]) in names else text


def _bare(name: str) -> str:
    """omegad1 of ω_d,₁ and of omega_d[1]."""
    return re.sub(r"[^\w']|_", "", plain_name(unicodedata.normalize("NFKC", name)))


def _plain(text: str) -> str:
    """The text of a unit as the language writes it: m/s² as m/s^2."""
    text = RAISED.sub(lambda found: "^" + found[0].translate(SUPERSCRIPTS), text.strip())
    text = text.replace("·", "*").replace("°", "deg").strip()
    return f"{text[2:]}^-1" if text.startswith("1/") else text


def _in_unit(number: float, half: float, given: str, unit: str) -> GivenAnswer:
    if not given or given == unit:
        return GivenAnswer(number, "", given, half)
    try:
        tree = parse(f"1 {given}")
    except ExpressionError:
        return GivenAnswer(None, f"'{given[:40]}' is not a unit")
    if not isinstance(tree, Number) or not tree.units:
        return GivenAnswer(None, f"'{given[:40]}' is not a unit")
    found, asked = unit_of_text(given), unit_of_text(unit)
    if found.dimension != (asked.dimension if asked is not None else {}):
        return GivenAnswer(None, f"'{given}' measures something else than {unit or 'a pure number'}", given)
    factor = found.in_si(1) / (asked.in_si(1) if asked is not None else 1.0)
    return GivenAnswer(number * factor, "", given, half * factor)
