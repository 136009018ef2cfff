"""What `check` accepts and what it rejects: tolerances, remarks, equations, energies, inertias, exit codes."""

import json
import math
from functools import partial

import pytest
from support.scenes import problem, problem_of

from vibcli.check.verdicts import check
from vibcli.cli.common import known_mistake
from vibcli.cli.program import run
from vibcli.manual import scenes
from vibcli.results.random_states import reach, states

MASS = """
parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, k: 40 N/m, c: 0.7 N*s/m}
gravity: g
points: {O: [0, 0], A: {body: rod, at: [0, -L]}, P: [L, -L]}
bodies: {rod: {shape: rod, mass: m, from: O0, to: [0, -L], pin: {at: O, by: phi}}}
springs: {s: {k: k, between: [[-L, -L], A]}}
dampers: {d: {c: c, between: [[-L, -L], A]}}
""".replace("O0", "[0, 0]")


def verdicts(scene, *answers):
    """{asked: Verdict} of the answers, lines `quantity: value`."""
    text = scene + "answers:\n" + "".join(f"  {line}\n" for line in answers)
    return {verdict.answer.asked.text: verdict for verdict in check(problem(text), partial(known_mistake, None))}


def agrees(scene, line):
    verdict, = verdicts(scene, line).values()
    return verdict.agrees


@pytest.mark.parametrize("value, good", [
    ("20 rad/s", True), ("20.0 rad/s", True), ("20.00 rad/s", True), ("20.0000001 "
                                                            "rad/s", False), ("20.04 rad/s", False),
    ("20.1 rad/s", False), ("19.9 rad/s", False), ("21 rad/s", False), ("2e1 rad/s", True), ("2.00e1 rad/s", True),
    ("2.004e1 rad/s", False), ("190.99 rpm", True), ("191 rpm", True), ("192 rpm", False), ("sqrt(k/m)", True),
    ("sqrt(k/m)*(1 + 2e-9)", False), ("{value: 20.1 rad/s, rtol: 1 %}", True), ("{value: 20.3 rad/s, rtol: 1 "
                                                            "%}", False),
    ("{value: sqrt(k/m)*1.004, rtol: 0.005}", True), ("{value: 20.1 rad/s, rtol: 0.001}", False)])
def test_tolerance_of_the_digits_written(value, good):
    assert agrees(MASS, f"omega[1]: {value}") is good


@pytest.mark.parametrize("stiffness, value, good", [
    ("812.02 N/m", "20.1 rad/s", True),     # 20.1497, half a unit of the last digit is 0.05
    ("812.06 N/m", "20.1 rad/s", False), ("812.1 N/m", "20.1 rad/s", False), ("804.1 N/m", "20.1 rad/s", True),
    ("803.9 N/m", "20 rad/s", False), ("2.02 N/m", "1.00 rad/s", True), ("2.03 N/m", "1.00 rad/s", False),
    ("2.02 N/m", "1.0 rad/s", False)])
def test_half_a_unit_and_at_most_half_a_percent(stiffness, value, good):
    assert agrees(MASS.replace("800 N/m", stiffness), f"omega[1]: {value}") is good


@pytest.mark.sweep
@pytest.mark.parametrize("line, remark", [
    ("omega[1]: 3.18310 rad/s", "Hz"), ("frequency[1]: 20.0 Hz", "in rad/s"), ("period[1]: 0.0500 s", "1/ω"),
    ("omega[1]: 10.0 rad/s", "half of it"), ("omega[1]: 40.0 rad/s", "twice of it"), ("omega[1]: -20.0 rad/s", "sign"),
    ("omega[1]: 23.0 rad/s", "ratio 1.15")])
def test_remarks_on_likely_mistakes(line, remark):
    verdict, = verdicts(MASS, line).values()
    assert not verdict.agrees
    assert remark in verdict.remark


