"""Small oscillations about a position: rows ∇s and weights of every element, in any arithmetic.

With s(q, t) the scalar functions of the scene, T = ½ Σ w ṡ², V = Σ (N s + ½ k s²) + Σ f s, Φ = ½ Σ c ṡ², δA = Σ F δs:

    M = Σ w ∇s ∇sᵀ + ∂²T/∂q̇²                C + G = Σ c ∇s ∇sᵀ + 2 Σ w ∇s (∂ₜ∇s)ᵀ − Σ ∇s (∂F/∂q̇)ᵀ + ∂²Φ/∂q̇² + …
    r = Σ P ∇s + ∂V/∂q − ∂T/∂q              P = N + k s,  f,  w ∂ₜₜs,  c ∂ₜs,  −F
    K = ∂r/∂q = Σ k ∇s ∇sᵀ + Σ P ∇²s + Σ w ∇s (∂ₜₜ∇s)ᵀ + Σ c ∇s (∂ₜ∇s)ᵀ − Σ ∇s (∂F/∂q)ᵀ + …

Σ P ∇²s is the geometric stiffness of preloads and weights (Kovacić & Radomirović 2018, ch. 2); r = 0 in equilibrium.
G is the skew part of what inertia multiplies the velocities with, C what dampers and loads do. Driven displacements
that oscillate are small like the coordinates: springs and dampers are linear in them too, which leaves them to the
excitation; and so are loads that depend on the time, which add nothing to Σ P ∇²s.
"""

from vibcli.algebra.calculus import gradient, substitute
from vibcli.algebra.evaluate import evaluate, evaluate_rational
from vibcli.algebra.normal import textbook
from vibcli.algebra.rationals import ONE
from vibcli.mechanics.elements import OscillatorElements

ALIKE = 2.0**-46


class Linearisation:
    """The expressions of all rows and weights, in the coordinates or with the drawn position substituted.

    inertias, springs, dampers: [(weight, {i: ∂s/∂qᵢ})]; curved: [(force, {(i, j): ∂²s/∂qᵢ∂qⱼ}, {i: ∂s/∂qᵢ})], the force
    being that along s; M, C, G, K: {(i, j): expression}, K as a list of terms; residual: {i: [expressions]}.
    """

    __slots__ = ("C", "G", "K", "M", "curved", "dampers", "drag", "inertias", "n", "residual", "springs", "table")


def linearise(scene, still=False):
    """The Linearisation of a scene as functions of the coordinates; `still`: without any excitation, so that what
    depends on the time turns or drifts with a carrier."""
    number = {node: i for i, node in enumerate(scene.q)}
    found = Linearisation()
    found.n, found.table, found.drag = len(scene.q), scene.table, {}
    inertias = scene.at_still("inertias") if still else scene.inertias
    found.inertias = [(term.weight, _row(term.s, number)) for term in inertias]
    dampers = scene.at_still("dampers")
    found.dampers = [(term.weight, _row(term.s, number)) for term in dampers]
    found.springs, found.curved = [], []
    for term in scene.at_still("springs"):
        row = _row(term.s, number)
        found.springs.append((term.weight, row))
        found.curved.append((term.force + term.weight * term.s, _curvature(row, number), row))
    for term in scene.weights:
        row = _row(term.s, number)
        found.curved.append((term.weight, _curvature(row, number), row))
    _written_out(scene, found, number)
    slips = {}
    for term in scene.forces:
        _loaded(scene, found, number, term, slips, still)
    _split(found, slips, found.drag)
    slips = {}
    if scene.timed:
        for kind, terms in (("inertias", inertias), ("dampers", dampers)):
            for term in terms:
                _driven(scene, found, number, term, kind, slips)
    _split(found, slips, found.G)
    return found


def _loaded(scene, found, number, term, slips, still):
    """A force F with the virtual work F δs."""
    rest, speeds = dict.fromkeys(scene.v, scene.table.zero), {v: i for i, v in enumerate(scene.v)}
    force, row = substitute([term.weight], rest)[0], _row(term.s, number)
    at_once = scene.table.sum(*((part, c) for part, c in _parts(force) if part.mask & scene.time.mask))
    found.curved.append((at_once - force, _curvature(row, number), row))
    found.residual.append({i: -(at_once * slope) for i, slope in row.items() if not (still or at_once.is_zero)})
    slopes = gradient(term.weight)
    by_place = {number[q]: slope for q, slope in slopes.items() if q in number}
    by_speed = {speeds[v]: slope for v, slope in slopes.items() if v in speeds}
    found.K.append(_at_rest({(i, j): -(x * slope) for i, x in row.items() for j, slope in by_place.items()}, rest))
    for (i, j), node in _at_rest({(i, j): -(x * slope) for i, x in row.items() for j, slope in by_speed.items()},
                                 rest).items():
        slips.setdefault((i, j), []).append(node)


def _parts(node):
    return node.args if node.op == "sum" else ((node, ONE),)


