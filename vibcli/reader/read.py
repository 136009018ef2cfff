"""A document to a Spec: every section read by its declaration, every name known, every dimension checked.

All diagnostics of a file are collected and raised together as one SpecError.
"""

import re
from collections.abc import Sequence
from os.path import basename
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, SpecError
from vibcli.base.spelling import nearest
from vibcli.elements import ELEMENTS
from vibcli.language.document.document import Mapping, Scalar
from vibcli.language.kinds import Kind, Text
from vibcli.language.named_elements import Lazy, LazyKind, Named
from vibcli.language.reader import MOST_PROBLEMS, Reader, TooManyErrors
from vibcli.language.record_calls import RESERVED, own
from vibcli.language.sections import NAMES as GIVEN
from vibcli.language.sections import OWN_OF_CASES
from vibcli.language.spec import MEMBERS, Spec
from vibcli.reader.sections import NAMES as ASKED
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.base.errors import Remark
    from vibcli.language.data_columns import Columns
    from vibcli.language.document.nodes import DocumentNode
    from vibcli.symbolic.syntax import Number, Product, Sum

MOST_CASES = 100
FEW_RADIANS = 6

QUOTE = r"\{\s*([^{}]*?)\s*\}"      # a parameter quoted in a question, compiled where one may be


class _Cases(Kind):
    """Each case is a part of a scene: kept as a node, merged over the scene and read like a file of its own."""

    wants = "a mapping from names to parts of the scene"

    def read(self, node: "DocumentNode", reader: Reader) -> dict[str, Mapping] | None:
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        if len(node.entries) > MOST_CASES:
            return reader.report(node.where, f"{len(node.entries)} cases; the limit is {MOST_CASES}", "divide the file")
        for key, (key_node, value) in node.entries.items():
            if not isinstance(value, Mapping):
                reader.expected(value, "the part of the scene that this case changes")
            elif "cases" in value.entries:
                reader.report(key_node.where, f"the case '{key}' cannot hold cases itself")
        return {key: value for key, (_, value) in node.entries.items() if isinstance(value, Mapping)}

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "additionalProperties": {"type": "object"}}


def _kind(name: str, section: str) -> Named | Lazy:
    """The kind of a section of elements: the one of its own name, or many by name."""
    if section == name:
        return Lazy(name)
    return Named(Lazy(name), f"a mapping from names to {_CALLED.get(section, section)}", _TAKEN.get(section, ()))


def _own(name: str) -> LazyKind:
    """The kind of a section that has a file of its own."""
    return LazyKind(name, "language.sections")


SET, PROBLEMS = "set.yaml", "problems"       # the file that names problems of homework, and its key for them
_CALLED, _TAKEN = {"points": "places"}, {"points": ("ground",), "bodies": ("ground",)}
SECTIONS: dict[str, tuple[Any, str]] = {
    "title": (Text(), "what the scene shows, in a line"),
    "source": (Text(), "where the problem is from"),
    "question": (Text(), "the question as a textbook would pose it; may quote parameters: {m}"),
    "parameters": (Named(Lazy("parameter", "language.sections"), "a mapping from names to values", ("pi",)),
                   GIVEN["parameter"]),
    "records": (Named(Lazy("record", "language.sections"), "a mapping from names to records", RESERVED),
                GIVEN["record"]),
    "coordinates": (_own("coordinates"), GIVEN["coordinates"]),
    "gravity": (_own("gravity"), GIVEN["gravity"]),
    **{section: (_kind(name, section), about) for name, (section, about) in ELEMENTS.items() if section is not None},
    "equilibrium": (_own("equilibrium"), GIVEN["equilibrium"]),
    "initial": (_own("initial"), GIVEN["initial"]),
    "motion": (_own("motion"), (
        "what motions in time are: `small` oscillations in closed form, the default about an equilibrium, or those of "
        "the `full` equations, integrated; `{order: 3}`: those of the equations expanded to the third order in the "
        "deviations from equilibrium; `{accuracy: 1e-6}`: how accurately the full ones, or with `order: 3` the "
        "expanded ones, are integrated. Scenes with nonlinear laws must say which")),
    "find": (LazyKind("find", "reader.sections", "QUESTIONS"), ASKED["find"]),
    "choose": (Named(Lazy("choose", "reader.sections"), "a mapping from parameters to conditions", ("pi", "t")),
               ASKED["choose"]),
    "answers": (LazyKind("answer", "reader.sections"), ASKED["answer"]),
    "variants": (Lazy("variants", "reader.sections"), ASKED["variants"]),
    "cases": (_Cases(), "parts of the scene by name, each merged over it, with its own find and answers"),
}


