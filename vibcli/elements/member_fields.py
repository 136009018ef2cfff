"""The fields that bars, shafts, beams and strings share, and the kinds of members."""

from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.cross_sections import SECTION
from vibcli.elements.member_ends import FREE, HOLDS, attachment, end_kind
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity
from vibcli.language.named_place import DRAWN
from vibcli.language.reader import Reader, Record


class MemberKind(NamedTuple):
    """A kind of members: the stiffness of its equation (None of strings, whose tension is theirs), and the modulus and
    geometry that it is made of; its mass per length, and of what; the signal of its motion."""

    name: str
    stiffness: str | None
    modulus: str | None
    geometry: str
    inertia: str
    motion: str

    @property
    def bends(self) -> bool:
        """Has it slopes beside displacements?"""
        return self.stiffness == "EI"

    @property
    def letter(self) -> str:
        """That of its motion in equations."""
        return "w" if self.motion == "along" else self.motion

    @property
    def torsional(self) -> bool:
        """Does it turn about its axis?"""
        return self.motion == "phi"


BAR = MemberKind("bar", "EA", "E", "A", "mass_per_length", "u")
SHAFT = MemberKind("shaft", "GIo", "G", "Io", "inertia_per_length", "phi")
BEAM = MemberKind("beam", "EI", "E", "I", "mass_per_length", "u")
LENGTHWISE = BAR._replace(motion="along")        # a beam in the plane as it stretches
STRING = MemberKind("string", None, None, "A", "mass_per_length", "u")
KINDS = {"bars": BAR, "shafts": SHAFT, "beams": BEAM, "strings": STRING}
MATERIAL = {
    "E": Field(Quantity("Pa"), "Young's modulus"),
    "G": Field(Quantity("Pa"), "its shear modulus"),
    "rho": Field(Quantity("kg/m^3"), "its density; massless without it"),
    "section": Field(SECTION, "its cross-section: `{circle: d}`, `{tube: [D, d]}` or `{rectangle: [b, h]}`"),
    "A": Field(Quantity("m^2"), "the area of its cross-section"),
    "I": Field(Quantity("m^4"), "the second moment of area for bending"),
    "Io": Field(Quantity("m^4"), "the polar second moment of area of a round cross-section"),
    "EA": Field(Quantity("N"), "its stiffness along, E times A"),
    "EI": Field(Quantity("N*m^2"), "its bending stiffness"),
    "GIo": Field(Quantity("N*m^2"), "its torsional stiffness"),
    "mass_per_length": Field(Quantity("kg/m"), "its mass per length; massless without it"),
    "inertia_per_length": Field(Quantity("kg*m"), "its moment of inertia about the axis per length"),
}
OF_KIND = {"bar": ("E", "rho", "section", "A", "EA", "mass_per_length"),
           "shaft": ("G", "rho", "section", "Io", "GIo", "inertia_per_length"),
           "beam": ("E", "rho", "section", "A", "I", "EI", "EA", "mass_per_length"),
           "string": ("rho", "section", "A", "mass_per_length")}


_SECTION = "a section is given as in section: {circle: d}"
_INSTEAD = {"string": {"EA": "strings keep their length: leave it out", "E": "strings do not bend: leave it out"}}


def member_element(kind: MemberKind, about: str, example: str) -> Element:
    """The declaration of a kind of members."""
    force, turn = "N" if kind.torsional else "N/m^2", "N*s" if kind.torsional else "N*s/m^2"
    along = {key: MATERIAL[key] for key in OF_KIND[kind.name]}
    if kind.bends:
        along["EA"] = Field(Quantity("N"), "its stiffness along, E times A, by which it stretches, in the plane alone")
    along["foundation"] = Field(Quantity(force), "the stiffness of what it rests on, per length")
    along["drag"] = Field(Quantity(turn), "the coefficient of what damps it, per length")
    exclusive = (("section", kind.geometry), (kind.inertia, "rho"), *(
        [(kind.stiffness, kind.modulus)] if kind.stiffness else []))
    segment = Element("segment", "A segment of a member, from the left; what it leaves out is the member's.",
                      {"length": Field(Quantity("m"), "its length", required=True), **along}, exclusive=exclusive,
                      example="beams")
    fields = {"length": Field(Quantity("m"), "its length"), **along}
    if not kind.torsional:
        fields |= {"from": Field(DRAWN, "where its left end is drawn, in the plane"),
                   "to": Field(DRAWN, "where its right end is drawn")}
        fields["preload"] = Field(Quantity("N"), "its tension as drawn, its mean along it where its "
                                   "weight and loads vary it; negative where it is compressed")
    fields["segments"] = Field(Many(segment, 1, 1000, "a list of segments"), "its segments from the left: "
                               "`[{length: L1, section: …}, …]`")
    for side in ("left", "right"):
        fields[side] = Field(end_kind(kind.torsional, kind.bends), f"what holds its {side} end (default: free)")
    fields["attached"] = Field(Many(attachment(kind.torsional, kind.bends), 1, 1000, "a list of attachments"),
                               "what is attached to it: `[{at: L, mass: M}, {at: a, k: k}]`")
    sized = dict.fromkeys(("d", "diameter", "radius", "r", "width", "height") if "section" in fields else (), _SECTION)
    return Element(kind.name, about, fields, exclusive=exclusive,
                   needs=(("length", "segments", *(() if kind.torsional else ("from",))),),
                   settle=_settle, example=example, instead=sized | _INSTEAD.get(kind.name, {}))


def _settle(record: Record, reader: Reader) -> None:
    """A mass per length without sections or the like; a string needs its tension."""
    for one, other in (("from", "to"), ("to", "from")):
        if one in record and other not in record:
            reader.report(record.place(one), f"'{one}' needs '{other}'", "a member is drawn from one place to another")
    if record.element.name == "bar" and "preload" in record and "from" not in record:
        reader.report(record.place("preload"), "the tension of a bar plays no part in what moves along it",
                      "leave it out, or draw the bar in the plane, `from` a place `to` another")
    if record.element.name == "beam" and "from" not in record:
        for part in (record, *record.get("segments", ())):
            if "EA" in part:
                reader.report(part.place("EA"), "a beam without a place moves across alone: its 'EA' plays no part",
                              "leave it out, or draw the beam in the plane, `from` a place `to` another")
    if record.element.name == "string" and "preload" not in record and (
            "from" not in record or all(isinstance(record.get(side), str) and holds_along(record[side])
                                        for side in ("left", "right"))):
        reader.report(record.where, f"nothing tells the tension of '{record.name}'", "give `preload: T`")


def holds_along(end: Record | str) -> bool:
    """Is an end held along its line?"""
    return end != FREE if isinstance(end, str) else any(word in end for word in HOLDS)


def members_of(spec: Any) -> "dict[str, tuple[MemberKind, Record]]":
    """{name: (kind, record)} of all members of a scene."""
    return {name: (kind, record) for section, kind in KINDS.items()
            for name, record in (spec.get(section) or {}).items()}


def bodies_that_hold(name: str, spec: Any) -> list[str]:
    """A body itself; of a point on a member the bodies that hold it, directly or through other members."""
    points, members, seen = spec.get("member_points") or {}, members_of(spec), []
    if name not in points:
        return [name]
    waiting, found = [points[name]["body"].text], []
    while waiting:
        member = waiting.pop()
        seen.append(member)
        for side in ("left", "right"):
            end = members[member][1].get(side, "free")
            for other in [] if isinstance(end, str) else [end[word].text for word in HOLDS if word in end]:
                if other not in members:
                    found.append(other)
                elif other not in seen:
                    waiting.append(other)
    return found
