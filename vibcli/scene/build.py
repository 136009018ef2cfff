"""Spec to Scene: every body, spring and damper becomes scalar functions s(q) with their weights.

    T = ½ Σ w ṡ²       V = Σ (N s + ½ k s²) − Σ m (gₓ x + g_y y)       Φ = ½ Σ c ṡ²
"""

from fractions import Fraction

from vibcli.base.errors import Diagnostic, SpecError
from vibcli.elements import gravity
from vibcli.language.fields import load
from vibcli.language.parameters import Parameters
from vibcli.language.reader import Reference
from vibcli.language.sections.initial import let_go
from vibcli.scene.build_order import carriers_first
from vibcli.scene.connections import Ends
from vibcli.scene.constraints import Freedom, close
from vibcli.scene.coordinates import SceneCoordinates
from vibcli.scene.expressions import Expressions
from vibcli.scene.frame import Frame
from vibcli.scene.geometry import Geometry
from vibcli.scene.held_drives import held_still
from vibcli.scene.laws import Laws
from vibcli.scene.terms import Terms
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats
from vibcli.symbolic.expression import Table
from vibcli.symbolic.parser import ExpressionError

ATTEMPTS = 12
SAMPLES = range(20, 28)     # where other samples start
SIZES = (1, 0.1, 0.01, 10)  # of what is chosen beside the numbers of a scene


def build_scene(spec, given=None, start=0, loose=False, releasing=False, opened=False, holding=False):
    """The Scene of a Spec; SpecError where its geometry contradicts itself.

    A `loose` scene keeps all coordinates: its constraints are held by multipliers. `releasing`: the supports of bodies
    give way by further coordinates, whose generalised forces are the reactions. `opened`: what drives the scene stands
    in it as further coordinates, the inputs: displacements that oscillate, and a load beside each load. `holding`: with
    the force that lets go where the motion starts.

    A scene with symbols is drawn with sample values, those that are `given` and others; signs such as that of R − r
    are those of the first sample in which the drawing fits together.
    """
    for attempt in range(start, start + ATTEMPTS):
        try:
            scene = Scene(spec, attempt, given or {}, releasing, opened, holding)
        except SpecError:   # a parameter that this sample leaves without value
            if attempt == start + ATTEMPTS - 1:
                raise
            continue
        try:
            scene.assemble(loose)
        except ExpressionError as error:
            scene.report(None, error.message)
        if not scene.diagnostics or not set(scene.parameters.free) - set(given or {}):
            break
    if scene.diagnostics:
        raise SpecError(scene.diagnostics)
    scene.built = scene.resting.built = True
    return scene


class Scene(Terms, Laws, Ends, SceneCoordinates, Geometry, Expressions):
    """The scalar functions of a scene, and the services by which elements make them."""

    def __init__(self, spec, attempt, given, releasing=False, opened=False, holding=False):
        self.spec, self.diagnostics, self.attempt, self.releasing = spec, [], attempt, releasing
        self.built = False
        self.resting, self.at_rest = self, False      # the scene at rest, where something is driven to and fro
        self.opened, self.inputs, self.holding = opened, {}, holding
        self.table = table = Table()
        table.records = {name: record["samples"] for name, record in (spec.get("records") or {}).items()}
        self.coordinates = list(spec.coordinates)
        self.parameters = Parameters(spec, table)
        given = {name: float(value) for name, value in given.items()}
        free = sample_values(self.parameters.free, attempt)
        free |= {name: free[name] * SIZES[attempt % len(SIZES)] for name in spec.choices if name in free}
        free |= {name: value for name, value in spec.sample.items() if name in free}
        self.sample = self.parameters.values(Floats, {**free, **given})
        table.sample = self.sample
        named = "t" in spec.parameters or "t" in spec.coordinates
        self.time = table.time = table.variable("the time" if named else "t")
        self.q, self.v, self.a = ([table.variable(name + primes) for name in self.coordinates]
                                  for primes in ("", "'", "''"))
        self._symbols = {(name, primes): node for primes, nodes in enumerate((self.q, self.v, self.a))
                         for name, node in zip(self.coordinates, nodes, strict=True)}
        self._symbols[self.time.name, 0] = self.time
        self.drawn = {node: self._drawn_value(name) for name, node in zip(self.coordinates, self.q, strict=True)}
        self._drawn_at_rest = {**self.drawn, **dict.fromkeys(self.v, table.zero), self.time: table.zero}
        self.speeds = self._speeds()
        self.released = []      # coordinates by which supports give way
        self.constraints, self.loops, self.dependent, self.driven = [], None, {}, {}
        self.freedom = Freedom(len(self.q), 0, ())
        self.surfaces = spec.get("surfaces") or {}
        self.bodies, self.points = {}, {}
        self.ground = Frame((table.zero, table.zero), (table.zero, table.zero), table.zero)
        self.start_terms()

    def assemble(self, loose=False):
        """Build the bodies, carriers first, then what connects them, then close the loops that constraints make."""
        spec = self.spec
        self.gravity = gravity.build(spec.get("gravity"), self) if "gravity" in spec.sections else None
        order = carriers_first(spec, self.report)
        for name in order:
            self.owner = name
            self.bodies[name] = load("body").build(spec.get("bodies")[name], self)
        if self.diagnostics:
            return
        for section, element in (("springs", "spring"), ("dampers", "damper"), ("forces", "force"),
                                 ("constraints", "constraint")):
            for record in (spec.get(section) or {}).values():
                if section == "forces" and record.name == let_go(spec) and not self.holding:
                    continue
                self.owner = record.name
                try:
                    load(element).build(record, self)
                except ZeroDivisionError:
                    self.report(record.where, f"'{record.name}' divides by zero as drawn", "draw its ends apart")
        for section in ("energies", "matrices"):
            if section in spec.sections:
                load(section).build(spec.get(section), self)
        for name, record in (spec.get("points") or {}).items():
            if "moves" in record:
                self.place(Reference(name, record.where))
        if self.driven:
            if any(map(self.oscillates, self.driven)):
                self.resting = held_still(self)
            shaken = self.keep_shaken()
            self.replace(self.driven)
            self.shaken = shaken
        if self.opened:
            self.open_loads()
        scenes = (self,) if self.resting is self else (self, self.resting)
        for scene in scenes:
            scene.settle_laws()
        if self.constraints and not loose and not self.diagnostics:
            try:
                close(scenes)
            except ZeroDivisionError:
                self._report_singular()
        for scene in scenes:
            scene.timed = scene.depends_on_time()

    def _report_singular(self):
        """Name the constraints that have no slope as drawn, as of √x at x = 0."""
        for constraint in self.constraints:
            try:
                self.at_drawn(*gradient(constraint.node).values())
            except ZeroDivisionError:
                self.report(constraint.where, f"the constraint '{constraint.name}' divides by zero as drawn",
                            "draw it in another position")
        if not self.diagnostics:
            self.report(self.constraints[0].where, "these constraints divide by zero as drawn", "draw them elsewhere")

    def report(self, where, message, hint=None):
        """Keep what is wrong; of a scene that is built raise it, since nobody looks at what is kept any more."""
        self.diagnostics.append(Diagnostic(where, message, hint))
        if self.built:
            raise SpecError(self.diagnostics)


def sample_values(names, attempt):
    """Values for symbols without one: positive, unrelated, and others at each attempt."""
    return {name: 0.6 + 1.7 * ((Fraction(7919 * (i + 1) + 104729 * attempt, 10007) * (attempt + 3)) % 1)
            for i, name in enumerate(names)}


