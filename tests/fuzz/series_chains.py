"""Forces of random chains of laws in series against 50 digits, found by bisection and Newton's method:

    PYTHONPATH=$PWD:tests python -m fuzz.series_chains 1000

prints the largest error in units of 2⁻⁵² times the condition of the force, 1 + D F′/F.
"""

import math
import random
import sys

import mpmath

from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.series_of_laws import PartLaw, SeriesOfLaws

LIMIT = 4.0
POWERS = {"linear": 1, "cubic": 3, "fifth": 5, "square": 2, "three halves": 1.5}


def drawn(chance: random.Random) -> tuple[list, float]:
    """([[(kind of a term, factor)] of each law], D)."""
    laws = []
    for _ in range(chance.randint(2, 5)):
        kinds = chance.sample([*POWERS, "sinh"], chance.randint(1, 2))
        laws.append([(kind, 10 ** chance.uniform(-4, 4)) for kind in kinds])
    return laws, chance.choice([-1, 1]) * 10 ** chance.uniform(-6, 1)


def _force(terms, d, sinh=math.sinh):
    return sum(c * (sinh(d) if kind == "sinh" else d ** POWERS[kind]) for kind, c in terms)


def _slope(terms, d):
    return sum(c * (mpmath.cosh(d) if kind == "sinh" else POWERS[kind] * d ** (POWERS[kind] - 1)) for kind, c in terms)


def _between(rising, low, high):
    """Where a rising function of a float passes zero, by bisection of the logarithm."""
    for _ in range(60):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if rising(middle) < 0 else (low, middle)
    return low


def _deflections(laws, force, D):
    return [_between(lambda d, terms=terms: _force(terms, d) - force, 1e-40, 2 * D) for terms in laws]


def precisely(laws: list, D: float) -> tuple:
    """(F, its condition) at a positive D: by bisection in floats, then by Newton's method of Fᵢ(dᵢ) = F."""
    forces = [_force(terms, D / len(laws)) for terms in laws]
    force = _between(lambda f: sum(_deflections(laws, f, D)) - D, min(forces) / 2, 2 * max(forces))
    parts = [mpmath.mpf(d) for d in _deflections(laws, force, D)]
    for _ in range(8):
        slopes = [_slope(terms, d) for terms, d in zip(laws, parts, strict=True)]
        forces = [_force(terms, d, mpmath.sinh) for terms, d in zip(laws, parts, strict=True)]
        stiffness = 1 / sum(1 / slope for slope in slopes)
        force = stiffness * (D - sum(parts) + sum(f / slope for f, slope in zip(forces, slopes, strict=True)))
        parts = [d + (force - f) / slope for d, f, slope in zip(parts, forces, slopes, strict=True)]
    assert abs(sum(parts) - D) < 1e-45 * D and max(abs(_force(terms, d, mpmath.sinh) - force) for terms, d in zip(
        laws, parts, strict=True)) < 1e-45 * force
    return force, 1 + D * stiffness / force


def error(laws: list, D: float, beside: list | None = None) -> float:
    """Of the force in floats, in units of 2⁻⁵² times its condition; `beside`: the laws that it is compared with."""
    table = Table()
    x = table.variable("x")
    symbols, values, parts = [], {}, []
    for terms in laws:
        law = table.zero
        for kind, c in terms:
            symbols.append(table.parameter(f"c{len(symbols)}"))
            values[symbols[-1].name] = c
            law += symbols[-1] * {"linear": x, "cubic": x**3, "fifth": x**5, "square": x * table.call("abs", x),
                                  "three halves": table.call("sign", x) * table.call("power", table.call("abs", x),
                                                                                    table.number(1) * 3 / 2),
                                  "sinh": table.call("sinh", x)}[kind]
        parts.append(PartLaw(law, from_zero(law, x)))
    force = SeriesOfLaws("s", parts, x, symbols).called("force", table.variable("D"), symbols)
    found = evaluate([force], Floats, {**values, "D": D})[0]
    with mpmath.workdps(50):
        exact, condition = precisely(beside or laws, abs(D))
        return float(abs(abs(found) - exact) / exact / condition) / 2.0**-52


def main(count: int) -> None:
    chance = random.Random(9)
    worst = max((error(*scene), scene) for scene in (drawn(chance) for _ in range(count)))
    print(f"{count} chains: the largest error {worst[0]:.3f} of {LIMIT}: {worst[1]}")


if __name__ == "__main__":
    main(int(sys.argv[1]))
