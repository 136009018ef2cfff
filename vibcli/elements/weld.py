"""A body fixed rigidly to another one."""

from typing import TYPE_CHECKING

from vibcli.language.kinds import BODY

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Reference
    from vibcli.scene.builder import Builder

ELEMENT = BODY
ABOUT = "The body is carried rigidly by another one: `weld: rod`."


def build(weld: "Reference", body: "Body", scene: "Builder") -> "Body":
    """The body with the frame of the one that carries it."""
    return body._replace(frame=scene.frame(weld))
