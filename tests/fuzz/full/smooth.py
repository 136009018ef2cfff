"""Scenes whose forces are smooth."""

from fractions import Fraction

import mpmath

from .scene import G, Moving, initial, solved

GRAVITY = "gravity: 9.81 m/s^2\n"


def pendulum(draw):
    """θ'' = −(g/L) sin θ − c θ'/(m L²) + T cos(W t)/(m L²)."""
    m, L, c = draw("m", 0.3, 4, "kg"), draw("L", 0.2, 2, "m"), draw("c", 0.001, 0.3, "N*m*s")
    T, W = draw("T", 0.01, 5, "N*m"), draw("W", 0.5, 6, "rad/s")
    start = [draw.number(-3, 3), draw.number(-3, 3)]
    text = f"""{GRAVITY}bodies: {{b: {{mass: m, at: [0, -L], pin: {{at: [0, 0], by: q}}}}}}
dampers: {{d: {{torsion: c, between: [ground, b]}}}}
forces: {{f: {{body: b, moment: T*cos(W*t)}}}}
"""

    def build(tape, t, y, mode):
        q, v = y
        a = -(q.sin_cos()[0] * (G / L)) - v * (c / (m * L * L)) + (t * W).sin_cos()[1] * (T / (m * L * L))
        return [v, a], {}, {}

    return text, ["q", "q'"], start, build


def free_pendulum(draw):
    """θ'' = −(g/L) sin θ, for long."""
    L = draw("L", 0.2, 2, "m")
    start = [draw.number(-2.5, 2.5), "0"]
    text = f"{GRAVITY}bodies: {{b: {{mass: 2 kg, at: [0, -L], pin: {{at: [0, 0], by: q}}}}}}\n"

    def build(tape, t, y, mode):
        q, v = y
        a = q.sin_cos()[0] * (-G / L)
        return [v, a], {}, {}

    return text, ["q", "q'"], start, build, draw.until(20, 60)


def duffing(draw):
    """m x'' = −k x − k₃ x³ − c x' + F cos(W t), two wells where k < 0."""
    m, k, k3 = draw("m", 0.5, 3, "kg"), draw("k", -9, 30, "N/m"), draw("k3", 1, 90, "N/m^3")
    c, F, W = draw("c", 0.01, 0.8, "N*s/m"), draw("F", 0.05, 8, "N"), draw("W", 0.5, 7, "rad/s")
    start = [draw.number(-1, 1), draw.number(-2, 2)]
    text = """bodies: {b: {mass: m, slide: x}}
springs: {s: {law: k*d + k3*d^3, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
forces: {f: {at: b, force: F*cos(W*t)}}
"""

    def build(tape, t, y, mode):
        x, v = y
        a = ((t * W).sin_cos()[1] * F - x * k - x * x * x * k3 - v * c) * (1 / m)
        return [v, a], {}, {}

    return text, ["x", "x'"], start, build


def double_pendulum(draw):
    """Absolute angles."""
    a, b = draw("a", 0.3, 3, "kg"), draw("b", 0.3, 3, "kg")
    L, K = draw("L", 0.3, 1.5, "m"), draw("K", 0.3, 1.5, "m")
    far = draw.random.choice((0.4, 1.5, 3.0))
    start = [draw.number(-far, far), draw.number(-far, far), draw.number(-1, 1), draw.number(-1, 1)]
    text = f"""{GRAVITY}points: {{P: {{body: upper, at: [0, -L]}}}}
bodies:
  upper: {{mass: a, at: [0, -L], pin: {{at: [0, 0], by: p}}}}
  lower: {{mass: b, at: [0, -L - K], pin: {{at: P, by: r}}}}
"""

    def build(tape, t, y, mode):
        p, r, u, w = y
        s, c = (p - r).sin_cos()
        M = [[tape.constant((a + b) * L * L), c * (b * L * K)], [c * (b * L * K), tape.constant(b * K * K)]]
        right = [-(s * w * w * (b * L * K)) - p.sin_cos()[0] * ((a + b) * G * L),
                 s * u * u * (b * L * K) - r.sin_cos()[0] * (b * G * K)]
        x = solved(M, right)
        return [u, w, *x], {}, {}

    return text, ["p", "r", "p'", "r'"], start, build, draw.until(1, 8)


