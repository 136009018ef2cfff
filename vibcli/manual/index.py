"""Every word that can be looked up, and the pages under it."""

from collections.abc import Callable
from typing import Any

from vibcli.base.units import UNITS
from vibcli.elements.shapes import NEEDS
from vibcli.manual import elements, subjects, topics
from vibcli.manual.aliases import ALIASES
from vibcli.manual.catalogue import Catalogue
from vibcli.manual.expressions import FUNCTIONS
from vibcli.manual.layout import blocks
from vibcli.quantities import FAMILIES
from vibcli.reader.read import SECTIONS
from vibcli.reader.sections.find import FIND
from vibcli.report.json_keys import KEYS
from vibcli.symbolic.parser import plain_name


class Index:
    """Words to pages: `entries[word]` is a list of (kind of page, page function, its arguments)."""

    def __init__(self) -> None:
        self.catalogue, self.entries = Catalogue(), {}
        for word in topics.TOPICS:
            self._add(word, "topic", subjects.topic_page, word)
        for section in SECTIONS:
            self._add(section, "section", elements.section_page, section)
        for word in self.catalogue.elements:
            if word not in SECTIONS:
                self._add(word, "element", elements.element_page, word)
        for word, key in self.catalogue.pairs():
            self._add(f"{word}.{key}", "key", elements.key_page, word, key)
            if key not in self.catalogue.elements or word not in ("body", "request"):
                self._add(key, "key", elements.key_page, word, key)
        subjects_of = (("find", subjects.find_page, FIND), ("quantity", subjects.quantity_page, FAMILIES),
                       ("shape", subjects.shape_page, NEEDS), ("function", subjects.function_page, FUNCTIONS),
                       ("unit", subjects.unit_page, UNITS))
        for kind, function, words in subjects_of:
            for word in words:
                self._add(word, kind, function, word)
        for word in dict.fromkeys(key.replace("[]", "").split(".")[-1] for key in KEYS):
            self._add(word, "json", subjects.json_page, word)

    def _add(self, word: str, kind: str, function: Callable[..., Any], *arguments: str) -> None:
        self.entries.setdefault(word, []).append((kind, function, arguments))

    def found(self, word: str) -> str:
        """The word of the manual that is meant: as written, in lower case, or by another name; None if none is."""
        text = " ".join(word.replace("_", " ").split())
        singular = {section: declared.word for section, declared in self.catalogue.sections.items()}
        head, dot, key = plain_name(word.strip("`'\" ")).replace(" ", ".").partition(".")
        spellings = [word, plain_name(word), text, text.replace(" ", "_"), singular.get(head, head) + dot + key]
        for spelling in [*spellings, *(spelling.lower() for spelling in spellings)]:
            spelling = ALIASES.get(spelling, spelling)
            if spelling in self.entries:
                return str(spelling)
        return None

    def page(self, word: str) -> str:
        """The pages of a word, one below the other; scenes only with the main one."""
        entries = self.entries[word]
        if len(entries) == 1:
            _, function, arguments = entries[0]
            return str(function(self.catalogue, *arguments))
        pages = []
        for kind, function, arguments in entries:
            options = {"scene": False} if kind == "key" else {}
            pages.append(function(self.catalogue, *arguments, **options))
        return blocks(*([page] for page in pages))


def page(word: str) -> str:
    """The page of a word of the manual; KeyError where there is none."""
    index = Index()
    found = index.found(word)
    if found is None:
        raise KeyError(word)
    return index.page(found)


def words() -> list[str]:
    """Every word that has a page."""
    return sorted({*Index().entries, *ALIASES})


def nearest_words(word: str) -> list[str]:
    """Up to three words that have a page and look like this one."""
    from difflib import get_close_matches

    known = {known.lower(): known for known in words() if len(known) > 2}
    return [known[near] for near in get_close_matches(word.lower(), known, 3, 0.55)]
