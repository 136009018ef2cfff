"""Signals as LinearOutputs of the response methods, each with the channel of what drives it directly."""

from math import comb
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction, rate
from vibcli.mechanics.inputs_outputs.outputs import linear_row, products
from vibcli.symbolic.rationals import ONE, fraction_of

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def linear_output(configuration: "Configuration", text: str, order: int = 0,
                  channel: Any = None) -> "tuple[LinearOutput, dict[int, Node]]":
    """(LinearOutput, {channel: what it carries, a node of the time}) of the order-th derivative of a signal, x' and x''
    included; `channel`: the number of its own channel, that after the coordinates if none is given."""
    row = linear_row(configuration, text)
    for _ in range(order):
        row = rate(row, configuration.with_inputs.scene)
    return as_output(configuration, row, channel)


def quadratic_output(configuration: "Configuration", text: str,
                     order: int = 0) -> "list[tuple[float, list[tuple[LinearOutput, dict[int, Node]]]]]":
    """[(weight, two (LinearOutput, {channel: node}))]: the order-th derivative of a signal is Σ weight·output·output;
    signals are the energy of a spring, the power of a damper or a load."""
    found = []
    for weight, (one, two) in products(configuration, text):
        if order > 1 and (one.v or two.v):
            primes = "'" * order
            raise PhysicsError(f"'{text}{primes}' needs third derivatives of the motion, which are not found",
                               f"ask for {text}'")
        left, right = (_rates(configuration, row, order) for row in (one, two))
        found += [(weight * comb(order, k), [left[k], right[order - k]]) for k in range(order + 1)]
    return found


def _rates(configuration: "Configuration", row: LinearFunction,
           order: int) -> "list[tuple[LinearOutput, dict[int, Node]]]":
    """The outputs of a LinearFunction and its derivatives."""
    found = [as_output(configuration, row)]
    for _ in range(order):
        row = rate(row, configuration.with_inputs.scene)
        found.append(as_output(configuration, row))
    return found


def as_output(configuration: "Configuration", row: LinearFunction,
              channel: Any = None) -> "tuple[LinearOutput, dict[int, Node]]":
    """(LinearOutput, {channel: node of the time}) of a LinearFunction."""
    channel = len(configuration.scene.q) if channel is None else channel
    opened, n = configuration.with_inputs, configuration.with_inputs.n
    q, v, a = ({i: x for i, x in part.items() if i < n} for part in (row.q, row.v, row.a))
    node = _direct(opened, row)
    if node is None:
        return LinearOutput(row.constant, q, v, a), {}
    return LinearOutput(row.constant, q, v, a, {channel: 1.0}), {channel: node}


def _direct(opened: "SystemWithInputs", row: LinearFunction) -> "Node | None":
    """What depends on the time alone: terms of its own, and what driven displacements add; None where nothing does."""
    scene = opened.scene
    terms = [scene.table.product((_number(scene, factor), ONE), (node, ONE)) for factor, node in row.time]
    for i, opening in enumerate(scene.inputs.values(), opened.n):
        if opening.node is not None:
            node = opening.node
            for part in (row.q, row.v, row.a):
                if part.get(i):
                    terms.append(_number(scene, part[i]) * node)
                node = scene.rate(node)
    total = scene.table.sum(*((term, ONE) for term in terms))
    return None if total.is_zero else total


def _number(scene: "Scene", value: float) -> "Node":
    return scene.table.number(fraction_of(value))
