"""Laws of motions and frequency responses, on scenes that hypothesis draws: superposition, reciprocity, the balance of
energy, time run backwards."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial.legendre import leggauss
from support.laws import EPS, FEW, LAW, rows, told, written

import vibcli

INSTANT = "0.7 s"
POINTS = 12     # of the integral of what is dissipated


def load(at, text):
    return {"at": f"b{at}", "force": text}


WAVES = st.sampled_from(["3 N*sin(2 rad/s*t)", "2 N*step(t - 0.2 s)", "(1 N/s)*ramp(t)", "5 N*exp(-2 s^-1*t)",
                         "2 N*square(5 rad/s*t)", "(0.3 N*s)*impulse(t - 0.1 s)"])


@pytest.mark.sweep
@FEW
@given(rows(most=3, damped=True), WAVES, WAVES)
def test_superposition(row, one, two):
    """A motion under two loads and from a start is the sum of those from each."""
    start = {"x0": "1 cm", "x1'": "0.2 m/s"}
    alone = [row.model(forces={"f": load(0, one)}), row.model(forces={"f": load(1, two)}), row.model(initial=start)]
    whole = row.model(forces={"f": load(0, one), "g": load(1, two)}, initial=start)
    for i in range(len(row.masses)):
        signal = f"x{i}({INSTANT})"
        parts = [model[signal] for model in alone]
        size, bound = sum(abs(part.value) for part in parts), sum(part.error for part in parts)
        value, error = told(whole, signal, size)
        assert abs(value - sum(part.value for part in parts)) <= error + bound + 8 * EPS * size
        assert bound <= 1e-9 * size


@pytest.mark.sweep
@LAW
@given(rows(damped=True), st.data(), st.integers(1, 99))
def test_reciprocity_of_rows(row, data, tenths):
    """Where one is pushed and another looked at, they may be exchanged (Maxwell, Betti, Rayleigh)."""
    i, j = data.draw(st.permutations(range(len(row.masses))))[:2]
    model = row.model()
    there, back = (model[f"frf[x{a}, x{b}]({tenths / 10} rad/s)"] for a, b in ((i, j), (j, i)))
    assert abs(there.value - back.value) <= there.error + back.error <= 1e-9 * abs(there.value)


@pytest.mark.sweep
@FEW
@given(st.integers(1, 19), st.integers(1, 19), st.integers(1, 400), st.booleans())
def test_reciprocity_of_members(one, two, omega, damped):
    """The same of two places of a beam that carries a mass, with and without a damper."""
    def place(at):
        return f"{at / 20} m"

    attached = [{"at": "0.4 m", "mass": "1 kg"}, *[{"at": "0.7 m", "c": "5 N*s/m"}] * damped]
    beam = {"length": "1 m", "EI": "100 N*m^2", "mass_per_length": "2 kg/m", "left": "clamped", "attached": attached}
    values = []
    for here, there in ((one, two), (two, one)):
        model = vibcli.load({"beams": {"b": beam}, "points": {"P": {"body": "b", "at": place(there)}},
                             "forces": {"f": {"at": "P", "force": "1 N*sin(3 rad/s*t)"}}})
        values.append(model[f"frf[b.u({place(here)}), f]({omega} rad/s)"])
    assert abs(values[0].value - values[1].value) <= values[0].error + values[1].error
    assert values[0].error <= 1e-8 * abs(values[0].value)


@FEW
@given(rows(most=3), st.integers(1, 40))
def test_energy_stays_where_nothing_damps(row, tenths):
    model = row.model(initial={"x0": "1 cm", "x1'": "0.2 m/s"})
    before, after = ([model[f"{energy}({t} s)"] for energy in "TV"] for t in (0, tenths / 10))
    total = sum(part.value for part in before)
    bound = sum(part.error for part in before + after)
    assert abs(sum(part.value for part in after) - total) <= bound + 4 * EPS * total and bound <= 1e-9 * total


@pytest.mark.sweep
@FEW
@given(rows(most=3, damped=True))
def test_energy_that_is_lost_is_what_dampers_take(row):
    """E(0) − E(t) = ∫ 2Φ dt, by Gauss's rule."""
    end = float(1 / sum(row.model().omega))
    model = row.model(initial={"x0": "1 cm", "x1'": "0.2 m/s"})
    energies = [sum(model[f"{energy}({t!r} s)"].value for energy in "TV") for t in (0.0, end)]
    nodes, weights = leggauss(POINTS)
    lost = sum(weight * end / 2 * 2 * model[f"Phi({float(end * (node + 1) / 2)!r} s)"].value
               for node, weight in zip(nodes, weights, strict=True))
    assert energies[0] - energies[1] == pytest.approx(lost, rel=1e-7, abs=1e-13 * energies[0])