@pytest.mark.parametrize("line, good", [
    ("equation[phi]: m*L^2/3*phi'' + c*L^2*phi' + (m*g*L/2 + k*L^2)*phi = 0", True),
    ("equation[phi]: -5*phi'' - 15*c/m*phi' = (15/2*g/L + 15*k/m)*phi", True),
    ("equation[1]: phi'' + 3*c/m*phi' + (3/2*g/L + 3*k/m)*phi = 0", True),
    ("equation[phi]: phi'' + 3*c/m*phi' + (3/2*g/L + 3.01*k/m)*phi = 0", False),
    ("equation[phi]: phi'' - 3*c/m*phi' + (3/2*g/L + 3*k/m)*phi = 0", False),
    ("equation[phi]: phi'' + (3/2*g/L + 3*k/m)*phi = 0", False),
    ("equation[phi]: phi'' + 3*c/m*phi' + (3/2*g/L + 3*k/m)*sin(phi) = 0", False),
    ("motion[phi]: phi'' + 3*c/m*phi' + (3/2*g/L + 3*k/m)*phi = 0", False),
    ("T: m*L^2/6*phi'^2", True), ("T: m*L^2/24*phi'^2", False), ("T: m*L^2/6*phi'^2 + 1e-7*m*L^2*phi'^2", False),
    ("V: k/2*(sqrt((L + L*sin(phi))^2 + (L - L*cos(phi))^2) - L)^2 - m*g*L/2*cos(phi) + 7*m*g*L", True),
    ("V: k/2*(L*sin(phi))^2 - m*g*L/2*cos(phi)", False),
    ("V: m*g*L/2*(1 - cos(phi))", False),
    ("Phi: c/2*L^2*phi'^2", False),
    ("J[rod]: m*L^2/12", True), ("J[rod, O]: m*L^2/3", True), ("J[rod, A]: m*L^2/3", True),
    ("J[rod, P]: m*L^2/12 + m*(L^2 + L^2/4)", True), ("J[rod, rod]: m*L^2/12", True), ("J[rod, O]: m*L^2/12", False),
    ("centre[rod].y: -L/2", True), ("centre[rod].x: 0", True), ("centre[rod].y: L/2", False),
    ("stable: true", True), ("stable: false", False), ("equilibrium[phi]: 0", True),
    ("2*M[phi,phi]/m: 2*L^2/3", True), ("omega[1]^2: K[1,1]/M[1,1]", True), ("omega[1]: 2*omega[1]", False)])
def test_answers_about_a_pendulum(line, good):
    assert agrees(PENDULUM, line) is good


def test_motion_of_a_pendulum_in_full():
    plain = PENDULUM.split("springs")[0].replace(", k: 40 N/m, c: 0.7 N*s/m", "")
    assert agrees(plain, "motion[phi]: L*phi'' = -1.5*g*sin(phi)")
    assert not agrees(plain, "motion[phi]: L*phi'' = -1.5*g*phi")
    assert not agrees(plain, "motion[phi]: L*phi'' = 1.5*g*sin(phi)")
    assert not agrees(plain, "motion[phi]: 0*phi'' = 0")


STIFF = """
parameters: {m: 1 kg, k: 210e9 N/m, c: 2 N*s/m, g: 9.81 m/s^2, h: 1 m}
gravity: g
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, -1], by: x}}}
springs: {s: {k: k, between: [[0, h], b]}}
dampers: {d: {c: c, between: [[0, h], b]}}
"""


@pytest.mark.parametrize("line, good", [
    ("motion[x]: m*x'' + c*x' + k*x - m*g = 0", True), ("motion[x]: c*x' + k*x - m*g = 0", False),
    ("motion[x]: m*x'' + k*x - m*g = 0", False), ("motion[x]: m*x'' + c*x' + k*x = 0", False),
    ("equation[x]: m*x'' + c*x' + k*x = 0", True), ("equation[x]: c*x' + k*x = 0", False),
    ("equation[x]: m*x'' + k*x = 0", False), ("V: k/2*x^2 - m*g*x", True), ("V: k/2*x^2", False),
    ("K[x,x]: k", True), ("equilibrium[x]: m*g/k", True), ("equilibrium[x]: 0", False)])
def test_small_terms_beside_a_stiff_spring(line, good):
    assert agrees(STIFF, line) is good


SOFT = """
parameters: {M: 5000 kg, m: 1 kg, k: 900 MN/m, K: 2 N/m}
bodies: {a: {mass: M, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, a]}, t: {k: K, between: [ground, b]}}
"""


