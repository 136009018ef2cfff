"""Modes of scenes with members as they are told: normalised, with nodes, the count that proves them, and in --json."""

import json
import warnings
from itertools import pairwise
from math import pi, sqrt

import mpmath
import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.report.document import Report
from vibcli.report.formats.text import render
from vibcli.report.sections.member_modes import member_shapes

BAR = "    bars: {rod: {length: 2 m, EA: 2e6 N, mass_per_length: 2 kg/m, left: clamped%s}}"
CANTILEVER = """
    beams:
      wing: {length: 0.6 m, EI: 56 N*m^2, mass_per_length: 0.27 kg/m, left: clamped,
             attached: [{at: 0.6 m, mass: 0.05 kg}]}
"""


def told(scene, *names):
    report = Report(scene)
    for name in names or ("equilibrium", "frequencies", "damping", "modes"):
        report.add(name)
    assert report.refusal is None
    return render([report.document()])


def cantilever(index):
    """(largest |u|, its place, nodes) of a cantilever with a tip mass, the tip moving by 1, in mpmath."""
    ratio = mpmath.mpf("0.05") / mpmath.mpf("0.162")

    def equation(y):
        return 1 + mpmath.cos(y) * mpmath.cosh(y) + ratio * y * (
            mpmath.cos(y) * mpmath.sinh(y) - mpmath.sin(y) * mpmath.cosh(y))

    y = mpmath.findroot(equation, [1.5, 4.2, 7.25][index - 1])
    mix = (mpmath.cosh(y) + mpmath.cos(y)) / (mpmath.sinh(y) + mpmath.sin(y))

    def shape(x):
        return mpmath.cosh(y * x) - mpmath.cos(y * x) - mix * (mpmath.sinh(y * x) - mpmath.sin(y * x))

    grid = [mpmath.mpf(i) / 200 for i in range(1, 201)]

    def slope(x):
        return mpmath.diff(shape, x)

    nodes, turns = ([mpmath.findroot(f, pair, solver="anderson") for pair in pairwise(grid)
                     if f(pair[0]) * f(pair[1]) < 0] for f in (shape, slope))
    top = max([mpmath.mpf(1), *turns], key=lambda x: abs(shape(x)))
    return shape(top) / shape(1), 0.6 * top, [0.6 * x for x in nodes]


@pytest.mark.sweep
@pytest.mark.parametrize("index", [1, 2, 3])
def test_the_largest_displacement_of_a_member_is_one(index, capsys, tmp_path):
    path = tmp_path / "wing.yaml"
    path.write_text(CANTILEVER, encoding="utf-8")
    assert run(["frequencies", str(path), "--json", "--modes", "3"]) == 0
    mode = json.loads(capsys.readouterr().out)["modes"][index - 1]
    largest, place, nodes = cantilever(index)
    wing = mode["members"]["wing"]
    assert mode["shape"]["wing.u(0.6 m)"] == pytest.approx(float(1 / largest), rel=1e-12)
    assert wing["nodes"] == pytest.approx(list(map(float, nodes)), rel=1e-12)
    assert max(wing["u"]) == pytest.approx(1, rel=1e-13)
    assert wing["x"][wing["u"].index(max(wing["u"]))] == pytest.approx(float(place), rel=1e-7)
    assert wing["shear"][-1] == pytest.approx(-0.05 * mode["omega"] ** 2 * mode["shape"]["wing.u(0.6 m)"], rel=1e-9)


def test_a_scene_without_coordinates_has_modes():
    scene = problem(BAR % ", right: clamped")
    assert not scene.scene.q
    text = told(scene)
    assert "J = 5 just above ω₅: none is missing" in text and "(the drawn position)" in text
    assert "Modes along rod" in text
    assert "(the first coordinate that moves is 1, those of members aside, where none does the largest" in text
    assert "  3     1          0.333333  0.666667, 1.33333" in text
    for i in (1, 2, 40):
        assert value(scene, f"omega[{i}]") == pytest.approx(500 * i * pi, rel=2e-15)
    assert value(scene, "stable") is True


@pytest.mark.sweep
def test_a_member_that_rests_in_a_mode_is_told_with_all_its_digits():
    """Two bars with a mass amid, tied there: in mode 3 one moves and the other rests."""
    halves = ("length: L, EA: 4 MN, mass_per_length: 2 kg/m, left: clamped, right: clamped, "
              "attached: [{at: L/2, mass: m}]")
    scene = problem(f"""
        parameters: {{L: 2 m, m: 3 kg, k: 500 N/m}}
        bars: {{a: {{{halves}}}, b: {{{halves}}}}}
        points: {{p: {{body: a, at: L/2}}, q: {{body: b, at: L/2}}}}
        springs: {{s: {{k: k, between: [p, q]}}}}
    """)
    assert "Modes along b" in told(scene)
    assert [value(scene, f"omega[{i}]") for i in (3, 4)] == pytest.approx([pi * sqrt(2e6)] * 2, rel=1e-14)


