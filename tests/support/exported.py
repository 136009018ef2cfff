"""Questions for course systems, made without a scene: keys as a manifest keeps them, bands as `grade` tells them."""

from importlib import import_module

from vibcli.homework.course import Course
from vibcli.homework.exports.item import ExportedKey, ExportedQuestion
from vibcli.homework.exports.told import bands_told
from vibcli.homework.marks import Marker
from vibcli.report.blocks import maths

COURSE = Course("Week 3", "", "", ())


def manifest_key(value, band, mistakes=(), unit="rad/s", figures=4, points=2.0):
    """A key of a manifest; mistakes: {name: value}."""
    return {"quantity": "omega[1]", "unit": unit, "points": points, "value": value, "error": 0.0, "figures": figures,
            "band": band, "mistakes": [{"name": name, "value": wrong} for name, wrong in dict(mistakes).items()]}


def question(item, *keys, words="A block on a spring.", said=None, by_hand=False, group="block"):
    """An ExportedQuestion that asks for keys of a manifest."""
    exported = tuple(ExportedKey(letter, key["quantity"], "angular frequency", key["unit"], str(key["figures"]),
                                 key["points"], "", ("x''" if by_hand else str(key["value"]),),
                                 None if by_hand else key["value"], () if by_hand else tuple(bands_told(key)))
                     for letter, key in zip("abcdefgh", keys, strict=False))
    names = [one["name"] for key in keys for one in key["mistakes"]]
    return ExportedQuestion(item, group, "block", 1, "A block", by_hand,
                            (words, maths("ω² = k/m")), (), None, "", {}, exported,
                            dict.fromkeys(names, "look again") if said is None else said, ())


def written(name, questions, course=COURSE):
    """{path: bytes} of a format."""
    return dict(import_module(f"vibcli.homework.exports.{name}").package(course, questions))


def on_disk(files, folder):
    """The folder, the files written into it."""
    for path, data in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(data)
    return folder


def grades(key):
    """text ↦ (verdict, mistake) of `grade` by a key of a manifest."""
    marker = Marker({"problems": [{"name": "block", "mistakes": {}, "variants": [{"variant": 1, "keys": [key]}]}],
                     "students": [{"id": "s", "name": "", "sheets": [{"problem": "block", "variant": 1}]}]})

    def marks(text):
        found, = marker.marks("s", "block", {key["quantity"]: text})
        return found.verdict, found.mistake
    return marks
