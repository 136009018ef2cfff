"""Values of the problems taken away and asked back: the frequency or damping that a value gives must give the value."""

from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, value

from vibcli.base.errors import PhysicsError
from vibcli.inverse import settled
from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression, Record
from vibcli.reader.sections import choose
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import whole_literal

SLOW = ("bar_on_two_springs", "ladder_held_by_spring", "disc_on_three_tight_springs", "two_link_arm_under_load",
        "press_with_two_blows")     # some seconds each
PROBLEMS = [path for path in sorted((Path(__file__).parents[3] / "problems").glob("*/*.yaml"))
            if path.stem not in SLOW]
EVERY, SIXTH = 9, 6
# With a sixth of the others these take every step of `vibcli/inverse` that all take, as measured line by line.
WHOLE = "motor_on_inclined_mounts", "stepped_drum_with_block_and_pulley"


def planted(problem, name, quantity, number):
    """The problem with the value of a parameter taken away and a condition on a quantity instead."""
    spec, record = problem.spec, problem.spec.parameters[name]
    where = record.where

    def side(text):
        return Expression(Scalar(text, where), parse(text), None, None)

    values = {key: entry for key, entry in record.items() if key != "value"}
    if problem.numeric.floats[name] < 0:
        values["sign"] = "any"
    condition = choose.Condition(f"{quantity} = {number!r}", where, None, side(quantity), side(repr(number)))
    choices = {name: Record(choose.ELEMENT, name, where, {"so": condition}, {})}
    spec = spec.with_parameters({**spec.parameters, name: record.with_values(values)})
    return Problem(spec.with_sections(choose=choices)._replace(choices=choices))


def measured_nearby(problem, name, quantity):
    """The quantity at values somewhat smaller and larger."""
    free = planted(problem, name, quantity, 1.0)
    return [value(free.with_values({name: Fraction(problem.numeric.floats[name] * factor)}), quantity)
            for factor in (0.99, 1.01)]


def measurable(problem):
    """[(quantity, number)] of the first and last frequency and the first damping ratio, where they are not zero."""
    found = []
    for quantity in ("omega[1]", f"omega[{len(problem.scene.coordinates)}]", "zeta[1]"):
        try:
            found.append((quantity, value(problem, quantity)))
        except PhysicsError:
            continue
    return list(dict.fromkeys(pair for pair in found if pair[1]))


@cache
def collected(path):
    """Every ninth (parameter, quantity, its number) of a problem in numbers that chooses nothing itself; of those a
    sixth, begun anywhere, of all problems but the WHOLE ones."""
    problem = kept_problem_of(path)
    # loops: some seconds for each place that is looked at
    # members: no conditions in letters, and the search alone covers a few decades about one unit
    if problem.numeric.has_free_symbols or problem.scene.loops is not None or problem.scene.pieces:
        return []
    names = [name for name, record in problem.spec.parameters.items()
             if "value" in record and whole_literal(record["value"].tree) and "unused" not in record]
    found = [(name, *pair) for name in names for pair in measurable(problem)][::EVERY]
    return found if path.stem in WHOLE else found[(len(path.stem) + 5) % SIXTH::SIXTH]


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_the_value_is_found_again(path):
    problem = kept_problem_of(path)
    for name, quantity, number in collected(path):
        true = problem.numeric.floats[name]
        try:
            found = settled(planted(problem, name, quantity, number))
        except PhysicsError as error:
            assert "so it does not determine it" in error.message
            assert measured_nearby(problem, name, quantity) == pytest.approx([number] * 2, rel=1e-11)
            continue
        values = [float(solution.values[name]) for solution in found.choice.solutions]
        assert min(abs(x - true) for x in values) <= 1e-7 * abs(true)
        assert value(found, quantity) == pytest.approx(number, rel=1e-9)
        assert values == sorted(values)


@pytest.mark.sweep
def test_how_many_were_swept():
    assert sum(len(collected(path)) for path in PROBLEMS) >= 45
