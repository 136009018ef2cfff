"""Words of a figure that touch: others, or lines, in points."""

from itertools import pairwise

from vibcli.drawing.canvas.primitives import LetterRuns

BESIDE = 0.5        # points by which boxes of words may overlap
WITHIN = 1.5        # points inside a box: letters do not fill it


def touching(drawn):
    """[(a word, what it touches)] of a figure."""
    words = [part for part in drawn if isinstance(part, LetterRuns)]
    lines = [part for part in drawn if not isinstance(part, LetterRuns)]
    found = []
    for i, word in enumerate(words):
        text = _text(word)
        found += [(text, _text(other)) for other in words[:i] if _overlap(word.box, other.box)]
        found += [(text, line.role) for line in lines if any(_struck(word.box, stroke) for stroke in line.strokes())]
    return found


def _text(word):
    return "".join(run.text for run in word.runs)


def _overlap(one, two):
    return all(min(one[k + 2], two[k + 2]) - max(one[k], two[k]) > BESIDE for k in (0, 1))


def _struck(box, stroke):
    """Does a polyline pass through a box? Each stretch is cut to it (Liang & Barsky, 1984)."""
    left, bottom, right, top = box[0] + WITHIN, box[1] + WITHIN, box[2] - WITHIN, box[3] - WITHIN
    for (ax, ay), (bx, by) in pairwise(stroke):
        first, last = 0.0, 1.0
        for rate, room in ((ax - bx, ax - left), (bx - ax, right - ax), (ay - by, ay - bottom), (by - ay, top - ay)):
            if rate < 0:
                first = max(first, room / rate)
            elif rate > 0:
                last = min(last, room / rate)
            elif room < 0:
                last = -1.0
        if first <= last:
            return True
    return False
