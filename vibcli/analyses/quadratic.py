"""Damping in the modes without damping: λ² + λ Ĉ_m + diag(ω̂²) in fixed point, and its eigenvalues.

Modes that no damping couples are quadratic equations of their own; the others are solved together from the
first-order form v' = −C v − Ω u, u' = Ω v (u = Ω q, rigid modes have no u: so one zero for each leaves exactly).
"""

import math

import numpy as np

from vibcli.analyses import fixed as fx
from vibcli.analyses.blocks import roots
from vibcli.analyses.symmetric import components, spectrum

SAME = 100
COUPLED = 130


class ModalDamping:
    """Modes (columns phi), values ω̂² and damping c in their coordinates, all in fixed point; free: flags of ω = 0."""

    __slots__ = ("bits", "c", "free", "phi", "values")

    def __init__(self, answer, elements, scale, untouched):
        self.bits, self.values = answer.bits, answer.values.copy()
        self.free = answer.zero
        self.values[self.free] = 0
        p = scale.coordinates
        turning = dict(elements.C)
        for at, x in elements.G.items():
            turning[at] = turning.get(at, 0) + x
        c = fx.assembled(elements.n, elements.dampers, turning, p, scale.damping, self.bits)
        self.phi = answer.shapes
        self.c = fx.product(self.phi.T, fx.product(c, self.phi, self.bits), self.bits)
        self._align()
        self._clear(untouched)

    def _align(self):
        """Turns the basis of each repeated frequency to the axes of the damping in it."""
        size = np.abs(fx.floats(self.values, self.bits))
        gap = np.abs(fx.floats(np.subtract.outer(self.values, self.values), self.bits))
        same = gap <= 2.0 ** -SAME * np.maximum.outer(size, size)
        np.fill_diagonal(same, False)
        for part in components(same):
            block = self.c[np.ix_(part, part)]
            block = (block + block.T) >> 1
            if fx.is_diagonal(block):
                continue
            turn = spectrum(block, self.bits, SAME).vectors
            self.phi[:, part] = fx.product(self.phi[:, part], turn, self.bits)
            self.c[:, part] = fx.product(self.c[:, part], turn, self.bits)
            self.c[part, :] = fx.product(turn.T, self.c[part, :], self.bits)

    def _clear(self, untouched):
        """Sets couplings that are zero but for the working precision to zero, and rigid motions without damping."""
        largest = max(abs(x) for x in self.c.ravel().tolist())
        small = np.abs(self.c) <= (largest >> COUPLED)
        self.c[small] = 0
        if untouched:
            rigid = [i for i in range(len(self.free)) if self.free[i]]
            rigid.sort(key=lambda i: abs(self.c[i, i]))
            self.c[rigid[:untouched], :] = 0
            self.c[:, rigid[:untouched]] = 0

    def groups(self):
        """The modes coupled by damping, as lists of indices; a mode on its own is a list of one."""
        linked = (self.c != 0) | (self.c.T != 0)
        np.fill_diagonal(linked, False)
        parts = components(linked.astype(bool))
        coupled = {i for part in parts for i in part}
        return parts + [[i] for i in range(len(self.values)) if i not in coupled]


class Damped:
    """One eigenvalue of the pencil in fixed point: re + i im, radius, modal vector x, left row of the v equations.

    mode: the undamped mode it belongs to, or None; excess: c² − 4 ω̂² of that mode.
    """

    __slots__ = ("excess", "im", "left", "mode", "radius", "re", "x")

    def __init__(self, re, im, radius, x, left, mode=None, excess=None):
        self.re, self.im, self.radius, self.x, self.left = re, im, radius, x, left
        self.mode, self.excess = mode, excess


def eigenvalues(modal):
    """Every eigenvalue as Damped; of a conjugate pair the upper one."""
    out = []
    for part in modal.groups():
        out += _alone(modal, part[0]) if len(part) == 1 else _coupled(modal, part)
    return out


def _unit(modal, i, value=1.0):
    x = np.zeros(len(modal.values), complex)
    x[i] = value
    return x


