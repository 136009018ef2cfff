"""All equilibria: "complete" is said where it is proved, and only there.

Intervals hold every value of their functions, compared with mpmath; a search that is made to miss equilibria is either
completed by the proof or not called complete.
"""

import random
from fractions import Fraction
from itertools import product
from math import pi

import mpmath
import numpy as np
import pytest
from support.scenes import scene_of_potential

from vibcli.cli.program import run
from vibcli.mechanics.equilibrium import all_equilibria
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.interval_arithmetic import Interval, Intervals

FUNCTIONS = ("sin", "cos", "tan", "exp", "sinh", "cosh", "tanh", "atan", "asin", "acos", "log", "abs", "sign")


def expression(draw, table, symbols, depth):
    """A random expression."""
    if depth == 0:
        return draw.choice([*symbols, table.number(Fraction(draw.randint(-30, 30), 7)), table.pi])
    one = expression(draw, table, symbols, depth - 1)
    kind = draw.choice(["sum", "product", "power", "call", "call"])
    if kind == "power":
        return table.power(one, table.number(draw.choice([Fraction(1, 2), Fraction(-1), Fraction(2), Fraction(3),
                                                          Fraction(-2), Fraction(3, 2), Fraction(-1, 2)])))
    if kind == "call":
        return table.call(draw.choice(FUNCTIONS), one)
    other = expression(draw, table, symbols, depth - 1)
    return one + other if kind == "sum" else one * other


@pytest.mark.parametrize("name", FUNCTIONS)
def test_intervals_of_points_are_narrow(name):
    """Of a point of the domain nothing but rounding is added, however small or large it is."""
    draw, table = random.Random(name), Table()
    x, bounded = table.variable("x"), name in ("asin", "acos")
    at = [draw.choice([1, -1]) * 10 ** draw.uniform(-12, 0 if bounded else 1.5) for _ in range(200)]
    at = np.abs(at) if name == "log" else np.array(at)
    with np.errstate(all="ignore"):
        found, = evaluate([table.call(name, x)], Intervals, {"x": Interval(at, at)})
    with mpmath.workdps(30):
        size = [abs(float(getattr(mpmath, {"abs": "fabs"}.get(name, name))(u))) for u in at]
    assert np.all(found.high - found.low <= 1e-12 * (1 + np.array(size)) ** 2)


@pytest.mark.sweep
def test_intervals_hold_all_values():
    draw, compared = random.Random("intervals"), 0
    for _ in range(300):
        table = Table()
        symbols = [table.variable(name) for name in "xy"]
        try:
            node = expression(draw, table, symbols, draw.randint(1, 3))
        except (ZeroDivisionError, OverflowError):
            continue
        ends = {name: sorted(draw.choice([0.0, draw.uniform(-4, 4), draw.uniform(-4, 4) * 10**draw.uniform(-6, 3)])
                             for _ in range(2)) for name in "xy"}
        box = {name: Interval(np.array([low]), np.array([high])) for name, (low, high) in ends.items()}
        with np.errstate(all="ignore"):
            found, = evaluate([node], Intervals, box)
        low, high = (float(np.ravel(end)[0]) for end in (found.low, found.high))
        for _ in range(8):
            at = {name: draw.choice([*pair, draw.uniform(*pair)]) for name, pair in ends.items()}
            with mpmath.workdps(40):
                try:
                    exact, = evaluate([node], multiprecision(), {name: mpmath.mpf(x) for name, x in at.items()})
                except (ZeroDivisionError, ValueError, OverflowError):
                    continue
                if isinstance(exact, mpmath.mpc) or not mpmath.isfinite(exact):
                    continue
                assert low <= exact <= high, (node, at, ends)
            compared += low > -np.inf and high < np.inf
    assert compared > 500


BUMPS = "1/(1 + (x - 1)^2 + y^2) + 1/(1 + (x + 1)^2 + y^2) + (x^2 + y^2)/10"


