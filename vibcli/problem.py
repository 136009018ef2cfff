"""Problem: the lazy pipeline from a Spec to its answers — the only cache, the only place that decides what to compute.

    scene → form (linearised expressions) → equilibrium → elements → modes, damped modes
                 └ energies, equations of motion in letters

Each stage is computed on first touch, by one call to a pure function whose module is imported there.
"""

from fractions import Fraction
from functools import cached_property

from vibcli.errors import defined_as_drawn
from vibcli.stage import Stage

STAGES = ("scene", "form", "equilibrium", "elements", "modes", "damped", "energies", "equations", "closed_forms",
          "equilibria")
ABOUT = {"equilibrium", "equilibria", "about_each", "elements", "sources", "modes", "zero_modes", "damped", "equations",
         "closed_forms", "balanced_as_drawn", "linear_in_letters", "matrices_in_letters"}   # differ between equilibria


class Problem:
    """A scene to be answered. `given`: exact values for parameters that the file leaves as symbols."""

    def __init__(self, spec, given=None):
        self.spec, self.given = spec, dict(given or {})
        self.costs, self.inner, self._cases = {}, 0.0, {}

    def with_values(self, given):
        """The same scene with values for its symbols."""
        return Problem(self.spec, {**self.given, **given})

    def case(self, name):
        """The problem of a case of the file."""
        if name not in self._cases:
            self._cases[name] = Problem(self.spec.cases[name], self.given)
        return self._cases[name]

    def at_equilibrium(self, equilibrium):
        """The same scene about another of its equilibria; what does not depend on it is shared."""
        other = Problem(self.spec, self.given)
        shared = {key: value for key, value in self.__dict__.items() if key not in ABOUT | other.__dict__.keys()}
        other.__dict__.update(shared, equilibrium=equilibrium)
        return other

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

    @property
    def symbolic(self):
        """Are there parameters without value?"""
        return self.symbolic_parameters(self.scene)

    def symbolic_parameters(self, scene):
        return any(name not in self.given for name in scene.parameters.free)

    @Stage
    def form(self):
        from vibcli.errors import PhysicsError
        from vibcli.mechanics.linearise import linearise

        if not self.scene.q:
            raise PhysicsError("nothing moves in this scene: it has no coordinates",
                               "give a body a motion, as in bodies: {block: {mass: 2 kg, slide: x}}")
        return defined_as_drawn(linearise, self.scene)

    @cached_property
    def drawn_form(self):
        """The form in the drawn position, in letters: what vanishes there by structure is exactly zero."""
        from vibcli.mechanics.linearise import at_position

        return defined_as_drawn(at_position, self.form, self.scene.drawn)

    @cached_property
    def is_linear(self):
        """Do the equations not depend on where the scene is linearised?"""
        form = self.form
        terms = (*form.inertias, *form.springs, *form.dampers)
        rows = [node for _, row in terms for node in row.values()]
        parts = [node for part in (form.M, form.C, form.G, *form.K) for node in part.values()]
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

        return matrices_in_letters(self.letters_form)

    @cached_property
    def linear_in_letters(self):
        """Can the small oscillations be written in letters: is the equilibrium drawn, or does its place not matter?"""
        return self.is_linear or self.balanced_as_drawn

    @property
    def letters_form(self):
        return self.drawn_form if self.balanced_as_drawn else self.form

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

        nodes = list(self.scene.drawn.values())
        return dict(zip(self.scene.coordinates, evaluate(nodes, _floats(), self.floats), strict=True))

    @cached_property
    def rational(self):
        """Exact values of the parameters that have a rational one."""
        return self.scene.parameters.rational(self.given)

    @cached_property
    def potential(self):
        """V of the whole scene less the kinetic energy at rest, as an expression."""
        from vibcli.mechanics.energies import effective_potential

        return defined_as_drawn(effective_potential, self.scene)

    @Stage
    def equilibrium(self):
        from vibcli.mechanics import equilibrium

        start = self.spec.get("equilibrium")
        if start is None and self.drawn_numbers is not None:
            return equilibrium.Equilibrium(self.drawn_floats, True, equilibrium.relative_residual(self.drawn_numbers))
        return equilibrium.find_equilibrium(self, self._start(start or {}))

    def _start(self, start):
        from vibcli.algebra.evaluate import evaluate

        nodes = [self.scene.lower(expression) for expression in start.values()]
        return {**self.drawn_floats, **dict(zip(start, evaluate(nodes, _floats(), self.floats), strict=True))}

    @cached_property
    def drawn_numbers(self):
        """The numbers in the drawn position where that is an equilibrium, else None."""
        from vibcli.mechanics.equilibrium import is_balanced
        from vibcli.mechanics.linearise import in_numbers

        numbers = in_numbers(self.drawn_form, _floats(), self.floats, self.rational)
        terms = len(self.drawn_form.curved) + len(self.drawn_form.residual)
        return numbers if is_balanced(numbers, terms + 2) else None

    @Stage
    def equilibria(self):
        """All equilibria within the bounds of the file, or within default ones."""
        from vibcli.mechanics.equilibria import find_equilibria

        return find_equilibria(self)

    @cached_property
    def about_each(self):
        """The Problems about all equilibria."""
        from vibcli.mechanics.degenerate import about

        return [about(self, item) for item in self.equilibria.items]

    @Stage
    def elements(self):
        """The element data at the equilibrium, in floats that are correct but for their own rounding."""
        from vibcli.mechanics.linearise import in_numbers

        if self.equilibrium.drawn:
            return self.drawn_numbers.elements
        if self.is_linear:
            return in_numbers(self.form, _floats(), {**self.floats, **self.equilibrium.values}, self.rational).elements
        from vibcli.mechanics.precise import rounded_elements

        return rounded_elements(self)

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

        return textbook_energies(self.scene)

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
