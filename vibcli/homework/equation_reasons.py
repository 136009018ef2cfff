"""Why an equation is wrong to which no known mistake leads: which of its terms do not fit its key, not how much."""

from collections.abc import Mapping

from vibcli.homework.reasons import UNKNOWN
from vibcli.homework.terms import OF_NUMBERS, alike


def of_terms(found: Mapping[str, float] | None, key: Mapping[str, float], band: float) -> str:
    """Why an equation is wrong, by its coefficients in the terms of the key, None where it is not made of these."""
    if found is None:
        return f"{UNKNOWN}: it is not made of the terms of the key"
    for text in key:
        if alike(key, {**found, text: -found[text]}, band):
            return f"the equation is right but for the sign of {_term(text, len(key))}"
    for text in key if len(key) > 2 else ():
        if alike(_without(key, text), _without(found, text), band):
            return f"the equation is right but for {_term(text, len(key))}"
    return f"{UNKNOWN}: its coefficients are not to each other as those of the key"


def _without(terms: Mapping[str, float], text: str) -> dict[str, float]:
    return {one: number for one, number in terms.items() if one != text}


def _term(text: str, count: int) -> str:
    """A term in words, of two either."""
    return "one of its terms" if count < 3 else "what stands alone" if text == OF_NUMBERS else f"the term with {text}"
