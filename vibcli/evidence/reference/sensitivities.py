"""∂ω/∂p to many digits: the frequencies of two scenes of which p differs by a little, each at rest where it then rests,

    ∂ω/∂p = (ω(p + h) − ω(p))/h,

from their element data; h falls with the digits. Frequencies that coincide split as p grows.
"""

from fractions import Fraction
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import modal
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.high_precision import in_its_place
from vibcli.symbolic.evaluation import multiprecision

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

DIGITS, START, LIMIT = 28, 60, 240


def sensitivity(configuration: Configuration, number: int, name: str) -> TrueValues:
    """That of a natural frequency, counted from 1; about: ω/p, or it, where that is larger."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        arithmetic = multiprecision()
        p = configuration.numeric.values(arithmetic)[name]
        size = abs(p) or mpmath.mpf(1)
        h = size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
        before, after = (_frequency(configuration, {name: rational(x)}, number) for x in (p, p + h))
        rate = (after - before) / h
        nothing = abs(rate) * size <= before * mpmath.mpf(10) ** (-mpmath.mp.dps // 3)
        return [mpmath.mpf(0) if nothing else rate], max(abs(rate), before / size)

    return settled(found, DIGITS, START, LIMIT, sized=True)


def rational(x: Any) -> Fraction:
    """A number of mpmath as it is."""
    return Fraction(*map(int, mpmath.libmp.to_rational(x._mpf_)))


def _frequency(configuration: Configuration, given: dict[str, Fraction], number: int) -> mpmath.mpf:
    """ω of a mode where parameters have these values, at the working precision."""
    found = modal.rates_at_once(lambda digits: undamped(_precise(configuration, given, digits)))
    known = sorted(found, key=mpmath.im)
    if mpmath.re(known[number - 1]) or not mpmath.im(known[number - 1]):
        raise PhysicsError("no reference is found of what does not oscillate")
    return mpmath.im(known[number - 1])


def _precise(configuration: Configuration, given: dict[str, Fraction], digits: int) -> "FactoredSystem":
    """Element data where it then rests: begun from as it is drawn, where that is its equilibrium."""
    numeric, near = configuration.numeric.sharing(given), configuration.equilibrium
    if near.drawn and not configuration.system.is_linear:
        with mpmath.workdps(digits):
            arithmetic = multiprecision()
            near = near._replace(drawn=False, values=in_its_place(
                configuration.scene.resting.drawn, numeric.values(arithmetic), arithmetic))
    return Configuration(numeric, near).precise_system(digits)


def undamped(elements: "FactoredSystem") -> Any:
    """The same without dampers and drag."""
    return elements.with_parts(dampers=(), C={}, drag={})
