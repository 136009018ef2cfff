"""Printing a scene file with its results as its answers."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vibcli.base.errors import PhysicsError
from vibcli.cli.common import known_mistake, show_refusal
from vibcli.cli.reports import write_text

if TYPE_CHECKING:
    from vibcli.api.answers import LeftOut
    from vibcli.cli.reports import Output
    from vibcli.reader.sections.answer import Answer
    from vibcli.results.problem import Problem


def print_answered(file: str, problems: "Sequence[tuple[str | None, Problem]]",
                   sections: "Callable[[Problem], Sequence[str]]", output: "Output", digits: int | None) -> int:
    """Print the text of a file, or write it, with what is found of the scene and its cases among their answers; what is
    left out is said on stderr. A case that cannot be solved is refused there: exit code 4."""
    from vibcli.api.answers import entries, with_answers

    found, left, refused = {}, [], False
    for case, problem in problems:
        try:
            spelled, beside = entries(problem, sections(problem), digits)
            found[case], differing = _agreeing(problem, spelled)
            left += [(case, one) for one in (*beside, *differing)]
        except PhysicsError as error:
            show_refusal(error, file + (f", case {case}" if case else ""))
            refused = True
    text = with_answers(Path(file).read_bytes().decode("utf-8-sig"), file, found)
    _tell(left)
    write_text(text.removesuffix("\n"), output)
    return 4 if refused else 0


def _agreeing(problem: "Problem",
              spelled: "dict[str, tuple[str, Answer]]") -> "tuple[dict[str, str], list[LeftOut]]":
    """({quantity: value} of those with which `check` agrees, the others as LeftOut)."""
    from vibcli.api.answers import LeftOut
    from vibcli.check.verdicts import verdicts_of

    found = verdicts_of(problem, [answer for _, answer in spelled.values()], mistake=partial(known_mistake, None))
    verdicts = dict(zip(spelled, found, strict=True))
    return {asked: value for asked, (value, _) in spelled.items() if verdicts[asked].agrees}, [
        LeftOut(asked, "check finds otherwise" + (f" ({one.remark})" if one.remark else ""))
        for asked, one in verdicts.items() if not one.agrees]


def _tell(left: "Sequence[tuple[str | None, LeftOut]]") -> None:
    """Say what is left out, of each reason once."""
    reasons: dict[str, list[str]] = {}
    for case, one in left:
        reasons.setdefault(one.reason, []).append((f"{case}: " if case else "") + one.asked)
    for reason, asked in reasons.items():
        click.echo(f"left out: {', '.join(asked)}: {reason}", err=True)
