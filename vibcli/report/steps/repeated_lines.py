"""Lines of a worked solution that say what an earlier one says are left out."""

from collections.abc import Sequence

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.step import WorkedLine


def without_repeats(steps: Sequence[WorkedLine]) -> list[WorkedLine]:
    """The lines, numbered anew; what one that is left out settles beside the earlier one stands with that."""
    of_number: dict[int, list[WorkedLine]] = {}
    for line in steps:
        of_number.setdefault(line.number, []).append(line)
    kept: dict[str, list[WorkedLine]] = {}
    places: dict[int, str] = {}
    for number, lines in of_number.items():
        said = formula([part for line in lines for part in line.parts], plain)
        if said in kept:
            settled = {"", *(line.settles for line in kept[said])}
            kept[said] += [line._replace(parts=()) for line in lines if line.settles not in settled]
        else:
            kept[said] = lines
        places[number] = said
    numbers = {said: i for i, said in enumerate(kept, 1)}
    return [line._replace(number=i, uses=tuple(sorted({numbers[places[use]] for use in line.uses} - {i})))
            for i, lines in enumerate(kept.values(), 1) for line in lines]