def read_spec(root: Any, file: str, diagnostics: Sequence[Any] = (), settings: Any = None) -> Spec:
    """The Spec of a document and of its cases; SpecError with every diagnostic where it is not one."""
    found = list(diagnostics)
    if root is None:
        raise SpecError(found)
    files = {}      # beside the scene, each read once
    base = _read_one(root, file, found, settings or {}, files)
    cases = root.entries.get("cases")
    specs = {}
    if cases is not None and isinstance(cases[1], Mapping):
        from vibcli.language.cases import merged

        for name, (_, part) in list(cases[1].entries.items())[:MOST_CASES]:
            if isinstance(part, Mapping) and "cases" not in part.entries:
                remark = f" (in the case {quoted(name)})"
                specs[name] = _read_one(merged(root, part), file, found, settings or {}, files, remark)
    everything = [spec for spec in (base, *specs.values()) if spec is not None]
    used = set().union(*(spec.used for spec in everything))
    for spec in everything:
        _report_unused(spec, used, found)
    if found:
        unique = {(d.where, d.message): d for d in found}
        raise SpecError(sorted(unique.values(), key=lambda d: d.where[1:3] if d.where else (0, 0)))
    remarks = {(one.where, one.message): one for spec in everything for one in spec.remarks}
    return base._replace(cases=specs, remarks=tuple(remarks.values()))


def read_changed(root: Mapping, part: Mapping, file: str, remark: str, settings: Any = None,
                 any_dimension: bool = False, spec: Spec | None = None) -> Spec:
    """The Spec of a document with a part merged over it as a case is, which may leave parameters unused; SpecError,
    with this remark, where it is none. any_dimension: its numbers are in SI units, whatever they measure; spec: that of
    the document, whose records are not read anew."""
    from vibcli.language.cases import merged
    from vibcli.language.sections.record import samples_by_text

    files = {} if spec is None else samples_by_text(spec.get("records", {}))
    return read_alone(merged(root, part), file, settings, files, remark, any_dimension)


def read_alone(root: Mapping, file: str, settings: Any = None, files: Any = None, remark: str = "",
               any_dimension: bool = False) -> Spec:
    """The Spec of a document without its cases, for which it may have parameters that it does not use; SpecError where
    it is none. files: {(scene, name): columns} of what was read beside scenes, to which it adds."""
    found: list[Diagnostic] = []
    spec = _read_one(root, file, found, settings or {}, {} if files is None else files, remark, any_dimension)
    if spec is None:
        raise SpecError(found)
    return spec


def _read_one(root: Mapping, file: str, found: list[Diagnostic],
              settings: "dict[str, tuple[Number | Product | Sum, Scalar]]",
              files: "dict[tuple[str, str], tuple[Columns | None, tuple[str, str] | Diagnostic | None]]",
              remark: str = "", any_dimension: bool = False) -> Spec | None:
    from vibcli.reader.unit_consistency import resolve  # the manual needs the declarations alone

    named, spec = {key: _names(value) for key, (_, value) in root.entries.items()}, None
    members = [name for section in MEMBERS for name in named.get(section, ())]
    reader = Reader(files, named.get("records", ()), members)
    try:
        spec = Spec.of(file, _sections(root, reader), named)
        if "choose" in named:
            from vibcli.reader.choices import with_choices

            spec = with_choices(spec, reader)
        if spec.let_go is not None:
            from vibcli.language.sections.initial import check_let_go

            check_let_go(spec, reader)
        spec = resolve(_with_settings(spec, reader, settings), reader, any_dimension)
        _question(spec, root, reader)
    except TooManyErrors:
        pass
    known = {(d.where, d.message) for d in found}
    for diagnostic in reader.diagnostics:
        if (diagnostic.where, diagnostic.message) not in known:
            found.append(Diagnostic(diagnostic.where, diagnostic.message + remark, diagnostic.hint))
    return None if reader.diagnostics else spec._replace(remarks=_remarks(spec, reader))


def _remarks(spec: Spec, reader: Reader) -> "tuple[Remark, ...]":
    """What a number without unit, greater than any angle, is taken for."""
    values = [record["value"] for record in spec.parameters.values() if "value" in record]
    if not any(number.value > FEW_RADIANS and not number.units for expression in (*reader.expressions.values(), *values)
               for number in expression.parts.numbers):
        return ()
    from vibcli.reader.angle_check import angle_remarks

    return tuple(angle_remarks(spec, reader))


