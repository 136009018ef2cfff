"""Why a search ends at no equilibrium, in words."""

from typing import TYPE_CHECKING

from vibcli.base.errors import Kinked, NoEquilibrium, PhysicsError

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.equilibrium.energy_descent import EnergyDescent

ALONE = ", or ask for what needs none: find: [accelerations]"
SET_IN = ", or let the load set in at t = 0, as F*step(t) does"
FAR, BESIDE = 1e6, 1e-6      # of the size of the figure
TOLD = 1e-9                  # of the largest eigenvalue: one below zero that is not that of rounding
JUMPS = ("abs", "sign", "min", "max", "step", "ramp")


class Undefined(PhysicsError):
    """Forces or stiffnesses are not finite at a place."""


def unbounded(search: "EnergyDescent", q: "np.ndarray") -> PhysicsError:
    """Nothing holds the coordinate that went farthest, or the way ends there."""
    np = search.np
    start = search.vector(search.numeric.drawn_floats)
    name = search.names[int(np.argmax(np.abs(q - start) / search.scale))]
    if search.blocked:
        place = ", ".join(f"{other} = {value:.6g}" for other, value in search.named_plainly(q).items())
        return PhysicsError(f"the search for the equilibrium reaches a dead centre of the linkage near {place}: "
                            f"there '{name}' cannot go on", "list another coordinate first under `coordinates:`, "
                            "or draw the scene nearer to its equilibrium")
    if search.scene.table.called.intersection(JUMPS) and np.all(np.abs(q) <= FAR * search.scale):
        here = ", ".join(f"{other} = {value:.6g}" for other, value in search.named_plainly(q).items())
        if _is_held(search, q):
            return Kinked(f"the scene rests near {here}, where a force jumps: it is driven back there from both sides, "
                          "and no small oscillations are about it", "follow the motion with motion: full")
        return PhysicsError(f"the search for the equilibrium ends near {here} and finds none: where forces "
                            "jump, bend or have an infinite slope its steps may not settle",
                            "start nearer to it with `equilibrium:`, or follow the motion with motion: full")
    if search.undefined:
        ending = search.scene.endings(search.numeric.floats)
        if ending:
            return NoEquilibrium(f"no equilibrium is reached from the {_origin(search)}: its forces drive '{name}' to "
                                 f"{search.named_plainly(q)[name]:.6g}, and just beyond they are not known: there "
                                 f"{ending.what}", ending.hint + ALONE,
                                 search.numeric.spec.origin(name).where)
        return NoEquilibrium(f"no equilibrium is reached from the {_origin(search)}: its forces drive '{name}' to "
                             f"{search.named_plainly(q)[name]:.6g}, and just beyond they are not finite numbers",
                             "add the spring or support that carries the load, or start elsewhere with "
                             "`equilibrium:`" + ALONE, search.numeric.spec.origin(name).where)
    why = "the potential energy keeps falling" if search.numeric.system.conservative else "forces keep driving"
    spec = search.numeric.spec
    later = SET_IN if spec.members and spec.get("forces") and not spec.get("gravity") else ""
    return NoEquilibrium(
        f"no equilibrium is reached from the {_origin(search)}: nothing holds '{name}', {why} along it",
        "add the spring or support that carries the load, or start elsewhere with `equilibrium:`" + later + ALONE,
        spec.origin(name).where)


def repelled(search: "EnergyDescent", refusal: PhysicsError) -> PhysicsError:
    """Why linear forces that balance at one place lead nowhere, where they lead away from it; the refusal of others."""
    from vibcli.mechanics.equilibrium.rest_in_digits import rest_in_digits

    place = rest_in_digits(search.numeric, held=False)
    if place is None or rest_in_digits(search.numeric) is not None:
        return refusal
    found = search.np.linalg.eigvals(search.hessian(search.at(search.vector(place))))
    if not found.real.min() < -TOLD * search.np.abs(found).max():
        return refusal
    there = ", ".join(f"{name} = {x:.6g}" for name, x in place.items())
    return NoEquilibrium(
        f"no equilibrium is reached from the {_origin(search)}: forces lead away from the only one that there is",
        f"it is {there}: name a place near it under `equilibrium:`, or add the spring or support that holds it")


def _is_held(search: "EnergyDescent", q: "np.ndarray") -> bool:
    """Is one coordinate driven back to a place from both sides, by forces that have a potential?"""
    if len(q) != 1 or not search.numeric.system.conservative:
        return False
    sides = [search.defined(q + side * BESIDE * search.scale) for side in (-1, 1)]
    return None not in sides and sides[0].residual[0] < 0 < sides[1].residual[0]


def _origin(search: "EnergyDescent") -> str:
    return "place that `equilibrium:` names" if search.numeric.spec.get("equilibrium") else "drawn position"


def unfinished(search: "EnergyDescent", q: "np.ndarray", steps: float) -> PhysicsError:
    """Steps are out, though nothing has run off."""
    place = ", ".join(f"{name} = {value:.6g}" for name, value in search.named_plainly(q).items())
    if search.blocked or search.np.any(search.np.abs(q) > FAR * search.scale):
        return unbounded(search, q)
    return NoEquilibrium(
        f"no equilibrium is reached from the {_origin(search)} in {steps} steps: the search has come to {place}",
        "draw the scene nearer to its equilibrium, or say where it is with `equilibrium:`")
