"""The damped frequency or period for the natural one."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import QuantityRef

INSTEAD = {"omega": "omega_d", "period": "period_d"}


def _wrong(asked: "QuantityRef") -> str | None:
    return f"{INSTEAD[asked.head]}[{asked.indices[0]}]" if asked.head in INSTEAD and len(asked.indices) == 1 else None


MISTAKE = CommonMistake("this is the value with the dampers, and the natural one is asked", formula=_wrong)
