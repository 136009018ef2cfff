"""The kind of a solution: what must be the same in all variants, so that one worked solution is true of all."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


class Regime(NamedTuple):
    """natural: the kind of each mode without dampers (rigid, oscillation, divergence, flutter); damped: that of each
    damped one; rests: how many equilibria there are, None where they are not asked; refusal: why there are no modes."""

    natural: tuple[str, ...]
    damped: tuple[str, ...]
    rests: int | None
    refusal: str | None = None

    def told(self, other: "Regime") -> str:
        """How another one differs from it, in words."""
        if other.refusal is not None and self.refusal is None:
            return other.refusal
        for name, one, its in (("modes without dampers", self.natural, other.natural),
                               ("damped modes", self.damped, other.damped)):
            if one != its:
                return f"{name}: {_counted(its)}, where the scene itself has {_counted(one)}"
        if self.rests != other.rests:
            return f"{other.rests} equilibria, where the scene itself has {self.rests}"
        return other.refusal or "the scene itself has no modes"


def regime(problem: "Problem", rests: bool) -> Regime:
    """The Regime of a scene with numbers; `rests`: with the number of its equilibria."""
    count = len(problem.equilibria.items) if rests else None
    try:
        natural = tuple(mode.kind for mode in problem.modal.modes.shown())
        damped = problem.modal.damped
        kinds = () if damped is None else tuple(mode.kind for mode in damped.shown())
    except (SpecError, PhysicsError) as error:
        return Regime((), (), count, error.message if isinstance(error, PhysicsError) else str(error))
    return Regime(natural, kinds, count)


def _counted(kinds: tuple[str, ...]) -> str:
    if not kinds:
        return "none"
    return ", ".join(f"{kinds.count(kind)} × {kind}" for kind in dict.fromkeys(kinds))
