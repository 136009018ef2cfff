"""Why the motion of members is not followed by modes."""

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves


class NotByModes(NotByWaves):
    """A system whose motion is not followed by modes, with the reason."""


class ShakenSupports(NotByModes):
    """A system whose modes are damped beside driven supports."""


class CoupledModes(NotByModes):
    """A system whose modes do not move each by itself."""
