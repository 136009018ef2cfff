"""The scene while it is built: the services by which elements make their functions of the coordinates, and to which
they contribute."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.elements import ELEMENTS
from vibcli.language.named_elements import load
from vibcli.language.parameter_samples import sample_values
from vibcli.language.parameters import Parameters
from vibcli.language.reader import Expression, Record, Reference
from vibcli.scene.build_order import carriers_first
from vibcli.scene.contents import Constraint, Contents, InnerStretch
from vibcli.scene.coordinates import SceneCoordinates
from vibcli.scene.displacements import Displacements, stays_bounded
from vibcli.scene.energy_terms import AppliedLoad, Damper, Inerter, Inertia, RestingLoad, Spring, Weight
from vibcli.scene.expressions import Expressions
from vibcli.scene.places import Frame, Places
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats
from vibcli.symbolic.expression import Table
from vibcli.symbolic.node import ALL_PURE, UNITS

if TYPE_CHECKING:
    from fractions import Fraction
    from typing import TypeVar

    from vibcli.elements.rigid_body import Body
    from vibcli.language.spec import Spec
    from vibcli.scene.build import Variant
    from vibcli.scene.member_tensions import Tensions
    from vibcli.symbolic.node import Node

    T = TypeVar("T")

FIRST = (None, "points", "surfaces", "bodies")       # built by what refers to them, or before all others
SIZES = (1, 0.1, 0.01, 10)  # of what is chosen beside the numbers of a scene


class Builder:
    """A scene that is built: elements see it as `scene`. `owner`: the name of the element that contributes."""

    owner: str

    def __init__(self, spec: "Spec", given: "Mapping[str, Fraction]", attempt: int, variant: "Variant",
                 tensions: "Mapping[str, Tensions]",
                 watched: "Callable[[dict[str, float]], dict[str, float]] | None" = None) -> None:
        self.tensions = tensions
        self.spec, self.variant, self.owner, self.reports, self.idle = spec, variant, None, Reports(), False
        records = spec.sections.get("records") or {}
        self.table = table = Table({name: record["samples"] for name, record in records.items()},
                                   dimension=None if spec.free_numbers else spec.dimensions.of,
                                   hidden=ALL_PURE if UNITS["m"] in spec.parameters else set())
        self.parameters = Parameters(spec, table, given=given)
        self.sample = self.parameters.values(Floats, _samples(spec, self.parameters.free, given, attempt))
        if watched:
            self.sample = watched(self.sample)
        table.resample(self.sample)
        self.time = table.time_variable("the time" if "t" in spec.parameters or "t" in spec.coordinates else "t")
        self.coordinates = SceneCoordinates.named(spec.coordinates, self.time)
        self.expressions = Expressions(self.coordinates, self.parameters, self.sample, self.reports)
        self.coordinates.draw([self.expressions.lower(record["drawn"]) if "drawn" in record else table.zero
                               for record in spec.coordinates.values()])
        self.contents, self.displacements = Contents.empty(table), Displacements(self.expressions, variant)
        self._offer(self.expressions, self.displacements, Places(
            spec, self.expressions, self.contents.bodies, self.contents.points, self.contents.members,
            lambda record, drawn: load("point").driven(record, drawn, self),
            lambda name: load("member").built(name, self)))

    def _offer(self, expressions: Expressions, displacements: Displacements, places: Places) -> None:
        """The services of expressions, of what is driven, and of bodies and points."""
        self.report, self.diagnostics = self.reports.report, self.reports.diagnostics
        self.lower, self.pair, self.load = expressions.lower, expressions.pair, expressions.load
        self.positive, self.number, self.sign = expressions.positive, expressions.number, expressions.sign
        self.agree, self.vanishes = expressions.agree, expressions.vanishes
        self.require_equal, self.terms_with = expressions.require_equal, expressions.terms_with
        self.unit, self.distance, self.absolute = expressions.unit, expressions.distance, expressions.absolute
        self.height_of, self.figures = expressions.height_of, expressions.figures
        self.symbol, self.at_drawn = self.coordinates.symbol, self.coordinates.at_drawn
        self.v, self.a = self.coordinates.v, self.coordinates.a
        self.driven_by, self.turns = displacements.driven_by, displacements.turns
        self.released = displacements.released
        self.members = self.contents.members
        self.bodies, self.surfaces, self.ground = places.bodies, self.spec.sections.get("surfaces") or {}, places.ground
        self.frame, self.carrier, self.new_frame, self.still = places.frame, places.carrier, Frame, places.still
        self.rim, self.place, self.place_of, self.pivot = places.rim, places.place, places.place_of, places.pivot
        self.extent, self.along_axis = places.extent, places.along_axis

    def change(self, expression: Expression, part: str = "") -> "Node":
        """A displacement of the body that is built."""
        return self.displacements.change(expression, self.owner, part)

    def supported(self, body: "Body") -> "Body":
        """A body that moves; where supports give way, with that of its own."""
        if not self.variant.released or "weld" in body.record:
            return body
        return body._replace(frame=self.displacements.release(body))

    @property
    def supports(self) -> "list[Node]":
        """The coordinates by which supports give way, drives apart."""
        return [q for q in self.released if ".reaction." in q.name]

    def add_elements(self) -> None:
        """Build the bodies, carriers first, then what connects them."""
        sections, bodies = self.spec.sections, self.bodies
        if "gravity" in sections:
            field = sections["gravity"]
            gravity = self.pair(field) if isinstance(field, list) else (self.table.zero, -self.lower(field))
            self.contents = self.contents._replace(gravity=gravity)
        for name in carriers_first(self.spec, self.report):
            self.owner = name
            bodies[name] = load("body").build(sections["bodies"][name], self)
        if self.diagnostics:
            return
        for name, (section, _) in ELEMENTS.items():
            if section in sections and section not in FIRST:
                self._add_section(name, section)
        along = {name: record for name, record in (sections.get("member_points") or {}).items()
                 if "from" in self.members[record["body"].text].record}
        for name, record in {**(sections.get("points") or {}), **along}.items():
            if "moves" in record or name in along:
                self.place(Reference(name, record.where))

    def _add_section(self, name: str, section: str) -> None:
        """The element of a section, or its elements by name, without the force that lets go."""
        found = self.spec.sections[section]
        if name == section:
            load(name).build(found, self)
            return
        left_out = self.spec.let_go if section == "forces" and not self.variant.preloaded else None
        for record in found.values():
            self.owner = record.name
            try:
                if record.name != left_out:
                    load(name).build(record, self)
            except ZeroDivisionError:
                self.report(record.where, f"'{record.name}' divides by zero as drawn", "draw its ends apart")

    def add_inertia(self, weight: "Node", s: "Node") -> None:
        """½·weight·ṡ² to T; nothing where s does not move or the weight is zero."""
        if s.mask and not weight.is_zero:
            self.contents.inertias.append(Inertia(weight, s, owner=self.owner))

    def add_inerter(self, b: "Node", s: "Node") -> None:
        """½·b·ṡ² to T, and the force b·s̈ between two ends."""
        self.contents.inertias.append(Inerter(b, s, owner=self.owner))

    def add_weight(self, mass: "Node", x: "Node", y: "Node") -> None:
        """−mass·(gₓ x + g_y y) to V."""
        if self.contents.gravity is not None:
            for g, s in zip(self.contents.gravity, (x, y), strict=True):
                if s.mask and not g.is_zero:
                    self.contents.weights.append(Weight(-mass * g, s, owner=self.owner))

    def add_spring(self, k: "Node", preload: "Node", s: "Node") -> None:
        """preload·s + ½·k·s² to V."""
        self.contents.springs.append(Spring(k, s, preload, self.owner))

    def tension(self, name: str, piece: int) -> "Node | None":
        """What statics finds in a piece of a member; None where nothing tells."""
        found = self.tensions.get(name)
        return found and _copied(found.pieces[piece], self.table)

    def tie(self, name: str) -> "Node | None":
        """The multiplier that keeps the length of a member both of whose ends move along it, as drawn."""
        found = self.tensions.get(name)
        return None if found is None or found.tie is None else _copied(found.tie, self.table)

    def drifts(self, motion: "Node") -> bool:
        """Is a motion driven, and not to and fro?"""
        drives = self.displacements.driven
        return any(x in drives and not stays_bounded(drives[x], self.time, self.sample) for x in gradient(motion))

    def owned(self, name: str, build: "Callable[[], T]") -> "T":
        """What `build` gives, its terms being those of the element of that name."""
        before, self.owner = self.owner, name
        found = build()
        self.owner = before
        return found

    def add_piece(self, start: "Node", coefficients: "Sequence[Node]", ends: "Sequence[Node]",
                  springs: "Sequence[tuple[Node, Node, Node]]") -> None:
        """A piece of a member, whose `springs` at rest are (stiffness, stretch, tension as drawn)."""
        from vibcli.scene.piece_terms import PieceSpring, PieceTerm

        for k, s, preload in springs:
            self.contents.springs.append(PieceSpring(k, s, preload, self.owner))
        self.contents.pieces.append(PieceTerm(self.owner, start, tuple(coefficients), tuple(ends), len(springs)))

    def add_spread_force(self, member: str, start: "Node", end: "Node", along: "Node", weight: "Node",
                         x: "Node") -> None:
        """The virtual work δA = weight ∫ along δu dx of a load on a member, `along` a function of the place x."""
        from vibcli.scene.spread_forces import SpreadForce

        self.contents.spread_forces.append(SpreadForce(self.owner, member, start, end, along, weight, x))

    def add_damper(self, c: "Node", s: "Node") -> None:
        """½·c·ṡ² to Φ."""
        self.contents.dampers.append(Damper(c, s, owner=self.owner))

    def add_force(self, steady: "Node", in_time: "Node", s: "Node", resting: bool = False) -> None:
        """The virtual work δA = force·δs of a load in two parts, functions of coordinates and velocities; resting: as a
        RestingLoad."""
        if steady.is_zero and in_time.is_zero:
            return
        self.idle |= not s.mask
        if s.mask or self.variant.inputs:
            offset = None if in_time.is_zero else steady
            kind = RestingLoad if resting else AppliedLoad
            self.contents.forces.append(kind(steady + in_time, s, offset, self.owner))

    def add_constraint(self, record: Record, node: "Node", form: str, part: str = "") -> None:
        """The condition node = 0."""
        self.contents.constraints.append(Constraint(record.name + part, node, record.where, form))

    def add_law(self, s: "Node", x: "Node", energy: "Node", damper: bool = False, bound: "Node | None" = None) -> None:
        """V(s) of a spring or Φ(ṡ) of a damper, given as a function of x."""
        from vibcli.scene.laws import Law

        force = gradient(energy).get(x, self.table.zero)
        self.contents.laws.append(Law(self.owner, s, x, energy, force, damper, bound))

    def add_inner_stretch(self, path: str, s: "Node") -> None:
        """The stretch of a part of what consists of several."""
        self.contents.inner_stretches.append(InnerStretch(self.owner, path, s))

    def static_preload(self, record: Record) -> "Node":
        """The unknown tension that keeps the drawn position in equilibrium, as a symbol `name.preload`."""
        node = self.table.parameter(record.name + ".preload", positive=False)
        self.contents.static_preloads.append((node, record))
        return node

    def add_energy(self, key: str, node: "Node") -> None:
        """A term of T, V or Φ that is written out."""
        record, names = self.spec.get("energies"), self.coordinates.names
        velocities = set(self.v)
        found = gradient(node)
        if key == "V" and velocities & set(found):
            self.report(record.place(key), "V depends on the coordinates alone, not on velocities")
        if set(self.a) & set(found):
            self.report(record.place(key), "energies do not depend on accelerations")
        moving = {"T": {*velocities, *self.coordinates.q}, "Phi": velocities}
        if key in moving and not moving[key] & set(found):
            self.report(record.place(key), f"{key} must depend on a velocity such as {names[0]}'" if names else
                        f"{key} must depend on a velocity")
        self.contents.energies[key] = self.contents.energies[key] + node

    def add_matrix(self, key: str, nodes: "list[list[Node]]") -> None:
        """M, C or K given outright."""
        self.contents.matrices[key] = nodes


class Reports:
    """Diagnostics: kept while a scene is built; of one that is finished raised, since nobody looks at what is kept any
    more."""

    __slots__ = ("diagnostics", "finished")

    def __init__(self) -> None:
        self.diagnostics, self.finished = [], False

    def report(self, where: Where | None, message: str, hint: str | None = None) -> None:
        """Something is wrong at a place of the file, which is said once."""
        if self.finished or not any((found.where, found.message) == (where, message) for found in self.diagnostics):
            self.diagnostics.append(Diagnostic(where, message, hint))
        if self.finished:
            raise SpecError(self.diagnostics[-1:])

    def finish(self) -> None:
        """The scene is built: SpecError where it is wrong."""
        if self.diagnostics:
            raise SpecError(self.diagnostics)
        self.finished = True


def _copied(node: "Node", table: Table) -> "Node":
    """An expression of another scene in this one."""
    from vibcli.symbolic.transfer_between_tables import copied

    return copied([node], table)[0]


def _samples(spec: "Spec", free: list[str], given: "Mapping[str, Fraction]", attempt: int) -> dict[str, float]:
    """{name: float} of the symbols without value: given ones, those that the spec names, and others."""
    found = sample_values(free, attempt)
    found |= {name: found[name] * SIZES[attempt % len(SIZES)] for name in spec.choices if name in found}
    found |= {name: value for name, value in spec.sample.items() if name in found}
    return {**found, **{name: float(value) for name, value in given.items()}}
