"""A body fixed rigidly to another one."""

from vibcli.language.kinds import BODY

ELEMENT = BODY
ABOUT = "The body is carried rigidly by another one: `weld: rod`."


def build(weld, body, scene):
    """The body with the frame of the one that carries it."""
    return body._replace(frame=scene.frame(weld))
