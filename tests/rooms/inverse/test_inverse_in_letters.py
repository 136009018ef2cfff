"""Solutions in letters: at numbers for the letters those whose conditions hold are all that the numbers give."""

import math

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.inverse import settled
from vibcli.inverse.admissible_ranges import known
from vibcli.inverse.symbolic_admissible_ranges import SPREADS, Letters
from vibcli.symbolic.evaluation import Floats, evaluate

ONE = """
parameters: {{{parameters}}}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
dampers: {{d: {{c: c, between: [ground, b]}}}}
forces: {{F: {{at: b, force: F0*sin(W*t)}}}}
choose: {{{choose}}}
"""
TWO = """
parameters: {{{parameters}}}
bodies: {{a: {{mass: m1, slide: x}}, b: {{mass: m2, slide: y}}}}
springs: {{s: {{k: k1, between: [ground, a]}}, t: {{k: k2, between: [a, b]}}}}
choose: {{{choose}}}
"""
SCENES = [
    (ONE, "m: , c: , F0: , W: , X: ", 'k: "amplitude(x) = X"'),
    (ONE, "m: , c: , F0: , W: ", 'k: {so: "amplitude(x) = 2 cm", to: 1000 N/m}'),
    (ONE, "m: , c: , F0: , W: , X: ", 'k: {so: "amplitude(x) = X", from: m*W^2, to: 2*m*W^2}'),
    (ONE, "c: , k: , F0: , W: , X: ", 'm: "amplitude(x) = X"'),
    (ONE, "m: , k: , F0: , W: , X: ", 'c: "amplitude(x) = X"'),
    (ONE, "m: , c: , F0: , W: , T: ", 'k: "transmissibility[ground.force, F](W) = T"'),
    (ONE, "c: , k: , F0: , W: , w: ", 'm: "omega_d[1] = w"'),
    (ONE, "m: , k: , F0: , W: , w: ", 'c: "decay[1] = w"'),
    (TWO, "m1: , m2: , k2: , w: ", 'k1: "omega[1] = w"'),
]
FIRST, MOST, LEAST = 1000, 200, 2


def counts(condition, solution, values):
    """Does a condition of a solution in letters hold at values of all letters?"""
    side = condition.node if condition.node is not None else solution.forms[condition.name]
    left, right = evaluate([side, condition.bound or side.table.zero], Floats, values)
    holds = {"≥": left >= right, ">": left > right, "≤": left <= right, "<": left < right}
    return not math.isnan(left) and (not condition.relation or holds[condition.relation])


def numbers_of(whole, given):
    """What the scene with numbers for its letters chooses."""
    name, = whole.spec.choices
    try:
        return [float(solution.values[name]) for solution in settled(whole.with_values(given)).choice.solutions]
    except PhysicsError:
        return []


def told_of(whole, solutions, given):
    """(values of the solutions in letters that count, whether conditions in words stand by some of them)."""
    name, = whole.spec.choices
    values, told, words = known(whole.sharing(given), Floats), [], False
    for solution in solutions:
        ruled = [condition for condition in solution.counts if condition.words is None]
        if all(counts(condition, solution, values) for condition in ruled):
            told += evaluate([solution.forms[name]], Floats, values)
            words |= len(ruled) < len(solution.counts)
    return sorted(told), words


@pytest.mark.sweep
@pytest.mark.parametrize(("frame", "given", "choose"), SCENES, ids=[part[2] + part[1][:5] for part in SCENES])
def test_solutions_in_letters_are_those_of_numbers(frame, given, choose):
    whole = problem(frame.format(parameters=given, choose=choose))
    solutions = settled(whole).choice.solutions
    draws, compared, none = Letters(whole, whole, [solution.forms for solution in solutions]), 0, 0
    for attempt in range(FIRST, FIRST + MOST):
        given = draws.values(attempt)
        told, words = told_of(whole, solutions, given)
        none += not told
        if not told and none > 1:
            continue
        numbers = numbers_of(whole, given)
        if words:       # a mode of another number, say
            assert all(any(x == pytest.approx(y, rel=1e-9) for y in told) for x in numbers)
        else:
            assert told == pytest.approx(numbers, rel=1e-9)
        compared += bool(numbers)
        if compared >= LEAST:
            break
    assert compared


@pytest.mark.sweep
def test_the_scene_goes_on_with_what_counts():
    """The smaller stiffness is negative for most values about one: the scene is drawn where it counts."""
    whole = problem(ONE.format(parameters="m: , c: , F0: , W: , X: ", choose='k: "amplitude(x) = X"'))
    found = settled(whole)
    assert len(found.choice.solutions) == 2 and found.scene.sample["k"] > 0
    assert all(float(settled(draw).numeric.floats["k"]) == pytest.approx(
        evaluate([found.choice.solutions[0].forms["k"]], Floats,
                 known(whole.sharing(draw.numeric.given), Floats))[0], rel=1e-9)
               for draw in found.choice.draws)


@pytest.mark.sweep
def test_what_no_draw_fulfils_is_not_called_impossible():
    text = ONE.format(parameters="m: , c: , F0: , W: , X: ", choose='k: {so: "amplitude(x) = -X"}')
    with pytest.raises(PhysicsError) as caught:
        settled(problem(text))
    assert "was found" in caught.value.message


def test_draws_lie_about_the_natural_scale_of_each_letter():
    """Within three decades of it, on both sides alike, nearer ones among them."""
    whole = problem(TWO.format(parameters="m1: , m2: , k2: , w: ", choose='k1: "omega[1] = w"'))
    draws = Letters(whole, whole, [])
    for name in whole.symbolic.letters:
        away = [math.log10(draws.values(attempt)[name] / draws.scales[name]) for attempt in range(MOST)
                if SPREADS[attempt % len(SPREADS)]]
        assert max(map(abs, away)) <= max(SPREADS) and abs(sum(away)) < 0.2 * len(away)
        assert max(away) > 2.5 and min(away) < -2.5
