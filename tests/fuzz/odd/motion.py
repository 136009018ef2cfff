"""Motions in time: small ones by exponentials of matrices and Gauss' quadrature, full ones by DOP853."""

from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

from . import jets, words
from .mechanics import accelerations, at_rest, mass

BEFORE = 1e-12                  # [s]; a step has its value to the right of it
NODES, WEIGHTS = np.polynomial.legendre.leggauss(14)


def breaks(figure, until):
    """The instants at which loads and drives may jump."""
    found = {0.0, until}
    for tree in of_time(figure):
        for name in ("step", "ramp", "impulse", "sign"):
            for (argument,) in words.calls(tree, name):
                start, rate, _ = figure.of_time([(1, argument)], 0.0)
                if rate:
                    found.add(-start / rate)
        for name, record in figure.records.items():
            for (argument,) in words.calls(tree, name):
                start, rate, _ = figure.of_time([(1, argument)], 0.0)
                found |= {(sample - start) / rate for sample in record.times}
        waves = [arguments for name in ("square", "sawtooth") for arguments in words.calls(tree, name)]
        waves += [inner for name in ("abs", "max") for arguments in words.calls(tree, name)
                  for inner in words.calls(arguments[-1], "sin")]
        for (argument,) in waves:
            start, rate, _ = figure.of_time([(1, argument)], 0.0)
            if rate:
                found |= {(np.pi * k - start) / rate for k in range(int(rate * until / np.pi) + 2)}
    return sorted(t for t in found if 0 <= t <= until)


def of_time(figure):
    """The expressions of the time in a scene."""
    for load in figure.scene.get("forces", {}).values():
        texts = load.get("force", load.get("moment", load.get("value", f"sin(({load.get('speed')})*t)")))
        for text in texts if isinstance(texts, list) else [texts]:
            yield figure.tree(text)
    for drive in figure.drives:
        for _, tree in drive.terms:
            yield tree


def small_motion(figure, small, start, times):
    """(q, q') at ascending times of M x'' + C x' + K x = Q(t) about the equilibrium."""
    n = len(small.q)
    inverse = np.linalg.inv(small.M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ small.K, -inverse @ small.C]])
    fast = max(np.abs(np.linalg.eigvals(A)).max(), _fastest(figure))
    state, t, found = np.array(start, dtype=float), 0.0, []
    at = [*breaks(figure, times[-1]), *times]
    parts = figure.parts([*small.q, *at_rest(figure, small.q).u])
    along = _along(figure, parts)

    def load(t):
        return np.concatenate([np.zeros(n), inverse @ _load(figure, small, along, t)])

    def blow(t):
        return _blow(figure, inverse, along, t) - np.concatenate([np.zeros(n), inverse @ small.Mu @ jumps(figure, t)])

    state = state + blow(0.0)
    for end in sorted(set(at)):
        pieces = max(1, int(np.ceil((end - t) * fast / 2)))
        h = (end - t) / pieces
        if h > 1e-13:
            spans = (1 - NODES) * h / 2
            whole, within = exponential(A * h), exponential(A * spans[:, None, None])
            for i in range(pieces):
                at_nodes = np.array([load(t + i * h + (1 + x) * h / 2) for x in NODES])
                state = whole @ state + np.einsum("k,kij,kj->i", WEIGHTS * h / 2, within, at_nodes)
        t = end
        if t > 0:
            state = state + blow(t)
        if end in times:
            found.append(state.copy())
    return [(np.array(small.q) + x[:n], x[n:]) for x in found]


def load_of_time(figure, small, t):
    """Q(t) of small motions."""
    return _load(figure, small, _along(figure, figure.parts([*small.q, *at_rest(figure, small.q).u])), t)


def exponential(A):
    """exp(A) of a small matrix, or of each of several, by Taylor's series of A/2ⁿ and n squarings."""
    halvings = max(0, int(np.ceil(np.log2(max(np.abs(A).sum(axis=-1).max(), 1e-9)))) + 1)
    A = A / 2.0**halvings
    term = total = np.eye(A.shape[-1]) + 0 * A
    for k in range(1, 17):              # ‖A‖ ≤ 1/2: what is left is 1e-20
        term = term @ A / k
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return total


