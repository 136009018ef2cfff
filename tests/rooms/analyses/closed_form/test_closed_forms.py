"""Closed forms: as textbooks print them, and against the route in numbers at values of their own."""

import random
from fractions import Fraction

import numpy as np
import pytest
from support.closed_forms import TEXTBOOK, chain, pendulums, ring
from support.scenes import number, problem
from support.trees import new_table, symbol
from sympy import QQ
from sympy.polys.rings import PolyRing

from vibcli.analyses.closed_form.algebraic_extension import Extension, unless_long
from vibcli.analyses.closed_form.toeplitz_chains import cosines
from vibcli.base.errors import PhysicsError
from vibcli.check.instances import Instances
from vibcli.check.verdicts import check
from vibcli.report.document import Report
from vibcli.report.formats.text import section_lines, shown
from vibcli.report.sections.spectrum_data import frequencies_data
from vibcli.symbolic.normal_form import TooLong
from vibcli.symbolic.parser import parse
from vibcli.symbolic.rational_functions import Quotients
from vibcli.symbolic.syntax import Sum


def printed(found):
    """The lines of the report, without their indent."""
    report = Report(found)
    for section in ("equilibrium", "equations", "frequencies", "modes"):
        report.add(section)
    return [line.strip() for line in shown(section_lines(report.sections)).splitlines()]


@pytest.mark.parametrize("name", [name for name, (_, answers, _) in TEXTBOOK.items() if answers])
def test_the_hand_formulas_hold_in_numbers(name):
    scene, answers, _ = TEXTBOOK[name]
    text = scene + "answers:\n" + "".join(f"  '{quantity}': {formula}\n" for quantity, formula in answers.items())
    verdicts = check(problem(text))
    assert len(verdicts) == len(answers)
    assert all(verdict.agrees for verdict in verdicts)


def forms_in_numbers(data, values):
    """[(ω or growth rate, shape, ζ)] of what is printed with --json, read back from its text."""
    damped = {mode["index"]: mode["zeta"] for mode in data["damped"] or ()}
    found = []
    for mode in data["modes"]:
        omega = mode["omega"] or mode["growth_rate"]
        shape = [amplitude and evaluated(amplitude, values) for amplitude in mode["shape"].values()]
        zeta = damped.get(mode["index"])
        found.append((evaluated(omega, values), shape, zeta and evaluated(zeta, values), mode["growth_rate"] is None))
    return found


def evaluated(text, values):
    return number(parse(text), values)


def agrees(data, draw):
    """Do the forms in letters give the modes of a numeric problem?"""
    M, _, _, K = draw.configuration.linear_system.matrices()
    n = len(draw.scene.q)
    M, K = (np.array([[A.get((i, j), 0.0) for j in range(n)] for i in range(n)]) for A in (M, K))
    forms = forms_in_numbers(data, draw.numeric.floats)
    wanted = sorted((mode.omega or mode.growth_rate or 0.0) * (-1 if mode.omega is None else 1)
                    for mode in draw.modal.modes)
    ours = sorted(omega if stable else -omega for omega, _, _, stable in forms)
    if not data.get("characteristic_polynomial") and ours != pytest.approx(wanted, rel=1e-9, abs=1e-7):
        return False
    for omega, shape, zeta, stable in forms:
        if not any(abs((omega if stable else -omega) - w) <= 1e-9 * abs(w) + 1e-7 for w in wanted):
            return False
        x, square = np.array(shape, dtype=float), omega * omega if stable else -omega * omega
        if None not in shape and not np.allclose(K @ x, square * (M @ x), rtol=1e-7, atol=1e-9 * abs(K).max()):
            return False
        if zeta and zeta < 1 and not any(abs((mode.zeta or 0.0) - zeta) <= 1e-7 * zeta for mode in draw.modal.damped):
            return False
    return True


class Forms:
    """The forms of a scene as they are printed with --json."""

    def __init__(self, text):
        self.problem = problem(text)
        self.data = frequencies_data(self.problem)

    def draws(self, wanted=3):
        """Numeric problems at random values other than those that the forms were checked with."""
        found = []
        for draw in Instances(self.problem):
            try:
                if not self.same_regime(draw):
                    continue
            except PhysicsError:
                continue
            found.append(draw)
            if len(found) == wanted:
                return found
        return found

    def same_regime(self, draw):
        growing = sum(mode["growth_rate"] is not None for mode in self.data["modes"])
        if sum(mode.growth_rate is not None for mode in draw.modal.modes) != growing:
            return False
        places = self.data["equilibrium"]["coordinates"]
        found = draw.configuration.equilibrium.values
        return all(evaluated(text, draw.numeric.floats) == pytest.approx(found[name], abs=1e-9)
                   for name, text in places.items())


