"""The modes that are printed: those that the command or the file asks for, else all, or the first of those without
end."""

from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.modal.mode_sequence import Selection
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.reader.sections.find import MODES
from vibcli.report.wanted import Wanted

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedForms, ClosedMode
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem

UNASKED = 5         # frequencies of a member in letters where nobody says how many


def lowest(count: int) -> Selection:
    """The Selection of so many modes."""
    return Selection(last=count)


def selection(problem: "Problem", wanted: Wanted | None = None) -> Selection | None:
    """The Selection that is asked for; None where nobody says which."""
    if wanted is not None and wanted.modes is not None:
        return wanted.modes
    record = _written(problem)
    if record is None:
        return None
    if "up_to" in record:
        return Selection(up_to=_highest(problem, record["up_to"]))
    numbers = record["numbers"]
    return Selection(last=numbers) if isinstance(numbers, int) else Selection(*numbers)


def _written(problem: "Problem") -> "Record | None":
    """The Record of the modes that the file asks for, or None."""
    find = problem.spec.get("find")
    return cast("Record | None", find.about(MODES) if find is not None else None)


def _highest(problem: "Problem", asked: Any) -> Any:
    """The angular frequency up to which modes are asked for."""
    from vibcli.quantities.expression import number_of

    found = number_of(problem, asked.tree)
    if found < 0:
        raise SpecError([Diagnostic(asked.where, f"'{asked.text}' is negative, and no mode has such a frequency",
                                    "mind the signs")])
    return found


def in_letters(problem: "Problem", wanted: Wanted | None, forms: "ClosedForms") -> "list[ClosedMode]":
    """The modes that are printed of a member in letters, whose frequencies have no number to be up to."""
    asked = selection(problem, wanted)
    if asked is None or not asked.last:
        return [forms.numbered(number) for number in range(1, UNASKED + 1)]
    return [forms.numbered(number) for number in range(asked.first, asked.last + 1)]


def shown(problem: "Problem", wanted: Wanted | None = None, modes: "Modes | None" = None) -> "list[Mode]":
    """The undamped modes that are printed, of `modes` where those are found to more digits."""
    modes, asked = problem.modal.modes if modes is None else modes, selection(problem, wanted)
    try:
        found = modes.shown(asked)
        if not found and modes and asked is not None:
            raise _none(modes, asked)
        return found
    except PhysicsError as refusal:
        record = _written(problem)
        written = record is not None and (wanted is None or wanted.modes is None) and "up_to" in record
        raise (refusal.told(record["up_to"].where) if written else refusal) from None


def _none(modes: Any, asked: Any) -> PhysicsError:
    if asked.up_to is None:
        from vibcli.quantities.quantity import counted

        return PhysicsError(f"there is no mode {asked.first}: this scene has {counted(len(modes), 'mode')}",
                            "ask for one that it has")
    return PhysicsError(f"there is no mode up to {asked.up_to:.6g} rad/s: the first one has ω = "
                        f"{float(modes[0].omega):.6g} rad/s", "ask for those up to a higher frequency")


def shown_damped(problem: "Problem", wanted: Wanted | None = None,
                 modes: "Modes | None" = None) -> "list[DampedMode] | None":
    """The damped modes that are printed; None where nothing damps."""
    modes = problem.modal.damped if modes is None else modes
    return None if modes is None else modes.shown(selection(problem, wanted))
