"""Members in time whose modes `damping:` damps one by one, by the modes without damping, H = Σ R/(ω² + s²):

    q̈ + c q̇ + ω² q = R w(t) + …,        H_c(s) = Σ R/(s² + c s + ω²)

with c = 2 ζ ω, or a series in ω². What loads hold up is a sum over all modes of a function g of their frequency, which
H itself gives (with c of ω the same function of z; Re z > 0),

    Σ R g(ω) = (1/2πi) ∫_{−i∞}^{i∞} 2 z g(z) H(iz) dz + Σ_{poles of g} Res 2 z g(z) H(iz)
"""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.exponential_polynomials import NOTHING
from vibcli.evidence.reference.member_pole_sums import DIGITS, PoleTerms
from vibcli.evidence.reference.member_poles import PoleSearch, damped_in_part
from vibcli.evidence.reference.member_residues import PoleResidues
from vibcli.evidence.reference.member_starts import StartedMembers, started_members
from vibcli.evidence.reference.members import determinant, require_plain
from vibcli.evidence.reference.settled import TrueValues
from vibcli.mechanics.given_damping import given_numbers
from vibcli.symbolic.evaluation import multiprecision

if TYPE_CHECKING:
    from vibcli.evidence.reference.member_images import MemberImages
    from vibcli.results.problem import Problem

REACH, LOST = 27, 3     # digits to which an integral goes, and of these such as its step leaves
FREE = 1e-30            # ω² beside which all others are large


class GivenDamping(NamedTuple):
    """c = 2 ζ ω by the number of the mode, the last ζ holding on, or Σ aₖ ω²ᵏ."""

    ratios: list[Any]
    series: list[Any]

    def of(self, omega: Any, number: Any) -> Any:
        """c of a mode, or of an array of them."""
        if self.ratios and hasattr(number, "dtype"):
            return 2 * np.array([float(x) for x in self.ratios])[np.minimum(number, len(self.ratios) - 1)] * omega
        if self.ratios:
            return 2 * self.ratios[min(number, len(self.ratios) - 1)] * omega
        exact = not hasattr(omega, "dtype")
        return sum((a if exact else float(a)) * omega ** (2 * k) for k, a in enumerate(self.series))

    def poles(self, rate: Any) -> list[tuple[Any, Any]]:
        """[(z, the residue of g there)] with Re z > 0 of g = 1/(z² + λ² + c λ)."""
        if self.ratios:
            zeta = self.ratios[-1]
            roots = [-zeta * rate + sign * mpmath.sqrt(zeta**2 - 1) * rate for sign in (1, -1)]
            return [(z, 1 / (2 * z + 2 * zeta * rate)) for z in roots if mpmath.re(z) > 0]
        terms = [a * rate for a in self.series] + [mpmath.mpf(0)] * (2 - len(self.series))
        terms[0] += rate**2
        terms[1] += 1
        while not terms[-1]:
            terms.pop()
        found = []
        for square in mpmath.polyroots(terms[::-1], maxsteps=500, extraprec=300):
            z = mpmath.sqrt(square)
            found.append((z, 1 / (2 * z * sum(k * x * square ** (k - 1) for k, x in enumerate(terms) if k))))
        return found


