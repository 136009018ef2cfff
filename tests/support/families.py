"""Random oscillators of every kind that breaks solvers, and their eigenvalues in many digits.

Each family is a function (random, n, ratio) -> FactoredSystem; ratio is the quotient of the stiffest and the
softest spring.
"""

import math
from fractions import Fraction

import mpmath
from support.characteristic_roots import roots

from vibcli.mechanics.factored_system import FactoredSystem


def _weight(random, ratio):
    return ratio ** random.random()


def _masses(random, n, ratio=10.0):
    return [(_weight(random, ratio), {i: 1.0}) for i in range(n)]


def _with_rows(n, inertias, springs, **more):
    rows = tuple({i: Fraction(x) for i, x in row.items()} for _, row in springs)
    return FactoredSystem(n, inertias, springs, rational_rows=rows, **more)


def chain(random, n, ratio, grounded=True):
    """Masses in a row."""
    springs = [(_weight(random, ratio), {i: 1.0, i - 1: -1.0}) for i in range(1, n)]
    if grounded:
        springs.append((_weight(random, ratio), {0: 1.0}))
    return _with_rows(n, _masses(random, n), springs)


def free_chain(random, n, ratio):
    """Masses in a row, tied to nothing."""
    return chain(random, n, ratio, grounded=False)


def tree(random, n, ratio):
    """Each mass hung on an earlier one."""
    springs = [(_weight(random, ratio), {i: 1.0, random.randrange(i): -1.0}) for i in range(1, n)]
    springs.append((_weight(random, ratio), {random.randrange(n): 1.0}))
    return _with_rows(n, _masses(random, n), springs)


def ring(random, n, ratio):
    """A chain closed on itself, with some cross ties and now and then one to the ground."""
    springs = [(_weight(random, ratio), {i: 1.0, (i + 1) % n: -1.0}) for i in range(n) if n > 1]
    for _ in range(random.randrange(3)):
        i, j = random.randrange(n), random.randrange(n)
        if i != j:
            springs.append((_weight(random, ratio), {i: 1.0, j: -1.0}))
    if random.random() < 0.5:
        springs.append((_weight(random, ratio), {random.randrange(n): 1.0}))
    return _with_rows(n, _masses(random, n), springs)


