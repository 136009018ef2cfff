"""Stages of a Problem in time: where its motion starts, and the motion, of small oscillations or in full."""

from functools import cached_property

from vibcli.results.stage import Stage


class InTime:
    """The part of a Problem that moves."""

    @cached_property
    def before(self):
        """The Problem under the force that lets go at t = 0; None where none does."""
        from vibcli.language.sections.initial import let_go

        if let_go(self.spec) is None or self.holding is not None:
            return None
        return self.held_back()

    @cached_property
    def given_start(self):
        """{coordinate, or velocity x': value} of what `initial` gives, or of the equilibrium from which it lets go."""
        from vibcli.mechanics.initial_state import given_start

        return given_start(self)

    @Stage
    def start(self):
        """({coordinate: value}, {coordinate: velocity}) at t = 0."""
        from vibcli.mechanics.initial_state import start

        return start(self)

    @Stage
    def motion(self):
        """The motion in time, as `motion:` of the file says."""
        from vibcli.results import responses

        if not self.scene.q and self.scene.timed:
            from vibcli.results.prescribed_motion import PrescribedMotion

            return PrescribedMotion(self)
        kind = self.spec.get("motion")
        if kind is None and self.scene.laws:
            raise responses.nonlinear(self.spec, self.scene.laws[0].owner)
        if kind == "full":
            from vibcli.results.full_response import FullMotion

            return FullMotion(self)
        return responses.SmallMotion(self)