def far_pendulum(draw):
    """A double pendulum let go from far up: chaotic, and followed for long."""
    L = draw("L", 0.5, 1.5, "m")
    start = [draw.number(2, 2.9), draw.number(2, 2.9), "0", "0"]
    text = f"""{GRAVITY}points: {{P: {{body: upper, at: [0, -L]}}}}
bodies:
  upper: {{mass: 1 kg, at: [0, -L], pin: {{at: [0, 0], by: p}}}}
  lower: {{mass: 1 kg, at: [0, -2*L], pin: {{at: P, by: r}}}}
"""

    def build(tape, t, y, mode):
        p, r, u, w = y
        s, c = (p - r).sin_cos()
        M = [[tape.constant(2), c], [c, tape.constant(1)]]
        x = solved(M, [-(s * w * w) - p.sin_cos()[0] * (2 * G / L), s * u * u - r.sin_cos()[0] * (G / L)])
        return [u, w, *x], {}, {"T + V": (u * u * 2 + w * w + c * u * w * 2) * (L * L / 2)
                                - p.sin_cos()[1] * (2 * G * L) - r.sin_cos()[1] * (G * L) + 3 * G * L}

    return text, ["p", "r", "p'", "r'"], start, build, draw.until(8, 30)


def relaxed(draw):
    """A light mass in thick oil on a hardening spring: stiff."""
    m, c, k, k3 = draw("m", 0.02, 0.1, "kg"), draw("c", 20, 200, "N*s/m"), draw("k", 50, 500, "N/m"), draw(
        "k3", 50, 5000, "N/m^3")
    start = [draw.number(0.1, 1), draw.number(-3, 3)]
    text = """bodies: {b: {mass: m, slide: x}}
springs: {s: {law: k*d + k3*d^3, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
"""

    def build(tape, t, y, mode):
        x, v = y
        pull = x * k + x * x * x * k3
        return [v, (-pull - v * c) * (1 / m)], {}, {"s.force": pull, "x^2 + x*x'/(1 rad/s)": x * x + x * v}

    return text, ["x", "x'"], start, build, draw.until(0.2, 1)


def triple_pendulum(draw):
    """Equal links, angles from the vertical."""
    L = draw("L", 0.3, 1.5, "m")
    far = draw.random.choice((0.3, 1.2))
    start = [draw.number(-far, far) for _ in range(3)] + ["0", "0", "0"]
    text = f"""{GRAVITY}points: {{P: {{body: one, at: [0, -L]}}, Q: {{body: two, at: [0, -2*L]}}}}
bodies:
  one: {{mass: 1.3 kg, at: [0, -L], pin: {{at: [0, 0], by: p}}}}
  two: {{mass: 1.3 kg, at: [0, -2*L], pin: {{at: P, by: r}}}}
  three: {{mass: 1.3 kg, at: [0, -3*L], pin: {{at: Q, by: s}}}}
"""

    def build(tape, t, y, mode):
        angles, speeds = y[:3], y[3:]
        weights = [[3, 2, 1], [2, 2, 1], [1, 1, 1]]
        M, right = [[None] * 3 for _ in range(3)], []
        for i in range(3):
            force = angles[i].sin_cos()[0] * (-(3 - i) * G / L)
            for j in range(3):
                if i == j:
                    M[i][j] = tape.constant(weights[i][j])
                    continue
                sine, cosine = (angles[i] - angles[j]).sin_cos()
                M[i][j] = cosine * weights[i][j]
                force = force - sine * speeds[j] * speeds[j] * weights[i][j]
            right.append(force)
        x = solved(M, right)
        return [*speeds, *x], {}, {}

    return text, ["p", "r", "s", "p'", "r'", "s'"], start, build, draw.until(1, 4)


