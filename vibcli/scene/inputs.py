"""Loads as inputs: a unit load beside each that is given, and one along each coordinate, as further coordinates."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from vibcli.scene.displacements import Opening
from vibcli.scene.energy_terms import AppliedLoad

if TYPE_CHECKING:
    from vibcli.scene.contents import Contents
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def with_input_loads(scene: "Scene", add: "Callable[..., Node]") -> "Contents":
    """The contents with loads F δs of inputs F; `add(name, load=, spread=)` gives the symbol of one."""
    beside = [(term.owner, term.s, k) for k, term in enumerate(scene.forces)]
    along = [(name, scene.symbol(name), None) for name in scene.spec.coordinates]
    loads = [AppliedLoad(add(name, load=k), s, owner=name) for name, s, k in (*beside, *along)]
    spread = [force._replace(weight=add(force.owner, spread=k)) for k, force in enumerate(scene.spread_forces)]
    return scene.contents._replace(forces=[*scene.forces, *loads], spread_forces=[*scene.spread_forces, *spread])


def with_loads_alone(scene: "Scene") -> "Scene | None":
    """A scene with its inputs, its expressions being those that they are; None where these are more than loads on what
    moves: of displacements that come and go, of constraints, and of loads on what stays."""
    if scene.oscillating or scene.constraints or scene.idle:
        return None
    coordinates, inputs = scene.kinematics.copied(), dict(scene.inputs)

    def add(name: str, load: int | None = None, spread: int | None = None) -> "Node":
        symbol = coordinates.further(f"input {len(inputs) + 1}")
        inputs[symbol] = Opening(name, None, load, spread)
        return symbol

    setting = scene.setting._replace(variant=scene.setting.variant._replace(inputs=True))
    return scene.with_parts(setting=setting, contents=with_input_loads(scene, add), coordinates=coordinates,
                            drives=scene.drives._replace(inputs=inputs))
