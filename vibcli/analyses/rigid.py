"""How many rigid-body motions a set of springs leaves free: n less the rank of the unscaled rows ∇s, exactly.

Stiffness plays no part in it. Rows of rational numbers are eliminated modulo a large prime, which can only
understate a rank with the odds of n/2^61; rows of floats by complete pivoting, rows with rounding in their parts
counting as dependent below 1e-14 n.
"""

from fractions import Fraction

from vibcli.analyses.scaled import exponent

PRIME = (1 << 61) - 1


def rigid_count(n, rows, exact_rows=None):
    """n − rank of the rows: dicts {coordinate: component}, and the same as Fractions where they are rational."""
    return n - rank(n, rows, exact_rows)


def undamped_rigid(elements, zeros, data):
    """How many of the `zeros` rigid motions no damper resists; 0 where damping is not all Σ c ∇s ∇sᵀ.

    data: the elements in the arithmetic that decides about rows which are not rational.
    """
    if not zeros or any(elements.C.values()) or any(elements.G.values()):
        return 0
    rows = [row for k, row in data.springs if k] + [row for c, row in data.dampers if c]
    rational = all(isinstance(x, (int, Fraction)) for row in rows for x in row.values())
    return elements.n - rank(elements.n, rows, rows if rational else None)


def rank(n, rows, exact_rows=None):
    """The rank of sparse rows."""
    if exact_rows is not None:
        rows = exact_rows
    if all(_is_difference(row) for row in rows):
        return n - _floating_components(n, rows)
    if exact_rows is not None:
        return _rank_modulo(rows)
    return _rank_of_floats(n, rows)


def _is_difference(row):
    """Whether a row is a(qᵢ − qⱼ), a qᵢ, or nothing."""
    parts = [x for x in row.values() if x]
    return len(parts) < 2 or (len(parts) == 2 and parts[0] == -parts[1])


def _floating_components(n, rows):
    """Connected parts of the coordinates that no row ties to the ground."""
    parent = list(range(n + 1))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for row in rows:
        ends = [i for i, x in row.items() if x]
        if ends:
            parent[root(ends[0])] = root(ends[1] if len(ends) == 2 else n)
    return len({root(i) for i in range(n)} - {root(n)})


def _rank_modulo(rows):
    """Rank over the integers modulo 2^61 − 1, sparse, the shortest row first."""
    pivots = {}
    for row in sorted(rows, key=len):
        rest = {}
        for i, x in row.items():
            value = x.numerator % PRIME * pow(x.denominator % PRIME, -1, PRIME) % PRIME
            if value:
                rest[i] = value
        while rest:
            lead = min(rest)
            if lead not in pivots:
                scale = pow(rest[lead], -1, PRIME)
                pivots[lead] = {i: x * scale % PRIME for i, x in rest.items()}
                break
            factor = rest[lead]
            for i, x in pivots[lead].items():
                value = (rest.get(i, 0) - factor * x) % PRIME
                if value:
                    rest[i] = value
                else:
                    rest.pop(i, None)
    return len(pivots)


def _rank_of_floats(n, rows):
    """Rank of float rows with rounding in their components, by Gaussian elimination with complete pivoting."""
    import numpy as np

    a = np.zeros((len(rows), n))
    for place, row in enumerate(rows):
        top = max((exponent(x) for x in row.values() if x), default=0)
        for i, x in row.items():
            a[place, i] = float(np.ldexp(float(x), -top)) if x else 0.0
    for axis in (0, 1, 0, 1):
        size = np.abs(a).max(axis=1 - axis, initial=0.0, keepdims=True)
        a = a / np.where(size > 0, 2.0 ** np.round(np.log2(np.where(size > 0, size, 1.0))), 1.0)
    found, limit = 0, 1e-14 * n
    while found < min(a.shape):
        at = np.argmax(np.abs(a[found:, found:]))
        i, j = divmod(int(at), n - found)
        i, j = i + found, j + found
        if abs(a[i, j]) <= limit:
            break
        a[[found, i]], a[:, [found, j]] = a[[i, found]], a[:, [j, found]]
        factor = a[found + 1:, found] / a[found, found]
        a[found + 1:, found:] -= np.multiply.outer(factor, a[found, found:])
        found += 1
    return found
