"""Segments of members: length, stiffness and mass per length of each, from what it or else its member says."""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.cross_sections import CrossSection, cross_section
from vibcli.elements.member_fields import MemberKind

if TYPE_CHECKING:
    from vibcli.elements.member_line import DrawnLine
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

TAKEN = "E", "G", "rho", "A", "I", "Io"     # what is multiplied to coefficients


class MemberSegment(NamedTuple):
    """From `start` to `end` along a member: its stiffness (EA, GI_o or EI; None of strings), inertia, foundation and
    drag per length, its modulus and cross-section, None where they are not given; `axial`: EA of a beam that stretches,
    None of any other."""

    start: "Node"
    end: "Node"
    text: str
    stiffness: "Node | None"
    inertia: "Node | None"
    foundation: "Node"
    drag: "Node"
    modulus: "Node | None"
    section: CrossSection | None
    axial: "Node | None" = None

    @property
    def nodes(self) -> "list[Node]":
        """The lengths and coefficients of its equation."""
        return [node for node in (self.start, self.end, self.stiffness, self.inertia, self.foundation, self.drag,
                                  self.axial) if node is not None]

    def lengthwise(self, scene: "Builder") -> "MemberSegment":
        """That of a beam as it stretches: along it neither what it rests on nor its drag acts."""
        zero = scene.table.zero
        return self._replace(stiffness=self.axial, foundation=zero, drag=zero, modulus=None, section=None, axial=None)


def segments_of(record: "Record", kind: MemberKind, line: "DrawnLine | None", scene: "Builder") -> list[MemberSegment]:
    """The Segments of a member; what does not add up, has no stiffness or no section is reported."""
    found, start = [], scene.table.zero
    given = _Given(record, kind, scene)
    for part in record.get("segments", [record]):
        end = start + (scene.positive(part["length"], f"the length of {_called(part, record)}") if "length" in part else
                       line.length)
        own = given.within(part)
        text = part["length"].text if "length" in part else ""
        found.append(MemberSegment(start, end, text, own.stiffness(), own.inertia(),
                                   own.per_length("foundation"), own.per_length("drag"), own.modulus(), own.section(),
                                   own.axial()))
        start = end
    given.tell_idle()
    if "segments" in record and "length" in record:
        length = scene.positive(record["length"], f"the length of '{record.name}'")
        scene.require_equal(start, length, record["length"].where,
                            f"the segments of '{record.name}' make {{}} m, its length is {{}} m",
                            "mend one of them, or leave `length` out")
    if line is not None and ("segments" in record or "length" in record):
        scene.require_equal(start, line.length, record.where, f"'{record.name}' is {{}} m long, and drawn {{}} m long",
                            "mend one of them; without `length` it is as long as it is drawn")
    return found


def _called(part: "Record", record: "Record") -> str:
    return f"'{record.name}'" if part is record else f"a segment of '{record.name}'"


