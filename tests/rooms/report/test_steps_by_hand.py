"""Five worked solutions of the problems followed by hand: their formulas as they are printed, with plain numbers, by
arithmetic of this file alone, each step from the ones before it."""

import cmath
import math
from pathlib import Path

import pytest
from support.scenes import kept_settled_of

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

G = 9.81


@pytest.fixture
def lines(request):
    found, = Path("problems").glob(f"*/{request.param}.yaml")
    return {line.settles: line for line in worked(kept_settled_of(found))}


def text(line):
    return formula(line.parts, plain).replace("\u00a0", " ").replace("−", "-")


def value(line, sign="= "):
    """The last number that a line prints."""
    return float(text(line).rpartition(sign)[2].split()[0])


def evaluated(node, **values):
    return evaluate([node], Floats, values)[0]


def printed(lines, key, found, digits=6):
    """Does a line print this number, to its digits?"""
    assert f"{found:.{digits}g}" in text(lines[key]), (key, found, text(lines[key]))


@pytest.mark.parametrize("lines", ["cage_loses_half_its_load"], indirect=True)
def test_a_hoist_that_loses_half_its_load(lines):
    """J + m₁R² + m₂r², the tension at rest, δ, ζ, ω_d, and the constants of the motion."""
    J, m1, m2, R, r, kt, c = 1.1, 24, 40, 0.32, 0.2, 340, 95
    inertia = J + m1 * R**2 + m2 * r**2
    assert lines["N_s"].value == pytest.approx(-G * (m2 * r - m1 * R))
    omega = math.sqrt(kt / inertia)
    printed(lines, "omega[1]", omega)
    printed(lines, "frequency[1]", omega / (2 * math.pi))
    printed(lines, "frequency[1]", 2 * math.pi / omega)
    delta = r**2 * c / (2 * inertia)
    printed(lines, "delta", delta)
    printed(lines, "zeta[1]", delta / omega)
    damped = math.sqrt(omega**2 - delta**2)
    printed(lines, "omega_d[1]", damped)
    start = value(lines["free motion"], "A = φ₀ = ")
    printed(lines, "free motion", delta * start / damped, 4)


@pytest.mark.parametrize("lines", ["quarter_car_damped"], indirect=True)
def test_a_quarter_of_a_car(lines):
    """a₂, a₁, a₀ from K and M, their roots, the ratios, and whether each root of the damped system fulfils its
    determinant."""
    mu, ms, kt, ks, c = 40, 300, 180e3, 20e3, lines_c(lines)
    M, K, C = [[mu, 0], [0, ms]], [[kt + ks, -ks], [-ks, ks]], [[c, -c], [-c, c]]
    a2, a1, a0 = mu * ms, mu * ks + ms * (kt + ks), kt * ks
    for name, found in (("a2", a2), ("a1", a1), ("a0", a0)):
        assert lines[name].value == pytest.approx(found)
    for k, sign in ((1, -1), (2, 1)):
        omega = math.sqrt((a1 + sign * math.sqrt(a1**2 - 4 * a2 * a0)) / (2 * a2))
        printed(lines, f"omega[{k}]", omega)
        printed(lines, f"mode[{k}][x2]", (kt + ks - mu * omega**2) / ks)
        root, = [complex(*map(float, text(lines[f"eigenvalue[{k}]"]).replace("λ = ", "").split("·i")[0].replace(
            " ", "").replace("±", " ").split()))]
        D = [[root**2 * M[i][j] + root * C[i][j] + K[i][j] for j in range(2)] for i in range(2)]
        assert abs(D[0][0] * D[1][1] - D[0][1] * D[1][0]) < 1e-4 * abs(D[0][0] * D[1][1])
        assert lines[f"decay[{k}]"].value == pytest.approx(-root.real, rel=1e-5)
        assert lines[f"omega_d[{k}]"].value == pytest.approx(root.imag, rel=1e-5)
    for name, found in (("c4", a2), ("c3", c * (mu + ms)), ("c2", a1), ("c1", c * kt), ("c0", a0)):
        assert lines[name].value == pytest.approx(found)
    assert c * (mu + ms) * ks != c * (mu * ks + ms * kt + ms * ks) and "not proportional" in text(lines["proportional"])


