"""Scenes seen in a mirror: they rest and swing as before, and a sense that is forgotten is seen."""

import pytest
from rooms.evidence.test_stress import scene_read_again
from rooms.evidence.test_whole_scene import CHAIN, shaken

from vibcli.base.errors import PhysicsError
from vibcli.evidence.stress import mirrored, whole_scene
from vibcli.evidence.stress.shaken import BROKEN, EQUAL, REFUSED, WITHIN
from vibcli.language.document.nodes import Mapping, Scalar, Sequence

SCENE = {
    "parameters": {"g": "9.81 m/s^2", "w": "0.35 m"}, "gravity": "g",
    "points": {"P": {"body": "cart", "at": ["w", "0 m"]}},
    "bodies": {"cart": {"mass": "2 kg", "at": ["0 m", "0 m"], "slide": {"by": "x", "along": ["2", "1"]}},
               "arm": {"shape": "rod", "mass": "1 kg", "from": ["w", "0 m"], "to": ["w + 0.2 m", "-0.6 m"],
                       "pin": {"at": "P", "by": "phi"}},
               "bob": {"mass": "0.5 kg", "at": ["1.1 m", "0.2 m"], "move": ["u", "v"]}},
    "springs": {"left": {"k": "300 N/m", "between": [["-0.8 m", "0.1 m"], "cart"], "free_length": "0.6 m"},
                "twist": {"torsion": "2 N*m", "between": ["cart", "arm"]},
                "right": {"k": "80 N/m", "between": [["1.9 m", "0.9 m"], "bob"], "free_length": "0.4 m"},
                "cross": {"k": "50 N/m", "between": ["P", "bob"], "free_length": "0.3 m"}},
    "dampers": {"loss": {"c": "3 N*s/m", "between": [["0 m", "-1 m"], "bob"]}},
    "forces": {"F": {"at": "bob", "force": ["2 N + 1 N*sin(3 rad/s*t)", "0.5 N"]},
               "M": {"body": "arm", "moment": "0.7 N*m + 0.1 N*m*cos(2 rad/s*t)"}},
    "initial": {"phi": "0.3 rad", "u'": "0.2 m/s"}, "motion": "small",
    "answers": {"omega[1]": "1 rad/s", "x(0.5 s)": "1 cm", "phi(0.5 s)": "0.1 rad", "max(v)": "1 cm", "T(1 s)": "1 J"}}

TIED = {
    "parameters": {"g": "9.81 m/s^2", "n": "sqrt(5)"}, "gravity": "g",
    "surfaces": {"slope": {"line": [["0 m", "0 m"], ["2 m", "1 m"]]}},
    "bodies": {"roller": {"shape": "disc", "mass": "2 kg", "radius": "0.1 m", "roll": {"surface": "slope", "turn": "w"},
                          "at": ["1 m - 0.1 m/n", "0.5 m + 0.2 m/n"]},
               "arm": {"shape": "rod", "mass": "3 kg", "from": ["-1 m", "0 m"], "to": ["-0.7 m", "-0.8 m"],
                       "pin": {"at": ["-1 m", "0 m"], "by": "phi"}},
               "wheel": {"inertia": "0.3 kg*m^2", "turn": "psi"},
               "weight": {"mass": "1 kg", "at": ["2.6 m", "0 m"], "slide": {"by": "y", "along": ["0", "-1"]}}},
    "springs": {"s": {"k": "90 N/m", "between": [["-0.8 m", "0.6 m"], "roller"], "free_length": "1.1 m"},
                "t": {"torsion": "9 N*m", "between": ["ground", "wheel"]}},
    "constraints": {"gear": {"equation": "psi = 2*phi + 0.3*w^2 + w/5"},
                    "cord": {"rope": ["roller", {"right_of": ["2.5 m", "1 m"], "radius": "0.1 m"}, "weight"]}},
    "motion": "small", "answers": {"omega[1]": "1 rad/s"}}

WELDED = {
    "parameters": {"g": "9.81 m/s^2", "W": "7 rad/s"}, "gravity": "g",
    "points": {"O": ["0 m", "0 m"], "tip": {"body": "frame", "at": ["0.5 m", "1 m"]},
               "low": {"body": "plate", "at": ["0.6 m", "0.5 m"]}},
    "bodies": {"frame": {"shape": "rod", "mass": "1 kg", "from": ["0 m", "0 m"], "to": ["0.5 m", "1 m"], "clamp": "O"},
               "plate": {"parts": [
                   {"shape": "sector", "mass": "2 kg", "radius": "0.3 m", "half_angle": "0.6", "at": ["0.5 m", "1 m"],
                    "angle": "-1.2 rad"},
                   {"shape": "rectangle", "density": "9 kg/m^2", "width": "0.2 m", "height": "0.1 m",
                    "at": ["0.5 m", "0.7 m"], "angle": "0.3 rad", "cut": "true"}],
                   "pin": {"at": "tip", "by": "phi"}},
               "wheel": {"inertia": "0.1 kg*m^2", "at": ["0.2 m", "1 m"], "pin": "psi"}},
    "springs": {"coil": {"torsion": "40 N*m", "between": ["frame", "plate"], "preload": "3 N*m"}},
    "dampers": {"loss": {"c": "2 N*s/m", "between": [["1 m", "0.4 m"], "low"]}},
    "constraints": {"teeth": {"gear": ["plate", "wheel"], "radii": ["0.2 m", "0.1 m"]}},
    "forces": {"rotor": {"at": "low", "unbalance": "0.01 kg*m", "speed": "W"}},
    "motion": "small", "answers": {"omega[1]": "1 rad/s", "T(0.5 s)": "1 J", "amplitude(phi)": "0.1 rad"}}
