"""The n-link pendulum by SymPy's LagrangesMethod and its linearisation, for comparison; it takes seconds to minutes."""

import json
from typing import Any

from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

LINKS = (2, 5)


def rows(runs: Any) -> list[Any]:
    """Ours, from the text to the frequencies, against SymPy's forming and linearising alone."""
    found = []
    ours = json.loads(answer("from vibcli.bench.lagranges_method import ours; ours()"))
    for n, milliseconds in zip(LINKS, ours, strict=True):
        slow = float(answer("from vibcli.bench.lagranges_method import main; main()", n))
        found.append(Timing(f"pendulum of {n} links", milliseconds, "ms", None, "sympy LagrangesMethod.linearize",
                            slow))
    return found


def ours() -> None:
    """Child process: print the milliseconds of ours for each number of links."""
    from vibcli.bench.growth import solve
    from vibcli.bench.scenes import pendulum

    solve(pendulum(3))
    print(json.dumps([1e3 * min(solve(pendulum(n))[2] for _ in range(9)) for n in LINKS]))


def main() -> None:
    """Child process: print the milliseconds that SymPy takes, its import excluded."""
    import sys
    from time import process_time

    from sympy import cos, sin, symbols
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    n = int(sys.argv[1])
    start = process_time()
    q, t = dynamicsymbols(f"q:{n}"), dynamicsymbols._t
    m, length, g = symbols("m L g", positive=True)
    x = y = T = V = 0
    for angle in q:
        x, y = x + length * sin(angle), y - length * cos(angle)
        T += m * (x.diff(t) ** 2 + y.diff(t) ** 2) / 2
        V += m * g * y
    method = LagrangesMethod(T - V, q)
    method.form_lagranges_equations()
    still = dict.fromkeys([*q, *(angle.diff(t) for angle in q)], 0)
    method.linearize(q_ind=q, qd_ind=[angle.diff(t) for angle in q], A_and_B=True, op_point=[still])
    print(1e3 * (process_time() - start))
