"""The motion of the full equations as a power series in time, about any of its states.

In s = (t − t₀)/T the coefficients follow from one another: q̇ and q of order k + 1 from q̈ of order k, and

    A x = −r,   A = [M Gᵀ; G 0],  x = (q̈, λ),  r = (h, γ):        A₀ xₖ = −rₖ − Σ_{j>0} Aⱼ xₖ₋ⱼ,

where the coefficients of M, h … follow from those of q and q̇ (symbolic/power_series.py).
"""

from collections.abc import Callable, Mapping, Sequence
from operator import mul
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.fixed_point import mantissa, shifted
from vibcli.numerics.fixed_point_functions import functions, inverse
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.power_series import SeriesSource

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.equations_of_motion import Dynamics
    from vibcli.scene.scene import Scene

    Computed = Callable[[int, int, Sequence[int], int], "Coefficients"]      # of (t₀, T, [q, q̇], order)


class Coefficients(NamedTuple):
    """[coefficients] of each coordinate, velocity and acceleration, of the powers of s."""

    q: list[list[int]]
    v: list[list[int]]
    a: list[list[int]]


class MotionSeries:
    """The equations `parts` of a scene as source of series. `products`: of series, in each round."""

    def __init__(self, scene: "Scene", parts: "Dynamics") -> None:
        self.n, self.m = len(scene.q), len(parts.gaps)
        slots = {scene.time: "t"}
        slots |= {symbol: f"q{i}" for i, symbol in enumerate(scene.q)}
        slots |= {symbol: f"v{i}" for i, symbol in enumerate(scene.v)}
        source = SeriesSource(slots)
        self._rows = [[] for _ in range(self.n + self.m)]       # [(column, list, is it constant?)]
        keys = [*parts.M, *((self.n + k, i) for k, i in parts.slopes)]
        nodes = [*parts.M.values(), *parts.slopes.values()]
        for (i, j), node, name in zip(keys, nodes, source.add(nodes), strict=True):
            for row, column in {(i, j), (j, i)}:
                self._rows[row].append((column, name, not node.mask))
        right = source.add([*parts.h, *parts.bends])
        self.constants = list(source.constants)
        self._code = compile(f"def f(t0,T,start,K,constants,B):\n{self._written(source, right)}\n", "<series>", "exec")
        self.products = source.products + sum(not still for row in self._rows for _, _, still in row) + self.n

    def _written(self, source: SeriesSource, right: list[str]) -> str:
        names = [f"{kind}{i}" for kind in "qv" for i in range(self.n)]
        unknowns = [f"a{i}" for i in range(self.n + self.m)]
        entries = [{column: f"{name}[0]" for column, name, _ in row} for row in self._rows]
        matrix = ",".join(f"[{','.join(row.get(j, '0') for j in range(len(entries)))}]" for row in entries)
        lines = [f"({','.join(names)},)=([x] for x in start)", "t=[t0]"]
        if source.constants:
            lines.append(f"({','.join(source.constants.values())},)=constants")
        lines += [*source.first, f"W=inverse([{matrix}],B)"]
        lines += [f"r{i}=-{name}[0]" for i, name in enumerate(right)]
        lines += [f"{a}=[{self._solved(i)}]" for i, a in enumerate(unknowns)]
        lines += ["for k in range(1,K+1):", *(" " + line for line in self._round(source, right, unknowns))]
        return "\n".join(f" {line}" for line in [*lines, f"return {_lists(names)},{_lists(unknowns[:self.n])}"])

    def _solved(self, i: int) -> str:
        return "+".join(f"W[{i}][{j}]*r{j}" for j in range(self.n + self.m)) + ">>B"

    def _round(self, source: SeriesSource, right: Sequence[str], unknowns: Sequence[str]) -> list[str]:
        """The lines of a round."""
        lines = ["h=(k+1)>>1", "t.append(T if k==1 else 0)"]
        for i in range(self.n):
            lines += [f"q{i}.append((v{i}[-1]*T>>B)//k)", f"v{i}.append((a{i}[-1]*T>>B)//k)"]
        lines += source.lines
        for i, name in enumerate(right):
            earlier = "+".join(f"sum(map(mul,{entry}[:0:-1],{unknowns[j]}))"
                               for j, entry, still in self._rows[i] if not still)
            lines.append(f"r{i}=-{name}[-1]" + (f"-({earlier}>>B)" if earlier else ""))
        return lines + [f"{a}.append({self._solved(i)})" for i, a in enumerate(unknowns)]

    def with_bits(self, values: "Mapping[str, mpmath.mpf]", bits: int) -> "Computed":
        """f(t₀, T, [q, q̇] at t₀, order), all numbers fixed points of so many bits; `values` of the parameters."""
        import mpmath

        with mpmath.workprec(2 * bits):
            known = [fixed_point(x, bits) for x in evaluate(self.constants, multiprecision(), values)]
        space: dict[str, Any] = {"mul": mul, "inverse": inverse, **functions(bits)}
        exec(self._code, space)     # of slots alone
        made, n = space["f"], self.n

        def series(t0: int, T: int, start: Sequence[int], order: int) -> Coefficients:
            lists, a = made(t0, T, start, order, known, bits)
            return Coefficients(lists[:n], lists[n:], a)

        return series


def resting(t0: int, T: int, start: Sequence[int], order: int) -> Coefficients:
    """The series of what stays where it is."""
    nothing, n = [0] * order, len(start) // 2
    return Coefficients([[x, *nothing] for x in start[:n]], [[0, *nothing] for _ in range(n)],
                        [[0, *nothing] for _ in range(n)])


def fixed_point(x: "mpmath.mpf", bits: int) -> int:
    """A real number; ArithmeticError of any other."""
    import mpmath

    if mpmath.im(x) or not mpmath.isfinite(x):
        raise ArithmeticError
    m, e = mantissa(mpmath.mpf(mpmath.re(x)))
    return shifted(m, e + bits)


def _lists(names: list[str]) -> str:
    return f"[{','.join(names)}]"
