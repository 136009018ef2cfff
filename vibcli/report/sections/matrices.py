"""M, C, G and K of the small oscillations as matrices."""

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure, width
from vibcli.notation.plain import plain
from vibcli.report.blocks import Heading, Name, Section, TableBlock, maths, section

if TYPE_CHECKING:
    from vibcli.mechanics.lagrange import EquationsOfMotion
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

WIDEST = 6          # coordinates of a scene whose matrices are told without being asked for
MOST = 16           # and of one whose matrices are written out at all
COLUMNS = 98
KINDS = ("M", "Mass"), ("C", "Damping"), ("G", "Gyroscopic"), ("K", "Stiffness")


def matrices(problem: "Problem", report: "Report") -> Iterator[Section]:
    names, asked = problem.scene.coordinates, "matrices" in (problem.spec.get("find") or ())
    if not asked and (problem.scene.pieces or not 2 <= len(names) <= WIDEST):
        return
    if len(names) > MOST:
        raise PhysicsError(f"matrices of {len(names)} coordinates are not printed", "see --json")
    if problem.scene.pieces:
        problem.symbolic.matrices  # noqa: B018, refused
    found = problem.symbolic.equations
    if found.refusal:
        if asked:
            raise found.refusal
        return
    letters = _tables(names, found, maths) if found.in_letters else []
    numbers = []
    if not problem.numeric.has_free_symbols:
        known: dict[str, Any] = dict(zip("MCGK", problem.configuration.told_matrices, strict=True))
        numbers = _tables(names, found._replace(**known), _number, ", in numbers (SI units)" if letters else "")
    if numbers and not all(_fits(block) for block in letters if isinstance(block, TableBlock)):
        letters = []
    yield from section(f"Matrices of {_equation(found)}", *letters, *numbers)


def _equation(found: "EquationsOfMotion") -> str:
    """M·q̈ + (C + G)·q̇ + K·q = Q, with the matrices that are there."""
    damping = " + ".join(letter for letter in "CG" if any(getattr(found, letter).values()))
    slowed = f"({damping})·q̇" if "+" in damping else f"{damping}·q̇" if damping else ""
    parts = ["M·q̈" if any(found.M.values()) else "", slowed, "K·q" if any(found.K.values()) else ""]
    return " + ".join(filter(None, parts)) + (" = Q" if found.drive else " = 0")


def _tables(names: Sequence[str], found: "EquationsOfMotion", write: Callable[..., Any],
            more: str = "") -> list[Heading | TableBlock]:
    blocks: list[Heading | TableBlock] = []
    for letter, kind in KINDS:
        entries = {pair: node for pair, node in getattr(found, letter).items() if node}
        rows = [(maths(Name(name)), *(write(entries[i, j]) if (i, j) in entries else "0" for j in range(len(names))))
                for i, name in enumerate(names)]
        if entries:
            blocks += [Heading(f"{kind} matrix {letter}{more}"),
                       TableBlock(("", *(maths(Name(name)) for name in names)), tuple(rows))]
    return blocks


def _number(value: float) -> str:
    return figure(value).replace("-", "−")


def _fits(table: TableBlock) -> bool:
    """Is a table of expressions no wider than a page?"""
    columns = zip(*(row[1:] for row in table.rows), strict=True)
    return sum(max(width(cell if isinstance(cell, str) else plain(*cell.parts)) for cell in column) + 2
               for column in columns) <= COLUMNS
