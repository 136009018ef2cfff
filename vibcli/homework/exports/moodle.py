"""Moodle XML: a category of questions for each problem, from which a quiz draws.

Moodle takes the first answer that matches, |x − a| ≤ tolerance, and gives what this says: the key stands first, then
the bands of mistakes at 0, each about its middle. One key is a numerical question, several are one cloze question; what
is marked by hand is an essay, with the key for who marks.
"""

from base64 import b64encode
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from itertools import groupby
from typing import TYPE_CHECKING

from vibcli.base.decoding import cleaned
from vibcli.homework.exports.asking import asked, figure_html, key_html
from vibcli.homework.exports.escaping import address, attribute, cdata
from vibcli.homework.exports.item import ExportedKey, ExportedQuestion, told, whole_weights
from vibcli.homework.exports.setting import TEX, html, running
from vibcli.homework.exports.told import RIGHT

if TYPE_CHECKING:
    from vibcli.homework.course import Course

FILE = "questions.xml"
PLACE = "@@PLUGINFILE@@/"
ADDED = 1e-14           # of the larger of answer and tolerance: what Moodle adds to a tolerance
ESSAY = ("<responseformat>editor</responseformat><responserequired>1</responserequired>"
         "<responsefieldlines>10</responsefieldlines><attachments>0</attachments>"
         "<attachmentsrequired>0</attachmentsrequired>")


def package(course: "Course", questions: Sequence[ExportedQuestion]) -> Iterator[tuple[str, bytes]]:
    """(path, bytes) of the files."""
    found = ['<?xml version="1.0" encoding="UTF-8"?>', "<quiz>"]
    for group, members in groupby(questions, key=lambda one: one.group):
        members = list(members)
        found.append(_category(course, group, members[0]))
        beside = _files(members[0])
        found += [_question(one, beside) for one in members]
    yield FILE, "\n".join([*found, "</quiz>", ""]).encode()


def _category(course: "Course", group: str, question: ExportedQuestion) -> str:
    """Its name holds that of the problem, so that no two are one; / within a name is written twice."""
    steps = [course.title or "Homework", f"{question.title} ({group})"]
    path = "/".join(["$course$", "top", *(" ".join(cleaned(step).split()).replace("/", "//") for step in steps)])
    return (f'<question type="category"><category>{_text(path)}</category>'
            f'<info format="html"><text></text></info><idnumber>{group}</idnumber></question>')


def _question(one: ExportedQuestion, beside: str) -> str:
    kind, body = (("essay", _essay) if one.by_hand else ("cloze", _cloze) if len(one.keys) > 1 else
                  ("numerical", _numerical))
    text, rest = body(one)
    return "\n".join([f'<question type="{kind}">', f"<name>{_text(f'{one.item}: {one.title}')}</name>",
                      f'<questiontext format="html">{_html(text)}{beside}</questiontext>',
                      f'<generalfeedback format="html">{_html(html(one.solution, TEX))}</generalfeedback>',
                      f"<defaultgrade>{one.points:.7f}</defaultgrade><penalty>0.3333333</penalty><hidden>0</hidden>"
                      f"<idnumber>{one.item}</idnumber>", rest, "</question>"])


def _text(text: str) -> str:
    return f"<text>{attribute(cleaned(text))}</text>"


def _html(text: str) -> str:
    return f"<text>{cdata(text)}</text>"


def _head(one: ExportedQuestion) -> str:
    """The question with its figure and values."""
    links = "".join(f'<p><a href="{PLACE}{address(name)}">{TEX.words(name)}</a></p>' for name in one.files)
    return "\n".join([f"<p>{running(one.question, TEX)}</p>", figure_html(one, PLACE), html(one.given, TEX), links])


def _files(one: ExportedQuestion) -> str:
    """What all questions of a problem show, each with a copy of its own."""
    files = dict(one.files) | ({"figure.svg": one.figure.draw("svg")} if one.figure is not None else {})
    return "".join(f'<file name="{attribute(name)}" path="/" encoding="base64">{b64encode(data).decode()}</file>'
                   for name, data in files.items())


def _numerical(one: ExportedQuestion) -> tuple[str, str]:
    key, = one.keys
    answers = "\n".join(f'<answer fraction="{100 if not mistake else 0}" format="moodle_auto_format"><text>{middle!r}'
                        f'</text><tolerance>{width!r}</tolerance><feedback format="html">'
                        f"{_html(TEX.words(told(mistake, one.said)))}</feedback></answer>"
                        for middle, width, mistake in _answers(key))
    rest = "<unitgradingtype>0</unitgradingtype><unitpenalty>0.1</unitpenalty><showunits>3</showunits>"
    return f"{_head(one)}\n<p>{asked(key, TEX, False)}</p>", answers + rest + "<unitsleft>0</unitsleft>"


def _answers(key: ExportedKey) -> Iterator[tuple[float, float, str]]:
    """(answer, tolerance, mistake or '') in the order in which they are tried."""
    for band in key.told:
        middle = key.value if band.mistake == RIGHT else (band.low + band.high) / 2
        width = (band.high - band.low) / 2
        yield middle, max(width - ADDED * max(width, abs(middle)), 0.0), band.mistake


def _cloze(one: ExportedQuestion) -> tuple[str, str]:
    weights = whole_weights([key.points for key in one.keys])
    lines = [f"<p>{asked(key, TEX)}<br/>{_field(key, weight, one.said)}</p>"
             for key, weight in zip(one.keys, weights, strict=True)]
    return "\n".join([_head(one), *lines]), ""


def _field(key: ExportedKey, weight: int, said: Mapping[str, str]) -> str:
    """{2:NUMERICAL:=21.9:0.1~%0%22.6:0.11#what is said}"""
    answers = [("=" if not mistake else "%0%") + f"{middle!r}:{width!r}"
               + (f"#{_within(told(mistake, said))}" if mistake else "") for middle, width, mistake in _answers(key)]
    return f"{{{weight}:NUMERICAL:{'~'.join(answers)}}}"


def _within(text: str) -> str:
    """Words within a field: HTML that Moodle decodes once more, with none of the signs that end an answer."""
    return escape(TEX.words(text)).replace("~", "&#126;")


def _essay(one: ExportedQuestion) -> tuple[str, str]:
    keys = "".join(key_html(key, TEX) for key in one.keys)
    text = "\n".join([_head(one), *(f"<p>{asked(key, TEX)}</p>" for key in one.keys)])
    return text, f'{ESSAY}<graderinfo format="html">{_html(keys)}</graderinfo>'
