"""Steady loads across beams whose tension varies along them, against sums of solutions by DOP853:

    EI u⁗ − ((N₀ + n x) u′)′ = q(x)        u = u′ = 0 at the clamp, u″ = u‴ = 0 where the tension has ended
"""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import vibcli
from vibcli.mechanics.internal_forces import forces_at_rest
from vibcli.mechanics.rest_curves import value_at_rest
from vibcli.numerics.pieces import graded_rest

H, EI, MU, G = 20.0, 2e7, 300.0, 9.81


def mast(load, to, more="", bed=""):
    return vibcli.loads(f"""
        gravity: 9.81 m/s^2
        parameters: {{H: 20 m, EI: 2e7 N*m^2, mu: 300 kg/m, q0: 500 N/m}}
        beams: {{mast: {{from: [0, 0], to: [0, {to}], EI: EI, mass_per_length: mu{bed}, left: clamped}}}}
        forces: {{wind: {{body: mast, per_length: {load}{more}}}}}
        """)


def exact(q, tension, stops=(0.0, H), k=0.0):
    """{place: (u, u′, u″, u‴)} at stops between which q is smooth."""
    gradient = -tension / H

    def along(start, loaded):
        found = [np.array(start, dtype=float)]
        for a, b in pairwise(stops):
            def rates(x, y, middle=(a + b) / 2):
                bent = (tension + gradient * x) * y[2] + gradient * y[1] - k * y[0] + loaded * q(x, middle)
                return [y[1], y[2], y[3], bent / EI]
            found.append(solve_ivp(rates, (a, b), found[-1], method="DOP853", rtol=1e-12, atol=1e-15).y[:, -1])
        return np.array(found)

    own, first, second = along([0, 0, 0, 0], 1), along([0, 0, 1e-3, 0], 0), along([0, 0, 0, 1e-4], 0)
    shares = np.linalg.solve(np.column_stack((first[-1, 2:], second[-1, 2:])), -own[-1, 2:])
    return dict(zip(stops, own + shares[0] * first + shares[1] * second, strict=True))


@pytest.mark.sweep
@pytest.mark.parametrize(("load", "q"), [("q0", lambda x, _: 500.0), ("q0*x/H", lambda x, _: 500 * x / H)])
def test_a_mast_in_the_wind(load, q):
    model, u = mast(load, "H"), exact(q, -MU * G * H, (0.0, 7.3, H))
    for signal, value in (("u(H)", u[H][0]), ("u(7.3 m)", u[7.3][0]), ("slope(7.3 m)", u[7.3][1]),
                          ("moment(0 m)", EI * u[0.0][2]), ("moment(7.3 m)", EI * u[7.3][2]),
                          ("shear(0 m)", EI * u[0.0][3])):
        assert model[f"equilibrium[mast.{signal}]"].value == pytest.approx(value, rel=1e-10)
        assert value_at_rest(model._problem.configuration, f"mast.{signal}") == pytest.approx(value, rel=1e-10)


@pytest.mark.sweep
def test_a_hanging_mast_under_a_load_on_a_part_of_it():
    model = mast("q0*sin(pi*x/H)^2", "-H", ", from: 5 m, to: 12 m")
    u = exact(lambda x, middle: 500 * np.sin(np.pi * x / H) ** 2 * (5 < middle < 12), MU * G * H, (0.0, 5.0, 12.0, H))
    assert model["equilibrium[mast.u(H)]"].value == pytest.approx(u[H][0], rel=1e-10)
    assert model["equilibrium[mast.moment(0 m)]"].value == pytest.approx(EI * u[0.0][2], rel=1e-10)


@pytest.mark.sweep
@pytest.mark.parametrize(("load", "q", "k"), [("q0*x/H", lambda x, _: 500 * x / H, 0.0), (
    "q0*x/H", lambda x, _: 500 * x / H, 2e3), ("q0", lambda x, _: 500.0, 2e3)])
def test_diagrams_of_a_mast_on_a_bed_in_the_wind(load, q, k):
    model, places = mast(load, "H", bed=f", foundation: {k} N/m^2" if k else ""), (0.0, 4.1, 15.0, H)
    u = exact(q, -MU * G * H, places, k)
    shear, moment = forces_at_rest(model._problem.configuration)
    for force, order in ((shear, 3), (moment, 2)):
        values = force.stretches[0].values(np.array(places))
        assert values == pytest.approx([EI * u[x][order] for x in places], rel=1e-9, abs=1e-9 * force.largest)


@pytest.mark.sweep
@pytest.mark.parametrize("load", ["q0*sqrt(x/H)", "q0*abs(sin(7*x/H))"])
def test_diagrams_under_rough_loads_agree_with_pieces_that_are_cut(load, monkeypatch):
    model, places = mast(load, "H"), np.array([0.0, 3.3, 17.0, H])
    found = [force.stretches[0].values(places) for force in forces_at_rest(model._problem.configuration)]
    monkeypatch.setattr(graded_rest, "DEGREES", ())
    for force, values in zip(forces_at_rest(model._problem.configuration), found, strict=True):
        assert force.stretches[0].values(places) == pytest.approx(values, rel=1e-6, abs=1e-8 * abs(values).max())