@pytest.mark.parametrize("line, good", [
    ("T: M/2*x'^2 + m/2*y'^2", True), ("T: M/2*x'^2 + m/2.01*y'^2", False), ("T: M/2*x'^2", False),
    ("V: k/2*x^2 + K/2*y^2", True), ("V: k/2*x^2", False), ("V: k/2*x^2 + K*y^2", False),
    ("K[x,y]: 0", True), ("K[y,y]: 0", False), ("M[y,y]: 0", False), ("mode[1][y]: 1", True)])
def test_light_parts_beside_heavy_ones(line, good):
    text = SOFT if not line.startswith("mode") else SOFT.replace("a: {mass: M, slide: x}, b: {mass: m, slide: y}",
                                                                "b: {mass: m, slide: y}, a: {mass: M, slide: x}")
    assert agrees(text, line) is good


def test_zero_is_zero_but_for_rounding():
    assert agrees(SOFT, "equilibrium[x]: 0")
    assert not agrees(SOFT.replace("{k: K, between", "{k: K, preload: 1e-4 N, between"), "equilibrium[y]: 0")


def test_symbols_are_checked_at_several_values():
    scene = MASS.replace("m: 2 kg, k: 800 N/m", "m: , k: ")
    assert agrees(scene, "omega[1]: sqrt(k/m)")
    assert not agrees(scene, "omega[1]: k/m*sqrt(m/k)*1.001")
    assert not agrees(scene, "omega[1]: sqrt(2*k/m)")


def test_a_regime_of_uneven_letters_is_found():
    """Beats need kc below a quarter of k."""
    assert all(verdict.agrees for verdict in check(problem("""
parameters: {m: , k: , kc: , x0: }
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s1: {k: k, between: [ground, a]}, s2: {k: kc, between: [a, b]}, s3: {k: k, between: [b, ground]}}
initial: {x: x0}
answers: {beat_period(x): 2*pi/(sqrt((k + 2*kc)/m) - sqrt(k/m))}
""")))


# the command

def file(folder, name, text):
    path = folder / name
    path.write_text(text)
    return str(path)


@pytest.fixture
def files(tmp_path):
    """One file for each exit code."""
    return {0: file(tmp_path, "good.yaml", MASS + "answers: {'omega[1]': 20.0 rad/s}\n"),
            1: file(tmp_path, "differs.yaml", MASS + "answers: {'omega[1]': 21.0 rad/s}\n"),
            3: file(tmp_path, "invalid.yaml", MASS + "answers: {'omega[9]': 21.0 rad/s}\n"),
            4: file(tmp_path, "refused.yaml", MASS + "answers: {'zeta[1]': 0.1}\n"),
            5: file(tmp_path, "nothing.yaml", MASS)}


@pytest.mark.parametrize("codes, expected", [
    ([0], 0), ([1], 1), ([3], 3), ([4], 4), ([5], 5), ([0, 5], 0), ([0, 1], 1), ([1, 4], 4), ([4, 1, 0], 4),
    ([4, 3], 3),
    ([0, 1, 3, 4, 5], 3), ([5, 5], 5), ([1, 5], 1)])
@pytest.mark.parametrize("more", [[], ["--json"], ["--quiet"]])
def test_exit_codes(files, codes, expected, more, capsys):
    assert run(["check", *more, *(files[code] for code in codes)]) == expected
    out = capsys.readouterr().out
    if more == ["--json"]:
        assert [entry["exit_code"] for entry in json.loads(out)] == [0 if code == 5 else code for code in codes]


def test_no_such_file_is_a_matter_of_the_command_line(tmp_path):
    assert run(["check", str(tmp_path / "absent.yaml")]) == 2
    assert run(["check"]) == 2


def test_a_folder_is_walked(files, tmp_path, capsys):
    (tmp_path / "below").mkdir()
    file(tmp_path / "below", "more.yml", MASS + "answers: {'omega[1]': 20.0 rad/s}\n")
    assert run(["check", str(tmp_path), "--json"]) == 3
    assert len(json.loads(capsys.readouterr().out)) == 6


def test_what_is_printed(files, capsys):
    run(["check", files[0], files[1]])
    out = capsys.readouterr().out
    assert "✓ omega[1]" in out
    assert "✗ omega[1]: expected 21, found 20 (ratio 1.05)  [line 5]" in out
    assert "1 answers agree, 1 differ in 2 files" in out or "1 answer agrees, 1 differs in 2 files" in out


