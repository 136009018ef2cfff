"""Problem: the lazy pipeline from a Spec to its answers — the only cache, the only place that decides what to compute.

    scene → form (linearised expressions) → equilibrium → elements → modes, damped modes
                 └ energies, equations of motion in letters

Each stage is computed on first touch, by one call to a pure function whose module is imported there.
"""

from fractions import Fraction
from functools import cached_property

from vibcli.errors import defined_as_drawn
from vibcli.on_request import OnRequest
from vibcli.stage import Stage

SHARED = ("scene", "preloads", "form", "timed_form", "drawn_form", "potential")
STAGES = ("scene", "form", "equilibrium", "elements", "modes", "damped", "energies", "equations", "closed_forms",
          "equilibria", "reactions", "shares", "sensitivities", "estimates")


class Problem(OnRequest):
    """A scene to be answered. `given`: exact values for parameters that the file leaves as symbols."""

    def __init__(self, spec, given=None):
        self.spec, self.given = spec, dict(given or {})
        self.costs, self.inner, self._cases = {}, 0.0, {}
        self.chosen = None      # what was chosen (inverse), where this is the scene with its solution

    def with_values(self, given):
        """The same scene with values for its symbols."""
        return Problem(self.spec, {**self.given, **given})

    def sharing(self, given):
        """The same with the expressions of this scene: for values on which no sign in its geometry hangs."""
        found = self.with_values(given)
        self.scene, self.form, self.drawn_form  # noqa: B018
        vars(found).update({stage: value for stage, value in vars(self).items() if stage in SHARED})
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
            self._cases[name] = Problem(self.spec.cases[name], given)
        return self._cases[name]

    def draw(self):
        """Build the scene and its cases, asked or not: SpecError where the geometry contradicts itself."""
        return [self.scene, *(self.case(name).scene for name in self.spec.cases)]

    def dimension(self, coordinate):
        """The dimension of a coordinate; a length where nothing settles it."""
        from vibcli.units import LENGTH

        found = self.spec.dimensions.of(coordinate)
        return LENGTH if any(base.startswith("?") for base in found) else found

    @Stage
    def scene(self):
        from vibcli.scene.build import build_scene

        scene = build_scene(self.spec, self.given)
        if self.symbolic_parameters(scene):
            from vibcli.mechanics.symbolic import drawn_stable

            scene = drawn_stable(self.spec, self.given, scene)
        self.preloads = {}
        if scene.static_preloads:
            from vibcli.mechanics.preload import settle_static_preloads

            self.preloads = defined_as_drawn(settle_static_preloads, scene)
        return scene

    @cached_property
    def loose(self):
        """The scene with all its coordinates, its closed loops held by multipliers; itself where it has none."""
        if self.scene.loops is None:
            return self.scene
        from vibcli.scene.build import build_scene

        return build_scene(self.spec, self.given, self.scene.attempt, loose=True)

    @property
    def symbolic(self):
        """Are there parameters without value?"""
        return self.symbolic_parameters(self.scene)

    @property
    def letters(self):
        """The parameters that have neither a value nor a condition."""
        return [name for name in self.scene.parameters.free if name not in self.given and name not in self.spec.choices]

    def symbolic_parameters(self, scene):
        return any(name not in self.given for name in scene.parameters.free)

    @Stage
    def form(self):
        from vibcli.errors import PhysicsError
        from vibcli.mechanics.linearise import linearise
        from vibcli.scene.closing import words_of_locked

        if not self.scene.q and any(body.moves for body in self.scene.bodies.values()):
            raise PhysicsError(words_of_locked(self.scene), "take a constraint out, or let one more body move")
        if not self.scene.q:
            raise PhysicsError("nothing moves in this scene: it has no coordinates",
                               "give a body a motion, as in bodies: {block: {mass: 2 kg, slide: x}}")
        found = defined_as_drawn(linearise, self.scene)
        if not self.scene.timed:
            return found
        from vibcli.mechanics.steady import steady

        self.timed_form = found
        return steady(self.scene, found)

    @cached_property
    def drawn_form(self):
        """The form in the drawn position, in letters: what vanishes there by structure is exactly zero."""
        from vibcli.mechanics.linearise import at_position

        return defined_as_drawn(at_position, self.form, self.scene.drawn_position)

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
        from vibcli.mechanics.equilibrium import figure_size

        return figure_size(self)

    @cached_property
    def matrices_in_letters(self):
        """M, C, G, K of the small oscillations in letters."""
        from vibcli.mechanics.lagrange import matrices_in_letters

        if self.scene.timed:
            from vibcli.mechanics.steady import require_autonomous
            from vibcli.scene.loops import drawn_values

            require_autonomous(self, drawn_values(self.scene))
        found = matrices_in_letters(self.letters_form)
        if self.equilibrium_letters is not None:
            from vibcli.algebra.polynomials import factored as shorter
        else:
            from vibcli.algebra.quotient import shorter
        return tuple({pair: shorter(node) for pair, node in matrix.items()} for matrix in found)

    @cached_property
    def linear_in_letters(self):
        """Can the small oscillations be written in letters: is the equilibrium known, or does its place not matter?"""
        return self.is_linear or self.balanced_as_drawn or self.equilibrium_letters is not None

    @property
    def letters_form(self):
        if self.balanced_as_drawn or self.is_linear:
            return self.drawn_form if self.balanced_as_drawn else self.form
        from vibcli.mechanics.linearise import at_position

        return at_position(self.form, self.equilibrium_letters.position(self.form))

    @cached_property
    def equilibrium_letters(self):
        """The Settled equilibrium of a nonlinear scene with letters, not drawn in it; None where none is found."""
        if not self.symbolic or self.balanced_as_drawn or self.is_linear:
            return None
        from vibcli.mechanics.settled import settled

        return settled(self)

    @cached_property
    def balanced_as_drawn(self):
        if self.symbolic:
            from vibcli.mechanics.symbolic import vanishes

            return all(vanishes(self.scene, terms) for terms in self.drawn_residual)
        return self.equilibrium.drawn

    @cached_property
    def drawn_residual(self):
        """The terms of each condition of equilibrium as drawn: lists of expressions."""
        from vibcli.mechanics.linearise import residual_terms

        return residual_terms(self.drawn_form)

    # numbers

    def values(self, arithmetic):
        """{parameter: number} in an arithmetic."""
        from vibcli.parameters import require_values

        if self.symbolic:
            require_values(self.scene.parameters, "this")
        given = {name: arithmetic.number(value) for name, value in self.given.items()}
        return self.scene.parameters.values(arithmetic, given)

    @cached_property
    def floats(self):
        return self.values(_floats())

    @cached_property
    def drawn_floats(self):
        from vibcli.algebra.evaluate import evaluate

        drawn = {q.name: node for q, node in self.scene.drawn.items()}
        drawn = {name: drawn[name] for name in self.spec.coordinates if name in drawn}
        return dict(zip(drawn, evaluate(list(drawn.values()), _floats(), self.floats), strict=True))

    @cached_property
    def rational(self):
        """Exact values of the parameters that have a rational one."""
        return self.scene.parameters.rational(self.given)

    @cached_property
    def potential(self):
        """V of the whole scene less the kinetic energy at rest, as an expression."""
        from vibcli.mechanics.energies import effective_potential

        return defined_as_drawn(effective_potential, self.scene)

    @cached_property
    def excitation(self):
        """{i: Q(t)}: what drives coordinate i of the small oscillations, in letters, with numbers for the place of an
        equilibrium that is not the drawn one."""
        from vibcli.mechanics.steady import excitation

        scene, settled = self.scene, self.equilibrium_letters
        if settled is not None:
            return excitation(scene, self.timed_form, settled.position(self.timed_form))
        if self.linear_in_letters or self.symbolic:
            return excitation(scene, self.timed_form, scene.drawn_position)
        place = {q: scene.table.number(Fraction(self.equilibrium.values[q.name])) for q in scene.drawn}
        return excitation(scene, self.timed_form, place)

    @cached_property
    def conservative(self):
        """Have all loads a potential: constant forces alone, and no driven motion?"""
        scene = self.scene
        return not scene.timed and not any(term.weight.mask for term in scene.forces)

    @Stage
    def equilibrium(self):
        from vibcli.mechanics import equilibrium

        start = self.spec.get("equilibrium")
        if start is None and self.drawn_numbers is not None:
            return equilibrium.Equilibrium(self.drawn_floats, True, equilibrium.relative_residual(self.drawn_numbers))
        return equilibrium.find_equilibrium(self, self._start(start or {}))

    def _start(self, start):
        from vibcli.algebra.evaluate import evaluate
        from vibcli.errors import PhysicsError

        for name, expression in start.items():
            if name not in self.scene.coordinates:
                raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints", "start "
                                   + " or ".join(f"'{other}'" for other in self.scene.coordinates), expression.where)
        nodes = [self.scene.lower(expression) for expression in start.values()]
        target = {**self.drawn_floats, **dict(zip(start, evaluate(nodes, _floats(), self.floats), strict=True))}
        return self.closed(self.drawn_floats, target)

    @property
    def dependent_values(self):
        """{name: float} of the dependent coordinates in equilibrium."""
        from vibcli.algebra.evaluate import evaluate

        nodes = self.scene.dependent
        values = dict(zip(nodes, evaluate(list(nodes.values()), _floats(), self.at_rest), strict=True))
        return {name: value if abs(value) > 1e-14 * self.scene.unit_of(name) else 0.0 for name, value in values.items()}

    @property
    def at_rest(self):
        """{symbol: float} of everything in equilibrium, at t = 0."""
        return {**self.floats, self.scene.time.name: 0.0, **self.equilibrium.values,
                **{v.name: 0.0 for v in self.scene.v}}

    def closed(self, start, target):
        """The position `target` ({coordinate: float}) with its dependent coordinates, reached from the closed position
        `start`; PhysicsError where its loops cannot close there."""
        if self.scene.loops is None:
            return target
        floats = {**self.floats, self.scene.time.name: 0.0}
        found = self.scene.loops.followed({**floats, **start}, {**floats, **target})
        if found is None:
            from vibcli.errors import PhysicsError

            raise PhysicsError("the loops of this scene cannot close in the position asked for",
                               "start nearer to the drawn position, or make the links longer")
        return {name: found[name] for name in self.drawn_floats}

    @cached_property
    def drawn_numbers(self):
        """The numbers in the drawn position where that is an equilibrium, else None."""
        from vibcli.mechanics.equilibrium import is_balanced
        from vibcli.mechanics.linearise import in_numbers

        numbers = in_numbers(self.drawn_form, _floats(), self.floats, self.rational)
        terms = len(self.drawn_form.curved) + len(self.drawn_form.residual)
        return numbers if is_balanced(numbers, terms + 2) else None

    @Stage
    def elements(self):
        """The element data at the equilibrium, in floats that are correct but for their own rounding."""
        from vibcli.mechanics.kinks import require_smooth
        from vibcli.mechanics.linearise import in_numbers

        require_smooth(self)
        if self.scene.timed:
            from vibcli.mechanics.steady import require_autonomous

            require_autonomous(self, self.at_rest)
        closed = self.scene.loops is not None or "atan2" in self.scene.table.called
        if self.equilibrium.drawn and not closed:
            return self.drawn_numbers.elements
        if self.is_linear:
            return in_numbers(self.form, _floats(), {**self.floats, **self.equilibrium.values}, self.rational).elements
        from vibcli.mechanics.precise import require_inertia, rounded_elements

        found = rounded_elements(self)
        if closed:
            require_inertia(self, found)
        return found

    def precise_elements(self, digits):
        """The element data at the equilibrium to so many digits, as mpmath numbers."""
        from vibcli.mechanics.precise import elements_to

        return elements_to(self, digits)

    def exact_elements(self):
        """The element data as Fractions, None where they are irrational or the equilibrium had to be searched for."""
        from vibcli.algebra.evaluate import Rationals
        from vibcli.mechanics.linearise import in_numbers

        form = self.drawn_form if self.equilibrium.drawn else self.form if self.is_linear else None
        if form is None:
            return None
        try:
            anywhere = dict.fromkeys(self.scene.coordinates, Fraction(0))
            return in_numbers(form, Rationals(), {**self.rational, **anywhere}).elements
        except (Rationals.Irrational, KeyError, ZeroDivisionError):
            return None

    @cached_property
    def sources(self):
        """Where more digits of the elements come from."""
        return self.precise_elements, self.exact_elements

    @Stage
    def modes(self):
        """The modes of the system without its dampers."""
        from vibcli.analyses.spectrum import natural_modes

        return self._named(natural_modes, self.elements, *self.sources)

    @cached_property
    def zero_modes(self):
        """What each mode without frequency is: free, held or falling (mechanics/neutral.py)."""
        from vibcli.mechanics.neutral import zero_modes

        return zero_modes(self) if any(mode.rigid for mode in self.modes) else {}

    @Stage
    def damped(self):
        """The damped modes; None where nothing damps."""
        elements = self.elements
        if not (elements.dampers or elements.C):
            return None
        from vibcli.analyses.spectrum import damped_modes

        return self._named(damped_modes, elements, lambda: self.modes, *self.sources)

    def shape(self, mode, how="first"):
        """The shape of a mode in the normalisation asked for, as a list of numbers."""
        from vibcli.analyses.shapes import normalised, weights

        return normalised(mode.shape, how, weights(self.elements))

    def _named(self, solve, *args, **options):
        """Solve, and give a physical refusal the name of its coordinate."""
        from vibcli.errors import PhysicsError

        try:
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
        from vibcli.analyses.spectrum import damped_modes, natural_modes

        modes = self._named(natural_modes, self.elements, *self.sources, digits=digits)
        return modes, self._named(damped_modes, self.elements, lambda: modes, *self.sources, digits=digits)

    # letters

    @Stage
    def energies(self):
        """T, V and Φ of the scene, brought into the form a textbook prints."""
        from vibcli.mechanics.energies import textbook_energies

        return textbook_energies(self.loose)

    @Stage
    def equations(self):
        """Lagrange's equations, full and for small oscillations, in letters."""
        from vibcli.mechanics.lagrange import equations

        return equations(self)

    @Stage
    def closed_forms(self):
        """Natural frequencies and modes in letters, by SymPy."""
        from vibcli.analyses.closed import closed_forms

        return closed_forms(self)


def _floats():
    from vibcli.algebra.evaluate import Floats

    return Floats
