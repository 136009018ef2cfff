"""Families in tables, and as data."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from vibcli.base.enumeration import listed
from vibcli.evidence.stress.point import StressPoint
from vibcli.evidence.stress.shaken import Shake
from vibcli.evidence.stress.supported import SupportedAnswer
from vibcli.evidence.stress.sweep import FamilyPoints, about, counts
from vibcli.evidence.told import drawn_values
from vibcli.report.blocks import Section, TableBlock, paragraph

MOVED = "Each figure of three digits or more was moved by half a unit of its last digit."


def section(one: FamilyPoints) -> Section:
    """A family's table; errors and bounds are relative, of the number whose error comes nearest to its bound."""
    head = (one.family.knob, "condition", "true error", "bound stated", "plain error", "verdict")
    refused = [f"{point.knob}: {point.why}" for point in one.points if point.why]
    reasons: dict[str, list[str]] = {}
    for point in one.points:
        if point.plain_why:
            reasons.setdefault(point.plain_why, []).append(point.knob)
    refused += [f"plain at {', '.join(knobs)}: {why}" for why, knobs in reasons.items()]
    rows = tuple((point.knob, *map(_shown, (point.condition, point.error, point.bound, point.plain)), _verdict(point))
                 for point in one.points)
    return Section(f"{one.name}: {about(one.name)}", (
        TableBlock(head, rows), paragraph(f"plain: {one.plain}"), *map(paragraph, refused)))


def _shown(number: float) -> str:
    return "" if number is None else "none" if math.isinf(number) else f"{number:.1e}"


def _verdict(point: StressPoint) -> str:
    return f"{point.verdict}, idle bound" if point.idle else point.verdict


def summary(found: Sequence[FamilyPoints]) -> str:
    """How many points there are of each verdict."""
    words = counts(found)
    idle, total = words.pop("idle"), sum(words.values())
    return (f"{total} points of {len(found)} famil{'y' if len(found) == 1 else 'ies'}: "
            + ", ".join(f"{count} {word}" for word, count in words.items()) + f"; {idle} bounds idle")


def data(found: Sequence[FamilyPoints]) -> dict[str, Any]:
    """The same as data; what is not finite is null."""
    return {"counts": counts(found), "families": [
        {"name": one.name, "about": about(one.name), "knob": one.family.knob, "plain": one.plain,
         "points": [{key: None if isinstance(x, float) and not math.isfinite(x) else x
                     for key, x in point._asdict().items()} for point in one.points]} for one in found]}


def scene_sections(shakes: Sequence[Shake], answers: Sequence[SupportedAnswer], drawn: Mapping[str, str]
                   ) -> list[Section]:
    """Of a scene of the user's: the values drawn for its letters, what was shaken, and how far its data reach."""
    rows = tuple((one.change, str(one.compared), one.verdict, f"{one.apart:.2g} {one.why}" if one.apart else one.why)
                 for one in shakes)
    head = "change", "compared", "verdict", "apart/bounds"
    found = [*drawn_values(drawn), Section("Shaken", (TableBlock(head, rows),))]
    if answers:
        lines = tuple((one.asked, f"{one.value:.6g}", _digits(one), one.parameter) for one in answers
                      if one.value is not None)
        table = TableBlock(("answer", "value", "digits", "taken most by"), lines)
        refused = (paragraph(f"{one.asked}: {one.why}") for one in answers if one.value is None)
        found.append(Section("Digits that the data support", (
            *[table] * bool(lines), *refused, paragraph(MOVED + _held(answers)))))
    return found


def _held(answers: Sequence[SupportedAnswer]) -> str:
    """What could not be moved, the same of all answers."""
    held = answers[0].held
    return f" Not moved, since nothing fits together with it alone: {listed(held)}." if held else ""


def _digits(one: SupportedAnswer) -> str:
    return "all" if one.digits is None else f"{one.digits:.1f}"


def scene_data(shakes: Sequence[Shake], answers: Sequence[SupportedAnswer], drawn: Mapping[str, str]
               ) -> dict[str, Any]:
    """The same as data."""
    return {"drawn": drawn or None,
            "shaken": [{**one._asdict(), "apart": one.apart if math.isfinite(one.apart) else None} for one in shakes],
            "supported": [one._asdict() for one in answers]}
