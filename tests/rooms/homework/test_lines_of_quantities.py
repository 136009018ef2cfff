"""Quantities that a sheet asks have lines by which they hang on what is rounded: amplitudes of signals, estimates,
directions of several elements, backbones, instants. Each against solutions of the scene with other values, and its band
against students who follow the lines."""

import numpy as np
import pytest
from support.scenes import problem
from support.students import Students, rounded

from vibcli.homework.asked_keys import key_of
from vibcli.homework.bands import KeyBand, half_a_unit
from vibcli.homework.line_values import LineValues
from vibcli.quantities.expression import measure
from vibcli.results.variants import Variants

MANY = 1000
MASSES = "    m1: {from: 3 kg, to: 5 kg, step: 0.1 kg}\n    m2: {from: 2 kg, to: 4 kg, step: 0.1 kg}\n"
STIFFNESS = "{from: 700 N/m, to: 1100 N/m, step: 20 N/m}"
SCENES = {
    "force of a spring and a damper of one degree": """
parameters: {m: 4 kg, k: 900 N/m, c: 20 N*s/m, F0: 30 N, Omega: 11 rad/s}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
forces: {f: {at: b, force: F0*sin(Omega*t)}}
variants:
  parameters: {m: {from: 3 kg, to: 5 kg, step: 0.1 kg}, k: """ + STIFFNESS + """, c: [15 N*s/m, 20 N*s/m, 25 N*s/m]}
  ask: {amplitude(x): {}, amplitude(s.force): {}, amplitude(d.force): {}}
""", "two masses on a base that moves": """
parameters: {m1: 4 kg, m2: 3 kg, k1: 900 N/m, k2: 500 N/m, c: 20 N*s/m, A: 5 mm, Omega: 9 rad/s}
bodies: {base: {slide: A*sin(Omega*t)}, a: {mass: m1, slide: x}, b: {mass: m2, slide: y}}
springs: {s1: {k: k1, between: [base, a]}, s2: {k: k2, between: [a, b]}}
dampers: {d: {c: c, between: [base, a]}}
variants:
  parameters:
""" + MASSES + """    k1: """ + STIFFNESS + """
  ask: {amplitude(x): {}, amplitude(s1.force): {}, amplitude(d.force): {}, amplitude(y - x): {}, phase(x): {}}
""", "four masses, which no determinant is written of": """
parameters: {m1: 4 kg, m2: 3 kg, k1: 900 N/m, k2: 500 N/m, F0: 30 N, Omega: 3 rad/s}
bodies: {a: {mass: m1, slide: x}, b: {mass: m2, slide: y}, c: {mass: m1, slide: z}, d: {mass: m2, slide: w}}
springs: {s1: {k: k1, between: [ground, a]}, s2: {k: k2, between: [a, b]}, s3: {k: k1, between: [b, c]},
  s4: {k: k2, between: [c, d]}}
forces: {f: {at: b, force: F0*sin(Omega*t)}}
variants:
  parameters:
""" + MASSES + """    k1: """ + STIFFNESS + """
  ask: {"omega[1]": {}, "omega[2]": {}, "mode[1][z]": {}, amplitude(x): {}, amplitude(s3.force): {}, rayleigh: {},
    dunkerley: {}}
""", "three springs in a plane": """
parameters: {m: 4 kg, k1: 900 N/m, k2: 500 N/m, k3: 300 N/m, al: 35 deg, R: 0.5 m}
bodies: {hub: {mass: m, at: [0, 0], move: [x, y, 0]}}
springs:
  s1: {k: k1, between: [[R, 0], hub]}
  s2: {k: k2, between: [[R*cos(al), R*sin(al)], hub]}
  s3: {k: k3, between: [[R*cos(130 deg), R*sin(130 deg)], hub]}
variants:
  parameters:
    k1: """ + STIFFNESS + """
    k2: {from: 400 N/m, to: 600 N/m, step: 20 N/m}
    al: {from: 30 deg, to: 40 deg, step: 1 deg}
  ask: {"stiffness[hub].max": {}, "stiffness[hub].min": {}, "stiffness[hub].angle": {}}
""", "an uneven spring": """
parameters: {m: 2 kg, k: 80 N/m, g2: 120 N/m^2, g3: 500 N/m^3, A: 20 cm}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d + g2*d^2 + g3*d^3, between: [ground, block]}}
variants:
  parameters:
    m: {from: 1.5 kg, to: 2.5 kg, step: 0.1 kg}
    k: {from: 70 N/m, to: 90 N/m, step: 1 N/m}
    A: {from: 15 cm, to: 25 cm, step: 1 cm}
  ask: {"backbone[1](x)(A)": {}}
""", "a pendulum by how high its bob rises": """
parameters: {m: 2 kg, L: 80 cm, h: 20 cm}
gravity: 9.81 m/s^2
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
variants:
  parameters: {L: {from: 60 cm, to: 90 cm, step: 1 cm}, h: {from: 15 cm, to: 25 cm, step: 1 cm}}
  ask: {"backbone[1](bob.y)(h)": {}}
""", "a hanging block that is let go": """
parameters: {m: 4 kg, k: 900 N/m, c: 20 N*s/m, u: 10 cm, t1: 0.3 s}
gravity: 9.81 m/s^2
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, -1], by: x}}}
springs: {s: {k: k, between: [[0, 1 m], b]}}
dampers: {d: {c: c, between: [[0, 1 m], b]}}
initial: {x: u}
variants:
  parameters:
    m: {from: 3 kg, to: 5 kg, step: 0.1 kg}
    k: """ + STIFFNESS + """
    c: [15 N*s/m, 20 N*s/m, 25 N*s/m]
    u: [9 cm, 10 cm, 12 cm]
  ask: {x(t1): {}, "x'(t1)": {}, x(0.1 s): {}, x(0 s): {}}
""", "damped by ratios of its modes": """
parameters: {m1: 4 kg, m2: 3 kg, k1: 900 N/m, k2: 500 N/m, F0: 30 N, Omega: 3 rad/s, z: 4 %}
bodies: {a: {mass: m1, slide: x}, b: {mass: m2, slide: y}}
springs: {s1: {k: k1, between: [ground, a]}, s2: {k: k2, between: [a, b]}}
forces: {f: {at: b, force: F0*cos(Omega*t)}}
damping: {modal: [z]}
variants:
  parameters:
""" + MASSES + """    k1: """ + STIFFNESS + """
  ask: {amplitude(x): {}, amplitude(s2.force): {}}
"""}


