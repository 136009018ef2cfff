"""What arrays tell of many scenes is what each of them tells by itself, and no scene is made where they tell it."""

import numpy as np
import pytest

import vibcli
from vibcli.api.axis import of_numbers
from vibcli.base.errors import PhysicsError
from vibcli.homework.grid_answers import GridAnswers
from vibcli.homework.regime import regime
from vibcli.language.document.nodes import Scalar
from vibcli.language.reader import Expression
from vibcli.quantities import FAMILIES
from vibcli.quantities.at_once import AnswersAtOnce
from vibcli.quantities.expression import value_of
from vibcli.quantities.quantity import named
from vibcli.results.problem import Problem
from vibcli.results.variants import Variants
from vibcli.symbolic.parser import parse

CAR = """
parameters: {m1: 40 kg, m2: 300 kg, k1: 180 kN/m, k2: 20 kN/m, c: 1200 N*s/m}
bodies: {wheel: {mass: m1, slide: x1}, body: {mass: m2, slide: x2}}
springs: {tyre: {k: k1, between: [ground, wheel]}, s: {k: k2, between: [wheel, body]}}
dampers: {d: {c: c, between: [wheel, body]}}
"""
UPRIGHT = """
parameters: {m: 2 kg, L: 0.6 m, k: 30 N*m, c: 0.4 N*m*s, g: 9.81 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi}}}
springs: {s: {torsion: k, between: [ground, bob]}}
dampers: {d: {torsion: c, between: [ground, bob]}}
"""
FREE = """
parameters: {m1: 6 kg, m2: 2 kg, k: 700 N/m}
bodies: {a: {mass: m1, slide: x1}, b: {mass: m2, slide: x2}}
springs: {s: {k: k, between: [a, b]}}
"""
OF_NATURAL, OF_DAMPED = ("omega", "frequency", "period"), ("zeta", "omega_d", "period_d", "decay", "decrement[]")
SAID = [(text, name, low, high) for text, name, low, high in (
    (CAR, "c", 100, 9000), (CAR, "m1", 20, 80), (UPRIGHT, "k", 8, 60), (UPRIGHT, "c", 0.1, 60), (FREE, "m2", 1, 9))]


def asked(text):
    return Expression(Scalar(text, None), parse(text))


def grid(text, name, low, high):
    problem = vibcli.loads(text)._as_read
    return Variants(problem, [{name: of_numbers(problem.spec, name, np.linspace(low, high, 41)).values}])


def test_what_may_be_asked_at_once_is_what_is_tried_here():
    declared = {word for word in (*FAMILIES, "decrement[]", "rayleigh[]") if named(word).at_once}
    assert declared == {*OF_NATURAL, *OF_DAMPED}


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "name", "low", "high"), SAID)
def test_each_is_that_of_the_scene_alone(text, name, low, high):
    variants = grid(text, name, low, high)
    at_once, known = AnswersAtOnce(variants), 0
    degrees = len(variants.problem.spec.coordinates)
    words = [f"{head.removesuffix('[]')}[{i}]" for head in (*OF_NATURAL, *OF_DAMPED) for i in range(1, degrees + 1)]
    for place in variants.places:
        alone = variants.at(variants.values_at(place))
        for text in (*words, f"2*{words[0]}", f"{words[0]}^2/{name}"):
            try:
                told = at_once.value_of(asked(text), place)
            except PhysicsError as error:
                with pytest.raises(PhysicsError, match=error.message[:20]):
                    value_of(alone, asked(text))
                continue
            if told is None:
                continue
            value, error = value_of(alone, asked(text))
            assert abs(told[0] - value) <= (told[1] + error + 1e-15) * abs(value)
            known += 1
    assert known > 41 * degrees


def test_what_some_scenes_do_not_have_is_theirs_alone():
    answers = GridAnswers.of(grid(UPRIGHT, "k", 8, 60))     # upright it falls where k < mgL
    assert answers._at_once.value_of(asked("omega[1]"), (0,)) is None
    with pytest.raises(PhysicsError, match="unstable"):
        answers.value_of((0,), asked("omega[1]"))
    assert answers.value_of((40,), asked("omega[1]"))[0] > 0
    assert answers._at_once.value_of(asked("growth_rate[1]"), (0,)) is None


def test_nothing_is_damped_where_nothing_damps():
    answers = AnswersAtOnce(grid(FREE, "m2", 1, 9))
    for _ in range(2):      # of one error no second trace is kept
        with pytest.raises(PhysicsError, match="nothing damps this scene") as raised:
            answers.value_of(asked("zeta[1]"), (7,))
    assert len(raised.traceback) <= 3


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "name", "low", "high"), SAID)
def test_the_regime_is_that_of_the_scene_alone(text, name, low, high):
    variants = grid(text, name, low, high)
    answers = GridAnswers.of(variants)
    assert all(answers.regime(place, False) == regime(variants.at(variants.values_at(place)), False)
               for place in variants.places)


def test_no_scene_is_made_of_what_arrays_tell(monkeypatch):
    answers = GridAnswers.of(grid(CAR, "m1", 20, 80))
    made = []
    monkeypatch.setattr(Problem, "sharing", lambda *args, **kwargs: made.append(args))
    found = [answers.value_of((i,), asked("omega_d[2]"))[0] for i in range(41)]
    assert len(set(found)) == 41 and not made and answers.regime((20,), False).natural == ("oscillation",) * 2
