"""Error, stated bound and the error of the plain method over the knob of a family, both logarithmic."""

from collections.abc import Callable, Sequence

from vibcli.evidence.stress.point import REFUSED, StressPoint
from vibcli.evidence.stress.sweep import FamilyPoints, about
from vibcli.plots.figure import Curve, Figure, Panel

LEAST, MOST = 1e-18, 10.0       # between which errors are drawn
BELOW = 10.0                    # by which a zero stands left of the least value


def figure(one: FamilyPoints) -> Figure:
    """One panel; a zero of the knob stands at its left end."""
    places = _places([float(point.knob) for point in one.points])

    def curve(label: str, read: Callable[[StressPoint], float | None], kind: str = "line") -> Curve:
        pairs = [(x, read(point)) for x, point in zip(places, one.points, strict=True)]
        known = [(x, y if y is None else min(max(y, LEAST), MOST)) for x, y in pairs if y is not None]
        return Curve(label, tuple(x for x, _ in known), tuple(y for _, y in known), kind)

    curves = [curve("plain method", lambda point: point.plain), curve("stated bound", lambda point: point.bound),
              curve("true error", lambda point: point.error)]
    if any(point.verdict == REFUSED for point in one.points):
        curves.append(curve("refused", lambda point: MOST if point.verdict == REFUSED else None, "markers"))
    return Figure(about(one.name), (Panel(one.family.knob, "relative error", True, True, tuple(curves),
                                          y_range=(LEAST, 3 * MOST)),))


def _places(values: Sequence[float]) -> list[float]:
    least = min(abs(x) for x in values if x)
    return [abs(x) or least / BELOW for x in values]


def drawn(one: FamilyPoints, kind: str) -> bytes:
    """The bytes of its picture."""
    from vibcli.plots.picture import picture

    return picture(figure(one), kind)
