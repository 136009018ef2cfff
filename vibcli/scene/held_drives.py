"""The scene at rest: what is driven to and fro is held as drawn, and what turns or travels on does so.

Its coordinates, parameters and the time are those of the scene itself; its equilibrium is the equilibrium about which
the driven scene vibrates.
"""

from copy import copy

OWN = ("bodies", "points", "energies", "matrices", "drawn", "_drawn_at_rest", "_symbols")


def held_still(scene):
    """The scene at rest of one that is assembled, its driven displacements still symbols, and not closed yet."""
    still, frames = copy(scene), {}
    for name in OWN:
        setattr(still, name, dict(getattr(scene, name)))
    still.bodies = {name: _apart(body, frames) for name, body in scene.bodies.items()}
    still.laws, still.constraints = list(scene.laws), list(scene.constraints)
    still.resting, still.at_rest, still.driven, still.shaken = still, True, {}, {}
    zero = scene.table.zero
    still.replace({symbol: zero if scene.oscillates(symbol) else node for symbol, node in scene.driven.items()})
    return still


def _apart(body, frames):
    """A copy of a body; bodies that share a frame share its copy."""
    found = copy(body)
    if body.frame is not None:
        found.frame = frames.setdefault(id(body.frame), copy(body.frame))
    return found
