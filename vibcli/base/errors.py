"""Errors and where they are: places in a file, diagnostics, physical refusals."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from typing import TypeVar

    T = TypeVar("T")


class Where(NamedTuple):
    """A place in a file; line and column count from 1."""

    file: str
    line: int
    column: int
    width: int = 1

    def shifted(self, offset: int, width: int = 1) -> "Where":
        """The place `offset` characters further along the same line."""
        return Where(self.file, self.line, self.column + offset, width)


class Diagnostic:
    """One thing wrong with the input: where, what, and what to write instead."""

    __slots__ = ("hint", "message", "where")
    WORD = "error"

    def __init__(self, where: Where | None, message: str, hint: str | None = None) -> None:
        self.where, self.message, self.hint = where, message, hint

    def __repr__(self) -> str:
        where = self.where
        place = "-" if not where else f"{where.line}:{where.column}" if where.width else where.file
        return f"{place}: {self.message}" + (f" (hint: {self.hint})" if self.hint else "")


class Remark(Diagnostic):
    """One thing of the input that is no error, and may be meant otherwise."""

    __slots__ = ()
    WORD = "warning"


class SpecError(Exception):
    """The input is invalid; carries every diagnostic that was found. Exit code 3."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__("\n".join(map(repr, diagnostics)))
        self.diagnostics = list(diagnostics)


class PhysicsError(Exception):
    """The scene is well written but has no such answer, for a physical cause. Exit code 4."""

    def __init__(self, message: str, hint: str | None = None, where: Any = None) -> None:
        super().__init__(message)
        self.message, self.hint, self.where = message, hint, where

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """The refusal as what is wrong with an input is told: the same for both kinds of errors."""
        return [Diagnostic(self.where, self.message, self.hint)]

    def told(self, where: Where | None = None, hint: str | None = None) -> "PhysicsError":
        """The same refusal at a place, if it has none, or with another hint: one that is kept is met at many."""
        found = type(self).__new__(type(self), *self.args)
        PhysicsError.__init__(found, self.message, hint or self.hint, self.where or where)
        return found


class NotFixed(PhysicsError):
    """A force that is one of several which share a load in any proportion: its name is told."""

    CELL = "not fixed by statics"

    def __init__(self, text: str, cause: str = "the scene is supported by more than it needs",
                 hint: str = "take a redundant support out") -> None:
        super().__init__(f"statics alone does not fix '{text}': {cause}", hint)


class Unknown(PhysicsError):
    """Of what is asked for a part is known, and stands: the rest is not."""


class LostDigits(PhysicsError):
    """Floats lose all digits of an answer, which more digits may find."""


class NotInLetters(PhysicsError):
    """There is such an answer, but it is not found in letters: a remark where other answers stand beside it."""


class Kinked(PhysicsError):
    """There are no small oscillations, as friction or a stop has no slope at rest: a remark beside equations."""


class Inertless(PhysicsError):
    """Nothing has inertia, so that nothing vibrates: a remark beside the equations of equilibrium."""

    def __init__(self) -> None:
        super().__init__("nothing in the scene has inertia: nothing can vibrate", "give a mass")


class NoEquilibrium(PhysicsError):
    """No equilibrium is reached, as where nothing holds the scene: a remark beside equations and accelerations."""


def defined_as_drawn(function: "Callable[..., T]", *args: Any) -> "T":
    """The result of a function; a refusal where an expression divides by zero in the drawn position."""
    try:
        return function(*args)
    except ZeroDivisionError:
        raise PhysicsError("the energies are not defined in the drawn position, at rest: something divides by zero "
                           "there", "draw the scene elsewhere, or say what its coordinates are as drawn") from None


class NoBound(PhysicsError):
    """A number whose error has no bound that is known."""

    CELL = "no bound"


class NoDigit(NoBound):
    """A number whose error has a bound that is as large as all that the number is one of."""

    CELL = "not known"
