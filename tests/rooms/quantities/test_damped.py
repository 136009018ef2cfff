"""Eigenvalues, damped periods and complex shapes against the eigenvalue problem of (λ² M + λ C + K) φ = 0 by mpmath."""

from textwrap import dedent

import mpmath
import numpy as np
import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

NAMES = "xyz"


def scene_of(M, C, K):
    def rows(A):
        return "[" + ", ".join("[" + ", ".join(map(repr, map(float, row))) + "]" for row in A) + "]"

    return problem(f"coordinates: [{', '.join(NAMES[:len(M)])}]\n"
                   f"matrices: {{M: {rows(M)}, C: {rows(C)}, K: {rows(K)}}}\n")


def symmetric(random, n, size):
    A = random.normal(size=(n, n)) * size
    return A @ A.T + 0.1 * size**2 * np.eye(n)


def by_mpmath(M, C, K):
    """[(λ, shape with the first amplitude 1)] with Im λ ≥ 0, by ascending |λ|."""
    n = len(M)
    with mpmath.workdps(40):
        M, C, K = (mpmath.matrix([[mpmath.mpf(repr(float(x))) for x in row] for row in A]) for A in (M, C, K))
        A = mpmath.zeros(2 * n)
        for i in range(n):
            A[i, n + i] = 1
        for block, at in ((M**-1 * K, 0), (M**-1 * C, n)):
            for i in range(n):
                for j in range(n):
                    A[n + i, at + j] = -block[i, j]
        values, vectors = mpmath.eig(A)
        kept = sorted((abs(z), i) for i, z in enumerate(values) if mpmath.im(z) > -1e-25 * abs(z))
        return [(complex(values[i]), [complex(vectors[j, i] / vectors[0, i]) for j in range(n)]) for _, i in kept]


@pytest.mark.parametrize("seed", range(12))
def test_they_are_those_of_random_matrices(seed):
    random = np.random.default_rng(seed)
    n = 2 + seed % 2
    M, K = symmetric(random, n, 1.0), symmetric(random, n, 20.0)
    C = symmetric(random, n, (0.5, 1.0, 3.0, 8.0)[seed % 4])
    scene, found = scene_of(M, C, K), by_mpmath(M, C, K)
    assert [mode.index for mode in scene.modal.damped] == list(range(1, len(found) + 1))
    for i, (eigenvalue, shape) in enumerate(found, 1):
        assert abs(value(scene, f"eigenvalue[{i}]") - eigenvalue) <= 1e-12 * abs(eigenvalue)
        assert value(scene, f"eigenvalue[{i},1]") == value(scene, f"eigenvalue[{i}]")
        for name, amplitude in zip(NAMES, shape, strict=False):
            for part, wanted in (("re", amplitude.real), ("im", amplitude.imag), ("abs", abs(amplitude))):
                if part == "abs":
                    found_part, error = map(abs, measure(scene, parse(f"mode_d[{i},{name}]")))
                else:
                    found_part, error = measure(scene, parse(f"{part}(mode_d[{i},{name}])"))
                assert abs(found_part - wanted) <= error * abs(found_part) + 1e-15, (i, name, part)
        if abs(eigenvalue.imag) > 1e-12:
            assert value(scene, f"period_d[{i}]") == pytest.approx(2 * np.pi / eigenvalue.imag, rel=1e-12)
        else:
            with pytest.raises(PhysicsError, match="does not oscillate"):
                value(scene, f"period_d[{i}]")


@pytest.mark.parametrize("gap", [2**-10, 2**-20, 2**-30, 2**-40])
def test_shapes_of_close_eigenvalues(gap):
    """Two equal oscillators, but for a part `gap` of stiffness and damping, and as weakly coupled with each other."""
    K = np.diag([128.0, 128.0 * (1 + gap), 320.0]) + gap * np.array([[8, -8, 0], [-8, 8, -1], [0, -1, 1]])
    C = np.diag([1.0, 1.0 + gap, 2.0]) + gap * np.array([[2, -2, 0], [-2, 2, 0], [0, 0, 0]])
    scene = scene_of(np.eye(3), C, K)
    for i, (_, shape) in enumerate(by_mpmath(np.eye(3), C, K), 1):
        found = [measure(scene, parse(f"mode_d[{i},{name}]")) for name in NAMES]
        pivot = next(k for k, (amplitude, _) in enumerate(found) if abs(amplitude - 1) < 1e-14)
        for (amplitude, error), wanted in zip(found, shape, strict=True):
            assert abs(amplitude - wanted / shape[pivot]) <= error * abs(amplitude), (i, gap)


