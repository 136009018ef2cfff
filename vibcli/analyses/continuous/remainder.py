"""What modes left out can add to a motion: their amplitudes fall with a power of the number of the mode."""

import numpy as np

SAFE = 2.0
NOISE = 1e-15       # of the largest amplitude: what is only rounding
FEW = 32            # modes that tell how amplitudes fall
EVEN, SURE = 0.02, 1.25     # how alike octaves fall from which on their sums tell more, and times what these tell


def remainder(sizes: np.ndarray) -> float:
    """A bound of Σ a_j over j > N, given the amplitudes a_1 … a_N in order of frequency; infinite where they do not
    fall faster than 1/j.

    Between N/2 and N no a_j is above C j⁻ᵖ with p from the largest in the octaves before (to halves: the order of the
    powers of ω that a jump, a field or a moment brings), and so are those beyond. Where the sums of the last octaves
    fall alike, so do those beyond.
    """
    count = len(sizes)
    top, middle, low = (sizes[count // 2**(k + 1):count // 2**k].max(initial=0.0) for k in range(3))
    if count < FEW:
        return np.inf if top else 0.0
    if top <= NOISE * sizes.max(initial=0.0):
        return SAFE * count * float(top)
    power = np.floor(2 * (np.log2(min(middle / top, 2 * low / middle if middle else np.inf)) + 0.3)) / 2
    if power <= 1:
        return np.inf
    most = SAFE * float(top) * count / (2**power * (power - 1))
    last, before, first = (float(sizes[count // 2**(k + 1):count // 2**k].sum()) for k in range(3))
    shares = last / before, before / first
    if max(shares) < 1 and max(shares) <= (1 + EVEN) * min(shares):
        return min(most, SURE * last * max(shares) / (1 - max(shares)))
    return most
