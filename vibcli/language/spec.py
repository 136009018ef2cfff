"""A scene file as read: records by section, coordinates in order, dimensions of all names."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Remark
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.units import Dimensions
from vibcli.language.reader import Record

if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction

    from vibcli.reader.sections.answer import Answer
    from vibcli.symbolic.syntax import QuantityRef

RELEASED = "released"       # the key of the force that lets go, among what a motion starts from
EXPANDED = "expanded"       # motions of the equations to the third order, {order: 3}
MEMBERS = ("bars", "shafts", "beams", "strings")        # the sections of continuous members


class Integrated(NamedTuple):
    """What `motion:` says of motions beyond a word: their kind, None where that is left open, and the accuracy that is
    asked."""

    kind: str | None
    accuracy: float | None = None


class Spec(NamedTuple):
    """`get(section, default)`: the records of a section; `named`: the names that stand in each section, of what could
    not be read as well; `used`: those on which something depends; `counts`: what names count, cycles or radians;
    `asked_dimension(spec, tree)`: that of a quantity, None while none may stand; `sample`: values of letters at which
    the scene is drawn, where not any will do; `remarks`: what is no error, and may be meant otherwise."""

    file: str
    sections: dict[str, Any]
    get: Callable[..., Any]
    named: dict[str, list[str]]
    parameters: dict[str, Record]
    choices: dict[str, Record]
    answers: "list[Answer]"
    used: set[str]
    counts: "dict[str, Mapping[str, Fraction | int]]"
    sample: dict[str, float]
    cases: dict[str, "Spec"]
    coordinates: dict[str, Record] | None = None
    dimensions: Dimensions | None = None
    free_numbers: bool | str = False
    asked_dimension: "Callable[[Spec, QuantityRef], Mapping[str, Fraction | int] | None] | None" = None
    remarks: Sequence[Remark] = ()

    @property
    def motion(self) -> str | None:
        """What its motions are: small, full or EXPANDED; None where that is not said."""
        said = self.get("motion")
        return said.kind if isinstance(said, Integrated) else said

    @property
    def accuracy(self) -> float | None:
        """How accurately its motions are integrated; None where nothing is asked."""
        said = self.get("motion")
        return said.accuracy if isinstance(said, Integrated) else None

    def with_accuracy(self, accuracy: float) -> "Spec":
        """The Spec whose motions, and those of its cases, are integrated so accurately."""
        cases = {name: case.with_accuracy(accuracy) for name, case in self.cases.items()}
        return self.with_sections(motion=Integrated(self.motion, accuracy))._replace(cases=cases)

    @property
    def in_full(self) -> bool:
        """Are its motions integrated, of equations that are not those of small oscillations?"""
        return self.motion in ("full", EXPANDED)

    @property
    def expanded(self) -> bool:
        """Are they those of the equations expanded to the third order?"""
        return self.motion == EXPANDED

    @classmethod
    def of(cls, file: Any, sections: Any, named: Any) -> "Spec":
        """A Spec whose names are not settled yet."""
        return cls(file, sections, sections.get, named, parameters=sections.get("parameters", {}), choices={},
                   answers=sections.get("answers", []), used=set(), counts={}, sample={}, cases={})

    def with_sections(self, **changed: Any) -> "Spec":
        """The Spec with other records in some sections."""
        sections = {**self.sections, **changed}
        return self._replace(sections=sections, get=sections.get)

    @property
    def connections(self) -> list[Record]:
        """The records of what joins two ends: springs, dampers and their like."""
        return [record for section in self.sections.values() if isinstance(section, dict) for record in section.values()
                if isinstance(record, Record) and record.element is not None and record.element.signals]

    def connection(self, name: str) -> Record | None:
        """The one of that name; None where there is none."""
        return next((record for record in self.connections if record.name == name), None)

    def origin(self, coordinate: str) -> Record:
        """What brings a coordinate into the scene: a record of its own, or that of a member."""
        if coordinate in self.coordinates:
            return self.coordinates[coordinate]
        name = coordinate.partition(".")[0]
        record: Record = self.sections[self.members[name]][name]
        return record

    @property
    def members(self) -> dict[str, str]:
        """{name: section} of its bars, shafts, beams and strings."""
        return {name: section for section in MEMBERS for name in self.sections.get(section) or ()}

    def coordinate_name(self, index: str) -> str | None:
        """A coordinate by its name or its number from 1; None where there is none."""
        names = list(self.coordinates)
        if index.isdecimal() and index.isascii():
            return names[int(index) - 1] if 1 <= int(index) <= len(names) else None
        return index if index in self.coordinates else None

    @property
    def let_go(self) -> str | None:
        """The name of the force that lets go at t = 0; None where none does."""
        record = self.get("initial")
        name: str | None = record[RELEASED].text if record is not None and RELEASED in record else None
        return name

    def with_parameters(self, parameters: Any) -> "Spec":
        """The Spec with other parameters."""
        sections = {**self.sections, "parameters": parameters}
        return self._replace(sections=sections, get=sections.get, parameters=parameters)

    @property
    def independent_parameters(self) -> list[str]:
        """Names of the parameters that are not defined by others."""
        records = self.parameters
        return [name for name, record in records.items() if "value" not in record
                or not any(other in records for other, *_ in record["value"].parts.names)]

    def example(self, literal: str) -> str:
        """A number with its unit for a hint, as this scene writes numbers: without it where it uses none."""
        return literal.partition(" ")[0] if self.free_numbers else literal
