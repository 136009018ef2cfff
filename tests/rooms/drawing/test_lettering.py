"""Letters of labels as they are set in print."""

import pytest
from support.scenes import problem

from vibcli.drawing.canvas.primitives import LetterRuns
from vibcli.drawing.canvas.svg_canvas import picture
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout.formulas import written
from vibcli.drawing.layout.lettering import letters, named, set_apart, width
from vibcli.symbolic.expression import Table


def of_name(name):
    """(on the line, lowered)"""
    runs = named(name)
    return letters([run for run in runs if not run.rise]), letters([run for run in runs if run.rise < 0])


@pytest.mark.parametrize("name, found", [
    ("kt1", ("k", "t1")), ("mp", ("m", "p")), ("phi2", ("φ", "2")), ("EI", ("EI", "")), ("EI2", ("EI", "2")),
    ("GIo", ("GI", "o")), ("rod1", ("rod1", "")), ("phi'", ("φ\u0307", "")), ("x1''", ("x\u0308", "1"))])
def test_names(name, found):
    assert of_name(name) == found


def test_a_number_stands_at_its_letter():
    table = Table()
    k, F = table.parameter("k"), table.parameter("F")
    assert letters(written(k * 4)) == "4k" and letters(written(k * F)) in ("k F", "F k")
    assert letters(written(k * F * -3)) == "−3k F"


def test_gravity_in_numbers_is_named():
    scene = "parameters: {m: 2 kg}\ngravity: 9.81 m/s^2\nbodies: {a: {mass: m, at: [0, 0], move: [0, y, 0]}}\n"
    told = [letters(part.runs) for part in draw(problem(scene)) if isinstance(part, LetterRuns)]
    assert "g = 9.81 m/s²" in told


@pytest.mark.parametrize("name, higher", [("x'", False), ("phi'", False), ("theta'", True), ("F''", True)])
def test_dots_stand_above_their_letter(name, higher):
    run, = named(name)
    (letter, left, low), (dots, right, rise) = set_apart(run)
    assert letter + dots in (run.text[0] + "\u02d9", run.text[0] + "\u00a8")
    assert (left, low) == (0.0, 0.0) and (rise > 0) == higher
    assert -1.0 < right < width((run._replace(text=letter),))


def test_dots_are_no_part_of_their_letter_in_figures():
    scene = "coordinates: [theta]\nparameters: {m: 2 kg*m^2}\nenergies: {T: m*theta'^2/2, V: m*theta^2*1 s^-2}\n"
    shown = picture(draw(problem(scene))).decode()
    assert "\u02d9</text>" in shown and "\u0307" not in shown
