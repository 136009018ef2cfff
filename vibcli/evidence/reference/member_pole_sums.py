"""A signal of members in time by the poles of its Laplace image, those of what moves the inputs among them:

    y(t) = d + Σ_{D < t} Σ_p Res_p S_D e^{p (t − D)}

S_D the image of what begins at the instant D. The first poles are found to the working precision, those that follow in
NumPy's longest floats, as few digits of their small residues count; those of the inputs, and what is at rest, lie in
circles, on which S_D is taken at even places. That the poles are all there, S_D itself tells at places to the right of
them:

    S_D(σ) = Σ_p Res_p S_D / (σ − p)
"""

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.member_fronts import sources
from vibcli.evidence.reference.member_images import MemberImages
from vibcli.evidence.reference.member_poles import PoleSearch, in_floats
from vibcli.evidence.reference.member_starts import StartedMembers, started_members
from vibcli.evidence.reference.members import require_plain
from vibcli.evidence.reference.settled import DoesNotSettle

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

DIGITS = 80             # with which the first poles are found
LARGE, MANY = 1e-22, 150    # rounding, of the largest residue, with which these need all digits, and how many may
SECANTS = 8
CIRCLE, GROWTH = 0.25, 30       # radius of a circle: of the distance to the next pole, of what e^{rt} becomes on it
OCTAVES = 4             # between the places at which the sum is tested
AT_FIRST, ALL = 1e-18, 1e-6     # how near it is to be at the first of them, and at the others, of what it is summed of
MOST = 32               # blocks of poles
LAST = 16               # poles by which those beyond are judged
CLOSE = 1e-25           # distance of places at which residues are read, relative


class PoleTerms(NamedTuple):
    """Σ c e^{pτ} from an instant on: (p, c) of mpmath, and arrays of more p and c in longer floats; the real part of
    twice each counts."""

    start: Any
    few: list[tuple[Any, Any]]
    p: np.ndarray
    c: np.ndarray

    def at(self, tau: Any, primes: int = 0, count: Any = None) -> Any:
        """The sum, or its rate, of so many of the array."""
        p, c = self.p[:count], self.c[:count]
        total = mpmath.fsum(mpmath.re(x * p**primes * mpmath.exp(p * tau)) for p, x in self.few)
        return 2 * (total + exactly((c * p**primes * np.exp(p * np.longdouble(str(tau)))).real.sum()))


def exactly(x: Any) -> Any:
    """A long float as a number of mpmath."""
    high = float(x)
    return mpmath.mpf(high) + mpmath.mpf(float(x - np.longdouble(high)))


@lru_cache(maxsize=2)
def signal_in_poles(problem: "Problem", signal: str, until: Any) -> "SignalInPoles":
    """A signal of a scene, kept for other instants, as its poles are for other signals."""
    members = started_members(problem, signal, until)
    require_plain(members.elements)
    if not all(placed.piece.inertia for placed in members.elements.pieces):
        raise PhysicsError("no reference in time is found of members without inertia")
    return SignalInPoles(members, _search(problem), until)


@lru_cache(maxsize=2)
def _search(problem):
    return PoleSearch(started_members(problem, next(iter(problem.scene.coordinates)), 1))


