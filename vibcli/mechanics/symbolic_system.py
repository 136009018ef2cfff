"""The small oscillations of a scene in letters: equilibrium, matrices, excitation, equations of motion."""

from collections.abc import Callable
from contextlib import suppress
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, defined_as_drawn
from vibcli.base.stage import Stage
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.inputs_outputs.symbolic_reactions import SymbolicForces
    from vibcli.mechanics.lagrange import EquationsOfMotion
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.mechanics.symbolic_equilibrium import SymbolicEquilibrium
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class SymbolicSystem:
    """A Configuration in letters. `modal_of`: what finds the modes of a Configuration, by which the stable equilibria
    are told from the others."""

    def __init__(self, configuration: "Configuration",
                 modal_of: "Callable[..., ModalAnalysis] | type[ModalAnalysis]") -> None:
        self.configuration, self.modal_of = configuration, modal_of
        self.numeric, self.system, self.spec = configuration.numeric, configuration.system, configuration.spec
        self.work, self.costs = configuration.work, configuration.costs

    @cached_property
    def scene(self) -> "Scene":
        return self.system.scene

    @cached_property
    def preloaded(self) -> "SymbolicSystem | None":
        """The same under the force that lets go at t = 0; None where none does."""
        held = self.configuration.preloaded
        return None if held is None else SymbolicSystem(held, self.modal_of)

    @property
    def letters(self) -> list[str]:
        """The parameters that have neither a value nor a condition."""
        return [name for name in self.scene.parameters.free
                if name not in self.numeric.given and name not in self.spec.choices]

    @property
    def matrices(self) -> Any:
        """M, C, G, K of the small oscillations; NotInLetters with members, whose motions no matrix holds."""
        if self.scene.pieces:
            raise NotInLetters("what vibrates with distributed inertia has no matrices: its frequency equation is "
                               "written out, its numbers follow from that",
                               hint="give the parameters values with --set")
        return self.discrete_matrices

    @cached_property
    def discrete_matrices(self) -> Any:
        """M, C, G, K of what is no member."""
        from vibcli.mechanics.nonsmooth import require_unheld
        from vibcli.mechanics.symbolic_matrices import matrices_in_letters

        require_unheld(self.system)
        if self.scene.timed:
            from vibcli.mechanics.autonomous import require_autonomous

            require_autonomous(self.configuration, self.scene.drawn_values)
        self._require_held()
        found = matrices_in_letters(self._written)
        if self.spec.get("damping") is not None and not self.scene.pieces:
            from vibcli.mechanics.given_damping_in_letters import in_letters

            M, C, G, K = found
            found = M, in_letters(self.spec, self.scene, M, C, K), G, K
        if self.equilibrium is not None:
            from vibcli.symbolic.rational_functions import factored as shorter
        else:
            from vibcli.symbolic.common_denominator import shorter
        with self.work.task("the matrices in letters"):
            return tuple({pair: shorter(node) for pair, node in matrix.items()} for matrix in found)

    @property
    def _written(self) -> "Linearisation":
        """The Linearisation without fractions that stand for functions."""
        form, fractions = self.linearisation, self.scene.fractions
        weights = substitute([weight for weight, _ in form.springs], fractions) if fractions else []
        return form._replace(springs=[(weight, row) for weight, (_, row) in zip(weights, form.springs, strict=True)]
                             ) if fractions else form

    def _require_held(self) -> None:
        """PhysicsError where a load drives what nothing holds, so that there is no equilibrium to oscillate about."""
        if self.numeric.has_free_symbols and self.system.is_linear and not self.balanced_as_drawn:
            with suppress(NotInLetters):
                self.equilibrium_position  # noqa: B018

    @cached_property
    def linearisable(self) -> bool:
        """Can the small oscillations be written in letters: is the equilibrium known, or does its place not matter?"""
        return self.system.is_linear or self.balanced_as_drawn or self.equilibrium is not None

    @property
    def linearisation(self) -> "Linearisation":
        """The Linearisation about the equilibrium."""
        system = self.system
        if self.balanced_as_drawn or system.is_linear:
            return system.linearisation_at_reference if self.balanced_as_drawn else system.linearisation
        from vibcli.mechanics.linearisation import at_position

        if self.equilibrium is None:
            raise NotInLetters("the equilibrium of this nonlinear scene is not found in letters",
                               "draw it in equilibrium, or give numbers with --set")
        return at_position(system.linearisation, self.equilibrium.position(system.linearisation))

    @cached_property
    def equilibrium(self) -> "SymbolicEquilibrium | None":
        """The SymbolicEquilibrium of a nonlinear scene with letters that is not the drawn position; None where none is
        found."""
        if not self.numeric.has_free_symbols or self.balanced_as_drawn or self.system.is_linear:
            return None
        from vibcli.mechanics.symbolic_equilibrium import symbolic_equilibrium

        with self.work.task("the search for the equilibrium in letters"):
            return symbolic_equilibrium(self)

    @cached_property
    def equilibrium_position(self) -> "dict[str, Node]":
        """{coordinate: expression} of the equilibrium; PhysicsError where there is none, or none in letters."""
        from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters

        return equilibrium_in_letters(self)

    @cached_property
    def start(self) -> "dict[Node, Node] | None":
        """{symbol: expression} of the position that `equilibrium:` names; None where it is the drawn one."""
        from vibcli.symbolic.normal_form import is_zero

        scene = self.scene
        named = {scene.symbol(name): node for name, node in self.system.named_start.items()}
        moved = any(not is_zero(node - scene.drawn[q]) for q, node in named.items())
        return {**{q: scene.drawn[q] for q in scene.q}, **named} if moved else None

    @cached_property
    def balanced_as_drawn(self) -> bool:
        """Is the equilibrium the drawn position? (Of linear equations its place does not matter.)"""
        if self.numeric.has_free_symbols:
            from vibcli.mechanics.symbolic_equilibrium_linear import vanishes

            drawn = all(vanishes(self.scene, terms) for terms in self.system.drawn_residual)
            return drawn and (self.system.is_linear or self.start is None)
        return self.configuration.equilibrium.drawn

    @cached_property
    def excitation(self) -> "dict[int, Node]":
        """{i: Q(t)}: what drives coordinate i of the small oscillations, in letters, with numbers for the place of an
        equilibrium that is not the drawn one."""
        if not self.scene.timed:
            return {}
        scene, found = self.scene.vibrating, dict(self._excitation_by_loads)
        if scene is not self.scene:
            from vibcli.mechanics.inputs_outputs.constraint_excitation import excitation_through

            for i, node in excitation_through(self).items():
                found[i] = found.get(i, scene.table.zero) + node
        if self.spec.get("damping") is not None and not self.scene.pieces:
            from vibcli.mechanics.given_damping_in_letters import excitation_by_damping

            for i, node in excitation_by_damping(self).items():
                found[i] = found.get(i, scene.table.zero) + node
        return found

    @property
    def _excitation_by_loads(self) -> "dict[int, Node]":
        """That of loads in time and of driven displacements."""
        if self._is_excited_as_drawn:
            return self.system.excitation_as_drawn
        from vibcli.mechanics.autonomous import excitation

        return excitation(self.scene.vibrating, self.system.time_dependent_linearisation, self.excitation_place)

    @cached_property
    def left_out(self) -> "dict[int, Node]":
        """{i: products that the left side of equation i of the small oscillations lacks}."""
        if not self.scene.timed:
            return {}
        from vibcli.mechanics.neglected_products import left_out

        return left_out(self)

    @property
    def excitation_place(self) -> "dict[Node, Node]":
        """{symbol: node} of the position about which loads in time act."""
        scene = self.scene.vibrating
        if self.equilibrium is not None:
            return self.equilibrium.position(self.system.time_dependent_linearisation)
        if self._is_excited_as_drawn:
            return scene.drawn_position
        values = self.configuration.equilibrium.values
        return {q: scene.table.number(fraction_of(values[q.name])) for q in scene.drawn}

    @property
    def _is_excited_as_drawn(self) -> bool:
        """Do loads in time act about the drawn position, or does that place not matter or is not known?"""
        return self.equilibrium is None and (self.linearisable or self.numeric.has_free_symbols)

    @cached_property
    def reactions(self) -> "SymbolicForces":
        """The SymbolicForces in equilibrium, of a scene whose equilibrium is known in letters; else NotInLetters."""
        from vibcli.mechanics.inputs_outputs.symbolic_reactions import symbolic_forces

        if not self.scene.held and self.system.sticking is not None:
            raise NotInLetters("reactions where friction holds a scene are found in numbers", "give numbers with --set")
        with self.work.task("the reactions in letters"):
            return symbolic_forces(self.numeric, place=self.place_of_rest)

    @cached_property
    def place_of_rest(self) -> "dict[str, Node]":
        """{coordinate: expression} of the equilibrium, of what follows from the others too; nothing where that is the
        drawn position; else NotInLetters."""
        if self.scene.held or self.balanced_as_drawn:
            return {}
        if self.scene.hidden:
            raise NotInLetters("reactions where members are deflected at rest are found in numbers",
                               "draw it in equilibrium, or give numbers with --set")
        scene, place = self.scene, self.equilibrium_position
        at = {q: place[q.name] for q in scene.q}
        return place | dict(zip(scene.dependent, substitute(list(scene.dependent.values()), at), strict=True))

    @cached_property
    def accelerations(self) -> Any:
        """The Accelerations from rest in the drawn position."""
        from vibcli.mechanics.accelerations import accelerations

        with self.work.task("the accelerations in letters"):
            return defined_as_drawn(accelerations, self.scene)

    @cached_property
    def forces_from_rest(self) -> "SymbolicForces":
        """The SymbolicForces with these accelerations."""
        from vibcli.mechanics.inputs_outputs.symbolic_reactions import symbolic_forces

        return symbolic_forces(self.numeric, self.accelerations.values)

    @Stage
    def energies(self) -> "dict[str, Node]":
        """T, V and Φ of the scene, brought into the form a textbook prints."""
        from vibcli.mechanics.energies import textbook_energies

        return textbook_energies(self.system.scene_with_multipliers.written)

    @cached_property
    def expanded_equations(self) -> "tuple[list[Node], list[Node]]":
        """The left sides of those to the third order in the deviations from equilibrium, the coordinates counted as
        drawn, and counted from it; PhysicsError where there are none."""
        from vibcli.mechanics.expanded_scene import expanded_equations

        with self.work.task("the expanded equations"):
            return expanded_equations(self)

    @Stage
    def equations(self) -> "EquationsOfMotion":
        """Lagrange's equations, full and for small oscillations."""
        from vibcli.mechanics.lagrange import equations

        return equations(self)
