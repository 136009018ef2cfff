"""Whether a spring or damper acts between rotations, and what that makes of its other keys."""

from collections.abc import Sequence
from typing import Any

from vibcli.language.kinds import Kind, Quantity
from vibcli.language.reader import Expression, Reader, Record


class Torsion(Kind):
    """A torsional coefficient, or the word true where something else says how large the moment is."""

    def __init__(self, unit: str) -> None:
        self.kind = Quantity(unit)

    @property
    def wants(self) -> str:
        return self.kind.wants + ", or the word true"

    def read(self, node: Any, reader: Any) -> Any:
        return True if getattr(node, "text", None) == "true" else self.kind.read(node, reader)

    def schema(self) -> dict[str, Any]:
        return {"anyOf": [{"const": True}, {"enum": ["true"]}, {"type": ["string", "number"]}]}


def settle_torsion(record: Record, reader: Reader, forces: Sequence[str], local: str, rate: bool) -> None:
    """The dimensions of what is a force, or of torsion a moment; `forces`: such keys, the law included, in which
    `local` is the deflection, or its rate."""
    torsion = "torsion" in record
    length, force = ("rad", "N*m") if torsion else ("m", "N")
    for key in ("stretch", "gap"):
        if key in record:
            reader.measured(record, key, length)
    for key in forces:
        if isinstance(record.get(key), Expression):
            reader.measured(record, key, force, said=True)
    if "law" in record:
        argument = f"{length}/s" if rate else length
        if isinstance(record["law"], Expression):
            reader.name_within(record["law"], local, argument)
        else:
            record["law"].check(reader, local, argument, force)
    said = [key for key in ("law", "friction", "series", "parallel") if key in record]
    if record.get("torsion") is True and not said:
        reader.report(record.place("torsion"), "`torsion: true` stands beside what says how large the moment is",
                      "write torsion: with its coefficient" + (", or a law" if not rate else ", a law or friction"))
    if "law" in record and "torsion" in record and record["torsion"] is not True:
        reader.report(record.place("torsion"), "'torsion' contradicts 'law' in one element",
                      "write `torsion: true` beside a law")
