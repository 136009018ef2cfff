"""Words of figures touch neither one another nor lines, in all but two of a hundred figures at most."""

from pathlib import Path

import pytest
from support.overlaps import touching
from support.scenes import problem_of

from vibcli.drawing.canvas.primitives import Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import lettering

ROOT = Path(__file__).parents[3]
MOST = 0.02


@pytest.mark.sweep
def test_words_of_problems_and_examples_touch_nothing():
    paths = sorted([*ROOT.glob("problems/[1-9]*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")])
    found = {path.stem: told for path in paths if (told := touching(draw(problem_of(path))))}
    assert len(paths) > 300 and len(found) <= MOST * len(paths), found


def test_a_word_that_touches_is_seen():
    word = lettering.text(lettering.named("m"), 10.0, 10.0)
    middle = (word.box[0] + word.box[2]) / 2, (word.box[1] + word.box[3]) / 2
    over, beside = Polyline(((0.0, middle[1]), (50.0, middle[1]))), Polyline(((0.0, 0.0), (50.0, 0.0)))
    assert touching([word, over, beside]) == [("m", "ink")]
    assert touching([word, Polyline(((middle[0], 0.0), (middle[0], 50.0)), "load")]) == [("m", "load")]
    assert touching([word, lettering.text(lettering.named("k"), *middle)]) == [("k", "m")]
    assert touching([word, lettering.text(lettering.named("k"), 100.0, 10.0), beside]) == []
