"""Sets of values for the letters of a scene: that of its drawing, others near it, and others far away."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.language.parameters import Parameters

PRIME = 10007
FAR = 100           # where attempts unrelated to those of the drawing start
FAR_APART = 5       # letters of one scene may differ by orders of magnitude


def sample_values(names: Sequence[str], attempt: int) -> dict[str, float]:
    """Values for symbols without one: positive, unrelated, and others at each attempt."""
    return {name: 0.6 + 1.7 * ((7919 * (i + 1) + 104729 * attempt) * (attempt + 3) % PRIME / PRIME)
            for i, name in enumerate(names)}


@lru_cache(1000)
def short_fraction(value: float) -> Fraction:
    """The fraction next to a number with a denominator up to 1000."""
    return Fraction(value).limit_denominator(1000)


def given_values(parameters: "Parameters", sample: Mapping[str, float], free: Sequence[str],
                 attempt: int) -> dict[str, Fraction]:
    """{letter: exact value} of `free` letters, another at each attempt; 0: those of the `sample`, odd ones near that,
    every fourth of letters far apart. Letters of any sign are negative at every fourth attempt."""
    if attempt == 0:
        return {name: Fraction(sample[name]) for name in free}
    values = sample_values(free, FAR + attempt)
    if attempt % 4 == 0:
        values = {name: value**FAR_APART for name, value in values.items()}
    elif attempt % 2:
        values = {name: sample[name] * (0.6 + 0.4 * value) for name, value in values.items()}
    signs = {name: -1 if attempt % 4 == 2 and parameters.records[name].get("sign") == "any" else 1
             for name in free}
    return {name: signs[name] * short_fraction(value) for name, value in values.items()}
