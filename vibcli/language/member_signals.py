"""Signals of continuous members, each at a place that is counted from the left end: `rod.u(L/2)`."""

from itertools import count
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import nearest

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Record
    from vibcli.language.signal_names import SignalName
    from vibcli.language.spec import Spec

PARTS = {"bars": {"u": "m", "force": "N", "stress": "Pa"},
         "shafts": {"phi": "rad", "moment": "N*m", "stress": "Pa"},
         "beams": {"u": "m", "slope": "rad", "moment": "N*m", "shear": "N", "stress": "Pa"},
         "strings": {"u": "m", "slope": "rad", "force": "N"}}
OF_COORDINATES = "across", "oscillator"         # what fields along members do not tell
STRETCHING = {"along": "m", "force": "N"}
ABOUT = (
    ("rod.u(x), .force, .stress", "of a bar at the place x from its left end, a length: displacement along the bar, "
                                  "tension EA u′, stress E u′"),
    ("line.phi(x), .moment, .stress", "of a shaft: turn, torque GI_o φ′, stress G φ′ D/2 at its outside"),
    ("wing.u(x), .slope, .moment, .shear, .stress",
     "of a beam: displacement across it, to the left of the way from its left end to its right one (upwards where it "
     "runs to the right), slope u′, bending moment EI u″, shear (EI u″)′, stress E u″ h/2 at the outer fibre. Stress "
     "of beams and shafts needs a `section`"),
    ("wing.along(x), .force", "of a beam that stretches, in the plane with an `EA`: displacement w along it, tension "
                              "EA w′ beside its `preload`"),
    ("rod.across(x)", "of a bar in the plane, which stays straight: displacement to the left of the way from its left "
                      "end to its right one"),
    ("wing.oscillator(x)", "of an oscillator that is attached at that place: displacement of its mass, on a shaft its "
                           "turn; of the second one there `wing.oscillator.2(x)`"),
    ("cord.u(x), .slope, .force", "of a string: displacement across it, slope u′, tension, which small motions do "
                                   "not change"),
    ("rod.u'(x)", "the rate of any of these; `rod.u(L)(1 ms)` is the value in time. At a jump along x the value on its "
                  "right counts, at the right end that on its left. Counted from the drawn line, in modes and "
                  "frequency responses from the equilibrium"),
)


class Mistake(NamedTuple):
    """What is wrong with a signal, and what to write."""

    message: str
    hint: str | None


def member_unit(spec: "Spec", signal: "SignalName") -> str | None:
    """The unit of a signal of a member; None where there is none of that name."""
    section = spec.members.get(signal.name)
    if section is None or not signal.place or _no_stress(spec, signal, section):
        return None
    return parts_of(spec, signal.name).get(signal.part)


def parts_of(spec: "Spec", name: str) -> dict[str, str]:
    """{part: its unit} of the signals of a member."""
    section = spec.members[name]
    record = spec.get(section)[name]
    stretches = section == "beams" and any("EA" in part for part in (record, *record.get("segments", ())))
    hung = dict.fromkeys(oscillator_parts(record), "rad" if section == "shafts" else "m")
    drawn = {"across": "m"} if section == "bars" and "from" in record else {}
    return PARTS[section] | (STRETCHING if stretches else {}) | drawn | hung


def oscillator_names(member: str, place: str) -> "Iterator[str]":
    """The motions of oscillators at a place, as the file has them: `wing.oscillator(L)`, `wing.oscillator.2(L)`, …"""
    yield f"{member}.oscillator({place})"
    yield from (f"{member}.oscillator.{number}({place})" for number in count(2))


def oscillator_parts(record: "Record") -> list[str]:
    """The parts by which names of a member's oscillators may go: `oscillator`, `oscillator.2`, …"""
    number = sum("oscillator" in part for part in record.get("attached", ()))
    return ["oscillator", *(f"oscillator.{i}" for i in range(2, number + 1))][:number]


def _no_stress(spec: "Spec", signal: "SignalName", section: str) -> bool:
    """Is it the stress of a member whose cross-section is not given everywhere?"""
    if signal.part != "stress":
        return False
    record = spec.get(section)[signal.name]
    keys = ("section", "A") if section == "bars" else ("section",)
    return not any(all(any(key in part for part in (segment, record)) for segment in record.get("segments", (record,)))
                   for key in keys)


def member_signals(spec: "Spec", signal: "SignalName") -> list[str]:
    """All signals of a member, at the place of the one given, else at its left end."""
    parts = parts_of(spec, signal.name)
    return [f"{signal.name}.{part}({signal.place or 0})" for part in parts
            if member_unit(spec, signal._replace(part=part, place="0", primes=0))]


def mistake(spec: "Spec", signal: "SignalName") -> Mistake | None:
    """What is wrong with the name of a signal of a member but for its place; None where nothing is, or of others."""
    section = spec.members.get(signal.name)
    if section is None:
        return _of_point(spec, signal)
    if signal.part not in parts_of(spec, signal.name):
        noun, known = section[:-1], member_signals(spec, signal)
        if section == "beams" and signal.part in STRETCHING:
            return Mistake(f"'{signal.name}' keeps its length: it has no '{signal.part}'", "a beam in the plane with "
                           "`EA` stretches")
        if not signal.part:
            return Mistake(f"'{signal.name}' is a {noun}: it has no value of its own", f"ask for {known[0]}")
        hint = nearest(signal._replace(place=signal.place or "0").still.text, known)
        return Mistake(f"a {noun} has no '{signal.part}'", hint or "ask for " + " or ".join(known))
    if not signal.place:
        record: Record = spec.get(section)[signal.name]
        at = record["length"].text if "length" in record else "0"
        return Mistake(f"'{signal.text}' needs a place on the {section[:-1]}",
                       f"write {signal._replace(place=at).text}")
    if _no_stress(spec, signal, section):
        return Mistake(f"'{signal.name}' has no cross-section: its stress is not known",
                       "give it a `section`, as in {circle: d}, or ask for "
                       + signal._replace(part={"bars": "force"}.get(section, "moment")).text)
    return None


def _of_point(spec: "Spec", signal: "SignalName") -> Mistake | None:
    """A point on a member without a place has no name of its own."""
    point = (spec.get("member_points") or {}).get(signal.name)
    if point is None:
        return None
    member = point["body"].text
    section = spec.members[member]
    if "from" in spec.get(section)[member]:
        return None
    motion = next(iter(PARTS[section]))
    return Mistake(f"'{signal.name}' is a point on '{member}', which has no place in the plane",
                   f"ask for {member}.{motion}({point['at'].text})")


def start_mistake(spec: "Spec", signal: "SignalName") -> Mistake | None:
    """What is wrong with the name of a field that a member starts with; None where nothing is."""
    section = spec.members[signal.name]
    motion = next(iter(PARTS[section]))
    if signal.part == motion and signal.primes < 2 and not signal.place:
        return None
    field = signal._replace(part=motion, place="", primes=0)
    return Mistake(f"a {section[:-1]} starts with a field of '{motion}' and one of its rate, found '{signal.text}'",
                   f"write {field.text}: … or {field._replace(primes=1).text}: …, x being the place")
