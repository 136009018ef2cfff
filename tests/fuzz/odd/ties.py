"""What holds between coordinates: each condition as a jet that has to stay zero."""

import mpmath
import numpy as np

from . import jets
from .places import Bodies, length

SIDES = {"over": (0, 1), "under": (0, -1), "left_of": (-1, 0), "right_of": (1, 0)}


def conditions(figure, bodies):
    """The conditions of all constraints of a scene, zero as drawn."""
    found = []
    for tie in figure.scene.get("constraints", {}).values():
        if not isinstance(tie, dict):
            tie = {"equation": tie}
        kind = next(k for k in ("equation", "rope", "gear", "belt", "join", "link", "point") if k in tie)
        found += globals()["_" + kind](figure, bodies, tie)
    return found


def _equation(figure, bodies, tie):
    left, right = str(tie["equation"]).split("=")
    return [figure.whole(left, bodies.known) - figure.whole(right, bodies.known)]


def _turn_of(bodies, name):
    words = bodies.figure.scene["bodies"][name]
    return bodies.change(words["turn"]) if "turn" in words else bodies[name].angle


def _wheels(figure, bodies, pair, tie):
    carrier = bodies[tie["carrier"]].angle if "carrier" in tie else 0
    radii = [figure.number(r) for r in tie["radii"]] if "radii" in tie else [figure.bodies[b].radius for b in pair]
    return [r * (_turn_of(bodies, body) - carrier) for r, body in zip(radii, pair, strict=True)]


def _gear(figure, bodies, tie):
    one, two = _wheels(figure, bodies, tie["gear"], tie)
    return [one - two if tie.get("inside") else one + two]


def _belt(figure, bodies, tie):
    one, two = _wheels(figure, bodies, tie["belt"], tie)
    return [one + two if tie.get("crossed") else one - two]


def _join(figure, bodies, tie):
    (ax, ay), (bx, by) = (bodies.place(end) for end in tie["join"])
    return [ax - bx, ay - by]


def _link(figure, bodies, tie):
    (ax, ay), (bx, by) = (bodies.place(end) for end in tie["link"])
    (px, py), (qx, qy) = (figure.drawn_end(end) for end in tie["link"])
    return [length(bx - ax, by - ay) - length(qx - px, qy - py)]


def _point(figure, bodies, tie):
    surface = figure.scene["surfaces"][tie["surface"]]
    x, y = bodies.place(tie["point"])
    if "body" in surface:                   # seen from the surface
        under = bodies[surface["body"]]
        x, y = x - under.x, y - under.y
        x, y = under.c * x + under.s * y, under.c * y - under.s * x
    if "line" in surface:
        (ax, ay), (bx, by) = (figure.place(p) for p in surface["line"])
        size = length(bx - ax, by - ay)
        return [(bx - ax) / size * (y - ay) - (by - ay) / size * (x - ax)]
    if "circle" in surface:
        cx, cy = figure.place(surface["circle"])
        px, py = figure.drawn_end(tie["point"])
        return [length(x - cx, y - cy) - length(px - cx, py - cy)]
    return [y - figure.curve(surface, x)]


class _Stop:
    """What a rope passes: its centre now and as drawn, its radius with the sign of the way round, how it has turned."""

    def __init__(self, figure, bodies, stop):
        self.drum = isinstance(stop, dict)
        self.side = next((SIDES[word] for word in SIDES if word in stop), None) if self.drum else None
        end = next((stop[word] for word in SIDES if word in stop), None) if self.drum else stop
        body = end if isinstance(end, str) and end in figure.bodies else None
        round_ = body is not None and self.drum
        self.now = bodies.circle(body) if round_ else bodies.place(end)
        self.drawn = figure.bodies[body].circle if round_ else figure.drawn_end(end)
        radius = figure.bodies[body].radius if body else 0
        self.radius = (figure.number(stop["radius"]) if "radius" in stop else radius) if self.drum else 0
        self.holds = round_ and any(k in figure.scene["bodies"][body] for k in ("pin", "roll", "move"))
        self.angle = bodies[body].angle if round_ else 0


