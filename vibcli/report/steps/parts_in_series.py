"""What the parts of a spring or damper in series share and what adds up: F = F₁(d₁) = F₂(d₂) = …, d₁ + d₂ + … = Δ."""

import re
from typing import TYPE_CHECKING, cast

from vibcli.notation.as_printed import as_printed
from vibcli.notation.plain import plain
from vibcli.report.blocks import Words
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem


def tell_parts(problem: "Problem", sheet: WorkedSolution, owner: str) -> None:
    """The line of an element whose parts in series are written out; none of others."""
    spring = owner in (problem.spec.get("springs") or {})
    record = problem.spec.get("springs" if spring else "dampers")[owner]
    x = "d" if spring else "v"
    parts = [_force(part, x) for part in record.get("series", ()) if hasattr(part, "items")]
    if len(parts) < 2 or len(parts) < len(record["series"]) or None in parts:
        return
    shown = parts[:1] if len(set(parts)) == 1 else parts
    letters = [sheet.letter(f"{x}{i}") for i in range(1, len(shown) + 1)]
    names = {*problem.spec.parameters, *letters}
    forces = [as_printed(re.sub(rf"\b{x}\b", letter, part), names)
              for part, letter in zip(shown, letters, strict=True)]
    total = " + ".join(map(plain.symbol, letters)) if shown is parts else f"{len(parts)}·{plain.symbol(letters[0])}"
    whole, F = plain.symbol(sheet.letter(x)), plain.symbol(sheet.letter("F", owner))
    told, what = " = ".join([f"{F}({whole})", *forces]), "stretches" if spring else "speeds"
    sheet.write(Words(f"the parts of {owner} share its force and their {what} add up:  {told},  {whole} = {total}"),
                settles=f"parts of {owner}")


def _force(part: "Record", x: str) -> str | None:
    """F(x) of a part as it is typed; None of one that consists of parts, or is given by a table."""
    text = next((part[key].text for key in ("k", "c", "torsion") if hasattr(part.get(key), "text")), None)
    if text is not None:
        return f"({text})*{x}" if re.search(r"[+\-/ ]", text) else f"{text}*{x}"
    return cast("str | None", getattr(part.get("law"), "text", None))
