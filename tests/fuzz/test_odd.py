"""Odd combinations of all that the language has: random scenes against a mechanics of their own (tests/fuzz/odd)."""

import re
from pathlib import Path

import numpy as np
import pytest
from fuzz.odd import compare, draw, mechanics, motion, shrink
from fuzz.odd.sweep import Sweep

SCENES, FIRST, MOST_REFUSED = 100, 12, 0.15
RARE = {"prescribed move", "prescribed roll", "full *.drive"}       # drawn, but few such scenes have frequencies
APART = {"body.clamp", "clamp.at", "clamp.carrier", "scene.inerters", "inerter.b", "inerter.between", "inerter.stretch",
         "inerter.torsion", "force.per_length", "force.from", "force.to", "roll.between",
         "roll.flat", "turn.carrier", "turn.by", "ritz.shapes", "backbone.of", "backbone.up_to", "backbone.mode",
         "request.backbone", "request.expansion", "expansion.order", "spring.series", "spring.parallel",
         "damper.series", "damper.parallel", "spring_part.k", "spring_part.law", "spring_part.torsion",
         "spring_part.series", "spring_part.parallel", "damper_part.c", "damper_part.law", "damper_part.torsion",
         "damper_part.series", "damper_part.parallel"}     # not drawn
UNASKED = ("variants.", "set of variants.", "range.", "asked quantity.", "scene.variants",
           "body.looks")        # homework and figures: no answer hangs on them


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    found = Sweep(tmp_path_factory.mktemp("odd"))
    found.representative(FIRST, SCENES, RARE | APART)
    return found


def test_every_number_agrees(sweep):
    assert sweep.numbers > 40 * sweep.drawn
    assert not sweep.disagreements


def test_few_are_refused_and_all_is_drawn(sweep):
    assert sweep.refused < MOST_REFUSED, sweep.refusals
    assert sweep.drawn <= SCENES
    assert {what for what in sweep.never if not what.startswith(UNASKED)} <= RARE | APART


def test_no_code_is_shared():
    """The program is run by doors.py alone."""
    files = [path for path in (Path(__file__).parent / "odd").glob("*.py") if path.name != "doors.py"]
    assert len(files) > 10
    assert not [path for path in files if re.search(r"^\s*(from|import) vibcli", path.read_text("utf-8"), re.M)]


# masses in a row with dampers and a load, compared in every part: as the scene of the seed PARTS would be
SCENE = next(seed for seed in range(1, 400) for scene in [draw.drawn(seed)]
             if scene.axis and scene.dampers and scene.forces and len(scene.coordinates) == 2 and not scene.tied
             and "motion" not in scene.sections)
PARTS = compare.FULL_EACH * compare.FRF_EACH * compare.EQUATIONS_EACH     # asked all that is asked every few scenes
SMALL, FULL, LEFT = mechanics.small, motion.full_motion, mechanics.residual


def _small(**changed):
    """Small motions with one matrix off in its seventh digit."""
    def wrong(*args):
        right = SMALL(*args)
        return right._replace(**{key: (1 + 1e-7) * np.array(getattr(right, key)) for key in changed})
    return wrong


@pytest.fixture(scope="module")
def right(tmp_path_factory):
    """The file of the scene, of which every number agrees."""
    path = tmp_path_factory.mktemp("right") / "scene.yaml"
    draw.drawn(SCENE).write(path)
    assert not compare.compared(draw.drawn(SCENE), path, PARTS).differences
    return path


@pytest.mark.parametrize(("module", "name", "wrong"), [
    *((mechanics, "small", _small(**{key: True})) for key in "MCK"),
    (mechanics, "residual", lambda figure, state, *args, **options: LEFT(
        figure, state._replace(v=[1.0001 * v for v in state.v]), *args, **options)),
    (motion, "full_motion", lambda *args: [(1.0001 * q, v) for q, v in FULL(*args)])])
def test_what_is_wrong_is_noticed(module, name, wrong, monkeypatch, right):
    monkeypatch.setattr(module, name, wrong)
    assert compare.compared(draw.drawn(SCENE), right, PARTS).differences


def test_smallest_scene():
    text = draw.drawn(SCENE).text()
    found = shrink.smallest(text, lambda scene: "dampers" in scene or None)
    assert "dampers" in found and "forces" not in found and "springs" not in found