class _Given:
    """What a segment, and then its member, gives: the nearest that can be told counts."""

    __slots__ = ("kind", "levels", "member", "nodes", "scene")

    def __init__(self, member: "Record", kind: MemberKind, scene: "Builder", levels: "tuple[Record, ...]" = (),
                 nodes: dict[Any, Any] | None = None) -> None:
        self.member, self.kind, self.scene, self.levels = member, kind, scene, levels or (member,)
        self.nodes = {} if nodes is None else nodes     # each field is lowered, and reported as wrong, once

    def within(self, part: "Record") -> "_Given":
        """What a segment gives before its member."""
        levels = (self.member,) if part is self.member else (part, self.member)
        return _Given(self.member, self.kind, self.scene, levels, self.nodes)

    def stiffness(self) -> "Node | None":
        """EA, GI_o or EI; None of strings."""
        kind = self.kind
        if kind.stiffness is None:
            return None
        for level in self.levels:
            if kind.stiffness in level:
                return self._positive(level, kind.stiffness)
            if {kind.modulus, kind.geometry, "section"} & set(level):
                modulus, geometry = self.modulus(), self._geometry(kind.geometry)
                if modulus is not None and geometry is not None:
                    return modulus * geometry
        self._missing(f"'{self.member.name}' has no stiffness",
                      f"give {kind.stiffness}, or {kind.modulus} and {kind.geometry} or a section")
        return self.scene.table.one

    def axial(self) -> "Node | None":
        """EA of a beam that stretches; None of a member none of whose parts gives it, and of others than beams."""
        parts = (self.member, *self.member.get("segments", ()))
        if not self.kind.bends or not any("EA" in part for part in parts):
            return None
        found = self._nearest("EA")
        if found is None:
            self._missing(f"a segment of '{self.member.name}' has no EA, and others stretch", "give each its EA, or "
                          "one to the whole beam")
            return self.scene.table.one
        return found

    def inertia(self) -> "Node":
        """Mass per length, of shafts moment of inertia per length; zero where nothing gives it."""
        kind, area = self.kind, "Io" if self.kind.torsional else "A"
        for level in self.levels:
            if kind.inertia in level:
                return self._positive(level, kind.inertia, zero=True)
            if {"rho", area, "section"} & set(level) and (density := self._nearest("rho")) is not None:
                size = self._geometry(area)
                if size is not None:
                    return density * size
                self._missing(f"the density of '{self.member.name}' needs its cross-section",
                              f"give {area} or a section, or {kind.inertia} instead", "rho")
                return self.scene.table.zero
        return self.scene.table.zero

    def per_length(self, key: str) -> "Node":
        """A foundation or drag, zero where there is none."""
        found = self._nearest(key, zero=True)
        return self.scene.table.zero if found is None else found

    def modulus(self) -> "Node | None":
        """E or G."""
        return self._nearest(self.kind.modulus) if self.kind.modulus else None

    def section(self) -> CrossSection | None:
        """The cross-section where one is drawn."""
        level = next((level for level in self.levels if "section" in level), None)
        return None if level is None else self._section(level)

    def tell_idle(self) -> None:
        """Report what the member or a segment gives and none of its coefficients takes: I beside EI."""
        for level in (self.member, *self.member.get("segments", ())):
            for key in TAKEN:
                if key in level and (level, key) not in self.nodes:
                    self.scene.report(level.place(key), f"'{key}' of '{self.member.name}' plays no part "
                                      "beside what else is given", "leave it out")

    def _nearest(self, key: str, zero: bool = False) -> "Node | None":
        level = next((level for level in self.levels if key in level), None)
        return None if level is None else self._positive(level, key, zero)

    def _geometry(self, key: str) -> "Node | None":
        """A, I or I_o, as it is given or from a section."""
        for level in self.levels:
            if key in level:
                return self._positive(level, key)
            if "section" in level:
                found: Node | None = getattr(self._section(level), key)
                if found is None:
                    self._missing("the torsion constant of a rectangle is not its polar second moment I_o",
                                  "give `GIo:` with its torsion constant, and `inertia_per_length:`, in place of the "
                                  "section", "section")
                    return self.scene.table.one
                return found
        return None

    def _section(self, level: "Record") -> CrossSection:
        if (level, "section") not in self.nodes:
            self.nodes[level, "section"] = cross_section(level["section"], self.scene)
        found: CrossSection = self.nodes[level, "section"]
        return found

    def _positive(self, level: "Record", key: str, zero: bool = False) -> "Node":
        if (level, key) not in self.nodes:
            what = f"'{key}' of '{self.member.name}'"
            self.nodes[level, key] = self.scene.positive(level[key], what, zero=zero)
        found: Node = self.nodes[level, key]
        return found

    def _missing(self, message: str, hint: str, key: str | None = None) -> None:
        if message not in self.nodes:
            self.nodes[message] = True
            where = next((level.place(key) for level in self.levels if key in level.places), self.levels[0].where)
            self.scene.report(where, message, hint)
