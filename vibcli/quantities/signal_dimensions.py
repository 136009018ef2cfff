"""Names of signals and inputs of a scene, and what they measure."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import ENERGIES, prescribed, signal_dimension

if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction

    from vibcli.language.reader import Record
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import QuantityRef


def name_dimension(spec: "Spec", name: str) -> "Mapping[str, Fraction | int] | None":
    """The dimension of a coordinate, parameter or signal."""
    known = name in spec.coordinates or name in spec.parameters
    return spec.dimensions.of(name) if known else signal_dimension(spec, name)


def output_dimension(spec: "Spec", text: str) -> "Mapping[str, Fraction | int] | None":
    """The dimension of a coordinate or signal, with its primes; None where there is none of that name."""
    primes, name = (signal := signal_name(text)).primes, signal.still.text
    found = spec.dimensions.of(name) if name in spec.coordinates else signal_dimension(spec, name)
    if found is None and name in ENERGIES and name not in spec.parameters:
        found = units.parse_unit(ENERGIES[name]).dimension
    return None if found is None or primes > 2 else units.times(found, units.TIME, -primes)


def deflection_dimension(spec: "Spec", name: str) -> Any:
    """Of what the law of a spring counts, its deflection, or of a damper the rate of that."""
    found = output_dimension(spec, name + ".stretch" + "'" * (name in (spec.get("dampers") or {})))
    return units.LENGTH if found is None else found


def inputs(spec: "Spec") -> list[str]:
    """The names of what can drive a scene; a force that has let go cannot."""
    driven = [name for name, record in (spec.get("points") or {}).items()
              if any(_within_functions(part.tree) for _, part in prescribed(spec, record).values())]
    bodies = [name for name, record in (spec.get("bodies") or {}).items() if _one_drive(spec, record)]
    loads = [name for name in spec.get("forces") or {} if name != spec.let_go]
    return [*loads, *driven, *bodies, *spec.coordinates]


def _one_drive(spec: "Spec", record: "Record") -> str | None:
    """The unit of the force along what is driven of a body, to and fro in one way; None of others."""
    driven = list(prescribed(spec, record).values())
    return driven[0][0] if len(driven) == 1 and _within_functions(driven[0][1].tree) else None


def _within_functions(tree: "QuantityRef") -> bool:
    """Does the time stand within functions alone, as in Y*sin(Omega*t) and not in v*t?"""
    if tree.kind in ("name", "call"):
        return tree.kind == "call" or tree.name != "t"
    return all(_within_functions(child) for child in tree.children)


def input_dimension(spec: "Spec", name: str) -> "Mapping[str, Fraction | int] | None":
    """The dimension of a unit of an input: of a force, moment, unbalance, displacement or generalised force, of a load
    along a member that of its largest value."""
    record = (spec.get("forces") or {}).get(name)
    if record is not None:
        if "per_length" in record:
            return units.parse_unit("N" if record["body"].text in (spec.get("shafts") or {}) else "N/m").dimension
        if "value" in record:
            return generalised_dimension(spec, record["coordinate"].text)
        unit = next(unit for key, unit in (("force", "N"), ("moment", "N*m"), ("unbalance", "kg*m")) if key in record)
        return units.parse_unit(unit).dimension
    if "moves" in (spec.get("points") or {}).get(name, ()):
        return units.LENGTH
    body = (spec.get("bodies") or {}).get(name)
    if body is not None and (unit := _one_drive(spec, body)):
        return units.times(units.ENERGY, units.parse_unit(unit).dimension, -1)
    return generalised_dimension(spec, name) if name in spec.coordinates else None


def generalised_dimension(spec: "Spec", coordinate: str) -> "dict[str, Fraction | int]":
    """Of a generalised force: energy over coordinate."""
    return units.times(units.ENERGY, spec.dimensions.of(coordinate), -1)
