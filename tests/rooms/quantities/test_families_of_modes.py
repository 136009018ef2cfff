"""Families of free motions of several degrees of freedom: closed forms, integration over a period, refusals."""

import json
import re

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from support.motions import problem
from support.references import CLOSED_LOOP

from vibcli.api.values import given_expression
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.quantities.expression import measure

PAIR = """
parameters: {m: 1 kg, k: 5 N/m, b: 2 N/m^3, c: 1.3 N/m, f: 1.5 N/m^3}
bodies: {left: {mass: m, slide: x}, right: {mass: m, slide: y}}
springs:
  s: {law: k*d + b*d^3, between: [ground, left]}
  t: {law: c*d + f*d^3, between: [left, right]}
  u: {law: k*d + b*d^3, between: [ground, right]}
"""
CART = """
parameters: {M: 2 kg, m: 1 kg, L: 0.5 m, k: 30 N/m, g: 9.81 m/s^2}
gravity: g
points: {W: [-1 m, 0]}
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [W, cart]}}
"""
TRUSS = """
parameters: {m: 1 kg, k: 40 N/m, c: 9 N/m, b: 300 N/m^3}
bodies: {left: {mass: m, slide: x}, right: {mass: 2*m, slide: y}}
springs: {s: {law: k*d - b*d^3, between: [ground, left]}, t: {k: c, between: [left, right]}}
"""
TURNING = """
parameters: {m: 1 kg, k: 50 N/m, b: 300 N/m^3, W: 2 rad/s}
coordinates: {x: a place, y: a place}
energies:
  T: m*((x' - W*y)^2 + (y' + W*x)^2)/2
  V: k*(x^2 + 2*y^2)/2 + b*x^4/4
"""


def asked(text, what):
    return measure(problem(text), given_expression(what, "it").tree)


def duffing(k, b, amplitude):
    """ω of q̈ + k q + b q³ = 0."""
    cubic = mpmath.mpf(b) * mpmath.mpf(amplitude) ** 2
    return mpmath.pi * mpmath.sqrt(k + cubic) / (2 * mpmath.ellipk(cubic / (2 * (k + cubic))))


@pytest.mark.parametrize(("number", "k", "b"), [(1, 5, 2), (2, 7.6, 14)])
@pytest.mark.parametrize("amplitude", ["0.01", "0.5", "2"])
def test_equal_masses_between_cubic_springs_move_on_straight_lines(number, k, b, amplitude):
    """x = ±y: of x alone q̈ + k q + b q³, with the middle spring at rest, or of twice the stretch."""
    with mpmath.workdps(30):
        for signal in ("x", "y"):
            found, error = asked(PAIR, f"backbone[{number}]({signal})({amplitude} m)")
            assert abs(found / duffing(k, b, amplitude) - 1) <= error <= 2e-12
    if number == 2:
        assert asked(PAIR, f"backbone[2](t.stretch)(2*{amplitude} m)")[0] == pytest.approx(found, rel=1e-13)


def _pendulum_on_a_cart(_, s):
    x, phi, v, w = s
    M = [[3.0, 0.5 * np.cos(phi)], [0.5 * np.cos(phi), 0.25]]
    return [v, w, *np.linalg.solve(M, [0.5 * np.sin(phi) * w * w - 30 * x, -0.5 * 9.81 * np.sin(phi)])]