def test_shapes_of_equal_eigenvalues_are_refused():
    scene = scene_of(np.eye(2), np.eye(2), 9 * np.eye(2))
    with pytest.raises(PhysicsError, match="coincides with another one"):
        value(scene, "mode_d[1,x]")


def test_two_real_eigenvalues_of_one_mode():
    """λ² + 50 λ + 400 = 0 beside a mode that oscillates, in one scene; critical damping has two that are equal."""
    scene = scene_of(np.eye(2), np.diag([50.0, 0.2]), np.diag([400.0, 9.0]))
    assert value(scene, "eigenvalue[2,1]") == pytest.approx(-10, rel=1e-14)
    assert value(scene, "eigenvalue[2,2]") == pytest.approx(-40, rel=1e-14)
    assert value(scene, "eigenvalue[2]") == value(scene, "eigenvalue[2,1]")
    for text in ("eigenvalue[1,2]", "eigenvalue[3,1]"):
        with pytest.raises(PhysicsError):
            value(scene, text)
    critical = scene_of(np.eye(1), [[20.0]], [[100.0]])
    assert value(critical, "eigenvalue[1,1]") == value(critical, "eigenvalue[1,2]") == pytest.approx(-10, rel=1e-14)


def test_in_letters():
    """Of one degree of freedom; the instances that oscillate have no such eigenvalues and are passed over."""
    from vibcli.check.verdicts import check

    scene = problem(dedent("""
        parameters: {m: {unit: kg}, k: {unit: N/m}, c: {unit: N*s/m}}
        bodies: {b: {slide: x, mass: m}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {c: c, between: [ground, b]}}
        answers:
          eigenvalue[1,1]: -c/(2*m) + sqrt((c/(2*m))^2 - k/m)
          eigenvalue[1,2]: -c/(2*m) - sqrt((c/(2*m))^2 - k/m)
          period_d[1]: 2*pi/sqrt(k/m - (c/(2*m))^2)
          mass[b]: m
    """))
    assert [verdict.agrees for verdict in check(scene)] == [True] * 4


def test_the_shape_of_a_signal_is_that_of_its_displacement():
    """A point halfway between two masses moves by the mean of their amplitudes, their distance by the difference."""
    scene = problem(dedent("""
        parameters: {m: 2 kg, k: 50 N/m, c: 3 N*s/m, a: 1 m}
        bodies: {p: {mass: m, at: [0, 0], slide: x}, q: {mass: m, at: [a, 0], slide: y}}
        springs: {s: {k: k, between: [[-a, 0], p]}, t: {k: k, between: [p, q]}}
        dampers: {d: {c: c, between: [[2*a, 0], q]}}
    """))
    x, y = (value(scene, f"mode_d[1,{name}]") for name in "xy")
    assert x == 1 and abs(value(scene, "mode_d[1,t.stretch]") - (y - x)) < 1e-12


def test_the_mass_of_a_body_of_parts():
    scene = problem(dedent("""
        parameters: {R: 0.2 m, a: 0.05 m, b: 0.3 m, h: 0.1 m, rho: 40 kg/m^2, m: 2 kg}
        bodies:
          plate:
            pin: {at: [0, 0], by: phi}
            parts:
              - {shape: disc, at: [0, -R], radius: R, density: rho}
              - {shape: rectangle, at: [0, -2*R], width: b, height: h, density: 2*rho}
              - {shape: disc, at: [0, -R], radius: a, density: rho, cut: true}
              - {at: [0, R], mass: m}
          cart: {mass: m, slide: x}
    """))
    wanted = 40 * (np.pi * (0.2**2 - 0.05**2) + 2 * 0.3 * 0.1) + 2
    assert value(scene, "mass[plate]") == pytest.approx(wanted, rel=1e-13)
    assert value(scene, "mass[cart]") == 2
