"""Letters that reports of members introduce, x the place along them, X a shape, β a wave number: each is another one
where a coordinate or parameter of the scene is printed like it."""

import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.free_letters import ARGUMENTS, BOTH, FREQUENCY, IMPEDANCES, STIFFNESSES, TURNS
from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.names import GREEK, NAMES, PLACES, factors_of, split_name
from vibcli.report.blocks import Equations, Factor, Maths, Name, SumOfTerms, Words
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import Node

if TYPE_CHECKING:
    from vibcli.report.blocks import Line
    from vibcli.report.steps.step import WorkedLine
    from vibcli.scene.scene import Scene

GREEK_POOL, SMALL, CAPITALS = "γλρχψτιυΓΛΔ", "wvyhbrag", "EIOΛΓΔΘΞ"
OTHERS = {**dict.fromkeys("βασφεζλδθ", GREEK_POOL), **dict.fromkeys("unlm", SMALL), **dict.fromkeys("DJSNQP", CAPITALS),
          "x": PLACES[1:], "X": "ΨΦΞΛF", "ω": [GREEK[one] for one in FREQUENCY[1:]], "t": "τs", "τ": "sh",
          "f": ["frequency"], "T": ["period"]}
ALONE, INDEXED = "xuφθλζβασεωXtτnDJSNlfT", "ωXmQPδθ"       # letters that stand without an index, and with one
INDEX = re.compile(r"_?(\d+|[ijk])")
KEPT = {GREEK.get(one, one) for one in (*ARGUMENTS, *FREQUENCY, *IMPEDANCES, *STIFFNESSES, *TURNS, *BOTH)}
OMEGA, BARE = "ω", re.compile("ω(?![₀-₉_])")
TOKEN = re.compile(r"([A-Za-z]+|[α-ωΑ-Ω])")
WORD = re.compile(r"(?<![^\W\d])x(?= = | counts|, counted)|(?<=an element d)x\b")     # within words: the place


class OwnLetters(NamedTuple):
    """The names of a scene, and {letter: the one for it} of those that are others beside these."""

    names: "set[str]"
    others: "dict[str, str]"

    @property
    def place(self) -> str:
        """That of the place along members."""
        return self.others.get("x", "x")

    def text(self, text: str) -> str:
        """A text of mathematics."""
        return TOKEN.sub(self._token, text) if self.others else text

    def _token(self, found: Any) -> str:
        word = found[0]
        return "d" + self.others.get(word[1], word[1]) if len(word) == 2 and word[0] == "d" else self.others.get(
            word, word)

    def words(self, text: str) -> str:
        """Words that speak of the place x."""
        return WORD.sub(self.place, text)

    def parts(self, parts: Sequence[Any]) -> tuple[Any, ...]:
        """Parts of a formula."""
        return tuple(map(self._part, parts)) if self.others else tuple(parts)

    def lines(self, lines: "Iterable[Line]") -> "list[Line]":
        """Lines, and what stands before each."""
        return [one._replace(parts=self.parts(one.parts), label=self.parts(one.label)) for one in lines]

    def step(self, line: "WorkedLine") -> "WorkedLine":
        """A line of the steps."""
        node, vanishes = (one if one is None else self.node(one) for one in (line.node, line.vanishes))
        name, power, exponent = line.settles.partition("^")
        other = self.others.get(GREEK.get(name, name))
        settles = self.text(name) if name.startswith("βL") else name if other is None else NAMES.get(other, other)
        return line._replace(parts=self.parts(line.parts), node=node, vanishes=vanishes,
                             letter=self.symbol(line.letter), settles=settles + power + exponent)

    def _part(self, part: Any) -> Any:
        if type(part) is str:
            return self.text(part)
        if isinstance(part, Words):
            return Words(self.words(part.text))
        if isinstance(part, Name):
            return Name(self.symbol(part.text))
        if isinstance(part, Factor):
            return Factor(self.node(part.node))
        return self.node(part) if isinstance(part, Node) else part

    def node(self, node: Node) -> Node:
        """An expression."""
        if not self.others:
            return node
        own = [one for one in reachable([node]) if one.op == "symbol"]
        return substitute([node], {one: node.table.parameter(name) for one in own
                                   if (name := self.symbol(one.name)) != one.name})[0]

    def symbol(self, name: str) -> str:
        """The name of a symbol, another one where the scene has it not."""
        if name.rstrip("'") in self.names or not name:
            return name
        if factors := factors_of(name):
            return "".join(self.others.get(one, one) for one in factors)
        letter, below, primes = split_name(name)
        other = self.others.get(GREEK.get(letter, letter))
        return name if other is None else NAMES.get(other, other) + below.rstrip("′") + primes


def own_letters(scene: "Scene") -> OwnLetters:
    """The letters for a scene."""
    names = {*scene.coordinates, *scene.parameters.nodes}
    parts = [split_name(part) for name in names for part in factors_of(name) or [name]]
    split = [(GREEK.get(letter, letter), below) for letter, below, _ in parts]
    taken, found = {letter for letter, _ in split}, {}
    shared = {letter for letter, below in split if letter in (INDEXED if below else ALONE)
              and (not below or INDEX.fullmatch(below))}
    for letter in filter(shared.__contains__, OTHERS):
        used = {*taken, *OTHERS, *found.values(), *(() if letter == "ω" else KEPT)}
        found[letter] = next((one for one in OTHERS[letter] if one not in used), letter)
    return OwnLetters(names, found)


def of_oscillators(scene: "Scene", blocks: "Iterable[Any]") -> list[Any]:
    """Blocks on natural frequencies of coordinates: ω_n for a ω without number where the scene has that, others for ζ,
    λ and δ."""
    own = own_letters(scene)
    letters = OwnLetters(own.names, {one: other for one, other in own.others.items() if one in "ζλδ"})
    if not letters.others and "omega" not in own.names:
        return list(blocks)
    natural = "omega_n" if "omega" in own.names else OMEGA

    def part(one: Any) -> Any:
        if type(one) is str:
            return letters.text(BARE.sub("ω_n", one) if natural != OMEGA else one)
        if isinstance(one, Node):
            table = one.table
            return letters.node(substitute([one], {table.variable(OMEGA): table.parameter(natural)})[0])
        if isinstance(one, SumOfTerms):
            return SumOfTerms(tuple(map(part, one.nodes)))
        return Factor(part(one.node)) if isinstance(one, Factor) else one

    def block(one: Any) -> Any:
        if isinstance(one, Equations):
            return Equations(tuple(line._replace(parts=tuple(map(part, line.parts))) for line in one.lines))
        return one._replace(parts=tuple(Maths(tuple(map(part, each.parts))) if isinstance(each, Maths) else (
            part(each) if "ω" in each else each) for each in one.parts))

    return [block(one) for one in blocks if one]
