"""All equilibria of a scene within bounds: a scan of one coordinate, many starts for several; each checked by its
residual and met once, images of it a turn apart included."""

import math
from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equilibrium import multistart, one_coordinate
from vibcli.mechanics.equilibrium.completeness import proved
from vibcli.mechanics.equilibrium.degenerate import sharpened
from vibcli.mechanics.equilibrium.distinct_roots import Found
from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
from vibcli.mechanics.equilibrium.families import Family
from vibcli.mechanics.equilibrium.indices import compared
from vibcli.mechanics.equilibrium.scaled_forces import Forces, TooMuch, idle, typical_length
from vibcli.mechanics.nonsmooth import KINKED
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.equilibrium.scaled_forces import Place
    from vibcli.mechanics.numeric_system import NumericSystem

MOST_WORK, MOST, LEAST, SAMPLES = 10**6, 60_000, 300, 24
SINGULAR, DUST = 1e-4, 1e-13       # of the stiffness typical of the scene; of the size of the figure
REACH = 2.0                        # of the size of the figure: what is searched of a length


class Item(NamedTuple):
    """One equilibrium, or a line of them by one of its positions; free: directions {coordinate: component} in which it
    can be moved and stays in equilibrium; singular: is K nearly so?"""

    equilibrium: Equilibrium
    free: list[dict[str, float]]
    singular: bool = True


class Equilibria(NamedTuple):
    """items in ascending order of the first coordinate that tells them apart; bounds {coordinate: (least, most)} of
    those searched; complete: is it proved that there are no others; cut: was the search cut short; linear: are the
    forces, so that there is no other? forces: the Forces that were searched; indices: Indices of what is not proved to
    be complete, None where they are not known."""

    items: list[Item]
    bounds: dict[str, tuple[float, float]]
    complete: bool
    linear: bool
    forces: Forces
    cut: bool = False
    indices: Any = None

    @property
    def missed(self) -> bool:
        """Is it proved that there are others?"""
        return self.indices is not None and not self.indices.agree


def find_equilibria(configuration: "Configuration", within: "Mapping[str, tuple[float, float]] | None" = None
                    ) -> Equilibria:
    """The Equilibria of a system in numbers, `within` bounds in place of those of the file; PhysicsError where the
    bounds are missing or wrong."""
    if configuration.numeric.has_free_symbols:
        asked = configuration.spec.get("find")
        raise PhysicsError("all equilibria are searched in numbers only, and this scene has symbols without value",
                           "give them with --set", asked.search.where if asked and asked.search else None)
    loose = idle(configuration.numeric)
    names = [name for name in configuration.scene.coordinates if name not in loose]
    forces = Forces(configuration.numeric, names)
    rests = _reached(configuration)
    given = _given_bounds(configuration.numeric) if within is None else within
    linear = configuration.system.is_linear and not configuration.scene.table.called.intersection(KINKED)
    if not names:
        return Equilibria([Item(rest, [{name: 1.0} for name in loose]) for rest in rests], {}, True, True, forces)
    if linear:
        limits = {name: given.get(name, (-np.inf, np.inf)) for name in names}
        found = Found(forces, _box(forces, limits))
    else:
        limits, found = _prepared(configuration.numeric, forces, rests, given)
    places = [place for rest in rests if (place := forces.at(forces.vector(rest.values))) is not None]
    for place in places:
        found.add(place)
    cut = not linear and _cut_short(forces, found)
    complete = configuration.system.sticking is None and (linear or (not cut and proved(forces, found)))
    indices = None if complete or configuration.system.sticking is not None else compared(forces, found)
    known = {id(place): rest for place, rest in zip(places, rests, strict=False)}
    items = [_item(forces, place, (), loose, known) for place in found.isolated]
    items += [_item(forces, family.place, family.rows, loose, known) for family in found.families]
    items.sort(key=lambda item: [round(x, 7) + 0.0 for x in forces.vector(item.equilibrium.values)])
    limits = {name: pair for name, pair in limits.items() if np.all(np.isfinite(pair))}
    return Equilibria(items, limits, complete, linear, forces, cut, indices)


def _reached(configuration: "Configuration") -> list[Equilibrium]:
    """[the equilibrium next to the drawn position], that of linear forces wherever it is, empty where there is none."""
    try:
        return [configuration.equilibrium]
    except PhysicsError:
        from vibcli.mechanics.equilibrium.rest_in_digits import rest_in_digits

        place = rest_in_digits(configuration.numeric, held=False)
        return [] if place is None else [Equilibrium(place, False, 0.0)]


def _prepared(numeric: "NumericSystem", forces: Forces, rests: Sequence[Equilibrium],
              given: "Mapping[str, tuple[float, float]]") -> tuple[dict[str, tuple[float, float]], Found]:
    """(bounds, an empty Found within them), the scales and periods of the forces being learnt."""
    forces.learn_periods()
    limits = _bounds(numeric, forces, [rest.values for rest in rests], given)
    low, high = _box(forces, limits)
    forces.learn_sizes(low + (high - low) * fractions for fractions in multistart.spread(len(low), SAMPLES))
    return limits, Found(forces, (low, high))