def drawn(scene, count):
    """(keys, values of so many variants, from all over the grid)."""
    rules = scene.spec.get("variants")
    variants = Variants(scene, rules.axes)
    places = list(variants.places)
    return [key_of(scene.spec, one) for one in rules.ask], [variants.values_at(places[i * len(places) // count])
                                                            for i in range(count)]


@pytest.mark.parametrize("name", SCENES)
def test_lines_tell_what_solutions_do(name):
    scene = problem(SCENES[name])
    keys, values = drawn(scene, 5)
    known = LineValues(scene)
    found = known.values({name: np.array([float(one[name].exact) for one in values]) for name in values[0]})
    for i, one in enumerate(values):
        fresh = Variants(scene, []).at(one)
        for key in keys:
            assert found[known.number(key.text)][i] == pytest.approx(measure(fresh, key.asked.tree)[0], rel=1e-9), one


@pytest.mark.parametrize("name", SCENES)
def test_bands_are_the_99th_percentile_of_what_rounding_does(name):
    scene = problem(SCENES[name])
    keys, values = drawn(scene, MANY)
    students = Students(scene, values)
    for key, share in zip(keys, students.rounding.shares(keys, students.given), strict=True):
        right = students.right(key)
        bands = np.array([KeyBand(None, tuple(map(tuple, share[:, :, i].tolist()))).width(value, 3)
                          for i, value in enumerate(right)])
        off = np.abs(rounded(right * students.answers(key, np.full(MANY, 3))[0], 3) - right) / bands
        own = np.allclose(bands, [half_a_unit(value, 3) for value in right])
        assert np.mean(off <= 1 + 1e-9) >= 0.98 and (own or 0.8 <= np.quantile(off, 0.99) <= 1.2), key.text


def test_what_is_told_again_is_rounded_once():
    """|X| of what nothing damps is X itself."""
    scene = problem(SCENES["four masses, which no determinant is written of"])
    known = LineValues(scene)
    assert known.again(known.number("amplitude(x)")) and not known.again(known.number("amplitude(s3.force)"))


def test_what_takes_few_values_is_off_by_what_these_are():
    """√(k/J) of three values: as an even error with the mean square of theirs."""
    from vibcli.homework.rounding import _half_a_unit, _of_few_values

    value = np.array([129.0994, 122.4745, 116.7748] * 40)
    half, off = _half_a_unit(value, 4), np.abs(np.round(value, 1) / value - 1)
    found = _of_few_values(value, half, off)
    units = np.array([0.0006, 0.0255, 0.0252]) / 0.05           # of the last figure but one: 129.1, 122.5, 116.8
    assert found / half == pytest.approx(np.sqrt(3 * np.mean(units**2)), rel=2e-2)
    assert (_of_few_values(np.full(9, 5.43), half[:9], off[:9]) == off[:9]).all()
    many = np.linspace(1, 9, 100)
    assert _of_few_values(many, many, many) is many
