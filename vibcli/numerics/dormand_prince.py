"""The rule of Dormand and Prince of eighth order, in plain floats: of few unknowns a step costs less than one call of
NumPy for each of its stages.

    k_s = f(t + c_s h, y + h Σ a_sj k_j),        y₁ = y + h Σ b_s k_s,        y(t + x h) = y + h Σ b_s(x) k_s

Tables and error estimate of Hairer, Nørsett & Wanner (1993), II.5, DOP853; stage 12 is f at the end of the step, and
stages 13 to 15 are those that its polynomials of seventh order need.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

C = (0.0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 0.3333333333333333, 0.25,
     0.3076923076923077, 0.6512820512820513, 0.6, 0.8571428571428571, 1.0, 1.0, 0.1, 0.2, 0.7777777777777778)
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
    {0: 0.056167502283047954, 6: 0.25350021021662483, 7: -0.2462390374708025, 8: -0.12419142326381637, 9:
     0.15329179827876568, 10: 0.00820105229563469, 11: 0.007567897660545699, 12: -0.008298},
    {0: 0.03183464816350214, 5: 0.028300909672366776, 6: 0.053541988307438566, 7: -0.05492374857139099, 10:
     -0.00010834732869724932, 11: 0.0003825710908356584, 12: -0.00034046500868740456, 13: 0.1413124436746325},
    {0: -0.42889630158379194, 5: -4.697621415361164, 6: 7.683421196062599, 7: 4.06898981839711, 8: 0.3567271874552811,
     12: -0.0013990241651590145, 13: 2.9475147891527724, 14: -9.15095847217987},
)
THIRD = {0: -0.18980075407240762, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585, 8:
         -0.4226823213237919, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.02265179219836082}
FIFTH = {0: 0.01312004499419488, 5: -1.2251564463762044, 6: -0.4957589496572502, 7: 1.6643771824549864, 8:
         -0.35032884874997366, 9: 0.3341791187130175, 10: 0.08192320648511571, 11: -0.022355307863886294}
DENSE = (
    {0: -8.428938276109013, 5: 0.5667149535193777, 6: -3.0689499459498917, 7: 2.38466765651207, 8: 2.117034582445028,
     9: -0.871391583777973, 10: 2.2404374302607883, 11: 0.6315787787694688, 12: -0.08899033645133331, 13:
     18.148505520854727, 14: -9.194632392478356, 15: -4.436036387594894},
    {0: 10.427508642579134, 5: 242.28349177525817, 6: 165.20045171727028, 7: -374.5467547226902, 8:
     -22.113666853125306, 9: 7.733432668472264, 10: -30.674084731089398, 11: -9.332130526430229, 12:
     15.697238121770845, 13: -31.139403219565178, 14: -9.35292435884448, 15: 35.81684148639408},
    {0: 19.985053242002433, 5: -387.0373087493518, 6: -189.17813819516758, 7: 527.8081592054236, 8:
     -11.57390253995963, 9: 6.8812326946963, 10: -1.0006050966910838, 11: 0.7777137798053443, 12: -2.778205752353508,
     13: -60.19669523126412, 14: 84.32040550667716, 15: 11.99229113618279},
    {0: -25.69393346270375, 5: -154.18974869023643, 6: -231.5293791760455, 7: 357.6391179106141, 8: 93.40532418362432,
     9: -37.45832313645163, 10: 104.0996495089623, 11: 29.8402934266605, 12: -43.53345659001114, 13:
     96.32455395918828, 14: -39.17726167561544, 15: -149.72683625798564},
)
STAGES, END = 16, 12


def _rows(table):
    found = np.zeros((len(table), STAGES))
    for i, row in enumerate(table):
        found[i, list(row)] = list(row.values())
    return found


STAGE_MATRIX = _rows(A)
_AT_END, _SLOPES = STAGE_MATRIX[END], _rows(DENSE)
_FIRST, _LAST = np.eye(STAGES)[[0, END]]


@lru_cache
def _polynomials():
    """The coefficients of xᵏ in bₛ(x), of shape (powers, stages): b = x (r₀ + (1 − x)(r₁ + x (r₂ + (1 − x)(r₃ + …"""
    rows = [_AT_END, _FIRST - _AT_END, 2 * _AT_END - _FIRST - _LAST, *_SLOPES]
    total = np.zeros((len(rows) + 1, STAGES))
    for i, row in enumerate(reversed(rows)):
        total[0] += row
        times_x = np.roll(total, 1, axis=0)
        total = times_x if i % 2 == 0 else total - times_x
    return total


def weights(x: np.ndarray) -> np.ndarray:
    """bₛ(x) at places x in [0, 1] of a step, of shape (places, stages)."""
    P = _polynomials()
    return np.vander(x, len(P), increasing=True) @ P


@lru_cache
def stepper(n: int) -> tuple[Callable, Callable]:
    """(step, dense) for n coordinates, q̈ = f(t, *q, *q̇) being a tuple.

    step(f, t, h, q, v, a, weights) ↦ (the error, 1 being allowed, q, v at the end, the stages of q̈ up to that at the
    end); weights: 1/(the error allowed) of each place and each velocity. dense(f, t, h, q, v, stages) ↦ the other
    three."""
    stages = [_stage(n, s) for s in range(1, END + 1)]
    lines = [*_unpacked(n, "a", "k0_"), f"{_names('w', 2 * n)}=w", *(line for stage in stages for line in stage)]
    sums = [f"({_combined(table, kind, i)})*w{i + n * (kind == 'k')}" for table in (FIFTH, THIRD)
            for kind in ("u", "k") for i in range(n)]
    lines += [f"e{i}={text}" for i, text in enumerate(sums)]
    for name, first in (("fifth", 0), ("third", 2 * n)):
        lines.append(f"{name}=" + "+".join(f"e{i}*e{i}" for i in range(first, first + 2 * n)))
    lines.append(f"bottom={2 * n}.0*(fifth+0.01*third)")
    result = (f"abs(h)*fifth/sqrt(bottom) if bottom else 0.0,{_names('x', n, END)},{_names('u', n, END)},"
              f"({','.join(_names('k', n, s) for s in range(END + 1))})")
    more = [*(f"{_names('k', n, s)}=stages[{s}]" for s in range(END + 1)),
            *(line for s in range(1, END + 1) for line in _speeds(n, s)),
            *(line for s in range(END + 1, STAGES) for line in _stage(n, s))]
    return (_function("f,t,h,q,v,a,w", [*_state(n), *lines], result),
            _function("f,t,h,q,v,stages", [*_state(n), *more],
                      ",".join(_names("k", n, s) for s in range(END + 1, STAGES))))


def _names(kind, n, s=None):
    return "(" + "".join(f"{kind}{i}," if s is None else f"{kind}{s}_{i}," for i in range(n)) + ")"


def _unpacked(n, whole, name):
    return ["(" + "".join(f"{name}{i}," for i in range(n)) + f")={whole}"]


def _state(n):
    """The state at the start; its velocities are those of stage 0."""
    return [f"{_names('q', n)}=q", f"{_names('u', n, 0)}=v"]


def _combined(table, kind, i):
    return "+".join(f"{factor!r}*{kind}{j}_{i}" for j, factor in table.items())


def _speeds(n, s):
    return [f"u{s}_{i}=u0_{i}+h*({_combined(A[s], 'k', i)})" for i in range(n)]


def _stage(n, s):
    places = [f"x{s}_{i}=q{i}+h*({_combined(A[s], 'u', i)})" for i in range(n)]
    state = ",".join(f"{kind}{s}_{i}" for kind in "xu" for i in range(n))
    return [*places, *_speeds(n, s), f"{_names('k', n, s)}=f(t+{C[s]!r}*h,{state})"]


def _function(head, lines, result):
    from math import sqrt

    body = "".join(f" {line}\n" for line in lines)
    space = {"sqrt": sqrt}
    exec(compile(f"def step({head}):\n{body} return {result}\n", "<step>", "exec"), space)     # slots and floats only
    return space["step"]
