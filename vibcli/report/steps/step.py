"""Steps, and the sheet on which they are written down one after the other."""

import re
from collections.abc import Sequence
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.as_printed import as_printed
from vibcli.notation.names import GREEK, split_name
from vibcli.notation.numbers import with_minus
from vibcli.notation.units_in_sums import unit_beside
from vibcli.quantities.dimensions import unit_of
from vibcli.report.blocks import Name, Words
from vibcli.symbolic.syntax import Call, Product, QuantityRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.report.steps.complex_nodes import LetteredStiffness
    from vibcli.report.steps.free_waves import ToldMotion
    from vibcli.report.steps.motion_by_pieces import MotionByModes, MotionByPieces
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef

MARKED = "′", "′′", "′′′"
MATRICES = {"M": "DHN", "C": "BRW", "G": "YXU", "K": "SEZ", "P": "LJQ", "Z": "AOV"}   # where the scene has these
ENTRY = re.compile(r"\d\d")      # indices of an entry of a matrix


class WorkedLine(NamedTuple):
    """What a numbered line tells; what is joined to it has the same number. settles: the quantity or letter that it
    tells, '' of words alone; uses: numbers of the lines that it follows from; parts: what it says, as mathematics;
    node: the expression that it settles, None of words and of what a search found; value: that in SI units, None in
    letters; unit: of the value; letter: the name of the symbol that stands for it in later lines, where that is not
    what it settles; vanishes: of what a search found a function of the letter, and of those of lines before it and
    joined to it, that is zero there, None where it is not known; aside: later lines that follow from the numbered line
    do not follow from this, but where its letter stands in them."""

    number: int
    settles: str
    uses: tuple[int, ...]
    parts: tuple[Any, ...]
    node: Any = None
    value: float | None = None
    unit: str = ""
    letter: str = ""
    vanishes: Any = None
    aside: bool = False


class WorkedSolution:
    """Steps that are written down; `taken`: the names of the scene, which new letters never meet."""

    def __init__(self, taken: Sequence[str]) -> None:
        self.steps: list[WorkedLine] = []
        self._taken = set(map(_printed, taken))
        self._letters: dict[str, str] = {}
        self._beside: WorkedLine | None = None
        self.drawn: dict[Problem, tuple[Any, ...]] = {}       # scenes in numbers that were drawn of one in letters
        self.waves: dict[str, ToldMotion] = {}      # of coordinates that move freely by the letters of lines
        self.in_numbers: dict[str, float] = {}      # of letters in whose place lines have the number
        self.responses: dict[Node, LetteredStiffness] = {}      # of K − Ω²M + iΩC by Ω
        self.lengths: dict[Node, Node] = {}         # the letters of long roots and of turns, by what they stand for
        self.turns: dict[Node, Node] = {}
        self.frequencies: dict[Node, Node] = {}     # the letters of those in numbers, at which something is asked
        self.by_pieces: dict[str, MotionByPieces | MotionByModes] = {}      # of coordinates under pieces of loads

    @property
    def last(self) -> int:
        """The number of the last line."""
        return self.steps[-1].number if self.steps else 0

    def letter(self, wanted: str, of: str = "") -> str:
        """The name of a new letter, with that of the element that it belongs to, primed where the scene has it."""
        key = f"{wanted} {of}"
        if key not in self._letters:
            base = f"{wanted}_{of}" if of else wanted
            self._letters[key] = self._free((base, *(base + mark for mark in MARKED)))
        return self._letters[key]

    def matrix(self, wanted: str) -> str:
        """The letter of a matrix, which has indices instead of marks."""
        key = f"matrix {wanted}"
        if key not in self._letters:
            of_entries = {letter for letter, below in self._taken if ENTRY.fullmatch(below)}
            self._letters[key] = self._free([name for name in (wanted, *MATRICES[wanted]) if name not in of_entries]
                                            + [wanted + mark for mark in MARKED])
        return self._letters[key]

    def _free(self, names: Sequence[str]) -> str:
        found = next(name for name in names if _printed(name) not in self._taken)
        self._taken.add(_printed(found))
        return found

    def write(self, *parts: Any, settles: str = "", uses: Sequence[int | None] = (), node: "Node | None" = None,
              value: float | None = None, unit: str = "", joined: bool = False, letter: str = "",
              vanishes: "Node | None" = None, opens: bool = False, aside: bool = False) -> int:
        """Write a line, or what is `joined` to the last one, and give its number; `opens`: the next one is joined to
        it."""
        number = self.last if joined or self.opened else self.last + 1
        known = tuple(sorted({use for use in uses if use and use < number}))
        self.steps.append(WorkedLine(number, settles, known, parts, node, value, unit, letter, vanishes, aside))
        self._beside = self.steps[-1] if opens else None
        return number

    def settles_too(self, line: WorkedLine, settles: str, node: "Node", value: float | None, unit: str) -> None:
        """Let a line settle another quantity that it tells as well."""
        found = WorkedLine(line.number, settles, line.uses, (), node, value, unit)
        self.steps.insert(self.steps.index(line) + 1, found)

    def join_next(self, joined: bool) -> None:
        """Let the next line be joined to the last one, or not."""
        self._beside = self.steps[-1] if joined and self.steps else None

    @property
    def opened(self) -> bool:
        """Will the next line be joined to the last one?"""
        return bool(self.steps) and self.steps[-1] is self._beside


