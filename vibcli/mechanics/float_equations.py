"""Accelerations in plain floats, at one instant: of few coordinates they cost less than a dozen calls of NumPy.

The equations M q̈ = −h are solved by elimination without pivots, M being positive definite; what vanishes is left out.
"""

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.numeric_code import NUMPY, PLAIN, Source

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_equations import NumericEquations


class FloatEquations(NamedTuple):
    """accelerations(t, *q, *q̇) ↦ q̈, a tuple; ArithmeticError or ValueError where it has no value; work: operations."""

    accelerations: Callable[..., tuple[float, ...]]
    work: int


def float_equations(system: "NumericEquations") -> FloatEquations | None:
    """The FloatEquations of a system without constraints and switches; None where something in it is found by arrays
    alone: a record, the deflection of a law."""
    scene, parts, n = system.scene, system.parts, system.n
    slots = {scene.time: "t"} | {node: f"{kind}{i}" for kind, symbols in (("q", scene.q), ("v", scene.v))
                                 for i, node in enumerate(symbols)}
    source = Source(slots, system.floats, None)
    entries = dict(zip(parts.M, source.add(list(parts.M.values())), strict=True))
    solved = _solved(entries, source.add(parts.h))
    if source.called:
        return None
    head = ",".join(f"{kind}{i}" for kind in "qv" for i in range(n))
    lines = [*source.lines, *solved, f"return ({''.join(f'a{i},' for i in range(n))})"]
    body = "".join(f" {line}\n" for line in lines)
    space = {NUMPY.get(name, name): getattr(math, name) for name in (*PLAIN, "sqrt", "nan") if hasattr(math, name)}
    space |= {"abs": abs, "minimum": min, "maximum": max, "power": math.pow}
    exec(compile(f"def f(t,{head}):\n{body}", "<motion>", "exec"), space)       # slots and floats only
    return FloatEquations(space["f"], sum(body.count(sign) for sign in "+-*/("))


def _solved(M: dict[tuple[int, int], str], h: Sequence[str]) -> list[str]:
    """Lines that solve M a = −h for a0, a1, …: M {(i, j): text}, i ≤ j, and h [text]."""
    n, M, lines = len(h), dict(M), [f"h{i}={text}" for i, text in enumerate(h)]
    for k in range(n):
        beside = [i for i in range(k + 1, n) if (k, i) in M]
        lines.append(f"o{k}=1.0/({M[k, k]})")
        for i in beside:
            lines += [f"m=({M[k, i]})*o{k}", f"h{i}-=m*h{k}"]
            for j in (j for j in beside if j >= i):
                slot = f"d{i}_{j}"
                before = f"({M[i, j]})" if (i, j) in M else ""
                lines.append(f"{slot}={before}-m*({M[k, j]})")
                M[i, j] = slot
    for i in reversed(range(n)):
        rest = "".join(f"-({M[i, j]})*a{j}" for j in range(i + 1, n) if (i, j) in M)
        lines.append(f"a{i}=(-h{i}{rest})*o{i}")
    return lines
