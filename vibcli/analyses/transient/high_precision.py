"""An output of a linear motion to any number of digits, by another way than the floats go.

The state and the waves that drive it form one autonomous system ż = G z, and z at the end of a stretch is e^{Gτ} z at
its start: Taylor's series of e^{Gτ/2ᵐ}, squared m times, in fixed-point numbers. It is computed with ever more bits
until two results agree.
"""

import math

import numpy as np

from vibcli.analyses.transient.descriptor_system import Descriptor, real
from vibcli.numerics import fixed_point as fx

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
    n, time, system = len(M), real(time), Descriptor(M, C, K)
    pieces = forcing.segments(math.nextafter(float(time), math.inf))
    state = [real(q0[i]) for i in system.places] + [real(v0[i]) for i in system.heavy]
    for piece, after in zip(pieces, [*pieces[1:], None], strict=True):
        start = real(piece.start)
        for channel, size in piece.impulses:
            for i in range(len(state) if channel < n else 0):
                state[i] += system.B[i, channel] * real(size)
        G, z, forces, Q = _generator(system, piece.waves, state, forcing.channels, n)
        last = after is None or real(after.start) > time
        z = _carried(G, (time if last else real(after.start)) - start, z, bits)
        if last:
            break
        state = [z[i] for i in range(len(state))]
    return [_read(G, z, forces, Q, output, order) for output in outputs]


def _generator(system, waves, state, channels, n):
    """(G, z, rows of the forces, rows of q): z = (y, parts of the waves), f = forces z, q = Q z."""
    from mpmath import mp

    first = len(state)
    size = first + sum(2 * (wave.power + 1) for wave in waves)
    G, forces, z, Q = mp.matrix(size, size), mp.matrix(channels, size), mp.matrix(size, 1), mp.matrix(n, size)
    for i, x in enumerate(state):
        z[i] = x
    at = first
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
    for whole, own, driven in ((G, system.A, system.B), (Q, system.Q, system.F)):
        loads = driven * forces[:n, :] if waves else None
        for i in range(own.rows):
            for j in range(size):
                if j < first:
                    whole[i, j] = own[i, j]
                elif waves:
                    whole[i, j] = loads[i, j]
    return G, z, forces, Q


def _read(G, z, forces, Q, output, order):
    """The output and its derivatives: those of z are G z, G² z …"""
    from mpmath import mp

    row = mp.matrix(1, len(z))
    for channel, x in output.channels.items():
        for j in range(len(z)):
            row[j] += real(x) * forces[channel, j]
    places = mp.matrix(1, len(z))
    for parts in (output.a, output.v, output.q):        # (a G + v) G + q
        places = places * G
        for i, x in parts.items():
            places += real(x) * Q[i, :]
    row += places
    for _ in range(order):
        row = row * G
    return (row * z)[0] + (real(output.constant) if not order else 0)


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
