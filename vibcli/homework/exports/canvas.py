"""Canvas: QTI 1.2 in its own profile, a quiz with a group of questions for each key, of which one is picked.

A numerical question of Canvas has one answer in a closed interval; each interval that a package holds is a right
answer, so that mistakes stand in what is said of a wrong one. Keys are asked in units in which they lie between 0.1 and
1000.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from vibcli.base.decoding import cleaned
from vibcli.homework.exports.asking import FIGURE, asked, figure_html
from vibcli.homework.exports.escaping import address, attribute
from vibcli.homework.exports.in_range import unit_in_range
from vibcli.homework.exports.item import ExportedKey, ExportedQuestion, plain_name, told
from vibcli.homework.exports.setting import TEX, html, running
from vibcli.homework.exports.told import RIGHT
from vibcli.homework.exports.zipped import zipped
from vibcli.notation.as_printed import as_printed
from vibcli.notation.numbers import in_figures

if TYPE_CHECKING:
    from vibcli.homework.course import Course

FILE = "package.zip"
HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
SCHEMA = 'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="{0} {1}"'
QTI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
META = "http://canvas.instructure.com/xsd/cccv1p0"
CONTENT = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
BASE = "$IMS-CC-FILEBASE$/"


def package(course: "Course", questions: Sequence[ExportedQuestion]) -> Iterator[tuple[str, bytes]]:
    """(path, bytes) of the files."""
    name = plain_name(course.title or "Homework")
    beside: dict[str, bytes] = {}
    for group, members in groupby(questions, key=lambda one: one.group):
        beside |= dict(_files(group, next(members)))
    yield FILE, zipped({
        "imsmanifest.xml": _manifest(name, list(beside)).encode(),
        f"{name}/assessment_meta.xml": _meta(course, name, questions),
        f"{name}/{name}.xml": _assessment(course, name, questions).encode(), **beside})


def _files(group: str, one: ExportedQuestion) -> Iterator[tuple[str, bytes]]:
    if one.figure is not None:
        yield f"files/{group}/{FIGURE}", one.figure.draw("svg")
    for name, data in one.files.items():
        yield f"files/{group}/{name}", data


def _assessment(course: "Course", name: str, questions: Sequence[ExportedQuestion]) -> str:
    groups = []
    for group, members in groupby(questions, key=lambda one: one.group):
        members = list(members)
        for i, key in enumerate(members[0].keys):
            items = [_item(one, one.keys[i]) for one in members]
            groups.append(_group(f"{group}-{key.letter}", members[0], key, items))
    title = attribute(cleaned(course.title or "Homework"))
    return (f'{HEAD}<questestinterop xmlns="{QTI}" {SCHEMA.format(QTI, QTI + "p1.xsd")}>\n<assessment ident="{name}" '
            f'title="{title}"><qtimetadata><qtimetadatafield><fieldlabel>cc_maxattempts</fieldlabel><fieldentry>1'
            '</fieldentry></qtimetadatafield></qtimetadata>\n<section ident="root_section">\n' + "\n".join(groups)
            + "\n</section>\n</assessment>\n</questestinterop>\n")


def _group(ident: str, question: ExportedQuestion, key: ExportedKey, items: list[str]) -> str:
    title = attribute(cleaned(f"{question.title} ({key.letter})"))
    return (f'<section ident="{ident}" title="{title}"><selection_ordering><selection><selection_number>1'
            f"</selection_number><selection_extension><points_per_item>{key.points:g}</points_per_item>"
            "</selection_extension></selection></selection_ordering>\n" + "\n".join(items) + "\n</section>")


def _item(one: ExportedQuestion, key: ExportedKey) -> str:
    kind = "essay_question" if one.by_hand else "numerical_question"
    key = key if one.by_hand else in_unit(one, key)
    ident, place = f"{one.item}-{key.letter}", f"{BASE}files/{one.group}/"
    links = "".join(f'<p><a href="{place}{address(name)}">{TEX.words(name)}</a></p>' for name in one.files)
    text = "\n".join([f"<p>{running(one.question, TEX)}</p>", figure_html(one, place), html(one.given, TEX), links,
                      f"<p>{asked(key, TEX, False)}</p>"])
    data = {"question_type": kind, "points_possible": f"{key.points:g}",
            "original_answer_ids": "" if one.by_hand else f"{ident}-answer",
            "assessment_question_identifierref": f"{ident}-q"}
    fields = "".join(f"<qtimetadatafield><fieldlabel>{label}</fieldlabel><fieldentry>{entry}</fieldentry>"
                     "</qtimetadatafield>" for label, entry in data.items())
    field = '<render_fib><response_label ident="answer1" rshuffle="No"/></render_fib>' if one.by_hand else (
        '<render_fib fibtype="Decimal"><response_label ident="answer1"/></render_fib>')
    title = attribute(cleaned(f"{one.item}: {one.title}"))
    return (f'<item ident="{ident}" title="{title}"><itemmetadata><qtimetadata>{fields}</qtimetadata></itemmetadata>\n'
            f"<presentation><material>{_html(text)}</material><response_str "
            f'ident="response1" rcardinality="Single">{field}</response_str></presentation>\n'
            f"{_processing(one, key)}\n</item>")


def _html(text: str) -> str:
    return f'<mattext texttype="text/html">{attribute(text)}</mattext>'


def in_unit(one: ExportedQuestion, key: ExportedKey) -> ExportedKey:
    """A key in a unit in which Canvas keeps its digits."""
    unit, factor = unit_in_range(key.value, int(key.figures), key.unit, f"{key.quantity} of {one.item}")
    return key._replace(unit=unit, value=key.value * factor, told=tuple(band.scaled(factor) for band in key.told))


def other_units(questions: Sequence[ExportedQuestion]) -> dict[str, dict[str, str]]:
    """{item: {quantity: unit}} of the keys that are asked in another unit here."""
    found: dict[str, dict[str, str]] = {}
    for one in questions:
        if not one.by_hand:
            units = {key.quantity: other for key in one.keys if (other := in_unit(one, key).unit) != key.unit}
            found |= {one.item: units} if units else {}
    return found


def _processing(one: ExportedQuestion, key: ExportedKey) -> str:
    outcomes = '<outcomes><decvar maxvalue="100" minvalue="0" varname="SCORE" vartype="Decimal"/></outcomes>'
    if one.by_hand:
        return (f'<resprocessing>{outcomes}<respcondition continue="No"><conditionvar><other/></conditionvar>'
                "</respcondition></resprocessing>")
    right = key.told[0]
    said = _wrong(one, key)
    shown = ('<respcondition continue="Yes"><conditionvar><other/></conditionvar><displayfeedback '
             'feedbacktype="Response" linkrefid="general_incorrect_fb"/></respcondition>') if said else ""
    feedback = (f'\n<itemfeedback ident="general_incorrect_fb"><flow_mat><material>{_html(said)}</material></flow_mat>'
                "</itemfeedback>") if said else ""
    return (f'<resprocessing>{outcomes}<respcondition continue="No"><conditionvar><vargte respident="response1">'
            f'{right.low!r}</vargte><varlte respident="response1">{right.high!r}</varlte></conditionvar><setvar '
            f'action="Set" varname="SCORE">100</setvar></respcondition>{shown}</resprocessing>{feedback}')


def _wrong(one: ExportedQuestion, key: ExportedKey) -> str:
    """What known mistakes give, for all who answered wrongly."""
    unit = f" {as_printed(key.unit)}" if key.unit else ""
    figures = int(key.figures)
    said = {band.mistake: in_figures((band.low + band.high) / 2, figures) for band in key.told
            if band.mistake != RIGHT}
    rows = "".join(f"<li>{TEX.words(f'{number}{unit}: {told(mistake, one.said)}')}</li>"
                   for mistake, number in said.items())
    return f"<p>Known mistakes:</p><ul>{rows}</ul>" if rows else ""


def _meta(course: "Course", name: str, questions: Sequence[ExportedQuestion]) -> bytes:
    groups = {one.group: one for one in questions}
    points = sum(one.points for one in groups.values())
    title = attribute(cleaned(course.title or "Homework"))
    return (f'{HEAD}<quiz identifier="{name}" xmlns="{META}" {SCHEMA.format(META, "https://canvas.instructure.com/xsd/cccv1p0.xsd")}>\n'
            f"<title>{title}</title>\n<description></description>\n<shuffle_answers>false</shuffle_answers>\n"
            "<scoring_policy>keep_highest</scoring_policy>\n<hide_results>always</hide_results>\n"
            f"<quiz_type>assignment</quiz_type>\n<points_possible>{points:.1f}</points_possible>\n"
            "<show_correct_answers>false</show_correct_answers>\n<allowed_attempts>1</allowed_attempts>\n"
            "<available>false</available>\n</quiz>\n").encode()


def _manifest(name: str, beside: list[str]) -> str:
    resources = [
        f'<resource identifier="{name}" type="imsqti_xmlv1p2"><file href="{name}/{name}.xml"/><dependency '
        f'identifierref="{name}-meta"/></resource>',
        f'<resource identifier="{name}-meta" type="associatedcontent/imscc_xmlv1p1/learning-application-resource" '
        f'href="{name}/assessment_meta.xml"><file href="{name}/assessment_meta.xml"/></resource>',
        *(f'<resource identifier="{name}-file-{i}" type="webcontent" href="{attribute(path)}"><file '
          f'href="{attribute(path)}"/></resource>' for i, path in enumerate(beside, 1))]
    return (f'{HEAD}<manifest identifier="{name}-manifest" xmlns="{CONTENT}">\n<metadata><schema>IMS Content</schema>'
            "<schemaversion>1.1.3</schemaversion></metadata>\n<organizations/>\n<resources>\n" + "\n".join(resources)
            + "\n</resources>\n</manifest>\n")