def levers(random, n, ratio):
    """Rigid bars (x and angle by turns) tied to each other and to the ground at points along them."""
    n += n % 2
    inertias = [(_weight(random, 10.0), {i: 1.0}) for i in range(n)]
    springs = []
    for i in range(0, n, 2):
        for _ in range(2):
            row = {i: 1.0, i + 1: random.choice((-1.0, -0.75, 0.5, 1.0, 1.25))}
            if i and random.random() < 0.6:
                j = 2 * random.randrange(i // 2)
                row |= {j: -1.0, j + 1: random.choice((-1.0, 0.25, 0.5, 1.0))}
            springs.append((_weight(random, ratio), row))
    return _with_rows(n, inertias, springs)


def general(random, n, ratio):
    """Rows of any components, as of a planar truss; one spring more than coordinates."""
    springs = [(_weight(random, ratio), {i: random.uniform(-1, 1) for i in random.sample(range(n), min(n, 4))})
               for _ in range(n + 1)]
    return _with_rows(n, _masses(random, n), springs)


def full_mass(random, n, ratio):
    """Coordinates coupled through the masses, as relative coordinates are."""
    inertias = [(_weight(random, 1e3), dict.fromkeys(range(i + 1), 1.0)) for i in range(n)]
    inertias += [(_weight(random, 1e3), {i: random.uniform(-1, 1), (i + 1) % n: 1.0}) for i in range(n)]
    springs = [(_weight(random, ratio), {i: 1.0}) for i in range(n)]
    return _with_rows(n, inertias, springs)


def preloaded(random, n, ratio):
    """A chain with a symmetric, mostly indefinite matrix added to its stiffness."""
    base = chain(random, n, ratio)
    k = {}
    for i in range(n):
        for j in range(i + 1):
            if i == j or random.random() < 0.4:
                k[i, j] = k[j, i] = random.uniform(-2, 1)
    return FactoredSystem(n, base.inertias, base.springs, K=k)


def repeated(random, n, ratio):
    """A ring of equal masses and springs: its frequencies come in pairs."""
    k = _weight(random, ratio)
    springs = [(k, {i: 1.0, (i + 1) % n: -1.0}) for i in range(n) if n > 2] + [(k / 2, {i: 1.0}) for i in range(n)]
    return _with_rows(n, [(3.0, {i: 1.0}) for i in range(n)], springs)


def massless_nodes(random, n, ratio):
    """A chain with some nodes of no mass."""
    base = chain(random, n, ratio)
    bare = sorted(random.sample(range(n), max(1, n // 3))) if n > 1 else []
    inertias = [term for i, term in enumerate(base.inertias) if i not in bare]
    return _with_rows(n, inertias, base.springs, massless=bare)


ONE_AXIS = (chain, free_chain, tree, ring, levers)
UNDAMPED = (*ONE_AXIS, general, full_mass, preloaded, repeated, massless_nodes)


def damped_chain(random, n, ratio, size=1.0, grounded=True):
    """A chain with dampers anywhere, their strengths about `size`."""
    base = chain(random, n, ratio, grounded)
    dampers = []
    for _ in range(random.randrange(1, n + 2)):
        i, j = random.randrange(n), random.randrange(n)
        row = {i: 1.0} if i == j else {i: 1.0, j: -1.0}
        dampers.append((size * _weight(random, 10.0), row))
    return _with_rows(n, base.inertias, base.springs, dampers=dampers)


def gyroscopic(random, n, ratio, size=1.0, grounded=True):
    """A chain with a random skew matrix and no damping."""
    base = chain(random, n, ratio, grounded)
    g = {}
    for i in range(n):
        for j in range(i):
            g[i, j] = size * random.uniform(-1, 1)
            g[j, i] = -g[i, j]
    return _with_rows(n, base.inertias, base.springs, G=g)


def rotor(random, n, ratio, size=1.0):
    """Skew, damping and indefinite stiffness together."""
    base, turning = preloaded(random, n, ratio), gyroscopic(random, n, ratio, size)
    dampers = damped_chain(random, n, ratio, size).dampers
    return FactoredSystem(n, base.inertias, base.springs, dampers, G=turning.G, K=base.K)


def follower(random, n, ratio, size=1.0, grounded=True):
    """A chain with a matrix added to its stiffness that is not symmetric; of a free one each row of it sums to zero."""
    base, k, unit = chain(random, n, ratio, grounded), {}, 2.0 ** (math.floor(math.log2(size)) - 20)
    for i in range(n):
        for j in range(n):
            if (i != j or grounded) and random.random() < 0.5:
                k[i, j] = unit * random.randrange(-1 << 20, 1 << 20)
        if not grounded:
            k[i, i] = -sum(x for (row, _), x in k.items() if row == i)
    return FactoredSystem(n, base.inertias, base.springs, K=k)


def free_follower(random, n, ratio, size=1.0):
    """The same tied to nothing."""
    return follower(random, n, ratio, size, grounded=False)


def massive_follower(random, n, ratio, size=1.0):
    """The same with coordinates coupled through the masses."""
    base = full_mass(random, n, ratio)
    return FactoredSystem(n, base.inertias, base.springs, K=follower(random, n, ratio, size).K)


def massless_follower(random, n, ratio, size=1.0):
    """The same with some nodes of no mass."""
    base = massless_nodes(random, n, ratio)
    return FactoredSystem(n, base.inertias, base.springs, K=follower(random, n, ratio, size).K,
                              massless=base.massless)


def driven(random, n, ratio, size=1.0, follow=follower):
    """Follower forces, dampers that resist or push, and now and then a skew matrix."""
    base = follow(random, n, ratio, 10 ** random.uniform(-4, 4))
    pushed = [(w * random.choice((1, 1, -1)), row) for w, row in damped_chain(random, n, ratio, size).dampers]
    g = gyroscopic(random, n, ratio, 10 ** random.uniform(-4, 4)).G if random.random() < 0.5 else {}
    g = {at: x for at, x in g.items() if not set(at) & set(base.massless)}
    return FactoredSystem(n, base.inertias, base.springs, pushed, G=g, K=base.K, massless=base.massless)


def held_by_spin(random, n, ratio, size=1.0):
    """Pairs of coordinates on negative springs, spun somewhat faster or slower than what holds them, loosely tied."""
    base, springs, g, k = chain(random, n, 10.0), [], {}, {}
    for i in range(0, n - 1, 2):
        stiffness, (m, _), (other, _) = _weight(random, ratio), *base.inertias[i:i + 2]
        springs += [(-stiffness, {i: 1.0}), (-stiffness, {i + 1: 1.0})]
        least = math.sqrt(stiffness) * (math.sqrt(m) + math.sqrt(other))
        g[i, i + 1] = least * (1 + random.choice((-1, 1)) * 10 ** random.uniform(-12, 0))
        g[i + 1, i] = -g[i, i + 1]
        if i:
            k[i, i - 1] = k[i - 1, i] = random.choice((0.0, 1e-3 * stiffness))
    springs += [(1.0, {n - 1: 1.0})] * (n % 2)
    return FactoredSystem(n, base.inertias, springs, G=g, K=k)


def anything(random, n, ratio, size=1.0):
    """Springs, dampers and matrices of any sign and of strengths up to `ratio` apart, on any coordinates."""
    def weight():
        return random.choice((1.0, 1.0, 2.0, random.uniform(0.1, 5), ratio ** random.uniform(-1, 1)))

    def row(largest=3):
        return {i: random.choice((1.0, -1.0, 0.5, random.uniform(-1, 1)))
                for i in random.sample(range(n), random.randrange(1, min(n, largest) + 1))}

    def several(most, negative=0.1):
        return [(weight() * (-1 if random.random() < negative else 1), row()) for _ in range(random.randrange(most))]

    inertias = [(weight(), {i: 1.0}) for i in range(n)]
    if random.random() < 0.3:
        inertias.append((weight(), row()))
    c, g, k = {}, {}, {}
    for i in range(n):
        if random.random() < 0.1:
            c[i, i] = weight() * size
        for j in range(i):
            if random.random() < 0.15:
                k[i, j] = k[j, i] = random.choice((-1, 1)) * weight()
            if random.random() < 0.15:
                g[i, j] = weight()
                g[j, i] = -g[i, j]
    dampers = [(w * size, r) for w, r in several(n + 2)]
    return FactoredSystem(n, inertias, several(2 * n), dampers, C=c, G=g, K=k)


def dense(terms, matrix, n):
    """Σ w s sᵀ + matrix in mpmath."""
    out = mpmath.zeros(n, n)
    for weight, row in terms:
        for i, x in row.items():
            for j, y in row.items():
                out[i, j] += mpmath.mpf(weight) * x * y
    for (i, j), x in matrix.items():
        out[i, j] += x
    return out


def pencil(elements):
    """M, C + G, K in mpmath."""
    n = elements.n
    c = dense(elements.dampers, elements.C, n)
    for (i, j), x in elements.G.items():
        c[i, j] += x
    return dense(elements.inertias, elements.M, n), c, dense(elements.springs, elements.K, n)


def squares(elements):
    """ω² ascending, massless coordinates condensed, at the precision that mpmath has now."""
    m, _, k = pencil(elements)
    bare = sorted(elements.massless)
    kept = [i for i in range(elements.n) if i not in bare]
    if bare:
        part = lambda a, r, c: mpmath.matrix([[a[i, j] for j in c] for i in r])  # noqa: E731
        follow = mpmath.lu_solve(part(k, bare, bare), part(k, bare, kept)) if len(kept) == 1 else \
            part(k, bare, bare) ** -1 * part(k, bare, kept)
        k, m = part(k, kept, kept) - part(k, kept, bare) * follow, part(m, kept, kept)
    inverse = mpmath.cholesky(m) ** -1
    a = inverse * k * inverse.T
    return sorted(mpmath.eigsy((a + a.T) / 2, eigvals_only=True))


def condensed(elements):
    """M⁻¹K of the massive coordinates, the massless ones following."""
    m, _, k = pencil(elements)
    bare = sorted(elements.massless)
    kept = [i for i in range(elements.n) if i not in bare]

    def part(a, rows, columns):
        return mpmath.matrix([[a[i, j] for j in columns] for i in rows])

    if bare:
        k = part(k, kept, kept) - part(k, kept, bare) * part(k, bare, bare) ** -1 * part(k, bare, kept)
    return part(m, kept, kept) ** -1 * k


def circulatory_squares(elements):
    """The eigenvalues −λ² of M⁻¹K, K not symmetric, massless coordinates condensed."""
    m, _, k = pencil(elements)
    return roots((k, -m)) or list(mpmath.eig(condensed(elements), left=False, right=False))


def eigenvalues(elements):
    """All 2n eigenvalues λ of λ²M + λ(C + G) + K, at the precision that mpmath has now."""
    return roots(pencil(elements)[::-1]) or by_qr(elements)


def by_qr(elements):
    """The same by mpmath's QR algorithm, which takes ten times as long."""
    m, c, k = pencil(elements)
    n, inverse = elements.n, m ** -1
    a = mpmath.zeros(2 * n, 2 * n)
    for i in range(n):
        a[i, n + i] = 1
    a[n:, :n], a[n:, n:] = -(inverse * k), -(inverse * c)
    return list(mpmath.eig(a, left=False, right=False))


def hypotenuse(values):
    """√Σx²: the size of the largest in a list of mpmath numbers, near enough."""
    return math.sqrt(sum(float(abs(x)) ** 2 for x in values))
