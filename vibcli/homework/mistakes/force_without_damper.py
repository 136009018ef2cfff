"""What passes to the ground without the part of the damper, √(1 + (2ζr)²)."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import QuantityRef


def _wrong(asked: "QuantityRef") -> str | None:
    if asked.head != "transmissibility" or not asked.args:
        return None
    place = asked.text.rpartition("](")[2][:-1]
    return f"{asked.text}/sqrt(1 + (2*zeta[1]*({place})/omega[1])^2)"


MISTAKE = CommonMistake("the damper passes a force on, too: √(1 + (2ζr)²) in the numerator", formula=_wrong,
                        single=True)