def spring_pendulum(draw):
    """m r'' = −k (|r| − L) r/|r| − m g e_y, from the place where it is drawn."""
    m, k, L = draw("m", 0.5, 3, "kg"), draw("k", 20, 300, "N/m"), draw("L", 0.4, 1.5, "m")
    start = [draw.number(-0.3, 0.3), draw.number(-0.2, 0.2), draw.number(-1, 1), draw.number(-1, 1)]
    text = f"{GRAVITY}bodies: {{b: {{mass: m, at: [0, -L], move: [x, y, 0]}}}}\n" \
           "springs: {s: {k: k, between: [[0, 0], b], free_length: L}}\n"

    def build(tape, t, y, mode):
        x, h, u, w = y
        down = h - L
        pull = (1 - L / (x * x + down * down).sqrt()) * (-k / m)
        return [u, w, pull * x, pull * down - G], {}, {
            "s.force": ((x * x + down * down).sqrt() - L) * k, "b.y": h, "s.energy": (
                (x * x + down * down).sqrt() - L) ** 2 * (k / 2)}

    return text, ["x", "y", "x'", "y'"], start, build


def cart_with_pendulum(draw):
    """A cart on a spring, driven by its wall, with a pendulum."""
    M, m, k = draw("M", 1, 6, "kg"), draw("m", 0.3, 3, "kg"), draw("k", 20, 400, "N/m")
    L, A, W = draw("L", 0.3, 1.2, "m"), draw("A", 0.005, 0.2, "m"), draw("W", 0.5, 9, "rad/s")
    start = [draw.number(-0.3, 0.3), draw.number(-2, 2), draw.number(-1, 1), draw.number(-2, 2)]
    text = f"""{GRAVITY}bodies:
  cart: {{mass: M, at: [0, 0], slide: x}}
  bob: {{mass: m, at: [0, -L], pin: {{at: [0, 0], carrier: cart, by: q}}}}
springs: {{s: {{k: k, stretch: x - A*sin(W*t)}}}}
"""

    def build(tape, t, y, mode):
        x, q, u, w = y
        s, c = q.sin_cos()
        wall = (t * W).sin_cos()[0] * A
        a = solved([[tape.constant(M + m), c * (m * L)], [c * (m * L), tape.constant(m * L * L)]],
                   [(wall - x) * k + s * w * w * (m * L), s * (-m * G * L)])
        return [u, w, *a], {}, {}

    return text, ["x", "q", "x'", "q'"], start, build, draw.until(2, 8)


def two_wells(draw):
    """Two coordinates in a potential (Hénon & Heiles): their motion may be chaotic."""
    k, b = draw("k", 4, 30, "N/m"), draw("b", 4, 20, "N/m^2")
    start = [draw.number(-0.3, 0.3), draw.number(-0.3, 0.3), draw.number(-0.5, 0.5), draw.number(-0.5, 0.5)]
    text = """bodies: {b: {mass: 1 kg, at: [0, 0], move: [x, y, 0]}}
energies: {V: k*(x^2 + y^2)/2 + b*(x^2*y - y^3/3) + k*(x^2 + y^2)^2/(1 m^2)}
"""

    def build(tape, t, y, mode):
        x, h, u, w = y
        bent = (x * x + h * h) * (4 * k)
        ax = -(x * k) - x * h * (2 * b) - bent * x
        ah = -(h * k) - (x * x - h * h) * b - bent * h
        return [u, w, ax, ah], {}, {}

    return text, ["x", "y", "x'", "y'"], start, build


def tied_blocks(draw):
    """Two blocks on a light rod between a wall and a floor: x = L sin q, y = L cos q where the rod leans."""
    a, b, L, k = draw("a", 0.5, 3, "kg"), draw("b", 0.5, 3, "kg"), draw("L", 0.6, 1.5, "m"), draw("k", 20, 200, "N/m")
    text = f"""{GRAVITY}points:
  A: {{body: floor, at: [0.6*L, 0]}}
  B: {{body: wall, at: [0, 0.8*L]}}
bodies:
  floor: {{mass: a, at: [0.6*L, 0], slide: x}}
  wall: {{mass: b, at: [0, 0.8*L], slide: {{along: [0, 1], by: y}}}}
springs: {{s: {{k: k, stretch: x}}}}
constraints: {{rod: {{link: [A, B]}}}}
"""
    speed = draw.number(0.2, 1.5)
    with mpmath.workdps(50):
        start = [mpmath.asin(mpmath.mpf(3) / 5), Fraction(speed) / (L * Fraction(4, 5))]

    def build(tape, t, y, mode):
        q, w = y
        s, c = q.sin_cos()
        x = s * L - L * Fraction(3, 5)
        force = s * (b * G * L) - x * c * (k * L) - s * c * w * w * (L * L * (b - a))
        return [w, force / (c * c * (a * L * L) + s * s * (b * L * L))], {}, {
            "x": x, "x'": c * w * L, "y": c * L - L * Fraction(4, 5), "y'": -(s * w * L)}

    return text + f"initial: {{x: 0 m, x': {speed} m/s}}\n", ["q", "q'"], start, build, draw.until(0.3, 3)


