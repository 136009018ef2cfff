"""What the declarations declare: every element with its keys, and where in a scene it stands."""

from typing import Any

from vibcli.language import sections
from vibcli.language.document.document import Mapping, Scalar, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, MotionField, NameOf, OneOf
from vibcli.language.named_elements import Lazy, LazyKind, Named, load
from vibcli.language.reader import article
from vibcli.reader import sections as questions
from vibcli.reader.read import SECTIONS

FACES = (("language.sections", sections.NAMES), ("reader.sections", questions.NAMES))


class Declared:
    """An element of the language: its word, its kind, what it is, and the places where it may stand; where it has other
    keys within some elements than within others, its kinds by the words of those."""

    __slots__ = ("about", "kind", "kinds", "places", "section", "word")

    def __init__(self, word: str, kind: Element | MotionField | NameOf, about: str, section: str | None) -> None:
        self.word, self.about, self.section, self.places = word, about, section, []
        self.kind: Any = kind
        self.kinds: dict[str, Element] = {}

    @property
    def fields(self) -> dict[str, Field]:
        """Its keys, those of all its kinds."""
        found: dict[str, Field] = {}
        for kind in (self.kind, *self.kinds.values()):
            if isinstance(kind, Element):
                found = {**kind.fields, **found}
        return found

    def within(self, key: str) -> list[str]:
        """The words of the elements within which alone it has a key; none where that is so in all."""
        having = [word for word, kind in self.kinds.items() if key in kind.fields]
        return [] if len(having) == len(self.kinds) else having

    @property
    def example(self) -> str | None:
        found: str | None = getattr(self.kind, "example", None)
        return found


class Catalogue:
    """All elements by word, found by walking the sections and their fields."""

    def __init__(self) -> None:
        self.elements, self.sections = {}, {}
        modules = [load(name, room) for room, names in FACES for name in names]
        self._of_kind = {id(module.KIND): module for module in modules if hasattr(module, "KIND")}
        for section in SECTIONS:
            kind = _kind(section)
            module = self._of_kind.get(id(kind))
            inner = kind.kind if isinstance(kind, Named) else kind
            whole = inner is kind and module is None
            place = f"the section `{section}`" if whole else f"an entry of `{section}`, by its name"
            if module is not None:
                inner = getattr(module, "ELEMENT", kind)
            declared = self._gather(inner, place, section)
            if declared is not None:
                self.sections[section] = declared

    def _gather(self, kind: Any, place: str, section: str | None, outer: str | None = None) -> Declared | None:
        """Enter the elements that a kind consists of, within the `outer` one; the outermost one is returned."""
        if isinstance(kind, (Many, Named)):
            return self._gather(kind.kind, place, section, outer)
        if isinstance(kind, OneOf):
            for part in kind.kinds.values():
                self._gather(part, place, section, outer)
            return None
        if not isinstance(kind, (Lazy, Element)):
            return None
        word, element, about = opened(kind)
        declared = self.elements.get(word)
        new = declared is None
        if declared is None:
            declared = self.elements[word] = Declared(word, element, about, section)
        if isinstance(element, Element) and outer is not None:
            new = new or all(element is not one for one in (declared.kind, *declared.kinds.values()))
            declared.kinds.setdefault(outer, element)
        if new and isinstance(element, Element):
            for key, field in element.fields.items():
                item = "an item of " if isinstance(field.kind, Many) else ""
                self._gather(field.kind, f"{item}the key `{key}` of {article(word)}", None, outer or word)
        if place not in declared.places:
            declared.places.append(place)
        return declared

    def about(self, section: str) -> str:
        """What a section is: the fullest text that its declarations have."""
        return getattr(self._of_kind.get(id(_kind(section))), "ABOUT", None) or SECTIONS[section][1]

    def pairs(self) -> list[tuple[str, str]]:
        """Every key of every element as (element word, key)."""
        return [(word, key) for word, declared in self.elements.items() for key in declared.fields]

    def used(self, root: Any) -> list[str | tuple[str, str]]:
        """What a scene document uses: section names, and (element word, key), each as often as it occurs."""
        found = []
        for section, (_, node) in root.entries.items():
            found.append(section)
            if section == "cases":
                for _, part in node.entries.values():
                    found += self.used(part)
            elif section in SECTIONS:
                kind = _kind(section)
                module = self._of_kind.get(id(kind))
                inner = Named(self.sections[section].kind, "") if module and section in self.sections else kind
                found += _used(inner, node)
        return found


def _kind(section: str) -> Any:
    """The kind of a section, the file of a lazy one loaded."""
    kind, _ = SECTIONS[section]
    return kind.opened if isinstance(kind, LazyKind) else kind


def opened(kind: Element | Lazy) -> tuple[str, Any, str]:
    """(word, kind, about) of an element, the file of a lazy one loaded."""
    if not isinstance(kind, Lazy):
        return kind.name, kind, kind.about
    module, element = kind.module, kind.module.ELEMENT
    return kind.name, element, element.about if isinstance(element, Element) else module.ABOUT


def _used(kind: Any, node: Scalar | Mapping | Sequence) -> list[tuple[str, str]]:
    """(element word, key) of every key that a node of a kind uses, by short forms too."""
    if isinstance(kind, Named):
        return [use for _, value in node.entries.values() for use in _used(kind.kind, value)] if isinstance(
            node, Mapping) else []
    if isinstance(kind, Many):
        return [use for item in node.items for use in _used(kind.kind, item)] if isinstance(node, Sequence) else []
    if isinstance(kind, OneOf):
        inner = kind.kinds.get(type(node))
        return _used(inner, node) if inner is not None else []
    if not isinstance(kind, (Lazy, Element)):
        return []
    word, element, _ = opened(kind)
    if not isinstance(element, Element):
        return []
    if not isinstance(node, Mapping):
        empty = isinstance(node, Scalar) and not node.text
        return [] if empty or element.short is None else [(word, element.short)]
    found = []
    for key, (_, value) in node.entries.items():
        if key in element.fields:
            found += [(word, key), *_used(element.fields[key].kind, value)]
    return found
