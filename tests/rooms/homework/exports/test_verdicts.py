"""One verdict: what each system does with an answer is what `grade` does, or stands in `vibcli explain exports`."""

import json
from pathlib import Path

import pytest
from support import course_systems
from support.course_systems import RIGHT, UNREADABLE, WRONG, element, rounded_by_canvas
from support.exported import grades, manifest_key, on_disk, question, written

from vibcli.homework.exports import FORMATS

KEYS = {
    "plain": manifest_key(21.909, 0.11, {"cycles": 3.4869, "weight": 22.6, "twice": 43.818}),
    "negative": manifest_key(-3.5127, 0.0176, {"sign": 3.5127, "half": -1.75635}, "mm"),
    "zero": manifest_key(0.0, 0.0, {"weight": 1.25, "sign": -1.25}, "N"),
    "small": manifest_key(0.00123456, 6.2e-6, {"other": 0.00125, "sign": -0.00123456}, "m"),
    "large": manifest_key(87654.3, 440.0, {"near": 89000.0, "low": 1234.5}, "N/m"),
    "narrow": manifest_key(2.7182818, 2.8e-5, {"next": 2.71834, "other": 2.7}, "m", 5),
    "degrees": manifest_key(14.3239, 0.07, {"radians": 0.25, "weight": 0.0}, "deg"),
    "small angle": manifest_key(-0.0375, 0.0002, {"sign": 0.0375}, "deg", 3),
    "meeting": manifest_key(10.0, 0.05, {"first": 11.0, "second": 11.02, "third": 11.06, "same": 11.02}),
    "touching": manifest_key(10.0, 0.5, {"within": 10.9, "beneath": 9.2}),
    "ratio": manifest_key(0.12541, 0.0001, {"twice": 0.25082}, ""),
}
SYSTEMS = ("moodle", "cloze", "prairielearn", "qti21")


def probes(key):
    """Key, both edges, a part in 10⁹ within and without, mistakes, the sign."""
    value, band = key["value"], key["band"]
    edges = [value + side * band * (1 + part) for side in (1, -1) for part in (0, 1e-9, -1e-9)]
    wrong = [one["value"] for one in key["mistakes"]]
    scale = abs(band / value) if value else 0.0
    beside = [other * (1 + side * 0.4 * scale) for other in wrong for side in (1, -1)]
    return [value, *edges, *wrong, *beside, -value, 0.0, 2 * value + 1]


def marks(system, key, folder):
    asked = (key, key) if system == "cloze" else (key,)
    name = "moodle" if system == "cloze" else system
    files = written(name, [question("block-1", *asked)])
    more = (on_disk(files, folder),) if name == "prairielearn" else ()
    return getattr(course_systems, name)(files, *more)["block-1"]["b" if system == "cloze" else "a"]


@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("name", KEYS)
def test_numbers(system, name, tmp_path):
    """Verdict and mistake, of numbers without a unit."""
    key = KEYS[name]
    there, here = marks(system, key, tmp_path), grades(key)
    for value in probes(key):
        verdict, said = there(repr(value))
        assert (verdict, said.partition(":")[0]) == here(repr(value)), value


@pytest.mark.parametrize("name", KEYS)
def test_canvas_compares_what_it_rounds(name, tmp_path):
    """The verdict is that of the rounded answer, in the unit that is asked there; mistakes are not told apart."""
    from vibcli.homework.exports.canvas import in_unit

    key = KEYS[name]
    there, here = marks("canvas", key, tmp_path), grades(key)
    one = question("block-1", key)
    factor = in_unit(one, one.keys[0]).value / key["value"] if key["value"] else 1.0
    assert not key["value"] or 0.1 <= abs(factor * key["value"]) <= 1000
    for value in probes(key):
        kept = float(rounded_by_canvas(value * factor)) / factor
        if abs(abs(kept - key["value"]) - key["band"]) > 1e-11 * abs(key["value"]):
            assert there(repr(value * factor)) == (here(repr(kept))[0], ""), value


# What differs: (system, how an answer is written) → its verdict; `grade` reads units, fractions of none and commas.
WRITTEN = {
    "with its unit": ("21.909 rad/s", RIGHT), "in another unit": ("209.2 rpm", RIGHT), "in Hz": ("21.909 Hz", WRONG),
    "of something else": ("21.909 kg", UNREADABLE), "with a comma": ("21,909 rad/s".replace("909", "91"), RIGHT),
    "as a fraction": ("43818/2000", UNREADABLE), "no number": ("none", UNREADABLE), "with a power": ("2.1909e1", RIGHT),
    "with a product": ("2.1909*10^1", RIGHT), "blanks around": (" 21.909 ", RIGHT),
}
DIFFER = {
    ("moodle", "with its unit"): UNREADABLE, ("moodle", "in another unit"): UNREADABLE,
    ("moodle", "in Hz"): UNREADABLE, ("moodle", "with a comma"): UNREADABLE,
    ("cloze", "in another unit"): WRONG, ("cloze", "in Hz"): RIGHT, ("cloze", "of something else"): RIGHT,
    ("cloze", "with a comma"): WRONG, ("cloze", "as a fraction"): WRONG,
    ("prairielearn", "with its unit"): UNREADABLE, ("prairielearn", "in another unit"): UNREADABLE,
    ("prairielearn", "in Hz"): UNREADABLE, ("prairielearn", "with a comma"): UNREADABLE,
    ("prairielearn", "with a product"): UNREADABLE,
    ("qti21", "with its unit"): UNREADABLE, ("qti21", "in another unit"): UNREADABLE, ("qti21", "in Hz"): UNREADABLE,
    ("qti21", "with a comma"): UNREADABLE, ("qti21", "with a product"): UNREADABLE,
    ("canvas", "with its unit"): UNREADABLE, ("canvas", "in another unit"): UNREADABLE, ("canvas", "in Hz"): UNREADABLE,
    ("canvas", "with a comma"): UNREADABLE, ("canvas", "with a product"): UNREADABLE,
}


@pytest.mark.parametrize("system", [*SYSTEMS, "canvas"])
def test_other_writings(system, tmp_path):
    there, here = marks(system, KEYS["plain"], tmp_path), grades(KEYS["plain"])
    for how, (text, verdict) in WRITTEN.items():
        assert here(text)[0] == verdict, how
        assert there(text)[0] == DIFFER.get((system, how), verdict), how


def test_every_format_has_a_rule():
    assert {name for name in FORMATS if hasattr(course_systems, name)} == set(FORMATS)


def test_the_element_of_prairielearn_marks_as_its_model():
    found = json.loads((Path(__file__).parent / "prairielearn_verdicts.json").read_text(encoding="utf-8"))
    said = {1.0: RIGHT, 0.0: WRONG, "format error": UNREADABLE}
    assert len(found["rows"]) == 240
    for key, rtol, atol, text, verdict in found["rows"]:
        assert element(key, rtol, atol, True, text) == said[verdict], (key, rtol, atol, text)
