"""The keys of what consists of parts, in series and in parallel, nested."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.elements.torsion import Torsion, settle_torsion
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity
from vibcli.language.named_elements import Lazy, LazyKind

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record

KEYS = "series", "parallel"
SERIES = "its parts one behind the other, which share the force"
PARALLEL = "its parts side by side, which share the deflection"


class InnerParts(Many):
    """Parts within a part."""

    __slots__ = ()

    def schema(self) -> dict[str, Any]:
        return {"type": "array", "items": {"$ref": f"#/definitions/{self.kind.name}"}, "minItems": self.least}


def part_element(whole: str, part: Lazy, key: str, about: str, unit: str, turning: str) -> Element:
    """The element of a part of a spring or damper, `part` where it stands within one, `key` being its coefficient in a
    unit, or in that of torsion."""
    rate = key == "c"
    law = "its force as a function of the rate v of its own length" if rate else (
        "its tension as a function of its own deflection d")
    inner = InnerParts(part, 2, named="a list of two parts or more")
    return Element(f"part of a {whole}", f"A part of a {whole} that consists of several, in series or in parallel.", {
        key: Field(Quantity(unit), about),
        "torsion": Field(Torsion(turning), f"its torsional coefficient, where the {whole} turns; `true` beside a law"),
        "law": Field(LazyKind("law_table", "language.sections"), law + ", or a table of points"),
        "series": Field(inner, SERIES),
        "parallel": Field(inner, PARALLEL),
    }, example=f"{whole}s_in_series", exclusive=((key, "torsion"), (key, "law", *KEYS)),
        needs=((key, "torsion", "law", *KEYS),), settle=_settle(rate), instead=_instead(whole))


def _instead(whole: str) -> dict[str, str]:
    of_all = f"it belongs to the whole {whole}, beside its parts"
    return {"c" if whole == "spring" else "k": "a spring and a damper in series move a body without mass between them: "
            "write that body", "friction": "dry friction jumps: put a body between it and the rest",
            **dict.fromkeys(("preload", "free_length", "acts", "gap", "between", "stretch"), of_all)}


def _settle(rate: bool) -> "Callable[[Record, Reader], None]":
    def settle(record: "Record", reader: "Reader") -> None:
        settle_parts(record, reader)
        settle_torsion(record, reader, ("law",), "v" if rate else "d", rate=rate)
    return settle


def settle_parts(record: "Record", reader: "Reader") -> None:
    """Of parts either all turn or none, and what they are the parts of does as they do."""
    parts = [part for key in KEYS for part in record.get(key, ())]
    turning = ["torsion" in part for part in parts]
    if any(turning) and not all(turning):
        reader.report(parts[turning.index(False)].where, "this part acts along a line, another one turns",
                      "write `torsion:` in all of them, `torsion: true` beside a law")
    elif any(turning):
        record["torsion"] = True
    elif parts and "torsion" in record:
        reader.report(record.place("torsion"), "this turns, its parts act along a line",
                      "write `torsion:` in its parts")
