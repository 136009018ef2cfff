"""The same as other programs read it: JSON, JUnit's XML, GitHub's annotations, SARIF.

JUnit's XML as CI servers take it: a suite for each file, a case for each answer. Annotations by the grammar of GitHub's
workflow commands. SARIF 2.1.0 (OASIS, 2020) with what GitHub's code scanning requires: rule, level, relative file and
line.
"""

import json
import os
import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any
from urllib.parse import quote

from vibcli import __version__
from vibcli.base.diagnostics import lines_escaped
from vibcli.base.rules import DIFFERS, DOUBTFUL, FAULT, RULES, level
from vibcli.cli.checking.found import CheckedFile, Finding, findings

NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
WHOLE = "scene"         # the name of what is no answer's
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def as_json(found: Sequence[CheckedFile]) -> str:
    """All verdicts, each with its rule; and what keeps files, or answers of them, from being checked."""
    data = [{"file": one.file, "exit_code": one.code, "diagnostics": list(_diagnostics(one)),
             "answers": [answer.data | {"rule": answer.rule or None} for answer in one.answers]} for one in found]
    return json.dumps(data, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def _diagnostics(found: CheckedFile) -> Iterator[dict[str, Any]]:
    """The troubles of a file as data: of a file as a whole there is neither line nor column."""
    if found.fault:
        yield _diagnostic(FAULT, found.fault, None, (found.file, 1, 1, 0))
    for one in found.troubles:
        yield _diagnostic(one.rule, one.message, one.hint, one.place or (found.file, 1, 1, 0))


def _diagnostic(rule: str, message: str, hint: str | None, place: tuple[str, int, int, int]) -> dict[str, Any]:
    file, line, column, width = place
    return {"rule": rule, "message": message, "hint": hint, "file": file, "line": line if width else None,
            "column": column if width else None, "width": width or None}


def as_junit(found: Sequence[CheckedFile]) -> str:
    """A suite for each file, a case for each answer; what is no answer's is a case named `scene`."""
    from xml.etree import ElementTree as xml

    tree = xml.TreeBuilder()
    tree.start("testsuites", {"name": "vibcli check"})
    for one in found:
        cases: dict[str, tuple[int, list[Finding]]] = {answer.name: (answer.place[0], []) for answer in one.answers}
        for finding in (each for each in findings(one) if each.rule != DOUBTFUL):
            cases.setdefault(finding.name or WHOLE, (finding.line, []))[1].append(finding)
        differ = [all(finding.rule == DIFFERS for finding in wrong) for _, wrong in cases.values() if wrong]
        file = _clean(one.file)
        tree.start("testsuite", {"name": file, "tests": str(len(cases)), "failures": str(sum(differ)),
                                 "errors": str(len(differ) - sum(differ))})
        for name, (line, wrong) in cases.items():
            tree.start("testcase", {"classname": file, "name": _clean(name), "file": file, "line": str(line)})
            for finding in wrong:
                kind = "failure" if finding.rule == DIFFERS else "error"
                tree.start(kind, {"type": finding.rule, "message": _clean(finding.message)})
                tree.data(_clean(f"{finding.file}:{finding.line}: {finding.message}"))
                tree.end(kind)
            tree.end("testcase")
        tree.end("testsuite")
    tree.end("testsuites")
    top = tree.close()
    xml.indent(top)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + xml.tostring(top, encoding="unicode") + "\n"


def _clean(text: str) -> str:
    """Text without what XML cannot hold."""
    return NOT_IN_XML.sub("\N{REPLACEMENT CHARACTER}", text)


def as_annotations(found: Sequence[CheckedFile]) -> str:
    """A line for each thing that is wrong, which GitHub shows at its line of a change."""
    told = []
    for one in (finding for each in found for finding in findings(each)):
        places = {"file": _relative(one.file), "line": one.line}
        if one.column:
            places |= {"col": one.column, "endColumn": one.column + one.width}
        places["title"] = one.rule
        properties = ",".join(f"{key}={_property(str(value))}" for key, value in places.items())
        told.append(f"::{level(one.rule)} {properties}::{_data(one.message)}\n")
    return "".join(told)


def _data(text: str) -> str:
    return lines_escaped(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")


def _relative(file: str) -> str:
    """The name of a file from the top of the repository in which the command runs, from where it runs if that is in
    none; the whole name of a file elsewhere."""
    try:
        here = os.getcwd()
    except OSError:         # a folder that is gone
        return file
    top = next((folder for folder in _upwards(here) if os.path.exists(os.path.join(folder, ".git"))), here)
    folder, name = os.path.split(file)
    whole = os.path.join(os.path.realpath(folder), name)
    path = os.path.relpath(whole, top)
    return (whole if path.split(os.sep)[0] == os.pardir else path).replace(os.sep, "/")


def _upwards(folder: str) -> Iterator[str]:
    """A folder, and those that it lies in."""
    yield folder
    while folder != (above := os.path.dirname(folder)):
        yield (folder := above)


def as_sarif(found: Sequence[CheckedFile]) -> str:
    """One run, a result for each thing that is wrong."""
    results = []
    for one in (finding for each in found for finding in findings(each)):
        region = {"startLine": one.line}
        if one.column:
            region |= {"startColumn": one.column, "endColumn": one.column + one.width}
        name = _relative(one.file)
        artifact = {"uri": f"file://{quote(os.fsencode(name))}"} if os.path.isabs(name) else {
            "uri": quote(os.fsencode(name)), "uriBaseId": "%SRCROOT%"}
        place = {"artifactLocation": artifact, "region": region}
        results.append({"ruleId": one.rule, "ruleIndex": list(RULES).index(one.rule), "level": level(one.rule),
                        "message": {"text": one.message}, "locations": [{"physicalLocation": place}]})
    rules = [{"id": name, "shortDescription": {"text": about}, "defaultConfiguration": {"level": level(name)},
              "help": {"text": f"vibcli explain {name}"}} for name, about in RULES.items()]
    driver = {"name": "vibcli", "version": __version__, "semanticVersion": __version__, "rules": rules}
    run = {"tool": {"driver": driver}, "columnKind": "unicodeCodePoints", "results": results}
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, ensure_ascii=False, indent=1) + "\n"


FORMS: dict[str, tuple[Callable[[Sequence[CheckedFile]], str], tuple[str, ...]]] = {
    "json": (as_json, (".json",)),          # name: (what makes its text, suffixes of its files)
    "junit": (as_junit, (".xml",)),
    "github": (as_annotations, (".txt",)),
    "sarif": (as_sarif, (".sarif", ".sarif.json")),
}