@pytest.mark.sweep
@LAW
@given(rows(damped=True), st.integers(5, 90))
def test_power_that_a_load_brings_in_is_what_dampers_take(row, tenths):
    """Over a period of the steady state."""
    model = row.model(forces={"f": load(0, f"3 N*sin({tenths / 10} rad/s*t)")})
    taken = [model[f"mean(d{i}.power)"] for i in range(len(row.dampers))]
    brought = model["mean(f.power)"]
    total = math.fsum(part.value for part in taken)
    bound = brought.error + sum(part.error for part in taken)
    assert abs(brought.value - total) <= min(bound + 4 * EPS * total, 1e-7 * total)


def reversed_back(scene, names, end, start):
    """From `start` for a time, the velocities turned round, and for that time again: (value, bound) of each coordinate
    and velocity then, the velocities turned round once more."""
    def state(model):
        return {name + prime: model[f"{name}{prime}({end} s)"] for name in names for prime in ("", "'")}

    there = state(scene(initial=start))
    back = {name: (f"{-one.value if name.endswith(chr(39)) else one.value:.17g} {one.unit}").strip()
            for name, one in there.items()}
    found = state(scene(initial=back))
    return {name: ((-1 if name.endswith("'") else 1) * one.value, there[name].error + one.error)
            for name, one in found.items()}


@pytest.mark.sweep
@FEW
@given(rows(most=3), st.integers(1, 30))
def test_time_run_backwards(row, tenths):
    names = [f"x{i}" for i in range(len(row.masses))]
    found = reversed_back(row.model, names, tenths / 10, {"x0": "1 cm", "x1'": "0.2 m/s"})
    for name, (value, _) in found.items():
        wanted = {"x0": 0.01, "x1'": 0.2}.get(name, 0.0)
        assert value == pytest.approx(wanted, abs=1e-9)


@pytest.mark.sweep
@FEW
@given(st.integers(1, 9), st.integers(20, 90), st.integers(5, 25))
def test_time_run_backwards_in_wide_motions(mass, stiffness, tenths):
    """The same of the full equations: a pendulum that swings widely on a cart on a spring."""
    def scene(**sections):
        return vibcli.load({"gravity": "9.81 m/s^2", "motion": "full", "bodies": {
            "cart": {"mass": written(mass, "kg"), "at": ["0 m", "0 m"], "slide": "x"},
            "bob": {"mass": "1 kg", "at": ["0 m", "-0.5 m"], "pin": {"at": ["0 m", "0 m"], "carrier": "cart",
                                                                    "by": "phi"}}},
            "springs": {"s": {"k": written(stiffness, "N/m"), "between": [["-1 m", "0 m"], "cart"]}}, **sections})

    found = reversed_back(scene, ("x", "phi"), 0.5, {"x": "1 cm", "phi": f"{tenths / 10} rad"})
    for name, (value, bound) in found.items():
        wanted = {"x": 0.01, "phi": tenths / 10}.get(name, 0.0)
        assert abs(value - wanted) <= 1e-7 and bound <= 1e-7
