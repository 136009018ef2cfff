"""Every value of every element put in another form, or left empty: a diagnostic at a place, or a scene that is read."""

import json
from pathlib import Path

import pytest
import yaml

from vibcli.base.errors import SpecError
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem

ROOT = Path(__file__).parents[2]
SCENES = sorted([*(ROOT / "vibcli" / "examples").glob("*.yaml"), *(ROOT / "problems").glob("*/*.yaml")])
LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
NAMED = ("parameters", "points", "surfaces", "bodies", "springs", "dampers", "forces", "constraints", "records",
         "cases", "coordinates", "choose", "answers", "equilibrium", "initial", "drawn")     # below them stand names
FORMS = ({"a": "1"}, ["1"], "", "no such word", [["1", "2"], {"a": ["1"]}])


def places(node, path=()):
    """((key or number, …), the same without names) of every value below a node."""
    for key, part in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
        here = *path, key
        yield here, tuple("*" if isinstance(step, int) or (i and here[i - 1] in NAMED) else step
                          for i, step in enumerate(here))
        yield from places(part, here)


def replaced(node, path, new):
    """The same with another value at a place."""
    if not path:
        return new
    found = dict(node) if isinstance(node, dict) else list(node)
    found[path[0]] = replaced(node[path[0]], path[1:], new)
    return found


def kinds():
    """{kind of place: (scene, a place of this kind in it)}, each in the shortest scene that has it."""
    found = {}
    for path in sorted(SCENES, key=lambda path: path.stat().st_size):
        whole = yaml.load(path.read_text(encoding="utf-8"), Loader=LOADER)
        for place, kind in places(whole):
            found.setdefault(kind, (path, whole, place))
    return found


KINDS = kinds()


def test_there_are_many_kinds_of_places():
    assert len(KINDS) > 250


@pytest.mark.parametrize("new", FORMS, ids=json.dumps)
def test_another_form_is_read_or_explained(new):
    for path, whole, place in KINDS.values():
        text = json.dumps(replaced(whole, place, new), indent=1).replace(': ""', ": ")
        node, diagnostics = read(text.encode(), str(path))
        try:
            assert Problem(read_spec(node, str(path), diagnostics)).scene is not None
        except SpecError as error:
            assert error.diagnostics and all(one.message and one.where for one in error.diagnostics), (place, new)
