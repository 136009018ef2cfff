"""Tables of numbers by name and mode, which shares and sensitivities are told in."""

from vibcli.language.parameters import require_values
from vibcli.report.blocks import TableBlock, paragraph, section

COLUMNS, ROWS = 8, 40       # of a table; the rest is in the JSON
NOTHING = 1e-9              # per cent


def grid(title, columns, write, *told):
    """A table of [(head, {name: number})], a row to each name, and what is told under it."""
    names = list(dict.fromkeys(name for _, column in columns for name in column))
    shown = columns[:COLUMNS]
    rows = [(name, *(write(column.get(name)) for _, column in shown)) for name in names[:ROWS]]
    left = [f"{len(columns) - COLUMNS} more modes"] * (len(columns) > COLUMNS)
    left += [f"{len(names) - ROWS} more rows"] * (len(names) > ROWS)
    return section(title, TableBlock(("", *(head for head, _ in shown)), tuple(rows)),
                   paragraph(f"… {' and '.join(left)}: see --json", hang=None) if left else None, *told) if rows else ()


def require_numbers(problem, word):
    """Refuse a scene with symbols."""
    if problem.numeric.has_free_symbols:
        require_values(problem.scene.parameters, f"`{word}`")


def numbered(indices):
    """The numbers of modes one after the other."""
    return ", ".join(map(str, indices))
