"""Words of figures touch neither one another nor lines, arrows cross neither springs nor dampers nor masses, in all but
two of a hundred figures at most."""

from pathlib import Path

import pytest
from support.overlaps import crossed, touching
from support.scenes import kept_problem_of

from vibcli.drawing.canvas.primitives import Circle, Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import lettering
from vibcli.drawing.symbols import arrow

ROOT = Path(__file__).parents[3]
MOST = 0.02


@pytest.mark.sweep
def test_words_and_arrows_of_problems_and_examples_touch_nothing():
    paths = sorted([*ROOT.glob("problems/[1-9]*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")])
    figures = {path.stem: draw(kept_problem_of(path)) for path in paths}
    assert len(figures) > 300
    for check in (touching, crossed):
        found = {name: told for name, figure in figures.items() if (told := check(figure))}
        assert len(found) <= MOST * len(paths), found


def test_a_word_that_touches_is_seen():
    word = lettering.text(lettering.named("m"), 10.0, 10.0)
    middle = (word.box[0] + word.box[2]) / 2, (word.box[1] + word.box[3]) / 2
    over, beside = Polyline(((0.0, middle[1]), (50.0, middle[1]))), Polyline(((0.0, 0.0), (50.0, 0.0)))
    assert touching([word, over, beside]) == [("m", "ink")]
    assert touching([word, Polyline(((middle[0], 0.0), (middle[0], 50.0)), "load")]) == [("m", "load")]
    assert touching([word, lettering.text(lettering.named("k"), *middle)]) == [("k", "m")]
    assert touching([word, lettering.text(lettering.named("k"), 100.0, 10.0), beside]) == []


def test_an_arrow_that_crosses_is_seen():
    shaft = arrow.straight((0.0, 0.0), (30.0, 0.0), "load")
    spring = Polyline(((19.5, -5.0), (19.5, 5.0)), "spring")
    assert crossed([*shaft, spring]) == [("load", "spring")]
    assert crossed([*shaft, spring._replace(points=((19.5, 1.0), (19.5, 5.0)))]) == []
    assert crossed([*shaft, Circle((20.0, 0.0), 6.0, "body")]) == [("load", "ink")]
    assert crossed([*shaft, Circle((0.0, 0.0), 6.0, "body")]) == []             # from the body on which it acts
    assert crossed([*arrow.round_((0.0, 0.0), 20.0, 0.0, 2.0, "coordinate"), spring]) == []
    assert crossed([*arrow.round_((0.0, 0.0), 20.0, -2.0, 0.5, "coordinate"), spring]) == [("coordinate", "spring")]
