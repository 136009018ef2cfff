"""A starting place for the search of the equilibrium, where several exist."""

from vibcli.fields import Kind, Named, Quantity


class _Start(Kind):
    wants = "a mapping from coordinates to values"

    def __init__(self):
        self.named = Named(Quantity(), self.wants)

    def read(self, node, reader):
        return self.named.read(node, reader)

    def schema(self):
        return self.named.schema()


KIND = _Start()
ABOUT = "Where the search for the equilibrium starts, `{x: 1 m}`; coordinates that are left out start as drawn."