MAST = {
    "parameters": {"L": "2 m"},
    "beams": {"mast": {"from": ["0 m", "0 m"], "to": ["0.4 m", "L"], "EI": "900 N*m^2", "mass_per_length": "2 kg/m",
                       "left": "clamped", "right": {"clamped": "tank"}}},
    "bodies": {"tank": {"mass": "9 kg", "at": ["0.4 m", "L"], "move": ["x", "y", "p"]}},
    "forces": {"wind": {"body": "mast", "per_length": "-30 N/m"}}, "answers": {"equilibrium[x]": "1 cm"}}

SLIDING = {
    "parameters": {"g": "9.81 m/s^2", "d": "0.3 s"}, "gravity": "g",
    "surfaces": {"bowl": {"curve": "w^2/(1 m) + w^3/(3 m^2)", "in": "w"},
                 "slope": {"line": [["0 m", "-1 m"], ["2 m", "-0.4 m"]]},
                 "ring": {"circle": ["3 m", "0 m"], "radius": "0.4 m", "side": "inside"}},
    "bodies": {"bead": {"mass": "1 kg", "at": ["0 m", "0 m"], "slide": {"surface": "bowl", "by": "u"}},
               "slider": {"mass": "2 kg", "at": ["0 m", "-1 m"], "slide": {"surface": "slope", "by": "v"}},
               "ball": {"mass": "1 kg", "at": ["3 m", "-0.4 m"], "slide": {"surface": "ring", "by": "s"}},
               "wheel": {"inertia": "0.3 kg*m^2", "at": ["5 m", "0 m"], "pin": "psi"}},
    "springs": {"pull": {"k": "60 N/m", "between": [["0.7 m", "1 m"], "bead"], "free_length": "0.9 m"},
                "hold": {"k": "90 N/m", "between": [["-1 m", "-1.3 m"], "slider"], "free_length": "1 m"},
                "side": {"k": "40 N/m", "between": ["ball", ["4 m", "0 m"]], "free_length": "0.6 m"},
                "coil": {"torsion": "true", "law": "(3 N*m)*d + (2 N*m)*d^2", "between": ["ground", "wheel"]}},
    "dampers": {"brake": {"torsion": "true", "law": "(2 N*m)*d*v", "between": ["ground", "wheel"]}},
    "forces": {"M": {"body": "wheel", "moment": "0.5 N*m"}},
    "motion": "small", "answers": {"omega[1]": "1 rad/s", "equilibrium[s]": "1 cm"}}


def seen(scene):
    return {change: one for change, one in shaken(scene).items() if change.startswith("mirrored")}


@pytest.mark.sweep
def test_it_rests_and_swings_as_before():
    found = seen(SCENE)
    assert {change: one.verdict for change, one in found.items() if one.verdict not in (EQUAL, WITHIN)} == {}
    assert {change: one.compared for change, one in found.items()} == {
        "mirrored: rest": 4, "mirrored: modes": 8, "mirrored: answers": 4}


@pytest.mark.sweep
@pytest.mark.parametrize(("scene", "forgotten"), [
    (SCENE, "load"), (SCENE, "start"), (SCENE, "body"), (SCENE, "connection"),
    (TIED, "expression"), (TIED, "_guide"), (TIED, "surface"),
    (SLIDING, "surface"), (SLIDING, "connection"),
    (WELDED, "_unbalance"), (WELDED, "connection"), (WELDED, "body"), (MAST, "load"), (MAST, "member")])
def test_a_sense_that_is_forgotten_is_seen(scene, forgotten, monkeypatch):
    monkeypatch.setattr(whole_scene, "LAWS", whole_scene.LAWS[-1:])
    assert {one.verdict for one in seen(scene).values()} <= {EQUAL, WITHIN}
    monkeypatch.setattr(mirrored._Sections, forgotten, lambda self, *args: args[-1])
    assert {one.verdict for one in seen(scene).values()} & {BROKEN, REFUSED}


@pytest.mark.sweep
def test_what_is_not_drawn_is_left_out_and_what_is_not_known_refused_by_its_name():
    assert seen(CHAIN) == {}
    top = scene_read_again(SCENE)[1]
    with pytest.raises(PhysicsError, match="what 'magnets' is in a mirror"):
        mirrored.mirrored(Mapping(None, {**top.entries, "magnets": (Scalar("magnets", None), Mapping(None))}))
    arm = {**SCENE["bodies"]["arm"], "from": ["0 m", "0 m"], "pin": {"at": ["0 m", "0 m"], "by": "p"}}
    held = {"bodies": {"arm": arm},
            "springs": {"s": {"torsion": "k", "between": ["ground", "arm"]}},
            "parameters": {"w": "0 m"}, "choose": {"k": "K[p,p] = 30 N*m"}}
    assert seen(held)["mirrored"].verdict == REFUSED and "another sense" in seen(held)["mirrored"].why


@pytest.mark.parametrize(("text", "expected"), [
    ("L*sin(phi) + phi'", "-(L*sin((-phi))) -((-phi'))"), ("phi0 - b.phi", "-(phi0) +(b.phi)"), ("0", "-(0)"),
    ("-2 N + 1e-3*(a - b) - k*-x^-2", "-(-2 N) -(1e-3*(a - b)) +(k*-x^-2)")])
def test_coordinates_have_the_other_sign_in_expressions(text, expected):
    assert mirrored._Sections(frozenset({"phi", "u"})).negative(Scalar(text, None)).text == expected


def test_places_and_directions_point_the_other_way():
    place = Sequence(None)
    place.items.extend([Scalar("w", None), Scalar("u + 2 m", None)])
    found = mirrored._Sections(frozenset({"u"})).vector(place)
    assert [one.text for one in found.items] == ["-(w)", "(-u) + 2 m"]
