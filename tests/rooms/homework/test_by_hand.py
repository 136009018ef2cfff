"""Keys of sheets that were handed out, reckoned by hand from what a student reads: plain arithmetic, and formulas
written out here."""

import csv
import os
import re
import unicodedata
from math import cos, degrees, pi, sin, sqrt, tan
from pathlib import Path

import pytest

from vibcli.cli.program import run

PROBLEMS = Path(__file__).parents[3] / "problems"
GIVEN = re.compile(r'<li><math alttext="([^"]+)">.*?</math> = ([-−\d.]+) ?([^<]*)</li>')
GREEK = {"Ω": "Omega", "Φ": "Phi", "μ": "mu"}
PREFIXED = {"kN/m": 1e3, "mm": 1e-3, "cm": 1e-2, "g/m": 1e-3, "g": 1e-3}


def root(f, low, high):
    """Where a function passes zero, by halving."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(middle) < 0) == (f(low) < 0) else (low, middle)
    return low


def pulley(J, m1, m2, R, r, k1, k2, **_):
    """Both springs stretch with their weights."""
    return {"omega[1]": sqrt((k1 * R * R + k2 * r * r) / (J + m1 * R * R + m2 * r * r))}


def boom(m, L, kt, ct, g, **_):
    """About its rest the weight turns with the boom."""
    rest = root(lambda phi: kt * phi + m * g * L / 2 * cos(phi), -pi / 2, 0.0)
    inertia, stiffness = m * L * L / 3, kt - m * g * L / 2 * sin(rest)
    delta = ct / (2 * inertia)
    return {"equilibrium[phi]": degrees(rest), "zeta[1]": delta / sqrt(stiffness / inertia),
            "omega_d[1]": sqrt(stiffness / inertia - delta * delta)}


def torsiograph(J, kt, ct, Phi, Omega, **_):
    """A seismic ring: r²/√((1 − r²)² + (2ζr)²) of what the case does."""
    omega, zeta = sqrt(kt / J), ct / (2 * sqrt(kt * J))
    r = Omega / omega
    return {"omega[1]": omega, "zeta[1]": zeta,
            "amplitude(theta)": Phi * r * r / sqrt((1 - r * r)**2 + (2 * zeta * r)**2)}


def cart(m1, m2, L, g, **_):
    """The bob swings against the cart about the mass centre of both."""
    return {"omega[2]": sqrt(g / L * (1 + m2 / m1))}


def inerter(m1, m2, k1, k2, c1, b, F0, Omega, **_):
    """(K + iΩC − Ω²M) X = F of machine and frame; the ground feels k₂ X₂."""
    a2, a1, a0 = m1 * m2 + b * (m1 + m2), m1 * (k1 + k2) + m2 * k1 + b * k2, k1 * k2
    part = sqrt(a1 * a1 - 4 * a2 * a0)
    between = k1 + 1j * Omega * c1 - Omega**2 * b
    machine, frame = between - Omega**2 * m1, between + k2 - Omega**2 * m2
    force = k2 * F0 * between / (machine * frame - between * between)
    return {"omega[1]": sqrt((a1 - part) / (2 * a2)), "omega[2]": sqrt((a1 + part) / (2 * a2)),
            "amplitude(ground.force)": abs(force)}


def string(L, mu, T, m, **_):
    """At the bead the two pieces pull back: T β (cot βL/3 + cot 2βL/3) = m ω²."""
    def left(beta):
        return T * beta * (1 / tan(beta * L / 3) + 1 / tan(2 * beta * L / 3)) - m * beta * beta * T / mu

    first, second = (root(left, (low + 1e-9) * pi / L, (high - 1e-9) * pi / L) for low, high in ((0, 1.5), (1.5, 3)))
    return {f"frequency[{k}]": beta * sqrt(T / mu) / (2 * pi) for k, beta in ((1, first), (2, second))}


def pendulum(L, g, **_):
    """By the arithmetic-geometric mean of 1 and cos ½Φ (Gauss)."""
    one, other = 1.0, cos(pi / 4)
    for _ in range(10):
        one, other = (one + other) / 2, sqrt(one * other)
    return {"omega[1]": sqrt(g / L), "backbone[1](phi)(90 deg)": sqrt(g / L) * one}


BY_HAND = {
    "3_free_undamped/stepped_pulley_two_weights": pulley, "4_free_damped/sagging_boom": boom,
    "5_forced/torsiograph_on_a_shaft": torsiograph, "6_two_degrees/cart_with_pendulum": cart,
    "7_forced_two_degrees/inerter_under_a_machine": inerter, "8_continuous/string_with_a_bead": string,
    "9_equivalents_and_corrections/pendulum_that_swings_widely": pendulum,
}


def given_on(page):
    """{letter: value in SI units} of what stands under `Given` on a sheet."""
    found = {}
    for letter, number, unit in GIVEN.findall(page):
        name = unicodedata.normalize("NFKC", letter)
        found[GREEK.get(name, name)] = float(number) * PREFIXED.get(unit, 1.0)
    return found


@pytest.mark.sweep
@pytest.mark.parametrize("name", BY_HAND)
def test_keys_reckoned_by_hand(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    text = (PROBLEMS / f"{name}.yaml").read_text(encoding="utf-8")
    Path("problem.yaml").write_text(text.replace("\nvariants:\n", "\nvariants:\n  sample: 3\n"), encoding="utf-8")
    Path("roster.csv").write_text("id\ns1\ns2\n", encoding="utf-8")
    Path("salt").write_text("a salt of its own", encoding="utf-8")
    code = run(["homework", "problem.yaml", "-o", "out", "--students", "roster.csv", "--salt-file", "salt"])
    assert code == 0
    with open(os.path.join("out", "instructor", "keys.csv"), encoding="utf-8") as table:
        keys = list(csv.DictReader(table))
    for student in ("s1", "s2"):
        page = Path("out", "student", f"{student}.html").read_text(encoding="utf-8")
        given = given_on(page)
        answers = BY_HAND[name](**given)
        own = {row["quantity"]: row for row in keys if row["id"] == student}
        assert set(answers) == set(own)
        for quantity, answer in answers.items():
            figures = int(own[quantity]["figures"])
            assert float(f"{answer:.{figures}g}") == float(own[quantity]["key"]), (quantity, answer, given)
