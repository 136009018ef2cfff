"""Motions by Taylor series whose recurrences are compiled: those of heyoka, where that is installed (vibcli[heyoka]).

The equations M q̈ = −h are solved in expressions, by elimination without pivots, M being positive definite. A step goes
as far as its series of order 1 − ln(tolerance)/2 reaches (Jorba & Zou, Experimental Mathematics 14 (2005), 99; Biscani
& Izzo, Monthly Notices of the Royal Astronomical Society 504 (2021), 2614).
"""

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.floats import ELEMENTARY, Floats

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_equations import NumericEquations

ENGINE = "heyoka"
QUICKLY = {"compact_mode": True, "opt_level": 0}        # optimising takes longer than all steps of most motions


def is_installed() -> bool:
    """Is there an engine?"""
    return find_spec(ENGINE) is not None


class CompiledSeries:
    """The motion of a system without constraints and switches from (q, q̇) at t, by steps whose error is `tolerance`.
    ArithmeticError or ValueError where an expression has no value, whatever moves."""

    def __init__(self, system: "NumericEquations", t: float, start: Sequence[float], tolerance: float) -> None:
        engine = import_module(ENGINE)
        scene, n = system.scene, system.n
        names = [node.name for node in (*scene.q, *scene.v)]
        state = [engine.expression(f"x{i}") for i in range(2 * n)]
        values = {**system.floats, scene.time.name: engine.time, **dict(zip(names, state, strict=True))}
        entries = evaluate([*system.parts.M.values(), *system.parts.h], _Arithmetic(engine), values)
        a = solved(dict(zip(system.parts.M, entries, strict=False)), entries[-n:])
        rates = [*state[n:], *(engine.expression(one) if isinstance(one, float) else one for one in a)]
        self._march = engine.taylor_adaptive(list(zip(state, rates, strict=True)), list(start), time=t,
                                             tol=tolerance, **QUICKLY)

    def steps(self, limit: float, most: int) -> tuple[np.ndarray, Callable[..., np.ndarray] | None]:
        """(the ends of the next steps towards an instant, `most` of them at most, states(times) on them, of shape
        (times, 2n)); no end where a force has no value."""
        *_, count, known = self._march.propagate_until(limit, max_steps=most, c_output=True)[:5]
        return (known.times[1:], known) if count and known is not None else (np.empty(0), None)


class _Arithmetic:
    """Expressions of the engine, and floats for what is constant."""

    pi, number = Floats.pi, staticmethod(Floats.number)

    def __init__(self, engine: Any) -> None:
        self.engine = engine
        of_expressions = {name: getattr(engine, name) for name in ELEMENTARY} | {
            "power": lambda b, e: engine.exp(e * math.log(b)) if isinstance(b, float) else b**e}
        self.functions = Floats.functions | {name: _either(Floats.functions[name], function)
                                             for name, function in of_expressions.items()}

    def power(self, base: Any, exponent: Fraction | int) -> Any:
        if isinstance(base, float):
            return Floats.power(base, exponent)
        return self.engine.sqrt(base) if exponent == Fraction(1, 2) else base ** float(exponent)


def _either(of_floats: Callable[..., Any], of_expressions: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *args: (of_floats if all(isinstance(one, float) for one in args) else of_expressions)(*args)


def solved(M: dict[tuple[int, int], Any], h: Sequence[Any]) -> list[Any]:
    """a of M a = −h, by elimination without pivots; M {(i, j): entry}, i ≤ j, without what vanishes."""
    M, h, n = dict(M), list(h), len(h)
    for k in range(n):
        beside = [i for i in range(k + 1, n) if (k, i) in M]
        for i in beside:
            factor = M[k, i] / M[k, k]
            h[i] = h[i] - factor * h[k]
            for j in (j for j in beside if j >= i):
                less = factor * M[k, j]
                M[i, j] = M[i, j] - less if (i, j) in M else -less
    a: list[Any] = [None] * n
    for i in reversed(range(n)):
        rest = h[i]
        for j in (j for j in range(i + 1, n) if (i, j) in M):
            rest = rest + M[i, j] * a[j]
        a[i] = -rest / M[i, i]
    return a