@pytest.mark.sweep
@pytest.mark.parametrize("within, count", [(2, 5), (5, 7)])
def test_two_bumps_on_a_bowl(within, count):
    """Seven places within 5, of which many starts meet six; on y = 0 the zeros of the slope are ±2.2198,
    ±1.0246 and 0, on x = 0 they are ±1.5723 and 0."""
    found = scene_of_potential(BUMPS, "xy", within).equilibria
    assert found.complete and len(found.items) == count
    places = [tuple(round(x, 4) + 0.0 for x in item.equilibrium.values.values()) for item in found.items]
    assert places == sorted((-x + 0.0, -y + 0.0) for x, y in places)
    assert {(0.0, -1.5723), (0.0, 0.0), (1.0246, 0.0)} <= set(places)


def blind(monkeypatch):
    """Searches that look at the drawn position alone."""
    monkeypatch.setattr(all_equilibria, "_search", lambda forces, found, first: None)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(4))
def test_what_a_search_misses_is_found_or_not_called_complete(seed, monkeypatch):
    """V = P(x) + Q(x + y): x is a root of P′ and x + y one of Q′."""
    blind(monkeypatch)
    draw = random.Random(seed)
    one, two = ([root / 8 for root in draw.sample(range(-9, 10), 3)] for _ in "xy")
    V = " + ".join(f"(({u})^4/4 - ({sum(r)})*({u})^3/3 + ({r[0] * r[1] + r[0] * r[2] + r[1] * r[2]})*({u})^2/2 - "
                   f"({r[0] * r[1] * r[2]})*({u}))" for u, r in (("x", one), ("x + y", two)))
    found = scene_of_potential(V, "xy", 3).equilibria
    places = sorted((x, u - x) for x, u in product(one, two))
    assert found.complete
    assert [tuple(item.equilibrium.values.values()) for item in found.items] == [
        pytest.approx(place, abs=1e-9) for place in places]


@pytest.mark.sweep
def test_angles_that_go_round(monkeypatch):
    """cos x + cos 2y: 2·4 places on the torus, those on its seam once; cos x + cos y + cos z: eight."""
    blind(monkeypatch)
    for V, names, count in (("cos(x) + cos(2*y)", "xy", 8), ("cos(x) + cos(y) + cos(z)", "xyz", 8)):
        found = scene_of_potential(V, names, None).equilibria
        assert found.complete and len(found.items) == count


@pytest.mark.sweep
@pytest.mark.parametrize("V, names", [
    ("x^4", "x"), ("(x - 1/3)^3", "x"), ("x^2*(x - 1)^3", "x"), ("(x^2 + y^2 - 1)^2", "xy"), ("abs(x) - x^2/3", "x"),
    ("x^3/3 - 1e-40*x", "x"), ("x^2 + y^2 + z^2 + w^2 + x^4", "xyzw"), ("1/(x - 1/3)^2 - x", "x"),
    ("max(abs(x) - 1, 0)^2", "x")])
def test_what_is_not_proved_is_not_called_complete(V, names, tmp_path, capsys):
    """Multiple zeros, circles, kinks, zeros nearer than rounding, many coordinates, poles of odd order."""
    made = scene_of_potential(V, names)
    assert not made.equilibria.complete and not made.equilibria.cut
    path = tmp_path / "scene.yaml"
    limits = ", ".join(f"{name}: [-2, 2]" for name in names)
    T = " + ".join(f"{name}'^2" for name in names)
    path.write_text(f"parameters: {{J: 1 kg*m^2, E: 1 J}}\ncoordinates: [{', '.join(names)}]\nfind: {{equilibria: all, "
                    f"within: {{{limits}}}}}\nenergies:\n  T: J/2*({T})\n  V: E*({V})\n")
    assert run(["solve", str(path)]) == 0
    out = capsys.readouterr().out
    assert "it is not proved that there are no others" in out and "proved by" not in out


@pytest.mark.parametrize("V, count", [("x^2/2 + 1/10/(1 - x)", 1), ("cos(x)", 2), ("x^3/3 - 1e-8*x", 2),
                                      ("exp(x) - 2*x", 1), ("x^2 + exp(x)", 1), ("x - x^5", 2)])
def test_zeros_beside_the_bounds_do_not_count(V, count):
    """Within ±π, which are one place of cos x."""
    found = scene_of_potential(V, within=pi).equilibria
    assert found.complete and len(found.items) == count
