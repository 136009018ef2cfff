"""Pages of elements, their keys, and sections."""

from typing import TYPE_CHECKING, Any

from vibcli.language.fields import Element
from vibcli.language.kinds import EquationField, Load, Many, MotionField, OneOf
from vibcli.language.named_elements import Lazy
from vibcli.manual import scenes, topics
from vibcli.manual.catalogue import Catalogue, opened
from vibcli.manual.layout import blocks, either, paragraph, table
from vibcli.reader.read import SECTIONS
from vibcli.reader.sections.find import FIND

if TYPE_CHECKING:
    from vibcli.language.fields import Field
    from vibcli.manual.catalogue import Declared


def expects(kind: Any) -> str:
    """What a key holds, in words."""
    if isinstance(kind, Many) and isinstance(kind.kind, (Element, Lazy)):
        return f"{kind.wants}, each {article(opened(kind.kind)[0])}"
    if isinstance(kind, MotionField):
        return kind.wants + ", in coordinates and time"
    if isinstance(kind, Load) and not isinstance(kind, EquationField):
        return kind.wants + ", in coordinates, velocities and time"
    if not isinstance(kind, (Element, Lazy)):
        return str(kind.wants)
    _, element, _ = opened(kind)
    if not isinstance(element, Element):
        return expects(element)
    mapping = "a mapping {" + ", ".join(element.fields) + "}"
    return mapping if element.short is None else f"{expects(element.fields[element.short].kind)}, or {mapping}"


def sentence(text: str) -> str:
    """A text of a declaration as a sentence."""
    text = text if text[:1] in "`[{" or text[:2].istitle() else text[:1].upper() + text[1:]
    return text if text.endswith((".", "…", ":")) else text + "."


def element_page(catalogue: Catalogue, word: Any, scene: bool = True) -> str:
    """What an element is, its keys, which of them go together, its short form, and a scene."""
    declared = catalogue.elements[word]
    head = [f"{word} — {declared.places[0]}", *(f"{'':{len(word)}}   {place}" for place in declared.places[1:])]
    example = _scene(declared.example) if scene and declared.example else _scene_using(catalogue, word) if scene else []
    if not declared.fields:
        return blocks(head, paragraph(sentence(declared.about)), example)
    rows = [(key, _expects(declared, key) + (" (required)" if field.required else ""), _meaning(declared, key))
            for key, field in declared.fields.items()]
    remarks = [paragraph(part) if isinstance(part, str) else table(part) for part in topics.REMARKS.get(word, ())]
    return blocks(head, paragraph(sentence(declared.about)), ["Keys", *table(rows)], _rules(declared), *remarks,
                  example)


def _expects(declared: "Declared", key: str) -> str:
    """What a key holds, and within which elements something else."""
    told: dict[str, list[str]] = {}
    for word, kind in declared.kinds.items():
        if key in kind.fields:
            told.setdefault(expects(kind.fields[key].kind), []).append(word + "s")
    first, *others = told or {expects(declared.fields[key].kind): []}
    return "; ".join([first, *(f"of {either(told[other], 'and')} {other}" for other in others)])


def _meaning(declared: "Declared", key: str) -> str:
    """What a key means, in a sentence, and within which elements alone it stands."""
    words = declared.within(key)
    of = f" Of {either([word + 's' for word in words], 'and')}." if words else ""
    return sentence(declared.fields[key].about) + of


def _scene_using(catalogue: Catalogue, word: str) -> list[str]:
    """A scene for an element that has no keys of its own: one that uses the key of its name."""
    use = next(((owner, key) for owner, key in catalogue.pairs() if key == word), None)
    return _scene(scenes.using(catalogue, use)) if use else []


def _rules(declared: "Declared") -> list[str]:
    """Sentences on the keys of an element that exclude or need one another, its short form, and further pages."""
    element, found = declared.kind, []
    for group in element.needs:
        count = "Exactly one" if group in element.exclusive else "One or more"
        found.append(f"{count} of {either(group)} is needed.")
    groups = dict.fromkeys(group for kind in (element, *declared.kinds.values()) for group in kind.exclusive)
    for group in groups:
        if group not in element.needs and not any(set(group) < set(other) for other in groups):
            found.append(f"At most one of {either(group)} may stand.")
    if element.short is not None:
        found.append(f"A bare value stands for `{element.short}`.")
    further = list(dict.fromkeys(word for word in map(_inner, declared.fields.values()) if word))
    if further:
        likewise = f", likewise {either(further[1:], 'and')}" if further[1:] else ""
        found.append(f"More: `vibcli explain {further[0]}`{likewise}.")
    return [line for text in found for line in paragraph(text)]


def _inner(field: "Field") -> str | None:
    """The word of the element that a key holds, or a list of it; None where it holds none."""
    kind = field.kind.kind if isinstance(field.kind, Many) else field.kind
    kind = next((part for part in kind.kinds.values() if isinstance(part, Element)), None) if isinstance(
        kind, OneOf) else kind
    return opened(kind)[0] if isinstance(kind, (Element, Lazy)) else None


def _rules_of(element: Element, key: str) -> str:
    """Sentences on what a key excludes and what it may replace."""
    found = []
    others = [other for group in element.exclusive if key in group for other in group if other != key]
    if others:
        found.append(f"Not together with {either(list(dict.fromkeys(others)))}.")
    for group in element.needs:
        if key in group:
            found.append(f"One of {either(group)} is needed.")
    if element.short == key:
        found.append("The short form: a bare value stands for this key.")
    return " ".join(found)


def _scene(name: str) -> list[str]:
    """A scene that runs, indented."""
    if name is None:
        return []
    lines = [f"A scene that runs (vibcli new {name}):", ""]
    return lines + ["  " + line if line else "" for line in scenes.text(name).rstrip("\n").split("\n")]


def key_page(catalogue: Catalogue, word: str, key: str, scene: bool = True) -> str:
    """A key of an element: what it holds, what it means, what it excludes, and a scene that uses it."""
    declared = catalogue.elements[word]
    field = declared.fields[key]
    head = [f"{word}.{key} — a key of {article(word)}" + (", required" if field.required else "")]
    rows = [("holds", _expects(declared, key)), ("means", field.about)]
    within = declared.within(key)
    rows += [("of", either([one + "s" for one in within], "and"))] if within else []
    rows += [("rules", _rules_of(declared.kind, key))] if _rules_of(declared.kind, key) else []
    if isinstance(field.kind, Many) and _inner(field):
        rows.append(("items", f"vibcli explain {_inner(field)}"))
    name = scenes.using(catalogue, (word, key), declared.example)
    if not scene:
        rows.append(("scene", f"vibcli explain {word}.{key}"))
    return blocks(head, table(rows), _scene(name) if scene else [])


def article(word: str) -> str:
    return word if word.endswith("s") else ("an " if word[0] in "aeiou" else "a ") + word


def section_page(catalogue: Catalogue, section: str) -> str:
    """A section of a scene; that of a section of elements is followed by the page of the element."""
    kind, _ = SECTIONS[section]
    declared = catalogue.sections.get(section)
    head = paragraph(f"{section} — a section of a scene: {kind.wants}")
    about = paragraph(sentence(catalogue.about(section)))
    if declared is not None:
        inner = declared.word
        page = element_page(catalogue, inner)
        return page if inner == section else blocks(head, [page])
    if section == "find":
        return blocks(head, about, table(FIND.items()), ["More: `vibcli explain request`."],
                      _scene(scenes.using(catalogue, section)))
    if section == "cases":
        about = [line for text in topics.CASES for line in paragraph(text)]
    return blocks(head, about, _scene(scenes.using(catalogue, section)))
