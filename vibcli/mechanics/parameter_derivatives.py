"""Element data at the equilibrium with their exact derivative by one parameter p, the shift of equilibrium included.

    r(q₀(p), p) = 0   gives   K dq₀/dp = −∂r/∂p,   and   d/dp A(q₀, p) = ∂A/∂p + Σ ∂A/∂qᵢ · dq₀ᵢ/dp

Both are found by evaluating the linearised form in dual numbers. Along what moves freely (K φ = 0) the equilibrium
stays where the drawing puts it.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.high_precision import place_to
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.dual_numbers import Dual, Duals, dual, slope, value
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.numeric_linearisation import Numbers
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LOST = 1e-20    # of the terms of a force: what counts as none, at the working precision of 60 digits


def perturbed_system(configuration: "Configuration", name: str, free: Any) -> "FactoredSystem":
    """FactoredSystem in dual numbers at the working precision of mpmath, the slopes being d/d`name`.

    `free`: the shapes of the rigid-body modes. PhysicsError where the equilibrium does not persist as p changes, or
    a tension is found with it.
    """
    settled = configuration.system.settled
    if settled is not None and settled.names:
        raise PhysicsError(f"the tension of '{settled.names[0]}', which statics alone leaves open, changes with "
                           f"'{name}': its rate is not found", "solve the scene with two values of it")
    scene, form, plain = configuration.scene, configuration.system.linearisation, multiprecision()
    arithmetic, known = Duals(plain), configuration.numeric.values(plain)
    given = {other: plain.number(x) for other, x in configuration.numeric.given.items()} | {name: Dual(known[name], 1)}
    values = scene.parameters.values(arithmetic, given)
    at = place_to(configuration, known, plain)
    if configuration.system.is_linear:
        return in_numbers(form, arithmetic, values | at).elements
    slopes = [slope(x) for x in evaluate(_start(configuration.system), arithmetic, values)]
    numbers = in_numbers(form, arithmetic, _moved(scene, arithmetic, values | at, slopes))
    shift = _shift(numbers, free, name)
    if shift is None:
        return numbers.elements
    slopes = [x + step for x, step in zip(slopes, shift, strict=True)]
    return in_numbers(form, arithmetic, _moved(scene, arithmetic, values | at, slopes)).elements


def _moved(scene: "Scene", arithmetic: Any, values: "dict[str, Dual | mpmath.mpf]",
           slopes: "Sequence[int | mpmath.mpf]") -> "dict[str, Dual | mpmath.mpf]":
    """The values with coordinates that change at these rates, and the dependent ones with those that keep their loops
    closed: G_z dz = −dG."""
    import mpmath

    values = values | {q: dual(values[q], x) for q, x in zip(scene.coordinates, slopes, strict=True)}
    loops = scene.resting.loops
    if loops is not None:
        values |= {scene.time.name: mpmath.mpf(0)}
        n = len(loops.names)
        found = evaluate([*loops.conditions, *loops.slopes], arithmetic, values)
        G = mpmath.matrix([[value(x) for x in found[n + i * n:n + (i + 1) * n]] for i in range(n)])
        steps = mpmath.lu_solve(G, mpmath.matrix([-slope(x) for x in found[:n]]))
        values |= {z: dual(values[z], step) for z, step in zip(loops.names, steps, strict=True)}
    return values


def _start(system: "MechanicalSystem") -> "list[Node]":
    """Where the search for the equilibrium starts: the drawn position, and what `equilibrium` says, as expressions."""
    scene, told = system.scene, system.spec.get("equilibrium") or {}
    return [scene.lower(told[name]) if name in told else node for name, node in scene.drawn_coordinates.items()]


def _shift(numbers: "Numbers", free: "Sequence[Sequence[mpmath.mpf]]", name: str) -> "list[mpmath.mpf] | None":
    """dq₀/dp beyond that of the starting place, orthogonal to the free motions; None where it is zero."""
    import mpmath

    force = [slope(r) for r in numbers.residual]
    size = [slope(x) for x in numbers.residual_size]
    if not any(abs(f) > LOST * s for f, s in zip(force, size, strict=True)):
        return None
    for shape in free:
        work = sum(f * x for f, x in zip(force, shape, strict=True))
        if abs(work) > LOST * sum(s * abs(x) for s, x in zip(size, shape, strict=True)):
            raise PhysicsError(f"the equilibrium does not persist when '{name}' changes: nothing holds it there")
    n = len(force)
    K = mpmath.zeros(n + len(free))
    for pair, entry in numbers.elements.stiffness().items():
        K[pair] = value(entry)
    for j, shape in enumerate(free, n):
        for i, x in enumerate(shape):
            K[i, j] = K[j, i] = x
    return list(mpmath.lu_solve(K, mpmath.matrix([-f for f in force] + [0] * len(free))))[:n]
