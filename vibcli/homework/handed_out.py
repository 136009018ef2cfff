"""What a manifest says was handed out, as it was: scenes, variants and keys of then, whatever the files are now."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import SpecError
from vibcli.homework.bands import Band
from vibcli.homework.course import Course, CoursePart, CourseProblem
from vibcli.homework.document import SceneDocument
from vibcli.homework.equation_keys import EquationValue
from vibcli.homework.formula_keys import FormulaValue
from vibcli.homework.gates import Wrong
from vibcli.homework.handout import Handout
from vibcli.homework.keys import KeyValue
from vibcli.homework.manifest import KEYS
from vibcli.homework.roster import Student
from vibcli.homework.variants import ProblemVariant
from vibcli.language.document.document import Scalar, read
from vibcli.language.given_values import giver, number_and_unit
from vibcli.language.reader import Expression
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.homework.manifest import Assigned
    from vibcli.language.given_values import GivenValue


def handed_out(manifest: Mapping[str, Any], patience: int = 1) -> "tuple[Course, list[Handout], Assigned, int]":
    """(course, problems, who got what, attempt) of a manifest."""
    handouts = [handout_of(one, patience) for one in manifest["problems"]]
    by_name = {one.name: one for one in handouts}
    assigned = [(Student(one["id"], one["name"]), [(by_name[sheet["problem"]], sheet["variant"] - 1)
                                                   for sheet in one["sheets"]]) for one in manifest["students"]]
    course = Course(manifest["title"], manifest["course"], manifest["due"],
                    tuple(CoursePart((one.course,), 1) for one in handouts))
    return course, handouts, assigned, manifest["attempt"]


def handout_of(one: "Mapping[str, Any]", patience: int = 1) -> Handout:
    """The Handout of a problem of a manifest."""
    node, diagnostics = read(one["scene"].encode(), one["file"])
    if node is None or diagnostics:
        raise SpecError(diagnostics)
    files = {name: text.encode() for name, text in one["files"].items()}
    document = SceneDocument.of(node, one["file"], one["case"], files=files)
    course = CourseProblem(one["name"], one["file"], one["case"], one["points"])
    variants = {variant["variant"] - 1: _variant(variant) for variant in one["variants"]}
    return Handout.read(course, variants, one["mistakes"], document, one["scene"], one["accepted"],
                        [tuple(ends) for ends in one["ranges"]], patience)


def _variant(found: Mapping[str, Any]) -> ProblemVariant:
    values = {name: _value(name, text) for name, text in found["values"].items()}
    return ProblemVariant((), values, tuple(map(_key, found["keys"])))


def _key(key: Mapping[str, Any]) -> FormulaValue | EquationValue | KeyValue:
    kind = next(kind for kind in KEYS if kind in key)
    wrong = tuple(Wrong(one["name"], one[kind]) for one in key["mistakes"])
    if kind == "formula":
        return FormulaValue(key["formula"], wrong)
    band = Band(key["figures"], key["band"])
    return EquationValue(key["terms"], band, wrong) if kind == "terms" else KeyValue(key["value"], key["error"], band,
                                                                                     wrong)


def _value(name: str, text: str) -> "GivenValue":
    number, unit = number_and_unit(Expression(Scalar(text, None), parse(text)))
    return giver(unit, name)(number)
