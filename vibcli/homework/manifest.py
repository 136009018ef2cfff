"""The manifest of what was handed out: enough to mark it, and to show any sheet of it again.

    {form, version, title, course, due, attempt,
     problems: [{name, title, file, case, points, scene, hash, files: {name: text}, gates_off, accepted, ranges,
                 mistakes: {name: sentence},
                 variants: [{variant, values: {parameter: text}, keys: [{quantity, unit, points, value, error, figures,
                             band, mistakes: [{name, value}]}]}]}],     of equations `terms` instead of value and error,
                                                                        of what is in letters `formula` alone
     students: [{id, name, sheets: [{problem, variant}]}],       of a pool the items, an item a sheet
     exports: [{format, files, units: {item: {quantity: unit}}}],       of a pool; units other than those of the keys
     seal: a hash of all this, by which a manifest that was edited is known}
"""

import json
from collections.abc import Mapping, Sequence
from hashlib import blake2b
from typing import TYPE_CHECKING, Any

from vibcli import __version__
from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.homework.roster import Student

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.handout import Handout

MAX_BYTES = 200 * 2**20
FORM = "vibcli homework 1"
NUMBER = int, float
NAMED: dict[Any, str] = {str: "text", int: "whole number", NUMBER: "number", dict: "mapping", list: "list"}
KEY = {"quantity": str, "unit": str, "points": NUMBER}
KEYS: dict[str, dict[str, Any]] = {     # by what tells the kind of a key
    "formula": {**KEY, "formula": str, "mistakes": [{"name": str, "formula": str}]},
    "terms": {**KEY, "terms": dict, "figures": int, "band": NUMBER, "mistakes": [{"name": str, "terms": dict}]},
    "value": {**KEY, "value": NUMBER, "error": NUMBER, "figures": int, "band": NUMBER,
              "mistakes": [{"name": str, "value": NUMBER}]},
}
SHAPE: dict[str, Any] = {
    "title": str, "course": str, "due": str, "attempt": int,
    "problems": [{
        "name": str, "title": str, "file": str, "scene": str, "accepted": int, "ranges": list, "mistakes": dict,
        "files": dict, "variants": [{"variant": int, "values": dict, "keys": [KEYS]}]}],
    "students": [{"id": str, "name": str, "sheets": [{"problem": str, "variant": int}]}],
}
Assigned = Sequence[tuple[Student, Sequence[tuple["Handout", int]]]]


def manifest(course: "Course", handouts: "Sequence[Handout]", assigned: Assigned, attempt: int,
             exports: Sequence[Any] = ()) -> dict[str, Any]:
    """The manifest of sheets: (student, (problem, number of the variant) in order) of each; exports: of packages."""
    given: dict[str, set[int]] = {one.name: set() for one in handouts}
    for _, sheets in assigned:
        for handout, number in sheets:
            given[handout.name].add(number)
    problems = [{"name": one.name, "title": one.title, "file": one.course.path, "case": one.course.case,
                 "points": one.course.points, "hash": blake2b(one.text.encode(), digest_size=16).hexdigest(),
                 "gates_off": list(one.rules.without), "accepted": one.accepted, "ranges": one.ranges,
                 "mistakes": one.sentences,
                 "variants": [one.data(number) for number in sorted(given[one.name])], "scene": one.text,
                 "files": {name: data.decode() for name, data in one.document.files.items()}}
                for one in handouts]
    students = [{"id": student.id, "name": student.name,
                 "sheets": [{"problem": handout.name, "variant": number + 1} for handout, number in sheets]}
                for student, sheets in assigned]
    found = {"form": FORM, "version": __version__, "title": course.title, "course": course.course, "due": course.due,
             "attempt": attempt, "problems": problems, "students": students,
             **({"exports": list(exports)} if exports else {})}
    return {**found, "seal": seal(found)}


def seal(found: Mapping[str, Any]) -> str:
    """A hash of all that a manifest says beside it."""
    text = json.dumps({key: value for key, value in found.items() if key != "seal"}, sort_keys=True)
    return blake2b(text.encode(), digest_size=16).hexdigest()


def read_manifest(path: str) -> dict[str, Any]:
    """A manifest that was written; SpecError where it is none."""
    def refused(message: str, hint: str | None = None) -> SpecError:
        return SpecError([Diagnostic(Where(path, 1, 1, 0), message, hint)])

    try:
        with open(path, "rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise refused(f"the manifest cannot be read: {error.strerror}") from None
    if len(data) > MAX_BYTES:
        raise refused(f"the manifest is longer than {MAX_BYTES} bytes")
    try:
        found = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise refused(f"this is no manifest: {error}", "it is the manifest.json beside the keys") from None
    if not isinstance(found, dict) or found.get("form") != FORM:
        raise refused("this is no manifest of this version", "it is the manifest.json beside the keys")
    if (damaged := _unlike(found, SHAPE, "")) is not None:
        raise refused(f"this manifest is damaged: {damaged}", "take the one that was written, unchanged")
    if found.get("seal") != seal(found):
        raise refused("this manifest was changed after it was written", "take the one that was written, unchanged")
    return found


def _unlike(value: object, shape: object, path: str) -> str | None:
    """Where a value has not the shape of a manifest, in words; None where it has."""
    if shape is KEYS and isinstance(value, dict):
        shape = KEYS[next((kind for kind in KEYS if kind in value), "value")]
    if isinstance(shape, dict) and isinstance(value, dict):
        return next((said for key, inner in shape.items()
                     if (said := _unlike(value.get(key), inner, f"{path}.{key}".lstrip("."))) is not None), None)
    if isinstance(shape, list) and isinstance(value, list):
        return next((said for i, one in enumerate(value)
                     if (said := _unlike(one, shape[0], f"{path}[{i}]")) is not None), None)
    if isinstance(shape, (tuple, type)) and isinstance(value, shape) and not isinstance(value, bool):
        return None
    kind = type(shape) if isinstance(shape, (dict, list)) else shape
    return f"{path} is missing, or no {NAMED[kind]}"
