"""PrairieLearn: a question for each problem, in a folder of its own, whose server.py picks a variant by the seed.

`pl-number-input` accepts |x − a| ≤ atol + rtol·|a| in numbers without a unit: rtol is that of the band, atol 0, and the
unit stands behind the field. The keys lie in variants.jsonl, a line for each, which the browser never gets.
"""

import json
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any
from uuid import NAMESPACE_URL, uuid5

from vibcli.homework.exports.asking import FIGURE, asked, key_html
from vibcli.homework.exports.escaping import attribute
from vibcli.homework.exports.item import ExportedKey, ExportedQuestion, told, whole_weights
from vibcli.homework.exports.setting import SPECIAL, TEX, html, running
from vibcli.homework.exports.told import RIGHT
from vibcli.notation.as_printed import as_printed

if TYPE_CHECKING:
    from vibcli.homework.course import Course

SEEN = "clientFilesQuestion"        # what browsers may load
TABLE = "variants.jsonl"
SERVER = '''\
"""Picks a variant by the seed, and names the mistake that a wrong answer shows."""

import json
import os

COUNT = {count}


def generate(data):
    number = int(data["variant_seed"]) % COUNT
    with open(os.path.join(data["options"]["question_path"], "{table}"), encoding="utf-8") as table:
        line = next(line for i, line in enumerate(table) if i == number)
    found = json.loads(line)
    data["params"].update(found["params"])
    data["correct_answers"].update(found["correct_answers"])


def grade(data):
    for name, mistakes in data["params"].get("mistakes", {{}}).items():
        score, answer = data["partial_scores"].get(name), data["submitted_answers"].get(name)
        if score is None or score.get("score") or not isinstance(answer, (int, float)):
            continue
        said = next((said for low, high, said in mistakes if low <= answer <= high), None)
        if said is not None:
            score["feedback"] = said
'''


def package(course: "Course", questions: Sequence[ExportedQuestion]) -> Iterator[tuple[str, bytes]]:
    """(path, bytes) of the files."""
    for group, members in groupby(questions, key=lambda one: one.group):
        for path, data in _folder(course, group, list(members)):
            yield f"questions/{group}/{path}", data


def _folder(course: "Course", group: str, members: list[ExportedQuestion]) -> Iterator[tuple[str, bytes]]:
    first = members[0]
    yield "info.json", _info(course, group, first)
    yield "question.html", (_by_hand(first) if first.by_hand else _page(first)).encode()
    yield "server.py", SERVER.format(count=len(members), table=TABLE).encode()
    yield TABLE, "".join(json.dumps(_variant(one), ensure_ascii=False, allow_nan=False) + "\n"
                         for one in members).encode()
    for name, data in _seen(first).items():
        yield f"{SEEN}/{name}", data


def _info(course: "Course", group: str, question: ExportedQuestion) -> bytes:
    found = {"uuid": str(uuid5(NAMESPACE_URL, f"vibcli:{group}")), "title": question.title,
             "topic": course.title or "Homework", "tags": ["vibcli"], "type": "v3",
             **({"gradingMethod": "Manual"} if question.by_hand else {})}
    return (json.dumps(found, ensure_ascii=False, indent=1) + "\n").encode()


def _seen(question: ExportedQuestion) -> dict[str, bytes]:
    figure = {FIGURE: question.figure.draw("svg")} if question.figure is not None else {}
    return dict(question.files) | figure


def _page(question: ExportedQuestion) -> str:
    weights = whole_weights([key.points for key in question.keys])
    fields = [f'<div>{{{{{{params.asked.{key.letter}}}}}}}</div>\n<pl-number-input answers-name="{key.letter}" '
              f'comparison="relabs" rtol="{{{{params.rtol.{key.letter}}}}}" atol="0" allow-fractions="false" '
              f'weight="{weight}"'
              + f' suffix="{_still(as_printed(key.unit))}"' * bool(key.unit) + "></pl-number-input>"
              for key, weight in zip(question.keys, weights, strict=True)]
    return _framed(question, fields, "")


def _by_hand(question: ExportedQuestion) -> str:
    fields = [f'<div>{{{{{{params.asked.{key.letter}}}}}}}</div>\n<pl-rich-text-editor '
              f'file-name="{key.letter}.html"></pl-rich-text-editor>' for key in question.keys]
    return _framed(question, fields, "<pl-manual-grading-only>{{{params.key}}}</pl-manual-grading-only>\n")


def _framed(question: ExportedQuestion, fields: list[str], below: str) -> str:
    shown = [f'<pl-figure file-name="{FIGURE}" alt="{_still(question.described)}"></pl-figure>'
             ] * (question.figure is not None)
    shown += [f'<pl-file-download file-name="{_still(name)}" directory="{SEEN}"></pl-file-download>'
              for name in question.files]
    return "\n".join(["<pl-question-panel>", "{{{params.question}}}", *shown, "{{{params.given}}}",
                      "<p><small>{{params.item}}</small></p>", "</pl-question-panel>", *fields, below
                      + "<pl-answer-panel>{{{params.solution}}}</pl-answer-panel>", ""])


def _still(text: str) -> str:
    """A text of the page that no template fills."""
    return attribute(text).replace("{", SPECIAL["{"]).replace("}", SPECIAL["}"])


def _variant(question: ExportedQuestion) -> dict[str, Any]:
    """What server.py knows of a variant."""
    params: dict[str, Any] = {
        "item": question.item, "question": f"<p>{running(question.question, TEX)}</p>",
        "given": html(question.given, TEX), "asked": {key.letter: asked(key, TEX) for key in question.keys},
        "solution": html(question.solution, TEX)}
    if question.by_hand:
        return {"params": {**params, "key": "".join(key_html(key, TEX) for key in question.keys)},
                "correct_answers": {}}
    params["rtol"] = {key.letter: repr(_rtol(key)) for key in question.keys}
    params["mistakes"] = {key.letter: [[band.low, band.high, TEX.words(told(band.mistake, question.said))]
                                       for band in key.told if band.mistake != RIGHT] for key in question.keys}
    return {"params": params, "correct_answers": {key.letter: key.value for key in question.keys}}


def _rtol(key: ExportedKey) -> float:
    """The band relative to the key; of a key that is 0 nothing else is accepted."""
    right = key.told[0]
    return (right.high - right.low) / 2 / abs(key.value) if key.value else 0.0
