"""A signal of bars, shafts and strings by the fronts of the waves that have reached it:

    y(t) = d + Σ_{D < t} Σⱼ c_Dⱼ (t − D)ʲ/j!,      Y_D(s) = Σⱼ c_Dⱼ s⁻ʲ⁻¹,

Y_D the image of what comes with the delay D. Outside of a circle about all that vibrates it is analytic, so that its
coefficients are means over a larger circle; each sum over j is a function without a singular place.
"""

from collections.abc import Iterator
from functools import lru_cache
from heapq import heappop, heappush
from itertools import count, pairwise
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.exponential_polynomials import NOTHING
from vibcli.evidence.reference.member_images import MemberImages, delay
from vibcli.evidence.reference.member_starts import StartedMembers, started_members
from vibcli.evidence.reference.settled import TrueValues, settled

if TYPE_CHECKING:
    from vibcli.evidence.reference.exponential_polynomials import ExponentialPolynomial
    from vibcli.results.problem import Problem

DIGITS, START, GROWTH, LIMIT = 40, 64, 1.5, 512
MOST = 600              # fronts
SAME = 20               # digits to which two delays are one
SAMPLES, FEW = 12, 3    # between two fronts, where the turns are looked for, and the size alone
STEPS = 80
ROUNDED = 1000          # units of the last place: what is no larger may be rounding alone


class ArrivedFront(NamedTuple):
    """What a signal gains from an instant on: Σ cⱼ τʲ/j!, from `terms` cⱼ/j!."""

    delay: Any
    terms: list[Any]


class SignalInFronts:
    """y = held + the sum of fronts, up to an instant."""

    def __init__(self, held: Any, fronts: list[ArrivedFront], until: Any) -> None:
        self.held, self.fronts, self.until = held, fronts, until

    def at(self, t: Any, arrived: int | None = None) -> tuple[Any, Any]:
        """(y, ẏ) of the first fronts, or of those that have arrived."""
        value, rate = self.held, mpmath.mpf(0)
        for front in self.fronts[:arrived]:
            tau, total, slope = t - front.delay, mpmath.mpf(0), mpmath.mpf(0)
            if arrived is None and tau < 0:
                break
            for c in reversed(front.terms):
                slope = slope * tau + total
                total = total * tau + c
            value, rate = value + total, rate + slope
        return value, rate

    def value(self, t: Any) -> Any:
        """y at an instant; PhysicsError where it jumps there."""
        near = mpmath.mpf(10) ** -SAME * self.until
        jumps = [front for front in self.fronts if abs(front.delay - t) <= near and front.delay > near]
        value = self.at(t, sum(front.delay <= t + near for front in self.fronts))[0]
        if any(abs(front.terms[0]) > mpmath.mpf(10) ** -SAME * (abs(value) + abs(self.held)) for front in jumps):
            raise PhysicsError("no reference is found of a signal at the instant at which it jumps")
        return value

    def sampled(self, samples: int = SAMPLES) -> list[tuple[Any, Any, Any, int]]:
        """[(t, y, ẏ, how many fronts have come)] before, between and after fronts, both ends of each stretch among
        them."""
        found, ends = [], [mpmath.mpf(0), *(front.delay for front in self.fronts), self.until]
        for number, (a, b) in enumerate(pairwise(ends)):
            if a < b:
                found += [(t, *self.at(t, number), number)
                          for t in (a + (b - a) * k / samples for k in range(samples + 1))]
        return found

    def extreme(self, sense: int) -> tuple[Any, Any, Any]:
        """(instant, value) of the largest (1) or smallest value (−1), the first of several, and the largest size."""
        sampled = self.sampled()
        tops = [(t, y) for t, y, _, _ in sampled]
        flat = mpmath.mpf(10) ** -SAME * max(abs(rate) for _, _, rate, _ in sampled)
        for one, two in pairwise(sampled):
            if one[3] == two[3] and sense * one[2] > 0 > sense * two[2] and abs(one[2] - two[2]) > flat:
                tops.append(self._turn(one, two))
        best, size = max(sense * y for _, y in tops), max(abs(y) for _, y in tops)
        small = mpmath.mpf(10) ** -SAME * size
        t = min(t for t, y in tops if sense * y >= best - small)
        return t, sense * best, size

    def _turn(self, one: tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf, int],
              two: tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf, int]) -> tuple[mpmath.mpf, mpmath.mpf]:
        number, sign = one[3], mpmath.sign(one[2])
        t = mpmath.findroot(lambda t: sign * self.at(t, number)[1], (one[0], two[0]), solver="anderson", verify=False,
                            tol=mpmath.eps * 10**10, maxsteps=STEPS)
        return t, self.at(t, number)[0]


