"""The frame of a body: where it was drawn, where it is now, how far it has turned."""

from typing import NamedTuple


class Frame(NamedTuple):
    """A reference point drawn at `drawn`, now at `place`, and the rotation `angle`: all expressions."""

    drawn: tuple
    place: tuple
    angle: object

    @property
    def nodes(self):
        """The expressions of the coordinates that it is made of."""
        return [*self.place, self.angle]

    def over(self, new):
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(place=tuple(new[node] for node in self.place), angle=new[self.angle])

    def point(self, x, y):
        """Where the body's point drawn at (x, y) is now: place + R(angle)·(its offset as drawn)."""
        dx, dy = x - self.drawn[0], y - self.drawn[1]
        if self.angle.is_zero:
            return self.place[0] + dx, self.place[1] + dy
        dx, dy = self.turned(dx, dy)
        return self.place[0] + dx, self.place[1] + dy

    def turned(self, x, y):
        """R(angle)·(x, y): a direction that the body carries."""
        cos, sin = self.angle.table.call("cos", self.angle), self.angle.table.call("sin", self.angle)
        return x * cos - y * sin, x * sin + y * cos

    def seen(self, x, y):
        """Where the body, were it still as drawn, would have the place that is now (x, y): the inverse of `point`."""
        dx, dy = x - self.place[0], y - self.place[1]
        cos, sin = self.angle.table.call("cos", self.angle), self.angle.table.call("sin", self.angle)
        return self.drawn[0] + dx * cos + dy * sin, self.drawn[1] + dy * cos - dx * sin
