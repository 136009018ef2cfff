"""Signals in time: values at any instant, extremes, passages through zero; the exact ones of linear motions, and those
that are composed of them."""

from functools import cached_property

from vibcli.algebra.evaluate import evaluate
from vibcli.errors import PhysicsError

SAMPLES, ROUNDS = 4001, 60


class LinearSignal:
    """A linear output of a linear motion."""

    def __init__(self, motion, output):
        self.motion, self.output = motion, output

    def values(self, times, order=0):
        return self.motion.values(self.output, times, order)

    def extreme(self, start, end, sense):
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        return self.motion.extreme(self.output, start, end, "max" if sense > 0 else "min")

    def zeros(self, start, end):
        return self.motion.zeros(self.output, start, end)

    def final(self):
        return self.motion.final(self.output)

    @cached_property
    def steady(self):
        return LinearSignal(self.motion.steady, self.output)

    @cached_property
    def transient(self):
        return LinearSignal(self.motion.transient, self.output)

    @cached_property
    def envelope(self):
        return Envelope(self)

    @property
    def phasors(self):
        """[(Ω, complex X)] of the steady state Re Σ X e^{iΩt}, by ascending Ω."""
        from vibcli.read_off import harmonics

        return harmonics(self)


class Envelope:
    """A e^{−δt} of a free vibration."""

    def __init__(self, signal):
        self.signal = signal

    def values(self, times, order=0):
        from vibcli.read_off import envelope

        return envelope(self.signal, times)


class ComposedSignal:
    """A function of signals, instant by instant; `node` in symbols that `signals` names."""

    def __init__(self, node, signals, floats):
        self.node, self.signals, self.floats = node, signals, floats

    def values(self, times, order=0):
        from vibcli.algebra.arrays import Arrays

        if order:
            raise PhysicsError("rates of products of signals are not found", "ask for the signal itself")
        values = {name: signal.values(times) for name, signal in self.signals.items()}
        return evaluate([self.node], Arrays, {**self.floats, **values})[0]

    def extreme(self, start, end, sense):
        """(instant, value), refined from the best of many samples by golden section."""
        import numpy as np

        times = np.linspace(start, end, SAMPLES)
        best = int(np.argmax(sense * self.values(times)))
        low, high = times[max(best - 1, 0)], times[min(best + 1, SAMPLES - 1)]
        for _ in range(ROUNDS):
            inner = np.array([low + 0.3819660112501051 * (high - low), high - 0.3819660112501051 * (high - low)])
            left, right = sense * self.values(inner)
            low, high = (low, inner[1]) if left >= right else (inner[0], high)
        candidates = np.array([times[best], 0.5 * (low + high)])
        found = self.values(candidates)
        pick = int(np.argmax(sense * found))
        return float(candidates[pick]), float(found[pick])

    def zeros(self, start, end, level=0.0):
        """Instants at which the signal passes a level, each bisected."""
        import numpy as np

        times = np.linspace(start, end, SAMPLES)
        values = self.values(times) - level
        found = []
        for i in np.flatnonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0):
            low, high, sign = times[i], times[i + 1], values[i] > 0
            for _ in range(ROUNDS):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if (self.values(np.array([middle]))[0] > level) == sign else (low, middle)
            found.append(float(0.5 * (low + high)))
        return found

    def final(self):
        values = {name: signal.final() for name, signal in self.signals.items()}
        from vibcli.algebra.evaluate import Floats

        return evaluate([self.node], Floats, {**self.floats, **values})[0]

    @cached_property
    def steady(self):
        return ComposedSignal(self.node, {name: signal.steady for name, signal in self.signals.items()}, self.floats)

    @cached_property
    def transient(self):
        return Difference(self, self.steady)


class Difference:
    """One signal less another."""

    def __init__(self, one, other):
        self.one, self.other = one, other

    def values(self, times, order=0):
        return self.one.values(times, order) - self.other.values(times, order)

    extreme, zeros = ComposedSignal.extreme, ComposedSignal.zeros

    def final(self):
        return self.one.final() - self.other.final()


class FullSignal:
    """A function of the coordinates, velocities and accelerations of a motion that was integrated."""

    def __init__(self, motion, node):
        self.motion, self.node = motion, node

    def values(self, times, order=0):
        from vibcli.algebra.arrays import Arrays

        if order:
            raise PhysicsError("rates of composed signals are not found", "ask for x' or x''")
        import numpy as np

        times = np.asarray(times, dtype=float)
        scene = self.motion.problem.scene
        trajectory = self.motion.trajectory(max(times.max(initial=0.0), self.motion.until))
        values = {**self.motion.problem.floats, scene.time.name: times}
        for primes, rows in zip(("", "'", "''"), trajectory.at(times), strict=True):
            values |= {name + primes: row for name, row in zip(trajectory.names, rows, strict=True)}
        return np.broadcast_to(evaluate([self.node], Arrays, values)[0], times.shape)

    def zeros(self, start, end, level=0.0):
        """Instants at which the signal passes a level."""
        from vibcli.analyses.trajectory.passages import passages

        return passages(self.motion.trajectory(max(end, self.motion.until)), self.values, start, end, level)

    def extreme(self, start, end, sense):
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        from vibcli.analyses.trajectory.passages import extreme

        return extreme(self.motion.trajectory(max(end, self.motion.until)), self.values, start, end, sense)

    def final(self):
        raise PhysicsError("a motion that is integrated has no known limit", "ask for its value at a late instant")
