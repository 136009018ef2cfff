"""A mechanical system at one of its equilibria, and the linear system about it."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NoEquilibrium, PhysicsError
from vibcli.base.stage import Costs, Stage
from vibcli.mechanics.factored_system import require_dense
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.mechanics.numeric_system import NumericSystem
from vibcli.symbolic.evaluation import Floats, Rationals, evaluate

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.mechanics.inputs_outputs.dynamic_reactions import MovingReactions
    from vibcli.mechanics.inputs_outputs.reactions import Reaction
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.running_errors import Rounded, RunningErrors


class Configuration:
    """A NumericSystem at the equilibrium next to the drawn position, or at one that is given, with its linear system
    if that is; `final`: no more digits of this are to be had. arithmetic: of what is evaluated about it."""

    arithmetic: Any = Floats

    def __init__(self, numeric: NumericSystem, equilibrium: "Equilibrium | None" = None,
                 linear_system: "FactoredSystem | None" = None, final: bool = False) -> None:
        self.numeric, self.system, self.spec, self.work = numeric, numeric.system, numeric.spec, numeric.work
        self.costs = numeric.costs if equilibrium is None else Costs()
        self._equilibrium, self._linear_system, self._final = equilibrium, linear_system, final

    @cached_property
    def scene(self) -> "Scene":
        return self.system.scene

    def with_values(self, given: Mapping[str, Fraction]) -> "Configuration":
        """The same with values for its symbols, its scene drawn anew."""
        return Configuration(self.numeric.with_values(given))

    @property
    def reference_form(self) -> "Linearisation":
        """The Linearisation from which the linear system is: as drawn, where that is the equilibrium."""
        return self.system.linearisation_at_reference if self.equilibrium.drawn else self.system.linearisation

    def about(self, equilibrium: "Equilibrium", linear_system: "FactoredSystem | None" = None,
              final: bool = False) -> "Configuration":
        """The same system at another of its equilibria."""
        return Configuration(self.numeric, equilibrium, linear_system, final)

    @cached_property
    def preloaded(self) -> "Configuration | None":
        """The Configuration under the force that lets go at t = 0; None where none does."""
        held = self.system.preloaded
        return None if held is None else Configuration(NumericSystem(held, self.numeric.given))

    @Stage
    def equilibrium(self) -> "Equilibrium":
        """The Equilibrium; PhysicsError where none is reached."""
        if self._equilibrium is not None:
            return self._equilibrium
        settled = self.system.settled
        if settled is not None and settled.refusal is not None:
            raise settled.refusal
        if settled is not None and settled.configuration.numeric.given == self.numeric.given:
            return settled.configuration.equilibrium
        found = self._reached()
        if self.scene.timed:
            from vibcli.mechanics.autonomous import require_autonomous

            require_autonomous(self, self.numeric.at_rest_in(found.values))
        return found

    @cached_property
    def falls(self) -> bool:
        """Is no equilibrium reached, as nothing holds the scene, so that its motion starts as drawn?"""
        try:
            self.equilibrium  # noqa: B018
        except NoEquilibrium:
            return True
        except PhysicsError:
            return False
        return False

    def _reached(self) -> "Equilibrium":
        from vibcli.mechanics.equilibrium import equilibrium

        numeric = self.numeric
        if self.scene.held:
            return equilibrium.Equilibrium(numeric.drawn_floats, True, 0.0)
        if self.system.named_start or numeric.drawn_numbers is None:
            require_dense(len(self.scene.q), "the search for an equilibrium that is not the drawn position")
        if self.system.named_start:
            from vibcli.mechanics.equilibrium.nearest import nearest_equilibrium

            found = nearest_equilibrium(numeric, numeric.start())
        elif numeric.drawn_numbers is not None:
            residual = equilibrium.relative_residual(numeric.drawn_numbers)
            found = equilibrium.Equilibrium(numeric.drawn_floats, True, residual)
        else:
            steep = self.system.is_steep_as_drawn
            found = equilibrium.find_equilibrium(numeric, numeric.beside_drawn() if steep else numeric.start())
        if found.drawn or found.jumps is not None or self.system.is_linear:
            return found
        from vibcli.mechanics.equilibrium.degenerate import sharpened

        return sharpened(numeric, found)

    @property
    def at_rest(self) -> dict[str, float]:
        """{symbol: float} of everything in equilibrium, at t = 0."""
        return self.numeric.at_rest_in(self.equilibrium.values)

    @property
    def dependent_values(self) -> dict[str, float]:
        """{name: float} of the dependent coordinates in equilibrium."""
        nodes = self.scene.resting.dependent
        values = dict(zip(nodes, evaluate(list(nodes.values()), Floats, self.at_rest), strict=True))
        return {name: value if abs(value) > 1e-14 * self.scene.unit_of(name) else 0.0 for name, value in values.items()}

    @property
    def linear_system(self) -> "FactoredSystem":
        """The element data for what makes dense matrices of them; PhysicsError where there are too many coordinates."""
        require_dense(self.element_data.n)
        return self.element_data

    @cached_property
    def element_data(self) -> "FactoredSystem":
        """The FactoredSystem about the equilibrium, in floats that are correct but for their own rounding."""
        return self.costs.measured("linear_system", self._assembled)

    def _assembled(self) -> "FactoredSystem":
        if self._linear_system is not None:
            return self._linear_system
        found = self.without_given_damping()
        if self.spec.get("damping") is None:
            return found
        from vibcli.mechanics.given_damping import with_damping

        return self.damped_as_a_whole(found) if found.pieces else with_damping(found, self.given_damping().each(float))

    @cached_property
    def coupled(self) -> bool:
        """Does `damping:` of members stand beside what couples their modes?"""
        if self.spec.get("damping") is None or not self.scene.pieces:
            return False
        from vibcli.mechanics.given_damping import coupled

        return coupled(self.spec.get("damping"), self.without_given_damping())

    @cached_property
    def rated_beside_dampers(self) -> bool:
        """Do modes of members have ratios beside dampers?"""
        if self.spec.get("damping") is None or not self.scene.pieces or self.coupled:
            return False
        return any(self.without_given_damping().matrices()[1].values())

    def damped_as_a_whole(self, elements: "FactoredSystem", moved: "Sequence[int] | None" = None) -> "FactoredSystem":
        """Element data of members with `damping:` that stands beside what couples their modes; moved: those of their
        coordinates that are displacements, where others are loads."""
        if not self.coupled:
            return elements
        from vibcli.mechanics.given_damping import as_a_whole

        return as_a_whole(self, elements, moved)

    def given_damping(self, digits: int = 40) -> "FactoredSystem":
        """What `damping:` adds, as element data, to so many digits; nothing where members are damped mode by mode."""
        if self.scene.pieces:
            from vibcli.mechanics.factored_system import FactoredSystem

            return FactoredSystem(len(self.scene.q))
        require_dense(len(self.scene.q), "`damping:`")
        from vibcli.mechanics.given_damping import damping_of

        return damping_of(self, digits)

    def without_given_damping(self) -> "FactoredSystem":
        """The FactoredSystem about the equilibrium without what `damping:` adds."""
        from vibcli.mechanics.nonsmooth import require_smooth

        require_smooth(self)
        numeric, system = self.numeric, self.system
        closed = self.scene.loops is not None or "atan2" in self.scene.table.called
        if self.equilibrium.drawn and not closed:
            return numeric.drawn_numbers.elements
        if system.is_linear:
            return in_numbers(system.linearisation, Floats, {**numeric.floats, **self.equilibrium.values},
                              numeric.rational).elements
        from vibcli.mechanics.high_precision import Degenerate, require_inertia, rounded_system

        try:
            found = rounded_system(self)
        except Degenerate as degenerate:
            from vibcli.mechanics.equilibrium.degenerate import settled_alone

            self._final = True
            self.equilibrium, found = settled_alone(numeric, self.equilibrium, degenerate.position)
            return found
        if closed:
            require_inertia(numeric, found)
        return found

    def precise_system(self, digits: int) -> "FactoredSystem":
        """The FactoredSystem to so many digits, as mpmath numbers."""
        from vibcli.mechanics.high_precision import system_to

        found = system_to(self, digits)
        if self.spec.get("damping") is None:
            return found
        from vibcli.mechanics.given_damping import with_damping

        return with_damping(found, self.given_damping(digits))

    @cached_property
    def bent_pieces(self) -> dict[tuple[str, int], Any]:
        """{(member, number of a piece): its deflection at rest} as far as they were asked for."""
        return {}

    @cached_property
    def bounded_rest(self) -> "tuple[RunningErrors, dict[str, float | Rounded]]":
        """An arithmetic of bounded numbers, and {symbol: number with the bound of its error} of everything at rest."""
        from vibcli.mechanics.bounded_rest import bounded_rest

        return bounded_rest(self)

    @cached_property
    def bounded_matrices(self) -> "list[dict[tuple[int, int], Rounded]]":
        """M, C, G, K, each {(i, j): number with the bound of its error}."""
        from vibcli.mechanics.bounded_rest import bounded_matrices

        return bounded_matrices(self)

    @cached_property
    def told_matrices(self) -> Sequence[Mapping[tuple[int, int], float]]:
        """M, C, G, K, each {(i, j): number}, without what rounding left in place of a zero."""
        from vibcli.mechanics.told_zeros import told_matrices

        return told_matrices(self)

    def precise_rest(self, digits: int) -> "tuple[Any, dict[str, mpmath.mpf]]":
        """mpmath's arithmetic, and {symbol: number} of everything at rest, at t = 0, to so many digits."""
        from vibcli.mechanics.high_precision import rest_to

        return rest_to(self, digits)

    def exact_system(self) -> "FactoredSystem | None":
        """The FactoredSystem in Fractions, None where it is irrational or the equilibrium had to be searched for."""
        system = self.system
        if not (self.equilibrium.drawn or system.is_linear) or self.spec.get("damping") is not None:
            return None
        try:
            anywhere = dict.fromkeys(self.scene.coordinates, Fraction(0))
            return in_numbers(self.reference_form, Rationals(), {**self.numeric.rational, **anywhere}).elements
        except (Rationals.Irrational, KeyError, ZeroDivisionError):
            return None

    @property
    def sources(self) -> "tuple[Callable[[int], FactoredSystem] | None, Callable[[], FactoredSystem | None] | None]":
        """Where more digits of the linear system come from, (None, None) where there are none."""
        return (None, None) if self._final else (self.precise_system, self.exact_system)

    @cached_property
    def with_inputs(self) -> "SystemWithInputs":
        """The scene with what drives it as further coordinates, linearised about the equilibrium."""
        from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs

        return SystemWithInputs(self)

    @Stage
    def reactions(self) -> "list[Reaction]":
        """Forces in constraints and supports in equilibrium, by multipliers."""
        from vibcli.mechanics.inputs_outputs.reactions import reactions

        return reactions(self)

    @cached_property
    def reaction_errors(self) -> dict[str, float]:
        """{signal: what a force in constraints and supports in equilibrium is off by at most}."""
        from vibcli.mechanics.inputs_outputs.reactions import reaction_errors

        return reaction_errors(self)

    @cached_property
    def moving_reactions(self) -> "MovingReactions":
        """Forces in constraints and supports during small oscillations."""
        from vibcli.mechanics.inputs_outputs.dynamic_reactions import MovingReactions

        if self.scene.pieces:
            raise PhysicsError("reactions in motion are not told where members have inertia of their own",
                               "ask for what members bear, as in rod.force(0 m); for reactions in equilibrium with "
                               "find: [reactions]")
        return MovingReactions(self)
