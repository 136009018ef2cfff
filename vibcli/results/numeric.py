"""Stages of a Problem in numbers: values, the equilibrium, and the element data there."""

from fractions import Fraction
from functools import cached_property

from vibcli.base.errors import defined_as_drawn
from vibcli.results.stage import Stage


class InNumbers:
    """The part of a Problem that puts numbers in and finds where it rests."""

    def values(self, arithmetic):
        """{parameter: number} in an arithmetic."""
        from vibcli.language.parameters import require_values

        if self.symbolic:
            require_values(self.scene.parameters, "this")
        given = {name: arithmetic.number(value) for name, value in self.given.items()}
        return self.scene.parameters.values(arithmetic, given)

    @cached_property
    def floats(self):
        return self.values(_floats())

    @cached_property
    def drawn_floats(self):
        from vibcli.symbolic.evaluation import evaluate

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

        return defined_as_drawn(effective_potential, self.scene.vibrating)

    @cached_property
    def conservative(self):
        """Have all loads a potential: constant forces alone, and no driven motion?"""
        scene = self.scene.vibrating
        return not scene.timed and not any(term.weight.mask for term in scene.forces)

    @Stage
    def equilibrium(self):
        from vibcli.mechanics.equilibrium import equilibrium

        if self.named_start:
            from vibcli.mechanics.equilibrium.nearest import nearest_equilibrium

            found = nearest_equilibrium(self, self._start())
        elif self.drawn_numbers is not None:
            found = equilibrium.Equilibrium(self.drawn_floats, True, equilibrium.relative_residual(self.drawn_numbers))
        else:
            found = equilibrium.find_equilibrium(self, self._start())
        if not (found.drawn or self.is_linear):
            from vibcli.mechanics.equilibrium.degenerate import sharpened

            found = sharpened(self, found)
        if self.scene.timed:
            from vibcli.mechanics.autonomous import require_autonomous

            require_autonomous(self, self.at_rest_in(found.values))
        return found

    @cached_property
    def named_start(self):
        """{coordinate: expression} of the place that `equilibrium:` names, empty where it names none."""
        from vibcli.base.errors import PhysicsError

        start = self.spec.get("equilibrium") or {}
        for name, expression in start.items():
            if name not in self.scene.coordinates:
                raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints", "start "
                                   + " or ".join(f"'{other}'" for other in self.scene.coordinates), expression.where)
        return {name: self.scene.lower(expression) for name, expression in start.items()}

    def _start(self):
        """The position from which the equilibrium is searched: as drawn but for what is named."""
        from math import isfinite

        from vibcli.base.errors import PhysicsError
        from vibcli.symbolic.evaluation import evaluate

        start = self.named_start
        values = evaluate(list(start.values()), _floats(), self.floats)
        for name, value in zip(start, values, strict=True):
            if not isfinite(value):
                raise PhysicsError(f"the start of '{name}' is no real number", "name another place under "
                                   "`equilibrium:`", self.spec.get("equilibrium")[name].where)
        return self.closed(self.drawn_floats, {**self.drawn_floats, **dict(zip(start, values, strict=True))})

    @property
    def dependent_values(self):
        """{name: float} of the dependent coordinates in equilibrium."""
        from vibcli.symbolic.evaluation import evaluate

        nodes = self.scene.resting.dependent
        values = dict(zip(nodes, evaluate(list(nodes.values()), _floats(), self.at_rest), strict=True))
        return {name: value if abs(value) > 1e-14 * self.scene.unit_of(name) else 0.0 for name, value in values.items()}

    @property
    def at_rest(self):
        """{symbol: float} of everything in equilibrium, at t = 0."""
        return self.at_rest_in(self.equilibrium.values)

    def at_rest_in(self, position):
        """{symbol: float} of everything at rest in a position, at t = 0."""
        return {**self.floats, self.scene.time.name: 0.0, **position, **{v.name: 0.0 for v in self.scene.v}}

    def closed(self, start, target):
        """The position at rest `target` ({coordinate: float}) with its dependent coordinates, reached from the closed
        position `start`; PhysicsError where its loops cannot close there."""
        return self._followed(self.scene.resting.loops, start, target)

    def closed_at_start(self, start, target):
        """The same with what is driven to and fro where it is at t = 0."""
        return self._followed(self.scene.loops, start, target)

    def _followed(self, loops, start, target):
        if loops is None:
            return target
        floats = {**self.floats, self.scene.time.name: 0.0}
        found = loops.followed({**floats, **start}, {**floats, **target})
        if found is None:
            from vibcli.base.errors import PhysicsError

            raise PhysicsError("the loops of this scene cannot close in the position asked for",
                               "start nearer to the drawn position, or make the links longer")
        return {name: found[name] for name in self.drawn_floats}

    @cached_property
    def drawn_numbers(self):
        """The numbers in the drawn position where that is an equilibrium, else None."""
        from vibcli.mechanics.equilibrium.equilibrium import is_balanced
        from vibcli.mechanics.numeric_linearisation import in_numbers

        numbers = in_numbers(self.drawn_form, _floats(), self.floats, self.rational)
        terms = len(self.drawn_form.curved) + len(self.drawn_form.residual)
        return numbers if is_balanced(numbers, terms + 2) else None

    @Stage
    def elements(self):
        """The element data at the equilibrium, in floats that are correct but for their own rounding."""
        from vibcli.mechanics.nonsmooth import require_smooth
        from vibcli.mechanics.numeric_linearisation import in_numbers

        require_smooth(self)
        closed = self.scene.loops is not None or "atan2" in self.scene.table.called
        if self.equilibrium.drawn and not closed:
            return self.drawn_numbers.elements
        if self.is_linear:
            return in_numbers(self.form, _floats(), {**self.floats, **self.equilibrium.values}, self.rational).elements
        from vibcli.mechanics.high_precision import Degenerate, require_inertia, rounded_elements

        try:
            found = rounded_elements(self)
        except Degenerate as degenerate:
            from vibcli.mechanics.equilibrium.degenerate import settled_alone

            return settled_alone(self, degenerate.position)
        if closed:
            require_inertia(self, found)
        return found

    def precise_elements(self, digits):
        """The element data at the equilibrium to so many digits, as mpmath numbers."""
        from vibcli.mechanics.high_precision import elements_to

        return elements_to(self, digits)

    def exact_elements(self):
        """The element data as Fractions, None where they are irrational or the equilibrium had to be searched for."""
        from vibcli.mechanics.numeric_linearisation import in_numbers
        from vibcli.symbolic.evaluation import Rationals

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


def _floats():
    from vibcli.symbolic.evaluation import Floats

    return Floats
