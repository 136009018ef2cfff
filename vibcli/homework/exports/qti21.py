"""QTI 2.1: a package with an item for each variant, and a test that picks one of each problem.

The band of a key is two comparisons with base values, low ≤ x and x ≤ high; mistakes are told as modal feedback. Bands
do not overlap, so their order does not matter.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from vibcli.base.decoding import cleaned
from vibcli.homework.exports.asking import FIGURE, asked, figure_html
from vibcli.homework.exports.escaping import address, attribute
from vibcli.homework.exports.item import ExportedKey, ExportedQuestion, plain_name, told
from vibcli.homework.exports.setting import MATHML, html, running
from vibcli.homework.exports.told import RIGHT
from vibcli.homework.exports.zipped import zipped
from vibcli.notation.as_printed import as_printed

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.exports.told import ToldBand

FILE = "package.zip"
HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
SPACE = "http://www.imsglobal.org/xsd/imsqti_v2p1"
SCHEMA = (f'xmlns="{SPACE}" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
          f'xsi:schemaLocation="{SPACE} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"')
CONTENT = "http://www.imsglobal.org/xsd/imscp_v1p1"
TEST = "test"


def package(course: "Course", questions: Sequence[ExportedQuestion]) -> Iterator[tuple[str, bytes]]:
    """(path, bytes) of the files."""
    beside: dict[str, bytes] = {}
    for one in questions:
        for name, data in _files(one):
            if name not in beside:
                beside[name] = data
    found = {f"items/{one.item}.xml": _item(one).encode() for one in questions}
    yield FILE, zipped({"imsmanifest.xml": _manifest(course, questions).encode(),
                        f"{TEST}.xml": _test(course, questions).encode(), **found, **beside})


def _files(one: ExportedQuestion) -> Iterator[tuple[str, bytes]]:
    """(path, bytes) of the files that an item shows; those of one problem are the same."""
    if one.figure is not None:
        yield f"files/{one.group}/{FIGURE}", one.figure.draw("svg")
    for name, data in one.files.items():
        yield f"files/{one.group}/{name}", data


def _item(one: ExportedQuestion) -> str:
    place = f"../files/{one.group}/"
    links = "".join(f'<p><a href="{place}{address(name)}">{MATHML.words(name)}</a></p>' for name in one.files)
    body = "\n".join([f"<div><p>{running(one.question, MATHML)}</p>", figure_html(one, place), html(one.given, MATHML),
                      links, *(f"<p>{asked(key, MATHML)}</p>{_field(key)}" for key in one.keys), "</div>"])
    return "\n".join([
        f'{HEAD}<assessmentItem {SCHEMA} identifier="{one.item}" title="{attribute(cleaned(one.title))}" '
        'adaptive="false" timeDependent="false">', *map(_response, one.keys),
        _outcome("SCORE"), _outcome("MAXSCORE", one.points),
        *(outcome for key in one.keys for outcome in _outcomes(key)), f"<itemBody>{body}</itemBody>",
        *([] if one.by_hand else [f"<responseProcessing>{''.join(_processing(one))}</responseProcessing>"]),
        *_feedback(one), "</assessmentItem>\n"])


def _field(key: ExportedKey) -> str:
    if key.value is None:
        return f'<extendedTextInteraction responseIdentifier="RESPONSE_{key.letter}" expectedLines="5"/>'
    unit = f" {MATHML.words(as_printed(key.unit))}" if key.unit else ""
    return f'<p><textEntryInteraction responseIdentifier="RESPONSE_{key.letter}" expectedLength="12"/>{unit}</p>'


def _response(key: ExportedKey) -> str:
    kind = "string" if key.value is None else "float"
    right = "" if key.value is None else f"<correctResponse><value>{key.value!r}</value></correctResponse>"
    return (f'<responseDeclaration identifier="RESPONSE_{key.letter}" cardinality="single" baseType="{kind}">{right}'
            "</responseDeclaration>")


def _outcome(name: str, value: float = 0.0, kind: str = "float") -> str:
    default = f"<defaultValue><value>{value:g}</value></defaultValue>" if kind == "float" else ""
    return (f'<outcomeDeclaration identifier="{name}" cardinality="single" baseType="{kind}">{default}'
            "</outcomeDeclaration>")


def _outcomes(key: ExportedKey) -> Iterator[str]:
    if key.value is not None:
        yield _outcome(f"SCORE_{key.letter}")
        yield _outcome(f"SAID_{key.letter}", kind="identifier")


def _processing(one: ExportedQuestion) -> Iterator[str]:
    """The score of each key and what is said of it; their sum. No answer is told apart from 0, which players may take
    it for."""
    for key in one.keys:
        said = {band.mistake: f"M{i}" for i, band in enumerate(key.told)}
        branches = "".join(f"<responseElseIf>{_within(key, band)}"
                           f"{_set(key, band.mistake == RIGHT, said[band.mistake])}</responseElseIf>"
                           for band in key.told)
        nothing, answer = _set(key, False, "NONE"), f'<variable identifier="RESPONSE_{key.letter}"/>'
        yield (f"<responseCondition><responseIf><isNull>{answer}</isNull>{nothing}</responseIf>{branches}<responseElse>"
               f"{nothing}</responseElse></responseCondition>")
    scores = "".join(f'<variable identifier="SCORE_{key.letter}"/>' for key in one.keys)
    yield f'<setOutcomeValue identifier="SCORE"><sum>{scores}</sum></setOutcomeValue>'


def _within(key: ExportedKey, band: "ToldBand") -> str:
    sides = "".join(f'<{sign}><variable identifier="RESPONSE_{key.letter}"/><baseValue baseType="float">{end!r}'
                    f"</baseValue></{sign}>" for sign, end in (("gte", band.low), ("lte", band.high)))
    return f"<and>{sides}</and>"


def _set(key: ExportedKey, is_right: bool, said: str) -> str:
    score = key.points if is_right else 0.0
    return (f'<setOutcomeValue identifier="SCORE_{key.letter}"><baseValue baseType="float">{score!r}</baseValue>'
            f'</setOutcomeValue><setOutcomeValue identifier="SAID_{key.letter}"><baseValue baseType="identifier">{said}'
            "</baseValue></setOutcomeValue>")


def _feedback(one: ExportedQuestion) -> Iterator[str]:
    for key in one.keys:
        said = {band.mistake: f"M{i}" for i, band in enumerate(key.told)}
        for mistake, name in said.items():
            if mistake != RIGHT:
                yield (f'<modalFeedback outcomeIdentifier="SAID_{key.letter}" identifier="{name}" showHide="show">'
                       f"({key.letter}) {MATHML.words(told(mistake, one.said))}</modalFeedback>")


def _test(course: "Course", questions: Sequence[ExportedQuestion]) -> str:
    """A section for each problem, of which one item is picked, within one for each part of the course."""
    groups = {group: list(members) for group, members in groupby(questions, key=lambda one: one.group)}
    parts = []
    for number, part in enumerate(course.parts, 1):
        names = {plain_name(one.name) for one in part.problems}
        own = [_section(group, members) for group, members in groups.items() if members[0].problem in names]
        pick = f'<selection select="{part.pick}"/>' if part.pick < len(part.problems) else ""
        parts.append(f'<assessmentSection identifier="part-{number}" title="{number}" visible="true">{pick}'
                     f"{''.join(own)}</assessmentSection>")
    title = attribute(cleaned(course.title or "Homework"))
    return (f'{HEAD}<assessmentTest {SCHEMA} identifier="{TEST}" title="{title}">\n<testPart identifier="all" '
            f'navigationMode="nonlinear" submissionMode="individual">\n' + "\n".join(parts)
            + "\n</testPart>\n</assessmentTest>\n")


def _section(group: str, members: list[ExportedQuestion]) -> str:
    items = "\n".join(f'<assessmentItemRef identifier="{one.item}" href="items/{one.item}.xml"/>' for one in members)
    title = attribute(cleaned(members[0].title))
    return (f'<assessmentSection identifier="{group}" title="{title}" visible="true"><selection select="1"/>\n{items}\n'
            "</assessmentSection>")


def _manifest(course: "Course", questions: Sequence[ExportedQuestion]) -> str:
    items = [_resource(one.item, "imsqti_item_xmlv2p1", f"items/{one.item}.xml", [path for path, _ in _files(one)])
             for one in questions]
    uses = "".join(f'<dependency identifierref="{one.item}"/>' for one in questions)
    test = (f'<resource identifier="{TEST}" type="imsqti_test_xmlv2p1" href="{TEST}.xml"><file href="{TEST}.xml"/>'
            f"{uses}</resource>")
    return (f'{HEAD}<manifest xmlns="{CONTENT}" identifier="{plain_name(course.title or "Homework")}">\n<metadata>'
            "<schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>\n<organizations/>\n"
            "<resources>\n" + "\n".join([test, *items]) + "\n</resources>\n</manifest>\n")


def _resource(name: str, kind: str, href: str, files: list[str]) -> str:
    shown = "".join(f'<file href="{attribute(path)}"/>' for path in files)
    return f'<resource identifier="{name}" type="{kind}" href="{href}"><file href="{href}"/>{shown}</resource>'
