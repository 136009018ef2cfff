"""All zeros of a real function on a range, found by looking: brackets, tangent zeros, poles, edges of the domain.

The function is bounded, |h| <= 1, as (L − R)/(|L| + |R|) is: at a pole its sign changes where |h| tends to 1, at a
zero where h tends to 0. None stands for "not defined there".
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import copysign, isfinite
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import mpmath

ZERO, TOUCHING = 1e-8, 1e-9             # |h| at a zero where h changes its sign, and where it only touches
SAME = 1e-7                             # two zeros nearer than this, relatively, are one
TAIL = 1e-6                             # towards an open end a function below this only tends to zero
COARSE, ALIKE, LEVEL = 4, 8, 1e-12      # a first look at every 4th place; over 8 values alike to LEVEL settle it
ROUNDS, BENT, MOST = 4, 0.12, 320       # halvings where h bends by more than BENT, up to MOST places
LOOKED, HALVINGS = 6, 34                # halvings towards an edge of the domain: at least, at most
FALLING, LEVELLED = 0.9, 1e-4           # a fall towards zero at an edge; a change that calls for no look at it
NARROW, LATE, JUMP = 2.0**-50, 30, 0.3  # a bracket narrowed LATE times has a jump if |h| stays above JUMP of its ends
DEEP, SHALLOW, EARLY = 0.5, 0.3, 24     # a dip of |h| that may hold a zero; what is left of it after EARLY steps
FLAT, BESIDE = 3, 1e3                   # neighbouring zeros that make a plateau; how much more h would be on a slope
GOLDEN = 0.3819660112501051


class Scan:
    """Values of a function, each computed once: `points` {x: h or None}."""

    def __init__(self, function: Callable[..., float | None], grid: Sequence[float]) -> None:
        """Looks at every COARSE-th place, and between two of them where the function is defined at one or nowhere; no
        further where it is the same at all of them."""
        self.function, self.points = function, {}
        coarse = sorted({*range(0, len(grid), COARSE), len(grid) - 1})
        values = [h for h in (self.at(grid[i]) for i in coarse) if h is not None]
        nowhere = not values
        if len(values) > ALIKE and max(values) - min(values) <= LEVEL:
            return
        for i, j in pairwise(coarse):
            if nowhere or self.at(grid[i]) is not None or self.at(grid[j]) is not None:
                for x in grid[i:j]:
                    self.at(x)

    def at(self, x: float) -> float | None:
        if x not in self.points:
            value = self.function(x)
            self.points[x] = value if value is not None and isfinite(value) else None
        found: float | None = self.points[x]
        return found

    def defined(self) -> list[tuple[float, float]]:
        """[(x, h)] ascending."""
        return sorted((x, h) for x, h in self.points.items() if h is not None)


def zeros(function: Callable[..., float | None], grid: Sequence[float],
          closed: Sequence[bool] = (True, True)) -> tuple[list[float], Scan]:
    """(zeros ascending, Scan) of a function over the range that an ascending grid covers.

    `closed`: does the range hold its ends? Towards an open end a function that only tends to zero has no zero.
    """
    scan = Scan(function, grid)
    _edges(scan, grid)
    _refine(scan)
    found = [x for x, h in scan.defined() if h == 0.0]
    for (a, ha), (b, hb) in list(_neighbours(scan)):
        if ha * hb < 0 and len(scan.points) <= 2 * MOST:
            found += _within(scan, a, ha, b, hb)
    for triple in list(_dips(scan)):
        if len(scan.points) > 3 * MOST:
            break
        found += _touched(scan, *triple)
    points = scan.defined()
    tails = [_tail(points[::1 if end == grid[0] else -1]) for end, held in zip((grid[0], grid[-1]), closed, strict=True)
             if not held and scan.at(end) is not None]
    return [x for x in _distinct(found, scan) if not any(x in tail for tail in tails)], scan


def _tail(points: Sequence[tuple[float, float]]) -> set[float]:
    """The points from an end on as long as the function is near zero there."""
    found = set()
    for x, h in points:
        if abs(h) > TAIL:
            break
        found.add(x)
    return found


def holds_everywhere(scan: Scan) -> bool:
    """Is the function zero wherever it is defined?"""
    values = [h for _, h in scan.defined()]
    return bool(values) and max(map(abs, values)) <= TOUCHING


def longest_plateau(scan: Scan) -> tuple[float, float] | None:
    """(from, to) where the function is zero at FLAT neighbouring points or more; None where it is nowhere flat. Points
    beside a zero are so near to it that it is small there anyway."""
    points, best, run = scan.defined(), [], []
    for k, (_, h) in enumerate(points):
        run = [*run, k] if abs(h) <= LEVEL else []
        best = max(best, run, key=len)
    if len(best) < FLAT:
        return None
    left, right = points[best[0]][0], points[best[-1]][0]
    beside = [points[k] for k in (best[0] - 1, best[-1] + 1) if 0 <= k < len(points)]
    steep = all(abs(h) * (right - left) > BESIDE * LEVEL * max(abs(x - left), abs(x - right)) for x, h in beside)
    return (left, right) if steep and right - left > 1e-3 * abs(right) else None


def _neighbours(scan: Scan) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    """Pairs of neighbouring points at both of which the function is defined."""
    points = sorted(scan.points.items())
    for one, other in pairwise(points):
        if one[1] is not None and other[1] is not None:
            yield one, other


def _middle(a: float, b: float) -> float:
    """Halfway, by ratio where both have one sign and differ much."""
    if a * b > 0 and max(abs(a), abs(b)) > 2 * min(abs(a), abs(b)):
        found: float = (a * b) ** 0.5 * (1 if a > 0 else -1)
        return found
    return 0.5 * (a + b)


def _edges(scan: Scan, grid: Sequence[float]) -> None:
    """Go up to the edges of the domain, all the way where the function falls towards zero there."""
    for i, (a, b) in enumerate(pairwise(grid)):
        if a not in scan.points or b not in scan.points or (scan.at(a) is None) == (scan.at(b) is None):
            continue
        inside, outside = (a, b) if scan.at(a) is not None else (b, a)
        before = scan.at(grid[max(i - 1, 0)] if inside == a else grid[min(i + 2, len(grid) - 1)])
        if before is not None and abs(scan.at(inside)) > 0.1 and abs(before - scan.at(inside)) < LEVELLED:
            continue
        falling = True
        for step in range(HALVINGS):
            x = _middle(inside, outside)
            if x in (inside, outside) or (step >= LOOKED and not falling):
                break
            if scan.at(x) is None:
                outside = x
            else:
                falling = abs(scan.at(x)) <= FALLING * abs(scan.at(inside))
                inside = x


def _refine(scan: Scan) -> None:
    """Halve where the function bends: its value differs from the mean of its neighbours'."""
    for _ in range(ROUNDS):
        points, wanted = scan.defined(), set()
        for (a, ha), (b, hb), (c, hc) in zip(points, points[1:], points[2:], strict=False):
            if abs(hb - 0.5 * (ha + hc)) > BENT:
                wanted |= {_middle(a, b), _middle(b, c)}
        if len(scan.points) + len(wanted) > MOST:
            return
        for x in wanted - set(scan.points):
            scan.at(x)


