"""The example scenes and templates that come with the package."""

import os
import re
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import vibcli
from vibcli.language.document.document import read_file

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Mapping
    from vibcli.manual.catalogue import Catalogue

FOLDERS = ("templates", "examples")
PLAINEST = "mass_spring_damper"


def folder(which: str) -> str:
    return os.path.join(os.path.dirname(vibcli.__file__), which)


@cache
def names(which: str) -> list[str]:
    """Names of the scenes in a folder of the package, sorted."""
    return sorted(name.removesuffix(".yaml") for name in os.listdir(folder(which)) if name.endswith(".yaml"))


def path(name: str) -> str:
    """The file of a template or example; None where there is none of that name."""
    places = [os.path.join(folder(which), name + ".yaml") for which in FOLDERS if name in names(which)]
    return places[0] if places else None


@cache
def text(name: Any) -> str:
    """The text of a template or example."""
    with open(path(name), encoding="utf-8") as file:
        return file.read()


def beside(name: str) -> list[str]:
    """Paths of the files that a template or example reads."""
    found = document(name).entries.get("records")
    files = [value.entries["file"][1].text for _, value in found[1].entries.values()] if found else []
    return [os.path.join(os.path.dirname(path(name)), file) for file in files]


def title(name: str) -> str:
    """The title of a template or example."""
    text: str = document(name).entries["title"][1].text
    return text


@cache
def document(name: str) -> "Mapping":
    """The document of a template or example, which nobody changes."""
    root: Mapping = read_file(path(name))[0]
    return root


def using(catalogue: "Catalogue", use: Sequence[str] | str, preferred: str | None = None) -> str:
    """The name of an example that uses a section or an (element, key): the preferred one, or the shortest."""
    for name in [preferred or PLAINEST, *sorted(names("examples"), key=lambda name: len(text(name)))]:
        if use in catalogue.used(document(name)):
            return name
    return None


def asking(head: str) -> str:
    """The name of an example whose answers ask for a quantity."""
    for name in names("examples"):
        for asked in _asked(document(name)):
            if re.search(rf"(?<![\w.]){head}[\[(]|^{head}$", asked):
                return name
    return None


def _asked(root: "Mapping") -> list[str]:
    keys = list(root.entries["answers"][1].entries) if "answers" in root.entries else []
    if "cases" in root.entries:
        for _, part in root.entries["cases"][1].entries.values():
            keys += _asked(part)
    return keys
