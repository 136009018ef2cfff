"""Signals of random chains to 30 digits against exponentials of matrices written by hand: springs, dampers, a driven
wall, loads that oscillate, rise, die out and begin later."""

import random
from fractions import Fraction

import mpmath
import pytest
from support.scenes import problem
from support.signals import signal_of

from vibcli.results.escalation import value_of_signal

DIGITS = 30


class Chain:
    """n masses between a driven wall and the ground: the scene as text, and ż = G z with the loads within z."""

    def __init__(self, seed):
        dice = random.Random(f"precise {seed}")
        self.n = n = dice.randint(1, 3)
        self.masses, self.springs, self.dampers = (
            [dice.choice(values) for _ in range(count)] for values, count in (
                (("0.7", "1", "2.3"), n), (("40", "90.5", "300"), n + 1), (("0", "0.3", "2.1"), n)))
        self.wall = dice.choice(["0.05", "0.2"]), dice.choice(["1.7", "9.1"])
        self.load = dice.choice(["3", "0.8"]), dice.choice(["6.283", "11"])
        self.later = Fraction(dice.choice(["0.5", "1.3"]))
        self.start = [dice.choice(["0", "0.01", "-0.02"]) for _ in range(2 * n)]

    @property
    def text(self):
        names = ["wall", *(f"b{i}" for i in range(self.n)), "ground"]
        bodies = "".join(f"  b{i}: {{mass: {m} kg, slide: x{i}}}\n" for i, m in enumerate(self.masses))
        springs = "".join(f"  s{i}: {{k: {k} N/m, between: [{names[i]}, {names[i + 1]}]}}\n"
                          for i, k in enumerate(self.springs))
        dampers = "".join(f"  d{i}: {{c: {c} N*s/m, between: [ground, b{i}]}}\n" for i, c in enumerate(self.dampers)
                          if c != "0")
        start = "".join(f"  x{i}: {x} m\n  x{i}': {v} m/s\n" for i, (x, v) in enumerate(
            zip(self.start[:self.n], self.start[self.n:], strict=True)))
        later = float(self.later)
        return (f"bodies:\n  wall: {{slide: {self.wall[0]} m*sin({self.wall[1]} rad/s*t)}}\n{bodies}springs:\n{springs}"
                + (f"dampers:\n{dampers}" if dampers else "")
                + f"forces:\n  f: {{at: b0, force: {self.load[0]} N*cos({self.load[1]} rad/s*t)}}\n"
                f"  g: {{at: b{self.n - 1}, force: 2 N/s*(t - {later} s)*step(t - {later} s)}}\ninitial:\n{start}")

    def late(self, t):
        """x₀, v₀ and the force of the first spring long after, the load that rises taken away."""
        z = mpmath.matrix([*map(mpmath.mpf, self.start), 0, 1, 1, 0, 1, 0])
        z = mpmath.expm(self.generator(False) * t, method="taylor") * z
        return z[0], z[self.n], mpmath.mpf(self.springs[0]) * (z[0] - mpmath.mpf(self.wall[0]) * z[2 * self.n])

    def generator(self, on):
        """G of z = (x, v, sin, cos of the wall, cos, sin of the load, 1, time since `later` where that is on)."""
        n, number = self.n, mpmath.mpf
        G = mpmath.zeros(2 * n + 6)
        m, k, c = (list(map(number, part)) for part in (self.masses, self.springs, self.dampers))
        for i in range(n):
            G[i, n + i] = 1
            G[n + i, i] -= (k[i] + k[i + 1]) / m[i]
            G[n + i, n + i] -= c[i] / m[i]
            if i:
                G[n + i, i - 1] += k[i] / m[i]
            if i + 1 < n:
                G[n + i, i + 1] += k[i + 1] / m[i]
        W, Omega, w = number(self.wall[1]), number(self.load[1]), 2 * n
        G[n, w] += k[0] * number(self.wall[0]) / m[0]
        G[n, w + 2] += number(self.load[0]) / m[0]
        G[2 * n - 1, w + 5] += 2 / m[-1] if on else 0
        G[w, w + 1], G[w + 1, w], G[w + 2, w + 3], G[w + 3, w + 2] = W, -W, -Omega, Omega
        G[w + 5, w + 4] = 1 if on else 0
        return G

    def at(self, t):
        """(z, ż) at an instant."""
        z = mpmath.matrix([*map(mpmath.mpf, self.start), 0, 1, 1, 0, 1, 0])
        late = mpmath.mpf(self.later.numerator) / self.later.denominator
        if t > late:
            z, t = mpmath.expm(self.generator(False) * late, method="taylor") * z, t - late
        else:
            late = None
        G = self.generator(late is not None)
        z = mpmath.expm(G * t, method="taylor") * z
        return z, G * z


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(6))
def test_values_of_random_chains(seed):
    chain = Chain(seed)
    found, n, last = problem(chain.text), chain.n, chain.n - 1
    with mpmath.workdps(55):
        for t in ("0.4", "1.3", "9.25"):
            z, rates = chain.at(mpmath.mpf(t))
            k, wall = list(map(mpmath.mpf, chain.springs)), mpmath.mpf(chain.wall[0]) * z[2 * n]
            exact = {f"x{last}": z[last], "x0'": z[n], "x0''": rates[n], "s0.force": k[0] * (z[0] - wall),
                     f"s{n}.energy": k[-1] * z[last] ** 2 / 2, f"x0*x{last}'": z[0] * z[n + last],
                     "T": sum(mpmath.mpf(m) * z[n + i] ** 2 for i, m in enumerate(chain.masses)) / 2}
            for text, value in exact.items():
                got = signal_of(found, text).precise(Fraction(t), DIGITS)
                assert abs(got - value) <= abs(value) * mpmath.mpf(10) ** -DIGITS, (text, t)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(20, 25))
def test_bounds_of_random_chains_after_long_times(seed):
    """What is printed after up to ten million seconds is within its bound, whether it was found in floats or anew."""
    chain, dice = Chain(seed), random.Random(seed)
    chain.dampers = ["0"] * chain.n if seed % 2 else chain.dampers
    t = Fraction(round(10 ** dice.uniform(3, 7)))
    found = problem("".join(line for line in chain.text.splitlines(keepends=True) if not line.startswith("  g:")))
    with mpmath.workdps(70):
        x, speed, force = chain.late(mpmath.mpf(t.numerator))
        for text, exact in {"x0": x, "x0'": speed, "s0.force": force, "x0^2": x * x}.items():
            value, bound = value_of_signal(signal_of(found, text), t)
            assert abs(mpmath.mpf(value) - exact) <= bound <= 1e-8 * max(abs(force), abs(exact)), text


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(8, 11))
def test_extremes_of_random_chains(seed):
    """At the largest value the slope vanishes, or it lies at an end; no sample between is above it."""
    chain = Chain(seed)
    signal = signal_of(problem(chain.text), "x0")
    with mpmath.workdps(45):
        t, value = signal.precise_extreme(0.0, 2.0, 1, DIGITS)
        z, _ = chain.at(t)
        assert abs(z[0] - value) <= abs(value) * mpmath.mpf(10) ** -DIGITS
        assert t in (0, 2) or abs(z[chain.n]) <= mpmath.mpf(10) ** (2 - DIGITS)
        assert all(chain.at(mpmath.mpf(i) / 8)[0][0] <= value for i in range(0, 17, 4))