@pytest.mark.sweep
def test_shapes_along_members_are_told_apart_from_that_of_a_close_frequency():
    """Two cantilevers alike, tied so weakly that shapes in floats are mixed by 2e-4: they move alike and opposed."""
    cantilever = "length: 1 m, EI: 3 N*m^2, mass_per_length: 1 kg/m, left: clamped"
    scene = problem(f"""
        beams: {{a: {{{cantilever}}}, b: {{{cantilever}}}}}
        points: {{p: {{body: a, at: 1 m}}, q: {{body: b, at: 1 m}}}}
        springs: {{s: {{k: 1e-11 N/m, between: [p, q]}}}}
        find: [{{modes: 2}}]
    """)
    text = told(scene).partition("Modes along b")[2]
    assert "  1     1          1         none" in text and "  2     -1         1         none" in text
    for mode, end in ((1, 1), (2, -1)):
        assert member_shapes(scene, mode, "first")["b"]["u"][-1] == pytest.approx(end, rel=1e-13)


@pytest.mark.parametrize("further", [", right: {c: 3 N*s/m}", ", drag: 3 Pa*s"])
def test_the_frequency_equation_leaves_dampers_out_and_says_so(further):
    assert "Frequency equation (of the undamped system)" in told(problem(BAR % further), "frequency_equation")
    assert "Frequency equation\n" in told(problem(BAR % ""), "frequency_equation")


@pytest.mark.sweep
def test_the_normalisation_of_damped_shapes_is_stated_by_what_is_printed():
    """No displacement along members is 1 in them, but the first or largest row."""
    scene = problem("beams: {b: {length: 2 m, EI: 300 N*m^2, mass_per_length: 2 kg/m, left: pinned, "
                    "right: {c: 3 N*s/m, k: 90 N/m}}}")
    for how, stated in (("first", "the first of these that moves is 1"),
                        ("largest", "the largest of these amplitudes is 1")):
        report = Report(scene, normalise=how)
        report.add("modes")
        shapes = " ".join(render([report.document()]).split("Shapes of the damped modes")[1].split())
        assert stated in shapes and "displacement" not in shapes
        rows = [[abs(x) for x in scene.modal.shape(mode, how)] for mode in scene.modal.damped[:3]]
        assert all((row[0] if how == "first" else max(row)) == pytest.approx(1, rel=1e-14) for row in rows)


@pytest.mark.sweep
def test_a_tension_that_varies_has_no_wave_number():
    chain = "{from: [0 m, 0 m], to: [0 m, -2 m], mass_per_length: 1 kg/m, left: clamped}"
    assert "β" not in told(problem(f"gravity: 9.81 m/s^2\nstrings: {{chain: {chain}}}"), "frequencies")


def test_nothing_moves_where_nothing_can():
    with pytest.raises(PhysicsError, match="nothing moves in this scene"):
        value(problem("    bars: {rod: {length: 2 m, EA: 2e6 N, left: clamped, right: clamped}}"), "omega[1]")


def test_the_count_from_one_number_to_another():
    text = told(problem(BAR % "" + "\n    find: [{modes: [990, 1000]}]"))
    assert "J = 1000 just above ω₁₀₀₀: none is missing" in text


@pytest.mark.sweep
def test_two_alike_are_counted_together():
    text = told(problem("""
        bars:
          one: {length: 2 m, EA: 2e6 N, mass_per_length: 2 kg/m, left: clamped}
          two: {length: 2 m, EA: 2e6 N, mass_per_length: 2 kg/m, left: clamped}"""))
    assert "repeated to 15 digits" in text and "J = 6 just above ω₅ ≈ ω₆: none is missing" in text


@pytest.mark.sweep
def test_the_first_of_some_may_be_alike_to_one_that_is_not_told():
    beam = "{length: 1 m, EI: 10 N*m^2, mass_per_length: 1 kg/m, left: clamped}"
    text = told(problem(f"beams: {{one: {beam}, two: {beam}}}\nfind: [{{modes: [2, 3]}}]"), "frequencies")
    assert "repeated" in next(line for line in text.splitlines() if line.strip().startswith("2 "))


def test_the_two_eigenvalues_of_an_over_damped_mode_are_told_as_such():
    beam = "beams: {one: {length: 1 m, EI: 10 N*m^2, mass_per_length: 1 kg/m, left: clamped}}\ndamping: {modal: %s}"
    texts = [told(problem(beam % ratio), "damping") for ratio in ("200 %", "50 %")]
    assert ["of an over-damped mode ω = √(λ₁λ₂)" in text for text in texts] == [True, False]


