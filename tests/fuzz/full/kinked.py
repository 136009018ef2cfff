"""Scenes with forces that bend, jump, stick or strike."""

from .scene import G, Moving, initial


def quadratic_damper(draw):
    """m x'' = −k x − c x' |x'|."""
    m, k, c = draw("m", 0.5, 3, "kg"), draw("k", 20, 300, "N/m"), draw("c", 0.1, 8, "N*s^2/m^2")
    start = [draw.number(-1, 1), draw.number(0.1, 3)]
    text = """bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {law: c*v*abs(v), between: [ground, b]}}
"""

    def build(tape, t, y, mode):
        x, v = y
        a = (-(x * k) - v * v * (c * mode)) * (1 / m)
        return [v, a], {"turn": v}, {}

    return text, ["x", "x'"], start, build, 1, lambda mode, name, y: (-mode, y)


def one_sided(draw):
    """A block between a spring and a stop with a gap, which only pushes."""
    m, k, K = draw("m", 0.5, 3, "kg"), draw("k", 10, 100, "N/m"), draw("K", 100, 3000, "N/m")
    gap, F, W = draw("e", 0.01, 0.2, "m"), draw("F", 0.1, 8, "N"), draw("W", 0.5, 9, "rad/s")
    start = ["0", draw.number(0.5, 3)]
    text = """bodies: {b: {mass: m, slide: x}}
springs:
  s: {k: k, stretch: x}
  stop: {k: K, stretch: x, acts: tension, gap: e}
forces: {f: {at: b, force: F*sin(W*t)}}
"""

    def build(tape, t, y, mode):
        x, v = y
        a = ((t * W).sin_cos()[0] * F - x * k) * (1 / m)
        if mode:
            a = a - (x - gap) * (K / m)
        return [v, a], {"meet": x - gap}, {}

    return text, ["x", "x'"], start, build, 0, lambda mode, name, y: (1 - mode, y)


def dry_friction(draw):
    """m x'' = −k x − R sign(x'), until it sticks; R as in motion holds at rest."""
    m, k, R = draw("m", 0.5, 3, "kg"), draw("k", 50, 400, "N/m"), draw("R", 0.5, 6, "N")
    start = [draw.number(0.1, 0.5), "0"]
    text = """bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {floor: {friction: R, stretch: x}}
"""
    if float(start[0]) * float(k) <= float(R) * 1.2:
        start[0] = f"{2.5 * float(R / k):.3g}"

    def build(tape, t, y, mode):
        x, v = y
        if not mode:
            return [tape.constant(0), tape.constant(0)], {}, {}
        a = (-(x * k) - R * mode) * (1 / m)
        return [v, a], {"rest": v}, {}

    def turn(mode, name, y):
        from support.taylor import fixed

        held = abs(y[0]) * k <= fixed(R)
        return (0, [y[0], 0]) if held else (-mode, y)

    return text, ["x", "x'"], start, build, -1, turn


def carried_friction(draw):
    """Two blocks on springs in a row, one of them on a rough floor, the other one smooth."""
    a, b, R = draw("a", 0.5, 3, "kg"), draw("b", 0.5, 3, "kg"), draw("R", 0.5, 6, "N")
    k, K = draw("k", 50, 400, "N/m"), draw("K", 50, 400, "N/m")
    start = ["0.2", draw.number(-0.5, 0.5), draw.number(0.2, 1), draw.number(-2, 2)]
    text = """bodies:
  one: {mass: a, slide: x}
  two: {mass: b, slide: y}
springs:
  s: {k: k, stretch: x}
  r: {k: K, stretch: y - x}
dampers: {floor: {friction: R, stretch: x}}
"""

    def build(tape, t, y, mode):
        x, h, u, w = y
        pull, back = (h - x) * K - x * k, (x - h) * (K / b)
        if not mode:
            return [tape.constant(0), w, tape.constant(0), back], {"up": pull - R, "down": pull + R}, {}
        return [u, w, (pull - R * mode) * (1 / a), back], {"rest": u}, {}

    def turn(mode, name, y):
        from support.taylor import fixed

        if name in ("up", "down"):
            return (1 if name == "up" else -1), y
        pull = (y[1] - y[0]) * K - y[0] * k
        if abs(pull) <= fixed(R):
            return 0, [y[0], y[1], 0, y[3]]
        return (1 if pull > 0 else -1), y

    return text, ["x", "y", "x'", "y'"], start, build, 1, turn