@pytest.mark.sweep
@pytest.mark.parametrize("name", TEXTBOOK)
def test_printed_as_in_a_textbook_and_true_at_other_values(name):
    scene, _, lines = TEXTBOOK[name]
    found = Forms(scene)
    assert set(lines) - set(printed(found.problem)) == set()
    draws = found.draws()
    assert len(draws) >= 2
    assert all(agrees(found.data, draw) for draw in draws)


FAMILIES = {
    **{f"{n} masses {kind}": chain(n, *ends) for n in range(2, 7)
       for kind, ends in (("between walls", (True, True)), ("on one wall", (True, False)), ("free", (False, False)))},
    **{f"ring of {n}": ring(n) for n in (3, 4, 5, 6)},
    **{f"{n} pendulums": pendulums(n) for n in (2, 3, 4)},
    "mirrored chain": chain(4, masses="m1 m2 m2 m1", springs="k1 k2 k3 k2 k1"),
    "mirrored chain of five": chain(5, masses="m1 m2 m3 m2 m1", springs="k1 k2 k3 k3 k2 k1"),
    "general chain": chain(3, masses="m1 m2 m3", springs="k1 k2 k3 k4"),
}


@pytest.mark.sweep
@pytest.mark.parametrize("name", FAMILIES)
def test_families_at_other_values(name):
    """Regular ones are solved as a whole."""
    found = Forms(FAMILIES[name])
    assert found.data["modes"] is not None
    for draw in found.draws():
        assert agrees(found.data, draw)
    if "chain" not in name:
        assert len(found.data["modes"]) == len(found.problem.scene.q)
        assert all(None not in mode["shape"].values() for mode in found.data["modes"])


def random_scene(seed):
    """Two to five masses with random letters, ties and dampers."""
    generator = random.Random(f"closed {seed}")
    n = generator.randint(2, 5)
    masses = [generator.choice(("m", "M", "m1")) for _ in range(n)]
    ends = [(f"b{j}", f"b{i}") for i in range(n) for j in range(i) if generator.random() < 0.6]
    ends += [("ground", f"b{i}") for i in range(n) if generator.random() < 0.5] or [("ground", "b0")]
    springs = [generator.choice(("k", "K", "k1")) for _ in ends]
    damped = [end for end in ends if generator.random() < 0.3]
    lines = ["bodies:"] + [f"  b{i}: {{mass: {m}, slide: x{i}}}" for i, m in enumerate(masses)] + ["springs:"]
    lines += [f"  s{i}: {{k: {springs[i]}, between: [{a}, {b}]}}" for i, (a, b) in enumerate(ends)]
    lines += ["dampers:"] * bool(damped) + [f"  d{i}: {{c: c, between: [{a}, {b}]}}" for i, (a, b) in enumerate(damped)]
    letters = dict.fromkeys(masses, "{unit: kg}") | dict.fromkeys(springs, "{unit: N/m}")
    letters |= {"c": ""} if damped else {}
    return "parameters: {" + ", ".join(f"{x}: {unit}" for x, unit in letters.items()) + "}\n" + "\n".join(lines) + "\n"


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(14))
def test_random_systems(seed):
    found = Forms(random_scene(seed))
    assert found.data["modes"] or found.data.get("characteristic_polynomial")
    for draw in found.draws(2):
        assert agrees(found.data, draw)
        assert polynomials_vanish(found.data, draw)


def polynomials_vanish(data, draw):
    """Are all ω² roots of what is printed: solved modes and polynomials in omega^2?"""
    solved = [omega for omega, *_ in forms_in_numbers(data, draw.numeric.floats)]
    for mode in draw.modal.modes:
        near = any(abs(mode.omega - omega) <= 1e-7 * (1 + omega) for omega in solved)
        texts = data.get("characteristic_polynomial", ())
        values = draw.numeric.floats | {"w": mode.omega}
        if not near and not any(small(text.replace("omega", "w"), values) for text in texts):
            return False
    return True


def small(text, values):
    """Is a sum zero beside its terms?"""
    tree = parse(text)
    parts = [number(part, values) for _, part in tree.parts] if isinstance(tree, Sum) else [number(tree, values)]
    return abs(number(tree, values)) <= 1e-7 * sum(map(abs, parts))


