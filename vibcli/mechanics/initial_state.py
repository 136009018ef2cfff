"""Where a motion starts: the values of `initial`, else at rest in the equilibrium without loads that depend on time."""

from collections.abc import Mapping
from functools import cached_property, partial
from math import isfinite
from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.stage import Stage
from vibcli.language.sections.initial import FIELDS
from vibcli.language.spec import RELEASED
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node


class InitialState:
    """Where the motion of a Configuration starts."""

    def __init__(self, configuration: "Configuration") -> None:
        self.configuration, self.costs = configuration, configuration.costs

    @cached_property
    def given(self) -> dict[str, float]:
        """{coordinate, or velocity x': value} of `initial`, and of the equilibrium under a force that lets go."""
        configuration = self.configuration
        record, scene, held = configuration.spec.get("initial"), configuration.scene, configuration.preloaded
        found = dict(at_rest(held)) if held is not None else {}
        for key, expression in record.items() if record is not None else ():
            if key == RELEASED:
                continue
            if key.rstrip("'") not in scene.coordinates:
                raise PhysicsError(f"'{key}' follows from the other coordinates by the constraints", "start "
                                   + " or ".join(f"'{other}'" for other in scene.coordinates[:3]), record.place(key))
            found[key], = evaluate([scene.lower(expression)], Floats, configuration.numeric.floats)
            if not isfinite(found[key]):
                raise PhysicsError(f"the start of '{key}' is no real number", "give another value under `initial:`",
                                   expression.where)
        if configuration.spec.get(FIELDS):
            from vibcli.mechanics.initial_fields import start_of_stations

            found = start_of_stations(configuration, partial(at_rest, configuration), found)
        return found

    @Stage
    def start(self) -> tuple[dict[str, float], dict[str, float]]:
        """({coordinate: value}, {coordinate: velocity}) at t = 0 of the independent coordinates."""
        given, names = self.given, self.configuration.scene.coordinates
        rest = given if all(name in given for name in names) else at_rest(self.configuration)
        return ({name: given.get(name, rest[name]) for name in names},
                {name: given.get(name + "'", 0.0) for name in names})


def at_rest(configuration: "Configuration") -> dict[str, float]:
    """{coordinate: value} where a motion starts at rest: in the equilibrium without friction; where none is reached, as
    nothing holds the scene, as drawn or where `equilibrium:` says; else as drawn if friction holds it there."""
    if configuration.falls:
        return configuration.numeric.start()
    try:
        return configuration.equilibrium.values
    except PhysicsError as error:
        if configuration.system.sticking is None:
            raise
        from vibcli.mechanics.equilibrium.dry_friction import holds

        if not holds(configuration.numeric, configuration.system.sticking, configuration.numeric.drawn_floats):
            raise PhysicsError(f"without friction {error.message}; friction does not hold it as drawn either",
                               "give the start of every coordinate under `initial`: "
                               + ", ".join(configuration.scene.coordinates), error.where) from None
        return configuration.numeric.drawn_floats


def start_in_letters(symbolic: "SymbolicSystem") -> "list[Node] | None":
    """[deviation from the equilibrium, velocity] of the one coordinate at t = 0; None where the file gives none."""
    starts = starts_in_letters(symbolic)
    return None if starts is None else starts[0]


def starts_in_letters(symbolic: "SymbolicSystem") -> "list[list[Node]] | None":
    """The same of each coordinate."""
    record, names = symbolic.spec.get("initial"), symbolic.scene.coordinates
    if record is None:
        return None
    if symbolic.spec.get(FIELDS):
        raise NotInLetters("motions that start with fields along members are found in numbers",
                           "give numbers with --set")
    held = symbolic.preloaded.equilibrium_position if symbolic.preloaded is not None else {}
    if any(key != RELEASED and key.rstrip("'") not in names for key in record):
        raise NotInLetters("this start is found in numbers", "give the parameters values with --set")
    return [_start_of(symbolic, record, held, name) for name in names]


def _start_of(symbolic: "SymbolicSystem", record: "Record", held: "Mapping[str, Node]", name: str) -> "list[Node]":
    rest = symbolic.equilibrium_position[name]
    place, speed = (symbolic.scene.lower(record[key]) if key in record else None for key in (name, name + "'"))
    if place is None:
        place = copied([held[name]], symbolic.scene.table)[0] if held else rest
    return [textbook(place - rest), symbolic.scene.table.zero if speed is None else speed]
