"""The JSON Schema (draft 7) of scene files, from the same declarations as the manual and the messages.

A YAML reader has types where scene files have text: whatever YAML may take a text for is allowed, a name without
value is null, and a case may hold any part of a scene.
"""

from typing import TYPE_CHECKING, Any

from vibcli.language.fields import Element
from vibcli.language.kinds import Text
from vibcli.language.named_elements import Named
from vibcli.manual.catalogue import Catalogue
from vibcli.reader.read import SECTIONS

if TYPE_CHECKING:
    from vibcli.manual.catalogue import Declared

DRAFT = "http://json-schema.org/draft-07/schema#"
ANY_TEXT = {"type": ["string", "number", "boolean", "null"]}
NAME = {"pattern": "^[A-Za-z_\u0391-\u03f5][A-Za-z0-9_\u0391-\u03f5]{0,31}$"}


def schema() -> dict[str, Any]:
    """The schema as a dict: sections under `properties`, elements under `definitions`."""
    catalogue = Catalogue()
    definitions = {word: _definition(word, declared) for word, declared in catalogue.elements.items()
                   if isinstance(declared.kind, Element)}
    inline = {word: catalogue.elements[word].kind.schema() for word in definitions}
    properties = {}
    for section, (kind, _) in SECTIONS.items():
        properties[section] = {**_section(section, kind, catalogue), "description": catalogue.about(section)}
    for part in (*definitions.values(), properties):
        for key in list(part):
            part[key] = _referring(part[key], inline)
    properties["cases"]["additionalProperties"] = {"type": "object", "propertyNames": {
        "enum": [section for section in SECTIONS if section != "cases"]}}
    return {"$schema": DRAFT, "title": "A scene of vibcli", "type": "object", "additionalProperties": False,
            "properties": properties, "definitions": definitions}


def _section(section: str, kind: Any, catalogue: Catalogue) -> dict[str, Any]:
    if isinstance(kind, Text):
        return dict(ANY_TEXT)
    found: dict[str, Any] = kind.schema()
    if isinstance(kind, Named):
        found["propertyNames"] = NAME
    return found


def _definition(word: str, declared: "Declared") -> dict[str, Any]:
    """The schema of one element, with what its keys exclude and need, and what YAML makes of its texts."""
    element = declared.kind
    found = element.schema()
    mapping = found["anyOf"][1] if element.short is not None else found
    for key, field in element.fields.items():
        if isinstance(field.kind, Text):
            mapping["properties"][key] = {**ANY_TEXT, "description": field.about}
    rules: list[dict[str, Any]] = [{"not": {"required": [one, other]}} for group in element.exclusive
                                   for i, one in enumerate(group) for other in group[i + 1:]]
    rules += [{"anyOf": [{"required": [key]} for key in group]} for group in element.needs]
    if rules:
        mapping["allOf"] = rules
    if word == "parameter":
        found["anyOf"].append({"type": "null"})
    if word == "answer":
        found["anyOf"].append({"type": "boolean"})
    return {**found, "description": declared.about}


def _referring(part: Any, inline: dict[str, dict[str, Any]]) -> Any:
    """The schema with every element that it holds inline replaced by a reference to its definition."""
    if isinstance(part, list):
        return [_referring(item, inline) for item in part]
    if not isinstance(part, dict):
        return part
    bare = {key: value for key, value in part.items() if key != "description"}
    for word, known in inline.items():
        if bare == known:
            reference = {"$ref": f"#/definitions/{word}"}
            return {"allOf": [reference], "description": part["description"]} if "description" in part else reference
    return {key: _referring(value, inline) for key, value in part.items()}