def _fastest(figure):
    """The highest angular frequency that stands in a load."""
    rates = [0.0]
    for tree in of_time(figure):
        for name in ("sin", "cos", "exp", "square", "sawtooth"):
            rates += [abs(figure.of_time([(1, argument)], 0.3)[1]) for (argument,) in words.calls(tree, name)]
    return max(rates)


def _along(figure, parts):
    """[(texts, turned, gradients)] of the loads that hold the time."""
    n = len(figure.independent)
    return [(figure.terms_of(text)[1], None if turned is None else jets.plain(turned), i, [
        jet.g[:n] if isinstance(jet, jets.Jet) else np.zeros(n) for jet in along])
        for texts, turned, along in parts.loads for i, text in enumerate(texts) if figure.terms_of(text)[1]]


def _load(figure, small, along, t):
    u, u1, u2 = figure.driven(t)
    total = np.zeros(len(small.q))
    if u:
        total = -(small.Mu @ np.array(u2) + small.Cu @ (np.array(u1) - _steady(figure)) + small.Ku @ np.array(
            [0.0 if drive.steady else x for drive, x in zip(figure.drives, u, strict=True)]))
    for text, turned, i, gradients in along:
        force = figure.value(text, {**figure.parameters, "t": t})
        if turned is None:
            total = total + force * gradients[i]
        else:
            c, s = np.cos(turned), np.sin(turned)
            x, y = ((c, s), (-s, c))[i]
            total = total + force * (x * gradients[0] + y * gradients[1])
    return total


def _steady(figure):
    """The speeds of drives that belong to the equilibrium."""
    return np.array([figure.of_time(drive.terms, 0.0)[1] if drive.steady else 0.0 for drive in figure.drives])


def _blow(figure, inverse, along, t):
    """The jump of the velocities where impulses act."""
    n = len(inverse)
    total = np.zeros(n)
    for text, _, i, gradients in along:
        for sign, tree in text:
            for (argument,) in words.calls(tree, "impulse"):
                start, rate, _ = figure.of_time([(1, argument)], 0.0)
                if abs(-start / rate - t) < 1e-12:
                    total = total + sign * _strength(figure, tree, t) * gradients[i]
    return np.concatenate([np.zeros(n), inverse @ total])


def _strength(figure, tree, t):
    """The coefficient of impulse(…) in a term, which holds one."""
    values = [figure.value([(1, tree)], {**figure.parameters, "t": t}, {
        **figure.functions, "impulse": lambda x, on=on: on}) for on in (0, 1)]
    return values[1] - values[0]


def struck(figure, state, t):
    """The same of the full equations in a state."""
    n = len(figure.independent)
    if not figure.records and not any(words.calls(tree, "impulse") for tree in of_time(figure)):
        return 0 * state
    parts = figure.parts([*state[:n], *figure.driven(t)[0]])
    inverse = np.linalg.inv(mass(figure, parts, n))
    carried = sum((w * np.outer(jet.g[:n], jet.g[n:]) for w, jet in parts.inertias), np.zeros((n, len(figure.drives))))
    return _blow(figure, inverse, _along(figure, parts), t) - np.concatenate([
        np.zeros(n), inverse @ carried @ jumps(figure, t)])


def jumps(figure, t):
    """The jumps of the speeds of drives at the samples of records."""
    after = figure.driven(t)[1]
    for record in figure.records.values():
        record.side = -1
    before = figure.driven(t)[1]
    for record in figure.records.values():
        record.side = 1
    return np.subtract(after, before)


def full_motion(figure, start, times, rtol=1e-9):
    """(q, q') at ascending times by the full equations."""
    n = len(figure.independent)
    state, found = np.array(start, dtype=float), []
    guess = dict(figure.drawn_values)

    def rates(t, y):
        if len(figure.coordinates) > n:
            known = figure.known([*y[:n], *figure.driven(t)[0]], guess)
            guess.update({name: known[name].v for name in figure.coordinates})
        return np.concatenate([y[n:], accelerations(figure, t, y[:n], y[n:], guess)])

    stops = sorted({*breaks(figure, times[-1]), *times})
    for begin, end in pairwise(stops):
        solved = solve_ivp(rates, (begin, end - BEFORE), state, "DOP853", rtol=rtol, atol=1e-12)
        state = solved.y[:, -1]
        state = state + struck(figure, state, end)
        if end in times:
            found.append((state[:n].copy(), state[n:].copy()))
    return found