class RatedMembers:
    """The modes of a signal, and what unit inputs do at any s."""

    def __init__(self, problem: "Problem", signal: str, until: Any) -> None:
        self.members, search = _undamped(problem, signal, until)
        self.order, self.inputs = _rates(self.members), list(range(self.members.n, self.members.end))
        self._residues = PoleResidues(self.members, search, self._sources)
        self.few, self.rest = self._residues.few, self._residues.rest
        self.damping = _given(problem, [mpmath.im(p) for p, _ in self.few])
        self._along: dict[Any, list[Any]] = {}

    def _sources(self, images: "MemberImages") -> list[Any]:
        return [images.started(), *(images.loaded({i: 1}) for i in self.inputs)]

    def _images(self, s: mpmath.mpc | mpmath.mpf) -> list[mpmath.mpc]:
        return [x / s**self.order for x in self._residues.images(s)[1:]]

    def held_up(self, rate: Any, given: dict[int, Any]) -> Any:
        """What inputs e^{λt} of these amplitudes hold the signal at, without the factor λ of its order."""
        shares = [mpmath.mpmathify(given.get(i, 0)) for i in self.inputs]
        if not rate:
            rate = mpmath.mpc(0)
            small = abs(self.few[0][0]) * mpmath.mpf(10) ** -(REACH // 2)
            return mpmath.fsum(x * y for x, y in zip(shares, self._images(small), strict=True))
        total = mpmath.mpc(0)
        for z, rest in self.damping.poles(rate):
            total += 2 * z * rest * mpmath.fsum(x * y for x, y in zip(shares, self._images(mpmath.mpc(0, 1) * z),
                                                                      strict=True))
        if self.damping.ratios:
            total += self._integral(rate, shares) + self._by_number(rate, shares)
        return total

    def _integral(self, rate: mpmath.mpc, shares: Sequence[mpmath.mpc]) -> mpmath.mpc:
        """(i/π) ∫ 4 ζ Ω y² H(y)/((y² + Ω²)² − (2 ζ Ω y)²) dy over y > 0, y = Ω eᵛ, λ = iΩ."""
        Omega, zeta = mpmath.im(rate), self.damping.ratios[-1]
        if mpmath.re(rate) or not Omega > 0:
            raise PhysicsError("no reference is found of modes with ratios under loads that are no sines")
        step = mpmath.pi**2 / (REACH * mpmath.log(10))
        ends = REACH * mpmath.log(10) / 3, REACH * mpmath.log(10)
        total = mpmath.mpf(0)
        for k in range(-int(ends[0] / step), int(ends[1] / step) + 1):
            y = Omega * mpmath.exp(k * step)
            if y not in self._along:
                self._along[y] = self._images(y)
            H = mpmath.fsum(x * image for x, image in zip(shares, self._along[y], strict=True))
            total += 4 * zeta * Omega * y**3 * H / ((y**2 + Omega**2) ** 2 - (2 * zeta * Omega * y) ** 2)
        return mpmath.mpc(0, 1) / mpmath.pi * step * total

    def _by_number(self, rate: mpmath.mpc, shares: Sequence[Any]) -> mpmath.mpc:
        """What modes with ratios of their own have otherwise."""
        total = mpmath.mpc(0)
        for number, (p, residues) in enumerate(self.few[:len(self.damping.ratios) - 1]):
            omega, R = mpmath.im(p), self._strengths(p, residues)
            own, last = (1 / (omega**2 + rate**2 + self.damping.of(omega, k) * rate)
                         for k in (number, len(self.damping.ratios)))
            total += mpmath.fsum(x * y for x, y in zip(shares, R, strict=True)) * (own - last)
        return total

    def _strengths(self, p: mpmath.mpc, residues: Any) -> list[mpmath.mpc]:
        """R of each input."""
        return [2 * p * x / p**self.order for x in residues[1:]]

    def terms(self) -> list[PoleTerms]:
        """The signal as sums over what is damped and what loads hold up."""
        changes: dict[Any, dict[Any, Any]] = {}
        for i, parts in self.members.inputs.items():
            before = NOTHING
            for part in parts:
                changes.setdefault(part.start, {})[i] = (part.function - before).from_(part.start)
                before = part.function
        return [self._free(), *(self._forced(start, given) for start, given in changes.items())]

    def _both(self, weight: Callable[..., Any]) -> PoleTerms:
        """PoleTerms from 0 on with `weight` of (p, c, ω, residues at iω) of every damped p, real ones counted half."""
        few = []
        for number, (p, residues) in enumerate(self.few):
            omega = mpmath.im(p)
            c = self.damping.of(omega, number)
            root = mpmath.sqrt(mpmath.mpc(c * c / 4 - omega * omega))
            for sign in (1, -1):
                place = -c / 2 + sign * root
                if mpmath.im(place) >= 0:
                    few.append((place, weight(place, c, omega, residues) / (1 if mpmath.im(place) else 2)))
        p, residues, _ = self.rest
        number = np.arange(len(p)) + len(self.few)
        c = self.damping.of(p.imag, number)
        root = np.sqrt((c * c / 4 - p.imag**2).astype(np.clongdouble))
        places = [-c / 2 + root, -c / 2 - root]
        weights = [weight(place, c, p.imag, residues) * np.where(place.imag, 1, 0.5) * (place.imag >= 0)
                   for place in places]
        return PoleTerms(mpmath.mpf(0), few, np.stack(places, 1).ravel(), np.stack(weights, 1).ravel())

    def _free(self) -> PoleTerms:
        def weight(p: Any, c: Any, omega: Any, residues: Any) -> Any:
            rho = residues[0] / (1j * omega) ** self.order
            a, b = 2 * rho.real, -2 * omega * rho.imag
            return ((p + c) * a + b) * p**self.order / (2 * p + c)

        return self._both(weight)

    def _forced(self, start: Any, given: Mapping[int, Any]) -> Any:
        def weight(p: Any, c: Any, omega: np.ndarray, residues: Any) -> Any:
            total = 0
            for i, function in given.items():
                rho = residues[1 + self.inputs.index(i)]
                R = (2j * omega * rho / (1j * omega) ** self.order).real
                if hasattr(p, "dtype"):
                    image = sum(complex(x) / (p - complex(rate)) for (rate, _), x in function.terms.items())
                else:
                    image = function.image(p)
                total = total + R * image
            return total * p**self.order / (2 * p + c)

        found = self._both(weight)
        rates = {rate for function in given.values() for rate, _ in function.terms}
        if any(power for function in given.values() for _, power in function.terms):
            raise PhysicsError("no reference is found of modes with ratios under loads that grow with time")
        held = []
        for rate in rates:
            if mpmath.im(rate) >= 0:
                shares = {i: function.terms.get((rate, 0), 0) for i, function in given.items()}
                X = self.held_up(rate, shares) * rate**self.order
                held.append((rate, X if mpmath.im(rate) else X / 2))
        return found._replace(start=start, few=found.few + held)


class RatedSignal:
    """A signal up to an instant, as SignalInPoles has it."""

    many = True

    def __init__(self, problem: "Problem", signal: str, until: Any) -> None:
        self._rated = rated_members(problem, signal, until)
        self.members, self.until = self._rated.members, until
        self.held, self.sources = self.members.held, self._rated.terms()

    def left(self, t: Any) -> Any:
        """What rounding may leave of modes that few digits count of, as they have died out since the last change, and
        the integral of what loads hold up."""
        held = sum(abs(x) for part in self.sources for p, x in part.few if not mpmath.re(p))
        since = min((float(t - part.start) for part in self.sources if t > part.start), default=0.0)
        p, _, rounding = self._rated.rest
        c = self._rated.damping.of(p.imag, np.arange(len(p)) + len(self._rated.few))
        slowest = np.where(c < 2 * p.imag, c / 2, p.imag**2 / np.maximum(c, p.imag))
        return mpmath.mpf(10) ** (LOST - REACH) * held + float((rounding * np.exp(-slowest * since)).sum())

    def at(self, t: Any, primes: int = 0, count: Any = None) -> Any:
        """y, or its rate, by all modes or fewer of those that few digits count of."""
        return (0 if primes else self.held) + sum(part.at(t - part.start, primes, count) for part in self.sources
                                                  if t > part.start)


@lru_cache(maxsize=2)
def rated_members(problem: "Problem", signal: str, until: Any) -> RatedMembers:
    """Kept for other instants and frequencies."""
    return RatedMembers(problem, signal, until)


def damping_of(problem: "Problem", signal: str) -> GivenDamping:
    """That of the modes which lead to a signal."""
    with mpmath.workdps(DIGITS):
        return rated_members(problem, signal, 1).damping


def at_frequency(problem: "Problem", signal: str, Omega: Callable[[], Any],
                 given: Callable[[], dict[int, Any]], read: Callable[[Any], Any]) -> TrueValues:
    """What is read of the phasor of a signal at Ω() where inputs have those of given(); about: its size."""
    with mpmath.workdps(DIGITS):
        rate = mpmath.mpc(0, Omega())
        rated = rated_members(problem, signal, 1)
        X = rated.held_up(rate, given()) * (rate**rated.order if rated.order else 1)
        return TrueValues([read(X)], REACH - LOST, DIGITS, DIGITS, abs(X))


def _undamped(problem: "Problem", signal: str, until: int | mpmath.mpf) -> tuple[StartedMembers, PoleSearch]:
    if problem.configuration.coupled:
        raise PhysicsError("no reference is found of members that `damping:` and dampers damp")
    members = started_members(problem, signal, until)
    require_plain(members.elements)
    proportional = "proportional" in problem.spec.get("damping")
    if not all(placed.piece.inertia for placed in members.elements.pieces) or (
            members.elements.damps and not proportional):
        raise PhysicsError("no reference is found of members that `damping:` and dampers damp")
    if any(one.node is not None for one in problem.configuration.with_inputs.scene.inputs.values()):
        raise PhysicsError("no reference is found of driven supports of members that `damping:` damps")
    plain = damped_in_part(members, 0)
    pieces = [placed._replace(retardation=0) for placed in plain.elements.pieces]
    members = plain._replace(elements=plain.elements.with_parts(pieces=pieces))
    return members, PoleSearch(members)


def _rates(members: StartedMembers) -> int:
    """How often a signal is differentiated by the time; PhysicsError of what several rates enter."""
    if members.place is not None:
        return members.place.primes
    orders = [k for k, part in enumerate((members.row.q, members.row.v, members.row.a)) if any(part.values())]
    if len(orders) != 1:
        raise PhysicsError("no reference is found of this signal of members that `damping:` damps")
    return orders[0]


def _given(problem: "Problem", omegas: Sequence[mpmath.mpf]) -> GivenDamping:
    """The GivenDamping of a scene whose lowest frequencies are known."""
    values = given_numbers(problem.configuration, multiprecision())
    if "proportional" in values:
        return GivenDamping([], list(values["proportional"]))
    elements = problem.configuration.precise_system(mpmath.mp.dps)
    one, two = (determinant(elements, mpmath.mpf(FREE) * k) for k in (1, 2))
    free = abs(two / one) > 1.5
    if "modal" in values and (len(values["modal"]) == 1 or not free):
        return GivenDamping(list(values["modal"]), [])
    numbers = sorted(values.get("caughey", ()))
    if free or numbers[-1] > len(omegas):
        raise PhysicsError("no reference is found of ratios of modes where some do not vibrate, or of very high ones")
    at = [omegas[number - 1] for number in numbers]
    powers = mpmath.matrix([[omega ** (2 * k) for k in range(len(at))] for omega in at])
    wanted = mpmath.matrix([2 * values["caughey"][number] * omega for number, omega in zip(numbers, at, strict=True)])
    return GivenDamping([], list(mpmath.lu_solve(powers, wanted)))
