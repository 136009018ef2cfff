"""What closed forms are: frequencies, shapes and damping as expressions."""

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.nested_form import letters

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

ROUNDED = 10**12    # a denominator of numbers that stand for roots
READABLE, LONGEST = 50, 100     # letters in all amplitudes of a mode, and of an expression, above which it is not read


class ClosedMode(NamedTuple):
    """One mode. index: its number, from 1, at the sample values; square: ω²; omega: ω, or the growth rate √(−ω²) where
    `unstable`; shape: amplitudes by coordinate with the first that moves 1, or None; pattern: the same as functions of
    ω where that is shorter, and `turns` where the second is a quarter period apart from the first; zeta, omega_d:
    damping ratio and damped frequency, or None; zeta_pattern: ζ as a function of ω where that is shorter; error:
    what rounds in a number within ω, relative; pair: the surds.Pair that it shares with the other root of its
    quadratic equation, or None; solves: the solutions.Turning of a gyroscopic mode whose ω is itself a root."""

    square: Any
    omega: Any
    shape: "list[Node] | None" = None
    unstable: bool = False
    pair: Any = None
    index: int = 1  # type: ignore[assignment]
    pattern: "list[Node] | None" = None
    turns: bool = False
    solves: Any = None
    zeta: Any = None
    omega_d: Any = None
    zeta_pattern: Any = None
    error: float = 0.0

    @property
    def period(self) -> Any:
        """2π/ω, with a number of fifteen digits where ω has one."""
        found = 2 * self.omega.table.pi / self.omega
        value = Fraction(found.coefficient)
        return found.table.scaled(found, Fraction(f"{float(value):.15g}") / value) if (
            value.denominator > ROUNDED) else found

    @property
    def readable(self) -> bool:
        return self.shape is not None and sum(map(letters, self.shape)) <= READABLE

    @property
    def short(self) -> bool:
        return letters(self.omega) <= LONGEST


class ClosedForms(NamedTuple):
    """modes: ascending at the sample values; polynomials: factors in λ = ω² that are not solved, lists of coefficients
    from the highest; critical: (symbol, value) of the damping coefficient for which ζ = 1, or None;
    numbered: of a member, which has modes without end, the ClosedMode by its number, else None."""

    modes: list[ClosedMode]
    polynomials: "list[list[Node]]" = []
    critical: "tuple[Node, Node] | None" = None
    numbered: Any = None