def test_coordinates_of_the_file_come_first():
    scene = problem("""
        bodies: {block: {mass: 3 kg, slide: x}}
        bars: {rod: {length: 2 m, EA: 2e6 N, mass_per_length: 2 kg/m, left: clamped, right: {clamped: block}}}""")
    assert [value(scene, f"mode[{i}][x]") for i in (1, 2, 3)] == [1.0, 1.0, 1.0]
    y = value(scene, "omega[2]") * sqrt(2 / 2e6) * 2
    inner = 2 * 2 * (0.5 - float(mpmath.sin(2 * y)) / (4 * y)) / float(mpmath.sin(y)) ** 2
    assert value(scene, "modal_mass[2]") == pytest.approx(3 + inner, rel=1e-12)


def test_the_modal_mass_of_a_bar_alone_is_half_of_it():
    scene = problem(BAR % "")
    assert [value(scene, f"modal_mass[{i}]") for i in (1, 7)] == pytest.approx([2.0, 2.0], rel=1e-13)


def test_damped_modes_of_members_are_told_with_their_number():
    scene = problem(BAR % ", right: {c: 5 N*s/m}")
    assert "of the undamped system" in told(scene, "frequencies")
    assert "by the argument principle: none is missing" in " ".join(told(scene, "damping").split())
    with pytest.raises(PhysicsError, match="in floats alone"):
        scene.modal.damped_to(30)


def test_a_matched_damper_leaves_no_mode():
    scene = problem(BAR % ", right: {c: 2000 N*s/m}")
    assert scene.modal.damped.finite and not scene.modal.damped


def test_parts_without_inertia_are_springs_in_what_is_told():
    scene = problem("""
        bars:
          rod: {segments: [{length: 1 m, EA: 1e6 N, mass_per_length: 2 kg/m}, {length: 1 m, EA: 2e6 N}], left: clamped,
                attached: [{at: 2 m, mass: 3 kg}]}""")
    written = told(scene, "energies", "equations", "frequency_equation", "frequencies", "modes")
    first = mpmath.findroot(lambda y: y * mpmath.tan(y) - mpmath.mpf(2) / 3 + y * y / 2, 0.63)
    assert f"βL = {float(first):.10g}, 2.39747" in written and "1.154" not in written
    assert value(scene, "omega[1]") == pytest.approx(float(first) * sqrt(1e6 / 2), rel=1e-13)


def test_a_member_that_turns_in_equilibrium_has_no_equations_in_letters_but_modes():
    scene = problem("""
        gravity: 9.81 m/s^2
        beams:
          arm: {from: [0, 0], to: [1.2 m, 0], EI: 2400 N*m^2, mass_per_length: 3 kg/m, left: clamped,
                right: {clamped: motor}}
        bodies:
          motor: {mass: 5 kg, at: [1.2 m, 0], move: [0, y, psi]}
          bob: {mass: 1 kg, at: [1.2 m, -0.3 m], pin: {at: [1.2 m, 0], carrier: motor, by: phi}}""")
    written = told(scene, "energies", "equations", "frequency_equation", "frequencies", "modes")
    assert "not found in letters, as the equilibrium is not" in written
    assert "  1     0          –         rests" in written
    assert value(scene, "omega[1]") == pytest.approx(sqrt(9.81 / 0.3), rel=1e-12)


def test_what_no_spring_touches_is_free_beside_what_moves_along_a_bar():
    """A bar that floats: across at both ends, along, and the turn of a body by itself; the rest is held."""
    modes = problem("""
    bodies: {cart: {mass: 4, slide: x}, block: {mass: 3, inertia: 1, at: [2, 0], move: [X, Y, psi]}}
    springs: {s: {k: 30, between: [cart, ground]}, t: {k: 200, between: [block, [2, 3]]},
              u: {k: 100, between: [block, [5, 0]]}}
    bars: {rod: {from: [0, 0], to: [2, 0], EA: 500, mass_per_length: 2, attached: [{at: 2, mass: 3}]}}
""").modal.modes
    assert [modes[i].omega for i in range(4)] == [0.0] * 4 < [modes[4].omega]
    assert modes[4].omega == pytest.approx(sqrt(30 / 4), rel=1e-13)


def test_a_thick_beam_is_told_once_whether_an_equilibrium_is_told_or_not():
    scene = problem("beams: {arm: {length: 1 m, E: 11 GPa, rho: 600 kg/m^3, section: {rectangle: [0.3 m, 0.15 m]}, "
                    "left: clamped}}")
    for names in (("frequencies",), ("equilibrium", "frequencies", "modes")):
        assert told(scene, *names).count("'arm' is thick: L/h is 6.67") == 1