def _rope(figure, bodies, tie):
    """No slip on what turns: the rope between two marks on neighbouring drums keeps its length.

    With ρ the radius, positive where the rope goes round counter-clockwise, and β the direction of a straight part:
    length + Σ ρ (β after − β before) over what it slides round, ρ (β − angle) at the drum it leaves, less that at the
    drum it reaches.
    """
    stops = [_Stop(figure, bodies, stop) for stop in tie["rope"]]
    for i, stop in enumerate(stops):
        before, after = stops[max(i - 1, 0)], stops[min(i + 1, len(stops) - 1)]
        dx, dy = (jets.real(b - a) for a, b in zip(before.drawn, after.drawn, strict=True))
        if stop.drum:
            stop.round = stop.radius * (1 if stop.side[0] * dy - stop.side[1] * dx > 0 else -1)
        else:
            stop.round = 0
    found, total = [], 0
    for i in range(len(stops) - 1):
        one, two = stops[i], stops[i + 1]
        part, turned = _straight(one, two)
        total = total + part + (one.round - two.round) * turned
        if one.holds:
            total = total - one.round * one.angle
        if two.holds:
            total = total + two.round * two.angle
            found.append(total)
            total = 0
    return found if stops[-1].holds else [*found, total]


def _straight(one, two):
    """(growth of the straight part between two circles since it was drawn, how far it has turned since)."""
    def part(a, b):
        dx, dy = b[0] - a[0], b[1] - a[1]
        off = two.round - one.round
        free = jets.sqrt(dx * dx + dy * dy - off * off)
        return dx, dy, off, free

    x, y, off, free = part(one.now, two.now)
    x0, y0, _, free0 = part(one.drawn, two.drawn)
    turned = jets.angle(x0 * x + y0 * y, x0 * y - y0 * x)
    lean = jets.angle(free * free0 + off * off, off * (free0 - free)) if jets.real(off) else 0
    return free - free0, turned - lean


def solve(figure, known, tied, guess):
    """The values of the coordinates that the conditions tie, by Newton's method from a guess."""
    values = list(guess)
    for _ in range(50):
        at = jets.variables(np.array(values))
        found = conditions(figure, Bodies(figure, {**known, **dict(zip(tied, at, strict=True))}))
        found = [jet if isinstance(jet, jets.Jet) else 0 * at[0] + jet for jet in found]
        slopes = np.array([jet.g for jet in found])
        change = _solved(slopes, np.array([jet.v for jet in found]))
        values = [value - step for value, step in zip(values, change, strict=True)]
        if max(abs(step) for step in change) <= 1e-14 * max(1, *map(abs, values)):
            last = _solved(slopes, _residuals(figure, known, tied, values))
            return [value - step for value, step in zip(values, last, strict=True)]
    raise ArithmeticError("the conditions cannot be solved")


def _residuals(figure, known, tied, values):
    found = conditions(figure, Bodies(figure, {**known, **dict(zip(tied, values, strict=True))}))
    return np.array([jets.plain(jet) for jet in found])


def as_jets(figure, known, tied, values, at):
    """The tied coordinates as jets of the others: two steps of Newton's method give both derivatives."""
    own = jets.variables(np.array(values))
    numbers = {name: jet.v for name, jet in known.items()}
    slopes = np.array([(jet if isinstance(jet, jets.Jet) else 0 * own[0]).g for jet in conditions(
        figure, Bodies(figure, {**numbers, **dict(zip(tied, own, strict=True))}))])
    found = [0 * at[0] + value for value in values]
    inverse = _solved(slopes, np.eye(len(tied), dtype=slopes.dtype))
    for _ in range(2):
        left = conditions(figure, Bodies(figure, {**known, **dict(zip(tied, found, strict=True))}))
        found = [jet - sum(inverse[i, j] * left[j] for j in range(len(left))) for i, jet in enumerate(found)]
    return dict(zip(tied, found, strict=True))


def _solved(A, b):
    if A.dtype != object:
        return np.linalg.solve(A, b)
    found = mpmath.matrix(A.tolist()) ** -1 * mpmath.matrix(b.tolist())
    return np.array(found.tolist(), dtype=object).reshape(b.shape)
