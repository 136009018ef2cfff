"""What a body's name stands for: the mass centre where forces and displacements are meant, the centre of its circle
where it rolls, meshes and carries ropes. How a body is put together changes none of the two."""

import random
import re
from copy import deepcopy
from pathlib import Path

import pytest
import yaml
from support.documents import LOADER

from vibcli.base.errors import SpecError
from vibcli.language.document.document import read
from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.reader.read import read_spec
from vibcli.scene.build import build_scene
from vibcli.symbolic.evaluation import Floats, evaluate

ROOT = Path(__file__).parents[3]
FILES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml"),
                *(ROOT / "tests" / "trials").glob("*.yaml")])
random.Random(5).shuffle(FILES)
MOST = 60       # files of a way


class Dumper(yaml.SafeDumper):
    """Writes what is empty as nothing, not as an empty text, and what stands twice, twice."""

    def ignore_aliases(self, data):
        return True


Dumper.add_representer(str, lambda dumper, text: dumper.represent_scalar(
    f"tag:yaml.org,2002:{'str' if text else 'null'}", text))
OF_A_SHAPE = ("shape", "mass", "density", "at", "from", "to", "angle", "radius", "half_angle", "width", "height", "a",
              "b")
ROUND = ("disc", "ring", "sector", "arch")


def in_one_part(body):
    """The body as one of a single part."""
    if "parts" in body or not {"mass", "density"} & set(body) or not {"at", "from"} & set(body):
        return None
    if re.match(r"0( |$)", str(body.get("mass", ""))):
        return None         # the mass centre of parts needs a mass
    kept = {key: value for key, value in body.items() if key not in OF_A_SHAPE}
    return {**kept, "parts": [{key: body[key] for key in OF_A_SHAPE if key in body}]}


def beside_a_point(body):
    """The same, behind a part of no mass that lies elsewhere."""
    found = in_one_part({key: value for key, value in body.items() if key != "looks"})
    if found is not None:
        found["parts"].insert(0, {"mass": "0 kg", "at": ["7.1 m", "-3.3 m"]})
    return found


def in_two_halves(body):
    """A round body as two halves about its centre."""
    found = in_one_part(body)
    if found is None or body.get("shape") not in ROUND:
        return None
    whole, = found["parts"]
    axis, half = (f"({whole.get(key, default)})" for key, default in (("angle", "0 rad"), ("half_angle", "pi")))
    weight = {key: f"({whole[key]})/2" if key == "mass" else whole[key] for key in ("mass", "density") if key in whole}
    piece = {**whole, **weight, "half_angle": f"{half}/2",
             "shape": {"disc": "sector", "ring": "arch"}.get(whole["shape"], whole["shape"])}
    found["parts"] = [{**piece, "angle": f"{axis} {sign} {half}/2"} for sign in "+-"]
    return found


def backwards(body):
    """A body of parts, their order turned round."""
    return {**body, "parts": body["parts"][::-1]} if len(body.get("parts", ())) > 1 else None


def rewritten(scene, way):
    """The scene with its bodies put together another way; None where that changes nothing."""
    found, changed = deepcopy(scene), False
    for name, body in (found.get("bodies") or {}).items():
        other = way(body)
        if other is not None:
            found["bodies"][name], changed = other, True
    return found if changed else None


def plain(path):
    """The scene of a file without its cases and what is asked, where parameters may be left unused."""
    scene = yaml.load(path.read_text(encoding="utf-8"), LOADER)
    kept = {key: value for key, value in scene.items() if key not in ("cases", "answers", "question")}
    for name, value in scene.get("parameters", {}).items():
        said = value if isinstance(value, dict) else {"value": value} if value else {}
        kept["parameters"][name] = {**said, "unused": "allowed"}
    return kept


def built(scene, path):
    """The scene with all its coordinates."""
    node, diagnostics = read(yaml.dump(scene, Dumper=Dumper, sort_keys=False, width=10**6).encode(), str(path))
    return build_scene(read_spec(node, str(path), diagnostics)).with_multipliers()


def described(scene):
    """T, V, Φ, Q, G and the displacements of all bodies at a few positions that are drawn at random."""
    scene = scene.with_preloads({node: scene.table.number(len(record.name)) for node, record in scene.static_preloads})
    V = potential(scene)
    nodes = [kinetic(scene), V - scene.at_drawn(V)[0], dissipation(scene), *(tie.node for tie in scene.constraints),
             *(generalised_force(scene, i) for i in range(len(scene.q))),
             *(displacement(scene, f"{name}.{axis}") for name, body in scene.bodies.items() if body.frame is not None
               for axis in "xy")]
    draw, found = random.Random(11), []
    for _ in range(3):
        values = {symbol.name: draw.uniform(0.05, 0.15) for symbol in (*scene.q, *scene.v, scene.time)}
        found += evaluate(nodes, Floats, {**scene.sample, **values})
    return found


WAYS = (beside_a_point, in_two_halves, backwards)
LEAST = {"beside_a_point": MOST, "in_two_halves": 40, "backwards": 4}


@pytest.mark.sweep
@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.__name__)
def test_how_a_body_is_put_together_changes_nothing(way):
    swept = 0
    for path in FILES:
        scene = plain(path)
        other = rewritten(scene, way)
        if other is not None and swept < MOST:
            try:
                wanted = described(built(scene, path))
            except SpecError as error:
                assert "is not taut" in str(error)      # its tension is found from its equilibrium
                continue
            found = described(built(other, path))
            size = max(map(abs, wanted), default=0.0)
            assert found == pytest.approx(wanted, rel=1e-9, abs=1e-11 * size), path.stem
            swept += 1
    assert swept >= LEAST[way.__name__]
