"""What the elements of a scene contribute: bodies, points and the terms of the energies."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.elements.member import Member
    from vibcli.elements.member_loads import SpreadLoad
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record
    from vibcli.scene.energy_terms import AppliedLoad, Damper, Inertia, Spring, Weight
    from vibcli.scene.laws import Law
    from vibcli.scene.piece_terms import PieceTerm
    from vibcli.scene.spread_forces import SpreadForce
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

TERMS = ("inertias", "springs", "dampers", "weights", "forces", "laws", "constraints", "pieces", "spread_forces",
         "inner_stretches")


class Constraint(NamedTuple):
    """One condition node = 0 of the constraint `name` (a part of it: `name.x`); `form` is one of
    equation, join, link, point, gear, belt, rope, contact, release."""

    name: str
    node: "Node"
    where: "Where"
    form: str

    @property
    def nodes(self) -> "list[Node]":
        """The expressions of the coordinates that it is made of."""
        return [self.node]

    def over(self, new: "Mapping[Node, Node]") -> "Constraint":
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(node=new[self.node])

    @property
    def whole(self) -> str:
        """The name of the constraint that this is a part of."""
        return self.name.partition(".")[0]

    @property
    def signal(self) -> str:
        """What its force is called: hoist.force, knee.force.x of a join, hoist.force.1 of a rope in several pieces; of
        a contact its name."""
        name, dot, part = self.name.partition(".")
        return self.name if self.form == "contact" else f"{name}.force{dot}{part}"


class InnerStretch(NamedTuple):
    """The stretch of a part of the spring `owner`, at `path`: 2, or 3.1 of nested parts."""

    owner: str
    path: str
    s: "Node"

    @property
    def nodes(self) -> "list[Node]":
        """The expressions of the coordinates that it is made of."""
        return [self.s]

    def over(self, new: "Mapping[Node, Node]") -> "InnerStretch":
        """Itself with its stretch replaced, {node: node}."""
        return self._replace(s=new[self.s])


class Contents(NamedTuple):
    """`points`: {name: (drawn, present)}; `spread_loads`: SpreadLoads along members; `energies`: T, V and Φ that
    are written out, and the laws once they are settled; `static_preloads`: [(symbol, record)] of unknown
    tensions; `shaken`: {kind: terms} as functions of the symbols of driven displacements, empty where nothing is
    driven; `fractions`: {part of a fraction that stands for a function where numbers are formed: how that is written,
    so that the fraction is the function}."""

    gravity: "tuple[Node, Node] | None"
    bodies: "dict[str, Body]"
    points: "dict[str, tuple[tuple[Node, Node], tuple[Node, Node]]]"
    members: "dict[str, Member]"
    spread_loads: "list[SpreadLoad]"
    inertias: "list[Inertia]"
    springs: "list[Spring]"
    dampers: "list[Damper]"
    weights: "list[Weight]"
    forces: "list[AppliedLoad]"
    laws: "list[Law]"
    constraints: list[Constraint]
    pieces: "list[PieceTerm]"
    spread_forces: "list[SpreadForce]"
    inner_stretches: list[InnerStretch]
    energies: "dict[str, Node]"
    matrices: "dict[str, list[list[Node]]]"
    static_preloads: "list[tuple[Node, Record]]"
    shaken: dict[str, list[Any]]
    fractions: "dict[Node, Node]"

    @classmethod
    def empty(cls, table: "Table") -> "Contents":
        """Contents to which elements may add."""
        energies = {"T": table.zero, "V": table.zero, "Phi": table.zero}
        return cls(None, {}, {}, {}, [], *([] for _ in TERMS), energies, {}, [], {}, {})  # type: ignore[arg-type]

    @property
    def nodes(self) -> "list[Node]":
        """All expressions of the coordinates in it."""
        kinds = [*(getattr(self, kind) for kind in TERMS), *self.shaken.values(), self.bodies.values(),
                 self.members.values()]
        places = [node for _, place in self.points.values() for node in place]
        return [*(node for kind in kinds for part in kind for node in part.nodes), *places, *self.energies.values()]

    @property
    def depends_on(self) -> "list[Node]":
        """Those of what moves, stores, damps and loads, with the factors, and of the energies."""
        kinds = (self.inertias, self.springs, self.dampers, self.weights, self.forces, self.pieces, self.spread_forces)
        return [*(node for kind in kinds for term in kind for node in term.nodes), *self.energies.values()]

    def over(self, new: "Mapping[Node, Node]") -> "Contents":
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(
            **{kind: [term.over(new) for term in getattr(self, kind)] for kind in TERMS},  # type: ignore[arg-type]
            shaken={kind: [term.over(new) for term in terms] for kind, terms in self.shaken.items()},
            bodies={name: body.over(new) for name, body in self.bodies.items()},
            members={name: member.over(new) for name, member in self.members.items()},
            points={name: (drawn, (new[x], new[y])) for name, (drawn, (x, y)) in self.points.items()},
            energies={key: new[node] for key, node in self.energies.items()})
