"""A scene: every body, spring and damper as scalar functions s(q, t) with their weights.

    T = ½ Σ w ṡ²       V = Σ (N s + ½ k s²) − Σ m (gₓ x + g_y y)       Φ = ½ Σ c ṡ²
"""

from collections.abc import Mapping, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.stage import SharedPart
from vibcli.scene.displacements import Opening, stays_bounded
from vibcli.scene.expressions import Expressions
from vibcli.scene.places import Places
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.parameters import Parameters
    from vibcli.language.spec import Spec
    from vibcli.scene.build import Setting
    from vibcli.scene.closed_loops import Loops
    from vibcli.scene.contents import Contents
    from vibcli.scene.coordinates import SceneCoordinates
    from vibcli.symbolic.defined_functions import Ending
    from vibcli.symbolic.node import Node

READ = frozenset(("setting", "lower", "pair", "number", "terms_with", "unrooted", "distance", "height_of", "frame",
                  "place", "place_of", "rim", "extent", "unit_of", "units_of"))     # made of the values of parameters
OF_VALUES = READ | {"like", "spec", "parameters", "sample", "still", "oscillating", "displaced_at_rest"}
CONNECTIONS = ("springs", "dampers", "laws", "inertias")        # of the inertias those that exert a force


class Drives(NamedTuple):
    """`driven`: {symbol: function of the time}; `inputs`: {symbol: Opening}; coordinates `released` by supports;
    `idle`: does a load act on what stays?"""

    driven: "dict[Node, Node]"
    inputs: "dict[Node, Opening]"
    released: "list[Node]"
    idle: bool = False


class Freedom(NamedTuple):
    """How many coordinates and independent conditions a scene has, and which constraints follow from others."""

    coordinates: int
    conditions: int
    redundant: tuple[str, ...]


class Closure(NamedTuple):
    """What constraints make of a scene: its Loops, if any, the `dependent` coordinates {name: node}, its Freedom."""

    loops: "Loops | None"
    dependent: "dict[str, Node]"
    freedom: Freedom


