"""The natural frequency for the frequency of the largest amplitude."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import QuantityRef


def _wrong(asked: "QuantityRef") -> str | None:
    return f"omega[{asked.indices[0]}]" if asked.head == "peak" and asked.component == "Omega" else None


MISTAKE = CommonMistake("this is the natural frequency: the largest amplitude comes at another one", formula=_wrong)
