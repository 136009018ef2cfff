"""Motions with dry friction: smooth between events, each contact slipping one way or held; which of them is searched.

Of a held contact the force is what keeps it from moving: M q'' + h + Σ f ∂s/∂q = 0 with the rate of s' zero.
"""

from itertools import pairwise, product

import numpy as np
from scipy.integrate import solve_ivp

from . import jets
from .mechanics import State, mass, residual
from .motion import BEFORE, breaks, struck

STILL = 1e-9


class Contacts:
    """The dry frictions of a figure."""

    def __init__(self, figure):
        self.figure, self.guess = figure, dict(figure.drawn_values)
        self.names = list(figure.frictions)

    def _known(self, t, y):
        """(state, parts, rates of the contacts) at an instant."""
        n = len(self.figure.independent)
        u, u1, u2 = self.figure.driven(t)
        state = State(list(y[:n]), list(y[n:]), [0.0] * n, u, u1, u2)
        parts = self.figure.parts([*state.q, *u], self.guess)
        self.guess.update({name: jets.plain(parts.known[name]) for name in self.figure.coordinates})
        rates = np.array([*state.v, *u1])
        return state, parts, [parts.dampers[name].g @ rates for name in self.names]

    def rates(self, t, y):
        return self._known(t, y)[2]

    def found(self, t, y, senses):
        """(q'', {contact: force}, {contact: s''}); sense 0 is held, ±1 slips."""
        state, parts, _ = self._known(t, y)
        n, rates = len(state.q), np.array([*state.v, *state.u1])
        self.figure.held = {name: sense * self.figure.frictions[name][0]
                            for name, sense in zip(self.names, senses, strict=True)}
        left = residual(self.figure, state, t, parts=parts)
        ways = [parts.dampers[name] for name in self.names]
        drift = [jet.g[n:] @ np.array(state.u2) + rates @ (jet.h @ rates) for jet in ways]
        held = [i for i, sense in enumerate(senses) if sense == 0]
        W = np.array([ways[i].g[:n] for i in held]).reshape(len(held), n)
        solved = np.linalg.solve(np.block([[mass(self.figure, parts, n), W.T], [W, np.zeros((len(held),) * 2)]]),
                                 np.concatenate([-left, [-drift[i] for i in held]]))
        self.figure.held.update({self.names[i]: force for i, force in zip(held, solved[n:], strict=True)})
        return solved[:n], dict(self.figure.held), [jet.g[:n] @ solved[:n] + d
                                                    for jet, d in zip(ways, drift, strict=True)]

    def senses(self, t, y, resting=None):
        """What each contact does from here on: one at rest is held if that takes no more than it can bear."""
        rates = [0.0 if i == resting else rate for i, rate in enumerate(self.rates(t, y))]
        ways = [(0, 1, -1) if abs(rate) <= STILL else (int(np.sign(rate)),) for rate in rates]
        for senses in product(*ways):
            try:
                _, forces, second = self.found(t, y, senses)
            except np.linalg.LinAlgError:
                continue
            if all(abs(forces[name]) <= self.figure.frictions[name][1] * (1 + 1e-12) if sense == 0 else
                   abs(rate) > STILL or sense * change > 0 for name, sense, rate, change in zip(
                       self.names, senses, rates, second, strict=True)):
                return senses
        raise ArithmeticError("no way to slip or to hold fits")


def slipping(figure, state):
    """{contact: force} where each slips as the rates of a state say."""
    parts, rates = figure.parts([*state.q, *state.u]), np.array([*state.v, *state.u1])
    return {name: size * np.sign(parts.dampers[name].g @ rates) for name, (size, _) in figure.frictions.items()}


def full_motion(figure, start, times):
    """(q, q') at ascending times; the forces of the contacts at the last of them are left in `figure.held`."""
    contacts, y, found = Contacts(figure), np.array(start, dtype=float), []
    n = len(figure.independent)
    for begin, end in pairwise(sorted({*breaks(figure, times[-1]), *times})):
        y = _between(contacts, y, begin, end)
        y = y + struck(figure, y, end)
        if end in times:
            found.append((y[:n].copy(), y[n:].copy()))
    contacts.found(times[-1], y, contacts.senses(times[-1], y))
    return found


def _between(contacts, y, t, end):
    """From one break of the loads to the next, event by event."""
    n = len(y) // 2
    senses = contacts.senses(t, y)
    for _ in range(200):
        def rates(t, y, senses=senses):
            return np.concatenate([y[n:], contacts.found(t, y, senses)[0]])

        solved = solve_ivp(rates, (t, end - BEFORE), y, "DOP853", rtol=1e-9, atol=1e-12, max_step=0.04,
                           events=[_event(contacts, senses, i, side) for i in range(len(senses)) for side in (1, -1)])
        t, y = solved.t[-1], solved.y[:, -1]
        if solved.status == 0:
            return y
        hit = next(k for k, at in enumerate(solved.t_events) if len(at))
        senses = _after(contacts, t, y, senses, hit // 2, 1 - 2 * (hit % 2))
    raise ArithmeticError("it sticks and slips without end")


def _event(contacts, senses, i, side):
    """Zero where a contact that slips comes to rest, or one that is held bears no more in one sense."""
    name, n = contacts.names[i], len(contacts.figure.independent)
    limit = contacts.figure.frictions[name][1]

    def event(t, y):
        if senses[i]:
            return senses[i] * contacts.rates(t, y)[i] if side == 1 else 1.0
        return limit - side * contacts.found(t, y[:2 * n], senses)[1][name]

    event.terminal, event.direction = True, -1
    return event


def _after(contacts, t, y, senses, i, side):
    """The senses after the event of a contact: let go in the sense of its force, or searched."""
    if senses[i] == 0:
        return tuple(side if k == i else sense for k, sense in enumerate(senses))
    return contacts.senses(t, y, i)
