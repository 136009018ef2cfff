"""Tables of numbers by name and mode, which shares and sensitivities are told in."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import plainly
from vibcli.report.blocks import Paragraph, Section, TableBlock, paragraph, section

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

COLUMNS, ROWS = 8, 40       # of a table; the rest is in the JSON
NOTHING = 1e-9              # per cent


def grid(title: str, columns: Any, write: Callable[..., str], *told: Paragraph) -> tuple[Section, ...]:
    """A table of [(head, {name: number})], a row to each name, and what is told under it."""
    names = list(dict.fromkeys(name for _, column in columns for name in column))
    shown = columns[:COLUMNS]
    rows = [(name, *(write(column.get(name)) for _, column in shown)) for name in names[:ROWS]]
    left = [f"{len(columns) - COLUMNS} more modes"] * (len(columns) > COLUMNS)
    left += [f"{len(names) - ROWS} more rows"] * (len(names) > ROWS)
    return section(title, TableBlock(("", *(head for head, _ in shown)), tuple(rows)),
                   paragraph(f"… {' and '.join(left)}: see --json", hang=None) if left else None, *told) if rows else ()


def require_numbers(problem: "Problem", word: str) -> None:
    """Refuse a scene with symbols."""
    if problem.numeric.has_free_symbols:
        from vibcli.language.parameters import require_values

        require_values(problem.scene.parameters, f"`{word}`")


def without_end(title: str, word: str) -> tuple[Section, ...]:
    """That something is not told of members."""
    return section(title, paragraph(f"Not told: a member with distributed inertia has modes without end, and {word} "
                                    "are those of finitely many."))


def numbered(indices: Mapping[int, Any] | Sequence[int]) -> str:
    """The numbers of modes one after the other."""
    return ", ".join(map(str, indices))


def off(value: Any, exact: Any) -> str:
    """How far an estimate is off, in per cent."""
    found = 100 * (value / exact - 1)
    if abs(found) < NOTHING:
        return "0 %"
    return f"{'−' if found < 0 else '+'}{plainly(abs(found))} %"
