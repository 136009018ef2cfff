"""Whole scenes shaken: written otherwise they rest, swing and answer as before, and one that does not is seen."""

import json
from functools import partial

import pytest
from rooms.evidence.test_stress import scene_read_again
from support.scenes import problem

from vibcli.cli.program import run
from vibcli.evidence.stress import whole_scene
from vibcli.evidence.stress.read_again import read_again
from vibcli.evidence.stress.rewritten import decimal_of, in_parallel, reordered, scaled, with_numbers
from vibcli.evidence.stress.shaken import BROKEN, EQUAL, REFUSED, WITHIN
from vibcli.language.document.document import read_file
from vibcli.language.document.nodes import Scalar

CHAIN = {"parameters": {"m": "2 kg", "k": "310 N/m", "w": "1.3 Hz"},
         "bodies": {"a": {"mass": "m", "slide": "x"}, "b": {"mass": "3*m", "slide": "y"}},
         "springs": {"s": {"law": "k*d + (2 N/mm^3)*d^3", "between": ["ground", "a"]},
                     "t": {"k": "2*k", "between": ["a", "b"]}},
         "dampers": {"c": {"c": "4 N*s/m", "between": ["ground", "b"]}},
         "forces": {"f": {"at": "b", "force": "(20 N)*sin(2*pi*w*t) + 30 N"}}, "motion": "small",
         "answers": {"omega[1]": "1 rad/s", "x(0.5 s)": "1 cm", "max(y)": "1 cm", "zeta[2]": "0.1", "stable": "true",
                     "amplitude(x)": "1 cm", "s.force(0.5 s)": "1 N", "mode[1][y]": "2"}}


def shaken(scene):
    problem, _, remade = scene_read_again(scene)
    return {one.change: one for one in whole_scene.shaken_as_a_whole(problem, remade)}


@pytest.mark.sweep
def test_where_units_change_by_powers_of_two_every_bit_of_rest_and_modes_stays():
    found = shaken(CHAIN)
    assert {change: one.verdict for change, one in found.items() if one.verdict not in (EQUAL, WITHIN)} == {}
    assert all(one.verdict == EQUAL for change, one in found.items() if "×" in change and "answers" not in change)
    assert found["lengths × 4: answers"].compared == 6 and found["springs as two in parallel: answers"].compared == 5
    assert found["times × 4: modes"].compared == 4 and found["masses × 4: rest"].compared == 2


@pytest.mark.sweep
@pytest.mark.parametrize("condition", ["max(y) = 11.5 cm", "omega[1] = 11.73 rad/s"])
def test_what_is_chosen_follows_its_condition(condition):
    """By a search and in closed form; 11.5 cm and 11.73 rad/s are of other units, too."""
    found = shaken({
        "bodies": {"b": {"mass": "1.25 kg", "slide": "y"}}, "springs": {"t": {"k": "h", "between": ["ground", "b"]}},
        "initial": {"y'": "1.35 m/s", "y": "0 m"}, "find": [{"response": {"until": "0.3 s"}}],
        "choose": {"h": condition}, "answers": {"h": "172 N/m", "omega[1]": "11.7 rad/s"}})
    assert {one.verdict for one in found.values()} <= {EQUAL, WITHIN}
    assert found["lengths × 4: answers"].compared == found["times × 4: answers"].compared == 2


@pytest.mark.parametrize(("law", "broken"), [
    (whole_scene.SceneLaw("lengths × 4", partial(with_numbers, change=scaled(1, 0, 1)), (1, 0, 0)), ["modes"]),
    (whole_scene.SceneLaw("a figure moved", partial(with_numbers, change=lambda number, text: (
        "311" if number.value == 310 else None))), ["rest", "modes", "answers"]),
    (whole_scene.SceneLaw("a bit of another scale", partial(with_numbers, change=lambda number, text: (
        decimal_of(number.value * 5) if number.units else None)), (0, 0, 0)), ["answers"])])
