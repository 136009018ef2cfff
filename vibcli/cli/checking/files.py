"""Which files are scenes, and the answers that they name, without solving anything."""

import os
from typing import TYPE_CHECKING

import click

from vibcli.homework import SET

if TYPE_CHECKING:
    from vibcli.language.document.nodes import DocumentNode, Scalar

SUFFIXES = ".yaml", ".yml"


def is_scene(name: str) -> bool:
    """Is a file of this name taken for a scene? Sets name problems; hidden files set up other programs."""
    return name.endswith(SUFFIXES) and name != SET and not is_hidden(name)


def is_hidden(name: str) -> bool:
    """Is a file or folder of this name hidden, as .github or .gitlab-ci.yml?"""
    return name.startswith(".")


def scenes_below(path: str) -> list[str]:
    """A file itself, or all scenes below a folder, sorted; a usage error where there is neither. A set, and what is
    hidden below the folder, is passed over."""
    if not os.path.isdir(path):
        if not os.path.exists(path):
            raise click.UsageError(f"there is no file or folder '{path}'")
        return [] if os.path.basename(path) == SET else [path]
    found = []
    for folder, folders, names in os.walk(path):
        folders[:] = sorted(name for name in folders if not is_hidden(name))
        found += [os.path.join(folder, name) for name in sorted(names) if is_scene(name)]
    return found


def answers_named(file: str) -> list[tuple[str, int]]:
    """(name, line) of the answers of a scene and of its cases, as far as the file can be read."""
    from vibcli.api.source import file_source

    top = file_source(file).node
    found = [(key.text, key.where.line) for key, _ in _entries(_entry(top, "answers")).values()]
    for name, (_, case) in _entries(_entry(top, "cases")).items():
        found += [(f"{name}: {key.text}", key.where.line) for key, _ in _entries(_entry(case, "answers")).values()]
    return found


def _entry(node: "DocumentNode | None", key: str) -> "DocumentNode | None":
    return _entries(node).get(key, (None, None))[1]


def _entries(node: "DocumentNode | None") -> "dict[str, tuple[Scalar, DocumentNode]]":
    entries: dict[str, tuple[Scalar, DocumentNode]] = getattr(node, "entries", {})
    return entries
