"""An output of a linear motion to any number of digits, by another way than the floats go.

The state and the waves that drive it form one autonomous system ż = G z, and z at the end of a stretch is e^{Gτ} z at
its start: Taylor's series of e^{Gτ/2ᵐ}, squared m times, in fixed-point numbers. It is computed with ever more bits
until two results agree.
"""

import math

import numpy as np

from vibcli.analyses import fixed as fx

GUARD, MORE, TRIES = 64, 96, 12


def precise_value(M, C, K, forcing, q0, v0, output, time, digits, order=0):
    """The order-th derivative of an output at a time as mpmath.mpf, see precise_values."""
    return precise_values(M, C, K, forcing, q0, v0, [output], time, digits, order)[0]


def precise_values(M, C, K, forcing, q0, v0, outputs, time, digits, order=0):
    """The order-th derivative of each output at a time, just after what jumps there, correct to `digits`.

    M, C, K: nested lists of numbers, as q0, v0 and those of the forcing and the outputs: float, Fraction, mpf or mpc.
    """
    from mpmath import mp

    bits, before = math.ceil(digits * math.log2(10)) + GUARD, None
    for _ in range(TRIES):
        with mp.workprec(bits + GUARD):
            found = _values(M, C, K, forcing, q0, v0, outputs, time, order, bits)
            small = mp.mpf(10) ** (-digits - 1)
            if before is not None and all(abs(x - y) < abs(x) * small for x, y in zip(found, before, strict=True)):
                break
        before, bits = found, bits + max(MORE, bits // 3)
    return found


def _values(M, C, K, forcing, q0, v0, outputs, time, order, bits):
    from mpmath import mp

    n, time = len(M), _real(time)
    inverse = mp.inverse(mp.matrix([[_real(x) for x in row] for row in M]))
    pieces = forcing.segments(math.nextafter(float(time), math.inf))
    state = [_real(x) for x in (*q0, *v0)]
    for piece, after in zip(pieces, [*pieces[1:], None], strict=True):
        start = _real(piece.start)
        for channel, size in piece.impulses:
            for i in range(n if channel < n else 0):
                state[n + i] += inverse[i, channel] * _real(size)
        G, z, forces = _generator(inverse, C, K, piece.waves, state, forcing.channels)
        last = after is None or _real(after.start) > time
        z = _carried(G, (time if last else _real(after.start)) - start, z, bits)
        if last:
            break
        state = [z[i] for i in range(2 * n)]
    return [_read(G, z, forces, output, order, n) for output in outputs]


def _real(x):
    from mpmath import mp, mpf

    return mpf(x.numerator) / x.denominator if hasattr(x, "numerator") and not isinstance(x, float) else mp.mpf(x)


def _generator(inverse, C, K, waves, state, channels):
    """(G, z, rows of the forces): z = (q, q̇, parts of the waves), f = forces z."""
    from mpmath import mp

    n = len(state) // 2
    size = 2 * n + sum(2 * (wave.power + 1) for wave in waves)
    G, forces, z = mp.matrix(size, size), mp.matrix(channels, size), mp.matrix(size, 1)
    for i, x in enumerate(state):
        z[i] = x
    at = 2 * n
    for channel, coefficient, power, exponent in waves:
        s, c = mp.mpc(exponent), mp.mpc(coefficient) * mp.factorial(power)
        z[at] = mp.one
        for k in range(power + 1):
            re, im = at + 2 * k, at + 2 * k + 1
            G[re, re], G[re, im], G[im, re], G[im, im] = s.real, -s.imag, s.imag, s.real
            if k:
                G[re, re - 2] = G[im, im - 2] = mp.one
        forces[channel, re] += c.real
        forces[channel, im] -= c.imag
        at = im + 1
    loads = forces[:n, :].copy() if at > 2 * n else mp.matrix(n, size)
    for i in range(n):
        for j in range(n):
            loads[i, j] -= _real(K[i][j])
            loads[i, n + j] -= _real(C[i][j])
    loads = inverse * loads
    for i in range(n):
        G[i, n + i] = mp.one
        for j in range(size):
            G[n + i, j] = loads[i, j]
    return G, z, forces


def _read(G, z, forces, output, order, n):
    """The output and its derivatives: those of z are G z, G² z …"""
    from mpmath import mp

    row = mp.matrix(1, len(z))
    for channel, x in output.channels.items():
        for j in range(len(z)):
            row[j] += _real(x) * forces[channel, j]
    for i, x in output.q.items():
        row[i] += _real(x)
    for i, x in output.v.items():
        row[n + i] += _real(x)
    for i, x in output.a.items():
        for j in range(len(z)):
            row[j] += _real(x) * G[n + i, j]
    for _ in range(order):
        row = row * G
    return (row * z)[0] + (_real(output.constant) if not order else 0)


def _carried(G, tau, z, bits):
    """e^{Gτ} z."""
    from mpmath import mp

    if not tau:
        return z
    size = G.rows
    norm = max(sum(abs(G[i, j]) for j in range(size)) for i in range(size)) * abs(tau)
    halvings = max(0, int(mp.ceil(mp.log(norm, 2))) + 8) if norm else 0
    wide = bits + 2 * halvings + GUARD
    step = np.empty((size, size), object)
    for at in np.ndindex(size, size):
        m, e = fx.mantissa(G[at] * tau)
        step[at] = fx.shifted(m, e + wide - halvings)
    total = term = fx.identity(size, wide)
    k = 0
    while np.abs(term).max() > 1:               # rounding down leaves −1
        k += 1
        term = fx.product(term, step, wide) // k
        total = total + term
    for _ in range(halvings):
        total = fx.product(total, total, wide)
    out = mp.matrix(size, 1)
    for i in range(size):
        out[i] = mp.fsum(mp.ldexp(mp.mpf(int(total[i, j])), -wide) * z[j] for j in range(size))
    return out
