"""What stands at the ends of members and what is attached to them: supports, springs, masses, oscillators."""

from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Mapping
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, NameOf, OneOf, Quantity

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record

FREE, CLAMPED, PINNED, GUIDED = "free", "clamped", "pinned", "guided"
HOLDS = (CLAMPED, PINNED, GUIDED)
OTHERS = {"fixed": CLAMPED, "built-in": CLAMPED, "built in": CLAMPED, "hinged": PINNED, "simply supported": PINNED,
          "supported": PINNED, "simple": PINNED, "sliding": GUIDED}       # words of books
_OTHER = NameOf("the name of a body or another member", "bodies", "members")
_STIFFNESS, _TORSION = Field(Quantity("N/m"), "the stiffness of a spring to the ground"), Field(
    Quantity("N*m"), "the stiffness of a torsion spring to the ground")
_TURNING = {"inertia": Field(Quantity("kg*m^2"), "its moment of inertia"),
            "torsion": Field(Quantity("N*m"), "the torsional stiffness by which it hangs on the shaft"),
            "c": Field(Quantity("N*m*s"), "the coefficient of its torsional damper")}
_SLIDING = {"mass": Field(Quantity("kg"), "its mass"),
            "k": Field(Quantity("N/m"), "the stiffness of the spring by which it hangs on the member"),
            "c": Field(Quantity("N*s/m"), "the coefficient of the damper beside it")}


def _settle_end(record: "Record", reader: "Reader") -> None:
    if "at" in record and not any(key in record for key in HOLDS):
        reader.report(record.place("at"), "'at' is a place on another member, and this end is held to none",
                      "write `{clamped: girder, at: L1}`")
    if any(key in record for key in HOLDS) and any(key in record for key in ("k", "torsion", "c")):
        key = next(key for key in ("k", "torsion", "c") if key in record)
        reader.report(record.place(key), f"'{key}' at an end that is held to something", "springs and dampers at "
                      "a point of the member stand under `springs` and `dampers`")
    if not record.places:
        reader.report(record.where, "expected what holds this end", "write free, clamped or {k: k}")


def end_kind(torsional: bool, bends: bool) -> OneOf:
    """What may stand at `left` and `right` of shafts (`torsional`), beams (`bends`) and of other members."""
    holds = HOLDS if bends else HOLDS[:2]
    fields = {word: Field(_OTHER, f"{word} to a body or another member") for word in holds}
    fields["at"] = Field(Quantity("m"), "the place on that member, from its left end")
    fields["c"] = Field(Quantity("N*m*s" if torsional else "N*s/m"), "the coefficient of a damper to the ground")
    if not torsional:
        fields["k"] = _STIFFNESS
    if torsional or bends:
        fields["torsion"] = _TORSION
    element = Element("end", "An end of a member.", fields, exclusive=(holds,), settle=_settle_end,
                      example="beams", instead={
                          key: f"what sits at an end stands under `attached`, as in [{{at: L, {key}: …}}]"
                          for key in ("inertia" if torsional else "mass", "inertia", "oscillator")})
    words = (FREE, *HOLDS) if bends else (FREE, CLAMPED, PINNED)
    wanted = f"{', '.join(words)}, or a mapping such as {{clamped: base}}"
    return OneOf(wanted, scalar=Choice(*words, others=OTHERS), mapping=element)


class _Attachment(Element):
    """One thing at a place of a member."""

    def read(self, node: Any, reader: Any, *named: Any) -> Any:
        record = super().read(node, reader, *named)
        if record is not None and set(record) <= {"at"} and isinstance(node, Mapping):
            reader.report(record.where, "nothing is attached here", "give a mass, a spring `k`, a support or an "
                          "oscillator")
        return record


def _settle_oscillator(record: "Record", reader: "Reader") -> None:
    moving, tied = ("inertia", ("torsion", "c")) if "torsion" in record.element.fields else ("mass", ("k", "c"))
    if moving not in record:
        reader.report(record.where, f"an oscillator needs '{moving}'", "what has none is a spring or damper")
    elif not any(key in record for key in tied):
        reader.report(record.where, "nothing ties this oscillator to the member", f"give `{tied[0]}`")


def attachment(torsional: bool, bends: bool) -> Element:
    """What may be attached to shafts (`torsional`), beams (`bends`) and other members."""
    holds = (PINNED, CLAMPED, GUIDED) if bends else (PINNED, CLAMPED)
    fields = {"at": Field(Quantity("m"), "the place, from the left end", required=True)}
    oscillator = Element("oscillator", "A mass on a spring and a damper, hung on a member; on a shaft an inertia.",
                         _TURNING if torsional else _SLIDING, settle=_settle_oscillator,
                         example="beams")
    if not torsional:
        fields["mass"] = Field(Quantity("kg"), "a mass")
        fields["k"] = _STIFFNESS
    if torsional or bends:
        fields["inertia"] = Field(Quantity("kg*m^2"), "a moment of inertia")
        fields["torsion"] = _TORSION
    fields["c"] = Field(Quantity("N*m*s" if torsional else "N*s/m"), "the coefficient of a damper to the ground")
    fields["support"] = Field(Choice(*holds), "a support")
    fields["oscillator"] = Field(oscillator, "a mass on a spring: `{mass: m, k: k, c: c}`, on shafts "
                                 "`{inertia: J, torsion: kt, c: c}`")
    return _Attachment("attachment", "What is attached to a member at a place: a mass, a spring or damper to the "
                       "ground, a support, an oscillator.", fields, example="beams")