def test_a_beam_that_sags_far_is_told_once_whether_an_equilibrium_is_told_or_not():
    """The slope at the free end of a cantilever under its weight is μgL³/(6EI)."""
    scene = problem("gravity: 10 m/s^2\nbeams: {arm: {from: [0, 0], to: [1 m, 0], EI: 3 N*m^2, "
                    "mass_per_length: 0.9 kg/m, left: clamped}}")
    for names in (("frequencies",), ("equilibrium", "frequencies", "modes")):
        assert told(scene, *names).count("'arm' turns by 0.5 rad in equilibrium") == 1


ROD = """
    parameters: {L: , EA: , mu: }
    bars:
      rod: {left: clamped, %s}
      %s
"""


@pytest.mark.parametrize(("rod", "more", "written"), [
    ("segments: [{length: L, EA: EA, mass_per_length: mu}, {length: 2*L, EA: EA, mass_per_length: 3*mu}]", "",
     "∫μ·X_i·X_j·dx (0 < x < L) + ∫3·μ·X_i·X_j·dx (L < x < 3·L) = 0"),
    ("length: L, EA: EA, mass_per_length: mu",
     "more: {left: {clamped: rod, at: L}, length: L, EA: 2*EA, mass_per_length: mu}",
     "∫μ·X_i·X_j·dx (rod) + ∫μ·X_i·X_j·dx (more) = 0")])
def test_orthogonality_tells_on_which_stretch_and_member_each_integral_is(rod, more, written):
    """By parts on every stretch: the forces between them cancel, whatever stretches belong together."""
    assert written in told(problem(ROD % (rod, more)), "frequency_equation")


@pytest.mark.parametrize("command", [["solve"], ["frequencies", "--json"], ["frequencies", "--digits", "20"]])
def test_beside_a_bar_a_mechanism_is_told_by_its_name(command, tmp_path, capsys):
    """Of rigid motions, one without inertia is no mode whose shape more digits would find."""
    path = tmp_path / "bar.yaml"
    path.write_text("bodies: {a: {mass: 0 kg, slide: x}, b: {mass: 10 kg, slide: y}}\n"
                    "bars: {rod: {length: 1 m, EA: 1 N, mass_per_length: 0.1 kg/m, left: free, right: pinned}}\n")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert run([*command, str(path)]) == 4
    assert "error: 'x' has no inertia and no spring ties it" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["tip", "t", "motor"])
def test_an_end_at_a_name_that_is_no_point_of_the_ground_is_refused(name, tmp_path, capsys):
    path = tmp_path / "strut.yaml"
    path.write_text("bodies: {motor: {mass: 1 kg, inertia: 1 kg*m^2, at: [0, 1 m], move: [x, y, p]}}\n"
                    f"beams: {{strut: {{from: [0, 0], to: {name}, EI: 1 N*m^2, EA: 1 N, mass_per_length: 1 kg/m, "
                    "left: clamped, right: {clamped: motor}}}\n")
    assert run(["solve", str(path)]) == 3
    assert f"strut.yaml:2:{len('beams: {strut: {from: [0, 0], to: ') + 1}: error" in capsys.readouterr().err


@pytest.mark.sweep
def test_a_chain_drawn_from_its_free_end_up_moves_as_one_that_is_drawn_down():
    up, down = (problem(f"""
        gravity: 9.81 m/s^2
        strings: {{b: {{from: [0, 0], to: [0, {to} m], mass_per_length: 2 kg/m, {side}: pinned}}}}
        """) for to, side in (("0.6", "right"), ("-0.6", "left")))
    for one, two in zip(up.modal.modes.first(3), down.modal.modes.first(3), strict=True):
        (first, second), scale = (found.modal.fields(mode) for found, mode in ((up, one), (down, two))), 0.6
        assert first.node_places("b") == pytest.approx([scale - x for x in second.node_places("b")[::-1]])
        for x in (0.0, 0.2, 0.45):
            (u, slope, bent), (v, turn, twice) = (
                [part / fields.at("b", end)[0] for part in fields.at("b", at)]
                for fields, end, at in ((first, 0.0, x), (second, scale, scale - x)))
            assert (u, slope) == pytest.approx((v, -turn)) and (x == 0 or bent == pytest.approx(twice))
    z = 2 * float(up.modal.modes[0].omega) * sqrt(0.6 / 9.81)
    u, slope, bent = up.modal.fields(up.modal.modes[0]).at("b", 0.0)
    assert (slope / u, bent / u) == pytest.approx((-z**2 / 4 / 0.6, z**4 / 32 / 0.36))
