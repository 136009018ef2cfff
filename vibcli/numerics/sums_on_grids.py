"""Re Σ cₙ e^{iωₙ t} of very many ω at very many equidistant t: the c are spread on a grid of ω, whose Fourier transform
is the sum but for that of what they are spread by (Dutt & Rokhlin 1993), here Kaiser's and Bessel's function."""

import numpy as np

WIDTH = 16          # cells of the grid that each c is spread over, which leaves 1e-14 of Σ |c|
FINER = 2           # the grid of t that is transformed, in that asked for
SHAPE = np.pi * WIDTH * (1 - 1 / (2 * FINER))


class SumsOnGrid:
    """Sums at 0, step, 2 step …, `count` of them, with the same (N,) omega, one c after another."""

    def __init__(self, omega: np.ndarray, step: float, count: int):
        self._size = size = FINER << max(count, WIDTH).bit_length()
        middle = size // (2 * FINER)            # t is counted from there, as what is spread is clearest about 0
        place = omega * (step * size / (2 * np.pi)) % size
        at = np.ceil(place - WIDTH / 2)[:, None] + np.arange(WIDTH)
        self._share = np.i0(SHAPE * np.sqrt(np.maximum(1 - ((place[:, None] - at) * 2 / WIDTH) ** 2, 0.0)))
        self._cells, self._begun = at.astype(int).ravel() % size, np.exp(1j * (omega * step * middle))
        t = np.arange(count) - middle
        self._places, self._scale = t % size, size / _transformed(t / size)

    def of(self, c: np.ndarray) -> np.ndarray:
        """(count,): the real part of the sum of c (N,), complex."""
        spread = (c * self._begun)[:, None] * self._share
        real, imag = (np.bincount(self._cells, part.ravel(), self._size) for part in (spread.real, spread.imag))
        half = self._size // 2 + 1          # a sum is real where that of −ω is its conjugate
        grid = (_even(real, half, 1) + 1j * _even(imag, half, -1)) / 2
        return np.fft.irfft(grid, self._size)[self._places] * self._scale


def _even(x, half, sense):
    """x[k] ± x[−k] of the first half."""
    return x[:half] + sense * np.append(x[:1], x[:half - 2:-1])


def _transformed(turns):
    """Of Kaiser's and Bessel's function, by cells."""
    root = np.sqrt(SHAPE**2 - (np.pi * WIDTH * turns) ** 2)
    return WIDTH * np.sinh(root) / root
