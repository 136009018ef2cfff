"""Lines of worked solutions over many values: searched numbers against solutions, slopes against lines that move."""

from pathlib import Path

import numpy as np
import pytest
from support.scenes import problem

from vibcli.api.source import file_source, problem_of
from vibcli.homework.asked_keys import key_of
from vibcli.homework.line_values import LineValues
from vibcli.homework.rounding import Rounding, _carried
from vibcli.quantities.expression import measure
from vibcli.results.variants import Variants
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import QuantityRef

PROBLEMS = Path(__file__).parents[3] / "problems"
AROUND = 1e-6       # relative: by how much a line is moved


def problem_named(stem):
    return problem_of(file_source(next(PROBLEMS.glob(f"*/{stem}.yaml"))))


def values_of(problem, count):
    variants = Variants(problem, problem.spec.get("variants").axes)
    places = list(variants.places)
    return [variants.values_at(places[i * len(places) // count]) for i in range(count)]


def given(values):
    return {name: np.array([float(one[name].exact) for one in values]) for name in values[0]}


@pytest.mark.parametrize("stem, texts", [
    ("rod_with_inclined_spring", ("equilibrium[phi]", "omega[1]")),     # a search for rest
    ("cantilever_with_tip_mass", ("omega[1]",)),                        # the root of a frequency equation
    ("three_discs_on_fixed_shaft", ("omega[1]", "omega[3]")),           # of a polynomial of the third degree
    ("quarter_car_damped", ("zeta[1]", "omega_d[2]")),                  # a pair of complex roots
    ("three_discs_on_fixed_shaft", ("dunkerley",)),                     # each inertia alone
    ("ring_on_five_spokes", ("stiffness[hub].max",)),                   # of a symmetric tensor
    ("pendulum_that_swings_widely", ("backbone[1](phi)(90 deg)",)),     # an integral between searched places
    ("three_storeys_on_shaking_ground", ("amplitude(c1.force)",)),      # complex amplitudes, found together
    ("roller_let_go_overdamped", ("x(0 s)",)),
])
def test_lines_tell_what_solutions_do(stem, texts):
    problem = problem_named(stem)
    values, known = values_of(problem, 7), LineValues(problem)
    found = known.values(given(values))
    for i, one in enumerate(values):
        fresh = Variants(problem, []).at(one)
        for text in texts:
            tree = parse(text)
            value = measure(fresh, tree if hasattr(tree, "args") else QuantityRef(0, 0, text, text))[0]
            assert found[known.number(text)][i] == pytest.approx(value, rel=1e-9), (text, one)


@pytest.mark.parametrize("stem", ["rod_with_inclined_spring", "cantilever_with_tip_mass", "quarter_car_damped",
                                  "bead_on_swinging_rod", "stepped_bar", "ring_on_five_spokes",
                                  "three_discs_on_fixed_shaft", "roller_let_go_overdamped"])
def test_what_lines_carry_is_what_moving_them_does(stem):
    """Each line with a letter moved by itself, all lines after it evaluated or searched anew."""
    problem = problem_named(stem)
    rounding, at = Rounding(problem), given(values_of(problem, 3))
    known = rounding.known
    values, weights = rounding.weighed(at)
    numbers, count = known.parameters(at), len(known.lines)
    named = {j for letters in known.letters for j in letters}
    assert named
    for j in named:
        moved = [*values[:j], values[j] * (1 + AROUND)]
        for i in range(j + 1, count):
            if known.letters[i]:
                first = i - known.place_in_group(i)
                moved += known.at(first, numbers, [*moved, *values[len(moved):]], values)[i - first:i - first + 1]
            else:
                moved.append(values[i])
        for end in range(j + 1, count):
            alone = [[np.full_like(values[0], 1.0 * (i == j)) for i in range(count)]]
            ends = dict(zip(rounding.uses[end], weights[end], strict=True)) if known.letters[end] else {}
            carried = _carried(ends, rounding.uses, weights, alone)[0][0] if ends else np.zeros(3)
            felt = np.abs(moved[end] / values[end] - 1) / AROUND
            names = known.lines[j].settles, known.lines[end].settles
            assert carried == pytest.approx(felt, rel=1e-3, abs=1e-3), names


def test_what_no_search_finds_is_told_by_no_line(monkeypatch):
    """Where the way from the values of the file ends, as behind a fold, the band is the one without lines."""
    problem = problem_named("rod_with_inclined_spring")
    rounding, keys = Rounding(problem), [key_of(problem.spec, one) for one in problem.spec.get("variants").ask]
    at = given(values_of(problem, 3))
    assert all(share is not None for share in rounding.shares(keys, at))
    monkeypatch.setattr(LineValues, "_search", lambda self, group, known, near: np.full((len(group), 3), np.nan))
    assert rounding.shares(keys, at) == [None] * len(keys)


def test_lines_follow_from_others_by_way_of_lines_without_numbers():
    """The determinant of a double pendulum from the mass matrix, and that from the inertia about the hinge."""
    known = LineValues(problem_named("double_pendulum_rods"))
    entry = known.number("M[1,1]")
    assert known.number("J_O_upper") in known.uses[entry] and entry in known.uses[known.number("a2")]


@pytest.mark.sweep
def test_no_line_follows_from_a_force_at_rest_beside_the_balance_that_it_uses():
    """The moment of a preloaded spring stands in the line of ∂V/∂φ = 0, by which V has no terms of the first order."""
    known = LineValues(problem_named("feeder_tray_driven_by_a_sawtooth"))
    moment, inertia = known.number("N_s"), known.number("J_O₁")
    assert moment is not None and not any(moment in uses for uses in known.uses)
    assert inertia in known.uses[known.number("omega[1]")]


@pytest.mark.sweep
def test_what_follows_from_exact_entries_and_takes_few_values_is_off_by_what_these_are():
    """√(k₁/J₁) of three J₁, behind entries of M and K that four figures hold."""
    problem = problem_named("three_discs_on_fixed_shaft")
    rounding = Rounding(problem)
    values = rounding.known.values(given(values_of(problem, 200)))
    line = rounding.known.number("omega_alone[one]")
    entries, rounded = rounding.uses[line], rounding.rounded(values, 4)
    assert rounding.known.number("K[phi1,phi1]") in entries and not any(rounded[i].any() for i in entries)
    off = np.round(values[line], 1) / values[line] - 1
    half = 0.05 / values[line]
    assert rounded[line] == pytest.approx(half * np.sqrt(3 * np.mean((off / half)**2)), rel=1e-6)


def test_lines_with_units_of_numbers_in_the_file_have_values():
    """A mass m + 0.5 kg on a spring, damped by 24 N·s/m: ω² = k/3.5 kg, δ = 24/7 1/s."""
    known = LineValues(problem("""
        parameters: {k: 1.2 kN/m, m: 3 kg}
        bodies: {b: {mass: m + 0.5 kg, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {c: 24 N*s/m, between: [ground, b]}}
    """))
    found = known.values({"k": np.array([1200.0, 4800.0])})
    omega, delta = (found[known.number(name)] for name in ("omega[1]", "delta"))
    assert omega == pytest.approx(np.sqrt(np.array([1200.0, 4800.0]) / 3.5)) and delta == pytest.approx([24 / 7] * 2)
