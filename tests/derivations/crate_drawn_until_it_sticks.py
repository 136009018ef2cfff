"""Half a swing at a time: (m + M) x'' = M g ∓ R − k x, about centres (M g ∓ R)/k with the one circular frequency, until
at a turning point friction can hold what the spring leaves; the rope carries M (g − x'')."""
from math import pi, sqrt


def answers(p):
    m, M, k, R, g = (p[n] for n in ("m", "M", "k", "R", "g"))
    omega, x, sense, turns = sqrt(k / (m + M)), 0.0, 1.0, []

    def rope(x, sense):
        return M * (g - (M * g - sense * R - k * x) / (m + M))

    largest = rope(0.0, 1.0)
    while abs(M * g - k * x) > R:
        centre = (M * g - sense * R) / k
        other = 2 * centre - x
        largest = max(largest, rope(x, sense), rope(other, sense))       # of a swing at its ends
        x, sense = other, -sense
        turns.append(x)
    return {"rope.force(0 s)": rope(0.0, 1.0), "max(rope.force)": largest, "max(x)": max(turns),
            "argmax(x)": pi / omega, "zero[3](x')": len(turns) * pi / omega, "x(t1)": x, "rope.force(t1)": M * g,
            "s.force(t1)": k * x, "rub.force(t1)": M * g - k * x, "crate.reaction.y(t1)": m * g}
