"""Displacements of bodies and points from where they are drawn: by coordinates, in time, by supports that give way."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Expression
    from vibcli.scene.build import Variant
    from vibcli.scene.expressions import Expressions
    from vibcli.scene.places import Frame
    from vibcli.symbolic.node import Node

EARLY, LATE = 1e4, 1e9
INSTANTS = (1.0, 1.137, 1.319, 1.523, 1.689, 1.733, 1.871, 1.957)
GROWTH = 30.0       # far more than what waves differ by, far less than LATE/EARLY


class Opening(NamedTuple):
    """An input of a scene with inputs: whose it is, what drives it (None of a load), and of which term of the loads, or
    of the spread forces, it stands beside (None of a displacement, or along a coordinate)."""

    name: str
    node: "Node | None" = None
    load: int | None = None
    spread: int | None = None


class Displacements:
    """What drives a scene that is built: `driven`, {symbol: function of the time}; `inputs`, {symbol: Opening}; and the
    coordinates `released` by which supports give way, if the `variant` says so."""

    __slots__ = ("coordinates", "driven", "expressions", "inputs", "released", "table", "time", "variant")
    driven: "dict[Node, Node]"
    inputs: "dict[Node, Opening]"
    released: "list[Node]"

    def __init__(self, expressions: "Expressions", variant: "Variant") -> None:
        self.expressions, self.variant, self.coordinates = expressions, variant, expressions.coordinates
        self.table, self.time = self.coordinates.table, self.coordinates.time
        self.driven, self.inputs, self.released = {}, {}, []

    def driven_by(self, node: "Node", name: str, drive: str | None = None) -> "Node":
        """A displacement of what has this name: where it depends on the time, a symbol that is zero as drawn and stands
        for it until the scene is assembled; of a scene with inputs an input. Its `drive` gives way with supports."""
        if not node.mask & self.time.mask:
            return node
        slip = self._released(drive) if self.variant.released and drive else self.table.zero
        if self.variant.inputs and stays_bounded(node, self.time, self.expressions.sample):
            return self.add_input(name, node) + slip
        symbol = self.table.dependent(f"driven {len(self.driven)}", node.mask)
        self.driven[symbol], self.coordinates.at_rest[symbol] = node, self.table.zero
        return symbol + slip

    def change(self, expression: "Expression", owner: str, part: str = "") -> "Node":
        """A displacement from the drawn position: how much the terms that hold coordinates have changed since then, and
        what is prescribed in time, which counts as it stands, constants included. `part`: .x, .y or .moment of a body
        that has several."""
        node, drive = self.expressions.lower(expression), f"{owner}.drive{part}"
        if node.mask == self.time.mask:
            return self.driven_by(node, owner, drive)
        drawn, = self.coordinates.at_drawn(node)
        held = self.expressions.terms_with(node, ~self.time.mask) if node.mask & self.time.mask else node
        driven = textbook(node - held)
        if not driven.mask:
            return node - drawn
        at_start, = self.coordinates.at_drawn(held)
        if drawn.is_zero:
            driven = driven + at_start
        return held - at_start + self.driven_by(driven, owner, drive)

    def release(self, body: "Body") -> "Frame":
        """The frame of a body whose support gives way: by x and y in the fixed axes, and by a rotation."""
        x, y, turn = (self._released(f"{body.name}.reaction.{part}") for part in ("x", "y", "moment"))
        frame = body.frame
        return frame._replace(place=(frame.place[0] + x, frame.place[1] + y), angle=frame.angle + turn)

    def turns(self, body: "Body") -> bool:
        """Does a body turn, other than by its support giving way?"""
        angle, = substitute([body.frame.angle], dict.fromkeys(self.released, self.table.zero))
        return bool(angle.mask)

    def _released(self, name: str) -> "Node":
        self.released.append(self.coordinates.further(name))
        return self.released[-1]

    def add_input(self, name: str, node: "Node | None" = None, load: int | None = None,
                  spread: int | None = None) -> "Node":
        """An input as a further coordinate: a displacement that is driven by `node`, or a load beside a given one."""
        symbol = self.coordinates.further(f"input {len(self.inputs) + 1}")
        self.inputs[symbol] = Opening(name, node, load, spread)
        return symbol


def stays_bounded(node: "Node", time: "Node", values: Mapping[str, float]) -> bool:
    """Does a displacement that depends on the time alone stay bounded, so that it counts as a small one?

    Sines and cosines, pulses, waves, records and what decays do; v·t and Ω·t do not: they are told apart by their
    growth from some 10⁴ s to some 10⁹ s. An impulse is not bounded.
    `values`: {name: float} of all symbols but the time.
    """
    if any(part.name == "impulse" for part in reachable([node])):
        return False
    calls = [part for part in reachable([node]) if part.name in ("sin", "cos")]
    waves = {part: node.table.parameter(f"wave {i}", positive=False) for i, part in enumerate(calls)}   # not 1: 1 − 1
    if not substitute([node], waves)[0].mask & time.mask:
        return True
    early, late = (max(abs(evaluate([node], Floats, {**values, time.name: start * x})[0]) for x in INSTANTS)
                   for start in (EARLY, LATE))
    bounded: bool = late <= GROWTH * early
    return bounded