class SignalInPoles:
    """A signal up to an instant, at the working precision."""

    def __init__(self, members: StartedMembers, search: PoleSearch, until: Any):
        self.members, self.held, self.until, self._search = members, members.held, until, search
        self._floats, self._blocks = in_floats(members), 1
        starts = [start for start, _ in sources(members, MemberImages(members, mpmath.mpc(1)))]
        p, c, rounding = search.with_residues(0, self._floats, _rights)
        large = np.flatnonzero((rounding > LARGE * np.abs(c).max(axis=1, keepdims=True)).any(axis=0))
        self._first = min(int(large[-1]) + 1 if len(large) else 1, MANY)
        few = [self._exact(exactly(x.real) + 1j * exactly(x.imag)) for x in p[:self._first]]
        few += self._circles([x for x, _ in few])
        self.sources = [PoleTerms(start, [(x, values[k]) for x, values in few], p[self._first:], c[k, self._first:])
                        for k, start in enumerate(starts)]
        self._rounding = rounding[:, self._first:].sum()
        self._require_all(abs(few[0][0]), float(abs(p[-1])))

    def doubled(self) -> None:
        """Take twice as many poles."""
        found = [self._search.with_residues(i, self._floats, _rights)
                 for i in range(self._blocks, 2 * self._blocks)]
        self._blocks *= 2
        self._rounding += sum(one[2].sum() for one in found)
        p = np.concatenate([self.sources[0].p, *(one[0] for one in found)])
        self.sources = [part._replace(p=p, c=np.concatenate([part.c, *(one[1][k] for one in found)]))
                        for k, part in enumerate(self.sources)]

    @property
    def many(self) -> bool:
        """Are there as many as are worth their time?"""
        return self._blocks >= MOST

    def left(self) -> Any:
        """What rounding may leave of those that few digits count of: of their residues, and of p t."""
        turned = float(np.finfo(np.longdouble).eps) * np.abs(self.sources[0].p) * float(self.until)
        return mpmath.mpf(self._rounding + sum(float((np.abs(part.c) * turned).sum()) for part in self.sources))

    def images(self, s: Any) -> list:
        """[S_D] at s."""
        images = MemberImages(self.members, s)
        every = [one for _, one in sources(self.members, images)]
        found = _solved(images, [right for right, _ in every])
        return [images.signal(x, fields) for x, (_, fields) in zip(found, every, strict=True)]

    def _exact(self, near):
        """(p, [the residue of each S_D])."""
        p = self._pole(near)
        h = mpmath.mpf(CLOSE) * abs(p)
        return p, [h * (x - y) / 2 for x, y in zip(self.images(p + h), self.images(p - h), strict=True)]

    def _pole(self, near):
        """By secants of 1/(bᵀ A⁻¹ b)."""
        def size(s):
            images = MemberImages(self.members, s)
            probe = [mpmath.mpf(k % 3 + 1) for k in range(images.size)]
            x, = _solved(images, [probe])
            return 1 / mpmath.fsum(a * b for a, b in zip(probe, x, strict=True))

        one, two = near * (1 + mpmath.mpf(2) ** -50), near
        at_one, at_two = size(one), size(two)
        for _ in range(SECANTS):
            if at_one == at_two:
                break
            one, two, at_one = two, two - at_two * (two - one) / (at_two - at_one), at_two
            if abs(two - one) <= mpmath.mpf(10) ** -(mpmath.mp.dps * 6 // 10) * abs(two):
                break
            at_two = size(two)
        return two

    def _circles(self, poles):
        """[(place, [half of what S_D has there])] about 0 and what the inputs have."""
        rates = {mpmath.mpc(0)} | {rate for parts in self.members.inputs.values() for part in parts
                                   for rate, _ in part.function.terms}
        found = []
        for centre in [rate for rate in rates if mpmath.im(rate) >= 0]:
            others = [abs(p - centre) for p in (*poles, *map(mpmath.conj, poles), *rates) if p != centre]
            radius = min(CIRCLE * min(others), GROWTH / self.until)
            points = 4 * int(mpmath.mp.dps / mpmath.log10(min(others) / radius) / 4 + 1)
            for m in range(points if mpmath.im(centre) else points // 2):
                s = centre + radius * mpmath.expjpi(mpmath.mpf(2 * m + 1) / points)
                found.append((s, [x * (s - centre) / points for x in self.images(s)]))
        return found

    def _require_all(self, least, most):
        """DoesNotSettle where the sum is not what the images are."""
        sigma = least
        while sigma <= max(least, most / 1000):
            for image, part in zip(self.images(sigma), self.sources, strict=True):
                terms = [2 * mpmath.re(x / (sigma - p)) for p, x in part.few]
                terms.append(exactly((2 * part.c / (np.longdouble(str(sigma)) - part.p)).real.sum()))
                near = (ALL if sigma > least else AT_FIRST) * mpmath.fsum(map(abs, terms))
                beyond = float(np.abs(part.c[-LAST:]).max(initial=0.0)) * len(part.c) / most
                if abs(mpmath.fsum(terms) - image) > near + beyond + self._rounding / sigma:
                    raise DoesNotSettle("the reference does not settle: not all poles of these members are found")
            sigma *= 2**OCTAVES

    def at(self, t: Any, primes: int = 0, count: Any = None) -> Any:
        """y, or its rate, by all poles or fewer of those that few digits count of."""
        return (0 if primes else self.held) + sum(part.at(t - part.start, primes, count) for part in self.sources
                                                  if t > part.start)


def _rights(members, images):
    return [right for _, (right, _) in sources(members, images)]


def _solved(images, rights):
    """The solutions of the whole equations, by elimination with pivots."""
    n = images.size
    A = [[mpmath.mpc(0)] * n + [mpmath.mpc(right[i]) for right in rights] for i in range(n)]
    for (i, j), x in images.whole().items():
        A[i][j] = mpmath.mpc(x)
    for i in range(n):
        biggest = max(map(abs, A[i][:n]))
        A[i] = [x / biggest for x in A[i]]
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(A[k][i]))
        A[i], A[best] = A[best], A[i]
        for row in A[i + 1:]:
            if row[i]:
                factor = row[i] / A[i][i]
                for k in range(i + 1, len(row)):
                    if A[i][k]:
                        row[k] -= factor * A[i][k]
    found = []
    for k in range(n, n + len(rights)):
        x = [mpmath.mpc(0)] * n
        for i in reversed(range(n)):
            x[i] = (A[i][k] - mpmath.fsum(a * b for a, b in zip(A[i][i + 1:n], x[i + 1:], strict=True))) / A[i][i]
        found.append(x)
    return found
