"""Bounds of motions of beams by few modes against sums of very many, each solved by hand:

    PYTHONPATH=$PWD:tests python -m fuzz.modal_bounds 300

prints how often a bound was missed, and how many times larger than the error bounds are.
"""

import random
import sys

import numpy as np
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse

MODES = 100_000
ROOTS = [1.8751040687119612, 4.694091132974175, 7.854757438237613, 10.995540734875467, 14.13716839104647,
         17.278759532088238, 20.42035225104125, 23.561944901806445, 26.703537555518299, 29.845130209102816]
SIGNALS = "u", "slope", "moment", "shear"


class Beam:
    """A beam with L = EI = μ = 1: βL of its modes, ∫ φ² dx = 1."""

    def __init__(self, clamped: bool, count: int = MODES):
        n = np.arange(1, count + 1)
        self.clamped, self.b = clamped, np.pi * (n - 0.5) if clamped else np.pi * n
        if clamped:
            self.b[:10] = ROOTS
        self.omega = self.b**2

    def shape(self, x: float, k: int = 0) -> np.ndarray:
        """The k-th derivative."""
        b, turned = self.b, x * self.b + k * np.pi / 2
        if not self.clamped:
            return np.sqrt(2) * b**k * np.sin(turned)
        e = np.exp(-b)
        whole = 1 - e * e + 2 * np.sin(b) * e
        ratio = (1 + 2 * np.cos(b) * e + e * e) / whole
        growing = (np.sin(b) - np.cos(b) - e) / whole * np.exp(b * x - b)
        return b**k * (growing + (-1)**k * (1 + ratio) / 2 * np.exp(-b * x) - np.cos(turned) + ratio * np.sin(turned))

    def overlap(self, powers: list) -> np.ndarray:
        """∫ φ u dx of a cubic, by parts."""
        u, found = np.polynomial.Polynomial(powers), 0.0
        for x, sign in ((1.0, 1), (0.0, -1)):
            found += sign * sum((-1)**k * self.shape(x, 3 - k) * u.deriv(k)(x) for k in range(4))
        return found / self.b**4


def drawn(chance: random.Random) -> tuple:
    """(beam, scene, place of the load, η(t) by hand)."""
    clamped, a = chance.random() < 0.5, round(chance.uniform(0.1, 1.0), 2)
    turn, begun, beam = chance.choice([0, 0, 1]), 0.01, Beam(clamped)
    a = a if clamped else min(a, 0.9)
    b, w = beam.shape(a, turn), beam.omega
    kind = chance.choice(["released", "step", "ramp", "pulse", "velocity", "field", "harmonic"])
    push = f"points: {{at: {{body: arm, at: {a} m}}}}\nforces: {{push: {{at: at, {'moment' if turn else 'force'}: "
    size = "1 N*m" if turn else "1 N"
    rate = chance.choice([7.0, 31.0])

    def sine(t):
        late = np.maximum(t, 0.0)
        return b * (np.sin(rate * late) - rate / w * np.sin(w * late)) / (w**2 - rate**2)

    if kind == "released":
        return beam, push + f"{size}}}}}\ninitial: {{released: push}}\n", lambda t: b / w**2 * np.cos(w * t)
    if kind == "step":
        text = push + f"{size}*step(t - {begun} s)}}}}\n"
        return beam, text, lambda t: b / w**2 * (1 - np.cos(w * max(t - begun, 0.0)))
    if kind == "ramp":
        return beam, push + f"{size}*t/(1 s)}}}}\n", lambda t: b / w**2 * (t - np.sin(w * t) / w)
    if kind == "harmonic":
        return beam, push + f"{size}*sin({rate} rad/s*t)}}}}\n", sine
    if kind == "pulse":
        text = push + f"{size}*sin({rate} rad/s*t)*(1 - step(t - pi/({rate} rad/s)))}}}}\n"
        return beam, text, lambda t: sine(t) + sine(t - np.pi / rate)
    powers = chance.choice([[0, 0, 1], [0, 0, 1, -0.5]] if clamped else [[0, 1, -1], [0, 1, 0, -1]])
    if kind == "velocity":
        powers = chance.choice([powers, [1], [0, 1]])
    field = "+".join(f"({c})*(x/(1 m))^{k}" for k, c in enumerate(powers) if c)
    eta = beam.overlap(powers)
    if kind == "velocity":
        return beam, f"initial: {{arm.u': 1 m/s*({field})}}\n", lambda t: eta / w * np.sin(w * t)
    return beam, f"initial: {{arm.u: 1 m*({field})}}\n", lambda t: eta * np.cos(w * t)


def case(seed: int) -> tuple[str, float, float, float]:
    """(what it was, error, bound, size) of a random signal at a random instant, by few modes."""
    chance = random.Random(seed)
    beam, text, eta = drawn(chance)
    k, x, t = chance.randrange(4), round(chance.uniform(0.0, 1.0), 2), chance.uniform(0.0, 0.6)
    ends = "left: clamped, right: free" if beam.clamped else "left: pinned, right: pinned"
    scene = problem("parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}\nbeams:\n  arm: {length: L, EI: EI, "
                    f"mass_per_length: mu, {ends}}}\n" + text)
    signal = scene.response.signal(with_places(parse(f"arm.{SIGNALS[k]}({x} m)"), scene.spec.members))
    motion = scene.response.motion(chance.choice([32, 128])).under(signal.modal.reads)
    terms = beam.shape(x, k) * eta(t)
    found, bound = float(motion.values(signal.reads, t)), float(motion.errors(signal.reads, np.array([t]))[0])
    doubt = 2 * float(np.abs(terms[-MODES // 10:]).sum())
    kind = f"{text.split('initial')[-1][:70]} {SIGNALS[k]}({x}) at {t:.3f}, {motion.count} modes".replace("\n", " ")
    return kind, max(abs(found - float(terms.sum())) - doubt, 0.0), bound, float(np.abs(terms).max())


def main(count: int) -> None:
    """Prints the survey."""
    ratios, open_ones = [], 0
    for seed in range(count):
        kind, error, bound, size = case(seed)
        if not np.isfinite(bound):
            open_ones += 1
            continue
        if error > bound + 1e-12 * size:
            print("missed:", seed, kind, error, bound)
        if error > 1e-13 * size:
            ratios.append(bound / error)
    print(f"{count} cases, {open_ones} without a bound; bound over error: least {min(ratios):.3g}, "
          f"median {np.median(ratios):.3g}, 90 % below {np.quantile(ratios, 0.9):.3g}")


if __name__ == "__main__":
    main(int(sys.argv[1]))
