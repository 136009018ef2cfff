"""What can be read off a scene in a state: energies, places, stretches, forces of elements, supports and drives."""

from itertools import pairwise

import numpy as np

from . import jets, written
from .mechanics import STEP, State, accelerations, at_rest, residual
from .motion import load_of_time

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


def energies(figure, state, guess=None):
    """T, V and Φ in a state, V counted from the drawn position."""
    parts = figure.parts([*state.q, *state.u], guess)
    rates = np.array([*state.v, *state.u1])
    kinetic = sum(w * (jet.g @ rates) ** 2 for w, jet in parts.inertias) / 2
    drawn = [*(figure.drawn_values[name] for name in figure.independent), *(0.0 for _ in figure.drives)]
    fallen = sum(force * (jet.v - before.v) for (force, jet), (_, before) in zip(
        parts.weights, figure.parts(drawn).weights, strict=True))
    stored = sum(_work(lambda s, name=name: figure.tension(name, s), jets.plain(stretch), figure.bends(name))
                 for name, stretch in parts.springs.items())
    lost = sum(_work(figure.damper_laws[name], jet.g @ rates) for name, jet in parts.dampers.items()
               if isinstance(jet, jets.Jet))
    lost += sum(size * abs(parts.dampers[name].g @ rates) for name, (size, _) in figure.frictions.items())
    more = written.energies(figure, state, parts.known)
    return {"T": kinetic + more["T"], "V": stored - fallen + more["V"], "Phi": lost + more["Phi"]}


def _work(law, end, bends=()):
    """∫ law from 0 to the end, by Gauss' rule between the places where it bends."""
    stops = sorted({0.0, end, *(x for x in bends if 0 < x / end < 1)} if end else ())
    total = sum((b - a) / 2 * sum(w * law((a + b + x * (b - a)) / 2) for x, w in zip(NODES, WEIGHTS, strict=True))
                for a, b in pairwise(stops))
    return total if end > 0 else -total


def in_state(figure, state, t=None, guess=None):
    """{signal: value}; without `t` the loads of the time do not act."""
    parts = figure.parts([*state.q, *state.u], guess)
    rates, found = np.array([*state.v, *state.u1]), {}

    def keep(name, jet, before=0):
        found[name] = jets.plain(jet) - before
        found[name + "'"] = jet.g @ rates if isinstance(jet, jets.Jet) else 0.0

    for name in figure.coordinates:
        keep(name, parts.known[name])
    _places(figure, parts.bodies, keep)
    for name, jet in {**parts.springs, **parts.dampers}.items():
        keep(f"{name}.stretch", jet)
        rate = found[f"{name}.stretch'"]
        if name in figure.damper_laws:
            found[f"{name}.force"] = figure.damper_laws[name](rate) + figure.held.get(name, 0.0)
        else:
            found[f"{name}.force"] = figure.tension(name, jets.plain(jet))
    if not figure.scene.get("constraints"):
        found |= _supports(figure, state, t)
    return found


def _places(figure, bodies, keep):
    for name, body in figure.bodies.items():
        if not body.lumped:
            for axis, now, drawn in zip("xy", bodies[name](body.centre), body.centre, strict=True):
                keep(f"{name}.{axis}", now, drawn)
            keep(f"{name}.angle", bodies[name].angle)
        elif "turn" in figure.scene["bodies"][name]:
            keep(f"{name}.angle", bodies.change(figure.scene["bodies"][name]["turn"]))
    for name in figure.points:
        for axis, now, drawn in zip("xy", bodies.place(name), figure.drawn(name), strict=True):
            keep(f"{name}.{axis}", now, drawn)


def _supports(figure, state, t):
    """Forces of supports, which give way along x, y and a turn, and of drives, which do along what they prescribe."""
    bodies = [name for name, body in figure.bodies.items()
              if not body.lumped and {"pin", "slide", "roll"} & set(figure.scene["bodies"][name])]
    n, drives, held = len(state.q), len(figure.drives), [0.0] * (3 * len(bodies))
    figure.gives = {name: drives + 3 * i for i, name in enumerate(bodies)}
    state = state._replace(u=[*state.u, *held], u1=[*state.u1, *held], u2=[*state.u2, *held])
    left = residual(figure, state, t, rows=n + drives + len(held))
    figure.gives = {}
    found = {f"{name}.reaction.{part}": left[n + drives + 3 * i + j] for i, name in enumerate(bodies)
             for j, part in enumerate(("x", "y", "moment"))}
    driven = [figure.driver(name) for name in figure.scene.get("bodies", {})]
    for name, drive in zip(figure.scene.get("bodies", {}), driven, strict=True):
        if drive is not None and driven.count(drive) == 1:
            found[f"{name}.drive"] = left[n + drive]
    return found


def of_small(figure, small, q, v, t):
    """The same of small motions, linear in what changes; energies are those of the state."""
    base = at_rest(figure, small.q)
    u, u1, u2 = figure.driven(t)
    away = np.array(q) - small.q
    a = np.linalg.solve(small.M, load_of_time(figure, small, t) - small.C @ v - small.K @ away)
    change = State(away, v, a, *(np.subtract(now, before) for now, before in zip((u, u1, u2), base[3:], strict=True)))
    moved = State(*([x + 1j * STEP * d for x, d in zip(one, other, strict=True)]
                    for one, other in zip(base, change, strict=True)))
    rest, slope, loaded = in_state(figure, base), in_state(figure, moved), in_state(figure, base, t)
    found = {name: loaded[name] + np.imag(slope[name]) / STEP for name in rest}
    return {**found, **energies(figure, State(list(q), list(v), [], u, u1, u2)), **_products(figure, found)}


def of_full(figure, q, v, t):
    """The same of the full equations."""
    u, u1, u2 = figure.driven(t)
    state = State(list(q), list(v), list(accelerations(figure, t, q, v)), u, u1, u2)
    found = in_state(figure, state, t)
    return {**found, **energies(figure, state), **_products(figure, found)}


def _products(figure, found):
    """Energies of springs and powers of dampers."""
    products = {f"{name}.power": found[f"{name}.force"] * found[f"{name}.stretch'"] for name in figure.damper_laws}
    for name, words_ in figure.scene.get("springs", {}).items():
        if not {"law", "gap", "acts"} & set(words_):
            k = figure.number(words_.get("k", words_.get("torsion")))
            products[f"{name}.energy"] = found[f"{name}.force"] ** 2 / (2 * k)
    return products


def unit(figure, signal):
    """The unit of a signal."""
    bare = signal.rstrip("'")
    rate = "/s" * (len(signal) - len(bare))
    name, _, part = bare.partition(".")
    if part == "":
        return {"T": "J", "V": "J", "Phi": "W"}.get(bare) or ("m" if bare.startswith("x") else "rad") + rate
    words_ = {**figure.scene.get("springs", {}), **figure.scene.get("dampers", {})}.get(name, {})
    turns = "torsion" in words_
    if part == "drive":
        return "N*m" if {"pin", "turn"} & set(figure.scene["bodies"][name]) else "N"
    return {"x": "m", "y": "m", "angle": "rad", "stretch": "rad" if turns else "m", "force": "N*m" if turns else "N",
            "energy": "J", "power": "W", "reaction.x": "N", "reaction.y": "N", "reaction.moment": "N*m"}[part] + rate