def _driven(scene, found, number, term, kind, slips):
    """What an inertia or a damper adds where its s(q, t) depends on the time explicitly."""
    first = gradient(term.s).get(scene.time)
    if first is None:
        return
    row = _row(term.s, number)
    turning, weight = _row(first, number), term.weight
    if kind == "dampers":
        force, bend = first, turning
    else:
        force = gradient(first).get(scene.time, scene.table.zero)
        bend = _row(force, number)
        for i, x in row.items():
            for j, slope in turning.items():
                slips.setdefault((i, j), []).append(2 * weight * x * slope)
    found.curved.append((weight * force, _curvature(row, number), row))
    found.K.append({(i, j): weight * x * slope for i, x in row.items() for j, slope in bend.items()})


def _split(found, slips, skew_parts):
    """Adds the symmetric part of {(i, j): [terms]} to C, the skew part to `skew_parts`."""
    total = {pair: found.table.sum(*((node, ONE) for node in terms)) for pair, terms in slips.items()}
    zero = found.table.zero
    for i, j in {tuple(sorted(pair)) for pair in total}:
        one, two = total.get((i, j), zero), total.get((j, i), zero)
        same, skew = textbook((one + two) / 2), textbook((one - two) / 2)
        for matrix, pairs in ((found.C, {(i, j): same, (j, i): same}), (skew_parts, {(i, j): skew, (j, i): -skew})):
            for pair, node in pairs.items():
                if not node.is_zero:
                    matrix[pair] = matrix.get(pair, zero) + node


def _row(s, number):
    return {number[q]: slope for q, slope in gradient(s).items() if q in number}


def _curvature(row, number):
    return {(i, number[q]): second for i, slope in row.items() for q, second in gradient(slope).items() if q in number}


def _written_out(scene, found, number):
    """What `energies` and `matrices` add."""
    speeds = {node: i for i, node in enumerate(scene.v)}
    rest = dict.fromkeys(scene.v, scene.table.zero)
    T, V, Phi = (scene.energies[key] for key in ("T", "V", "Phi"))
    momentum = {speeds[v]: p for v, p in gradient(T).items() if v in speeds}
    force = {speeds[v]: p for v, p in gradient(Phi).items() if v in speeds}
    found.M = _at_rest(_blocks(momentum, speeds), rest)
    found.C = _at_rest(_blocks(force, speeds), rest)
    slips = _at_rest(_blocks(momentum, number), rest)
    found.G = {pair: slips.get(pair, scene.table.zero) - slips.get(pair[::-1], scene.table.zero)
               for pair in set(slips) | {(j, i) for i, j in slips}}
    found.G = {pair: node for pair, node in found.G.items() if not node.is_zero}
    slope_V = {number[q]: s for q, s in gradient(V).items() if q in number}
    slope_T = {number[q]: s for q, s in gradient(T).items() if q in number}
    found.K = [_at_rest(_blocks(slope_V, number), rest), _at_rest(_blocks(_negated(slope_T), number), rest)]
    found.residual = [_at_rest(slope_V, rest), _at_rest(_negated(slope_T), rest)]
    drag = [force]
    if scene.timed:
        drag.append({i: gradient(p)[scene.time] for i, p in momentum.items() if scene.time in gradient(p)})
        for pair, node in _at_rest(_blocks(drag[1], speeds), rest).items():
            found.C[pair] = found.C.get(pair, scene.table.zero) + node
    found.K += [_at_rest(_blocks(part, number), rest) for part in drag]
    found.residual += [_at_rest(part, rest) for part in drag]
    for key, rows in scene.matrices.items():
        _outright(scene, found, key, rows)


def _outright(scene, found, key, rows):
    """Adds a matrix that the scene gives outright: M, K, or C = sym C + G."""
    pairs = [(i, j) for i in range(found.n) for j in range(found.n)]
    if key == "K":
        found.K.append({(i, j): rows[i][j] for i, j in pairs if not rows[i][j].is_zero})
        found.residual.append({i: scene.table.sum(*((q * k, ONE) for q, k in zip(scene.q, row, strict=True)))
                               for i, row in enumerate(rows)})
        return
    parts = [(found.M if key == "M" else found.C, 1)] + [(found.G, -1)] * (key == "C")
    for matrix, sign in parts:
        for i, j in pairs:
            half = (rows[i][j] + sign * rows[j][i]) / 2
            if not half.is_zero:
                matrix[i, j] = matrix.get((i, j), scene.table.zero) + half


def _blocks(slopes, number):
    """{(i, j): ∂slopeᵢ/∂xⱼ} of {i: slope}, by the symbols in `number`."""
    return {(i, number[x]): second for i, slope in slopes.items() for x, second in gradient(slope).items()
            if x in number}


def _negated(slopes):
    return {i: -slope for i, slope in slopes.items()}


def _at_rest(entries, rest):
    values = substitute(list(entries.values()), rest)
    return {key: node for key, node in zip(entries, values, strict=True) if not node.is_zero}