def _within(scan: Scan, a: float, ha: float, b: float, hb: float) -> list[float]:
    """The zero within a change of sign; none at a pole or a jump."""
    middle = scan.at(_middle(a, b))
    rises = middle is not None and abs(middle) > abs(ha if (middle > 0) == (ha > 0) else hb)
    ends: Sequence[float] | None = (a, ha, b, hb)
    if rises and 1 not in (abs(middle), abs(ha), abs(hb)):
        ends = _beside_pole(scan, a, ha, b, hb)
    x = None if ends is None else bracketed(scan.at, *ends)
    return [] if x is None or abs(scan.at(x)) > ZERO else [x]


def _beside_pole(scan: Scan, a: float, ha: float, b: float, hb: float) -> Sequence[float] | None:
    """The change of sign of h where |h| falls again on the way to the place at which 1 − |h| vanishes, found as a zero;
    None where it rises from both sides up to there: at a pole, a jump, or where h is not defined."""
    near, fell = {ha > 0: (a, ha), hb > 0: (b, hb)}, []

    def below_one(x: float) -> "float | None":
        h = scan.at(x)
        if h is None or fell:
            return None
        if abs(h) < abs(near[h > 0][1]):
            fell.extend((x, h, *near[h < 0]))
        near[h > 0] = x, h
        return copysign(1 - abs(h), h)

    bracketed(below_one, a, copysign(1 - abs(ha), ha), b, copysign(1 - abs(hb), hb))
    return fell or None


