"""The steady state under loads that repeat themselves: the motion that is after a period where it was before it,

    y₀ = (I − e^{AT})⁻¹ y(T),   ẏ = A y + B u(t) from y(0) = 0,   T a common period of all loads,

followed in Taylor series between the instants at which these bend or jump; its means are quadratures of each step.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import lcm
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.harmonics import repeated
from vibcli.evidence.reference.motion import Motion, settled_along
from vibcli.evidence.reference.settled import TrueValues
from vibcli.evidence.reference.taylor_steps import SPARE
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.evidence.reference.taylor_steps import TaylorSteps
    from vibcli.symbolic.node import Node

MOST = 60               # periods of the slowest wave in one of all loads
RMS = "rms"
MORE = 24               # samples of a step beyond the order of its series


class NoCommonPeriod(PhysicsError):
    """Loads have no common period, or a very long one."""


class PeriodicMotion(NamedTuple):
    """A Motion that begins in the steady state; period(bits): T, a rational number that near."""

    motion: Motion
    period: Callable[[int], Fraction]


def steady(motion: Motion, work: Any) -> PeriodicMotion:
    """The PeriodicMotion of a small motion; PhysicsError where nothing repeats itself, or no steady state is one."""
    if motion.blows:
        raise PhysicsError("no reference is found of steady states under blows")
    rates = repeated(motion)[0].rates

    @cache
    def period(bits: int) -> Fraction:
        with mpmath.workprec(2 * bits):
            found = [abs(x) for x in evaluate(rates, multiprecision(), motion.values(bits)) if x]
            if not found:
                raise PhysicsError("nothing drives it that repeats itself")
            slowest = min(found)
            ratios = [Fraction(round(float(x / slowest), 9)).limit_denominator(MOST) for x in found]
            if any(abs(x / slowest - mpmath.mpf(r.numerator) / r.denominator) > mpmath.ldexp(x / slowest, 16 - bits)
                   for x, r in zip(found, ratios, strict=True)):
                raise NoCommonPeriod("the loads have no common period: no reference is found of their steady state")
            periods = lcm(*(ratio.denominator for ratio in ratios))
            if periods > MOST:
                raise NoCommonPeriod("the loads repeat themselves after very many periods: no reference is found")
            return Fraction(fixed_point(2 * mpmath.pi * periods / slowest, 2 * bits), 1 << 2 * bits)

    at_rest = motion._replace(start=lambda bits: [0] * 2 * len(motion.scene.q))

    @cache
    def start(bits: int) -> list[int]:
        steps = at_rest.steps(period(bits), int((bits - SPARE) / 3.321), work)
        with mpmath.workprec(2 * bits):
            places, speeds, _ = steps.at(steps.fixed(period(bits)))
            over = mpmath.eye(2 * len(places)) - mpmath.expm(state_matrix(motion, bits) * _number(period(bits)))
            try:
                found = mpmath.lu_solve(over, mpmath.matrix([*places, *speeds]))
            except ZeroDivisionError:
                raise PhysicsError("this motion never settles: no reference is found of its steady state") from None
            return [fixed_point(x, bits) for x in found]

    return PeriodicMotion(motion._replace(start=start), period)


def _number(x: Fraction) -> mpmath.mpf:
    return mpmath.mpf(x.numerator) / x.denominator


def state_matrix(motion: Motion, bits: int) -> Any:
    """A of ẏ = A y, y = (q, q̇)."""
    values, n = motion.values(bits), len(motion.scene.q)
    M, C, K = (mpmath.matrix([[values[f"{part}[{i};{j}]"] for j in range(n)] for i in range(n)]) for part in "MCK")
    found = mpmath.zeros(2 * n)
    found[:n, n:] = mpmath.eye(n)
    for part, columns in ((K, range(n)), (C, range(n, 2 * n))):
        rows = -mpmath.inverse(M) * part
        for i in range(n):
            for place, j in enumerate(columns):
                found[n + i, j] = rows[i, place]
    return found


def over_a_period(known: PeriodicMotion, node: "Node", head: str, work: Any) -> TrueValues:
    """The mean or rms value of a signal; about: its largest magnitude."""
    def found(steps: "TaylorSteps") -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        signal, T = known.motion.signal(node), _number(known.period(steps.bits))

        with mpmath.workprec(2 * steps.bits):
            total, size = mpmath.mpf(0), mpmath.mpf(0)
            for step in steps.steps:
                for s, weight in rule(steps.order + MORE, 2 * steps.bits):
                    x, = signal.along(steps, [signal.node], step.start + int(s * (step.end - step.start)))
                    size = max(size, abs(x))
                    total += (x * x if head == RMS else x) * weight * mpmath.ldexp(step.end - step.start, -steps.bits)
            mean = total / T
            mean = mean if abs(mean) > mpmath.ldexp(size, -steps.accuracy) else mpmath.mpf(0)
            return [mpmath.sqrt(mean) if head == RMS else mean], size

    return settled_along(known.motion, known.period, work, found)


@cache
def rule(count: int, bits: int) -> list[tuple[Any, Any]]:
    """Places and weights of Fejér's first rule from 0 to 1, none of them at an end, where loads may jump."""
    count += count % 2
    with mpmath.workprec(bits):
        waves = [mpmath.cospi(mpmath.mpf(k) / (2 * count)) for k in range(4 * count)]
        return [((1 - waves[k]) / 2, (1 - 2 * sum(
            waves[2 * j * k % (4 * count)] / (4 * j * j - 1) for j in range(1, count // 2 + 1))) / count)
            for k in range(1, 2 * count, 2)]


def at_the_start(known: PeriodicMotion) -> tuple[float, list[float]]:
    """(T, [q, q̇] of the steady state at t = 0, counted from rest)."""
    bits = 128
    return float(known.period(bits)), [x / 2.0**bits for x in known.motion.start(bits)]
