"""Zeros of damped and of gyroscopic responses of members against those of finite elements of high degree."""

import numpy as np
import pytest
from numpy.polynomial import Legendre
from support.scenes import problem

BARS = ((0.4, 9000.0, 0.7), (0.6, 2500.0, 1.6), (0.5, 3200.0, 1.1))     # length, EA, mass per length
MASSES, SPRINGS, HIGH = (1.3, 0.6, 1.9), (700.0, 150.0, 2200.0), 450.0
PAIRS = (0, 1), (1, 2), (0, 2)
DEGREE = 14


def scene(dampers, turning):
    lines = ["bodies:", *(f"  {name}b: {{mass: {m} kg, slide: {name}}}" for name, m in zip("xyz", MASSES, strict=True))]
    lines += ["bars:", *(f"  r{name}: {{length: {L} m, EA: {EA} N, mass_per_length: {mu} kg/m, left: clamped, right: "
                         f"{{pinned: {name}b}}}}" for name, (L, EA, mu) in zip("xyz", BARS, strict=True))]
    between = [f"{'xyz'[i]}b, {'xyz'[j]}b" for i, j in PAIRS]
    lines += ["springs:", *(f"  s{k}: {{k: {x} N/m, between: [{between[k]}]}}" for k, x in enumerate(SPRINGS))]
    lines += ["dampers:", *(f"  d{k}: {{c: {x} N*s/m, between: [{between[k]}]}}" for k, x in enumerate(dampers) if x),
              ] if any(dampers) else []
    h = f"{turning} N*s/m"
    lines += [f"matrices: {{C: [[0, -{h}, 0], [{h}, 0, -{h}], [0, {h}, 0]]}}"] if turning else []
    return "\n".join([*lines, "forces: {drive: {at: xb, force: 1 N*sin(3 rad/s*t)}}"])


def elements(dampers, turning):
    """M, C, K: of each bar its free end and inner functions of Legendre's."""
    size = DEGREE + 1
    at, weights = np.polynomial.legendre.leggauss(DEGREE + 4)
    shapes = [Legendre([0.5, 0.5])] + [Legendre.basis(k + 2) - Legendre.basis(k) for k in range(DEGREE)]
    u, slope = (np.array([f.deriv(k)(at) if k else f(at) for f in shapes]) for k in range(2))
    M, C, K = np.zeros((3, 3 * size, 3 * size))
    for i, ((L, EA, mu), m) in enumerate(zip(BARS, MASSES, strict=True)):
        own = slice(i * size, (i + 1) * size)
        M[own, own] = mu * L / 2 * (u * weights) @ u.T
        K[own, own] = EA * 2 / L * (slope * weights) @ slope.T
        M[i * size, i * size] += m
    for part, sizes in ((K, SPRINGS), (C, dampers)):
        for x, (i, j) in zip(sizes, PAIRS, strict=True):
            at = np.ix_([i * size, j * size], [i * size, j * size])
            part[at] += x * np.array([[1, -1], [-1, 1]])
    for i, j in ((0, 1), (1, 2)):
        C[i * size, j * size] -= turning
        C[j * size, i * size] += turning
    return M, C, K


def zeros_of_elements(place, dampers, turning):
    """det [D b; cᵀ 0] = 0."""
    M, C, K = elements(dampers, turning)
    n, scale = len(M), HIGH / 2
    units = np.append(1 / np.sqrt(np.diag(K)), 1.0)
    bordered = np.zeros((3, n + 1, n + 1))
    bordered[:, :n, :n] = K, C * scale, M * scale**2
    bordered *= units[:, None] * units
    bordered[0, 0, n], bordered[0, n, place * (DEGREE + 1)] = 1.0, 1.0
    inverse = np.linalg.solve(bordered.sum(axis=0), np.hstack([bordered[1] + 2 * bordered[2], bordered[2]]))
    found = np.linalg.eigvals(np.vstack([-inverse, np.eye(n + 1, 2 * n + 2)]))
    found = scale * (1 + 1 / found[abs(found) > 1e-8])
    return found[(found.imag > 1) & (found.imag < HIGH)]


@pytest.mark.sweep
@pytest.mark.parametrize(("dampers", "turning"), [
    ((0.0, 0.0, 0.0), 30.0), ((0.3, 9.0, 0.0), 0.0), ((40.0, 2.0, 0.0), 30.0)], ids=["gyroscopic", "damped", "both"])
def test_none_is_missing_beside_the_axis(dampers, turning):
    """Of what is driven and of what is seen elsewhere, next to the axis as far as poles are apart."""
    solved = problem(scene(dampers, turning))
    for place, name in enumerate("xyz"):
        response = solved.frequency_response(name, "drive").transfer
        found, known = response.zeros(0.0, HIGH), zeros_of_elements(place, dampers, turning)
        beside = known[abs(known.real) < 0.5 * HIGH / (len(response.natural()) + 6)]
        assert response.counts("zeros") and len(found)
        assert all(abs(found - s).min() < 1e-7 * abs(s) for s in beside)
        assert all(abs(known - s).min() < 1e-7 * abs(s) for s in found)


RATED = """\
    parameters: {L: 1 m, EI: 20 N*m^2, mu: 1 kg/m, F: 1 N}
    beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, attached: [{at: L/2, c: 2 N*s/m}]}}
    points: {p: {body: arm, at: L}}
    forces: {f: {at: p, force: F}}
    damping: {%s}
    """


@pytest.mark.sweep
def test_poles_beside_ratios_and_dampers_are_counted():
    """As damped modes where these are told, and else by det(1 + s C H₀)."""
    told = problem(RATED % "modal: [1 %, 2 %]").frequency_response("arm.u(L)", "f").transfer
    poles = told.poles(0.0, HIGH)
    counted = told._counted_up_to(HIGH)
    assert told.counts("poles") and len(poles) == 3
    near = counted.poles[abs(counted.poles.real) < counted.width]
    assert near == pytest.approx(poles, rel=1e-9)
    creeping = problem(RATED % "caughey: {1: 1 %, 2: 2 %, 3: 8 %}").frequency_response("arm.u(L)", "f")
    assert len(creeping.peaks) == 3 and len(creeping.antiresonances) == 2
    assert creeping.transfer.counts("poles") and not creeping.transfer.counts("zeros")
