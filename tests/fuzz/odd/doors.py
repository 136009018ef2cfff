"""The program, run on a scene: its answers by every way that it gives them."""

import contextlib
import io
import json
import re

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.check.verdicts import check
from vibcli.cli.program import run
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem


class Refusal(Exception):
    """The program refuses a scene: its exit code and the sentence."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code, self.message = code, message


def printed(*words):
    """What a command prints; Refusal where it does not end well."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = run([str(word) for word in words])
    if code:
        raise Refusal(code, err.getvalue() or out.getvalue())
    return out.getvalue()


def data(*words):
    return json.loads(printed(*words, "--json"))


def schema():
    """The JSON schema of scenes."""
    return json.loads(printed("schema"))


def words_of(topic):
    """The words that a page of the manual explains."""
    return re.findall(r"^  ([a-z]\w*)  +\S", printed("explain", topic), re.M)


def values(text, asked, path):
    """{quantity: value or Refusal} of what `answers` can ask of a scene, whose records lie beside `path`."""
    answers = "".join(f"  {quantity!r}: {{value: {unit}, rtol: 1 %}}\n".replace("'", '"') if "'" not in quantity
                      else f'  "{quantity}": {{value: {unit}, rtol: 1 %}}\n' for quantity, unit in asked.items())
    node, diagnostics = read((text + "answers:\n" + answers).encode(), str(path))
    try:
        verdicts = check(Problem(read_spec(node, str(path), diagnostics)))
    except (PhysicsError, SpecError) as error:
        raise Refusal(4, str(error)) from error
    return {quantity: Refusal(4, verdict.refusal.message) if verdict.refusal else verdict.found
            for quantity, verdict in zip(asked, verdicts, strict=True)}
