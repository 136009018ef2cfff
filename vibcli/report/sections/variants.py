"""Variants of a problem: how many passed which gate, their keys, the mistakes that come nearest, all of them."""

from collections.abc import Iterator, Sequence
from math import inf
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.enumeration import amount
from vibcli.notation.numbers import plainly
from vibcli.reader.sections.variants import GATES
from vibcli.report.blocks import Name, Section, TableBlock, maths, paragraph, section
from vibcli.report.keys import Key

if TYPE_CHECKING:
    from vibcli.homework.variants import SolvedVariants
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def variants(problem: "Problem", report: "Report") -> Iterator[Section]:
    """Counts, keys and mistakes."""
    found = report.wanted.variants
    rules, total = found.rules, len(found.accepted) + len(found.rejected)
    of = f" of {rules.candidates} in the grid" if total < rules.candidates else ""
    yield from section(
        "Variants", paragraph(f"{amount(total, 'candidate')}{of}, {len(found.accepted)} accepted."),
        _gates(found), *(paragraph(text) for text in _remarks(found)))
    if found.accepted:
        summaries = found.summaries
        yield from section("Keys", _keys(found, summaries))
        yield from section("Mistakes", _mistakes(found, summaries), *(paragraph(
            f"“{name}” leads to {text} itself in every variant: it is left out.") for name, text in found.same), *(
            paragraph(f"“{name}” gives nothing in any variant, and is left out: {reason}.")
            for name, reason in found.unsolved))


def variant_table(problem: "Problem", report: "Report") -> Iterator[Section]:
    """All accepted variants."""
    found = report.wanted.variants
    if not found.accepted:
        return
    names = list(found.accepted[0].values)
    head: tuple[Any, ...] = ("no.", *(maths(Name(name)) for name in names), *(_named(key) for key in found.keys))
    yield from section("Accepted", TableBlock(head, tuple(
        (str(number), *(_printed(one.values[name].text) for name in names),
         *(key.written for key in one.keys))
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


def _printed(text: str) -> str:
    """A value or unit as it is set in print."""
    from vibcli.notation.as_printed import as_printed

    return as_printed(text)


def _named(key: Any) -> str:
    return cast("str", key.text + (f" [{_printed(key.unit)}]" if key.unit else ""))


def _gates(found: "SolvedVariants") -> TableBlock:
    rows = []
    for gate, count in found.counts.items():
        if gate in found.rules.without:
            rows.append((gate, "off", GATES[gate]))
        elif count or gate in GATES:
            rows.append((gate, str(count), GATES.get(gate, "there is such a scene, and it has such an answer")))
    return TableBlock(("gate", "rejected", "what it asks"), tuple(rows))


def _remarks(found: "SolvedVariants") -> Iterator[str]:
    if found.reread:
        yield f"{amount(found.reread, 'variant')} read anew from the printed values: the same keys."
    if found.closed:
        yield f"Closed forms give the same: {', '.join(f'{text} in {count}' for text, count in found.closed.items())}."


def _keys(found: "SolvedVariants", summaries: Sequence[Any]) -> TableBlock:
    rows = []
    for key, one in zip(found.keys, summaries, strict=True):
        first, texts = one.first, str(len(one.texts))
        if first.value is None:
            rows.append((key.text, "–", first.written, "", texts, first.figures, first.spread))
        else:
            rows.append((key.text, _printed(key.unit) or "–", one.low.written, one.high.written, texts,
                         " to ".join(map(str, dict.fromkeys(one.figures))), f"{plainly(100 * one.widest)} %"))
    return TableBlock(("quantity", "unit", "least", "largest", "distinct", "figures", "widest band"), tuple(rows))


def _mistakes(found: "SolvedVariants", summaries: Sequence[Any]) -> TableBlock | None:
    """Of each mistake and key, the variant in which they come nearest."""
    rows = []
    for key, summary in zip(found.keys, summaries, strict=True):
        is_number = summary.first.value is not None
        for name in (mistake.name for mistake in found.mistakes if mistake.name in summary.nearest):
            gap, one, wrong = summary.nearest[name]
            apart = "unequal" if not is_number else f"{plainly(100 * gap)} %" if gap < inf else "–"
            rows.append((gap if is_number else 1.0, (name, key.text, one.written, one.said(wrong), apart)))
    rows.sort(key=lambda row: row[0])
    head = ("mistake, nearest first", "quantity", "key", "mistaken", "apart")
    return TableBlock(head, tuple(row for _, row in rows)) if rows else None


def variants_data(found: "SolvedVariants") -> dict[str, Any]:
    """The variants with the keys of --json."""
    asked = [{"name": key.text, "unit": key.unit or None, "points": key.points} for key in found.keys]
    accepted = [{"given": _given_data(one), "keys": [_key_data(key) for key in one.keys]} for one in found.accepted]
    rejected = [{"given": _given_data(one), "gate": one.gate, "reason": one.reason} for one in found.rejected]
    same = [{"mistake": name, "name": text} for name, text in found.same]
    counts = [{"gate": gate, "rejected": count} for gate, count in found.counts.items()]
    nothing = [{"mistake": name, "reason": reason} for name, reason in found.unsolved]
    return KEY.row(len(accepted) + len(rejected), counts, list(found.rules.without), asked, accepted, rejected, same,
                   nothing,
                   found.reread, [{"name": text, "variants": count} for text, count in found.closed.items()])


def _given_data(one: Any) -> list[dict[str, Any]]:
    return [{"name": name, "value": value.text} for name, value in one.values.items()]


def _key_data(key: Any) -> dict[str, Any]:
    if key.value is None:
        wrong = [{"mistake": one.mistake, "value": None, "text": key.said(one.value)} for one in key.wrong]
        return {"value": None, "error": None, "text": key.written, "figures": key.band and key.band.figures,
                "band": key.band and key.band.width, "mistakes": wrong}
    wrong = [{"mistake": one.mistake, "value": one.value, "text": None} for one in key.wrong]
    return {"value": key.value, "error": key.error, "text": None, "figures": key.band.figures,
            "band": key.band.width, "mistakes": wrong}


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
            Key("value", "the key; null of an equation or expression"),
            Key("error", "an absolute bound of its error; null of these"),
            Key("text", "an equation or expression as text; null of a number"),
            Key("figures", "to how many it is asked; null of what is exact"),
            Key("band", "how far a right answer may lie from it, of coefficients relative; null of what is exact"),
            Key("mistakes", "what known mistakes give, a list", each=(
                Key("mistake", "its name"), Key("value", "what it gives; null of what is no number"),
                Key("text", "the equation or expression that it gives; null of a number"))))))),
    Key("rejected", "the other candidates, a list", each=(
        Key("given", "the values of parameters, a list", each=GIVEN), Key("gate", "the first that it failed"),
        Key("reason", "why"))),
    Key("same", "mistakes that lead to the key in every variant, a list", each=(
        Key("mistake", "its name"), Key("name", "the quantity"))),
    Key("unsolved", "mistakes that give nothing in any variant, a list", each=(
        Key("mistake", "its name"), Key("reason", "why, in the first of them"))),
    Key("reread", "how many were held against the scene read anew"),
    Key("closed", "quantities that have a closed form, which gives the same keys, a list", each=(
        Key("name", "the quantity"), Key("variants", "in how many candidates")))))