def test_a_law_that_does_not_hold_is_broken(law, broken, monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", (law,))
    assert {f"{law.name}: {what}" for what in broken} <= {
        change for change, one in shaken(CHAIN).items() if one.verdict == BROKEN}


def test_what_is_asked_of_a_spring_by_its_name_is_another_thing_where_it_is_two(monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", [law for law in whole_scene.LAWS if law.change is in_parallel])
    found = shaken({**CHAIN, "answers": {"law[s, d^3]": "2 N/mm^3", "omega[1]": "1 rad/s"}})
    assert found["springs as two in parallel: answers"].compared == 1
    assert BROKEN not in {one.verdict for one in found.values()}


def test_what_is_chosen_by_the_name_of_a_spring_is_refused_where_that_is_two(monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", [law for law in whole_scene.LAWS if law.change is in_parallel])
    one, = shaken({"parameters": {"g": "9.81 m/s^2"}, "gravity": "g",
                   "choose": {"k": "equilibrium[s.force]^2 = k*1 N*m"},
                   "bodies": {"b": {"mass": "2 kg", "at": ["0", "-1 m"], "slide": {"along": ["0", "-1"], "by": "y"}}},
                   "springs": {"s": {"k": "k", "between": [["0", "0"], "b"]}}, "answers": {"k": "385 N/m"}}).values()
    assert one.verdict == REFUSED and "by name" in one.why


@pytest.mark.sweep
def test_a_rate_at_a_limit_of_stability_may_be_what_rounding_leaves(monkeypatch):
    """A rod upright on a torsion spring: m g L/2 = k."""
    found = shaken({"parameters": {"g": "9.81 m/s^2"}, "gravity": "g", "choose": {"k": "stability limit"},
                    "bodies": {"b": {"shape": "rod", "mass": "1.3 kg", "from": ["0", "0"], "to": ["0", "0.7 m"],
                                     "pin": {"at": ["0", "0"], "by": "p"}}, "c": {"mass": "1 kg", "slide": "x"}},
                    "springs": {"s": {"torsion": "k", "between": ["ground", "b"]},
                                "t": {"k": "90 N/m", "between": ["ground", "c"]}}, "answers": {"k": "4.46 N*m"}})
    assert BROKEN not in {one.verdict for one in found.values()} and found["masses × 4: modes"].compared == 2


@pytest.mark.parametrize(("choose", "vanishing", "others"), [
    ("parameters: {k: 9 N/m}", 0, 0), ("choose: {k: 'omega[1] = 3 rad/s'}", 2.0**-40, 2.0**-40),
    ("choose: {k: stability limit}", 2.0**-26, 2.0**-40), ("choose: {k: 'K[x,x] = 0'}", 2.0**-26, 2.0**-40)])
def test_what_is_chosen_moves_rates_little_but_those_that_vanish_at_a_limit(choose, vanishing, others):
    felt = whole_scene._felt(problem("bodies: {b: {mass: 2 kg, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
                                     + choose), 8.0)
    assert felt(0.0) == felt(2.0**-23) == 8 * vanishing and felt(2.0**-22) == felt(8.0) == 8 * others


@pytest.mark.parametrize(("key", "told"), [("equilibrium[mast.u(1 m)]", False), ("equilibrium[mast.u(L/2)]", True),
                                           ("x(2 s)", True), ("frf[b.u(L/2), F](5 Hz)", True)])
def test_places_in_numbers_within_brackets_stay_where_lengths_grow(key, told):
    assert whole_scene._is_told(key, whole_scene.LAWS[0], None, ()) is told


def test_where_another_coordinate_begins_at_rest_motions_are_others(monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", [law for law in whole_scene.LAWS if law.change is reordered])
    found = shaken({"bodies": {"a": {"mass": "2 kg", "slide": "x"}, "b": {"mass": "1 kg", "slide": "y"}},
                    "springs": {"s": {"k": "80 N/m", "between": ["ground", "a"]}},
                    "constraints": {"tie": {"equation": "y = x + (2 cm)*sin(3 rad/s*t)"}},
                    "answers": {"y(1 s)": "1 cm"}})
    assert found["elements reordered: answers"].verdict == REFUSED
    assert found["elements reordered: modes"].verdict in (EQUAL, WITHIN)


def test_entries_by_the_numbers_of_coordinates_are_others_in_another_order(monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", [law for law in whole_scene.LAWS if law.change is reordered])
    found = shaken({**CHAIN, "answers": {"M[1,1]": "2 kg", "K[x,y]": "1 N/m", "omega[1]": "1 rad/s"}})
    assert found["elements reordered: answers"].compared == 2 and BROKEN not in {one.verdict for one in found.values()}


def test_modal_masses_are_others_where_another_coordinate_is_the_first(monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", [law for law in whole_scene.LAWS if law.change is reordered])
    found = shaken({**CHAIN, "answers": {"modal_mass[1]": "2 kg", "omega[1]": "1 rad/s"}})
    assert found["elements reordered: answers"].compared == 1 and BROKEN not in {one.verdict for one in found.values()}


@pytest.mark.sweep
def test_what_consists_of_parts_is_two_of_half_of_each_and_turns_beside_what_slides():
    """No length measures how far a block slides beside a disc that turns: its place is compared within its bound."""
    found = shaken({
        "bodies": {"block": {"mass": "2 kg", "slide": "x"}, "disc": {"inertia": "0.5 kg*m^2", "turn": "phi"}},
        "springs": {"s": {"series": [{"k": "800 N/m"}, {"law": "(800 N/m)*d + (2e5 N/m^3)*d^3"}, {"parallel": [
            {"k": "800 N/m"}, {"series": [{"k": "800 N/m"}] * 2}]}], "between": ["ground", "block"]},
            "shaft": {"series": [{"torsion": "30 N*m"}, {"torsion": "true", "law": "(30 N*m)*d^3"}],
                      "between": ["ground", "disc"]}},
        "forces": {"pull": {"at": "block", "force": "24 N"}, "twist": {"body": "disc", "moment": "6 N*m"}},
        "motion": "small", "answers": {"equilibrium[phi]": "0.78", "equilibrium[x]": "5 cm"}})
    assert {one.verdict for one in found.values()} <= {EQUAL, WITHIN}
    assert found["springs as two in parallel: answers"].compared == 2 == found["masses × 4: rest"].compared


POINTS = [["-3 mm", "-6 N"], ["0", "0"], ["2 mm", "3.1 N"], ["5 mm", "14 N"]]


@pytest.mark.parametrize(("law", "refused"), [
    (POINTS, 0), ({"table": POINTS, "beyond": "linear"}, 0), ({"table": "t.csv", "units": ["mm", "N"]}, 4)])
def test_tables_of_a_scene_are_shaken_with_it_and_those_of_a_file_stay_as_they_were_measured(law, refused, tmp_path):
    (tmp_path / "t.csv").write_text("".join(f"{d.split()[0]},{force.split()[0]}\n" for d, force in POINTS))
    file = tmp_path / "s.yaml"
    file.write_text(json.dumps({
        "bodies": {"b": {"mass": "2.5 kg", "at": ["0.3 m", "0 m"], "slide": "x"}},
        "springs": {"s": {"law": law, "between": [["0 m", "0 m"], "b"], "free_length": "0.3 m"}},
        "forces": {"f": {"at": "b", "force": ["2 N", "0 N"]}}, "motion": "small", "answers": {"omega[1]": "26 rad/s"}}))
    _, remade = read_again(read_file(str(file))[0], str(file), {}, None)
    found = {one.change: one for one in whole_scene.shaken_as_a_whole(remade(lambda same: same), remade)}
    assert [one.verdict for one in found.values()].count(REFUSED) == refused
    assert {one.verdict for one in found.values()} <= {EQUAL, WITHIN, REFUSED} and len(found) == 18 - 2 * refused


def test_numbers_without_units_and_what_cannot_be_read_are_refused():
    plain = {"matrices": {"M": [["9", "0"], ["0", "1"]], "K": [["27", "-3"], ["-3", "3"]]},
             "coordinates": {"x": "one", "y": "two"}, "answers": {"omega[2]": "2"}}
    found = shaken(plain)
    assert [one.verdict for one in found.values()][:3] == [REFUSED] * 3 and found["elements reordered: modes"].compared


@pytest.mark.parametrize(("unit", "load", "refused"), [("N", "f(t)", 3), ("m/s^2", "-m*f(t)", 2)])
def test_a_record_is_not_scaled_and_so_nothing_is_called_broken(unit, load, refused, tmp_path, capsys):
    """That of a force has all units in it, that of an acceleration no masses."""
    (tmp_path / "f.csv").write_text("0,0\n0.25,3\n1,-1\n", encoding="utf-8")
    (tmp_path / "s.yaml").write_text(
        f"records: {{f: {{file: f.csv, unit: {unit}}}}}\nparameters: {{m: 1.25 kg}}\n"
        "bodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: 80 N/m, between: [ground, b]}}\n"
        f"forces: {{F: {{at: b, force: {load}}}}}\nfind: [{{response: {{until: 2 s}}}}]\n"
        "answers: {max(x): 1 cm}\n", encoding="utf-8")
    assert run(["stress", str(tmp_path / "s.yaml"), "--json"]) == 0
    told = [one["verdict"] for one in json.loads(capsys.readouterr().out)["shaken"]]
    assert told.count(REFUSED) == refused


@pytest.mark.parametrize(("text", "powers", "expected"), [
    ("0.35 m", (1, 0, 0), "1.4 m"), ("2*k + 3.1 N/m", (0, 0, 1), "2*k + 0.19375 N/m"),
    ("12 kN*m", (1, 1, 1), "48 kN*m"), ("static", (1, 0, 0), "static"),
    ("frf[x, F](5 Hz)", (0, 0, 1), "frf[x, F](1.25 Hz)"), ("30 deg", (1, 1, 1), "30 deg"),
    ("-1e-3 m^2", (1, 0, 0), "-0.016 m^2"), ("max(x) = 2.5 cm", (1, 0, 0), "max(x) = 10 cm"),
    ("q = 2*p + 5 mm", (1, 0, 0), "q = 2*p + 20 mm"),
    ("a = b = 3 m", (1, 0, 0), "a = b = 3 m"), ("Two cars, 5 m apart.", (1, 0, 0), "Two cars, 5 m apart.")])
def test_numbers_are_scaled_exactly_wherever_they_stand(text, powers, expected):
    assert with_numbers(Scalar(text, None), scaled(*powers)).text == expected


def test_springs_in_two_keep_their_names_and_elements_their_entries():
    _, top, _ = scene_read_again(CHAIN)
    springs = in_parallel(top).entries["springs"][1].entries
    assert list(springs) == ["s", "s_twin", "t", "t_twin"]
    assert springs["t"][1].entries["k"][1].text == "(2*k)/2"
    assert list(reordered(top).entries["bodies"][1].entries) == ["b", "a"]


def test_what_the_scene_written_otherwise_refuses_is_refused_with_its_reason_and_not_broken(monkeypatch):
    """Which of two springs bears how much of a load as drawn is not said by statics."""
    scene = {"parameters": {"m": "2 kg", "g": "9.81 m/s^2"}, "gravity": "g",
             "bodies": {"b": {"mass": "m", "at": ["0 m", "0 m"], "slide": {"by": "x", "along": ["0", "-1"]}}},
             "springs": {"s": {"law": "(800 N/m)*d + (9 N/mm^3)*d^3", "preload": "static",
                               "between": [["0 m", "1 m"], "b"]}}}
    found = {change: one for change, one in shaken(scene).items() if "parallel" in change}
    assert {one.verdict for one in found.values()} == {REFUSED} and all(one.why for one in found.values())


@pytest.mark.sweep
def test_forces_of_supports_have_the_same_bits_in_all_units():
    """Slopes by lengths and by angles stand beside each other in the conditions of a step ladder."""
    base, _, remade = scene_read_again({
        "gravity": "9.81 m/s^2",
        "points": {"A": ["-0.7 m", "0 m"], "B": {"body": "right", "at": ["0.7 m", "0 m"]},
                   **{f"{name}{side}": {"body": body, "at": [x, y]} for name, y, places in (
                       ("top", "2.4 m", ("0 m", "0 m")), ("R", "0.96 m", ("-0.42 m", "0.42 m")))
                      for side, body, x in zip("12", ("left", "right"), places, strict=True)}},
        "surfaces": {"floor": {"line": [["-0.7 m", "0 m"], ["0.7 m", "0 m"]]}},
        "bodies": {"left": {"shape": "rod", "mass": "12 kg", "from": "A", "to": ["0 m", "2.4 m"],
                            "pin": {"at": "A", "by": "phi"}},
                   "right": {"shape": "rod", "mass": "8 kg", "from": ["0.7 m", "0 m"], "to": ["0 m", "2.4 m"],
                             "move": ["x", "y", "psi"]},
                   "man": {"mass": "75 kg", "at": ["-0.175 m", "1.8 m"], "weld": "left"}},
        "constraints": {"hinge": {"join": ["top1", "top2"]}, "foot": {"point": "B", "surface": "floor"},
                        "tie": {"rope": ["R1", "R2"]}}, "find": ["equilibrium", "reactions"],
        "answers": {"equilibrium[foot.force]": "364 N", "equilibrium[tie.force]": "158 N",
                    "equilibrium[left.reaction.y]": "568 N"}})
    for power in (1, -3):
        law = whole_scene.SceneLaw("lengths", partial(with_numbers, change=scaled(power, 0, 0)), (power, 0, 0))
        numbers = whole_scene.GROUPS["answers"](base)
        found = whole_scene._shake(base, remade(law.change), law, "answers", numbers)
        assert (found.verdict, found.compared) == (EQUAL, 3)
