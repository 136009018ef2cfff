"""The list of all equilibria, as a section of a report and as data."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.stability import FALLING, HELD, NEUTRAL, OPEN, STABLE, UNDECIDED, UNSTABLE, inertless, judged
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Paragraph, Section, TableBlock, Words, maths, paragraph, section, separated
from vibcli.report.keys import Key
from vibcli.report.sections.equilibrium import measured
from vibcli.report.sections.parameters import unit

if TYPE_CHECKING:
    from vibcli.analyses.modal.stability import Stability
    from vibcli.mechanics.equilibrium.all_equilibria import Equilibria, Item
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

KINDS = {STABLE: "stable", UNSTABLE: "unstable", NEUTRAL: "neutral", HELD: "stable by terms beyond the linear ones",
         FALLING: "unstable by terms beyond the linear ones", OPEN: "no small oscillations: a kink",
         UNDECIDED: "masses or dampers would decide"}
WIDEST = 6      # coordinates side by side
PROVED = "proved by interval arithmetic: there are no others within these bounds"
OPEN_LIST = "found by search: it is not proved that there are no others"
HELD_ELSEWHERE = "these are the positions of rest without dry friction, which holds it in others too"
AGREE = ("{}; the indices of these sum to {}, the degree of the forces on the bounds, so that those of any others "
         "cancel")
MISSED = ("at least one more exists: the indices of these sum to {}, but the forces on the bounds have the degree {}. "
          "It was not found; give narrower bounds under `within`, in which it may be")
CUT = "the search was cut short: there may be more; give narrower bounds under `within`"


def equilibria(problem: "Problem", _: "Report") -> Iterator[Section]:
    """A table of the equilibria, and where they were searched."""
    listed = _listed(problem)
    warned = [(number, _warning(about, found)) for number, (_, about, found) in enumerate(listed, 1)]
    limits = [maths(Name(name), *(part for words, end in ((" from ", low), (" to ", high)) for part in (
        Words(words), *measured(end, problem.system.dimension(name)))))
              for name, (low, high) in problem.equilibria.bounds.items()]
    yield from section(
        "Equilibria", _table(problem, listed) if listed else paragraph("none"),
        *(paragraph(f"{number}: {warning}", hang=3) for number, warning in warned if warning),
        paragraph("searched: ", *separated(limits)) if limits else None,
        search_told(problem, problem.equilibria))


def search_told(problem: "Problem", found: "Equilibria") -> Paragraph | None:
    """A paragraph: are there others?"""
    if problem.system.sticking is not None:
        return paragraph(HELD_ELSEWHERE, hang=None)
    if found.linear:
        return paragraph("the equations are linear: there are no others") if found.items else None
    if found.missed:
        return paragraph(MISSED.format(*map(_signed, found.indices)), hang=None)
    said = PROVED if found.complete else CUT if found.cut else OPEN_LIST
    return paragraph(said if found.indices is None else AGREE.format(said, _signed(found.indices.sum)), hang=None)


def _signed(number: int) -> str:
    return str(number).replace("-", "−")


def _listed(problem: "Problem") -> "list[tuple[Item, Problem, Stability]]":
    """[(what was found, the problem about it, its Stability)]"""
    return [(item, about, judged(about.modal))
            for item, about in zip(problem.equilibria.items, problem.about_each, strict=True)]


def _warning(problem: "Problem", found: "Stability") -> str | None:
    """A warning where an equilibrium is near a bifurcation; None of one whose stability is open."""
    if found.kind == OPEN:
        return None
    from vibcli.analyses.modal.bifurcation_distance import bifurcation_warning, stiffness_condition

    return bifurcation_warning(stiffness_condition(problem.modal))


def _table(problem: "Problem", listed: "Sequence[tuple[Item, Problem, Stability]]") -> TableBlock:
    rows = [(str(number), *_places(problem, item), figure(item.equilibrium.residual, digits=2), _kind(found, item),
             _rates(about, found)) for number, (item, about, found) in enumerate(listed, 1)]
    return TableBlock(("", *_heads(problem), "left of the forces", "", "ω [rad/s]"), tuple(rows))


def _heads(problem: "Problem") -> list[Any]:
    names = problem.scene.coordinates
    if len(names) > WIDEST:
        return ["position in SI units"]
    return [maths(Name(name), Words(f" [{unit(problem.system.dimension(name))}]")) for name in names]


def _places(problem: "Problem", item: "Item") -> list[str]:
    """The coordinates of an equilibrium, in columns where there are few."""
    names, values = problem.scene.coordinates, item.equilibrium.values
    if len(names) > WIDEST:
        from vibcli.notation.plain import plain

        return [", ".join(f"{plain.symbol(name)} = {figure(values[name])}" for name in names)]
    return [figure(values[name]) for name in names]


def _rates(problem: "Problem", found: "Stability") -> str:
    if found.growth_rate is not None:
        return f"grows as exp({figure(found.growth_rate)}·t)"
    if found.kind == OPEN or inertless(problem.configuration.linear_system):
        return ""
    return ", ".join(figure(None if mode.omega is None else float(mode.omega), mode.error)
                     for mode in problem.modal.modes.shown())


def _omega(problem: "Problem", found: "Stability") -> list[float | None]:
    """The natural angular frequencies, None of what does not oscillate."""
    if found.kind == OPEN or inertless(problem.configuration.linear_system):
        return []
    return [None if mode.omega is None else float(mode.omega) for mode in problem.modal.modes.shown()]


def _kind(found: "Stability", item: "Item") -> str:
    free = ", ".join(_direction(direction) for direction in item.free)
    if not free:
        return KINDS[found.kind]
    return f"neutral along {free}" if found.kind == NEUTRAL else f"{KINDS[found.kind]}; free along {free}"


def _direction(free: Mapping[str, float]) -> str:
    """`x`, or `(1 x, -1 y)`."""
    from vibcli.notation.plain import plain

    parts = [f"{figure(value, digits=4)} {plain.symbol(name)}" for name, value in free.items()]
    return plain.symbol(next(iter(free))) if len(free) == 1 else f"({', '.join(parts)})"


def _data(problem: "Problem") -> Iterator[dict[str, dict[str, float] | float | list[float | None] | str | None]]:
    """What the keys tell of each of the list."""
    for item, about, found in _listed(problem):
        values = {name: item.equilibrium.values[name] for name in problem.scene.coordinates}
        yield EQUILIBRIA.row(values, about.configuration.dependent_values, found.stable, found.kind, found.growth_rate,
                             item.equilibrium.residual, _omega(about, found), item.free, _warning(about, found))


EQUILIBRIA = Key("equilibria", "where `find` asks for them: a list of all equilibria found within the bounds, in "
                 "ascending order", _data, each=(
    Key("coordinates", "{name: value}"),
    Key("dependent", "{name: value} of the coordinates that constraints tie to the others"),
    Key("stable", "true or false (motion that costs no energy counts as stable); null where a kink leaves it open, "
        "or masses that the scene does not give would decide"),
    Key("kind", "stable, unstable, neutral (it can move freely), or where only terms beyond the linear ones decide: "
        "held, falling; open at a kink, undecided where masses or dampers would decide"),
    Key("growth_rate", "the largest growth rate, with the dampers of the scene; null where nothing grows"),
    Key("residual", "what is left of the forces, relative to their terms"),
    Key("omega", "natural angular frequencies about it, null for unstable modes"),
    Key("free", "directions {coordinate: component} in which it can be moved and stays in equilibrium"),
    Key("warning", "a sentence where it is near a bifurcation, else null")))
SEARCH = Key("search", "of the search for all equilibria", lambda problem: problem.equilibria, of=(
    Key("bounds", "{name: [least, greatest]}; empty where the equations are linear",
        lambda found: {name: [float(low), float(high)] for name, (low, high) in found.bounds.items()}),
    Key("complete", "true where it is proved that there are no others within the bounds; false where there may be "
        "more"),
    Key("cut", "true where the search was cut short"),
    Key("indices", "sum of the signs of det K of the equilibria found; null where it is complete or not known",
        lambda found: found.indices and found.indices.sum),
    Key("degree", "the degree of the forces on the bounds, which this sum has where none is missing; null likewise",
        lambda found: found.indices and found.indices.degree)))
