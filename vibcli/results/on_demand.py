"""Stages of a Problem that run only where asked for: all equilibria, reactions, shares, derivatives, estimates."""

from functools import cached_property

from vibcli.results.stage import Stage


class OnRequest:
    """The part of a Problem that says more than equations and frequencies."""

    @cached_property
    def sharp_modes(self):
        """The modes to the digits that shares and derivatives need."""
        from vibcli.analyses.modal.modes_precise import sharp_modes

        return self.named(sharp_modes, self)

    @cached_property
    def sharp_damped(self):
        """The damped modes to as many digits; asked for only where something damps."""
        from vibcli.analyses.modal.modes_precise import sharp_damped

        return self.named(sharp_damped, self)

    @Stage
    def equilibria(self):
        """All equilibria within the bounds of the file, or within default ones."""
        from vibcli.mechanics.equilibrium.all_equilibria import find_equilibria

        return find_equilibria(self)

    @cached_property
    def about_each(self):
        """The Problems about all equilibria."""
        from vibcli.mechanics.equilibrium.degenerate import about

        return [about(self, item) for item in self.equilibria.items]

    @cached_property
    def sticking(self):
        """Where dry friction holds the scene at rest; None where nothing does."""
        from vibcli.mechanics.equilibrium.dry_friction import sticking

        return sticking(self)

    @Stage
    def reactions(self):
        """Forces in constraints and supports in equilibrium, by multipliers."""
        from vibcli.mechanics.inputs_outputs.reactions import reactions

        return reactions(self)

    @cached_property
    def opened(self):
        """The scene with what drives it as further coordinates, linearised about the equilibrium."""
        from vibcli.mechanics.inputs_outputs.base_excitation import Opened

        return Opened(self)

    @cached_property
    def moving_reactions(self):
        """Forces in constraints and supports during small oscillations."""
        from vibcli.mechanics.inputs_outputs.dynamic_reactions import MovingReactions

        return MovingReactions(self)

    @Stage
    def shares(self):
        """Whose energy the modes have."""
        from vibcli.analyses.modal.energy_shares import shares

        return shares(self)

    @Stage
    def sensitivities(self):
        """Derivatives of frequencies and damping ratios by the parameters."""
        from vibcli.analyses.modal.sensitivities import sensitivities

        return sensitivities(self)

    @Stage
    def estimates(self):
        """Estimates of the lowest frequency by Rayleigh and Dunkerley."""
        from vibcli.analyses.modal.estimates import estimates

        return estimates(self)

    def frequency_response(self, signal, driver):
        """The FrequencyResponse of a signal to an input."""
        from vibcli.results.frequency_response import FrequencyResponse

        known = self.__dict__.setdefault("_curves", {})
        if (signal, driver) not in known:
            known[signal, driver] = FrequencyResponse(self, signal, driver)
        return known[signal, driver]
