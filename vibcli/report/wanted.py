"""What a command asks of responses beyond the file: signals, their end, the input, the range, how phases are told."""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.modal.mode_sequence import Selection
    from vibcli.homework.variants import SolvedVariants
    from vibcli.quantities.sweep import Sweep


class Wanted(NamedTuple):
    """signals: Expressions, those of the file if empty; driver: the Expression of an input, or None; phase: sine,
    cosine or lead; low, high: angular frequencies or None; parts: steady, transient, to be shown apart; points: how
    many instants are sampled; at: instants as (text, Fraction of a second), to so many digits; modes: the Selection of
    them, or None; sweep: the Sweep, variants: the SolvedVariants that are told, or None."""

    signals: tuple[Any, ...] = ()
    driver: Any = None
    phase: str = "sine"
    low: float | None = None
    high: float | None = None
    parts: tuple[Any, ...] = ()
    points: int = 1001
    at: tuple[Any, ...] = ()
    digits: int | None = None
    modes: "Selection | None" = None
    sweep: "Sweep | None" = None
    variants: "SolvedVariants | None" = None