def in_fronts(problem: "Problem", signal: str, until: Any) -> SignalInFronts:
    """A signal up to an instant, at the working precision."""
    members = started_members(problem, signal, until)
    if not all(placed.piece.inertia for placed in members.elements.pieces):
        raise PhysicsError("no reference by fronts is found of members without inertia")
    until = mpmath.mpf(until)
    points = 1 << (2 * mpmath.mp.dps - 1).bit_length()
    radius = points / (4 * until)
    found = [_images(members, radius * mpmath.expjpi(mpmath.mpf(2 * m) / points), until)
             for m in range(points // 2 + 1)]
    largest = max(abs(image) for one in found for _, image in one.values())
    delays, fronts = {key: late for one in found for key, (late, _) in one.items()}, []
    for key in sorted(delays):
        terms = _terms([one.get(key, (0, mpmath.mpc(0)))[1] for one in found], radius, largest)
        fronts += [ArrivedFront(delays[key], terms)] * bool(terms)
    return SignalInFronts(members.held, fronts, until)


@lru_cache(maxsize=8)
def _kept(problem: "Problem", signal: str, until: float, _digits: int) -> SignalInFronts:
    """Kept for other features, as far as each number of digits goes."""
    return in_fronts(problem, signal, until)


def _terms(images: list[mpmath.mpc], radius: mpmath.mpf, largest: mpmath.mpf) -> list[mpmath.mpf]:
    """cⱼ/j! of an image at the points of half of a circle, from s = R on, without the last that are nothing."""
    means = _transformed([*images, *(mpmath.conj(x) for x in images[-2:0:-1])])
    means, found, factor = [*means[1:], means[0]], [], radius / len(means)
    least = mpmath.eps * ROUNDED * len(means) * largest
    while means and abs(means[-1]) <= least:
        means.pop()
    for j, x in enumerate(means):
        factor = factor * radius / j if j else factor
        found.append(factor * mpmath.re(x))
    return found


def _transformed(values: list[mpmath.mpc]) -> list[mpmath.mpc]:
    """Σ vₘ e^{2πi jm/n} of so many values, a power of two."""
    if len(values) == 1:
        return values
    even, odd = _transformed(values[::2]), _transformed(values[1::2])
    turned = [mpmath.expjpi(mpmath.mpf(2 * j) / len(values)) * x for j, x in enumerate(odd)]
    return [a + b for a, b in zip(even, turned, strict=True)] + [a - b for a, b in zip(even, turned, strict=True)]


def _images(members: StartedMembers, s: mpmath.mpc, until: mpmath.mpf) -> dict[int, tuple[mpmath.mpf, mpmath.mpc]]:
    """{a whole number by it: (delay, image)} of what comes later by it."""
    images, found = MemberImages(members, s), {}
    inverse, unit = images.A ** -1, 10**SAME / until
    delays = [delay(placed.piece) for placed in members.elements.pieces]
    for start, (right, fields) in sources(members, images):
        order, least = count(), mpmath.mpf(10) ** (-0.9 * mpmath.mp.dps) * max(map(abs, right))
        pending = [(start, next(order), right, fields)]
        while pending:
            late, _, right, fields = heappop(pending)
            while pending and (pending[0][0] - late) * unit <= 1:
                right = [x + y for x, y in zip(right, heappop(pending)[2], strict=True)]
            solution = [mpmath.fsum(inverse[i, j] * x for j, x in enumerate(right) if x) for i in range(len(right))]
            field = NOTHING if fields is None or members.place is None else fields[members.place.piece]
            for more, image in images.along(solution, field):
                if late + more < until:
                    key = int(mpmath.nint((late + more) * unit))
                    found[key] = late + more, found.get(key, (0, 0))[1] + image
            for part in images.running:
                if late + delays[part.piece] < until:
                    after = [mpmath.mpc(0)] * len(right)
                    for (i, j), x in part.entries.items():
                        after[i] -= x * solution[j] * part.rest
                    if max(map(abs, after)) > least:
                        heappush(pending, (late + delays[part.piece], next(order), after, None))
            if len(found) > MOST:
                raise PhysicsError("the reference takes too long: very many fronts arrive")
    return found


def sources(members: StartedMembers,
            images: MemberImages) -> "Iterator[tuple[mpmath.mpf, tuple[list[Any], list[ExponentialPolynomial]]]]":
    """[(instant, (right side, fields))] of the start, and of all instants at which what moves the inputs changes."""
    yield mpmath.mpf(0), images.started()
    changes: dict[Any, dict[Any, Any]] = {}
    for i, parts in members.inputs.items():
        before = NOTHING
        for part in parts:
            change = (part.function - before).from_(part.start)
            changes.setdefault(part.start, {})[i] = change.image(images.s)
            before = part.function
    for start, given in changes.items():
        yield start, images.loaded(given)


def at_instant(problem: "Problem", signal: str, t: Any) -> TrueValues:
    """The value of a signal at t(), an instant; about: its largest size until then."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        until = t()
        if not until:
            value = started_members(problem, signal, until).at_first()
            return [value], abs(value) or mpmath.mpf(1)
        along = in_fronts(problem, signal, until * (1 + mpmath.mpf(2) ** -20))
        value, size = along.value(until), max(abs(y) for _, y, _, _ in along.sampled(FEW))
        return [value if abs(value) > mpmath.mpf(10) ** -DIGITS * size else mpmath.mpf(0)], size

    return settled(found, DIGITS, START, LIMIT, GROWTH, sized=True)


def extremes(problem: "Problem", signal: str, until: Any, sense: int, instant: bool) -> TrueValues:
    """The largest or smallest value of a signal until an instant, or where it has it; about: its largest size, or
    `until`."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        t, top, size = _kept(problem, signal, until, mpmath.mp.dps).extreme(sense)
        return ([t], mpmath.mpf(until)) if instant else ([top], size)

    return settled(found, DIGITS, START, LIMIT, GROWTH, sized=True)
