"""A document to a Spec: every section read by its declaration, every name known, every dimension checked.

All diagnostics of a file are collected and raised together as one SpecError.
"""

import re

from vibcli import naming
from vibcli.document import Mapping, Scalar
from vibcli.elements import answer, coordinates, equilibrium, gravity
from vibcli.errors import SpecError
from vibcli.fields import Choice, Kind, Lazy, Many, Named, Reader, Text, nearest
from vibcli.questions import FIND


class _Cases(Kind):
    """Each case is a part of a scene: kept as a node, merged over the scene and read like a file of its own."""

    wants = "a mapping from names to parts of the scene"

    def read(self, node, reader):
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        for key, (key_node, value) in node.entries.items():
            if not isinstance(value, Mapping):
                reader.expected(value, "the part of the scene that this case changes")
            elif "cases" in value.entries:
                reader.report(key_node.where, f"the case '{key}' cannot hold cases itself")
        return {key: value for key, (_, value) in node.entries.items() if isinstance(value, Mapping)}

    def schema(self):
        return {"type": "object", "additionalProperties": {"type": "object"}}


SECTIONS = {
    "title": (Text(), "what the scene shows, in a line"),
    "source": (Text(), "where the problem is from"),
    "question": (Text(), "the question as a textbook would pose it; may quote parameters: {m}"),
    "parameters": (Named(Lazy("parameter"), "a mapping from names to values"), "what is given"),
    "coordinates": (coordinates.KIND, coordinates.ELEMENT.about),
    "gravity": (gravity.KIND, gravity.ABOUT),
    "points": (Named(Lazy("point"), "a mapping from names to places"), "named places, fixed or carried"),
    "surfaces": (Named(Lazy("surface"), "a mapping from names to surfaces"), "what bodies roll on"),
    "bodies": (Named(Lazy("body"), "a mapping from names to bodies"), "what moves, and how"),
    "springs": (Named(Lazy("spring"), "a mapping from names to springs"), "springs"),
    "dampers": (Named(Lazy("damper"), "a mapping from names to dampers"), "dampers"),
    "energies": (Lazy("energies"), "terms of T, V and Phi written out"),
    "matrices": (Lazy("matrices"), "M, C and K given outright"),
    "equilibrium": (equilibrium.KIND, equilibrium.ABOUT),
    "find": (Many(Choice(*FIND), 1, 20, "a list of questions"), "what `solve` prints; all that is cheap if left out"),
    "answers": (answer.KIND, "expected answers, which `check` compares"),
    "cases": (_Cases(), "parts of the scene by name, each merged over it, with its own find and answers"),
}


class Spec:
    """A scene file as read: records by section, coordinates in order, dimensions of all names."""

    __slots__ = ("answers", "asked_dimension", "cases", "coordinates", "dimensions", "file", "free_numbers",
                 "parameters", "sections", "used", "velocities")

    def __init__(self, file, sections):
        self.file, self.sections = file, sections
        self.parameters = sections.get("parameters", {})
        self.answers = sections.get("answers", [])
        self.cases, self.asked_dimension, self.velocities, self.used = {}, None, set(), set()

    def get(self, section, default=None):
        return self.sections.get(section, default)


def read_spec(root, file, diagnostics=(), settings=None):
    """The Spec of a document and of its cases; SpecError with every diagnostic where it is not one."""
    found = list(diagnostics)
    if root is None:
        raise SpecError(found)
    cases = root.entries.get("cases")
    base = _read_one(root, file, found, settings or {})
    specs = {}
    if base is not None and cases is not None and isinstance(cases[1], Mapping):
        for name, part in (base.get("cases") or {}).items():
            specs[name] = _read_one(_merged(root, part), file, found, settings or {})
    everything = [spec for spec in (base, *specs.values()) if spec is not None]
    for spec in everything[:1]:
        naming.report_unused(spec, set().union(*(s.used for s in everything)), found)
    if found:
        raise SpecError(_once(found))
    base.cases = specs
    return base


def _once(diagnostics):
    """Each diagnostic once, in the order of the file."""
    unique = {(d.where, d.message): d for d in diagnostics}
    return sorted(unique.values(), key=lambda d: d.where[1:3] if d.where else (0, 0))


def _merged(root, part):
    """The scene with a case merged over it; answers and find are the case's own."""
    entries = {key: pair for key, pair in root.entries.items() if key not in ("cases", "answers", "find")}
    return _mapping(_over(entries, part.entries), part.where)


def _mapping(entries, where):
    mapping = Mapping(where)
    mapping.entries = entries
    return mapping


def _over(below, above):
    merged = dict(below)
    for key, (key_node, value) in above.items():
        old = merged.get(key)
        if old is not None and isinstance(old[1], Mapping) and isinstance(value, Mapping) and key != "answers":
            value = _mapping(_over(old[1].entries, value.entries), value.where)
        merged[key] = (key_node, value)
    return merged


def _read_one(root, file, found, settings):
    reader = Reader()
    sections = {}
    for key, (key_node, value) in root.entries.items():
        if key not in SECTIONS:
            reader.report(key_node.where, f"unknown key '{key}'", nearest(key, SECTIONS))
            continue
        if isinstance(value, Scalar) and not value.text.strip() and not isinstance(SECTIONS[key][0], Text):
            reader.report(key_node.where, f"the section '{key}' is empty", "fill it in or leave it out")
            continue
        record = SECTIONS[key][0].read(value, reader)
        if record is not None:
            sections[key] = record
    spec = Spec(file, sections)
    try:
        _settings(spec, settings)
        if not reader.diagnostics:
            naming.resolve(spec, reader)
            _question(spec, root, reader)
    finally:
        found.extend(reader.diagnostics)
    return None if reader.diagnostics else spec


def _settings(spec, settings):
    """Values given from outside replace those of the file; a bare number takes the unit of the file's."""
    from vibcli.parameters import override

    for name, tree_and_scalar in settings.items():
        if name in spec.parameters:
            override(spec.parameters[name], *tree_and_scalar)


def _question(spec, root, reader):
    text = spec.get("question", "")
    for name in re.findall(r"\{([^{}]*)\}", text):
        if name.strip() not in spec.parameters:
            reader.report(root.entries["question"][1].where, f"the question quotes '{{{name}}}', which is no parameter",
                          nearest(name.strip(), spec.parameters))
