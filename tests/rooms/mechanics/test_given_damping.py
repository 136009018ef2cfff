"""Damping of a whole scene, by ratios of its modes or in proportion: random rows of masses against NumPy, many digits
and the exponential of their matrices."""

import random
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from scipy.linalg import expm
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.program import run
from vibcli.symbolic.syntax import NameRef

SEEDS = range(8)


class Row:
    """Masses in a row from the ground, or free; M, K in floats."""

    def __init__(self, seed, free=False):
        dice = random.Random(seed)
        self.n = dice.randint(1, 5)
        self.m = [round(10 ** dice.uniform(-1, 2), 3) for _ in range(self.n)]
        self.k = [round(10 ** dice.uniform(1, 5), 2) for _ in range(self.n)]
        if free:
            self.k[0] = 0.0
        self.ratios = [round(dice.uniform(0, 0.3), 3) for _ in range(dice.randint(1, self.n))]
        self.M, self.K = np.diag(self.m), np.zeros((self.n, self.n))
        for i, k in enumerate(self.k):
            row = np.eye(self.n)[i] - (np.eye(self.n)[i - 1] if i else 0)
            self.K += k * np.outer(row, row)

    def modes(self):
        """(ω, Φ) with ΦᵀMΦ = 1."""
        root = np.sqrt(self.m)
        squares, vectors = np.linalg.eigh(self.K / np.outer(root, root))
        return np.sqrt(np.maximum(squares, 0)), vectors / root[:, None]

    def zeta(self):
        return np.array([*self.ratios, *[self.ratios[-1]] * self.n][:self.n])

    def damping(self, rates):
        """M Φ diag(rates) Φᵀ M."""
        rows = self.M @ self.modes()[1]
        return rows @ np.diag(rates) @ rows.T

    def text(self, damping, more=""):
        names = ["ground", *(f"b{i}" for i in range(self.n))]
        lines = ["bodies:", *(f"  b{i}: {{mass: {m} kg, slide: x{i}}}" for i, m in enumerate(self.m))]
        ties = [f"  s{i}: {{k: {k} N/m, between: [{names[i]}, {names[i + 1]}]}}" for i, k in enumerate(self.k) if k]
        lines += ["springs:", *ties] if ties else []
        return "\n".join([*lines, f"damping: {{{damping}}}", more, ""])


def matrix(scene, n):
    return np.array([[value(scene, f"C[x{i},x{j}]") for j in range(n)] for i in range(n)])


