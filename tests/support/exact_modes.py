"""Modes of beams and bodies in mpmath from their element data, by formulas of their own: D(ω²) of u = Σ cⱼ fⱼ, fⱼ of
cos βx, sin βx, cosh βx, sinh βx, and inverse iteration from frequencies that are known in floats."""

from functools import lru_cache

import mpmath
import numpy as np
from mpmath import mp, mpf

DIGITS, GUESS, SHARP = 60, mpf(10) ** -17, mpf(10) ** -45


def along(piece, z, x):
    """The derivatives of the four functions, row by row."""
    beta = mp.root((piece.inertia * z - piece.foundation) / piece.bending, 4)
    c, s, C, S = mp.cos(beta * x), mp.sin(beta * x), mp.cosh(beta * x), mp.sinh(beta * x)
    rows = [[c, s, C, S], [-s, c, S, C], [-c, -s, C, S], [s, -c, S, C]]
    return mp.matrix([[beta**k * value for value in row] for k, row in enumerate(rows)])


@lru_cache(maxsize=64)          # of a few pieces and modes, at which many places are read
def stiffness(piece, z):
    """d, and the coefficients of unit end values."""
    left, right, B = along(piece, z, 0), along(piece, z, piece.length), piece.bending
    ends = mp.matrix([list(left[0, :]), list(left[1, :]), list(right[0, :]), list(right[1, :])])
    forces = mp.matrix([list(B * left[3, :]), list(-B * left[2, :]), list(-B * right[3, :]), list(B * right[2, :])])
    inverse = ends**-1
    return forces * inverse, inverse


class ExactModes:
    """Those of a problem next to its modes in floats; z = ω², shapes with ∫ μ φ² + xᵀ M x = 1."""

    def __init__(self, problem, count):
        with mpmath.workdps(DIGITS):
            self.elements = problem.configuration.sources[0](DIGITS)
            n = self.elements.n
            self.K, self.M = mp.matrix(n, n), mp.matrix(n, n)
            for terms, extra, found in ((self.elements.springs, self.elements.K, self.K),
                                        (self.elements.inertias, self.elements.M, self.M)):
                for weight, row in terms:
                    for i, x in row.items():
                        for j, y in row.items():
                            found[i, j] += weight * x * y
                for (i, j), x in extra.items():
                    found[i, j] += x
            known = [mpf(mode.motion.z) for mode in problem.modal.modes.first(count)]
            self.z, self.shapes = zip(*(self._mode(z) for z in known), strict=True)

    def D(self, z):
        found = self.K - z * self.M
        for placed in self.elements.pieces:
            d, _ = stiffness(placed.piece, z)
            for a, row in enumerate(placed.rows):
                for b, other in enumerate(placed.rows):
                    for i, x in row.items():
                        for j, y in other.items():
                            found[i, j] += d[a, b] * x * y
        return found

    def _mode(self, z):
        x, slope = mp.matrix([mp.sin(7 * i + 1) + mpf(1) / 3 for i in range(self.elements.n)]), self._slope(z)
        for near in (GUESS, GUESS, SHARP, SHARP, SHARP):        # the slope is off by as little as z is at first
            x = mp.lu_solve(self.D(z * (1 + near)), x)
            z = z + (x.T * self.D(z) * x)[0] / (x.T * slope * x)[0]
        return z, x / mp.sqrt((x.T * self._slope(z) * x)[0])

    def _slope(self, z):
        """−∂D/∂z."""
        step = z * mpf(10) ** -20
        return (self.D(z - step) - self.D(z + step)) / (2 * step)

    @lru_cache(maxsize=1)       # noqa: B019 - one place after the other is read of it
    def _steady(self, coordinate, z):
        """The coordinates under a unit load that swings."""
        load = mp.matrix(self.elements.n, 1)
        load[coordinate] = 1
        return mp.lu_solve(self.D(z), load)

    def _at(self, place, z, q):
        """What is read at a FieldPoint of coordinates q."""
        placed = self.elements.pieces[place.piece]
        ends = mp.matrix([sum((x * q[i] for i, x in row.items()), mpf(0)) for row in placed.rows])
        return (along(placed.piece, z, mpf(place.x))[place.along, :] * (stiffness(placed.piece, z)[1] * ends))[0]

    def under_a_sine(self, place, coordinate, Omega, times):
        """What sin Ωt on a coordinate brings from rest at a FieldPoint, with these modes beside the steady motion."""
        with mpmath.workdps(DIGITS):
            steady = self._at(place, mpf(Omega) ** 2, self._steady(coordinate, mpf(Omega) ** 2))
            rates = [mp.sqrt(z) for z in self.z]
            sizes = [self._at(place, z, x) * x[coordinate] * Omega / rate / (z - Omega**2)
                     for z, x, rate in zip(self.z, self.shapes, rates, strict=True)]
            return np.array([float(steady * mp.sin(Omega * t) - sum(
                size * mp.sin(rate * t) for size, rate in zip(sizes, rates, strict=True)))
                for t in map(mpf, times.tolist())])
