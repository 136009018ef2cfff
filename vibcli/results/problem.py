"""Problem: the lazy pipeline from a Spec to its answers — the only cache, the only place that decides what to compute.

    scene → form (linearised expressions) → equilibrium → elements → modes, damped modes
                 └ energies, equations of motion in letters

Each stage is computed on first touch, by one call to a pure function whose module is imported there.
"""

from functools import cached_property

from vibcli.base.errors import defined_as_drawn
from vibcli.base.work import Work
from vibcli.results.numeric import InNumbers
from vibcli.results.on_demand import OnRequest
from vibcli.results.stage import Stage
from vibcli.results.symbolic import InLetters
from vibcli.results.time_response import InTime

SHARED = ("scene", "preloads", "form", "timed_form", "drawn_form", "potential")
STAGES = ("scene", "form", "equilibrium", "elements", "modes", "damped", "energies", "equations", "closed_forms",
          "equilibria", "reactions", "shares", "sensitivities", "estimates")
MOST = 10_000       # steps of a million products, for modes


class Problem(InNumbers, InLetters, InTime, OnRequest):
    """A scene to be answered. `given`: exact values for parameters that the file leaves as symbols; `work`: what counts
    its long work."""

    def __init__(self, spec, given=None, holding=None, work=None):
        """`holding`: the Problem whose motion starts under the force that lets go, where this one is held by it."""
        self.spec, self.given, self.holding, self.work = spec, dict(given or {}), holding, work or Work()
        self.costs, self.inner, self._cases = {}, 0.0, {}
        self.end = None         # of a motion in time [s], where it is not that of the file
        self.signed = False     # amplitudes have a sign, so that a search sees where they vanish
        self.chosen = None      # what was chosen (inverse), where this is the scene with its solution

    def without(self, damper):
        """The problem with one damper taken out."""
        dampers = {name: record for name, record in self.spec.get("dampers").items() if name != damper}
        spec = self.spec._replace(sections={**self.spec.sections, "dampers": dampers})
        return Problem(spec, self.given, self.holding, self.work)

    def with_values(self, given):
        """The same scene with values for its symbols."""
        return Problem(self.spec, {**self.given, **given}, self.holding, self.work)

    def held_back(self):
        """The same scene under the force that lets go where its motion starts."""
        return Problem(self.spec, self.given, self, self.work)

    def sharing(self, given):
        """The same with the expressions of this scene: for values on which no sign in its geometry hangs."""
        found = self.with_values(given)
        self.scene, self.form, self.drawn_form  # noqa: B018
        vars(found).update({stage: value for stage, value in vars(self).items() if stage in SHARED})
        return found

    def ending(self, end):
        """The same scene with its motion looked at until an instant [s]."""
        found = self.sharing({})
        found.chosen, found.end = self.chosen, end
        return found

    def at_equilibrium(self, equilibrium):
        """The same scene about another of its equilibria."""
        found = self.sharing({})
        found.chosen, found.equilibrium = self.chosen, equilibrium
        return found

    def case(self, name):
        """The problem of a case of the file."""
        if name not in self._cases:
            given = {key: value for key, value in self.given.items() if key not in self.spec.choices}
            self._cases[name] = Problem(self.spec.cases[name], given, work=self.work)
        return self._cases[name]

    def draw(self):
        """Build the scene and its cases, asked or not: SpecError where the geometry contradicts itself."""
        problems = [self, *(self.case(name) for name in self.spec.cases)]
        problems += [problem.before for problem in problems if problem.before is not None]
        return [problem.scene for problem in problems]

    def dimension(self, coordinate):
        """The dimension of a coordinate; a length where nothing settles it."""
        from vibcli.base.units import LENGTH

        found = self.spec.dimensions.of(coordinate)
        return LENGTH if any(base.startswith("?") for base in found) else found

    @Stage
    def scene(self):
        from vibcli.scene.build import build_preloaded, build_scene

        scene = (build_scene if self.holding is None else build_preloaded)(self.spec, self.given)
        if self.symbolic_parameters(scene):
            from vibcli.mechanics.symbolic_equilibrium_linear import drawn_stable

            scene = drawn_stable(scene)
        self.preloads = {}
        if scene.static_preloads and self.holding is not None:
            from vibcli.mechanics.static_preload import take_over

            scene = take_over(scene, self.holding.preloads)
        elif scene.static_preloads:
            from vibcli.mechanics.static_preload import settle_static_preloads

            scene, self.preloads = defined_as_drawn(settle_static_preloads, scene)
        return scene

    @cached_property
    def loose(self):
        """The scene with all its coordinates, its closed loops held by multipliers; itself where it has none."""
        return self.scene if self.scene.loops is None else self.scene.with_multipliers()

    @property
    def symbolic(self):
        """Are there parameters without value?"""
        return self.symbolic_parameters(self.scene)

    def symbolic_parameters(self, scene):
        return any(name not in self.given for name in scene.parameters.free)

    @Stage
    def form(self):
        from vibcli.base.errors import PhysicsError
        from vibcli.mechanics.linearise import linearise
        from vibcli.scene.constraints import words_of_locked

        if not self.scene.q and any(body.moves for body in self.scene.bodies.values()):
            hint = "take a constraint out, or let one more body move"
            until = self.spec.example("2 s")
            in_time = f", or ask for its motion in time: find: [{{response: {{until: {until}}}}}]"
            raise PhysicsError(words_of_locked(self.scene), hint + in_time * self.scene.timed)
        if not self.scene.q:
            raise PhysicsError("nothing moves in this scene: it has no coordinates",
                               "give a body a motion, as in bodies: {block: {mass: 2 kg, slide: x}}")
        found = defined_as_drawn(linearise, self.scene.vibrating)
        if not self.scene.timed:
            return found
        from vibcli.mechanics.autonomous import steady

        self.timed_form = found
        return steady(self.scene.vibrating, found)

    @cached_property
    def drawn_form(self):
        """The form in the drawn position, in letters: what vanishes there by structure is exactly zero."""
        from vibcli.mechanics.linearisation import at_position

        scene = self.scene.vibrating
        try:
            return at_position(self.form, scene.drawn_position)
        except ZeroDivisionError:
            from vibcli.mechanics.nonsmooth import without_slope

            defined_as_drawn(without_slope, scene)

    @cached_property
    def is_linear(self):
        """Do the equations not depend on where the scene is linearised?"""
        form = self.form
        terms = (*form.inertias, *form.springs, *form.dampers)
        rows = [node for _, row in terms for node in row.values()]
        parts = [node for part in (form.M, form.C, form.G, form.drag, *form.K) for node in part.values()]
        return not any(node.mask for node in rows + parts) and not any(curvature for _, curvature, _ in form.curved)

    @cached_property
    def figure_size(self):
        """The extent of the drawn figure in metres; 0 where nothing has a place."""
        from vibcli.mechanics.equilibrium.equilibrium import figure_size

        return figure_size(self)

    @cached_property
    def drawn_residual(self):
        """The terms of each condition of equilibrium as drawn: lists of expressions."""
        from vibcli.mechanics.linearisation import residual_terms

        return residual_terms(self.drawn_form)

    @Stage
    def modes(self):
        """The modes of the system without its dampers; none where it would not oscillate."""
        from vibcli.analyses.modal.massless_coordinates import only_damped
        from vibcli.analyses.modal.modes import natural_modes

        if self.elements.massless and only_damped(self.elements):
            return []
        return self.named(natural_modes, self.elements, *self.sources)

    @cached_property
    def zero_modes(self):
        """What each mode without frequency is: free, held or falling (mechanics/neutral.py)."""
        from vibcli.mechanics.equilibrium.zero_modes import zero_modes

        return zero_modes(self) if any(mode.rigid for mode in self.modes) else {}

    @Stage
    def damped(self):
        """The damped modes; None where nothing damps."""
        elements = self.elements
        if not (elements.dampers or elements.C):
            return None
        from vibcli.analyses.modal.modes import damped_modes

        return self.named(damped_modes, elements, lambda: self.modes, *self.sources)

    def shape(self, mode, how="first"):
        """The shape of a mode in the normalisation asked for, as a list of numbers."""
        from vibcli.analyses.modal.normalisation import normalised, weights

        return normalised(mode.shape, how, weights(self.elements))

    def named(self, solve, *args, **options):
        """Solve for modes, and give a physical refusal the name of its coordinate."""
        from vibcli.base.errors import PhysicsError

        try:
            with self.work.task("the search for the modes", MOST):
                return solve(*args, **options)
        except PhysicsError as error:
            index = getattr(error, "coordinate", None)
            if index is not None:
                name = self.scene.coordinates[index]
                error.message = error.message.format(coordinate=name).replace(f"coordinate {index + 1}", f"'{name}'")
                error.where = error.where or self.spec.coordinates[name].where
            raise

    def to_digits(self, digits):
        """(modes, damped modes) recomputed to so many correct digits."""
        from vibcli.analyses.modal.modes import damped_modes, natural_modes

        elements = self.elements
        if self.sources[0] is None:
            from vibcli.mechanics.high_precision import Degenerate

            raise Degenerate
        modes = self.named(natural_modes, elements, *self.sources, digits=digits) if self.modes else []
        return modes, self.named(damped_modes, self.elements, lambda: modes, *self.sources, digits=digits)
