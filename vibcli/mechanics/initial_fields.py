"""The fields of the place x that members start with, and what they say of the motions of their stations."""

from itertools import takewhile
from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.member_signals import oscillator_names
from vibcli.language.sections.initial import FIELDS, PLACE
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from vibcli.base.errors import Where
    from vibcli.elements.member import Member
    from vibcli.elements.member_line import Station
    from vibcli.mechanics.configuration import Configuration
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAME = 1e-9         # of the largest displacement: how far a field may be from what holds the member
WHAT = "this field", "the slope of this field"      # as a support holds them
POINTS = 61         # between which a field is looked at for its size


class MemberFields(NamedTuple):
    """u (of shafts φ) and its rate along a member at t = 0, counted from the drawn line, as functions of x, for which
    the time of the scene stands; None of what is not given."""

    displacement: "Node | None"
    rate: "Node | None"


def member_fields(scene: "Scene") -> dict[str, MemberFields]:
    """{member: MemberFields} of those of which a field is given."""
    found: dict[str, MemberFields] = {}
    for signal, expression in (scene.spec.get(FIELDS) or {}).items():
        node = scene.lower(expression, (PLACE, scene.time))
        known = found.get(signal.name, MemberFields(None, None))
        found[signal.name] = known._replace(**{"rate" if signal.primes else "displacement": node})
    return found


def start_of_stations(configuration: "Configuration", rest: "Callable[[], Mapping[str, float]]",
                      given: "Mapping[str, float]") -> dict[str, float]:
    """{coordinate, or velocity x': value} of what is attached to members that start with a field, `rest()` the
    coordinates at rest, and what is `given` of them by name; PhysicsError where a displacement contradicts a support,
    what is given, or the field of another member."""
    scene, found = configuration.scene, dict(given)
    for name, fields in member_fields(scene).items():
        member = scene.members[name]
        for field, primes in ((fields.displacement, ""), (fields.rate, "'")):
            if field is not None:
                found = _along(configuration, rest, member, field, primes, found) | found
    return found


def _along(configuration: "Configuration", rest: "Callable[..., Any]", member: "Member", field: "Node", primes: str,
           known: "Mapping[str, float]") -> dict[str, float]:
    scene, found = configuration.scene, {}
    parts = [field, gradient(field).get(scene.time, scene.table.zero)] if member.kind.bends else [field]
    where = scene.spec.get("initial").place(f"{member.name}.{member.kind.motion}{primes}")
    values = [_values(configuration, parts, station, where) for station in member.stations]
    sizes = _sizes(configuration, parts, member)
    for station, row in zip(member.stations, values, strict=True):
        found |= _hung(configuration, rest, member, station, row[0], primes)
        for motion, value, size, what in zip(member.motions(station), row, sizes, WHAT, strict=False):
            if motion.op == "symbol" and motion.name in scene.coordinates:
                found[motion.name + primes] = value
                other = known.get(motion.name, value)
                if not primes and abs(value - other) > SAME * max(size, abs(other)):
                    raise PhysicsError(f"'{motion.name}' starts at {other:.6g}, and {what} is {value:.6g} there",
                                       "let both agree, or leave one of them out", where)
            elif any(node.op == "symbol" and node.name in scene.coordinates for node in reachable([motion])):
                raise PhysicsError(f"what '{member.name}' is held to at {station.text} does not move as one coordinate:"
                                   " a field does not say how it starts", "give the start of each coordinate", where)
            elif not primes and abs(value - _at_first(configuration, motion)) > SAME * size:
                raise PhysicsError(f"'{member.name}' is held at {station.text}, where {what} is {value:.6g}",
                                   "a field of displacements fits the supports", where)
    return found


def _at_first(configuration: "Configuration", motion: "Node") -> float:
    """Where a support is at t = 0, which the time may move."""
    found: float = evaluate([motion], Floats, {**configuration.numeric.floats, configuration.scene.time.name: 0.0})[0]
    return found


def _hung(configuration: "Configuration", rest: "Callable[..., Any]", member: "Member", station: "Station",
          value: float, primes: str) -> dict[str, float]:
    """The starts of oscillators at a station that starts with a value: their springs are as long as at rest."""
    scene, found = configuration.scene, {}
    for name in takewhile(scene.coordinates.__contains__, oscillator_names(member.name, station.text)):
        found[name + primes] = value
        if not primes:
            resting, carrier = rest(), member.motions(station)[0]
            found[name] += resting[name] - evaluate([carrier], Floats, {**configuration.numeric.floats, **resting})[0]
    return found


def _sizes(configuration: "Configuration", parts: "list[Node]", member: "Member") -> list[float]:
    """How large functions of x are somewhere on a member."""
    floats, time = configuration.numeric.floats, configuration.scene.time.name
    length, = evaluate([member.length], Floats, floats)
    found = [evaluate(parts, Floats, {**floats, time: length * k / POINTS}) for k in range(POINTS + 1)]
    return [max((abs(x) for x in row if isfinite(x)), default=0.0) for row in zip(*found, strict=True)]


def _values(configuration: "Configuration", parts: "list[Node]", station: "Station", where: "Where") -> list[float]:
    """Functions of x at a station."""
    floats = configuration.numeric.floats
    place, = evaluate([station.place], Floats, floats)
    found = evaluate(parts, Floats, {**floats, configuration.scene.time.name: place})
    if not all(map(isfinite, found)):
        raise PhysicsError(f"this field is no real number at {station.text}", "give another one under `initial:`",
                           where)
    return found
