"""What modes left out can add to a motion: their amplitudes fall with a power of the number of the mode."""

import numpy as np

SAFE = 2.0
NOISE = 1e-15       # of the largest amplitude: what is only rounding
FEW = 32            # modes that tell how amplitudes fall
OCTAVES = 4         # over which they fall surely where single octaves, by where nodes lie, tell no fall
EVEN, SURE = 0.02, 1.25     # how alike octaves fall from which on their sums tell more, and times what these tell


def remainder(sizes: np.ndarray, rounded: float = 0.0) -> float:
    """A bound of Σ a_j over j > N, given the amplitudes a_1 … a_N in order of frequency and what rounding leaves of one
    of the last; infinite where they do not fall faster than 1/j.

    Between N/2 and N no a_j is above C j⁻ᵖ with p from the largest in the octaves before (to halves: the order of the
    powers of ω that a jump, a field or a moment brings), and so are those beyond; where nodes next to a place make one
    octave as large as the one before, p is what they fall by over several, whole halves of it. Where the sums of the
    last octaves fall alike, so do those beyond.
    """
    count = len(sizes)
    top, middle, low = (sizes[count // 2**(k + 1):count // 2**k].max(initial=0.0) for k in range(3))
    if count < FEW:
        return np.inf if top else 0.0
    if top <= max(NOISE * sizes.max(initial=0.0), rounded):
        return SAFE * count * float(top)
    fall = min(middle / top, 2 * low / middle if middle else np.inf)
    power = np.floor(2 * (np.log2(fall) + 0.3)) / 2 if fall else 0.0
    size = float(top) / 2**power
    if power <= 1:
        power = _over_octaves(sizes)
        if power <= 1:
            return np.inf
        tail = np.arange(count // 8, count)
        size = float((sizes[tail] * ((tail + 1) / count) ** power).max())
    most = SAFE * size * count / (power - 1)
    last, before, first = (float(sizes[count // 2**(k + 1):count // 2**k].sum()) for k in range(3))
    shares = (last / before, before / first) if before and first else (1.0,)
    if max(shares) < 1 and max(shares) <= (1 + EVEN) * min(shares):
        return min(most, SURE * last * max(shares) / (1 - max(shares)))
    return most


def _over_octaves(sizes: np.ndarray) -> float:
    """The power, in halves, of which amplitudes fall by no less over the last two octaves, three, …"""
    count = len(sizes)
    tops = [sizes[count // 2**(k + 1):count // 2**k].max() for k in range(OCTAVES + 1)]
    fall = min((tops[k] / tops[0]) ** (1 / k) for k in range(2, OCTAVES + 1))
    return np.floor(2 * np.log2(fall)) / 2 if fall else 0.0
