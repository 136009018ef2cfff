"""Loads along members as inputs by name: of the form f(x) that is written, scaled so that its largest |f| is 1 N/m."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.amplitudes import amplitudes
from vibcli.scene.energy_terms import RestingLoad
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.separated_products import products_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.elements.member_loads import SpreadLoad
    from vibcli.mechanics.configuration import Configuration
    from vibcli.scene.displacements import Opening
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

GRID, ZOOM = 240, 12        # places at which a form is looked at, and at which again about the largest, ever closer
SMALLEST = 1e-30            # of a length: places are told apart no further


def spread_input(configuration: "Configuration", name: str, found: "Mapping[int, Opening]") -> dict[int, Any]:
    """{number of an input coordinate: its share} of the load of that name; `found`: all inputs."""
    opened = configuration.with_inputs
    scene, sample, arithmetic = opened.scene, opened.sample, opened.arithmetic
    load = next(load for load in scene.spread_loads if load.owner == name)
    along, moving = _product(load, scene)
    largest = _largest(along, load, sample, arithmetic)
    shares = {}
    for j, opening in found.items():
        if opening.name == name and opening.spread is not None:
            shares[j] = 1 / largest
        elif opening.name == name and opening.load is not None:
            term = scene.forces[opening.load]
            if isinstance(term, RestingLoad) or (term.offset is None and not load.in_time.is_zero):
                continue
            part = term.weight if term.offset is None else term.weight - term.offset
            size, unit = amplitudes(opened, [part, moving])
            shares[j] = size / unit / largest
    if not shares:
        raise PhysicsError(f"'{name}' does no work", "let the member move where it acts")
    return shares


def _product(load: "SpreadLoad", scene: "Scene") -> "tuple[Node, Node]":
    """(f, g) of a load f(x) g(t)."""
    if load.in_time.is_zero:
        return load.q, scene.table.one
    found = products_of(load.in_time, load.x, scene.time)
    if found is None or len(found) != 1:
        raise PhysicsError(f"'{load.owner}' has no one form along '{load.member}': it is no product f(x)*g(t)",
                           "write a force of its own for each product, and name one of them")
    return found[0]


def _largest(along: "Node", load: "SpreadLoad", sample: "Mapping[str, Any]", arithmetic: Any) -> Any:
    """The largest |f| from one end to the other."""
    start, end = evaluate([load.start, load.end], arithmetic, sample)

    def sizes(places: "Sequence[Any]") -> "list[Any]":
        return [abs(evaluate([along], arithmetic, {**sample, load.x.name: x})[0]) for x in places]

    step = (end - start) / GRID
    places = [start + step * k for k in range(GRID)] + [end]
    found = sizes(places)
    most, at = max(zip(found, places, strict=True))
    while step > SMALLEST * (end - start):
        low, high = max(start, at - step), min(end, at + step)
        step = (high - low) / ZOOM
        places = [low + step * k for k in range(ZOOM)] + [high]
        near, place = max(zip(sizes(places), places, strict=True))
        if not near > most * (1 + 4 * _rounding(arithmetic)):
            break
        most, at = near, place
    if not most > 0:
        raise PhysicsError(f"'{load.owner}' is zero all along '{load.member}'", "name a load that is not")
    return most


def _rounding(arithmetic: Any) -> Any:
    from vibcli.symbolic.evaluation import Floats

    if arithmetic is Floats:
        return 2.0**-53
    from mpmath import mp

    return mp.eps
