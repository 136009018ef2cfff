"""Masses, mass centres and moments of inertia beside closed forms, and by sums over cells."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.elements import shapes
from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import over_shapes
from vibcli.evidence.subject import Deadline

ROUND = """
parameters: {m: 2 kg, a: 0.3 m, b: 0.2 m, h: 0.7 rad}
points: {O: [0.5 m, -0.4 m]}
bodies:
  whole: {shape: ellipse, mass: m, a: a, b: b, at: [0, 0], angle: 20 deg, pin: {at: O, by: alpha}}
  slice: {shape: sector, mass: m, radius: a, half_angle: h, at: [0, 0], angle: pi/2, pin: {at: O, by: beta}}
  bow: {shape: arch, mass: m, radius: a, half_angle: h, at: [0, 0], pin: {at: O, by: gamma}}
  plain: {mass: m, gyration: b, at: [0, 0], pin: {at: O, by: delta}}
springs: {s: {k: 1 N/m, stretch: alpha*a + beta*a + gamma*a + delta*a}}
answers: {"J[whole, O]": 0, "centre[slice].y": 0, "J[slice]": 0, "centre[bow].x": 0, "J[bow, whole]": 0,
  "J[plain, O]": 0}
"""
PIERCED = """
parameters: {q: 20 kg/m^2, w: 0.4 m, h: 0.3 m, r: 6 cm, d: 0.1 m}
bodies:
  plate:
    parts:
      - {shape: rectangle, density: q, width: w, height: h, at: [0, 0], angle: pi/6}
      - {shape: disc, density: q, radius: r, at: [d, 0], cut: true}
      - {shape: ring, mass: 0.5 kg, radius: r, at: [d, 0]}
      - {shape: rod, mass: 1 kg, from: [0, 0], to: [0, h]}
      - {mass: 0.25 kg, at: [0, -h]}
    pin: {at: [0, 0], by: phi}
springs: {s: {k: 1 N/m, stretch: phi*d}}
points: {O: [0, 0]}
answers: {"mass[plate]": 0, "centre[plate].x": 0, "J[plate, O]": 0}
"""


def round_ones():
    m, a, b, h = 2, mpmath.mpf("0.3"), mpmath.mpf("0.2"), mpmath.mpf("0.7")
    far, of_slice, of_bow = mpmath.mpf("0.41"), 2 * a * mpmath.sin(h) / (3 * h), a * mpmath.sin(h) / h
    return [m * (a**2 + b**2) / 4 + m * far, of_slice, m * (a**2 / 2 - of_slice**2), of_bow, m * a**2, m * (b**2 + far)]


def pierced():
    q, w, h, r, d = 20, mpmath.mpf("0.4"), mpmath.mpf("0.3"), mpmath.mpf("0.06"), mpmath.mpf("0.1")
    hole = q * mpmath.pi * r**2
    mass = q * w * h - hole + mpmath.mpf("1.75")
    return [mass, d * (mpmath.mpf("0.5") - hole) / mass, q * w * h * (w**2 + h**2) / 12 - hole * (r**2 / 2 + d**2)
            + (r**2 + d**2) / 2 + h**2 / 3 + h**2 / 4]


def found(text):
    one = problem(text)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "exact"), [(ROUND, round_ones), (PIERCED, pierced)])
def test_moments_beside_closed_forms_and_by_cells(text, exact):
    with mpmath.workdps(60):
        for each, x in zip(found(text), exact(), strict=True):
            answer = each.ours()
            assert abs(each.true.values[0] - x) < 1e-45, each.asked
            assert each.error(answer.values, each.true) <= answer.bound < 1e-13 or not x
            runs = {(run.method, run.setting): run for run in over_shapes.attempts(each)}
            last = runs.get(("Gauss", "32"), next(iter(runs.values())))
            assert each.error(last.run(Deadline(1)).values, each.true) < 1e-14
            if ("cells", "30") in runs:
                assert each.error(runs["cells", "30"].run(Deadline(1)).values, each.true) < 2e-3


@pytest.mark.sweep
def test_a_shape_that_is_off_is_found(monkeypatch):
    for name in ("ellipse", "sector"):
        law = shapes.LAWS[name]
        monkeypatch.setitem(shapes.LAWS, name, lambda *args, law=law: law(*args)._replace(
            gyration2=law(*args).gyration2 * (1 + args[0].number(10) ** -12)))
    broken = {each.asked for each in found(ROUND) for answer in (each.ours(),)
              if not each.error(answer.values, each.true) <= answer.bound}
    assert broken == {"J[whole, O]", "J[slice]"}