def at_position(form, values):
    """The Linearisation with coordinates replaced, {symbol: node}; what vanishes there is left out.

    In letters, so that what is zero by structure is exactly zero.
    """
    nodes = []
    _each(form, lambda node: nodes.append(node) or node)
    moved = dict(zip(nodes, substitute(nodes, values), strict=True))
    return _each(form, moved.__getitem__)


def _each(form, change):
    """A Linearisation with `change` applied to every expression in a fixed order."""
    found = Linearisation()
    found.n, found.table = form.n, form.table

    def entries(mapping):
        changed = {key: change(node) for key, node in mapping.items()}
        return {key: node for key, node in changed.items() if not node.is_zero}

    for kind in ("inertias", "springs", "dampers"):
        setattr(found, kind, [(change(weight), entries(row)) for weight, row in getattr(form, kind)])
    found.curved = [(change(force), entries(curvature), entries(row)) for force, curvature, row in form.curved]
    for kind in ("M", "C", "G", "drag"):
        setattr(found, kind, entries(getattr(form, kind)))
    found.K = [entries(part) for part in form.K]
    found.residual = [entries(part) for part in form.residual]
    return found


def residual_terms(form):
    """The terms of each condition of equilibrium r = 0: a list of expressions for each coordinate."""
    found = [[] for _ in range(form.n)]
    for force, _, row in form.curved:
        for i, slope in row.items():
            found[i].append(force * slope)
    for part in form.residual:
        for i, node in part.items():
            found[i].append(node)
    return found


class Numbers:
    """A Linearisation evaluated: the element data, the residual r, and the sizes of the terms r was added from."""

    __slots__ = ("elements", "residual", "residual_size")

    def __init__(self, elements, residual, residual_size):
        self.elements, self.residual, self.residual_size = elements, residual, residual_size


def in_numbers(form, arithmetic, values, rational=None):
    """The Numbers of a Linearisation. `rational`: exact values of the symbols, for rows that are exactly rational."""
    nodes = []
    _each(form, lambda node: nodes.append(node) or node)
    unique = list(dict.fromkeys(nodes))
    known = dict(zip(unique, evaluate(unique, arithmetic, values), strict=True))
    data = _Evaluated(known)
    n, zero = form.n, arithmetic.number(form.table.zero.coefficient)
    K, size = {}, {}
    residual, residual_size = [zero] * n, [zero] * n
    for force, curvature, row in form.curved:
        f = known[force]
        for pair, second in curvature.items():
            _accumulate(K, size, pair, f * known[second])
        for i, slope in row.items():
            _gather(residual, residual_size, i, f * known[slope])
    for part in form.K:
        for pair, node in part.items():
            _accumulate(K, size, pair, known[node])
    for part in form.residual:
        for i, node in part.items():
            _gather(residual, residual_size, i, known[node])
    if arithmetic.ordered:
        _even_out(K, size)
    elements = OscillatorElements(
        n, data.rows(form.inertias), data.rows(form.springs), data.rows(form.dampers), M=data.entries(form.M),
        C=data.entries(form.C), G=data.entries(form.G), drag=data.entries(form.drag), K=K, K_size=size,
        massless=massless(form, known), rational_rows=_rational_rows(form, rational))
    return Numbers(elements, residual, residual_size)


def _accumulate(K, size, pair, term):
    if term:
        K[pair] = K.get(pair, 0) + term
        size[pair] = size.get(pair, 0) + abs(term)


def _even_out(K, size):
    """K of forces with a potential is symmetric: what differs by rounding alone is made equal."""
    for (i, j), one in list(K.items()):
        other = K.get((j, i), 0)
        if i < j and one != other and abs(one - other) <= ALIKE * max(size[i, j], size.get((j, i), 0)):
            K[i, j] = K[j, i] = (one + other) / 2


def _gather(residual, size, i, term):
    residual[i] = residual[i] + term
    size[i] = size[i] + abs(term)


class _Evaluated:
    def __init__(self, known):
        self.known = known

    def rows(self, terms):
        known = self.known
        return [(known[weight], {i: known[node] for i, node in row.items()}) for weight, row in terms]

    def entries(self, mapping):
        return {pair: self.known[node] for pair, node in mapping.items()}


def massless(form, known):
    """Coordinates which no inertia moves: those in no row of T and in no entry of M but such as are exactly zero."""
    moving = {i for weight, row in form.inertias if known[weight] for i in row}
    moving |= {i for (i, _), node in form.M.items() if known[node]}
    return [i for i in range(form.n) if i not in moving]


def _rational_rows(form, rational):
    if rational is None:
        return None
    nodes = [node for _, row in form.springs for node in row.values()]
    values = evaluate_rational(nodes, rational)
    if values is None:
        return None
    known = dict(zip(nodes, values, strict=True))
    return [{i: known[node] for i, node in row.items()} for _, row in form.springs]


def nodes_of(form):
    """Every expression of a Linearisation."""
    nodes = []
    _each(form, lambda node: nodes.append(node) or node)
    return nodes