def _alone(modal, i):
    """λ² + c λ + ω̂² = 0."""
    bits, c, k = modal.bits, int(modal.c[i, i]), int(modal.values[i])
    excess = c * c - (k << (bits + 2))
    if abs(excess) <= (abs(k) << bits) >> (COUPLED - 10):
        excess = 0
    root = math.isqrt(abs(excess))
    size = math.ldexp(1.0, -bits + 4) * (1.0 + abs(fx.to_float(c, bits)))
    if excess < 0:
        pairs = [(-c >> 1, root >> 1)]
    elif not k:
        pairs = [(0, 0), (-c, 0)]
    else:
        far = (-c - root if c >= 0 else -c + root) >> 1
        pairs = [((k << bits) // far, 0), (far, 0)]
    out = []
    for re, im in pairs:
        slope = complex(fx.to_float(2 * re + c, bits), fx.to_float(2 * im, bits))
        value = abs(complex(fx.to_float(re, bits), fx.to_float(im, bits)))
        radius = size * (1 + value) + abs(value) * 2.0 ** (-COUPLED + 20)
        out.append(Damped(re, im, radius, _unit(modal, i), _unit(modal, i, 1 / slope if slope else np.inf), i, excess))
    return out


def _coupled(modal, part):
    """The eigenvalues of modes that damping couples."""
    bits, c = modal.bits, modal.c[np.ix_(part, part)]
    values = modal.values[part]
    spring = [i for i in range(len(part)) if values[i]]
    k = len(part)
    omega = np.array([math.isqrt(abs(int(values[i])) << bits) for i in spring], object)
    pull = np.array([w if values[i] > 0 else -w for w, i in zip(omega, spring, strict=True)], object)

    def apply(y):
        v, u = y[:k], y[k:]
        out = np.concatenate([-(c.dot(v) >> bits), omega[:, None] * v[spring] >> bits])
        out[spring] -= pull[:, None] * u >> bits
        return out

    matrix = np.zeros((k + len(spring), k + len(spring)))
    matrix[:k, :k] = -fx.floats(c, bits)
    at = k + np.arange(len(spring))
    matrix[at, spring], matrix[spring, at] = fx.floats(omega, bits), -fx.floats(pull, bits)
    still = _still(matrix, part, modal)
    noise = 2.0 ** -COUPLED * np.abs(matrix[:k, :k]).max() * k + 2.0 ** -(SAME + 40) * np.abs(matrix).max()

    def enough(re, im, radius):
        size, decay = math.hypot(fx.to_float(re, bits), fx.to_float(im, bits)), abs(fx.to_float(re, bits))
        return radius <= max(2.0 ** -60 * decay, 2.0 ** -90 * size) or size + radius <= 2.0 ** -80 * top

    top = np.abs(matrix).max()
    found = roots(apply, matrix, bits, enough, noise)
    found.sort(key=lambda root: root.re * root.re + root.im * root.im)
    out = [Damped(0, 0, 0.0, _unit(modal, i), _unit(modal, i)) for i in part if not modal.values[i]]
    for place, root in enumerate(found):
        x, left = np.zeros(len(modal.values), complex), np.zeros(len(modal.values), complex)
        value = complex(fx.to_float(root.re, bits), fx.to_float(root.im, bits))
        zero = place < still
        x[part] = root.vector[:k] if zero or not value else root.vector[:k] / value
        left[part] = root.left[:k] * (1 if zero or not value else value)
        out.append(Damped(0, 0, 0.0, x, left) if zero else Damped(root.re, root.im, root.radius, x, left))
    return out


def _still(matrix, part, modal):
    """How many eigenvalues vanish besides one for each rigid mode: the rank that the damping of those lacks."""
    rigid = [i for i in range(len(part)) if not modal.values[part[i]]]
    if not rigid:
        return 0
    sigma = np.linalg.svd(matrix[np.ix_(rigid, rigid)], compute_uv=False)
    return int((sigma <= 1e-13 * np.abs(matrix[:len(part), :len(part)]).max()).sum())