@pytest.mark.parametrize("seed", SEEDS)
def test_ratios_are_those_that_are_given(seed):
    row = Row(seed)
    scene = problem(row.text(f"modal: {row.ratios}"))
    omega, _ = row.modes()
    C = row.damping(2 * row.zeta() * omega)
    assert matrix(scene, row.n) == pytest.approx(C, rel=1e-9, abs=1e-11 * np.abs(C).max())
    for i, zeta in enumerate(row.zeta(), 1):
        assert value(scene, f"omega[{i}]") == pytest.approx(omega[i - 1], rel=1e-9)
        assert value(scene, f"zeta[{i}]") == pytest.approx(zeta, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("seed", SEEDS)
def test_motions_are_those_of_the_matrices(seed):
    row = Row(seed)
    omega, _ = row.modes()
    C = row.damping(2 * row.zeta() * omega)
    t = round(3 / omega[0], 6)
    scene = problem(row.text(f"modal: {row.ratios}", f"initial: {{x{row.n - 1}: 1 cm}}\nmotion: small"))
    A = np.block([[np.zeros((row.n, row.n)), np.eye(row.n)],
                  [-np.linalg.solve(row.M, row.K), -np.linalg.solve(row.M, C)]])
    start = np.zeros(2 * row.n)
    start[row.n - 1] = 0.01
    exact = (expm(A * t) @ start)[:row.n]
    found = [value(scene, f"x{i}({t} s)") for i in range(row.n)]
    assert found == pytest.approx(exact, rel=1e-8, abs=1e-10 * 0.01)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_series_through_two_modes_is_proportional(seed):
    row = Row(seed, free=seed % 2)
    omega, _ = row.modes()
    first = 2 if seed % 2 else 1
    if row.n < first + 1:
        return
    slow, fast = omega[first - 1], omega[first]
    second = float(0.019 + 0.001 * fast / slow)
    alpha, beta = np.linalg.solve([[0.5 / slow, 0.5 * slow], [0.5 / fast, 0.5 * fast]], [0.02, second]).tolist()
    C = matrix(problem(row.text(f"proportional: [{alpha!r} s^-1, {beta!r} s]")), row.n)
    np.testing.assert_allclose(C, alpha * row.M + beta * row.K, rtol=1e-12)
    two = problem(row.text(f"caughey: {{{first}: 0.02, {first + 1}: {second!r}}}"))
    assert matrix(two, row.n) == pytest.approx(C, rel=1e-8, abs=1e-9 * np.abs(C).max())


def test_a_series_through_all_modes_has_their_ratios():
    row = Row(3)
    ratios = dict(enumerate((0.02 for _ in range(row.n)), 1))
    one, two = (problem(row.text(text)) for text in (f"caughey: {ratios}", "modal: 2 %"))
    assert matrix(one, row.n) == pytest.approx(matrix(two, row.n), rel=1e-9)


def test_of_a_series_of_three_terms_no_rounding_is_told_where_it_has_no_entries():
    """C = M Σ aₖ (M⁻¹K)ᵏ, k ≤ 2, of a row joins no masses farther apart than two."""
    row = next(row for row in map(Row, range(20)) if row.n == 5)
    row.m, row.k = [2.0, 2.6, 3.2, 3.8, 4.4], [1600.0, 2400.0, 800.0, 1600.0, 2400.0]
    C = problem(row.text("caughey: {1: 1 %, 3: 1 %, 5: 1 %}")).configuration.told_matrices[1]
    assert {pair for pair, x in C.items() if x} == {(i, j) for i in range(5) for j in range(5) if abs(i - j) <= 2}


def test_dampers_add():
    row = Row(5)
    plain, more = (problem(row.text("modal: 4 %", extra)) for extra in (
        "", "dampers: {d: {c: 7 N*s/m, between: [ground, b0]}}"))
    added = matrix(more, row.n) - matrix(plain, row.n)
    assert added == pytest.approx(np.diag([7.0, *[0.0] * (row.n - 1)]), abs=1e-9)


def test_supports_that_are_driven_are_followed():
    """Of one mass on a shaken spring: m z̈ + 2ζωm ż + k z = −m ü of z relative to the support; in many digits too."""
    scene = problem("""
points: {W: {at: [0, 0], moves: [0.02 m*sin(3 rad/s*t), 0]}}
bodies: {a: {mass: 2 kg, at: [1 m, 0], slide: x}}
springs: {s: {k: 100 N/m, between: [W, a]}}
damping: {modal: 10 %}
initial: {x: 0}
motion: small
""")
    with mpmath.workdps(40):
        w, zeta, W, A, t = mpmath.sqrt(50), mpmath.mpf("0.1"), mpmath.mpf(3), mpmath.mpf("0.02"), mpmath.mpf("0.7")
        steady = A * W**2 / (w**2 - W**2 + 2j * zeta * w * W)
        wd = w * mpmath.sqrt(1 - zeta**2)
        start, rate = -steady.imag, -A * W - (1j * W * steady).imag
        swing = start * mpmath.cos(wd * t) + (rate + zeta * w * start) / wd * mpmath.sin(wd * t)
        free = mpmath.exp(-zeta * w * t) * swing
        exact = free + (steady * mpmath.expj(W * t)).imag + A * mpmath.sin(W * t)
    assert value(scene, "x(0.7 s)") == pytest.approx(float(exact), rel=1e-12)
    precise = scene.with_digits(30).response.signal(NameRef(0, 0, "x", 0)).precise(Fraction("0.7"), 30)
    assert abs(precise - exact) <= abs(exact) * mpmath.mpf(10) ** -29
    assert value(scene, "amplitude(x - W.x)") == pytest.approx(float(abs(steady)), rel=1e-12)


SAME = """bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 2 kg, slide: y}}
springs: {s: {k: 200 N/m, between: [ground, a]}, t: {k: 200 N/m, between: [ground, b]}}
"""


@pytest.mark.parametrize(("text", "told"), [
    (SAME + "damping: {modal: [2 %, 3 %]}", "one frequency"),
    (SAME + "damping: {caughey: {1: 2 %, 2: 2 %}}", "one frequency"),
    (SAME + "damping: {caughey: {3: 2 %}}", "the last mode has the number 2"),
    ("bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}\nsprings: {s: {k: 1 N/m, between: [a, b]}}\n"
     "damping: {caughey: {1: 2 %}}", "does not vibrate"),
    ("bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}, c: {mass: 1 kg, slide: z}}\nsprings:\n"
     "  s: {k: 1 N/m, between: [ground, a]}\n  t: {k: 1 N/m, between: [a, b]}\n  u: {k: 1 N/m, between: [b, c]}\n"
     "damping: {caughey: {1: 9 %, 2: 0.1 %}}", "drives mode 3"),
    ("coordinates: [x, y]\nmatrices: {M: [[2 kg, 0], [0, 2 kg]], C: [[0, -1 N*s/m], [1 N*s/m, 0]],\n"
     "  K: [[9 N/m, 0], [0, 9 N/m]]}\n"
     "damping: {modal: 2 %}", "gyroscopic")])
def test_what_has_no_such_damping_is_refused(text, told):
    with pytest.raises((PhysicsError, SpecError), match=told):
        value(problem(text + "\n"), "zeta[1]")


def test_rigid_modes_are_not_damped_by_ratios():
    row = Row(2, free=True)
    scene = problem(row.text("modal: 5 %"))
    assert matrix(scene, row.n) @ np.ones(row.n) == pytest.approx(np.zeros(row.n), abs=1e-9)


def test_what_neither_inertia_nor_a_spring_holds_has_no_mode_to_be_damped():
    loose = problem("bodies: {a: {mass: 0 kg, slide: x}, b: {mass: 1 kg, slide: y}}\n"
                    "springs: {s: {k: 4 N/m, between: [ground, b]}}\ndamping: {modal: 0.1}\n")
    with pytest.raises(PhysicsError, match="needs inertia or a spring along every coordinate"):
        _ = loose.modal.damped


def test_what_has_no_inertia_has_no_mode_to_be_damped(capsys, tmp_path):
    """All is as without damping."""
    path, scene = tmp_path / "light.yaml", "springs: {s: {k: 4 N/m, between: [ground, a]}}\nbodies: {a: {mass: 0 kg, " \
                                           "slide: x}}\n"
    for command in (["frequencies"], ["frequencies", "--json"], ["response"], ["frf"]):
        codes = []
        for more in ("", "damping: {modal: 0.1}\n", "damping: {caughey: {1: 1 %}}\n"):
            path.write_text(scene + more)
            codes.append(run([*command, str(path)]))
        assert len(set(codes)) == 1 and codes[0] in (0, 4), (command, codes)


def test_a_series_of_two_terms_has_no_entries_but_those_of_mass_and_stiffness():
    """C = α M + β K: what does not touch is not coupled, and neither is it by rounding."""
    row = Row(0)
    assert row.n > 3
    scene = problem(row.text("caughey: {1: 2 %, 3: 2 %}"))
    C = matrix(scene, row.n)
    assert not C[row.K == 0].any()
    rates = row.modes()[0]
    beta = 0.04 / (rates[0] + rates[2])
    assert np.allclose(C, beta * rates[0] * rates[2] * row.M + beta * row.K, rtol=1e-12)
