"""A signal of members in time by the poles of its Laplace image, those of what moves the inputs among them:

    y(t) = d + Σ_{D < t} Σ_p Res_p S_D e^{p (t − D)}

S_D the image of what begins at the instant D. The first poles are found to the working precision, those that follow in
NumPy's longest floats, as few digits of their small residues count; those of the inputs, and what is at rest, lie in
circles, on which S_D is taken at even places. That the poles are all there, S_D itself tells at places to the right of
them:

    S_D(σ) = Σ_p Res_p S_D / (σ − p)
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.even_poles import even_poles
from vibcli.evidence.reference.member_fronts import sources
from vibcli.evidence.reference.member_images import MemberImages
from vibcli.evidence.reference.member_poles import PoleSearch
from vibcli.evidence.reference.member_residues import PoleResidues, exactly
from vibcli.evidence.reference.member_starts import StartedMembers, started_members
from vibcli.evidence.reference.members import require_plain
from vibcli.evidence.reference.settled import DoesNotSettle

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

DIGITS = 80             # with which the first poles are found
CIRCLE, GROWTH = 0.25, 10       # radius of a circle: of the distance to the next pole, of what e^{rt} becomes on it
OCTAVES = 4             # between the places at which the sum is tested
AT_FIRST, ALL = 1e-18, 1e-6     # how near it is to be at the first of them, and at the others, of what it is summed of
MOST, WORK = 32, 1.2e8      # blocks of poles, and entries of matrices for them
FEW, MANY = 1000, 1 << 20       # even poles that are summed at the working precision, and of all
LIKELY = 8              # times the root of the sum of squares of what is as likely up as down; roundings of a residue
LAST = 16               # poles by which those beyond are judged


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
        if c.any():
            total += exactly((c * p**primes * np.exp(p * np.longdouble(str(tau)))).real.sum())
        return 2 * total


@lru_cache(maxsize=2)
def signal_in_poles(problem: "Problem", signal: str, until: Any) -> "SignalInPoles":
    """A signal of a scene, kept for other instants, as its poles are for other signals."""
    members = started_members(problem, signal, until)
    require_plain(members.elements)
    if not all(placed.piece.inertia for placed in members.elements.pieces):
        raise PhysicsError("no reference in time is found of members without inertia")
    return SignalInPoles(members, _search(problem), until)


@lru_cache(maxsize=2)
def _search(problem: "Problem") -> PoleSearch:
    return PoleSearch(started_members(problem, next(iter(problem.scene.coordinates)), 1))


class SignalInPoles:
    """A signal up to an instant, at the working precision."""

    def __init__(self, members: StartedMembers, search: PoleSearch, until: Any) -> None:
        self.members, self.held, self.until = members, members.held, until
        self._blocks, self._cost = 1, search.cost
        starts = [start for start, _ in sources(members, MemberImages(members, mpmath.mpc(1)))]
        self._residues = found = PoleResidues(
            members, search, lambda images: [one for _, one in sources(images.members, images)])
        first, (p, c, rounding) = found.few, found.rest
        self._even = even_poles(found)
        if self._even is not None:
            first = first + self._even.exactly(len(first) + 1, FEW)
            p, c = self._even.between(FEW + 1, 2 * FEW)
            rounding = np.zeros(len(p))
        self._rounding = float(rounding.sum())
        few = first + self._circles([x for x, _ in first])
        self.sources = [PoleTerms(start, [(x, values[k]) for x, values in few], p, c[k])
                        for k, start in enumerate(starts)]
        self._require_all(abs(few[0][0]), float(abs(p[-1] if len(p) else first[-1][0])))

    def doubled(self) -> None:
        """Take twice as many poles."""
        if self._even is not None:
            last = FEW + len(self.sources[0].p)
            found = [(*self._even.between(last + 1, 2 * last), np.zeros(0))]
        else:
            found = [self._residues.block(i) for i in range(self._blocks, 2 * self._blocks)]
        self._blocks *= 2
        self._rounding += sum(one[2].sum() for one in found)
        p = np.concatenate([self.sources[0].p, *(one[0] for one in found)])
        self.sources = [part._replace(p=p, c=np.concatenate([part.c, *(one[1][k] for one in found)]))
                        for k, part in enumerate(self.sources)]

    @property
    def many(self) -> bool:
        """Are there as many as are worth their time?"""
        if self._even is not None:
            return 2 * len(self.sources[0].p) > MANY
        return self._blocks >= MOST or 2 * self._blocks * self._cost > WORK

    def left(self, t: Any) -> Any:
        """What rounding may leave of those that few digits count of: of their residues, and of p t. Of even ones, whose
        residues are known to the last digit of longer floats, it is as likely up as down."""
        eps = float(np.finfo(np.longdouble).eps)
        turned = eps * np.abs(self.sources[0].p).astype(float) * float(t)
        each = [np.abs(part.c).astype(float) * turned for part in self.sources]
        if self._even is None:
            return mpmath.mpf(self._rounding + float(sum(part.sum() for part in each)))
        each = [part + LIKELY * eps * np.abs(one.c).astype(float) for part, one in zip(each, self.sources, strict=True)]
        return mpmath.mpf(LIKELY * sum(float(np.linalg.norm(part)) for part in each))

    def _circles(self, poles: Sequence[mpmath.mpc]) -> list[tuple[mpmath.mpc, list[mpmath.mpc]]]:
        """[(place, [half of what S_D has there])] about 0 and what the inputs have."""
        rates = {mpmath.mpc(0)} | {rate for parts in self.members.inputs.values() for part in parts
                                   for rate, _ in part.function.terms}
        found = []
        for centre in [rate for rate in rates if mpmath.im(rate) >= 0]:
            others = [abs(p - centre) for p in (*poles, *map(mpmath.conj, poles), *rates) if p != centre]
            radius = min(CIRCLE * min(others), GROWTH / self.until)
            points = 4 * int(mpmath.mp.dps / mpmath.log10(min(others) / radius) / 4 + 1)
            while (radius * self.until) ** points / mpmath.factorial(points) > mpmath.eps:     # of e^{sτ}
                points += 4
            for m in range(points if mpmath.im(centre) else points // 2):
                s = centre + radius * mpmath.expjpi(mpmath.mpf(2 * m + 1) / points)
                found.append((s, [x * (s - centre) / points for x in self._residues.images(s)]))
        return found

    def _require_all(self, least: mpmath.mpf, most: float) -> None:
        """DoesNotSettle where the sum is not what the images are."""
        sigma = least
        while sigma <= max(least, most / 1000):
            for image, part in zip(self._residues.images(sigma), self.sources, strict=True):
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
