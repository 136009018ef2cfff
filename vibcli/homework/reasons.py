"""Why an answer is wrong to which no known mistake leads, in words that may be given back to who wrote it: how it
differs from its key, never the key, nor so closely how far it is that one follows from the other."""

from collections.abc import Iterator
from math import pi, tau

RATIOS = {"2": 2.0, "2π": tau, "60": 60.0, "180/π": 180 / pi, "30/π": 30 / pi}      # of units, and of what is halved
DECADES = {f"{10**n}": 10.0**n for n in range(1, 10)}
NEAR = {2: "twice", 10: "ten times"}        # as far as the band reaches
UNLIKE = 2                                  # by more than this factor an answer is of another size
UNKNOWN = "no known mistake leads to this"
NOT_EQUAL = f"{UNKNOWN}: at random values of its letters it is another than the key"
NOT_PROPORTIONAL = f"{UNKNOWN}: at random values and motions it is no multiple of the key"


def factors() -> Iterator[tuple[str, float]]:
    """(in words, factor) of those by which answers are often too large or too small, units above all."""
    for text, factor in {**DECADES, **RATIOS}.items():
        yield text, factor
        yield f"1/({text})" if "/" in text or "π" in text else f"1/{text}", 1 / factor


def of_number(value: float, key: float, band: float) -> str:
    """Why a number that lies outside the band of a key is wrong."""
    if not key:
        return f"{UNKNOWN}: it lies outside the band of the key"
    for words, factor in (("", 1.0), *factors()):
        for sign in (1, -1):
            if abs(sign * value / factor - key) <= band and (words or sign < 0):
                but = " and ".join(["its sign"] * (sign < 0) + [f"a factor of {words}"] * bool(words))
                return f"the number is right but for {but}"
    return f"{UNKNOWN}: {_apart(value, key, band)}"


def _apart(value: float, key: float, band: float) -> str:
    """How an answer that is no simple multiple of its key differs from it."""
    if value * key < 0:
        return "sign and size differ from those of the key"
    if abs(value) > UNLIKE * abs(key):
        return "it is more than twice what is right"
    if UNLIKE * abs(value) < abs(key):
        return "it is less than half of what is right"
    return next((f"it lies further from the key than its band reaches, but not {words} as far"
                 for times, words in NEAR.items() if abs(value - key) <= times * band),
                f"it lies more than {NEAR[max(NEAR)]} as far from the key as its band reaches")
