"""What springs and dampers join: places, bodies and the ground, and how far their ends are apart."""

TURNING = "torsion acts between two bodies, or a body and `ground`"


class Ends:
    """Turns the two ends of a spring or damper into its stretch."""

    __slots__ = ("bodies", "expressions", "geometry", "places", "report", "table")

    def __init__(self, places):
        self.places, self.bodies, self.geometry = places, places.bodies, places.geometry
        self.expressions, self.table, self.report = self.geometry.expressions, places.table, places.report

    def stretch(self, record, torsion):
        """The stretch of a spring or damper since the drawn position; None where it was reported as wrong."""
        if "stretch" in record:
            return self.moving(record, self.expressions.lower(record["stretch"]))
        if torsion:
            return self.moving(record, self._difference(record, [self._angle(end) for end in record["between"]]))
        lumped = [self._lumped(end) for end in record["between"]]
        if lumped == [0, 0] or any(part is not None and part != 0 for part in lumped):
            return self.moving(record, self._lumped_stretch(record, lumped))
        dx, dy = self.span(record)
        if dx is None:
            return None
        length = self.length(record, dx, dy)
        return None if length is None else self.moving(record, length - self.geometry.at_drawn(length)[0])

    def length(self, record, dx, dy):
        """The distance of two ends; None where they coincide as drawn, which is reported."""
        length = self.geometry.distance(dx, dy)
        if self.expressions.number(length) > 0:
            return length
        self.report(record.where, f"the ends of '{record.name}' coincide as drawn: its direction is not defined",
                    "draw them apart" + (", or give `free_length: 0`" if "k" in record else ""))
        return None

    def moving(self, record, stretch):
        """The stretch; None where it never changes, which is reported."""
        if stretch is not None and not stretch.mask:
            hint = "check its ends, or take it out"
            if any(isinstance(end, list) for end in record.get("between", ())):
                hint = "a place [x, y] is fixed; a point of a body is P: {body: name, at: [x, y]} under `points`"
            self.report(record.where, f"the stretch of '{record.name}' never changes", hint)
            return None
        return stretch

    def span(self, record):
        """(dx, dy) from the first end to the second; (None, None) where an end has no place."""
        places = [self._place_of(end, record) for end in record["between"]]
        if None in places:
            return None, None
        (ax, ay), (bx, by) = places
        return bx - ax, by - ay

    def _place_of(self, end, record):
        if isinstance(end, list):
            return self.expressions.pair(end)
        if end.text == "ground":
            self.report(end.where, f"'{record.name}' joins a place and bare ground", "say where on the ground: [x, y]")
            return None
        if end.text in self.bodies and self.bodies[end.text].frame is None:
            self.report(end.where, f"'{end.text}' is lumped: it has no place, so '{record.name}' has no free length",
                        "give `preload` instead, or say where the body is drawn with `at`")
            return None
        return self.places.place(end)[1]

    def _lumped(self, end):
        """(kind, motion) of a lumped body, 0 for the ground, None for what has a place."""
        if isinstance(end, list):
            return None
        if end.text == "ground":
            return 0
        return self.bodies[end.text].lumped if end.text in self.bodies else None

    def _lumped_stretch(self, record, lumped):
        motions = []
        for end, part in zip(record["between"], lumped, strict=True):
            if part is None:
                where = end[0].where if isinstance(end, list) else end.where
                self.report(where, f"'{record.name}' joins a lumped body and a place",
                            "lumped bodies are joined with each other or with `ground`")
                return None
            if part and part[0] == "turn":
                self.report(end.where, f"'{end.text}' turns: '{record.name}' must be a torsion element",
                            "write `torsion:` instead")
                return None
            motions.append(part[1] if part else self.table.zero)
        return motions[1] - motions[0]

    def _angle(self, end):
        """The rotation of an end; None where it has none."""
        if isinstance(end, list):
            self.report(end[0].where, "a place does not turn", TURNING)
            return None
        if end.text == "ground":
            return self.table.zero
        if end.text not in self.bodies:
            self.report(end.where, f"the point '{end.text}' does not turn", TURNING)
            return None
        return self.angle_of(end, "write `k` or `c` instead of `torsion`")

    def angle_of(self, end, hint="give it a `turn`, or a place and a `pin`"):
        """The rotation of a body; None where it has none, which is reported."""
        body = self.bodies[end.text]
        if body.frame is not None:
            return body.frame.angle
        if body.lumped[0] == "slide":
            self.report(end.where, f"'{end.text}' slides: it has no rotation", hint)
            return None
        return body.lumped[1]

    @staticmethod
    def _difference(record, angles):
        return None if None in angles else angles[1] - angles[0]