class Scene:
    """The scalar functions of a scene; finished when it is made. `still`: the scene at rest, where something is driven
    to and fro; `like`: one of the same functions, with other values."""

    like: "Scene | None" = None

    def __init__(self, setting: "Setting", coordinates: "SceneCoordinates", contents: "Contents", drives: Drives,
                 closure: Closure | None = None, still: "Scene | None" = None) -> None:
        self.setting, self.kinematics, self.contents, self.still = setting, coordinates, contents, still
        self.spec, self.attempt, _, self.parameters, self.sample, reports, _ = setting
        self.surfaces, self.report = self.spec.sections.get("surfaces") or {}, reports.report
        self.table, self.time, self.coordinates, self.q, self.v, self.a, self.speeds, _, self.drawn, _ = coordinates
        self.symbol, self.rate, self.at_drawn = coordinates.symbol, coordinates.rate, coordinates.at_drawn
        (self.gravity, self.bodies, self.points, self.members, self.spread_loads, self.inertias, self.springs,
         self.dampers, self.weights, self.forces, self.laws, self.constraints, self.pieces, self.spread_forces,
         self.inner_stretches, self.energies, self.matrices, self.static_preloads, self.shaken,
         self.fractions) = contents
        self.drives, (self.driven, self.inputs, self.released, self.idle), self.closure = drives, drives, closure
        self.loops, self.dependent, self.freedom = closure or Closure(None, {}, Freedom(len(self.q), 0, ()))

    if not TYPE_CHECKING:
        def __getattr__(self, name: str) -> Any:
            """What reads fields of the file, with the values of the parameters: made when it is first asked for."""
            if name not in READ:
                raise AttributeError(name)
            self._read_fields()
            return vars(self)[name]

    def _read_fields(self) -> None:
        if self.like is not None:
            self.setting = self.like.setting._replace(spec=self.spec, parameters=self.parameters, sample=self.sample,
                                                      draw=partial(self.like.setting.draw.func, self.spec, {}))
        expressions = Expressions(self.kinematics, self.parameters, self.sample, self.setting.reports)
        self.lower, self.pair, self.number = expressions.lower, expressions.pair, expressions.number
        self.terms_with, self.unrooted = expressions.terms_with, expressions.unrooted
        self.distance, self.height_of = expressions.distance, expressions.height_of
        places = Places(self.spec, expressions, self.bodies, self.points, self.members)
        self.frame, self.place, self.place_of, self.rim = places.frame, places.place, places.place_of, places.rim
        self.extent, self.unit_of, self.units_of = places.extent, places.unit_of, places.units_of

    @SharedPart
    def timed(self) -> bool:
        """Does anything that moves, stores, damps or loads depend on the time?"""
        return any(node.mask & self.time.mask for node in self.contents.depends_on)

    def with_parts(self, **parts: Any) -> "Scene":
        """The same with other parts, as they are named where a Scene is made."""
        return Scene(**{"setting": self.setting, "coordinates": self.kinematics, "contents": self.contents,
                        "drives": self.drives, "closure": self.closure, "still": self.still, **parts})

    @cached_property
    def _of_no_values(self) -> dict[str, Any]:
        """{name: part} of what hangs on no value of a parameter."""
        return {name: part for name, part in vars(self).items() if name not in OF_VALUES}

    def with_other_values(self, spec: "Spec", parameters: "Parameters", sample: dict[str, float]) -> "Scene":
        """The same by its expressions with other values, at which all would be drawn alike."""
        found = object.__new__(Scene)
        still = self.still and self.still.with_other_values(spec, parameters, sample)
        vars(found).update(self._of_no_values, like=self, spec=spec, parameters=parameters, sample=sample, still=still)
        if self.loops is not None:
            loops = self.loops.with_sizes(found.unit_of)
            vars(found).update(loops=loops, closure=Closure(loops, self.dependent, self.freedom))
        return found

    def replaced(self, values: "Mapping[Node, Node]", **parts: Any) -> "Scene":
        """With other parts, and symbols replaced in every expression, {symbol: node}."""
        scene = self.with_parts(**parts)
        nodes = scene.contents.nodes
        new = scene.unrooted(substitute(nodes, values))
        return scene.with_parts(contents=scene.contents.over(dict(zip(nodes, new, strict=True))))

    def with_preloads(self, tensions: "Mapping[Node, Node]") -> "Scene":
        """The same with its static preloads, {symbol: node}; so is the scene at rest."""
        found = self.replaced(tensions, contents=self.contents._replace(static_preloads=[]))
        return found.with_parts(still=self.still and self.still.with_preloads(tensions))

    @property
    def written(self) -> "Scene":
        """The same in the letters of textbooks, without fractions that stand for functions."""
        return self.replaced(self.fractions) if self.fractions else self

    def with_multipliers(self) -> "Scene":
        """The same with all its coordinates, its constraints to be held by multipliers."""
        return self.setting.draw(self.attempt, self.setting.variant._replace(multipliers=True))

    def with_released_supports(self) -> "Scene":
        """The same with all its coordinates and those by which its supports give way, whose forces are reactions."""
        return self.setting.draw(self.attempt, self.setting.variant._replace(multipliers=True, released=True))

    def with_open_members(self) -> "Scene":
        """The same with all its coordinates and those by which members that keep their length are cut open."""
        return self.setting.draw(self.attempt, self.setting.variant._replace(multipliers=True, opened=True))

    def with_inputs(self) -> "Scene":
        """The same with what drives it as further coordinates, which stand last: displacements that come and go, a load
        beside each load, and one along each coordinate."""
        return self.setting.draw(self.attempt, self.setting.variant._replace(inputs=True))

    def drawn_anew(self, attempt: int) -> "Scene":
        """The same drawn with other sample values for its symbols, of the first attempt from this one that fits."""
        return self.setting.draw(attempt, self.setting.variant)

    def drawn_with(self, letters: "Mapping[str, Fraction]") -> "Scene":
        """The same drawn with given values of its symbols."""
        return self.setting.draw.func(self.spec, letters, 0, self.setting.variant)

    @property
    def hidden(self) -> list[str]:
        """Names of the coordinates that the file does not name: motions of members, dependent ones too."""
        names = (*self.coordinates, *self.dependent)
        return [name for name in names if name not in self.spec.coordinates]

    @cached_property
    def displaced_at_rest(self) -> "dict[str, Node | None]":
        """{signal: what it is at rest}, of places on members, as far as they were asked for."""
        return {}

    @property
    def resting(self) -> "Scene":
        """The scene at rest: itself where nothing is driven to and fro."""
        return self.still or self

    @property
    def held(self) -> bool:
        """Is all of it a question of statics: bodies that supports and constraints leave no freedom, nothing driven?"""
        return not (self.q or self.timed) and any(body.moves for body in self.bodies.values())

    @property
    def vibrating(self) -> "Scene":
        """The scene whose small oscillations are those of this one: itself; but the one at rest where constraints tie
        its coordinates to what is driven to and fro."""
        tied = self.still and any(node.mask & self.time.mask for node in self.dependent.values())
        return self.still if tied else self

    @property
    def drawn_position(self) -> "dict[Node, Node]":
        """{symbol: its value as drawn} of all coordinates and the time."""
        return {**self.drawn, self.time: self.table.zero}

    @SharedPart
    def rates_at_rest(self) -> "dict[Node, Node]":
        """{symbol: zero} of the velocities."""
        return dict.fromkeys(self.v, self.table.zero)

    @property
    def drawn_coordinates(self) -> "dict[str, Node]":
        """{name: node as drawn} of the independent coordinates."""
        return {q.name: self.drawn[q] for q in self.q}

    @property
    def drawn_values(self) -> dict[str, float]:
        """{name: float} as drawn, with sample values for letters."""
        names = {node.name: value for node, value in self.drawn.items()}
        found = evaluate(list(names.values()), Floats, self.sample)
        return {**self.sample, **dict(zip(names, found, strict=True)), self.time.name: 0.0}

    def terms_of(self, name: str, *kinds: str, undriven: bool = False) -> list[Any]:
        """The springs, dampers, laws and inerters of an element, or those of the given kinds; `undriven`: as functions
        of the symbols of driven displacements."""
        return [term for kind in kinds or CONNECTIONS
                for term in (self.undriven(kind) if undriven else getattr(self, kind))
                if term.owner == name and hasattr(term, "force")]

    def force_of(self, name: str) -> "Node | None":
        """The force of a spring or damper, of a spring without free length its magnitude; None of another element."""
        forces: list[Node] = [term.force(self) for term in self.terms_of(name)]
        if len(forces) > 1:
            return self.table.sqrt(self.table.sum(*((force * force, ONE) for force in forces)))
        return forces[0] if forces else None

    def law_switches(self) -> "tuple[dict[Node, str], dict[Node, Node]]":
        """({argument: owner}, {argument: σ₀}) of what bends or jumps in the laws."""
        from vibcli.symbolic.kinks import kinks_at

        owners, bounds = {}, {}
        for law in self.laws:
            for part in reachable([law.potential(self)]):
                for u in kinks_at(part) if part.mask else ():
                    sign = self.table.call("sign", u)
                    if sign.op != "call":
                        sign = self.table.call("sign", -u)
                    if sign.op != "call":
                        continue        # it has one sign at all times
                    owners[sign.args[0]] = law.owner
                    if law.bound is not None:
                        bounds[sign.args[0]] = law.bound
        return owners, bounds

    def endings(self, floats: Mapping[str, float]) -> "Ending | None":
        """Why laws have no value beyond some deflection, the parameters being numbers; None where all go on."""
        found: dict[str, Ending] = {}
        for call in reachable([law.potential(self) for law in self.laws]):
            function = self.table.functions.get(call.name)
            if call.op == "call" and function is not None:
                ending = function.ending(evaluate(list(call.args[1:]), Floats, floats))
                found |= {ending.what: ending} if ending else {}
        return next(iter(found.values()))._replace(what=" or ".join(found)) if found else None

    def undriven(self, kind: str) -> list[Any]:
        """Terms, or laws, as functions of the symbols of driven displacements, which are zero as drawn."""
        terms: list[Any] = self.shaken[kind] if self.shaken else getattr(self, kind)
        return terms

    @cached_property
    def oscillating(self) -> "list[Node]":
        """The driven displacements that come and go, so that they count as small ones."""
        return [symbol for symbol, node in self.driven.items() if stays_bounded(node, self.time, self.sample)]

    @property
    def held_drives(self) -> "dict[Node, Node]":
        """{symbol: node} of driven displacements, zero of those that oscillate."""
        return self.driven | dict.fromkeys(self.oscillating, self.table.zero)

    def at_still(self, kind: str) -> list[Any]:
        """The springs, dampers, inertias or loads with the driven displacements that oscillate left out."""
        terms = self.undriven(kind)
        if not self.shaken:
            return terms
        held = self.held_drives
        return [term.over(dict(zip(term.nodes, substitute(term.nodes, held), strict=True))) for term in terms]

    def loads_at_still(self) -> Sequence[Any]:
        """The loads, the steady ones with the driven displacements that oscillate left out; beside each of them what of
        it is a load in time, as it is."""
        if not self.oscillating:
            return self.forces
        found, zero = [], self.table.zero
        for still, term in zip(self.at_still("forces"), self.forces, strict=True):
            if term.offset is None:
                found.append(still)
                continue
            if not still.offset.is_zero:
                found.append(still._replace(weight=still.offset, offset=None))
            found.append(term._replace(weight=term.weight - term.offset, offset=zero))
        return found
