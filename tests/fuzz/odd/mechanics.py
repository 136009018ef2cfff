"""Lagrange's equations from jets: each inertia w moves along its jet r, and d/dt ∂T/∂r' of w r'²/2 is w r'' ∂r/∂q.

Accelerations are r'' = ∂r/∂z z'' + z' ∂²r/∂z² z', z being the coordinates and the driven displacements.
"""

from collections import namedtuple

import mpmath
import numpy as np

from . import jets, written

STEP = 1e-30
State = namedtuple("State", "q v a u u1 u2")
Small = namedtuple("Small", "q M C K Mu Cu Ku drag")


def rest(figure):
    """(u, u', u'') of the drives without those that come and go: a steady one turns with its speed."""
    zero = figure.literal(0, 1, 0)
    found = [figure.of_time(drive.terms, zero)[1] if drive.steady else zero for drive in figure.drives]
    return [zero] * len(found), found, [zero] * len(found)


def residual(figure, state, t=None, damped=True, parts=None, rows=None):
    """What is left of the equations in a state; loads of the time act where `t` is given.

    `rows`: of how many variables, where those of drives and of supports that give way are asked for as well: what is
    left is the force along them.
    """
    n = rows or len(state.q)
    parts = parts or figure.parts([*state.q, *state.u])
    rates = np.array([*state.v, *state.u1])
    second = np.array([*state.a, *state.u2])
    left = 0 * rates[:n]
    for w, jet in parts.inertias:
        left = left + w * (jet.g @ second + rates @ (jet.h @ rates)) * jet.g[:n]
    left = left + written.forces(figure, state, parts.known, n, damped)
    for force, jet in parts.weights:
        left = left - force * jet.g[:n]
    for name, jet in parts.springs.items():
        if isinstance(jet, jets.Jet):
            left = left + figure.tension(name, jet.v) * jet.g[:n]
    if damped:
        for name, jet in parts.dampers.items():
            if isinstance(jet, jets.Jet):
                left = left + (figure.damper_laws[name](jet.g @ rates) + figure.held.get(name, 0)) * jet.g[:n]
    for force, jet in loads(figure, parts, rates, t, damped):
        left = left - force * jet.g[:n]
    return left


def loads(figure, parts, rates, t, damped=True):
    """[(force, jet of the displacement along it)] in a state."""
    known = {**figure.parameters, **{k: jet.v for k, jet in parts.known.items()}}
    speeds = {f"{k}__1": jet.g @ rates for k, jet in parts.known.items() if isinstance(k, str)}
    known.update(speeds if damped else dict.fromkeys(speeds, 0))
    found = []
    for texts, turned, along in parts_of(parts.loads, figure, t):
        forces = [figure.value(text, {**known, "t": t}) for text in texts]
        if turned is not None:
            angle = jets.plain(turned)
            c, s = jets.cos(angle), jets.sin(angle)
            forces = [c * forces[0] - s * forces[1], s * forces[0] + c * forces[1]]
        found += [(force, jet) for force, jet in zip(forces, along, strict=True) if isinstance(jet, jets.Jet)]
    return found


def parts_of(loads, figure, t):
    """The loads that act: without a time those terms that hold none, component by component."""
    for texts, turned, along in loads:
        yield [text if t is not None else figure.terms_of(text)[0] for text in texts], turned, along


def settle_statics(figure):
    """Preloads that make the drawn position the equilibrium."""
    if not figure.statics:
        return
    names = list(figure.statics)
    state = at_rest(figure, [figure.drawn_values[name] for name in figure.independent])
    left = residual(figure, state)
    springs = figure.parts([*state.q, *state.u]).springs
    columns = np.array([springs[name].g[:len(left)] for name in names]).T
    found = np.linalg.lstsq(columns.astype(float), -left.astype(float), rcond=None)[0]
    figure.statics.update(zip(names, found.tolist(), strict=True))


def at_rest(figure, q):
    zero = [figure.literal(0, 1, 0)] * len(q)
    return State(list(q), zero, zero, *rest(figure))


def slopes(function, values):
    """The matrix of derivatives of a function of a list, by complex steps; in mpmath's numbers by differences."""
    columns = []
    for j in range(len(values)):
        if isinstance(values[j], mpmath.mpf):
            step = mpmath.mpf(10) ** (-mpmath.mp.dps // 3)
            up, down = ([*values[:j], values[j] + s, *values[j + 1:]] for s in (step, -step))
            columns.append((function(up) - function(down)) / (2 * step))
        else:
            columns.append(function([*values[:j], values[j] + 1j * STEP, *values[j + 1:]]).imag / STEP)
    return np.array(columns).T if columns else np.zeros((len(function(values)), 0))


def equilibrium(figure, start, close=1e-14):
    """The zero of the forces that Newton's method reaches, its steps kept short; None where it reaches none."""
    q = list(start)

    def forces(q):
        return residual(figure, at_rest(figure, q))

    for _ in range(100):
        left, slope = forces(q), slopes(forces, q)
        try:
            change = np.array(mpmath.lu_solve(slope.tolist(), left.tolist()).T.tolist()[0], dtype=object) if (
                left.dtype == object) else np.linalg.solve(slope, left)
        except (np.linalg.LinAlgError, ZeroDivisionError):
            return None
        longest = max(abs(step) for step in change)
        shrink = min(1, 0.2 / longest) if longest else 1
        q = [value - shrink * step for value, step in zip(q, change, strict=True)]
        if longest <= close:
            return q
    return None


def small(figure, q):
    """The matrices of small motions about an equilibrium, those of the drives too; `drag` is C of the dampers."""
    base = at_rest(figure, q)

    def by(field, **options):
        def moved(values):
            return residual(figure, base._replace(**{field: values}), **options)
        return slopes(moved, getattr(base, field))

    C = by("v")
    return Small(list(q), by("a"), C, by("q"), by("u2"), by("u1"), by("u"), C - by("v", damped=False))


def accelerations(figure, t, q, v, guess=None):
    """q'' of the full equations."""
    n = len(q)
    u, u1, u2 = figure.driven(t)
    zero = [0.0] * n
    state = State(list(q), list(v), zero, u, u1, u2)
    parts = figure.parts([*q, *u], guess)
    return np.linalg.solve(mass(figure, parts, n), -residual(figure, state, t, parts=parts))


def mass(figure, parts, n):
    """The matrix of q'' in the full equations."""
    return sum((w * np.outer(jet.g[:n], jet.g[:n]) for w, jet in parts.inertias), figure.given.get("M", 0))
