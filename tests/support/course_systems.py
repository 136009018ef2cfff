"""Course systems as they mark: each reads a package, and compares answers by its own rule, told from its documentation
and sources in our words. `read(files)` gives {item: {letter: marks}}; marks(text) is (verdict, what is said)."""

import io
import json
import math
import re
from decimal import ROUND_HALF_UP, Decimal
from html import unescape
from operator import ge, gt, le, lt
from types import ModuleType
from xml.etree import ElementTree
from zipfile import ZipFile

RIGHT, WRONG, UNREADABLE = "right", "wrong", "unreadable"


# Moodle: the first answer within its tolerance. PHP's precision of 14 digits is added to it.

NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?"
DIGITS = r"-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?"
FIELD = re.compile(r"\{([0-9]*):NUMERICAL:(.*?(?<!\\))\}", re.DOTALL)
PART = re.compile(rf"(=|%(-?[0-9]+)%)?({DIGITS})(?::({DIGITS}))?(?:#(.*?(?<!\\)))?(?=~|$)", re.DOTALL)


def moodle(files):
    found = {}
    quiz = ElementTree.fromstring(files["questions.xml"])
    for one in quiz.iter("question"):
        if one.get("type") == "numerical":
            answers = [(float(answer.find("text").text), float(answer.find("tolerance").text),
                        float(answer.get("fraction")), answer.find("feedback/text").text or "")
                       for answer in one.iter("answer")]
            found[one.find("idnumber").text] = {"a": _moodle(answers, False)}
        elif one.get("type") == "cloze":
            fields = FIELD.findall(one.find("questiontext/text").text)
            found[one.find("idnumber").text] = {
                letter: _moodle([(float(a), float(t or 0), 100.0 if sign == "=" else float(part), unescape(said))
                                 for sign, part, a, t, said in PART.findall(answers)], True)
                for letter, (_, answers) in zip("abcdefgh", fields, strict=False)}
    return found


def _moodle(answers, in_cloze):
    def marks(text):
        plain = re.sub(r"(?:e|E|[x*×]10(?:\^|\*\*))([+-]?\d+)", r"e\1", text.replace(" ", ""))
        plain = plain.replace(",", "")              # of thousands, where the site speaks English
        match = re.match(NUMBER, plain)
        if match is None or (plain[match.end():] and not in_cloze):
            return UNREADABLE, ""
        value = float(match[0])
        for answer, tolerance, fraction, said in answers:
            reach = tolerance + 1e-14 * max(tolerance, abs(answer), 1e-14)
            if answer - reach <= value <= answer + reach:
                return (RIGHT if fraction == 100 else WRONG), unescape(re.sub("<[^>]*>", "", said))
        return WRONG, ""
    return marks


# PrairieLearn: |x − a| ≤ atol + rtol·|a|, of numbers alone.

def element(key, rtol, atol, allow_fractions, text):
    """The verdict of `pl-number-input comparison="relabs"`."""
    value = _parsed(text, allow_fractions)
    if value is None:
        return UNREADABLE
    return RIGHT if abs(value - key) <= atol + rtol * abs(key) else WRONG


def _parsed(text, allow_fractions):
    plain = text.strip().replace("−", "-").replace("∕", "/").replace("⁄", "/").replace("÷", "/")
    parts = plain.split("/")
    if len(parts) > 2 or (len(parts) == 2 and not allow_fractions):
        return None
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        return None
    if not all(map(math.isfinite, numbers)) or (len(numbers) == 2 and not numbers[1]):
        return None
    return numbers[0] / numbers[1] if len(numbers) == 2 else numbers[0]


def prairielearn(files, folder):
    """The same; folder: where the files are written, as server.py reads its table."""
    found = {}
    for path in (path for path in files if path.endswith("question.html")):
        place = path.rpartition("/")[0]
        if json.loads(files[f"{place}/info.json"]).get("gradingMethod") == "Manual":
            continue
        server = ModuleType("server")
        exec(files[f"{place}/server.py"].decode(), server.__dict__)
        for seed in range(server.COUNT):
            data = {"params": {}, "correct_answers": {}, "variant_seed": str(seed + 3 * server.COUNT),
                    "options": {"question_path": str(folder / place)}}
            server.generate(data)
            page = _filled(files[path].decode(), data["params"])
            fields = {one.get("answers-name"): one for one in ElementTree.fromstring(page).iter("pl-number-input")}
            found[data["params"]["item"]] = {name: _prairielearn(server, data, name, one)
                                             for name, one in fields.items()}
    return found


