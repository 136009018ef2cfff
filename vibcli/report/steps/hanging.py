"""The line on the general solution of a string whose tension varies evenly (Rao 2007, section 8.4)."""

from typing import TYPE_CHECKING

from vibcli.report.blocks import Name, Words
from vibcli.report.own_letters import own_letters
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.hanging_strings import HangingString
    from vibcli.scene.scene import Scene


def general_solution(sheet: WorkedSolution, found: "HangingString", scene: "Scene", uses: list[int]) -> int:
    """X = C₁ J₀(ζ) + C₂ Y₀(ζ), J₀ alone where the tension ends at zero, and ω² by z: its number."""
    table, second = found.omega.table, []
    call, along = table.call, found.along(table.parameter(own_letters(scene).place))
    if found.sigma is not None:
        second = [" + ", Name(sheet.letter("C2")), "·", call("Y0", along)]
    why = "" if second else ", J₀ alone finite where the tension ends"
    return sheet.write(Words("standing waves  "), "X(x)·sin(ω·t + ε)", Words(f"  are Bessel's functions{why}:  "),
                       "X = ", Name(sheet.letter("C1")), "·", call("J0", along), *second, Words(",  "),
                       found.omega ** 2, " = ", found.square, settles="X", uses=uses)
