"""Springs and dampers whose laws are tables: rest, periods and motions against SciPy's interpolation, files, and what
lies beyond their ends."""

import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

import vibcli
from vibcli.base.errors import PhysicsError, SpecError

D = [-4e-3, -2e-3, 0.0, 1e-3, 2e-3, 4e-3]
F = [-90.0, -40.0, 0.0, 15.0, 40.0, 100.0]
POINTS = "[[-4 mm, -90 N], [-2 mm, -40 N], [0 mm, 0 N], [1 mm, 15 N], [2 mm, 40 N], [4 mm, 100 N]]"
SCENE = """
bodies: {{block: {{mass: 2 kg, slide: x}}}}
springs: {{s: {{law: {law}, between: [ground, block]}}}}
{more}
"""
FORCE = PchipInterpolator(D, F)
ENERGY = FORCE.antiderivative()


def _model(law, more=""):
    return vibcli.loads(SCENE.format(law=law, more=more))


def test_a_block_rests_and_vibrates_where_the_cubics_say():
    model = _model(POINTS, "forces: {f: {at: block, force: 50 N}}")
    x = brentq(lambda d: FORCE(d) - 50, 2e-3, 4e-3, xtol=1e-18)
    assert model["equilibrium[x]"].value == pytest.approx(x, rel=1e-14)
    assert model["omega[1]"].value == pytest.approx(math.sqrt(FORCE(x, 1) / 2), rel=1e-13)


@pytest.mark.sweep
def test_the_period_splits_at_the_points():
    model = _model(POINTS, "initial: {x: 3 mm}\nmotion: full")
    E = ENERGY(3e-3)
    left = brentq(lambda x: ENERGY(x) - E, -4e-3, -1e-4, xtol=1e-19)

    def quarter(end, stop):
        """From the end to a point, where x = end − side r²."""
        side = math.copysign(1, end)
        return quad(lambda r: 2 * r * math.sqrt(1 / (E - ENERGY(end - side * r * r))), 0, math.sqrt(abs(end - stop)),
                    epsabs=0, epsrel=1e-11)[0]

    inner = sum(quad(lambda x: math.sqrt(1 / (E - ENERGY(x))), a, b, epsabs=0, epsrel=1e-12)[0]
                for a, b in ((-2e-3, 0), (0, 1e-3), (1e-3, 2e-3)))
    period = model["period(x)"]
    assert period.value == pytest.approx(2 * (inner + quarter(left, -2e-3) + quarter(3e-3, 2e-3)), rel=1e-10)
    assert model[f"x({period.value!r} s)"].value == pytest.approx(3e-3, rel=1e-12)


@pytest.mark.sweep
def test_a_damper_from_a_table_loses_what_it_says():
    law = "{table: [[-0.5 m/s, -9 N], [0, 0], [0.1 m/s, 2 N], [0.5 m/s, 4 N]], beyond: linear}"
    model = _model("800 N/m*d", f"dampers: {{c: {{law: {law}, between: [ground, block]}}}}\n"
                   "initial: {x': 0.7 m/s}\nmotion: full")
    inner = PchipInterpolator([-0.5, 0, 0.1, 0.5], [-9.0, 0, 2, 4])

    def friction(v):
        end = min(max(v, -0.5), 0.5)
        return float(inner(end) + inner(end, 1) * (v - end))

    wanted = solve_ivp(lambda t, y: [y[1], -(800 * y[0] + friction(y[1])) / 2], (0, 0.25), [0, 0.7], rtol=1e-10,
                       atol=1e-13, method="DOP853", max_step=2e-3).y[:, -1]
    assert [model["x(0.25 s)"].value, model["x'(0.25 s)"].value] == pytest.approx(wanted, rel=1e-7)


def test_a_file_says_the_same_as_points(tmp_path):
    (tmp_path / "stiffness.csv").write_text("# measured\nforce,d,other\n" + "".join(
        f"{f / 1000!r},{d * 1000:.0f},7\n" for d, f in zip(D, F, strict=True)))
    scene = tmp_path / "scene.yaml"
    load = "forces: {f: {at: block, force: 33 N}}"
    scene.write_text(SCENE.format(law="{table: stiffness.csv, columns: [d, 1], units: [mm, kN]}", more=load))
    found, plain = vibcli.load(scene), _model(POINTS, load)
    for quantity in ("equilibrium[x]", "omega[1]"):
        assert found[quantity].value == plain[quantity].value


@pytest.mark.parametrize(("more", "asked"), [
    ("forces: {f: {at: block, force: 150 N}}", "equilibrium[x]"),
    ("", "law[s](9 mm)"), ("initial: {x: 3.9 mm, x': 0.1 m/s}\nmotion: full", "x(3 ms)")])
def test_the_end_of_a_table_is_told(more, asked):
    with pytest.raises(PhysicsError, match=r"table of 's'|'s' has no force"):
        _ = _model(POINTS, more)[asked].value
    assert math.isfinite(_model(f"{{table: {POINTS}, beyond: linear}}", more)[asked].value)


def test_a_table_in_series_needs_to_go_on():
    scene = SCENE.replace("law: {law}", "series: [{{k: 30 N/mm}}, {{law: {law}}}]")
    with pytest.raises(SpecError, match="ends where its table ends"):
        _ = vibcli.loads(scene.format(law=POINTS, more=""))["omega[1]"].value
    law = f"{{table: {POINTS}, beyond: linear}}"
    model = vibcli.loads(scene.format(law=law, more="forces: {f: {at: block, force: 50 N}}"))
    inner = brentq(lambda d: FORCE(d) - 50, 2e-3, 4e-3, xtol=1e-18)
    assert model["equilibrium[x]"].value == pytest.approx(inner + 50 / 30e3, rel=1e-14)
    assert np.isclose(model["equilibrium[s.stretch.2]"].value, inner, rtol=1e-14, atol=0)
