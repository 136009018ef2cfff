"""Records of a file: their names, and the dimensions of their values."""

from vibcli.base.units import NONE
from vibcli.language.record_calls import own


def check_record_names(spec, reader):
    """A record is neither a parameter nor a coordinate."""
    for name, record in (spec.get("records") or {}).items():
        kind = "parameter" if name in spec.named.get("parameters", ()) else "coordinate"
        if kind == "parameter" or name in spec.coordinates:
            reader.report(record.where, f"'{name}' is a record and a {kind}", "rename one of them")


def record_dimensions(spec):
    """The values of a record have its unit; without one they are pure numbers, in a scene without units anything."""
    records = spec.get("records") or {}
    if not records:
        return
    from vibcli.language.sections.record import dimension

    for name, record in records.items():
        measured = dimension(record)
        if measured is not None or not spec.free_numbers:
            spec.dimensions.equate(spec.dimensions.unknown(own(name)), NONE if measured is None else measured)
