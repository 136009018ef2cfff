"""The sentence that matters: what our error costs, and who else reaches it."""

import math
from collections.abc import Sequence

from vibcli.evidence.timing import SPENT, STOPPED, Point

AS_GOOD = 10 ** 0.5         # times our error
ROUNDED = 2.0 ** -51        # below which errors differ by the rounding of what is printed


def beside(points: Sequence[Point]) -> Point | None:
    """The point that the first, ours, is set beside: the fastest that is as good, else the one with the least error;
    None where nothing else answers."""
    ours, *others = points
    plain = [point for point in others if point.error is not None and point.method != ours.method]
    if ours.error is None or not plain:
        return None
    reaching = [point for point in plain if _as_good(point, ours)]
    return min(reaching, key=lambda point: point.seconds[1]) if reaching else min(plain, key=lambda point: point.error)


def _as_good(point: Point, ours: Point) -> bool:
    return point.error <= max(AS_GOOD * ours.error, ROUNDED)


def verdict(points: Sequence[Point]) -> str:
    """Of points of which the first is ours: nothing else is compared where that has no answer."""
    ours, other = points[0], beside(points)
    if ours.error is None:
        return f"vibcli itself refuses: {ours.why}"
    if other is None:
        return "vibcli alone answers: there is nothing to compare it with"
    if _as_good(other, ours):
        return _reached(ours, other)
    cut = any(point.why in (STOPPED, SPENT) for point in points[1:])
    return (f"{_times(ours, other)} of {named(other)} and {_digits(ours, other)} more; "
            f"{'of what ended in time none' if cut else 'nothing plain'} reaches {_decade(other.error)}")


def _reached(ours: Point, other: Point) -> str:
    """Another one is as good."""
    bound = "" if other.bound is not None else "; it states no bound"
    if other.seconds[1] < ours.seconds[1]:
        return (f"{named(other)} is as good, {other.error:.1e}, and {_ratio(ours, other)} × faster{bound}")
    return f"{_ratio(other, ours)} × faster than {named(other)}, the fastest that is as good{bound}"


def named(point: Point) -> str:
    """A method with its setting."""
    if not point.setting:
        return point.method
    return f"{point.method} {'at' if point.setting[1:3] == 'e-' else 'with'} {point.setting}"


def _ratio(slow: Point, fast: Point) -> str:
    ratio = max(slow.seconds[1], 1e-9) / max(fast.seconds[1], 1e-9)
    return f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.2g}"


def _times(ours: Point, other: Point) -> str:
    if ours.seconds[1] <= other.seconds[1]:
        return f"1/{_ratio(other, ours)} of the time"
    return f"{_ratio(ours, other)} × the time"


def _digits(ours: Point, other: Point) -> str:
    """How many more decimals, of errors below the rounding of a float those of that."""
    count = round(math.log10(other.error / max(ours.error, 2.0 ** -53)))
    return f"{count} digit{'s' * (count != 1)}"


def _decade(error: float) -> str:
    """The decade just below an error."""
    return f"1e{math.ceil(math.log10(error)) - 1}"
