"""What `damping:` gives to the modes of a scene with members, each η̈ + c η̇ + ω² η = φᵀ f by itself:

    modal           c = 2 ζᵢ ω of those that vibrate
    proportional    c = α + β ω²
    caughey         c = a₀ + a₁ ω² + a₂ ω⁴ + … through the modes that are given
"""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.given_damping import given_numbers

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.configuration import Configuration

ALIKE = 1e-12       # relative distance of ω² below which frequencies are one


class MemberDamping(NamedTuple):
    """ratios: ζ by number, whose last holds on; else series: the aₖ. whole: does it resist velocities counted from
    the ground, also where supports are driven, and not those against what these give at rest?"""

    ratios: tuple[Any, ...] = ()
    series: tuple[Any, ...] = ()
    whole: bool = False

    @property
    def nothing(self) -> bool:
        """Does it damp nothing?"""
        return not any(self.ratios or self.series)

    @property
    def creeps(self) -> bool:
        """Do the modes creep the more slowly the higher they are?"""
        return len(self.series) > 2

    def ratio(self, number: int) -> Any:
        """ζ that is given to the mode of a number."""
        return self.ratios[min(number, len(self.ratios)) - 1]

    def rate(self, mode: "Mode") -> Any:
        """c of a mode without dampers."""
        omega = mode.omega or 0
        if self.ratios:
            return 2 * self.ratio(mode.index) * omega
        square = omega**2 if mode.growth_rate is None else -mode.growth_rate**2
        return sum(a * square**k for k, a in enumerate(self.series))

    def of_squares(self, squares: Any) -> Any:
        """c of modes of these ω² beyond those with ratios of their own."""
        if self.ratios:
            return 2 * float(self.ratios[-1]) * squares**0.5
        return sum((float(a) * squares**k for k, a in enumerate(self.series)), 0 * squares)

    def spread(self, mode: "Mode") -> float:
        """How many times as large as c the terms are that it is added from."""
        terms = [float(a) * float(mode.omega or 0.0)**(2 * k) for k, a in enumerate(self.series)]
        return sum(map(abs, terms)) / abs(sum(terms)) if sum(terms) else 1.0


def member_damping(configuration: "Configuration", modes: "Modes", arithmetic: Any) -> MemberDamping | None:
    """The MemberDamping of a scene in the numbers of its modes without dampers; None where none is given."""
    record = configuration.spec.get("damping")
    if record is None:
        return None
    values = given_numbers(configuration, arithmetic)
    if "proportional" in values:
        return MemberDamping(series=_shortened(values["proportional"]), whole=True)
    if "modal" in values:
        found = MemberDamping(tuple(values["modal"]))
        _require_one_ratio(found, modes)
        return found
    return MemberDamping(series=_through(values["caughey"], modes))


def _shortened(series: "Sequence[float]") -> tuple[float, ...]:
    """Without the last that are 0."""
    found = list(series)
    while len(found) > 1 and not found[-1]:
        found.pop()
    return tuple(found)


def _require_one_ratio(damping: MemberDamping, modes: "Modes") -> None:
    """Modes of one frequency have no shapes of their own."""
    for one, two in pairwise(modes.first(len(damping.ratios)) if len(set(damping.ratios)) > 1 else ()):
        if one.omega and two.omega and damping.ratio(one.index) != damping.ratio(two.index) and (
                two.omega - one.omega <= ALIKE * two.omega):
            raise PhysicsError(f"modes {one.index} and {two.index} have one frequency: what is damped by two ratios is "
                               "not told apart", "give both the same ratio")


def _through(given: "dict[int, Any]", modes: "Modes") -> tuple[float, ...]:
    """aₖ with 2 ζⱼ ωⱼ = Σ aₖ ωⱼ²ᵏ at the modes {number: ζ}, by divided differences (Newton)."""
    numbers = sorted(given)
    chosen = [mode for number in numbers for mode in modes.numbered(number, number)]
    for number, mode in zip(numbers, chosen, strict=False):
        if not mode.omega:
            raise PhysicsError(f"no ratio can be given to mode {number}: it does not vibrate",
                               "name modes that vibrate")
    at = [mode.omega**2 for mode in chosen]
    if any(two - one <= ALIKE * two for one, two in pairwise(at)):
        raise PhysicsError("two of the modes of `caughey` have one frequency", "give the ratio of one of them")
    differences = [2 * given[number] * mode.omega for number, mode in zip(numbers, chosen, strict=True)]
    for k in range(1, len(at)):
        for i in reversed(range(k, len(at))):
            differences[i] = (differences[i] - differences[i - 1]) / (at[i] - at[i - k])
    series = [differences[-1]]
    for i in reversed(range(len(at) - 1)):      # (p)·(z − zᵢ) + differences[i]
        series = [low - at[i] * high for low, high in zip([0, *series], [*series, 0], strict=True)]
        series[0] += differences[i]
    found = _shortened(series)
    _require_no_drive(found, numbers)
    return found


def _require_no_drive(series: "Sequence[Any]", numbers: "Sequence[int]") -> None:
    """PhysicsError where a mode could be driven: modes without end lie on all of ω² > 0, near enough to it."""
    import numpy as np

    size = max(map(abs, series))
    roots = np.roots([float(a / size) for a in reversed(series)]) if size and len(series) > 1 else np.zeros(0)
    crossed = [x.real for x in roots if x.real > 0 and abs(x.imag) <= 1e-9 * abs(x)]
    if series[-1] < 0 or crossed:
        where = f" beyond {min(crossed) ** 0.5:.6g} rad/s" if crossed else ""
        through = ", ".join(map(str, numbers))
        raise PhysicsError(f"the Caughey series through the modes {through} would drive what vibrates{where}",
                           "give other ratios or modes, or write `modal: […]`")
