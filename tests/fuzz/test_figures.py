"""Words of the figures of random scenes touch neither one another nor lines."""

import random

from fuzz import full_bounds, spring_scenes
from support.overlaps import touching
from support.scenes import problem

from vibcli.drawing.canvas.primitives import LetterRuns
from vibcli.drawing.drawing import draw

COUNT, MOST = 250, 0.02     # scenes of each kind; the share of figures that may have words that touch


def test_words_of_random_scenes_touch_nothing():
    texts = [spring_scenes.text(spring_scenes.drawn(random.Random(seed))) for seed in range(COUNT)]
    texts += [full_bounds.drawn(seed).text for seed in range(COUNT)]
    figures = [draw(problem(text)) for text in texts]
    assert all(any(isinstance(part, LetterRuns) for part in figure) for figure in figures)
    found = {i: told for i, figure in enumerate(figures) if (told := touching(figure))}
    assert len(figures) == 2 * COUNT and len(found) <= MOST * len(figures), found