def _bounds(numeric: "NumericSystem", forces: Forces, rests: Sequence[dict[str, float]],
            given: "Mapping[str, tuple[float, float]]") -> dict[str, tuple[float, float]]:
    """{coordinate: (least, greatest)} that are given, else a turn of angles and twice the figure; `rests`: positions of
    equilibrium that are known, which are kept within."""
    found = {}
    for name, angle, periodic in zip(forces.names, forces.angle, forces.periodic, strict=True):
        drawn = numeric.drawn_floats[name]
        if name in given:
            low, high = given[name]
            centre = 0.5 * (low + high)
            found[name] = (centre - math.pi, centre + math.pi) if periodic and high - low > math.tau else (low, high)
        elif angle:
            centre = 0.0 if abs(drawn) <= math.pi else drawn
            found[name] = (centre - math.pi, centre + math.pi)
        else:
            reach = REACH * max(typical_length(numeric), *(abs(rest[name] - drawn) for rest in rests), 0.0)
            if not reach:
                far = numeric.spec.example("2 m")
                raise PhysicsError(f"nothing in this scene says how far '{name}' is to be searched for equilibria",
                                   f"give bounds, as in find: {{equilibria: all, within: {{{name}: [-{far}, {far}]}}}}",
                                   numeric.spec.origin(name).where)
            found[name] = (drawn - reach, drawn + reach)
    return found


def _given_bounds(numeric: "NumericSystem") -> dict[str, tuple[float, float]]:
    """{coordinate: (least, greatest)} of the file."""
    asked, found = numeric.spec.get("find"), {}
    for name, pair in (asked.within if asked else {}).items():
        nodes = [numeric.scene.lower(expression) for expression in pair]
        low, high = evaluate(nodes, Floats, numeric.floats)
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise PhysicsError(f"the bounds of '{name}' are {low:.6g} and {high:.6g}, expected the smaller one first",
                               "write [least, most]", pair[0].where)
        found[name] = (low, high)
    return found


def _box(forces: Forces, limits: "Mapping[str, tuple[float, float]]") -> list[np.ndarray]:
    return [forces.vector({name: pair[i] for name, pair in limits.items()}) for i in (0, 1)]


def _cut_short(forces: Forces, found: Found) -> bool:
    """Searches the box; True if that took too much."""
    limit = min(MOST, max(LEAST, MOST_WORK // len(forces.names) ** 2))
    with forces.work.task("the search for equilibria", limit) as task, task.kept(), suppress(TooMuch):
        _search(forces, found, [forces.vector(forces.numeric.drawn_floats)])
        return False
    return True


def _search(forces: Forces, found: Found, first: list[np.ndarray]) -> None:
    if len(forces.names) > 1:
        multistart.search(forces, found, first)
        return
    for place, stretch in one_coordinate.zeros(forces, found.box[0][0], found.box[1][0]):
        if stretch is None:
            found.add(place)
        elif not _line(forces, stretch):
            _add_multiple(forces, found, stretch)
        elif not any(family.holds(forces, place) for family in found.families):
            found.families.append(Family(place, np.ones((1, 1))))


def _line(forces: Forces, stretch: tuple[float, float]) -> bool:
    """Is every position of a stretch one of rest, and not only so flat that floats see no force?"""
    from vibcli.mechanics.high_precision import rests

    low, high = stretch
    return forces.looped or rests(forces.numeric, forces.position(np.array([low + (high - low) / 3])))


def _add_multiple(forces: Forces, found: Found, stretch: tuple[float, float]) -> None:
    """The one multiple zero of a stretch about which the forces are rounding."""
    low, high = stretch
    if any(low <= place.z[0] <= high for place in found.isolated):
        return
    middle = Equilibrium(forces.position(np.array([0.5 * (low + high)])), False, 0.0)
    found.add(forces.at(forces.vector(sharpened(forces.numeric, middle).values)))


def _item(forces: Forces, place: "Place", rows: np.ndarray | tuple[np.ndarray, ...], loose: Sequence[str],
          known: "Mapping[int, Equilibrium]") -> Item:
    place = place if id(place) in known else _tidied(forces, place)
    free = [{name: 1.0} for name in loose] + [_direction(forces, row) for row in rows]
    rest = known.get(id(place))
    if rest is None:
        rest = Equilibrium(forces.position(place.z), False, forces.residual(place))
        rest = rest if len(rows) else sharpened(forces.numeric, rest)
    return Item(rest, free, float(np.linalg.svd(place.J, compute_uv=False)[-1]) < SINGULAR)


def _direction(forces: Forces, row: np.ndarray) -> dict[str, float]:
    """{coordinate: component} of a direction in z, the largest one 1."""
    parts = row * forces.D
    parts = parts / parts[np.argmax(np.abs(parts))]
    return {name: float(x) for name, x in zip(forces.names, parts, strict=True) if abs(x) > 1e-9}


def _tidied(forces: Forces, place: "Place") -> "Place":
    """The place with coordinates that are zero but for rounding set to zero."""
    plain = forces.at(np.where(np.abs(place.z) < DUST, 0.0, place.z))
    return plain if plain is not None and forces.balanced(plain) else place
