"""The keys of the JSON of what is found about modes, each said in the file that writes the section of a word."""

from collections.abc import Sequence
from importlib import import_module

from vibcli.report.keys import Key
from vibcli.report.sections import SECTIONS


def section_keys(words: Sequence[str]) -> tuple[Key, ...]:
    """The Key of each word of `find`."""
    return tuple(import_module(f"vibcli.report.sections.{SECTIONS[word][0]}").KEY for word in words)
