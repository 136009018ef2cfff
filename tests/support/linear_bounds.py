"""Random linear scenes, their motions in many digits, and how the printed bounds compare with the true errors.

    python -m support.linear_bounds COUNT SEED

The motion is that of ż = A z with the loads as further states (1, τ, cos Ωt, sin Ωt, e^{−t/T}), by Taylor's series of
e^{At} and squarings in integers, multiples of 2**-BITS, from the decimal numbers of the scene.
"""

import random
import sys
from contextlib import suppress
from fractions import Fraction
from itertools import pairwise
from statistics import median

import mpmath
import numpy as np
from mpmath import mp, mpf
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

DPS, LEAST = 60, 1e-40      # digits, and what is nothing in them
BITS, TERMS = 400, 12       # of integers: twice as many as the digits; of Taylor's series about an instant
KINDS = ("cos", "sin", "near", "step", "pulse", "ramp", "record", "square", "decay", "periodic", "constant")


def decimal(dice, low, high, digits=4):
    """A number as text, its logarithm evenly drawn."""
    return f"{10 ** dice.uniform(np.log10(low), np.log10(high)):.{digits}g}"


class LinearScene:
    """Masses in a row or a net: numbers as texts. loads: [(place, kind, its numbers)]."""

    def __init__(self, dice):
        self.n = dice.choice((1, 1, 2, 2, 3, 4, 6))
        stiff = dice.choice((1.0, 1e2, 1e4, 1e8))
        self.masses = [decimal(dice, 0.5, 5) for _ in range(self.n)]
        if dice.random() < 0.2:
            self.masses = [self.masses[0]] * self.n
        free, ends = dice.random() < 0.15, [(-1, 0)]
        ends = ([] if free else ends) + list(pairwise(range(self.n)))
        ends += [pair for pair in [(-1, self.n - 1), (0, self.n - 1)] if dice.random() < 0.3 and pair[0] != pair[1]]
        same = decimal(dice, 50, 2000)
        alike = dice.random() < 0.2
        self.springs = [(*pair, same if alike else decimal(dice, 50, 50 * stiff)) for pair in dict.fromkeys(ends)]
        if self.n == 1 and not free:
            self.springs = self.springs[:1]
        damped = dice.choice(("no", "no", "some", "all", "light", "critical"))
        self.dampers = []
        if damped == "some":
            self.dampers = [(*pair, decimal(dice, 0.1, 20)) for *pair, _ in self.springs[:1 + self.n // 2]]
        elif damped == "light":
            self.dampers = [(*pair, decimal(dice, 1e-4, 1e-2)) for *pair, _ in self.springs]
        elif damped == "all":
            share = Fraction(decimal(dice, 1e-3, 1e-1))
            self.dampers = [(i, j, str(float(Fraction(k) * share))) for i, j, k in self.springs]
        elif damped == "critical" and self.n == 1 and self.springs:
            w, m = dice.choice((2, 5, 10, 20)), Fraction(self.masses[0])
            self.springs = [(-1, 0, str(float(m * w * w)))]
            self.dampers = [(-1, 0, str(float(2 * m * w)))]
        self.start = [decimal(dice, 0.001, 0.1) if dice.random() < 0.6 else "0" for _ in range(self.n)]
        self.speeds = [decimal(dice, 0.01, 1) if dice.random() < 0.4 else "0" for _ in range(self.n)]
        self.speed = float(np.sqrt(np.abs(np.linalg.eigvals(np.linalg.solve(
            np.diag([float(m) for m in self.masses]), self._floats(self.springs)))).max())) or 1.0
        self.loads = [self._load(dice) for _ in range(dice.choice((0, 0, 1, 1, 2)))]
        long = 10 ** dice.choice((0.5, 1, 2, 3, 5, 7))
        self.times = sorted(decimal(dice, 0.01 * long / self.speed, long / self.speed, 6) for _ in range(3))

    def _floats(self, ties):
        found = np.zeros((self.n, self.n))
        for i, j, k in ties:
            row = np.zeros(self.n)
            for end, sign in ((i, -1.0), (j, 1.0)):
                if end >= 0:
                    row[end] = sign
            found += float(k) * np.outer(row, row)
        return found

    def _load(self, dice):
        kind, place, size = dice.choice(KINDS), dice.randrange(self.n), decimal(dice, 1, 100)
        rates = np.sqrt(np.abs(np.linalg.eigvals(np.linalg.solve(
            np.diag([float(m) for m in self.masses]), self._floats(self.springs)))))
        near = float(dice.choice(rates.tolist())) or 3.0
        rate = decimal(dice, 0.3 * near, 3 * near)
        if kind == "near":
            rate = repr(round(near * (1 + 10 ** -dice.uniform(3, 9)), 9))
        times = sorted({decimal(dice, 0.1 / near, 8 / near) for _ in range(6)}, key=float)
        values = [decimal(dice, 1, 100) for _ in times]
        return place, kind, (size, rate, times, values)

    def text(self):
        """The scene in the language."""
        name = ["ground", *(f"b{i}" for i in range(self.n))]
        lines = ["bodies:"] + [f"  b{i}: {{mass: {m} kg, slide: x{i}}}" for i, m in enumerate(self.masses)]
        for kind, ties, unit, key in (("springs", self.springs, "N/m", "k"), ("dampers", self.dampers, "N*s/m", "c")):
            lines += [f"{kind}:"] * bool(ties)
            lines += [f"  {key}{at}: {{{key}: {x} {unit}, between: [{name[i + 1]}, {name[j + 1]}]}}"
                      for at, (i, j, x) in enumerate(ties)]
        lines += ["forces:"] * bool(self.loads)
        lines += [f"  F{at}: {{at: b{place}, force: {_written(kind, *numbers)}}}"
                  for at, (place, kind, numbers) in enumerate(self.loads)]
        starts = [f"x{i}{prime}: {x} {unit}" for part, prime, unit in ((self.start, "", "m"), (self.speeds, "'", "m/s"))
                  for i, x in enumerate(part)]
        return "\n".join([*lines, f"initial: {{{', '.join(starts)}}}", "motion: small"]) + "\n"


def _written(kind, size, rate, times, values):
    """A load in the language."""
    if kind in ("cos", "near"):
        return f"{size} N*cos({rate} rad/s*t)"
    if kind == "sin":
        return f"{size} N*sin({rate} rad/s*t)"
    if kind == "step":
        return f"{size} N*step(t - {times[0]} s)"
    if kind == "pulse":
        return f"{size} N*(step(t - {times[0]} s) - step(t - {times[-1]} s))"
    if kind == "ramp":
        return f"{size} N/s*ramp(t - {times[0]} s)"
    if kind == "record":
        return " + ".join(f"{value} N/s*ramp(t - {time} s)*({sign}1)"
                          for time, value, sign in zip(times, values, _signs(times), strict=True))
    if kind == "constant":
        return f"{size} N"
    if kind == "square":
        return f"{size} N*square({rate} rad/s*t)"
    if kind == "decay":
        return f"{size} N*exp(-{rate} rad/s*t/20)"
    return f"{size} N*cos({rate} rad/s*t)^3"


def _signs(times):
    return ["" if at % 2 else "-" for at in range(len(times))]


class Exact:
    """The motion of a LinearScene in numbers of mpmath: z = (q, q̇, 1, τ, cosines, …)."""

    def __init__(self, scene):
        self.scene, self.n = scene, scene.n
        self.known = {}
        self.waves = []         # (cos, sin) pairs of rates, and decays: states that run by themselves
        number = lambda text: mpf(Fraction(text).numerator) / Fraction(text).denominator    # noqa: E731
        self.number = number
        self.cuts, self.jumps = {mpf(0)}, []
        for place, kind, (size, rate, times, values) in scene.loads:
            c, w, t = number(size), number(rate), [number(time) for time in times]
            if kind in ("cos", "near", "sin"):
                self.waves.append((place, c, w, kind == "sin"))
            elif kind == "periodic":
                self.waves += [(place, 3 * c / 4, w, False), (place, c / 4, 3 * w, False)]
            elif kind == "decay":
                self.waves.append((place, c, -w / 20, None))
            elif kind == "square":
                self.jumps.append((place, "square", c, w))
            else:
                steps = {"constant": [(mpf(0), c, 0)], "step": [(t[0], c, 0)],
                         "pulse": [(t[0], c, 0), (t[-1], -c, 0)], "ramp": [(t[0], c, 1)],
                         "record": [(at, (-1 if sign else 1) * number(v), 1)
                                    for at, v, sign in zip(t, values, _signs(t), strict=True)]}[kind]
                self.jumps.append((place, "steps", steps, None))
                self.cuts |= {at for at, *_ in steps}

    def until(self, t):
        """z at a time."""
        if t not in self.known:
            self.known[t] = self._until(t)
        return self.known[t]

    def _until(self, t):
        cuts = set(self.cuts)
        for _, kind, _, w in self.jumps:
            if kind == "square":
                count = int(t * w / mp.pi) + 2
                cuts |= {k * mp.pi / w for k in range(1, count)}
        cuts = sorted(cut for cut in cuts if cut < t)
        z, known = self.first(), {}
        for start, end in pairwise([*cuts, t]):
            A = self.matrix((start + end) / 2, start)
            z[2 * self.n + 1] = mpf(0)
            key = (tuple(A), mp.nstr(end - start, 50))
            if key not in known:
                known[key] = exponential(A, end - start)
            z = known[key] * z
        return z

    def first(self):
        """z at t = 0."""
        states = [self.number(x) for x in (*self.scene.start, *self.scene.speeds)] + [mpf(1), mpf(0)]
        for *_, odd in self.waves:
            states += [mpf(0), mpf(1)] if odd else [mpf(1), mpf(0)]
        return mp.matrix(states)

    def matrix(self, middle, start):
        """A between two cuts."""
        n, scene = self.n, self.scene
        size = 2 * n + 2 + 2 * len(self.waves)
        A = mp.zeros(size)
        for i in range(n):
            A[i, n + i] = mpf(1)
        masses = [self.number(m) for m in scene.masses]
        for ties, shift in ((scene.springs, 0), (scene.dampers, n)):
            for i, j, text in ties:
                for a, sa in ((i, -1), (j, 1)):
                    for b, sb in ((i, -1), (j, 1)):
                        if a >= 0 and b >= 0:
                            A[n + a, shift + b] -= sa * sb * self.number(text) / masses[a]
        A[2 * n + 1, 2 * n] = mpf(1)
        for at, (place, c, w, odd) in enumerate(self.waves):
            here = 2 * n + 2 + 2 * at
            A[n + place, here] += c / masses[place]
            if odd is None:
                A[here, here] = w
            else:       # (cos, −sin)' = …; of sin the states are (sin, cos)
                sign = 1 if odd else -1
                A[here, here + 1], A[here + 1, here] = sign * w, -sign * w
        for place, kind, data, w in self.jumps:
            if kind == "square":
                A[n + place, 2 * n] += (1 if mp.sin(w * middle) > 0 else -1) * data / masses[place]
                continue
            for at, c, power in data:
                if at <= start:
                    A[n + place, 2 * n] += c * (start - at if power else 1) / masses[place]
                    if power:
                        A[n + place, 2 * n + 1] += c / masses[place]
        return A

    def derivatives(self, i, t, orders):
        """Derivatives of coordinate i at a time, from the pieces that run then."""
        z = self.until(t)
        start = max(cut for cut in [*self.cuts, *self._turns(t)] if cut < t or not cut)
        A = self.matrix(start + (t - start) / 2, start)
        found = []
        for _ in range(max(orders) + 1):
            found.append(z[i])
            z = A * z
        return [found[order] for order in orders]

    def series(self, i, t):
        """x, ẋ and ẍ of coordinate i at t + τ, as functions of τ: Taylor's series, of little τ."""
        found = self.derivatives(i, t, range(TERMS + 3))
        return [lambda tau, rows=found[order:order + TERMS + 1]: mp.fsum(
            row * tau**k / mp.factorial(k) for k, row in enumerate(rows)) for order in range(3)]

    def _turns(self, t):
        return [k * mp.pi / w for _, kind, _, w in self.jumps if kind == "square"
                for k in range(1, int(t * w / mp.pi) + 1)]


def exponential(A, t):
    """e^{At} by Taylor's series and squarings."""
    A = A * t
    norm = max(sum(abs(A[i, j]) for j in range(A.cols)) for i in range(A.rows))
    halvings = max(0, int(mp.ceil(mp.log(norm, 2))) + 8) if norm else 0
    part = np.array([[int(mp.ldexp(x, BITS - halvings)) for x in row] for row in A.tolist()], object)
    term = total = np.array([[int(i == j) << BITS for j in range(A.cols)] for i in range(A.rows)], object)
    k = 1
    while abs(term).max() > 1:
        term = (term @ part >> BITS) // k
        total, k = total + term, k + 1
    for _ in range(halvings):
        total = total @ total >> BITS
    return mp.matrix([[mp.ldexp(x, -BITS) for x in row] for row in total.tolist()])


def compared(dice):
    """[(what, true error, bound, size)] of one scene; [] where the program refuses it."""
    scene = LinearScene(dice)
    found = []
    with mpmath.workdps(DPS):
        exact, solved = Exact(scene), problem(scene.text())
        try:
            signals = [(i, order, solved.response.signal(parse(f"x{i}" + "'" * order)))
                       for i in {0, scene.n - 1} for order in (0, 1, 2)]
        except PhysicsError:
            return scene, []
        for text in scene.times:
            t = exact.number(text)
            if any(kind == "square" and t * w > 300 for _, kind, _, w in exact.jumps):
                continue
            at = float(Fraction(text))
            values = {}
            for i, order, signal in signals:
                if i not in values:
                    values[i] = exact.derivatives(i, t, (0, 1, 2))
                value, true = float(signal.values(np.array([at]))[0]), values[i][order]
                found.append((f"x{i}{chr(39) * order}({text})", abs(value - true), signal.error(at), abs(true)))
        found += _tops(scene, exact, signals) + _passages(scene, exact, signals)
    return scene, found


def _passages(scene, exact, signals):
    """The first instants at which a signal passes zero."""
    found, (i, _, signal) = [], signals[0]
    for t in map(float, signal.zeros(0.0, 20 / scene.speed)[:3]):
        at = mpf(t)
        if not t or min(abs(at - cut) for cut in [*exact.cuts, *exact._turns(mpf(20) / scene.speed)]) < 1e-6 * t:
            continue
        x, v, _ = exact.series(i, at)
        for _ in range(4):
            slope = v(at - t)
            at -= x(at - t) / slope if slope else 0
        if abs(at - t) < 1e-3 / scene.speed:
            found.append((f"zero(x{i})", abs(t - at), signal.error_of_zero(t), at))
    return found


def outputs(dice):
    """The same of forces of springs and dampers, of accelerations, energies, products and functions of signals."""
    scene = LinearScene(dice)
    scene.times = scene.times[:2]
    scene.loads = [load for load in scene.loads if load[1] != "square"]
    found = []
    with mpmath.workdps(DPS):
        exact, solved = Exact(scene), problem(scene.text())
        for text in scene.times:
            t = exact.number(text)
            q = [exact.derivatives(i, t, (0, 1, 2)) for i in range(scene.n)]
            for asked, true in _read(scene, exact, q).items():
                try:
                    signal = solved.response.signal(parse(asked))
                    value = float(signal.values(np.array([float(text)]))[0])
                except PhysicsError:
                    continue
                found.append((f"({asked})({text})", abs(value - true), signal.error(float(text)), abs(true)))
    return scene, found


def _read(scene, exact, q):
    """{signal: its value} of the places, velocities and accelerations of all masses."""
    def across(i, j, order):
        return q[j][order] - (q[i][order] if i >= 0 else 0)

    last = scene.n - 1
    found = {"x0*x0'": q[0][0] * q[0][1], f"sin(x0/(1 m)) + x{last}'^2/(1 m^2/s^2)": mp.sin(q[0][0]) + q[last][1]**2,
             f"x{last}'' - x0''": q[last][2] - q[0][2],
             "T": sum(exact.number(m) * one[1]**2 / 2 for m, one in zip(scene.masses, q, strict=True))}
    for number, (i, j, k) in enumerate(scene.springs[:2]):
        found[f"k{number}.force"] = exact.number(k) * across(i, j, 0)
        found[f"k{number}.energy"] = exact.number(k) * across(i, j, 0)**2 / 2
    for number, (i, j, c) in enumerate(scene.dampers[:1]):
        found[f"c{number}.power"] = exact.number(c) * across(i, j, 1)**2
    return found


def _tops(scene, exact, signals):
    """The largest values within some periods, and where."""
    found, end = [], 20 / scene.speed
    for i, _, signal in signals[:1]:
        t, value = signal.extreme(0.0, end, 1)
        at = mpf(t)
        if not 0 < t < end or min(abs(at - cut) for cut in [*exact.cuts, *exact._turns(mpf(end))]) < 1e-6 * t:
            continue
        x, v, a = exact.series(i, at)
        for _ in range(4):
            slope, bend = v(at - t), a(at - t)
            if not bend or abs(slope / bend) > 1e-3 / scene.speed:
                return found
            at -= slope / bend
        true = x(at - t)
        found += [(f"max(x{i})", abs(value - true), signal.error(t), abs(true)),
                  (f"argmax(x{i})", abs(t - at), signal.error_of_time(t), at)]
    return found


def dynamic(exact, Omega):
    """K + iΩC − Ω²M of a scene in mpmath, times M⁻¹: from the matrix of its motion."""
    n, A = exact.n, exact.matrix(mpf(0), mpf(0))
    D = mp.matrix(n, n)
    for i in range(n):
        for j in range(n):
            D[i, j] = exact.number(exact.scene.masses[i]) * (
                -A[n + i, j] - mp.mpc(0, Omega) * A[n + i, n + j] - (Omega**2 if i == j else 0))
    return D


def harmonics(dice):
    """[(what, true error, bound, size)] of the frequency responses of one scene, at frequencies and at peaks, and of
    the steady state under a harmonic load where it is damped."""
    scene = LinearScene(dice)
    found, i, j = [], dice.randrange(scene.n), dice.randrange(scene.n)
    rate = decimal(dice, 0.2 * scene.speed, 1.5 * scene.speed, 6)
    kind = dice.choice(("cos", "square"))
    scene.loads = [(j, kind, ("3.7", rate, ["1"], ["1"]))]
    with mpmath.workdps(DPS):
        exact, solved = Exact(scene), problem(scene.text())

        def H(Omega):
            return mp.lu_solve(dynamic(exact, Omega), mp.matrix([int(k == j) for k in range(scene.n)]))[i]

        try:
            curve = solved.frequency_response(f"x{i}", f"x{j}")
            for text in (rate, decimal(dice, 0.01, 10)):
                value, error = curve.at(float(text))
                true = H(exact.number(text))
                found.append((f"frf({text})", abs(value - true), error * abs(value), abs(true)))
            peaks = curve.peaks
        except (PhysicsError, ZeroDivisionError):
            return scene, found
        for number, (Omega, value) in enumerate(peaks, 1):
            off, relative = curve.error_of_peak(number)
            if np.isfinite(value) and off < 0.01 * Omega:
                found += _peak(H, Omega, value, off, relative)
        with suppress(PhysicsError):
            if kind == "cos":
                found += _steady(solved, f"x{i}", mpf("3.7") * H(exact.number(rate)))
            else:
                found += _repeated(solved, f"x{i}", lambda n: H(n * exact.number(rate)) * 4 * mpf("3.7") / (n * mp.pi))
    return scene, found


def _peak(H, Omega, value, off, relative):
    try:
        at = mp.findroot(lambda at: mp.diff(lambda x: abs(H(x))**2, at, h=mpf(10)**-20), (mpf(Omega), mpf(Omega) + off))
    except (ValueError, ZeroDivisionError):
        return []
    if abs(at - Omega) > 1e-3 * Omega:
        return []
    return [("peak.Omega", abs(at - Omega), off, at), ("peak.value", abs(abs(H(at)) - value), relative * value, value)]


def _steady(solved, signal, X):
    rows = []
    for text, true in ((f"amplitude({signal})", abs(X)), (f"phase({signal})", -mp.arg(X * mp.mpc(0, 1))),
                       (f"rms({signal})", abs(X) / mp.sqrt(2))):
        value, error = measure(solved, parse(text))
        rows.append((text, abs(mp.re(mp.mpf(value) - true)), error * abs(value), abs(true)))
    return rows


def _repeated(solved, signal, harmonic):
    """Of the harmonics under a square wave."""
    rows = []
    for n in (1, 3):
        value, error = measure(solved, parse(f"harmonic[{n}]({signal})"))
        rows.append((f"harmonic[{n}]({signal})", abs(value - abs(harmonic(n))), error * abs(value), abs(value)))
    return rows


def free(dice):
    """The same of the free vibration of one degree of freedom: decrement, times, period, amplitude and phase."""
    m, k, x, v = (decimal(dice, 0.1, 10), decimal(dice, 10, 1e6), decimal(dice, 0.001, 1), decimal(dice, 0.01, 10))
    c = f"{2 * float(decimal(dice, 1e-7, 0.5)) * (float(m) * float(k)) ** 0.5:.5g}"
    text = (f"bodies: {{b: {{mass: {m} kg, slide: x}}}}\nsprings: {{s: {{k: {k} N/m, between: [ground, b]}}}}\n"
            f"dampers: {{d: {{c: {c} N*s/m, between: [ground, b]}}}}\ninitial: {{x: {x} m, x': {v} m/s}}\n")
    solved = problem(text)
    with mpmath.workdps(DPS):
        m, k, x, v, c = (mpf(Fraction(text).numerator) / Fraction(text).denominator for text in (m, k, x, v, c))
        decay = c / (2 * m)
        w = mp.sqrt(k / m - decay**2)
        A, rows = mp.hypot(x, (v + decay * x) / w), []
        phi, late = mp.atan2((v + decay * x) / w, x), mpf("1.7")
        for text, true in (("decrement(x)", 2 * mp.pi * decay / w), ("time_to[0.1](x)", mp.log(10) / decay),
                           ("cycles_to[0.1](x)", mp.log(10) / decay * w / (2 * mp.pi)), ("period(x)", 2 * mp.pi / w),
                           ("amplitude(x)", A), ("phase(x)", phi), ("envelope(x)(1.7 s)", A * mp.exp(-late * decay))):
            value, error = measure(solved, parse(text))
            rows.append((text, abs(value - true), error * abs(value), abs(true)))
    return text, rows


def survey(count, seed, drawn=compared):
    """(failures, [bound/error]) of scenes."""
    dice, failures, ratios = random.Random(seed), [], []
    for number in range(count):
        state = dice.getrandbits(64)
        _, rows = drawn(random.Random(state))
        for what, error, bound, size in rows:
            if error > max(bound, LEAST):
                failures.append((number, state, what, float(error), bound, float(size)))
            if error > LEAST:
                ratios.append((float(bound / error), what, state, float(bound / size) if size else 0.0))
    return failures, ratios


def main():
    count, seed = int(sys.argv[1]), int(sys.argv[2])
    for drawn in (compared, outputs, harmonics, free):
        print(drawn.__name__)
        _told(count, *survey(count, seed, drawn))


def _told(count, failures, ratios):
    sizes = sorted(ratio for ratio, *_ in ratios)
    for one in failures[:20]:
        print("exceeded", one)
    for one in sorted(ratios)[-8:]:
        print("loose", one)
    print(f"{count} scenes, {len(ratios)} numbers, {len(failures)} bounds exceeded, median bound/error "
          f"{median(sizes):.3g}, 90 % below {sizes[int(0.9 * len(sizes))]:.3g}, largest {sizes[-1]:.3g}")


if __name__ == "__main__":
    main()
