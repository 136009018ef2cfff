"""What a scene writes out: the terms of `energies`, T and Φ of constant coefficients, and the entries of `matrices`."""

import numpy as np

from . import jets, words

KINDS = (("M", "T", 1), ("C", "Phi", 1), ("K", None, 0))


def read(figure):
    """(the tree of V or None, {key: matrix})."""
    energies, given, n = figure.scene.get("energies", {}), {}, len(figure.coordinates)
    rows = {key: [[figure.number(entry) for entry in row] for row in matrix]
            for key, matrix in figure.scene.get("matrices", {}).items()}
    for key, energy, primes in KINDS:
        if energy in energies:
            given[key] = _hessian(figure, figure.tree(energies[energy]), "__1" * primes)
        if key in rows:
            given[key] = given.get(key, np.zeros((n, n))) + np.array(rows[key])
    return figure.tree(energies["V"]) if "V" in energies else None, given


def _hessian(figure, tree, mark):
    """The second derivatives of a quadratic form."""
    names = [name + mark for name in figure.coordinates]
    at = dict(zip(names, jets.variables([figure.literal(0, 1, 0)] * len(names)), strict=True))
    return words.value(tree, {**figure.parameters, **at}, figure.literal, figure.functions).h


def potential(figure, known):
    """V as written."""
    return words.value(figure.written_V, {**figure.parameters, **known}, figure.literal, figure.functions)


def forces(figure, state, known, n, damped):
    """What they add to the equations."""
    total = np.array([0 * value for value in [*state.v, *state.u1]])[:n]
    if figure.written_V is not None:
        total = total + potential(figure, known).g[:n]
    for key, values in (("M", state.a), ("C", state.v), ("K", state.q)):
        if key in figure.given and (damped or key != "C"):
            force = figure.given[key] @ np.array(values)
            total = total + np.concatenate([force, np.zeros(n - len(force), force.dtype)])
    return total


def energies(figure, state, known):
    """What they add to T, V and Φ, V counted from the drawn position."""
    values = {"M": state.v, "C": state.v, "K": state.q}
    found = {key: np.array(values[key]) @ figure.given[key] @ np.array(values[key]) / 2 if key in figure.given else 0
             for key in values}
    if figure.written_V is not None:
        found["K"] = found["K"] + jets.plain(potential(figure, known)) - potential(figure, figure.drawn_values)
    return {"T": found["M"], "V": found["K"], "Phi": found["C"]}
