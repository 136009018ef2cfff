"""The backbone curve: the angular frequency of free motions over their amplitude."""

from vibcli.analyses.modes import LAST
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity, WholeNumber
from vibcli.language.signal_kinds import SignalField

ELEMENT = Element(
    "backbone",
    "How the frequency of free motions about the equilibrium hangs on their amplitude, which is half the range of a "
    "signal. Dampers are left out. With one degree of freedom each motion is found from its energy by "
    "quadrature; with several as a sum of harmonics that obey the equations of motion, followed from a mode of small "
    "vibrations. No expansion is used; the family ends where a motion passes a top of the potential energy.",
    {
        "of": Field(Many(SignalField(), 1, 1, "a list of one signal"), "the signal; the coordinate if left out"),
        "up_to": Field(Quantity(), "the largest amplitude of that signal", required=True),
        "mode": Field(WholeNumber(LAST), "the mode at which the family starts; the first if left out"),
    },
    example="swing_by_amplitude",
)


class BackbonePoint(NamedTuple):
    """A free motion: the amplitude of the signal, ω [rad/s], its energy above that of the equilibrium [J] and the bound
    of the relative error of ω."""

    amplitude: float
    omega: float
    energy: float
    error: float


class Backbone(NamedTuple):
    """Motions of one family, in the order in which it passes them; `resonance`: where another mode comes in, told, or
    None."""

    points: list[BackbonePoint]
    resonance: str | None
