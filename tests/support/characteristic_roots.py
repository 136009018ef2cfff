"""Eigenvalues in many digits as roots of det(λ²M + λC + K), which is formed exactly: LAPACK tells them apart, Newton's
method finds their digits, and the polynomial of what was found proves that they are all (Vieta)."""

import mpmath
import numpy as np

GUARD, LOST, STEPS, MOST = 20, 10, 12, 7        # digits beyond those of now, and of them lost; of Newton; rows


def roots(matrices):
    """The roots of det Σ λᵏ Aₖ of matrices (A₀, A₁ …) of mpmath's numbers, at its precision of now, 0 as often as it is
    one; None where they are not told apart in floats."""
    n = matrices[0].rows
    if n > MOST:
        return None
    exact = determinant(whole(matrices), n)
    if not exact:
        return None
    rigid = next(i for i, x in enumerate(exact) if x)
    with mpmath.workdps(mpmath.mp.dps + GUARD):
        coefficients = [mpmath.mpf(x) / exact[-1] for x in exact[rigid:]]
        found = []
        for start in starts(coefficients):
            root = refined(coefficients, start)
            if root is None:
                return None
            found += [root, root.conjugate()] if start.imag else [root.real]
        return [mpmath.mpf(0)] * rigid + found if all_are(coefficients, found) else None


def whole(matrices):
    """[[[Aₖ,ᵢⱼ]]] as whole multiples of one power of 2."""
    n = range(matrices[0].rows)
    parts = [[[(int(mpmath.sign(a[i, j])) * a[i, j].man, a[i, j].exp) for a in matrices] for j in n] for i in n]
    least = min((pair[1] for row in parts for entry in row for pair in entry if pair[0]), default=0)
    return [[[man << (exp - least) if man else 0 for man, exp in entry] for entry in row] for row in parts]


def determinant(rows, n):
    """The coefficients of the determinant of polynomials, by Laplace's expansion: of the first rows, those of each
    choice of as many columns."""
    minors = {0: [1]}
    for row in rows:
        wider = {}
        for columns, minor in minors.items():
            for j in (j for j in range(n) if not columns >> j & 1 and any(row[j])):
                sign = -1 if (columns >> j).bit_count() % 2 else 1
                total = wider.setdefault(columns | 1 << j, [0] * (len(minor) + len(row[j]) - 1))
                for i, x in enumerate(minor):
                    for k, y in enumerate(row[j]):
                        total[i + k] += sign * x * y
        minors = wider
    found = minors.get((1 << n) - 1, [])
    while found and not found[-1]:
        found.pop()
    return found


def starts(coefficients):
    """The roots in floats, of each conjugate pair the one above, with λ in a unit that makes their product 1."""
    degree = len(coefficients) - 1
    if not degree:
        return []
    unit = abs(coefficients[0]) ** (mpmath.mpf(1) / degree)
    scaled = [float(x * unit ** (i - degree)) for i, x in enumerate(coefficients)]
    if not np.isfinite(scaled).all():
        return [mpmath.mpc(1)]
    return [mpmath.mpc(complex(x)) * unit for x in np.roots(scaled[::-1]) if x.imag >= 0]


def refined(coefficients, start):
    """A root by Newton's method, to all digits; None where it does not come to rest as by single roots."""
    z, nearer = start if start.imag else start.real, mpmath.mpf(10) ** (LOST - mpmath.mp.dps)
    for _ in range(STEPS):
        value, slope = coefficients[-1], mpmath.mpf(0)
        for x in coefficients[-2::-1]:
            value, slope = value * z + x, slope * z + value
        if not value:
            return z
        if not slope:
            return None
        step = value / slope
        z -= step
        if abs(step) <= nearer * abs(z):
            return z
    return None


def all_are(coefficients, found):
    """Is Π(λ − λᵢ) that polynomial, beside Π(λ + |λᵢ|)?"""
    product, sizes = [mpmath.mpf(1)], [mpmath.mpf(1)]
    for root in found:
        product = [a - root * b for a, b in zip([0, *product], [*product, 0], strict=True)]
        sizes = [a + abs(root) * b for a, b in zip([0, *sizes], [*sizes, 0], strict=True)]
    small = mpmath.mpf(10) ** (2 * LOST - mpmath.mp.dps)
    return len(product) == len(coefficients) and all(
        abs(a - b) <= small * size for a, b, size in zip(product, coefficients, sizes, strict=True))
