"""Words of the figures of random scenes touch neither one another nor lines, their arrows cross nothing."""

import random

from fuzz import full_bounds, spring_scenes
from support.overlaps import crossed, touching
from support.scenes import problem

from vibcli.drawing.canvas.primitives import LetterRuns
from vibcli.drawing.drawing import draw

COUNT, MOST = 125, 0.02     # scenes of each kind; the share of figures that may have a flaw


def test_words_and_arrows_of_random_scenes_touch_nothing():
    texts = [spring_scenes.text(spring_scenes.drawn(random.Random(seed))) for seed in range(COUNT)]
    texts += [full_bounds.drawn(seed).text for seed in range(COUNT)]
    figures = [draw(problem(text)) for text in texts]
    assert all(any(isinstance(part, LetterRuns) for part in figure) for figure in figures)
    assert len(figures) == 2 * COUNT
    for check in (touching, crossed):
        found = {i: told for i, figure in enumerate(figures) if (told := check(figure))}
        assert len(found) <= MOST * len(figures), found
