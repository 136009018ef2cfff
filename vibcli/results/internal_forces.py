"""Forces and moments within members along each: of a mode, at an instant of the motion, amplitudes of what lasts."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import LEFT_OF
from vibcli.mechanics.internal_forces import InternalForce, forces_within
from vibcli.numerics.stretches import PARTS, CurveStretch
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

SAME, COARSE, A_HALF_WAVE = 1e-9, 24, 16      # of the length; parts of a stretch in time; of a half-wave of a mode
ORDERS = {("beam", "moment"): 2, ("beam", "shear"): 3, ("beam", "force"): 1, ("bar", "force"): 1,
          ("shaft", "moment"): 1}


def forces_of_mode(problem: "Problem", index: int, normalise: str = "first") -> list[InternalForce]:
    """Those of a mode, normalised as its shape is; those of strings do not change."""
    mode, = problem.modal.modes.numbered(index, index)
    mode = problem.modal.told_apart(mode)
    fields, factor = problem.modal.fields(mode), complex(problem.modal.scale(mode, normalise))
    found = []
    for name, member, part in forces_within(problem.scene):
        order = ORDERS.get((member.kind.name, part))
        if order is not None:
            pieces = fields.pieces(f"{name}.along" if member.stretching and part == "force" else name)
            found.append(InternalForce(name, part, [_moved(one, order, factor) for one in pieces]))
    return found


def _moved(moved, order, factor):
    piece = moved.piece
    stiffness = piece.bending or piece.tension
    waves = (max(-moved.kappa, 0.0) / stiffness) ** (1 / piece.order) * piece.length / np.pi
    return CurveStretch(moved.start, moved.start + piece.length,
                   lambda places: (stiffness * factor * moved.along(places)[:, order]).real,
                   max(PARTS, int(A_HALF_WAVE * waves)))


def forces_in_time(problem: "Problem", instant: float) -> tuple[list[InternalForce], list[str]]:
    """(those at an instant of the motion, why others are not found)."""
    at = np.array([instant])

    def signal(name):
        return problem.response.signal(NameRef(0, len(name), name, 0))

    return _of_signals(problem, lambda name: float(signal(name).values(at)[0]),
                       lambda name: signal(name).error(instant))


def amplitudes(problem: "Problem") -> tuple[list[InternalForce], list[str]]:
    """(amplitudes of the steady state, why others are not found)."""
    from vibcli.results import feature_errors, steady_features

    def signal(name):
        args = NameRef(0, len(name), name, 0),
        return problem.response.signal(QuantityRef(0, 0, f"steady({name})", "steady", args=args))

    return _of_signals(problem, lambda name: steady_features.amplitude(signal(name)),
                       lambda name: feature_errors.amplitude(signal(name)))


def _of_signals(problem, value, error):
    """Those whose values signals tell, each at a place."""
    scene, found, refused = problem.scene, [], []
    for name, member, part in forces_within(scene):
        length, stations = scene.number(member.length), [scene.number(one.place) for one in member.stations]
        stations = [0.0, *sorted(x for x in stations if SAME * length < x < (1 - SAME) * length), length]
        signal, seen = f"{name}.{part}", {}
        try:
            stretches = [_of_signal(signal, start, end, value, seen) for start, end in pairwise(stations)]
            force = InternalForce(name, part, stretches, lambda x, signal=signal: error(f"{signal}({x!r} m)"))
            force.largest       # noqa: B018 - refused where it is not found
            found.append(force)
        except PhysicsError as refusal:
            refused.append((f"{part} of {name}", refusal))
    if not found and refused:
        raise refused[0][1]
    return found, [f"the {what} is not found: {refusal.message}" for what, refusal in refused]


def _of_signal(signal, start, end, value, seen):
    """The CurveStretch of a signal; `seen` {name: value} are those that are known."""
    def values(places):
        names = [f"{signal}({x!r} m{LEFT_OF * (x >= end)})" for x in places.tolist()]
        for name in names:
            if name not in seen:
                seen[name] = value(name)
        return np.array([seen[name] for name in names])

    return CurveStretch(start, end, values, COARSE)


def require_numbers(problem: "Problem") -> None:
    """PhysicsError where there are no members, or symbols without value."""
    if not problem.scene.members:
        raise PhysicsError("this scene has no members: no diagram of forces within them can be drawn",
                           "`vibcli draw FILE` draws the scene")
    if problem.numeric.has_free_symbols:
        raise PhysicsError("diagrams need numbers, and this scene has symbols without value", "give them with --set")