def lines_c(lines):
    """The damper, from the sum of the roots: tr M⁻¹C = 2 (δ₁ + δ₂)."""
    total = -2 * sum(value(lines[f"eigenvalue[{k}]"], "λ = ") for k in (1, 2))
    return total / (1 / 40 + 1 / 300)


@pytest.mark.parametrize("lines", ["compressor_to_be_isolated"], indirect=True)
def test_a_compressor_that_is_isolated(lines):
    """The complex equation, solved; with the chosen k a tenth of the force reaches the ground."""
    m, c, F0, Omega = 180, 240, 900, 75
    k = lines["k"].value
    phasor = F0 / (4 * k - m * Omega**2 + 4j * c * Omega)
    printed(lines, "amplitude(y)", abs(phasor))
    printed(lines, "tan theta", math.tan(-cmath.phase(phasor)), 5)
    assert abs((4 * k + 4j * c * Omega) * phasor) / F0 == pytest.approx(0.1, rel=1e-9)
    printed(lines, "omega[1]", 2 * math.sqrt(k / m), 4)


@pytest.mark.parametrize("lines", ["hoist_with_moving_pulley"], indirect=True)
def test_a_hoist_with_a_moving_pulley(lines):
    """T of each body by its speed, the place of rest and the tension, the frequency."""
    m1, m2, m3, m4, k = 4, 6, 10, 20, 900
    assert lines["equilibrium[y]"].value == pytest.approx(-G * (m1 - 2 * m3 + m4) / (4 * k))
    assert lines["N_tie"].value == pytest.approx((m1 * G + m4 * G - 2 * m3 * G) / 2)
    T = 3 * m1 / 4 + m4 / 2 + m2 + 2 * m3           # of ẏ = 1
    omega = math.sqrt(4 * k / (2 * T))
    printed(lines, "omega[1]", omega)
    printed(lines, "frequency[1]", 2 * math.pi / omega)


@pytest.mark.parametrize("lines", ["cantilever_with_tip_mass"], indirect=True)
def test_a_cantilever_with_a_mass(lines):
    """Each root makes the determinant of the two conditions at the right end vanish; ω = (βL)² √(EI/μ)/L²."""
    L, EI, mu, M = 0.8, 240, 1.2, 0.48
    for k in (1, 2, 3):
        x = lines[f"βL[{k}]"].value
        b = x / L
        f3, g3 = EI * b**3 * (math.sinh(x) - math.sin(x)), EI * b**3 * (math.cosh(x) + math.cos(x))
        square = EI * b**4 / mu
        row = (f3 + M * square * (math.cosh(x) - math.cos(x)), g3 + M * square * (math.sinh(x) - math.sin(x)))
        moment = math.cosh(x) + math.cos(x), math.sinh(x) + math.sin(x)
        assert abs(row[0] * moment[1] - row[1] * moment[0]) < 1e-9 * abs(row[0] * moment[1])
        assert math.cosh(x) * math.cos(x) + 1 == pytest.approx(
            -M * x * (math.sinh(x) * math.cos(x) - math.sin(x) * math.cosh(x)) / (L * mu), rel=1e-9)
        printed(lines, f"omega[{k}]", x**2 * math.sqrt(EI / mu) / L**2)


@pytest.mark.parametrize("lines", ["accelerometer_on_a_casing"], indirect=True)
def test_what_a_sheet_asks_is_told_last(lines):
    """The stretch of the spring, Z = Y r²/√((1 − r²)² + (2ζr)²)."""
    m, k, c, Y, Omega = 0.012, 7600, 11, 0.2e-3, 500
    r, zeta = Omega / math.sqrt(k / m), c / (2 * math.sqrt(k * m))
    found = Y * r**2 / math.sqrt((1 - r**2)**2 + (2 * zeta * r)**2)
    assert value(lines["amplitude(s.stretch)"]) == pytest.approx(found, rel=1e-5)
    assert evaluated(lines["amplitude(s.stretch)"].node, m=m, k=k, c=c, Y=Y, Omega=Omega) == pytest.approx(found)