def _instead(key: str, root: Mapping) -> str:
    """What was meant by a key that is no section."""
    if PROBLEMS in root.entries and basename(root.where.file or "") == SET:
        return "this is a set of problems: vibcli homework hands it out"
    if key in ("equation", "equations"):
        return "equations are derived; one to compare with stands under answers, as in equation[x]: m*x'' + k*x = 0"
    return f"a set of problems is a file with the name {SET}" if key == PROBLEMS else nearest(key, SECTIONS)


def _sections(root: Mapping, reader: Reader) -> dict[str, Any]:
    """The records of each section."""
    sections = {}
    for key, (key_node, value) in root.entries.items():
        before = len(reader.diagnostics)
        if key not in SECTIONS:
            reader.report(key_node.where, f"unknown key {quoted(key)}", _instead(key, root))
            reader.lost.update(_names(value))
        elif _is_empty(value) and not isinstance(SECTIONS[key][0], Text):
            reader.report(key_node.where, f"the section '{key}' is empty", "fill it in or leave it out")
        else:
            record = SECTIONS[key][0].read(value, reader)
            if record is not None:
                sections[key] = record
        if len(reader.diagnostics) > before and key not in (*OWN_OF_CASES, "choose", "initial"):
            reader.not_whole()
    found = _with_member_points({key: sections[key] for key in SECTIONS if key in sections})
    if not reader.members or "initial" not in found:
        return found
    from vibcli.language.sections.initial import with_fields_apart

    return with_fields_apart(found)


def _with_member_points(sections: dict[str, Any]) -> dict[str, Any]:
    """The sections with the points on members apart from those that have a place."""
    points = sections.get("points") or {}
    along = {name: record for name, record in points.items() if not isinstance(record.get("at"), list)}
    if not along:
        return sections
    placed = {name: record for name, record in points.items() if name not in along}
    return {key: value for key, value in sections.items() if key != "points"} | (
        {"points": placed} if placed else {}) | {"member_points": along}


def _is_empty(node: "DocumentNode") -> bool:
    if isinstance(node, Scalar):
        return not node.text.strip()
    return not (node.entries if isinstance(node, Mapping) else node.items)


def _names(node: "DocumentNode") -> list[str]:
    """The names in a section, whether or not what they stand for could be read."""
    if isinstance(node, Mapping):
        return [plain_name(key) for key in node.entries]
    items = [] if isinstance(node, Scalar) else node.items
    return [plain_name(item.text) for item in items if isinstance(item, Scalar)]


def _with_settings(spec: Spec, reader: Reader, settings: "dict[str, tuple[Number | Product | Sum, Scalar]]") -> Spec:
    """The Spec with values given from outside, which replace those of the file, and conditions."""
    if not settings:
        return spec
    from vibcli.language.parameters import overridden

    given = {name: overridden(spec.parameters[name], *value, reader) for name, value in settings.items()
             if name in spec.parameters}
    choices = {name: record for name, record in spec.choices.items() if name not in given}
    return spec.with_parameters({**spec.parameters, **given})._replace(choices=choices)


def _question(spec: Spec, root: Mapping, reader: Reader) -> None:
    question = spec.get("question", "")
    for quote in re.finditer(QUOTE, question) if "{" in question else ():
        name = quote.group(1)
        if plain_name(name) not in spec.named.get("parameters", ()):
            place = root.entries["question"][1].place(quote.start(), len(quote.group()))
            reader.report(place, f"the question quotes {quoted(quote.group())}, which is no parameter",
                          nearest(name, spec.parameters))


def _report_unused(spec: Spec, used: set[str], diagnostics: list[Diagnostic]) -> None:
    """An unused record is an error, and an unused parameter, unless it says `unused: allowed`."""
    for name, record in spec.parameters.items():
        if len(diagnostics) <= MOST_PROBLEMS and name not in used and record.get("unused") != "allowed":
            hint = f"take it out, or write {name}: {{value: …, unused: allowed}}"
            if name in spec.choices:
                hint = "it can be chosen only where something in the scene depends on it"
            diagnostics.append(Diagnostic(record.where, f"the parameter '{name}' is not used", hint))
    for name, record in (spec.get("records") or {}).items():
        if len(diagnostics) <= MOST_PROBLEMS and own(name) not in used:
            hint = f"write {name}(t) in a load or motion, or take it out"
            diagnostics.append(Diagnostic(record.where, f"the record '{name}' is not used", hint))