def _filled(page, params):
    def value(match):
        found = params
        for step in match[2].split(".")[1:]:
            found = found[step]
        return found if match[1] else found.replace("&", "&amp;").replace("<", "&lt;")

    page = re.sub(r"\{\{(\{?)(params[\w.]*)\}\}\}?", value, page)
    return f"<page>{page}</page>"


def _prairielearn(server, data, name, field):
    assert field.get("comparison") == "relabs"

    def marks(text):
        key = data["correct_answers"][name]
        verdict = element(key, float(field.get("rtol")), float(field.get("atol", "1e-8")),
                          field.get("allow-fractions", "true") == "true", text)
        if verdict == UNREADABLE:
            return verdict, ""
        own = {**data, "submitted_answers": {name: _parsed(text, False)},
               "partial_scores": {name: {"score": float(verdict == RIGHT)}}}
        server.grade(own)
        return verdict, unescape(re.sub("<[^>]*>", "", own["partial_scores"][name].get("feedback", "")))
    return marks


# QTI 2.1: conditions with base values, in order.

def _tag(node):
    return node.tag.rpartition("}")[2]


def qti21(files):
    found = {}
    with ZipFile(io.BytesIO(files["package.zip"])) as package:
        for path in package.namelist():
            if path.startswith("items/"):
                item = ElementTree.fromstring(package.read(path))
                fields = [node.get("identifier").partition("_")[2] for node in item.iter()
                          if _tag(node) == "responseDeclaration" and node.get("baseType") == "float"]
                if fields:
                    found[item.get("identifier")] = {name: _qti(item, name) for name in fields}
    return found


def _qti(item, name):
    said = {(node.get("outcomeIdentifier"), node.get("identifier")): "".join(node.itertext())
            for node in item.iter() if _tag(node) == "modalFeedback"}

    def marks(text):
        try:
            value = float(text)
        except ValueError:
            return UNREADABLE, ""
        outcomes = {}
        processing = next(node for node in item.iter() if _tag(node) == "responseProcessing")
        for condition in processing:
            if _tag(condition) == "responseCondition":
                _branch(condition, {f"RESPONSE_{name}": value}, outcomes)
        verdict = RIGHT if float(outcomes[f"SCORE_{name}"]) > 0 else WRONG
        feedback = said.get((f"SAID_{name}", outcomes[f"SAID_{name}"]), "")
        return verdict, feedback.removeprefix(f"({name}) ")
    return marks


def _branch(condition, responses, outcomes):
    for branch in condition:
        test, *sets = branch if _tag(branch) != "responseElse" else (None, *branch)
        if test is None or all(_compared(sign, responses) for sign in test):
            outcomes |= {one.get("identifier"): one[0].text for one in sets}
            return


def _compared(sign, responses):
    if _tag(sign) == "variable":        # of isNull
        return responses.get(sign.get("identifier")) is None
    value = responses.get(sign[0].get("identifier"))
    if value is None:
        return False
    compare = {"gte": ge, "lte": le, "gt": gt, "lt": lt}[_tag(sign)]
    return compare(value, float(sign[1].text))


# Canvas: every interval of a package is a right answer; an answer is rounded to four decimals as it is typed.

def canvas(files):
    found = {}
    with ZipFile(io.BytesIO(files["package.zip"])) as package:
        path = next(path for path in package.namelist() if path.count("/") == 1 and path.endswith(".xml")
                    and "meta" not in path)
        for item in (node for node in ElementTree.fromstring(package.read(path)).iter() if _tag(node) == "item"):
            fields = {_tag(node): node for node in item.iter()}
            kind = next(entry.text for entry in item.iter() if _tag(entry) == "fieldentry")
            if kind == "numerical_question":
                ranges = [(Decimal(repr(float(low.text))), Decimal(repr(float(high.text))))
                          for condition in item.iter() if _tag(condition) == "conditionvar"
                          for low in condition if _tag(low) == "vargte" for high in condition if _tag(high) == "varlte"]
                assert "itemmetadata" in fields
                name, _, letter = item.get("ident").rpartition("-")
                found.setdefault(name, {})[letter] = _canvas(ranges)
    return found


def rounded_by_canvas(value):
    """A number as Canvas keeps it."""
    return Decimal(value).quantize(Decimal("0.0001"), ROUND_HALF_UP)


def _canvas(ranges):
    def marks(text):
        try:
            value = rounded_by_canvas(float(text))
        except ValueError:
            return UNREADABLE, ""
        return (RIGHT if any(low <= value <= high for low, high in ranges) else WRONG), ""
    return marks
