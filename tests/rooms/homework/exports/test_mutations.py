"""A package that is spoilt in one place is found out: by its verdicts, or as its reader takes it."""

import io
from zipfile import ZipFile

import pytest
from support import course_systems
from support.exported import grades, manifest_key, on_disk, question, written

KEY = manifest_key(0.0123456, 6.2e-5, {"weight": 0.012415, "sign": -0.0123456, "cycles": 0.5}, "m")
ZERO = manifest_key(0.0, 0.0, {"weight": 1.25}, "N")
TEXTS = ["", " ", "0.0123456 m", "123456/10000000", "none", "1", "0"]


def package(name):
    """{path: bytes}, of a zip file those within it."""
    own = [question("block-1", KEY, ZERO)] if name == "cloze" else [question("block-1", KEY), question("block-2", ZERO)]
    found = written("moodle" if name == "cloze" else name, own)
    if "package.zip" not in found:
        return found
    with ZipFile(io.BytesIO(found["package.zip"])) as files:
        return {path: files.read(path) for path in files.namelist()}


def zipped(files):
    data = io.BytesIO()
    with ZipFile(data, "w") as found:
        for path, text in files.items():
            found.writestr(path, text)
    return {"package.zip": data.getvalue()}


def agrees(name, files, folder):
    """Is every answer marked and told as `grade` does, those of other writings as known of the system?"""
    if name in ("qti21", "canvas"):
        files = zipped(files)
    more = (on_disk(files, folder),) if name == "prairielearn" else ()
    read = getattr(course_systems, "moodle" if name == "cloze" else name)(files, *more)
    fields = [(read["block-1"]["a"], KEY), (read["block-1"]["b"] if name == "cloze" else read["block-2"]["a"], ZERO)]
    unread = 0
    for field, key in fields:
        here, scale = grades(key), 10.0 ** 3 if name == "canvas" and key is KEY else 1.0
        for value in numbers(key):
            verdict, said = field(repr(value * scale))
            if name == "canvas":
                kept = float(course_systems.rounded_by_canvas(value * scale)) / scale
                if abs(abs(kept - key["value"]) - key["band"]) > 1e-9 and verdict != here(repr(kept))[0]:
                    return False
            elif (verdict, said.partition(":")[0]) != here(repr(value)):
                return False
        unread += sum(field(text)[0] == "unreadable" for text in TEXTS[:5])
    return unread == (6 if name == "cloze" else 10)


def numbers(key):
    value, band = key["value"], key["band"]
    return [value, *(value + side * band * (1 + part) for side in (1, -1) for part in (0, 1e-9, -1e-9)),
            *(one["value"] for one in key["mistakes"]), value + 1.7 * band, value - 1.7 * band, 1.0]


def found_out(name, change, folder):
    files = package(name)
    spoilt = {path: change(data) for path, data in files.items()}
    assert spoilt != files, "nothing was changed"
    try:
        return not agrees(name, spoilt, folder)
    except (AssertionError, KeyError, ValueError, IndexError, StopIteration, SyntaxError):
        return True


def swapped(old, new, count=1):
    return lambda data: data.replace(old.encode(), new.encode(), count)


RIGHT = repr(KEY["value"])
MUTATIONS = {
    "moodle: band doubled": ("moodle", swapped("<tolerance>6", "<tolerance>12")),
    "moodle: no tolerance": ("moodle", swapped("<tolerance>6", "<tolerance>0")),
    "moodle: a mistake is right": ("moodle", swapped('fraction="0"', 'fraction="100"')),
    "moodle: the key is wrong": ("moodle", swapped('fraction="100"', 'fraction="0"')),
    "moodle: unit in the key": ("moodle", swapped(f"<text>{RIGHT}</text>", f"<text>{RIGHT} m</text>")),
    "moodle: comma in the key": ("moodle", swapped(f"<text>{RIGHT}</text>", "<text>0,0123456</text>")),
    "cloze: mistake before key": ("cloze", swapped("NUMERICAL:=", "NUMERICAL:%0%1:9~=")),
    "cloze: all wrong": ("cloze", swapped("NUMERICAL:=", "NUMERICAL:%0%")),
    "cloze: a field is no field": ("cloze", swapped("NUMERICAL:=0.0123456:", "NUMERICAL=0.0123456:")),
    "cloze: other feedback": ("cloze", swapped("#weight", "#cycles")),
    "prairielearn: no atol": ("prairielearn", swapped(' atol="0"', "")),
    "prairielearn: band doubled": ("prairielearn", swapped('"rtol": {"a": "0.00502', '"rtol": {"a": "0.01004')),
    "prairielearn: significant figures": ("prairielearn", swapped('"relabs"', '"sigfig"')),
    "prairielearn: fractions": ("prairielearn", swapped(' allow-fractions="false"', "")),
    "prairielearn: key of another": ("prairielearn", swapped('"correct_answers": {"a": 0.0123456}',
                                                             '"correct_answers": {"a": 0.0123465}')),
    "qti21: an edge is left out": ("qti21", lambda data: data.replace(b"gte>", b"gt>").replace(
        repr(KEY["value"] - KEY["band"] * (1 + 1e-12) - 1e-15 * KEY["value"]).encode(),
        repr(KEY["value"] - KEY["band"]).encode())),
    "qti21: bounds exchanged": ("qti21", lambda data: data.replace(b"gte>", b"x>").replace(b"lte>", b"gte>").replace(
        b"x>", b"lte>")),
    "qti21: another mistake is told": ("qti21", swapped('identifier="M1" showHide', 'identifier="M2" showHide')),
    "canvas: a mistake has an interval": ("canvas", lambda data: data.replace(
        b"<respcondition continue=\"Yes\"><conditionvar><other/>", b"<respcondition continue=\"Yes\"><conditionvar>"
        b"<vargte>12.4</vargte><varlte>12.43</varlte>", 1)),
    "canvas: asked in metres": ("canvas", lambda data: data.replace(b">12.28", b">0.01228").replace(
        b">12.40", b">0.01240")),
}


@pytest.mark.parametrize("name", ["moodle", "cloze", "prairielearn", "qti21", "canvas"])
def test_what_is_not_spoilt_agrees(name, tmp_path):
    assert agrees(name, package(name), tmp_path)


@pytest.mark.parametrize("what", MUTATIONS)
def test_what_is_spoilt_is_found(what, tmp_path):
    name, change = MUTATIONS[what]
    assert found_out(name, change, tmp_path)


def test_how_many_there_are():
    assert len(MUTATIONS) == 20
