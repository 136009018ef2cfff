"""Stages of a Problem that keep its letters: matrices, equilibrium, energies, equations, closed forms."""

from contextlib import suppress
from fractions import Fraction
from functools import cached_property

from vibcli.base.errors import NotInLetters
from vibcli.results.stage import Stage


class InLetters:
    """The part of a Problem that answers in letters."""

    @property
    def letters(self):
        """The parameters that have neither a value nor a condition."""
        return [name for name in self.scene.parameters.free if name not in self.given and name not in self.spec.choices]

    @cached_property
    def matrices_in_letters(self):
        """M, C, G, K of the small oscillations in letters."""
        from vibcli.mechanics.nonsmooth import require_unheld
        from vibcli.mechanics.symbolic_matrices import matrices_in_letters

        require_unheld(self)
        if self.scene.timed:
            from vibcli.mechanics.autonomous import require_autonomous
            from vibcli.scene.closed_loops import drawn_values

            require_autonomous(self, drawn_values(self.scene))
        self._require_held()
        found = matrices_in_letters(self.letters_form)
        if self.equilibrium_letters is not None:
            from vibcli.symbolic.rational_functions import factored as shorter
        else:
            from vibcli.symbolic.common_denominator import shorter
        with self.work.task("the matrices in letters"):
            return tuple({pair: shorter(node) for pair, node in matrix.items()} for matrix in found)

    def _require_held(self):
        """PhysicsError where a load drives what nothing holds, so that there is no equilibrium to oscillate about."""
        if self.symbolic and self.is_linear and not self.balanced_as_drawn:
            from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters

            with suppress(NotInLetters):
                equilibrium_in_letters(self)

    @cached_property
    def linear_in_letters(self):
        """Can the small oscillations be written in letters: is the equilibrium known, or does its place not matter?"""
        return self.is_linear or self.balanced_as_drawn or self.equilibrium_letters is not None

    @property
    def letters_form(self):
        if self.balanced_as_drawn or self.is_linear:
            return self.drawn_form if self.balanced_as_drawn else self.form
        from vibcli.mechanics.linearisation import at_position

        return at_position(self.form, self.equilibrium_letters.position(self.form))

    @cached_property
    def equilibrium_letters(self):
        """The Settled equilibrium of a nonlinear scene with letters that is not the drawn position; None where none is
        found."""
        if not self.symbolic or self.balanced_as_drawn or self.is_linear:
            return None
        from vibcli.mechanics.symbolic_equilibrium import settled

        with self.work.task("the search for the equilibrium in letters"):
            return settled(self)

    @cached_property
    def start_in_letters(self):
        """{symbol: expression} of the position that `equilibrium:` names; None where it is the drawn one."""
        from vibcli.symbolic.normal_form import is_zero

        scene = self.scene
        named = {scene.symbol(name): node for name, node in self.named_start.items()}
        moved = any(not is_zero(node - scene.drawn[q]) for q, node in named.items())
        return {**{q: scene.drawn[q] for q in scene.q}, **named} if moved else None

    @cached_property
    def balanced_as_drawn(self):
        """Is the equilibrium the drawn position? (Of linear equations its place does not matter.)"""
        if self.symbolic:
            from vibcli.mechanics.symbolic_equilibrium_linear import vanishes

            drawn = all(vanishes(self.scene, terms) for terms in self.drawn_residual)
            return drawn and (self.is_linear or self.start_in_letters is None)
        return self.equilibrium.drawn

    @cached_property
    def excitation(self):
        """{i: Q(t)}: what drives coordinate i of the small oscillations, in letters, with numbers for the place of an
        equilibrium that is not the drawn one."""
        from vibcli.mechanics.autonomous import excitation

        if not self.scene.timed:
            return {}
        scene, place = self.scene.vibrating, self.excitation_place
        found = excitation(scene, self.timed_form, place)
        if scene is not self.scene:
            from vibcli.mechanics.inputs_outputs.constraint_excitation import excitation_through

            for i, node in excitation_through(self).items():
                found[i] = found.get(i, scene.table.zero) + node
        return found

    @cached_property
    def left_out(self):
        """{i: products that the left side of equation i of the small oscillations lacks}."""
        if not self.scene.timed:
            return {}
        from vibcli.mechanics.neglected_products import left_out

        return left_out(self)

    @property
    def excitation_place(self):
        """{symbol: node} of the position about which loads in time act."""
        self.form  # noqa: B018
        scene, settled = self.scene.vibrating, self.equilibrium_letters
        if settled is not None:
            return settled.position(self.timed_form)
        if self.linear_in_letters or self.symbolic:
            return scene.drawn_position
        return {q: scene.table.number(Fraction(self.equilibrium.values[q.name])) for q in scene.drawn}

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
        from vibcli.analyses.closed_form.modes import closed_forms

        with self.work.task("the search for closed forms"):
            return closed_forms(self)