def rolling_disc(draw):
    """A disc rolls in a circular track: 3/2 (R − r) q'' = −g sin q, φ = −(R − r) q/r."""
    r, R = draw("r", 0.03, 0.2, "m"), draw("R", 0.4, 1.5, "m")
    far = R - r
    start = [draw.number(-9, 9), draw.number(-3, 3)]
    text = f"""{GRAVITY}surfaces: {{track: {{circle: [0, 0], radius: R, side: inside}}}}
bodies: {{d: {{shape: disc, mass: 0.7 kg, radius: r, at: [0, r - R], roll: {{surface: track, turn: q}}}}}}
"""

    def build(tape, t, y, mode):
        q, v = y
        a = (q * (r / far)).sin_cos()[0] * (-G * Fraction(2, 3) / r)
        return [v, a], {}, {}

    return text, ["q", "q'"], start, build


def heavy_start(draw):
    """From rest in equilibrium, √ of the data, a load that swings: m x'' = m g − k x − k₃ x³ + F sin(W t)."""
    m, k, k3 = draw("m", 0.5, 3, "kg"), draw("k", 20, 300, "N/m"), draw("k3", 30, 3000, "N/m^3")
    F, W = draw("F", 0.5, 9, "N"), draw("W", 1, 20, "rad/s")
    text = f"""{GRAVITY}bodies: {{b: {{mass: m, at: [0, 0], slide: {{along: [0, -1], by: x}}}}}}
springs: {{s: {{law: k*d + k3*d^3, stretch: x}}}}
forces: {{f: {{at: b, force: [0, -F*sin(W*t)]}}}}
"""
    with mpmath.workdps(50):
        load, stiff, bend = (mpmath.mpf(one.numerator) / one.denominator for one in (m * G, k, k3))
        rest = mpmath.findroot(lambda x: stiff * x + bend * x**3 - load, float(m * G / k) / 2)

    def build(tape, t, y, mode):
        x, v = y
        a = (m * G - x * k - x * x * x * k3 + (t * W).sin_cos()[0] * F) * (1 / m)
        return [v, a], {}, {}

    return text, ["x", "x'"], [rest, 0], build


def driven_pivot(draw):
    """A pendulum whose pivot is driven up and down: L q'' = −(g − A W² cos W t) sin q − c/(m L) q'."""
    m, L, c = draw("m", 0.5, 3, "kg"), draw("L", 0.3, 1.5, "m"), draw("c", 0.002, 0.2, "N*m*s")
    A, W = draw("A", 0.01, 0.2, "m"), draw("W", 2, 15, "rad/s")
    start = [draw.number(-2, 2), draw.number(-2, 2)]
    text = f"""{GRAVITY}points: {{P: {{at: [0, 0], moves: [0, A*cos(W*t)]}}}}
bodies: {{b: {{mass: m, at: [0, -L], pin: {{at: P, by: q}}}}}}
dampers: {{d: {{torsion: c, between: [ground, b]}}}}
"""

    def build(tape, t, y, mode):
        q, v = y
        lift = (t * W).sin_cos()[1] * (A * W * W)
        a = (lift - G) * q.sin_cos()[0] * (1 / L) - v * (c / (m * L * L))
        return [v, a], {}, {}

    return text, ["q", "q'"], start, build


KINDS = (far_pendulum, relaxed, pendulum, free_pendulum, duffing, double_pendulum, triple_pendulum, spring_pendulum,
         cart_with_pendulum, two_wells, tied_blocks, rolling_disc, heavy_start, driven_pivot)


def moving(kind, draw):
    """The Moving of a kind."""
    text, names, start, build, *until = kind(draw)
    rest = "" if kind in (heavy_start, tied_blocks) else initial(names, start)
    return Moving(kind.__name__, "motion: full\n" + draw.parameters + text + rest, names, start,
                  until[0] if until else draw.until(), build)
