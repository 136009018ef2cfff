"""What may be asked of a motion in time."""

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Quantity
from vibcli.language.signal_kinds import SIGNALS

ELEMENT = Element(
    "response",
    "The motion in time: which signals, and until when.",
    {
        "of": Field(SIGNALS, "the signals; the coordinates if left out"),
        "until": Field(Quantity("s"), "the end of the motion; some periods, or until it has died out, if left out"),
    },
    example="bump_in_the_road",
)