def bracketed(function: Callable[[float], float | None], a: float, fa: float, b: float, fb: float) -> float | None:
    """A zero between a and b, by inverse quadratic steps that fall back on halving (Chandrupatla 1997); None where the
    function is not defined on the way, or jumps."""
    c, fc, t, start = a, fa, 0.5, min(abs(fa), abs(fb))
    for step in range(120):
        x = a + t * (b - a) if t != 0.5 else _middle(a, b)
        fx = function(x)
        if fx is None:
            return None
        if (fx > 0) == (fa > 0):
            c, fc = a, fa
        else:
            c, b, fc, fb = b, a, fb, fa
        a, fa = x, fx
        best, least = (a, abs(fa)) if abs(fa) < abs(fb) else (b, abs(fb))
        width = abs(b - a)
        if step == LATE and least > max(JUMP * start, ZERO):
            return None
        if least == 0.0 or width <= 4 * NARROW * abs(best):
            return best
        t = 0.5
        if fc in (fa, fb) or c in (a, b):
            continue
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        if phi**2 < xi and (1 - phi) ** 2 < 1 - xi:
            t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        limit = 0.5 * NARROW * abs(best) / width
        t = min(max(t, limit), 1 - limit)
    return best


def last_place(holds: Callable[..., bool], low: "float | mpmath.mpf", high: "float | mpmath.mpf",
               most: int = 200) -> "tuple[float | mpmath.mpf, float | mpmath.mpf]":
    """(low, high) next to each other, or halved so often: between them a condition ceases to hold that holds at low and
    not at high. Numbers may be floats or mpmath's."""
    for _ in range(most):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low, high


def _dips(scan: Scan) -> Iterator[tuple[float, float, float]]:
    """Three neighbours of one sign, the middle one nearest to zero; at an edge of the domain the last one twice."""
    points = sorted(scan.points.items())
    for i, (b, hb) in enumerate(points):
        if not hb:
            continue
        (a, ha), (c, hc) = points[max(i - 1, 0)], points[min(i + 1, len(points) - 1)]
        (a, ha), (c, hc) = (b, hb) if ha is None else (a, ha), (b, hb) if hc is None else (c, hc)
        deep = abs(hb) <= DEEP * max(abs(ha), abs(hc))      # a parabola that touches zero: at most 1/9
        if ha * hb > 0 and hc * hb > 0 and abs(hb) <= min(abs(ha), abs(hc)) and deep:
            yield a, b, c


def _touched(scan: Scan, a: float, b: float, c: float) -> list[float]:
    """Zeros near the least |h| between a and c: two where it goes beyond zero, one where it touches."""
    h, start = scan.at(b), abs(scan.at(b))
    sign = 1 if h > 0 else -1
    for step in range(90):
        x = b + GOLDEN * (c - b) if c - b > b - a else b - GOLDEN * (b - a)
        hx = scan.at(x)
        if hx is None or x in (a, b, c):
            break
        if hx * h < 0:
            end = c if x > b else a
            return _within(scan, b, scan.at(b), x, hx) + _within(scan, x, hx, end, scan.at(end))
        if abs(hx) < abs(scan.at(b)):
            a, b, c = (b, x, c) if x > b else (a, x, b)
        elif x > b:
            c = x
        else:
            a = x
        if step == EARLY and abs(scan.at(b)) > SHALLOW * start and start > 1e-3:
            break
        if c - a <= 1e-9 * abs(b):
            break
    return [b] if sign * scan.at(b) <= TOUCHING else []


def _distinct(found: Sequence[float], scan: Scan) -> list[float]:
    """Zeros that differ by more than what a double zero is known to; of two at one place the better one."""
    kept = []
    for x in sorted(found):
        if kept and abs(x - kept[-1]) <= SAME * max(abs(x), abs(kept[-1])):
            if abs(scan.at(x)) < abs(scan.at(kept[-1])):
                kept[-1] = x
        else:
            kept.append(x)
    return kept
