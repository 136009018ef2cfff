"""Records of a file: their names, and the dimensions of their values."""

from vibcli.base.units import NONE
from vibcli.language.record_calls import own
from vibcli.language.sections.record import dimension


def settle_records(spec, reader, records):
    """A record is neither a parameter nor a coordinate. Its values have its unit; without one they are pure numbers, in
    a scene without units anything."""
    for name, record in records.items():
        kind = "parameter" if name in spec.named.get("parameters", ()) else "coordinate"
        if kind == "parameter" or name in spec.coordinates:
            reader.report(record.where, f"'{name}' is a record and a {kind}", "rename one of them")
        measured = dimension(record)
        if measured is not None or not spec.free_numbers:
            spec.dimensions.equate(spec.dimensions.unknown(own(name)), NONE if measured is None else measured)
