"""Re Σ cₙ e^{iωₙ t} of very many ω at very many equidistant t: the c are spread on a grid of ω, whose Fourier transform
is the sum but for that of what they are spread by (Dutt & Rokhlin 1993), here Kaiser's and Bessel's function."""

from functools import cache

import numpy as np

WIDTH = 16          # cells of the grid that each c is spread over, which leaves 1e-14 of Σ |c|
FINER = 2           # the grid of t that is transformed, in that asked for
SHAPE = np.pi * WIDTH * (1 - 1 / (2 * FINER))
DEGREE = 14         # of the polynomials that are that function on each cell, to rounding
ROUND = 8, 9, 10, 12, 15        # times powers of two: sizes of grids that are transformed fast


class SumsOnGrid:
    """Sums at 0, step, 2 step …, `count` of them, with the same (N,) omega, one c after another."""

    def __init__(self, omega: np.ndarray, step: float, count: int) -> None:
        self._size = size = _round(FINER * max(count, WIDTH))
        middle = size // (2 * FINER)            # t is counted from there, as what is spread is clearest about 0
        place = omega * (step * size / (2 * np.pi)) % size
        first = np.ceil(place - WIDTH / 2)
        self._share = _spread() @ np.polynomial.chebyshev.chebvander(2 * (first - place) + WIDTH - 1, DEGREE).T
        cells = first.astype(int) % size + np.arange(WIDTH)[:, None]
        self._cells = np.where(cells < size, cells, cells - size).ravel()
        self._begun = np.exp(1j * (omega * step * middle))
        t = np.arange(count) - middle
        self._places, self._scale = t % size, size / _transformed(t / size)

    def of(self, c: np.ndarray) -> np.ndarray:
        """(count,): the real part of the sum of c (N,), complex."""
        spread = c * self._begun * self._share
        real, imag = (np.bincount(self._cells, part.ravel(), self._size) for part in (spread.real, spread.imag))
        half = self._size // 2 + 1          # a sum is real where that of −ω is its conjugate
        grid = (_even(real, half, 1) + 1j * _even(imag, half, -1)) / 2
        return np.fft.irfft(grid, self._size)[self._places] * self._scale


def _round(least: int) -> int:
    """The next even size that is transformed fast."""
    return min(factor << max(1, (-(-least // factor) - 1).bit_length()) for factor in ROUND)


@cache
def _spread() -> np.ndarray:
    """Kaiser's and Bessel's function on each cell that a c is spread over, as sums of Chebyshev polynomials of how far
    the first of them is off, (cells, DEGREE + 1)."""
    chebyshev = np.polynomial.chebyshev
    u = chebyshev.chebpts1(DEGREE + 1)
    off = (u[:, None] + 1 - WIDTH) / 2 + np.arange(WIDTH)
    values = np.i0(SHAPE * np.sqrt(np.maximum(1 - (off * 2 / WIDTH) ** 2, 0.0)))
    return np.linalg.solve(chebyshev.chebvander(u, DEGREE), values).T


def _even(x: np.ndarray, half: int, sense: int) -> np.ndarray:
    """x[k] ± x[−k] of the first half."""
    found: np.ndarray = x[:half] + sense * np.append(x[:1], x[:half - 2:-1])
    return found


def _transformed(turns: np.ndarray) -> np.ndarray:
    """Of Kaiser's and Bessel's function, by cells."""
    root = np.sqrt(SHAPE**2 - (np.pi * WIDTH * turns) ** 2)
    return WIDTH * np.sinh(root) / root