def _come_to_rest(start, half):
    end = solve_ivp(_pendulum_on_a_cart, (0, half), [*start, 0, 0], method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    return np.array([end[2], end[3], 0.5 * abs(start[1] - end[1]) - 0.9])


@pytest.mark.sweep
@pytest.mark.parametrize("number", [1, 2])
def test_a_pendulum_on_a_cart_comes_to_rest_after_half_a_period(number):
    """By shooting: of the places of rest one is found near those of the linear mode, through the amplitudes."""
    text, slope = problem(CART), np.zeros((3, 3))
    omega, error = measure(text, given_expression(f"backbone[{number}](phi)(0.9 rad)", "it").tree)
    mode = text.modal.modes.first(2)[number - 1].shape
    u = np.array([0.9 * mode[0] / mode[1], 0.9, np.pi / omega])
    for _ in range(5):
        r = _come_to_rest(u[:2], u[2])
        for i in range(3):
            step = np.where(np.arange(3) == i, 1e-6, 0)
            slope[:, i] = (_come_to_rest((u + step)[:2], (u + step)[2]) - r) / 1e-6
        u = u - np.linalg.solve(slope, r)
    assert np.abs(r).max() < 1e-10
    assert abs(np.pi / u[2] / omega - 1) < 1e-11 and error < 2e-12


def test_dampers_are_left_out():
    damped = PAIR + "dampers: {d: {c: 3 N*s/m, between: [ground, left]}}\n"
    assert asked(damped, "backbone[1](x)(10 cm)") == asked(PAIR, "backbone[1](x)(10 cm)")


@pytest.mark.parametrize(("text", "what", "message"), [
    (PAIR, "backbone[3](x)(1 m)", "2 families"),
    (PAIR, "backbone[1](t.stretch)(1 m)", "does not move in the family of mode 1"),
    (PAIR, "backbone[1](x')(1 m/s)", "a displacement or a spring"),
    (PAIR, "backbone[1](x)(0 m)", "positive"),
    (PAIR.replace("c: 1.3 N/m", "c: 20 N/m"), "backbone[1](x)(1 m)", "mode 2 has 3 times the frequency of mode 1"),
    (PAIR + "forces: {p: {at: left, force: (1 N)*sin((2 rad/s)*t)}}\n", "backbone[1](x)(1 m)", "in time drive"),
    (CLOSED_LOOP, "backbone[1](phi)(0.1 rad)", "closed loops"),
    (TRUSS, "backbone[1](x)(1 m)", "family 1 is followed up to 0.37.* more than 64 harmonics"),
    (TURNING, "backbone[1](x)(10 cm)", "turn with the sense of the motion"),
    (TRUSS.replace("- b*d^3", "+ b*(1 m^3)*sign(d)"), "backbone[1](x)(1 m)", "bend or jump at the equilibrium"),
])
def test_what_has_no_such_motion_is_refused(text, what, message):
    with pytest.raises(PhysicsError) as refused:
        asked(text, what)
    assert re.search(message, f"{refused.value} {refused.value.hint}")


def test_a_motion_across_a_bend_keeps_its_bound():
    """x = y with k d + b d |d|: T = 4 ∫ dx/√(k (A² − x²) + 2/3 b (A³ − x³)), x = A (1 − u²)."""
    found, error = asked(PAIR.replace("b*d^3", "b*(1 m)*d*abs(d)"), "backbone[1](x)(0.8 m)")

    def integrand(u):
        x = 0.8 * (1 - u * u)
        return 1.6 * u / mpmath.sqrt(5 * (0.64 - x * x) + mpmath.mpf(4) / 3 * (0.512 - x**3))

    exact = mpmath.pi / (2 * mpmath.quad(integrand, [0, 1]))
    assert abs(found / exact - 1) <= error < 1e-6


@pytest.mark.sweep
def test_an_internal_resonance_is_told_and_the_family_named(tmp_path, capsys):
    """ω₂ is a little more than 3 ω₁: harmonic 3 of the first family moves as mode 2 does."""
    file = tmp_path / "pair.yaml"
    text = "title: Two blocks\n" + PAIR.replace("c: 1.3 N/m", "c: 20.2 N/m").replace("law: k*d + b*d^3, between: "
                                                "[ground, right]", "k: k, between: [ground, right]")
    file.write_text(text + "find: [{backbone: {of: [x], up_to: 1 m}}]\n")
    assert run(["frequencies", str(file), "--backbone"]) == 0
    assert "Internal resonance near 3:1" in capsys.readouterr().out
    file.write_text(text + "find: [{backbone: {of: [x], up_to: 10 cm, mode: 2}}]\n")
    assert run(["frequencies", str(file), "--backbone", "--json"]) == 0
    points = json.loads(capsys.readouterr().out)["backbone"]["points"]
    assert points[-1]["omega"] == pytest.approx(asked(text, "backbone[2](x)(10 cm)")[0], rel=1e-14)


@pytest.mark.sweep
def test_an_interrupt_keeps_the_motions_that_were_found(tmp_path, capsys, monkeypatch):
    from vibcli.analyses.nonlinear.family_of_mode import FamilyOfMode

    landed = FamilyOfMode._landed

    def interrupted(self, *args):
        if len(self.found) == 3:
            raise KeyboardInterrupt
        return landed(self, *args)

    file = tmp_path / "blocks.yaml"
    file.write_text(PAIR + "find: [{backbone: {of: [x], up_to: 1 m}}]\n")
    assert run(["frequencies", str(file), "--backbone", "--save", str(tmp_path / "curve.svg")]) == 0
    whole = capsys.readouterr().out
    (tmp_path / "curve.svg").unlink()
    monkeypatch.setattr(FamilyOfMode, "_landed", interrupted)
    assert run(["frequencies", str(file), "--backbone", "--save", str(tmp_path / "curve.svg")]) == 130
    told = capsys.readouterr()
    assert "Interrupted: 3 of 10 motions were found." in told.out and told.err == "interrupted\n"
    rows = [line for line in whole.splitlines() if line.startswith(("  0.1 ", "  0.2 ", "  0.3 "))]
    assert len(rows) == 6 and all(row in told.out for row in rows)        # of the table, which is set in two parts
    assert not (tmp_path / "curve.svg").exists()