def test_coefficients_out_of_proportion_are_not_factored(monkeypatch):
    """λ = kμ, μ³ + μ² − 2μ − 1 = 0 has the roots 2cos(2πj/7); with other letters among them none are sought."""
    table = new_table()
    quotients = Quotients(table, [symbol(table, "m"), symbol(table, "k")])
    m, k = (quotients(symbol(table, name)) for name in "mk")
    one = quotients.number(1)
    assert [root.N for root in cosines(quotients, [-k**3, -2 * k**2, k, one])] == [7, 7, 7]
    monkeypatch.delattr(Quotients, "factors")
    assert cosines(quotients, [-k**3, -2 * k * m, m + k, one]) is None


# what is not shown

@pytest.mark.sweep
def test_a_wrong_form_is_not_shown(monkeypatch):
    from vibcli.analyses.closed_form import block_modes

    text = chain(2, springs="k kc k")
    assert problem(text).closed_forms is not None
    honest = block_modes._mode

    for part, factor in (("square", Fraction(1000001, 1000000)), ("omega", Fraction(1000001, 1000000)), ("omega", -1)):
        def wrong(*args, part=part, factor=factor):
            mode = honest(*args)
            return mode._replace(**{part: getattr(mode, part) * factor})
        monkeypatch.setattr(block_modes, "_mode", wrong)
        assert problem(text).closed_forms is None


def test_a_wrong_shape_and_a_wrong_damping_are_left_out(monkeypatch):
    from vibcli.analyses.closed_form import block_modes

    honest = block_modes._mode

    def wrong(*args):
        mode = honest(*args)
        return mode._replace(shape=[mode.shape[0], mode.shape[1] * Fraction(1000001, 1000000)],
                             zeta=mode.zeta * Fraction(1000001, 1000000))
    text = chain(2, damped=True)
    assert all(mode.shape and mode.zeta for mode in problem(text).closed_forms.modes)
    monkeypatch.setattr(block_modes, "_mode", wrong)
    assert all(mode.shape is None and mode.zeta is None for mode in problem(text).closed_forms.modes)


def test_late_algebra_leaves_the_polynomial(monkeypatch):
    """Where a factorisation takes too long the polynomial is taken whole, and solved if it is quadratic."""
    from vibcli.symbolic import rational_functions

    def late(self, polynomial):
        return polynomial.ring.domain(1), [(polynomial, 1)]
    monkeypatch.setattr(rational_functions.Quotients, "factors", late)
    found = Forms(chain(3, right=False, masses="m1 m2 m3", springs="k1 k2 k3"))
    assert len(found.data["characteristic_polynomial"]) == 1
    assert all(polynomials_vanish(found.data, draw) for draw in found.draws())


def test_no_equilibrium_in_letters_is_said():
    text = """
    parameters: {m: , L: , g: , kt: }
    gravity: g
    bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
    springs: {s: {torsion: kt, between: [ground, rod]}}
    """
    with pytest.raises(PhysicsError, match="not found in letters"):
        frequencies_data(problem(text))


def test_letters_of_any_sign():
    text = """
    parameters: {m: , k: , L: , a: {unit: m, sign: any}}
    bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
    springs: {s: {k: k, stretch: a*phi}}
    """
    assert "ω₁ = |a|·√(3·k/m)/L" in printed(problem(text))


@pytest.mark.sweep
@pytest.mark.parametrize("modulus", [[-2, 0, 1], [-2, 0, 0, 3], [1, 1, 0, 0, 1], [3, 5]])
def test_arithmetic_with_a_root_is_that_of_a_field(modulus):
    ground = PolyRing("x", QQ, "lex").to_field()
    generator, field = random.Random(len(modulus)), Extension(ground, list(map(ground, modulus)))
    for _ in range(30):
        a, b, c = (field.reduced([ground(generator.randint(-5, 5)) for _ in range(len(modulus) + k)])
                   for k in range(3))
        if a:
            assert field.times(a, field.inverse(a)) == [1]
            assert field.times(field.times(b, a), field.inverse(a)) == b
        assert field.minus(field.times(a, b), field.times(a, c)) == field.times(a, field.minus(b, c))
        assert field.minus(field.minus(a, b), a) == field.minus([], b)


def test_shapes_are_not_told_where_common_factors_of_many_letters_would_take_minutes():
    ground = PolyRing([f"a{i}" for i in range(12)], QQ, "lex").to_field()
    one, other = (1 + sum(gen**power for gen in ground.gens) for power in (2, 3))
    field = Extension(ground, [one, other, ground(1)])
    with pytest.raises(TooLong):
        field.inverse([one, 1 / other])
    assert unless_long(field.quotient, [one, 1 / other], [other, 1 / one]) is None
