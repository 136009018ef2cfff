"""T, V, Φ and the loads of a scene in any motion, element by element, unexpanded."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.abbreviations import abbreviated
from vibcli.notation.plain import plain
from vibcli.report.blocks import Name, Words
from vibcli.report.sections.too_long import brief
from vibcli.report.steps.bodies import LONG, EnergyPart
from vibcli.report.steps.in_motion import InMotion, short_form
from vibcli.report.steps.parts_in_series import tell_parts
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.energy_terms import Term
    from vibcli.scene.laws import Law
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

GIVEN = {"T": ("kinetic energy", "M", "v"), "V": ("potential energy", "K", "q"), "Phi": ("dissipation function", "C",
                                                                                         "v")}


def potential_of_weights(scene: "Scene") -> "tuple[Node, Node]":
    """What of the potential of all weights moves, and its constant, which is not told."""
    table = scene.table
    terms = [table.total([term.weight * term.s for term in scene.weights if term.owner == name])
             for name in dict.fromkeys(term.owner for term in scene.weights)]
    whole = textbook(table.total(terms))
    parts = whole.args if whole.op == "sum" else ((whole, ONE),)
    moving = table.sum(*((part, c) for part, c in parts if part.mask))
    return moving, textbook(whole - moving)


class FullEnergies:
    """What stores and dissipates energy in any motion, told on a sheet; long lengths get a symbol of their own."""

    def __init__(self, motion: InMotion, sheet: WorkedSolution) -> None:
        self.motion, self.sheet, self.scene = motion, sheet, motion.scene
        self._letters = [term.owner for kind in ("springs", "laws", "weights") for term in getattr(self.scene, kind)]

    def short(self, *nodes: "Node") -> "list[Any]":
        """The expressions with symbols for long lengths, those that are new told before; words for what is too long to
        read."""
        shown, lengths = abbreviated(list(nodes), self.sheet.lengths)
        for symbol, length in lengths:
            self.sheet.write(symbol, " = ", brief(length), settles=symbol.name, node=length)
        return [brief(short_form(node) if letters(node) > LONG else node) for node in shown]

    def given(self, key: str) -> "Iterator[EnergyPart]":
        """What the file writes out of T, V or Φ, as energies or matrices."""
        table, scene = self.scene.table, self.scene
        what, matrix, symbols = GIVEN[key]
        x, rows = getattr(scene, symbols), scene.matrices.get(matrix, ())
        squares = table.total([rows[i][j] * x[i] * x[j] / 2 for i in range(len(rows)) for j in range(len(rows))])
        record = self.motion.problem.spec.get("energies") or {}
        energy = scene.lower(record[key]) if key in record else table.zero
        for node, words in ((energy, f"{what} as given"), (squares, f"{what} of the given matrix {matrix}")):
            if not node.is_zero:
                yield self._part(self.sheet.letter(key, "given"), textbook(node), Words(words + ":  "))

    def _part(self, letter: str, node: "Node", *head: Words, formula: "Sequence[Node]" = (),
              uses: Sequence[int] = ()) -> EnergyPart:
        """A line letter = formula = node."""
        shown, = self.short(node)
        told = [] if not formula or plain(formula[0]) == plain(node) else [*formula, " = "]
        line = self.sheet.write(*head, Name(letter), " = ", *told, shown, settles=letter, node=node, uses=uses)
        return EnergyPart(letter, node, line)

    def _letter(self, letter: str, owner: str) -> str:
        return self.sheet.letter(letter, owner if len(set(self._letters)) > 1 or self._several("V") else "")

    def _several(self, key: str) -> bool:
        return key in (self.motion.problem.spec.get("energies") or {}) or bool(self.scene.matrices)

    def stored(self) -> "Iterator[EnergyPart]":
        """V of each spring, and of all weights."""
        for term in self.scene.springs:
            yield self._spring(term)
        for law in self.scene.laws:
            if not law.damper:
                for symbol, record in self.scene.static_preloads:
                    if record.name == law.owner:
                        self._as_drawn(record, symbol.name, symbol)
                yield self._of_law(law, "Delta", "V", textbook(law.s), "stretch of")
        yield from self._weights()

    def _spring(self, term: "Term") -> EnergyPart:
        """½ k Δ² + N Δ."""
        letter = self._letter("V", term.owner)
        delta, uses = self._told(term, "Delta", textbook(term.s), "stretch of")
        N, s = self._tension(term), textbook(term.s)
        uses = [*uses, self.sheet.last] if N is not self._offset(term) else uses
        return self._part(letter, term.weight * s ** 2 / 2 + self._offset(term) * s, formula=[
            term.weight * delta ** 2 / 2 + N * delta], uses=uses)

    def _offset(self, term: Any) -> "Node":
        return self.scene.table.zero if term.offset is None else term.offset

    def _tension(self, term: Any) -> "Node":
        """What N is told as: a letter, which has a line, of a spring that holds the scene as drawn."""
        N = self._offset(term)
        record = (self.motion.problem.spec.get("springs") or {}).get(term.owner, {})
        if N.is_zero or record.get("preload") != "static":
            return N
        name = self._letter("N", term.owner)
        self._as_drawn(record, name, N)
        return self.motion.letter(name)

    def _as_drawn(self, record: "Record", name: str, N: "Node") -> None:
        """The line of the tension N of a spring that holds the scene as drawn."""
        balanced = self._balanced(record.name, N)
        value, unit = self.motion.value(balanced), "N·m" if "torsion" in record else "N"
        self.sheet.write(Words(f"tension of {record.name} as drawn, where the forces balance:  "), Name(name), " = ",
                         *((N, " = ") if balanced is not N and name != N.name else ()), self.short(balanced)[0],
                         *(() if value is None or balanced.is_zero else number(value, unit)), settles=name, node=N,
                         value=value, unit=unit)

    def _balanced(self, name: str, N: "Node") -> "Node":
        """What a static preload is where loops are open and it has a symbol alone; else N, what it is already."""
        if N.op != "symbol":
            return N
        return copied([self.motion.problem.system.preloads[name]], self.scene.table)[0]

    def _told(self, term: Any, letter: str, node: "Node", words: str) -> "tuple[Node, list[int]]":
        """(the letter of a stretch or speed, the lines that it follows from); a symbol itself needs no line."""
        if node.op == "symbol":
            return node, []
        name = self._letter(letter.removesuffix("'"), term.owner) + letter[-1] * letter.endswith("'")
        shown, = self.short(node)
        line = self.sheet.write(Words(f"{words} {term.owner}:  "), Name(name), " = ", shown, settles=name, node=node)
        return self.motion.letter(name), [line]

    def _of_law(self, law: "Law", letter: str, energy: str, s: "Node", words: str) -> EnergyPart:
        """The integral of the law at s."""
        tell_parts(self.motion.problem, self.sheet, law.owner)
        at, uses = self._told(law, letter, s, words)
        name = self._letter(energy, law.owner)
        formula, node = (substitute([law.integral], {law.x: x})[0] for x in (at, s))
        return self._part(name, node, Words(f"by the law of {law.owner}:  "), formula=[formula], uses=uses)

    def _weights(self) -> Iterator[EnergyPart]:
        moving, _ = potential_of_weights(self.scene)
        if moving.mask:
            yield self._part(self._letter("V", "g"), moving, Words("the weights, without constants:  "))

    def dissipated(self) -> "Iterator[EnergyPart]":
        """Φ of each damper."""
        laws = [law for law in self.scene.laws if law.damper]
        several = len({term.owner for term in self.scene.dampers} | {law.owner for law in laws}) > 1
        for term in self.scene.dampers:
            speed = textbook(self.scene.rate(term.s))
            u, uses = self._told(term, "u'", speed, "speed across")
            letter = self.sheet.letter("Phi", term.owner if several else "")
            yield self._part(letter, textbook(term.weight * speed ** 2 / 2), formula=[term.weight * u ** 2 / 2],
                             uses=uses)
        for law in laws:
            yield self._of_law(law, "u'", "Phi", textbook(self.scene.rate(law.s)), "speed across")

    def loads(self) -> "list[Node]":
        """Q of each coordinate, from δA = Σ F δs, told where there are loads."""
        from vibcli.mechanics.energies import generalised_force

        scene = self.scene
        if not scene.forces:
            return [scene.table.zero] * len(scene.q)
        owners = ", ".join(dict.fromkeys(term.owner for term in scene.forces))
        Q = [textbook(generalised_force(scene, i)) for i in range(len(scene.q))]
        shown = self.short(*Q)
        told: list[Any] = []
        for i, (node, exact) in enumerate(zip(shown, Q, strict=True)):
            if not exact.is_zero:
                letter = self.sheet.letter(f"Q{i + 1}" if len(Q) > 1 else "Q")
                told += [Words(",  " * bool(told)), Name(letter), " = ", node]
        if told:
            self.sheet.write(Words(f"virtual work of {owners}, δA = Σ F·δs = Σ Q·δq:  "), *told, settles="Q")
        return Q

    def sum(self, letter: str, parts: Sequence[EnergyPart], node: "Node") -> int | None:
        """T, V or Φ of all; nothing where one part is all of it."""
        if len(parts) < 2:
            return parts[0].line if parts else None
        names = [part for name in dict.fromkeys(part.letter for part in parts) for part in (" + ", Name(name))][1:]
        shown, = self.short(node)
        letter = self.sheet.letter(letter)
        whole = self.motion.agree([part.node for part in parts], [node])
        return self.sheet.write(Name(letter), " = ", *names, " = ", shown, *([] if whole else [" + const"]),
                                settles=letter, node=node, uses=[part.line for part in parts])
