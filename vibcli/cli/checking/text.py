"""What was checked, as people read it: in full, file by file, or a line for each thing that is wrong."""

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

import click

from vibcli.base.diagnostics import escaped
from vibcli.base.enumeration import amount
from vibcli.base.rules import DIFFERS, INVALID, UNCERTAIN, UNSOLVED
from vibcli.cli.checking.found import CheckedAnswer, CheckedFile, findings
from vibcli.cli.common import show_diagnostics, show_fault

if TYPE_CHECKING:
    from vibcli.base.errors import Where


def is_told(found: CheckedFile, quiet: bool) -> bool:
    """Is anything printed of a file?"""
    return not quiet or bool(found.failures or found.troubles)


def tell_troubles(found: CheckedFile) -> None:
    """What keeps a file or answers of it from being checked, on stderr."""
    if found.fault:
        click.echo(f"{escaped(found.file)}:", err=True)
        show_fault(found.fault)
    invalid = [one for one in found.troubles if one.rule == INVALID]
    for together in (invalid, *([one] for one in found.troubles if one.rule != INVALID)):
        sources = {one.place: one.source for one in together}
        show_diagnostics([one.diagnostic for one in together], partial(_only, sources))


def _only(sources: dict[tuple[str, int, int, int] | None, str | None], where: "Where") -> Sequence[str]:
    """Lines of which that of a place alone is known."""
    source = sources.get((where.file, where.line, where.column, where.width))
    return () if source is None else [*[""] * (where.line - 1), source]


def tell_in_full(found: CheckedFile, quiet: bool) -> None:
    """The answers of a file on stdout, each with its mark; `quiet`: those alone that do not agree."""
    shown = [one for one in found.answers if not (quiet and not one.rule)]
    if not shown and quiet:
        return
    click.echo(escaped(found.file) + ("" if found.answers else "  (not checked)" if found.failed else "  (no answers)"))
    for one in shown:
        click.echo(f"  {_mark(one)} {_told(one)}")


def _told(one: CheckedAnswer) -> str:
    estimate = "  (its error is estimated)" if one.estimated else ""
    if not one.rule:
        return one.name + estimate
    return f"{one.name}: {one.said}{estimate}  [line {one.place[0]}]"


def _mark(one: CheckedAnswer) -> str:
    shown, color = ("✓", "green") if not one.rule else ("?", "yellow") if one.rule == UNCERTAIN else ("✗", "red")
    return click.style(shown, fg=color)


def tell_in_short(found: CheckedFile) -> None:
    """A line for each thing that is wrong: file:line:column: rule: message."""
    for one in findings(found):
        place = f":{one.line}:{one.column}" if one.column else ""
        click.echo(f"{escaped(one.file)}{place}: {one.rule}: {escaped(one.message)}")


def summary(found: Sequence[CheckedFile]) -> str:
    """How many answers agree, and what does not."""
    rules = [answer.rule for one in found for answer in one.answers]
    agree, differ, uncertain, unsolved = map(rules.count, ("", DIFFERS, UNCERTAIN, UNSOLVED))
    failed = sum(one.failed and not one.answers for one in found)
    parts = [f"{amount(agree, 'answer')} agree" + "s" * (agree == 1)]
    if differ:
        parts.append(f"{differ} differ" + "s" * (differ == 1))
    if uncertain:
        parts.append(f"{uncertain} {'is' if uncertain == 1 else 'are'} uncertain")
    if unsolved:
        parts.append(f"{unsolved} cannot be found")
    kept = sum(one.cached for one in found)
    return f"{', '.join(parts)} in {amount(len(found), 'file')}{_failed(failed, len(found))}" + (
        f", {kept} of {len(found)} from the cache" if kept else "")


def _failed(count: int, of: int) -> str:
    if not count:
        return ""
    which = "which" if of == 1 else "none of which" if count == of else f"{count} of which"
    return f", {which} could {'' if count == of > 1 else 'not '}be checked"