def _printed(name: str) -> tuple[str, str]:
    """(letter, index) as a name is printed: a_1 as a1."""
    letter, below, primes = split_name(name)
    return GREEK.get(letter, letter) + primes, below.removeprefix("_")


def indexed(name: str, index: int) -> str:
    """A letter with an index, before its marks: Q1′ of Q′."""
    bare = name.rstrip("′")
    return f"{bare}{index}{name[len(bare):]}"


def momentum(sheet: WorkedSolution, name: str, p: Any, change: Any, slope: Any) -> tuple[Any, ...]:
    """Parts of ∂T/∂q̇ = p,  d/dt ∂T/∂q̇ = its rate,  ∂T/∂q = slope."""
    of_speed = slope_by(sheet, "T", name + "'")
    return (*of_speed, " = ", p, Words(",  "), "d/dt ", *of_speed, " = ", change, Words(",  "),
            *slope_by(sheet, "T", name), " = ", slope)


def slope_by(sheet: WorkedSolution, letter: str, name: str) -> tuple[str, Name, str, Name]:
    """Parts of ∂V/∂q of the letter of an energy."""
    return ("∂", Name(sheet.letter(letter)), "/∂", Name(name))


def number(value: float, unit: str = "") -> tuple[str | Words, ...]:
    """Parts of ` = value unit`."""
    return (" = " + told(value), *([Words(f" {unit}")] if unit else []))


def of_time(sheet: WorkedSolution, omega: float) -> list[Name | str | Words]:
    """Parts of `,  f = …,  T = …` of an angular frequency."""
    return [Words(",  "), Name(sheet.letter("f")), *number(omega / tau, "Hz"), Words(",  "), Name(sheet.letter("T")),
            *number(tau / omega, "s")]


def told(value: float) -> str:
    """A number as mathematics."""
    return with_minus(value)


def place_told(*place: "Node") -> "list[Node | str]":
    """Parts of (x, y); a number beside letters that does not tell its unit, or alone, is in metres."""
    parts: list[Any] = []
    for node in place:
        fixed = node.coefficient if node.op in ("sum", "number") else 0
        parts.append(", " if parts else "(")
        known = node.table.dimension is None or not node.table.hidden or (node.op == "sum" and unit_beside(node))
        if not fixed or known:
            parts.append(node)
            continue
        sign = "−" if fixed < 0 else ""
        head = [node - node.table.number(fixed), f" {sign or '+'} "] if node.op == "sum" else [sign]
        parts += [*head, told(abs(float(fixed))), Words("\u00a0m")]
    return [*parts, ")"]


def unit_told(spec: "Spec", asked: "Expression") -> str:
    """The unit of what is asked, in SI units; '' of a pure number, as what is divided is."""
    unit = as_printed(unit_of(spec, asked))
    return "" if unit == "1" or (unit == "rad" and _divides(asked.tree)) else unit


def _divides(tree: "NameRef | QuantityRef") -> bool:
    """Is it a quotient, or read off one?"""
    if isinstance(tree, Product):
        return any(power < 0 for power, _ in tree.parts)
    return isinstance(tree, (Call, QuantityRef)) and any(_divides(arg) for arg in tree.args[:1])
