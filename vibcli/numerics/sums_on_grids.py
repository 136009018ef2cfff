"""Σ cₙ e^{iωₙ t} of very many ω at very many equidistant t: the c are spread on a grid of ω, whose Fourier transform is
the sum but for that of what they are spread by (Dutt & Rokhlin 1993), here Kaiser's and Bessel's function."""

import numpy as np

WIDTH = 16          # cells of the grid that each c is spread over, which leaves 1e-14 of Σ |c|
FINER = 2           # the grid of t that is transformed, in that asked for
SHAPE = np.pi * WIDTH * (1 - 1 / (2 * FINER))


def sum_on_grid(c: np.ndarray, omega: np.ndarray, step: float, count: int) -> np.ndarray:
    """(count,): the sum at 0, step, 2 step …; c (N,) complex."""
    size = FINER << max(count, WIDTH).bit_length()
    middle = size // (2 * FINER)            # t is counted from there, as what is spread is clearest about 0
    place = omega * (step * size / (2 * np.pi)) % size
    at = np.ceil(place - WIDTH / 2)[:, None] + np.arange(WIDTH)
    share = np.i0(SHAPE * np.sqrt(np.maximum(1 - ((place[:, None] - at) * 2 / WIDTH) ** 2, 0.0)))
    grid = np.zeros(size, complex)
    np.add.at(grid, at.astype(int) % size, (c * np.exp(1j * (omega * step * middle)))[:, None] * share)
    found = np.fft.ifft(grid)
    t = np.arange(count) - middle
    return found[t] * size / _transformed(t / size)


def _transformed(turns):
    """Of Kaiser's and Bessel's function, by cells."""
    root = np.sqrt(SHAPE**2 - (np.pi * WIDTH * turns) ** 2)
    return WIDTH * np.sinh(root) / root
