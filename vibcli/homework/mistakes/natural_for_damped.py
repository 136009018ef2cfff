"""The natural frequency or period for the damped one."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import QuantityRef

INSTEAD = {"omega_d": "omega", "period_d": "period"}


def _wrong(asked: "QuantityRef") -> str | None:
    return f"{INSTEAD[asked.head]}[{asked.indices[0]}]" if asked.head in INSTEAD else None


MISTAKE = CommonMistake("this is the value without the dampers, which take ω to ω√(1 − ζ²)", formula=_wrong)
