"""Forces in constraints that close loops, in small motion: each is the multiplier of its condition, by as many
equations of the coordinates, those cut free, as there are conditions, to the first order from rest,

    M̃ S q̈ + C̃ S q̇ + (K̃ + Σ λ⁰ₖ ∂²gₖ/∂q∂q) S q + Gᵀλ = F,   λ⁰ at rest,

S how the coordinates move with those that are independent."""

from typing import TYPE_CHECKING, Any

from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING
from vibcli.mechanics.static_preload import pivots, solve_linear
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.multipliers import READABLE
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node


class CutFree:
    """The equations of a scene cut free at its loops, linear about rest. G: the slopes of its conditions there; steady,
    moving: what else the equations have, at rest and beside that, with letters for the multipliers at rest."""

    def __init__(self, about: AboutRest) -> None:
        problem = about.problem
        self.about, self.scene, found = about, problem.system.scene_with_multipliers, problem.symbolic.equations
        self.symbols, table = list(found.multipliers), self.scene.table
        self.zero = table.zero
        place, moves = self._place()
        loaded = {symbol: problem.system.preloads[record.name] for symbol, record in self.scene.static_preloads}
        tensions = dict(zip(loaded, copied(list(loaded.values()), table), strict=True))
        self._still = {**place, **tensions, **dict.fromkeys((*self.scene.v, *self.scene.a), self.zero)}
        columns, none = [gradient(row) for row in found.full], dict.fromkeys(self.symbols, self.zero)
        self.G = self._at_rest([[row.get(symbol, self.zero) for symbol in self.symbols] for row in columns])
        loads = substitute(list(found.full), {**self._still, **none})
        timed = [self.scene.terms_with(node, self.scene.time.mask) for node in loads]
        self.steady = [textbook(node - part) for node, part in zip(loads, timed, strict=True)]
        slopes = [self._at_rest([[row.get(x, self.zero) for x in of] for row in columns])
                  for of in (self.scene.q, self.scene.v, self.scene.a)]
        self.moving = [table.total([part, *(row[j] * moves[order][j] for order, matrix in enumerate(slopes)
                                            for row in [matrix[i]] for j in range(len(row)))])
                       for i, part in enumerate(timed)]

    def _place(self) -> "tuple[dict[Node, Node], list[list[Node]]]":
        """({q: its value at rest}, [what each q, q̇ and q̈ is, to the first order by the independent ones])."""
        about, scene, found = self.about, self.scene, {}
        moves = [[], [], []]
        for name in scene.coordinates:
            own = about.scene.coordinates.index(name) if name in about.scene.coordinates else None
            small = None if own is not None else about.small(about.scene.dependent[name])
            node = about.place[about.scene.q[own]] if small is None else small.at_rest
            slopes = {own: about.table.one} if small is None else small.slopes
            (found[scene.symbol(name)],), parts = copied([node], scene.table), dict(zip(slopes, copied(
                list(slopes.values()), scene.table), strict=True))
            for order, of in enumerate((about.scene.q, about.scene.v, about.scene.a)):
                moves[order].append(scene.table.total([a * scene.table.variable(of[m].name) for m, a in parts.items()]))
        return found, moves

    def _at_rest(self, rows: "Sequence[Sequence[Any]]") -> list[list[Any]]:
        flat = substitute([node for row in rows for node in row], self._still)
        width = len(rows[0])
        return [list(map(textbook, flat[i:i + width])) for i in range(0, len(flat), width)]

    def rows(self) -> "list[int]":
        """Equations that fix the multipliers, in the order of these; none where there are not as many."""
        values = dict.fromkeys((symbol.name for symbol in self.symbols), 0.0)
        sizes = [evaluate(row, Floats, {**self.about.samples[0], **values}) for row in self.G]
        found, picked = pivots(sizes)
        return [row for _, row in sorted(zip(picked, found, strict=True))] if len(picked) == len(self.symbols) else []

    def solved(self, rows: "Sequence[int]") -> "tuple[list[Node], list[Node]]":
        """(the equations in letters for all multipliers, what these are)."""
        def by(parts: "Sequence[Node]") -> "list[Node]":
            found = solve_linear([[*self.G[i], -part] for i, part in zip(rows, parts, strict=True)], self.zero)
            return [self.about.tidy(node) if not node.mask else textbook(node) for node in found]

        at_rest = dict(zip(self.symbols, by([self.steady[i] for i in rows]), strict=True))
        whole = [textbook(self.steady[i] + substitute([self.moving[i]], at_rest)[0]) for i in rows]
        tied = [textbook(self.scene.table.total([part, *(g * symbol for g, symbol in zip(
            self.G[i], self.symbols, strict=True))])) for i, part in zip(rows, whole, strict=True)]
        return tied, by(whole)


def tell_first_order_multipliers(about: AboutRest, sheet: WorkedSolution) -> None:
    """The forces in closed loops that the scene asks for along its small motion; nothing where there are none."""
    problem = about.problem
    text = " ".join(answer.asked.text for answer in problem.spec.answers if getattr(answer.asked.tree, "args", ()))
    loose, equations = problem.system.scene_with_multipliers, problem.symbolic.equations
    ties = list(zip(equations.multipliers, loose.constraints, strict=False))
    if not equations.full or not any(tie.signal in text for _, tie in ties):
        return
    cut = CutFree(about)
    rows = cut.rows()
    if not rows:
        return
    tied, values = cut.solved(rows)
    if max(map(letters, values)) > READABLE:
        return
    told = [part for symbol, tie in ties for part in (Words(",  "), symbol, Words(f" for '{tie.name}'"))][1:]
    line = sheet.write(Words("cut free, each condition acts by its slope times a multiplier:  "), *told,
                       settles="cut free")
    for k, (i, node) in enumerate(zip(rows, tied, strict=True)):
        name = loose.coordinates[i]
        sheet.write(Words("along  " if k else "to the first order along  "), Name(name), Words(":  "), node, " = 0",
                    settles=f"balance[{name}]", node=node, uses=[line], joined=k > 0)
    balances, first = sheet.last, True
    for (symbol, tie), value in zip(ties, values, strict=True):
        if tie.signal in text:
            sign = symbol if tie.form in LENGTHENING else -symbol
            node = textbook(value if tie.form in LENGTHENING else -value)
            node = min((node, single(node)), key=letters)
            sheet.write(Words("so  " * first + tie.signal), " = ", sign, " = ", node, settles=tie.signal, node=node,
                        uses=[balances], joined=not first)
            first = False
