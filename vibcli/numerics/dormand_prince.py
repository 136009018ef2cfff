"""The rule of Dormand and Prince of eighth order, in plain floats: of few unknowns a step costs less than one call of
NumPy for each of its stages.

    k_s = f(t + c_s h, y + h Σ a_sj k_j),        y₁ = y + h Σ b_s k_s

Tables and error estimate of Hairer, Nørsett & Wanner (1993), II.5, DOP853; the last stage is f at the end of the step.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any

C = (0.0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 0.3333333333333333, 0.25,
     0.3076923076923077, 0.6512820512820513, 0.6, 0.8571428571428571, 1.0, 1.0)
A = (
    {},
    {0: 0.05260015195876773},
    {0: 0.0197250569845379, 1: 0.0591751709536137},
    {0: 0.02958758547680685, 2: 0.08876275643042054},
    {0: 0.2413651341592667, 2: -0.8845494793282861, 3: 0.924834003261792},
    {0: 0.037037037037037035, 3: 0.17082860872947386, 4: 0.12546768756682242},
    {0: 0.037109375, 3: 0.17025221101954405, 4: 0.06021653898045596, 5: -0.017578125},
    {0: 0.03709200011850479, 3: 0.17038392571223998, 4: 0.10726203044637328, 5: -0.015319437748624402, 6:
     0.008273789163814023},
    {0: 0.6241109587160757, 3: -3.3608926294469414, 4: -0.868219346841726, 5: 27.59209969944671, 6:
     20.154067550477894, 7: -43.48988418106996},
    {0: 0.47766253643826434, 3: -2.4881146199716677, 4: -0.590290826836843, 5: 21.230051448181193, 6:
     15.279233632882423, 7: -33.28821096898486, 8: -0.020331201708508627},
    {0: -0.9371424300859873, 3: 5.186372428844064, 4: 1.0914373489967295, 5: -8.149787010746927, 6:
     -18.52006565999696, 7: 22.739487099350505, 8: 2.4936055526796523, 9: -3.0467644718982196},
    {0: 2.273310147516538, 3: -10.53449546673725, 4: -2.0008720582248625, 5: -17.9589318631188, 6: 27.94888452941996,
     7: -2.8589982771350235, 8: -8.87285693353063, 9: 12.360567175794303, 10: 0.6433927460157636},
    {0: 0.054293734116568765, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585, 8:
     0.3111643669578199, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.04471061572777259},
)
THIRD = {0: -0.18980075407240762, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585, 8:
         -0.4226823213237919, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.02265179219836082}
FIFTH = {0: 0.01312004499419488, 5: -1.2251564463762044, 6: -0.4957589496572502, 7: 1.6643771824549864, 8:
         -0.35032884874997366, 9: 0.3341791187130175, 10: 0.08192320648511571, 11: -0.022355307863886294}
END = 12


@lru_cache
def stepper(n: int) -> Callable[..., Any]:
    """step(f, t, h, q, v, a, weights) ↦ (the error, 1 being allowed, q, q̇, q̈ at the end) for n coordinates, q̈ =
    f(t, *q, *q̇) being a tuple; weights: 1/(the error allowed) of each place and each velocity."""
    stages = [_stage(n, s) for s in range(1, END + 1)]
    lines = [*_state(n), f"{_names('w', 2 * n)}=w", *(line for stage in stages for line in stage)]
    sums = [f"({_combined(table, kind, i)})*w{i + n * (kind == 'k')}" for table in (FIFTH, THIRD)
            for kind in ("u", "k") for i in range(n)]
    lines += [f"e{i}={text}" for i, text in enumerate(sums)]
    for name, first in (("fifth", 0), ("third", 2 * n)):
        lines.append(f"{name}=" + "+".join(f"e{i}*e{i}" for i in range(first, first + 2 * n)))
    lines.append(f"bottom={2 * n}.0*(fifth+0.01*third)")
    ends = ",".join(_names(kind, n, END) for kind in "xuk")
    return _function("f,t,h,q,v,a,w", lines, f"abs(h)*fifth/sqrt(bottom) if bottom else 0.0,{ends}")


def _names(kind: str, n: int, s: int | None = None) -> str:
    return "(" + "".join(f"{kind}{i}," if s is None else f"{kind}{s}_{i}," for i in range(n)) + ")"


def _state(n: int) -> list[str]:
    """At the start; its velocities and accelerations are those of stage 0."""
    return [f"{_names('q', n)}=q", f"{_names('u', n, 0)}=v", f"{_names('k', n, 0)}=a"]


def _combined(table: Mapping[int, float], kind: str, i: int) -> str:
    return "+".join(f"{factor!r}*{kind}{j}_{i}" for j, factor in table.items())


def _stage(n: int, s: int) -> list[str]:
    places = [f"x{s}_{i}=q{i}+h*({_combined(A[s], 'u', i)})" for i in range(n)]
    speeds = [f"u{s}_{i}=u0_{i}+h*({_combined(A[s], 'k', i)})" for i in range(n)]
    state = ",".join(f"{kind}{s}_{i}" for kind in "xu" for i in range(n))
    return [*places, *speeds, f"{_names('k', n, s)}=f(t+{C[s]!r}*h,{state})"]


def _function(head: str, lines: Sequence[str], result: str) -> Callable[..., Any]:
    from math import sqrt

    body = "".join(f" {line}\n" for line in lines)
    space = {"sqrt": sqrt}
    exec(compile(f"def step({head}):\n{body} return {result}\n", "<step>", "exec"), space)     # slots and floats only
    return space["step"]
