"""The frame of a body: where it was drawn, where it is now, how far it has turned."""


class Frame:
    """A reference point drawn at `drawn`, now at `place`, and the rotation `angle`: all expressions."""

    __slots__ = ("angle", "drawn", "place")

    def __init__(self, drawn, place, angle):
        self.drawn, self.place, self.angle = drawn, place, angle

    def point(self, x, y):
        """Where the body's point drawn at (x, y) is now: place + R(angle)·(its offset as drawn)."""
        dx, dy = x - self.drawn[0], y - self.drawn[1]
        if self.angle.is_zero:
            return self.place[0] + dx, self.place[1] + dy
        table = self.angle.table
        cos, sin = table.call("cos", self.angle), table.call("sin", self.angle)
        return self.place[0] + dx * cos - dy * sin, self.place[1] + dx * sin + dy * cos
