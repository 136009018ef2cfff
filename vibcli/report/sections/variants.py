"""Variants of a problem: how many passed which gate, their keys, the mistakes that come nearest, all of them."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.notation.numbers import in_figures, plainly
from vibcli.reader.sections.variants import GATES
from vibcli.report.blocks import Name, Section, TableBlock, maths, paragraph, section
from vibcli.report.keys import Key

if TYPE_CHECKING:
    from vibcli.homework.variants import KeyValue, SolvedVariants
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def variants(problem: "Problem", report: "Report") -> Iterator[Section]:
    """Counts, keys and mistakes."""
    found = report.wanted.variants
    rules, total = found.rules, len(found.accepted) + len(found.rejected)
    of = f" of {rules.candidates} in the grid" if total < rules.candidates else ""
    yield from section(
        "Variants", paragraph(f"{_count(total, 'candidate')}{of}, {len(found.accepted)} accepted."),
        _gates(found), *(paragraph(text) for text in _remarks(found)))
    if found.accepted:
        yield from section("Keys", _keys(found))
        yield from section("Mistakes", _mistakes(found), *(paragraph(
            f"“{name}” leads to {text} itself in every variant: it is left out.") for name, text in found.same))


def variant_table(problem: "Problem", report: "Report") -> Iterator[Section]:
    """All accepted variants."""
    found = report.wanted.variants
    if not found.accepted:
        return
    names = list(found.accepted[0].values)
    head = ("no.", *(maths(Name(name)) for name in names), *(_named(key) for key in found.keys))
    yield from section("Accepted", TableBlock(head, tuple(
        (str(number), *(_printed(one.values[name].text) for name in names),
         *(in_figures(key.value, key.band.figures) for key in one.keys))
        for number, one in enumerate(found.accepted, 1))))


def rejected_variants(problem: "Problem", report: "Report") -> Iterator[Section]:
    """All rejected candidates, each with its reason."""
    found = report.wanted.variants
    if not found.rejected:
        return
    names = list(found.rejected[0].values)
    yield from section("Rejected", TableBlock((*(maths(Name(name)) for name in names), "gate", "reason"), tuple(
        (*(_printed(one.values[name].text) if name in one.values else "–" for name in names), one.gate, one.reason)
        for one in found.rejected)))


def _printed(text):
    """A value or unit as it is set in print."""
    from vibcli.notation.as_printed import as_printed

    return as_printed(text)


def _count(number, what):
    return f"{number} {what}" + "s" * (number != 1)


def _named(key):
    return key.text + (f" [{_printed(key.unit)}]" if key.unit else "")


def _gates(found):
    rows = []
    for gate, count in found.counts.items():
        if gate in found.rules.without:
            rows.append((gate, "off", GATES[gate]))
        elif count or gate in GATES:
            rows.append((gate, str(count), GATES.get(gate, "there is such a scene, and it has such an answer")))
    return TableBlock(("gate", "rejected", "what it asks"), tuple(rows))


def _remarks(found):
    if found.reread:
        yield f"{_count(found.reread, 'variant')} read anew from the printed values: the same keys."


def _keys(found):
    rows = []
    for i, key in enumerate(found.keys):
        values = [one.keys[i] for one in found.accepted]
        texts = {in_figures(one.value, one.band.figures) for one in values}
        low, high = (pick(values, key=lambda one: one.value) for pick in (min, max))
        widest = max(one.band.width / abs(one.value) for one in values if one.value) if any(
            one.value for one in values) else 0.0
        rows.append((key.text, _printed(key.unit) or "–", in_figures(low.value, low.band.figures),
                     in_figures(high.value, high.band.figures), str(len(texts)), _figures(values),
                     f"{plainly(100 * widest)} %"))
    return TableBlock(("quantity", "unit", "least", "largest", "distinct", "figures", "widest band"), tuple(rows))


def _figures(values):
    least, most = (pick(one.band.figures for one in values) for pick in (min, max))
    return str(least) if least == most else f"{least} to {most}"


def _mistakes(found):
    """Of each mistake and key, the variant in which they come nearest."""
    rows = []
    for i, key in enumerate(found.keys):
        for mistake in found.mistakes:
            pairs = [(abs(wrong.value - one.keys[i].value) / abs(one.keys[i].value), one.keys[i], wrong.value)
                     for one in found.accepted for wrong in one.keys[i].wrong if wrong.mistake == mistake.name]
            if pairs:
                gap, nearest, wrong = min(pairs, key=lambda pair: pair[0])
                rows.append((gap, (mistake.name, key.text, in_figures(nearest.value, nearest.band.figures),
                                   in_figures(wrong, nearest.band.figures), f"{plainly(100 * gap)} %")))
    rows.sort(key=lambda row: row[0])
    head = ("mistake, nearest first", "quantity", "key", "mistaken", "apart")
    return TableBlock(head, tuple(row for _, row in rows)) if rows else None


def variants_data(found: "SolvedVariants") -> dict:
    """The variants with the keys of --json."""
    asked = [{"name": key.text, "unit": key.unit or None, "points": key.points} for key in found.keys]
    accepted = [{"given": _given_data(one), "keys": [_key_data(key) for key in one.keys]} for one in found.accepted]
    rejected = [{"given": _given_data(one), "gate": one.gate, "reason": one.reason} for one in found.rejected]
    same = [{"mistake": name, "name": text} for name, text in found.same]
    counts = [{"gate": gate, "rejected": count} for gate, count in found.counts.items()]
    return KEY.row(len(accepted) + len(rejected), counts, list(found.rules.without), asked, accepted, rejected, same,
                   found.reread)


def _given_data(one):
    return [{"name": name, "value": value.text} for name, value in one.values.items()]


def _key_data(key: "KeyValue"):
    wrong = [{"mistake": one.mistake, "value": one.value} for one in key.wrong]
    return {"value": key.value, "error": key.error, "figures": key.band.figures, "band": key.band.width,
            "mistakes": wrong}


GIVEN = (Key("name", "the parameter"), Key("value", "its value as text"))
KEY = Key("variants", "the variants of a problem", of=(
    Key("candidates", "how many were looked at"),
    Key("counts", "by gates, in their order, a list", each=(
        Key("gate", "its name"), Key("rejected", "how many failed it before any other"))),
    Key("without", "gates that the file switches off"),
    Key("asked", "what is asked, a list", each=(
        Key("name", "the quantity"), Key("unit", "in which it is asked; null of a pure number"),
        Key("points", "that it gives"))),
    Key("accepted", "the variants, a list", each=(
        Key("given", "the values of parameters, a list", each=GIVEN),
        Key("keys", "in the order of `asked`, in its units, a list", each=(
            Key("value", "the key"), Key("error", "an absolute bound of its error"),
            Key("figures", "to how many it is asked"), Key("band", "how far a right answer may lie from it"),
            Key("mistakes", "what known mistakes give, a list", each=(
                Key("mistake", "its name"), Key("value", "what it gives"))))))),
    Key("rejected", "the other candidates, a list", each=(
        Key("given", "the values of parameters, a list", each=GIVEN), Key("gate", "the first that it failed"),
        Key("reason", "why"))),
    Key("same", "mistakes that lead to the key in every variant, a list", each=(
        Key("mistake", "its name"), Key("name", "the quantity"))),
    Key("reread", "how many were held against the scene read anew")))
