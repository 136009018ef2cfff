"""A case of a scene merged over it, as documents."""

from typing import Any

from vibcli.language.document.nodes import Mapping, Scalar
from vibcli.language.sections import OWN_OF_CASES
from vibcli.symbolic.parser import plain_name

WHOLE = ("damping",)        # sections that a case replaces, as their keys exclude each other


def document_of_case(root: Mapping, case: str | None) -> Mapping:
    """The document of a case of another, itself where none is named."""
    return root if case is None else merged(root, root.entries["cases"][1].entries[case][1])


def merged(root: Mapping, part: Mapping) -> Mapping:
    """The scene with a case merged over it; answers and find are the case's own."""
    entries = {key: pair for key, pair in root.entries.items() if key not in OWN_OF_CASES}
    found = _over(entries, part.entries)
    if "choose" in entries and isinstance(found["choose"][1], Mapping):
        found["choose"] = _still_chosen(*found["choose"], part)
        if not found["choose"][1].entries:
            del found["choose"]
    return Mapping(part.where, found)


def _still_chosen(key_node: Scalar, choices: Mapping, part: Mapping) -> tuple[Scalar, Mapping]:
    """The conditions of a scene without those of parameters to which the case gives a value."""
    given = part.entries["parameters"][1] if "parameters" in part.entries else None
    own = part.entries["choose"][1] if "choose" in part.entries else None
    names = {plain_name(key) for key, (_, value) in given.entries.items()
             if not (isinstance(value, Scalar) and not value.text)} if isinstance(given, Mapping) else set()
    names -= {plain_name(key) for key in own.entries} if isinstance(own, Mapping) else set()
    left = {key: pair for key, pair in choices.entries.items() if plain_name(key) not in names}
    return key_node, Mapping(choices.where, left)


def _over(below: dict[str, tuple[Scalar, Any]], above: dict[str, tuple[Scalar, Any]]) -> dict[str, tuple[Scalar, Any]]:
    found = dict(below)
    for key, (key_node, value) in above.items():
        old = found.get(key)
        if old is not None and key not in WHOLE and isinstance(old[1], Mapping) and isinstance(value, Mapping):
            value = Mapping(value.where, _over(old[1].entries, value.entries))
        found[key] = (key_node, value)
    return found