def test_cases_are_checked(tmp_path, capsys):
    text = MASS + "cases:\n  stiff: {parameters: {k: 1800 N/m}, answers: {'omega[1]': 30.0 rad/s}}\n"
    path = file(tmp_path, "cases.yaml", text)
    assert run(["check", path, "--json"]) == 0
    answer, = json.loads(capsys.readouterr().out)[0]["answers"]
    assert (answer["case"], answer["agrees"], answer["found"]) == ("stiff", True, 30.0)


@pytest.mark.parametrize("setting", ["g=10", "g=10 m/s^2", "g=1000 cm/s^2"])
def test_a_bare_number_takes_the_whole_unit_of_the_file(tmp_path, capsys, setting):
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}\ngravity: g\n"
                    "bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}\n")
    assert run(["frequencies", str(path), "--set", setting, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["modes"][0]["omega"] == pytest.approx(10**0.5, rel=1e-15)


def test_a_set_value_is_shown_with_its_unit(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 1 kg, k: {unit: kN/m}}\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\n")
    assert run(["solve", str(path), "--set", "k=4"]) == 0
    assert "k = 4 kN/m" in capsys.readouterr().out


@pytest.mark.parametrize(("k", "m"), [(1, 1), (3, 7), (812.3, 0.37), (2e5, 1234.5), (1e-3, 9), (7e11, 0.01)])
@pytest.mark.parametrize("digits", [15, 16, 17])
def test_numbers_printed_in_full_agree(k, m, digits):
    """Numbers pasted from another program, to the digits of a double, agree; 20 ε beside them they do not."""
    scene = MASS.replace("2 kg", f"{m} kg").replace("800 N/m", f"{k} N/m")
    for head, value in (("omega", (k / m) ** 0.5), ("frequency", (k / m) ** 0.5 / (2 * math.pi)),
                        ("period", 2 * math.pi / (k / m) ** 0.5)):
        unit = {"omega": "rad/s", "frequency": "Hz", "period": "s"}[head]
        assert agrees(scene, f"{head}[1]: {value:.{digits}g} {unit}")
        assert not agrees(scene, f"{head}[1]: {value * (1 + 3e-13):.{digits}g} {unit}")


def test_the_frequency_of_a_turn_in_a_second():
    unit = MASS.replace("2 kg", "1 kg").replace("800 N/m", "1 N/m")
    assert agrees(unit, "frequency[1]: 0.1591549430918953 Hz")
    assert agrees(unit, "frequency[1]: 0.15915494309189533576888376337251436 Hz")


@pytest.mark.parametrize(("expected", "words"), [
    ("20.00000000001", "expected 20.00000000001, found 20 (off by 5e-13 of it)"),
    ("20.000001", "expected 20.000001, found 20 (off by 5e-08 of it)"),
    ("20.1", "expected 20.1, found 20 (ratio 1.005)"), ("19.99999999999999", ""),
    ("20.0000000000003", "expected 20.0000000000003, found 20 (off by 1.5e-14 of it)")])
def test_a_difference_is_printed_to_the_digits_in_which_it_shows(expected, words, tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text(MASS + f"answers: {{'omega[1]': {expected} rad/s}}\n")
    assert run(["check", str(file)]) == bool(words)
    assert words in capsys.readouterr().out


SLIGHT = """
parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m, L: 0.5 m, g: 9.81 m/s^2, e: SLIGHT}
gravity: g
points: {O: [0, 0], A: {body: rod, at: [0, -L]}}
bodies:
  rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: O, by: phi}}
  fixed: {shape: rod, mass: m, from: [0, 0], to: [e*L, -L]}
  one: {mass: m, at: [2*L, 0], slide: x}
  two: {mass: m, at: [4*L, 0], slide: y}
springs:
  s: {k: k, between: [[1.5*L, 0], one]}
  t: {k: k*(1 + e), between: [[4.5*L, 0], two]}
dampers:
  d: {c: c, between: [[1.5*L, 0], one]}
energies: {T: e*m*x'*y', V: e*k*x*y, Phi: e*c*x'*y'}
forces: {P: {at: A, force: [e*m*g, 0]}, F: {at: one, force: [e*m*g, 0]}}
"""
ZEROS = ["K[x,y]: 0", "C[x,y]: 0", "M[x,y]: 0", "equilibrium[x]: 0", "equilibrium[phi]: 0",
         "equilibrium[rod.reaction.x]: 0", "equilibrium[s.force]: 0", "equilibrium[one.x]: 0", "centre[fixed].x: 0",
         "omega[2]^2 - omega[3]^2: 0", "K[x,y]/K[x,x]: 0"]


@pytest.mark.parametrize("line", ZEROS)
def test_zero_is_zero_to_rounding(line):
    """Beside what is as large as it may be a millionth is no zero."""
    assert agrees(SLIGHT.replace("SLIGHT", "0"), line)
    assert not agrees(SLIGHT.replace("SLIGHT", "1e-6"), line)


DRIVEN = """
parameters: {e: SLIGHT, w: 3 rad/s}
bodies: {one: {mass: 2 kg, slide: x}, two: {mass: 3 kg, slide: y}}
springs: {s: {k: 80 N/m, between: [ground, one]}, t: {k: 70 N/m, between: [ground, two]}}
dampers: {d: {c: 4 N*s/m, between: [ground, one]}, f: {c: 5 N*s/m, between: [ground, two]}}
forces: {F: {at: one, force: 3 N*sin(w*t)}, G: {at: two, force: 3 N*e*sin(w*t)}}
"""


@pytest.mark.parametrize("line", [
    "amplitude(y): 0", "y(1 s): 0", "max(t.force): 0", "min(y'): 0", "final(transient(y)): 0", "rms(y): 0",
    "abs(frf[y, G](3 rad/s))*e: 0 m/N", "steady(y)(2 s): 0"])
def test_signals_are_zero_to_rounding(line):
    """Signals by the size of their own kind, or of nothing at all."""
    slight = agrees(DRIVEN.replace("SLIGHT", "1e-6"), line)
    assert agrees(DRIVEN.replace("SLIGHT", "0"), line)
    assert slight is line.startswith("final")


@pytest.mark.parametrize("name", ["double_pendulum", "two_storeys", "slider_crank"])
def test_random_states_are_within_reach(name):
    """Coordinates one reach about the drawn position, velocities three of them, accelerations nine; each group of its
    kind alone: all, at rest, very near at rest, with a velocity alone, with an acceleration alone."""
    given = problem_of(scenes.path(name))
    found, groups = states(given)
    seen = {name + "'" * k: 0.0 for name in given.scene.coordinates for k in range(3)}
    for name in given.scene.coordinates:
        for k, most in enumerate((1, 3, 9)):
            away = abs(found[name + "'" * k] - (0 if k else given.numeric.drawn_floats[name])) / reach(given, name)
            assert most / 2 < max(away) <= most
            seen[name + "'" * k] = [bool(max(away[group])) for group in groups]
    kinds = {tuple(any(seen[name + "'" * k][i] for name in given.scene.coordinates) for k in range(3))
             for i in range(len(groups))}
    assert kinds == {(True, True, True), (True, False, False), (False, True, False), (False, False, True)}
    moving = [sum(any(seen[name + "'" * k][i] for k in range(3)) for name in given.scene.coordinates)
              for i in range(len(groups))]
    assert {1, len(given.scene.coordinates)} == set(moving)


PASSING = """
parameters: {m: 2, k: 200, c: 4, F: 5, W: 6}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
forces: {f: {at: b, force: F*sin(W*t)}}
initial: {x: 0.03, x': 0.1}
motion: full
"""
TURNS = 0.03384973285088846     # where x' passes zero


@pytest.mark.sweep
@pytest.mark.parametrize("asked", [f"T({TURNS})", "min(T)", f"x'({TURNS})"])
def test_a_number_near_zero_agrees_with_zero_alone(asked):
    """The error of what is found is absolute: as a part of a number near zero it may be more than all of it."""
    for other in ("2", "0.123456789", "-1e-6", "m/4"):
        assert not agrees(PASSING, f"{asked}: {other}"), other
    assert agrees(PASSING, f"{asked}: 0")
