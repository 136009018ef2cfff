"""What a small motion comes to under loads that are powers of the time in the end, Q = Σ b_k tᵏ: q = Σ a_k tᵏ with

    K a_k = b_k − (k + 1) C a_{k+1} − (k + 1)(k + 2) M a_{k+2},

from the highest power on; a signal of it is such a sum, too, its limit the constant one where there is no other.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

DEGREE, MORE = 4, 4         # highest power of the time; instants at which a sum of them is tried beyond those it has
FAR, DIGITS, START = 16, 36, 80


def value(motion: Motion, node: "Node", until: float, time: Callable[[], Any]) -> TrueValues:
    """Of a signal at an instant, after what dies out; until: an instant beyond which loads do not change their form."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        row, instant = _signal(motion, node, until), time()
        terms = [c * instant**k for k, c in enumerate(row)]
        return [mpmath.fsum(terms)], max(map(abs, terms))

    return settled(found, DIGITS, START, sized=True)


def limit(motion: Motion, node: "Node", until: float) -> TrueValues:
    """The limit of a signal; PhysicsError where it has none."""
    def found() -> "tuple[list[mpmath.mpf], int | mpmath.mpf]":
        row = _signal(motion, node, until)
        if any(row[1:]):
            raise PhysicsError("the reference finds that this signal has no limit")
        return [row[0]], abs(row[0]) or 1

    return settled(found, DIGITS, START, sized=True)


def _signal(motion: Motion, node: "Node", until: float) -> list[mpmath.mpf]:
    """[coefficients] of a signal, at the working precision."""
    scene, numbers = motion.scene, motion.values(mpmath.mp.prec)
    rows = _motion(motion, numbers, until)

    def at(t: mpmath.mpf) -> "list[mpmath.mpf]":
        known = {**numbers, scene.time.name: t}
        for primes in range(3):
            known |= {name + "'" * primes: _rate(row, t, primes)
                      for name, row in zip(scene.coordinates, rows, strict=True)}
        return evaluate([node], multiprecision(), known)

    largest = max(abs(_rate(row, mpmath.mpf(until) * FAR, 0)) for row in rows)
    return _fitted(at, until, mpmath.mpf(10) ** (-mpmath.mp.dps // 2) * max(1, largest))[0]


def _motion(motion: Motion, numbers: Mapping[str, mpmath.mpf], until: float) -> list[list[mpmath.mpf]]:
    """[coefficients] of each coordinate."""
    scene, n = motion.scene, len(motion.scene.q)
    still = dict.fromkeys((*scene.q, *scene.v), scene.table.zero)
    loads = [-node for node in substitute(motion.parts.h, still)]
    b = _fitted(lambda t: evaluate(loads, multiprecision(), {**numbers, scene.time.name: t}), until)
    M, C, K = (mpmath.matrix([[numbers[f"{part}[{i};{j}]"] for j in range(n)] for i in range(n)]) for part in "MCK")
    found = [mpmath.zeros(n, 1)] * (DEGREE + 3)
    for k in reversed(range(DEGREE + 1)):
        right = mpmath.matrix([row[k] for row in b]) - (k + 1) * C * found[k + 1] - (k + 1) * (k + 2) * M * found[k + 2]
        found[k] = mpmath.lu_solve(K, right) if any(right) else right
    return [[column[i] for column in found[:DEGREE + 1]] for i in range(n)]


def _rate(row: Sequence[mpmath.mpf], t: mpmath.mpf, order: int) -> mpmath.mpf:
    return mpmath.fsum(c * mpmath.ff(k, order) * t ** (k - order) for k, c in enumerate(row) if k >= order)


def _fitted(at: Callable[[Any], Sequence[Any]], until: float, nothing: Any = 0) -> list[list[Any]]:
    """[coefficients] of functions of the time far from its start; PhysicsError of what is no sum of its powers.
    nothing: what is rounding."""
    times = [mpmath.mpf(until) * FAR * k for k in range(1, DEGREE + MORE + 2)]
    columns = [[x if abs(x) > nothing else mpmath.mpf(0) for x in values]
               for values in zip(*map(at, times), strict=True)]
    count = DEGREE + 1
    powers = mpmath.matrix([[t**k for k in range(count)] for t in times[:count]])
    found = []
    for values in columns:
        row = mpmath.lu_solve(powers, mpmath.matrix(values[:count])) if any(values) else [mpmath.mpf(0)] * count
        size, small = max(map(abs, values)), mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
        row = [c if abs(c) * times[0] ** k > small * size else mpmath.mpf(0) for k, c in enumerate(row)]
        if any(abs(mpmath.fsum(c * t**k for k, c in enumerate(row)) - x) > small * size
               for t, x in zip(times, values, strict=True)):
            raise PhysicsError("a reference of what a motion comes to is found of loads that are powers of the time")
        found.append(row)
    return found
