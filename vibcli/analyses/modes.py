"""Which modes are asked for: so many, those from one number to another, or all up to a frequency."""

from typing import Any

from vibcli.analyses.modal.mode_sequence import MOST
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, OneOf, WholeNumber
from vibcli.language.signal_kinds import FrequencyField

LAST = 100_000       # number of a mode


class NumberRange(Many):
    """Two numbers of modes, the second not before the first and not too far after it."""

    __slots__ = ()

    def read(self, node: Any, reader: Any) -> list[int] | None:
        found: list[int] | None = super().read(node, reader)
        if found is not None and not 0 <= found[1] - found[0] < MOST:
            far = found[1] > found[0]
            reader.report(node.where, f"these are {found[1] - found[0] + 1} modes, more than {MOST}" if far else
                          f"mode {found[1]} stands before mode {found[0]}",
                          "ask for fewer at once" if far else f"write [{found[1]}, {found[0]}]")
            return None
        return found


ELEMENT = Element(
    "choice of modes",
    "Which natural frequencies and mode shapes are found and printed. Modes are numbered from 1: unstable ones first, "
    "then rigid-body modes, then the others by ascending frequency. Where there are fewer, fewer are printed. If "
    "nothing is said, all are printed; of members with distributed inertia, which have modes without end, and of more "
    "than 2000 coordinates, the unstable ones, the rigid ones and five more. Of more than 2000 coordinates the lowest "
    "are found (a fourth of all at most), none missed by a count of signs; what needs matrices of them all is refused.",
    {
        "numbers": Field(OneOf("how many modes, or two numbers [from, to]",
                               scalar=WholeNumber(MOST),
                               sequence=NumberRange(WholeNumber(LAST), 2, 2, "two numbers [from, to]")),
                         "so many of the lowest, or those from one number to another"),
        "up_to": Field(FrequencyField("Hz"), "all up to this frequency, those that grow or rest included"),
    },
    short="numbers",
    exclusive=(("numbers", "up_to"),),
    needs=(("numbers", "up_to"),),
    example="many_modes",
)
