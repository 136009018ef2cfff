"""A named point stands wherever a place does: every scene reads the same where each place of its bodies, surfaces and
points has a name; and any parameter is an answer."""

import json
from pathlib import Path

import pytest
import yaml
from support.documents import LOADER
from support.scenes import problem, problem_of

from vibcli.check.verdicts import check
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec

ROOT = Path(__file__).parents[3]
SCENES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml")])
PLACES = ("at", "from", "to", "circle")


def named(scene):
    """The scene with a point for every place that is written out; the number of those."""
    points = {}

    def name(place):
        points[f"place{len(points)}"] = place
        return f"place{len(points) - 1}"

    for body in scene.get("bodies", {}).values():
        for shape in (body, *body.get("parts", ())) if isinstance(body, dict) else ():
            shape.update({key: name(shape[key]) for key in PLACES if isinstance(shape.get(key), list)})
    for surface in scene.get("surfaces", {}).values():
        surface.update({"circle": name(surface["circle"])} if "circle" in surface else {})
        surface.update({"line": [name(place) for place in surface["line"]]} if "line" in surface else {})
    for key, point in scene.get("points", {}).items():
        if isinstance(point, dict):
            point["at"] = name(point["at"]) if isinstance(point["at"], list) else point["at"]
        else:
            scene["points"][key] = name(point)
    if points:
        scene["points"] = points | scene.get("points", {})
    return len(points)


def places(spec):
    """{(section, name, key): texts} of the places of a scene."""
    found = {}
    for section in ("bodies", "surfaces", "points"):
        for name, record in (spec.get(section) or {}).items():
            for i, part in enumerate((record, *record.get("parts", ()))):
                for key in (*PLACES, "line"):
                    pairs = part.get(key, ()) if key == "line" else [part[key]] if key in part else []
                    found[section, name, i, key] = [[value.text for value in pair] for pair in pairs]
    return found


@pytest.mark.parametrize("path", SCENES[::2], ids=lambda path: path.stem)
def test_every_place_may_have_a_name(path):
    scene = yaml.load(path.read_text(encoding="utf-8"), Loader=LOADER)
    if not named(scene):
        return
    node, diagnostics = read(json.dumps(scene, indent=1).replace(': ""', ': ').encode(), str(path))
    found, wanted = places(read_spec(node, str(path), diagnostics)), places(problem_of(path).spec)
    assert {key: found[key] for key in wanted} == wanted


def test_any_parameter_and_what_they_make_is_an_answer():
    scene = problem("""
        parameters: {m: 2 kg, k: 5 N/m, T: 1/f, f: 4 Hz, V: 3 m/s, omega: 5 rad/s, k_t: k/2, c: , stiff: 2*k}
        bodies: {one: {mass: m, slide: x}}
        springs: {s: {k: stiff, between: [ground, one]}}
        dampers: {d: {c: c*(T*f)*V/V*omega/omega*k_t/k_t, between: [ground, one]}}
        choose: {c: "zeta[1] = 0.5"}
        answers: {k_t: 2.50 N/m, T: 0.250 s, f: 4.00 Hz, V: 3.00 m/s, omega: 5.00 rad/s, k*m: 10.0 kg^2/s^2,
                  2*stiff: 4*k, T*f: 1, V*m: 6.00 N*s, c: sqrt(2*k*m), "omega[1]": sqrt(2*k/m)}
    """)
    assert [verdict.agrees for verdict in check(scene)] == [True] * 11
