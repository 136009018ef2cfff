"""Forces in ropes, links, pins, guides and contacts, by multipliers.

Every constraint G_k = 0 of the scene with all its coordinates has a multiplier λ_k; every support of a body is released
by displacements ρ (x, y and a rotation about its reference point) that are held at zero. With the work of what acts

    E_q + Σ λ_k ∂G_k/∂q = 0          R_ρ = E_ρ + Σ λ_k ∂G_k/∂ρ,          E = d/dt ∂T/∂q̇ − ∂T/∂q + ∂Φ/∂q̇ + ∂V/∂q − Q.

R is the force (moment) that the support exerts on the body, in the fixed axes, its moment about the pin or the mass
centre, of what rolls about the centre of its circle; λ is a tension for ropes and links, positive in lengthening.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.linearisation import residual_terms
from vibcli.mechanics.linearise import linearise
from vibcli.mechanics.static_preload import take_over
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.running_errors import UNIT, error_in, number_in

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

OPEN = 1e-9
ROUNDINGS = 4           # of a term, preloads that statics gives among them
LENGTHENING = ("rope", "link", "gear", "belt", "equation")


class Reaction(NamedTuple):
    """`signal`: its name, such as rod.reaction.x or hoist.force; value: N or N·m, None where statics leaves it open."""

    signal: str
    value: float
    form: str


class Released:
    """The scene with all its coordinates and its supports released, and the numbers of its coordinates in `q`."""

    def __init__(self, numeric: "NumericSystem") -> None:
        self.numeric, self.scene = numeric, numeric.scene.with_released_supports()
        if self.scene.static_preloads and numeric.has_free_symbols:
            self.scene = take_over(self.scene, numeric.system.preloads)
        elif self.scene.static_preloads:
            tensions = {node: numeric.system.preloads[record.name] for node, record in self.scene.static_preloads}
            values = evaluate(list(tensions.values()), Floats, numeric.floats)
            self.scene = self.scene.with_preloads({node: self.scene.table.number(Fraction(value))
                                                   for node, value in zip(tensions, values, strict=True)})
        count = len(self.scene.q) - len(self.scene.released)
        self.held, self.real = self.scene.q[count:], self.scene.q[:count]
        self.units = self.scene.units_of([q.name for q in self.real])


def constraint_slopes(scene: "Scene") -> "list[Node]":
    """[∂G_k/∂q] of one constraint after the other, over all coordinates."""
    return [gradient(constraint.node).get(q, scene.table.zero) for constraint in scene.constraints for q in scene.q]


def reactions(configuration: "Configuration") -> list[Reaction]:
    """The Reactions in equilibrium: constraints first, then the supports of the bodies."""
    import numpy as np

    released = Released(configuration.numeric)
    scene, n = released.scene.resting, len(released.real)
    values = _at_rest(configuration, released)
    terms = residual_terms(linearise(scene, still=True))
    nodes = [scene.table.total(row) for row in terms]
    sizes = evaluate([term for row in terms for term in row], Floats, values)
    flat = evaluate([*nodes, *constraint_slopes(scene)], Floats, values)
    E = np.array(flat[:len(nodes)])
    G = np.array(flat[len(nodes):]).reshape(len(scene.constraints), len(nodes))
    multipliers, loose = solved(G[:, :n], E[:n], released.units)
    held = E[n:] + multipliers @ G[:, n:]
    left_open = np.abs(loose @ G[:, n:]).max(axis=0, initial=0.0) > OPEN
    found = []
    size = float(max(np.abs(held).max(initial=0.0), np.abs(sizes).max(initial=0.0)))
    for k, constraint in enumerate(scene.constraints):
        sign = 1.0 if constraint.form in LENGTHENING else -1.0
        unknown = np.abs(loose[:, k]).max(initial=0.0) > OPEN
        value = 0.0 if constraint.form == "contact" and abs(multipliers[k]) <= 1e-13 * size else float(multipliers[k])
        found.append(Reaction(constraint.signal, None if unknown else sign * value + 0.0, constraint.form))
    for symbol, force, unknown in zip(released.held, held, left_open, strict=True):
        value = 0.0 if abs(force) <= 1e-13 * size else float(force)
        found.append(Reaction(symbol.name, None if unknown else value, "support"))
    return found


def _at_rest(configuration: "Configuration", released: Released) -> dict[str, float]:
    """{symbol: float} of the released scene in equilibrium."""
    scene = configuration.scene.resting
    names = [q.name for q in released.real]
    values = dict(zip(names, evaluate([scene.symbol(name) for name in names], Floats, configuration.at_rest),
                      strict=True))
    return {**configuration.numeric.floats, **values, **dict.fromkeys((q.name for q in released.held), 0.0),
            released.scene.time.name: 0.0}


def left_inverse(G: "np.ndarray", units: Sequence[float]) -> "tuple[np.ndarray, np.ndarray]":
    """(Y of λ = −Y E, which solves Gᵀλ = −E, by least squares in the units of the coordinates; a basis of what Gᵀλ = 0
    leaves open, as rows)."""
    inverse, loose = _left_inverses(G[None], units)
    return inverse[0], loose[0][loose[0].any(axis=1)]


def _left_inverses(G: "np.ndarray", units: Sequence[float]) -> "tuple[np.ndarray, np.ndarray]":
    """The same of a stack (N, k, n): (N, k, n), and (N, k, k) with rows of zeros."""
    import numpy as np

    ties, kept = G.shape[1], min(G.shape[1:])
    if not kept:
        return np.zeros(G.shape), np.broadcast_to(np.eye(ties), (len(G), ties, ties))
    found = G * units
    scale = np.abs(found).max(axis=2)
    scale[scale == 0.0] = 1.0       # of what ties supports alone
    u, s, vt = np.linalg.svd((found / scale[:, :, None]).swapaxes(1, 2), full_matrices=True)
    fixed = s > OPEN * s[:, :1]
    inverse = vt[:, :kept].swapaxes(1, 2) / np.where(fixed, s, np.inf)[:, None] @ u[:, :, :kept].swapaxes(1, 2)
    rest = np.arange(ties) >= fixed.sum(axis=1)[:, None]
    return inverse / scale[:, :, None] * units, vt * rest[:, :, None] / scale[:, None]


def solved(G: "np.ndarray", E: "np.ndarray", units: Sequence[float]) -> "tuple[np.ndarray, np.ndarray]":
    """λ of Gᵀλ = −E, and a basis of what Gᵀλ = 0 leaves open, as rows."""
    multipliers, loose = solved_each(G[None], E[None], units)
    return multipliers[0], loose[0][loose[0].any(axis=1)]


def solved_each(G: "np.ndarray", E: "np.ndarray", units: Sequence[float]) -> "tuple[np.ndarray, np.ndarray]":
    """The same of stacks (N, k, n) and (N, n), among rows of zeros: (N, k), (N, k, k)."""
    inverse, loose = _left_inverses(G, units)
    multipliers, E = inverse @ -E[:, :, None], E[:, :, None]
    left = E + G.swapaxes(1, 2) @ multipliers       # hundreds of roundings
    return (multipliers - inverse @ left)[:, :, 0], loose


def reaction_errors(configuration: "Configuration") -> dict[str, float]:
    """{signal: what a Reaction is off by at most}, to first order: the errors of E and G and what is left of the
    balance, through the pseudoinverse of G."""
    import numpy as np

    released = Released(configuration.numeric)
    scene, n, (arithmetic, rest) = released.scene.resting, len(released.real), configuration.bounded_rest
    names, at_rest = [q.name for q in released.real], configuration.scene.resting
    values = {**rest, **dict(zip(names, evaluate([at_rest.symbol(name) for name in names], arithmetic, rest),
                                 strict=True)), **dict.fromkeys((q.name for q in released.held), 0.0)}
    terms = residual_terms(linearise(scene, still=True))
    flat = evaluate([*map(scene.table.total, terms), *constraint_slopes(scene)], arithmetic, values)
    sums = [evaluate(row, Floats, {name: number_in(x) for name, x in values.items()}) for row in terms]
    shape = len(scene.constraints), len(terms)
    E, G = (np.array([number_in(x) for x in part], float) for part in (flat[:len(terms)], flat[len(terms):]))
    off, leaning = (np.array([error_in(x) for x in part], float) for part in (flat[:len(terms)], flat[len(terms):]))
    G, leaning = G.reshape(shape), leaning.reshape(shape)
    inverse = left_inverse(G[:, :n], released.units)[0]
    multipliers = solved(G[:, :n], E[:n], released.units)[0]
    size = np.array([sum(map(abs, row)) for row in sums]) + abs(multipliers) @ abs(G)
    off += abs(multipliers) @ leaning + ROUNDINGS * UNIT * (len(G) + 1) * size
    off[:n] += abs(E + multipliers @ G)[:n]
    far = abs(inverse) @ off[:n]
    held = off[n:] + far @ abs(G[:, n:])
    return dict(zip([*(constraint.signal for constraint in scene.constraints), *(q.name for q in released.held)],
                    map(float, (*far, *held)), strict=True))


def slack(reactions: Sequence[Reaction]) -> list[Any]:
    """[(rope's signal, tension)] of ropes that equilibrium would have to push."""
    forces = [reaction for reaction in reactions if reaction.form == "rope" and reaction.value is not None]
    largest = max((abs(reaction.value) for reaction in reactions if reaction.value is not None), default=0.0)
    return [(reaction.signal, reaction.value) for reaction in forces if reaction.value < -1e-9 * largest]