def driven_friction(draw):
    """The same on a belt: slip alone, driven by a spring whose end moves, friction smaller than the drive: m x'' =
    −k (x − A sin W t) − R sign(x'); it never sticks for long, but it may."""
    m, k, R = draw("m", 0.5, 3, "kg"), draw("k", 50, 400, "N/m"), draw("R", 0.2, 3, "N")
    A, W = draw("A", 0.05, 0.4, "m"), draw("W", 2, 12, "rad/s")
    start = [draw.number(0.1, 0.5), draw.number(0.3, 2)]
    text = """points: {P: {at: [-1 m, 0], moves: [A*sin(W*t), 0]}}
bodies: {b: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [P, b]}}
dampers: {floor: {friction: R, stretch: x}}
"""

    def build(tape, t, y, mode):
        x, v, clock = y
        pull = ((clock * W).sin_cos()[0] * A - x) * k
        one, none = tape.constant(1), tape.constant(0)
        if not mode:
            return [none, none, one], {"up": pull - R, "down": pull + R}, {}
        a = (pull - R * mode) * (1 / m)
        return [v, a, one], {"rest": v}, {}

    def turn(mode, name, y):
        import mpmath
        from support.taylor import fixed, real

        if name in ("up", "down"):
            return (1 if name == "up" else -1), y
        with mpmath.workdps(45):
            pull = (mpmath.mpf(A.numerator) / A.denominator * mpmath.sin(real(y[2]) * W.numerator / W.denominator)
                    - real(y[0])) * k.numerator / k.denominator
        if abs(fixed(pull)) <= fixed(R):
            return 0, [y[0], 0, y[2]]
        return (1 if pull > 0 else -1), y

    return text, ["x", "x'", "clock"], [*start, "0"], build, 1, turn


def steps(draw):
    """A pendulum on which a moment begins, and ends: T (step(t − t1) − step(t − t2))."""
    m, L, T = draw("m", 0.5, 3, "kg"), draw("L", 0.3, 1.5, "m"), draw("T", 0.5, 9, "N*m")
    t1, t2 = draw("t1", 0.2, 1, "s"), draw("t2", 1.1, 2, "s")
    start = [draw.number(-1, 1), draw.number(-1, 1)]
    text = """gravity: 9.81 m/s^2
bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: q}}}
forces: {f: {body: b, moment: T*(step(t - t1) - step(t - t2))}}
"""

    def build(tape, t, y, mode):
        q, v = y
        a = q.sin_cos()[0] * (-G / L) + (T / (m * L * L) if mode else 0)
        return [v, a], {}, {}

    return text, ["q", "q'"], start, build, 0, lambda mode, name, y: (1 - mode, y), (t1, t2)


def blows(draw):
    """A pendulum struck at its bob: P across it at t1, along x: L q' jumps by P cos q/m."""
    m, L, P = draw("m", 0.5, 3, "kg"), draw("L", 0.3, 1.5, "m"), draw("P", 0.2, 4, "N*s")
    t1 = draw("t1", 0.2, 1.5, "s")
    start = [draw.number(-1, 1), draw.number(-1, 1)]
    text = """gravity: 9.81 m/s^2
bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: q}}}
forces: {f: {at: b, force: [P*impulse(t - t1), 0]}}
"""

    def build(tape, t, y, mode):
        q, v = y
        a = q.sin_cos()[0] * (-G / L)
        return [v, a], {}, {}

    def turn(mode, name, y):
        import mpmath
        from support.taylor import fixed, real

        with mpmath.workdps(45):
            size = P / (m * L)
            return mode, [y[0], y[1] + fixed(mpmath.cos(real(y[0])) * size.numerator / size.denominator)]

    return text, ["q", "q'"], start, build, 0, turn, (t1,)


KINDS = (carried_friction, quadratic_damper, one_sided, dry_friction, driven_friction, steps, blows)


def moving(kind, draw):
    """The Moving of a kind."""
    text, names, start, build, mode, turn, *times = kind(draw)
    given = [(name, value) for name, value in zip(names, start, strict=True) if name != "clock"]
    return Moving(kind.__name__, "motion: full\n" + draw.parameters + text + initial(*zip(*given, strict=True)), names,
                  start, draw.until(2, 6), build, mode, turn, times[0] if times else ())
