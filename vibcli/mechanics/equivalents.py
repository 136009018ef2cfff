"""The pair of perpendicular springs or dampers that resists like several at one place, in numbers with their bounds.

Eigenvalues of a symmetric tensor move by no more than the norm of its error (Weyl); half its double angle 2α moves by
asin of that error over half the difference of the eigenvalues.
"""

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.concurrent import Concurrent, isotropic, tensor
from vibcli.mechanics.nonsmooth import jumps
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in, number_in

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.configuration import Configuration

HALF = Fraction(1, 2)
HALVED = 0.5


class Equivalent(NamedTuple):
    """Numbers with their bounds: entries in x and y, `middle` = ½ (kmax + kmin), `half` = ½ (kmax − kmin), twice the
    angle; `elements` that it stands for."""

    xx: Any
    xy: Any
    yy: Any
    middle: Any
    half: Any
    double_angle: Any
    elements: "list[Concurrent]"

    @property
    def max(self) -> Any:
        """The largest stiffness of all directions."""
        return self.middle + self.half

    @property
    def min(self) -> Any:
        """The least, which is across."""
        return self.middle + -1 * self.half

    @property
    def isotropic(self) -> bool:
        """Do all directions agree, but for rounding?"""
        return not number_in(self.half) > error_in(self.half)

    @property
    def angle(self) -> Any:
        """That of the stiffest direction in (−π/2, π/2]; PhysicsError where there is none."""
        if self.isotropic:
            raise isotropic(self.elements)
        return self.double_angle * HALVED


def equivalent(configuration: "Configuration", elements: "list[Concurrent]", digits: int | None = None,
               unit: float = 2.0**-52) -> Equivalent:
    """That of springs or dampers at a place, in equilibrium."""
    arithmetic, values = _rest(configuration, digits, unit)
    for one in elements:
        if any(jumps(configuration, node) for node in (one.kappa, one.around)):
            raise PhysicsError(f"'{one.name}' has a kink in the equilibrium: its stiffness is another one to each side",
                               "ask for its force, or move the equilibrium off the kink")
    try:
        xx, xy, yy = evaluate([*tensor(elements)], arithmetic, values)
    except ZeroDivisionError:
        raise PhysicsError("the ends of an element meet in equilibrium: it has no direction there",
                           "let it end elsewhere") from None
    inner, off = arithmetic.inner, error_in(xx) + error_in(yy) + error_in(xy)
    difference, middle = xx + -1 * yy, (xx + yy) * HALVED
    u, v = number_in(difference), 2 * number_in(xy) + 0         # −0 turns to 0
    half = inner.power(u * u + v * v, HALF) / 2
    return Equivalent(xx, xy, yy, middle, Rounded(half, off + 4 * arithmetic.unit * half, arithmetic.unit),
                      _double_angle(inner, u, v, half, off, arithmetic.unit), elements)


def _double_angle(inner: Any, u: "float | mpmath.mpf", v: "float | mpmath.mpf", half: "float | mpmath.mpf",
                  off: "float | mpmath.mpf", unit: float) -> Rounded | None:
    """That of a tensor with 2 kxy = v, kxx − kyy = u; π, not −π, where only rounding tells them apart."""
    if not half > off:
        return None
    found = inner.functions["atan2"](v, u)
    if u < 0 and abs(v) <= 2 * off:
        found = abs(found)
    return Rounded(found, 2 * off / half + 4 * unit * abs(found), unit)      # asin x ≤ 2x


def share_axes(K: Equivalent, C: Equivalent) -> bool:
    """Do two pairs have the same axes, but for rounding: is K C symmetric?"""
    twist = K.xy * (C.xx + -1 * C.yy) + -1 * (C.xy * (K.xx + -1 * K.yy))
    return not abs(number_in(twist)) > error_in(twist)


def _rest(configuration: "Configuration", digits: int | None,
          unit: float) -> "tuple[RunningErrors, dict[str, float | mpmath.mpf | Rounded]]":
    if digits is None:
        return configuration.bounded_rest
    inner, values = configuration.precise_rest(digits)
    return RunningErrors(inner, unit), values


def size(configuration: "Configuration", elements: "list[Concurrent]") -> float:
    """Σ |κ| + 2 |N/l|: what rounding is measured by."""
    found = evaluate([node for one in elements for node in (one.kappa, one.around)], Floats, configuration.at_rest)
    result: float = sum(map(abs, found[::2])) + 2 * sum(map(abs, found[1::2]))
    return result
