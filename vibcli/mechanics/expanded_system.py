"""A mechanical system whose scene is that of another one with its equations expanded."""

from functools import cached_property
from typing import TYPE_CHECKING

from vibcli.mechanics.system import MechanicalSystem

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene


class ExpandedSystem(MechanicalSystem):
    """That of a MechanicalSystem with the Scene `expanded`."""

    settled = preloaded = None

    def __init__(self, system: MechanicalSystem, expanded: "Scene") -> None:
        super().__init__(system.spec, system.given, system.work, system.released, system.tensions)
        self._expanded, self.preloads = expanded, system.preloads

    @cached_property
    def scene(self) -> "Scene":
        return self._expanded
