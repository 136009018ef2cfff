"""Functions of a place in closed form, as numerics take loads along pieces."""

from typing import TYPE_CHECKING, Any

from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Forcing


def load_form(given: "Forcing", channel: int, end: Any) -> LoadForm:
    """A channel of a Forcing over the place, up to an end."""
    segments = given.segments(end)
    ends = [*(one.start for one in segments[1:]), end]
    return LoadForm(tuple(LoadStretch(one.start, last, one.start, tuple(
        LoadTerm(*wave[1:]) for wave in one.waves if wave.channel == channel and wave.coefficient))
        for one, last in zip(segments, ends, strict=True)))
