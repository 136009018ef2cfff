"""The list of all equilibria, as a section of a report and as data."""

from vibcli.analyses.modal.bifurcation_distance import bifurcation_warning, stiffness_condition
from vibcli.analyses.modal.stability import FALLING, HELD, NEUTRAL, OPEN, STABLE, UNSTABLE, inertless, judged
from vibcli.notation.numbers import figure, with_unit
from vibcli.notation.plain import plain
from vibcli.report.blocks import Name, TableBlock, Words, maths, paragraph, section, separated
from vibcli.report.sections.parameters import unit

KINDS = {STABLE: "stable", UNSTABLE: "unstable", NEUTRAL: "neutral", HELD: "stable by terms beyond the linear ones",
         FALLING: "unstable by terms beyond the linear ones", OPEN: "no small oscillations: a kink"}
WIDEST = 6      # coordinates side by side
PROVED = "proved by interval arithmetic: there are no others within these bounds"
OPEN_LIST = "found by search: it is not proved that there are no others"
HELD_ELSEWHERE = "these are the positions of rest without dry friction, which holds it in others too"
AGREE = ("{}; the indices of these sum to {}, the degree of the forces on the bounds, so that those of any others "
         "cancel")
MISSED = ("at least one more exists: the indices of these sum to {}, but the forces on the bounds have the degree {}. "
          "It was not found; give narrower bounds under `within`, in which it may be")
CUT = "the search was cut short: there may be more; give narrower bounds under `within`"


def equilibria(problem, _):
    """A table of the equilibria, and where they were searched."""
    found = problem.equilibria
    warned = [(number, _warning(about)) for number, about in enumerate(problem.about_each, 1)]
    limits = [maths(Name(name), Words(f" from {with_unit(low, problem.system.dimension(name))} to "
                                      f"{with_unit(high, problem.system.dimension(name))}"))
              for name, (low, high) in found.bounds.items()]
    yield from section(
        "Equilibria", _table(problem) if found.items else paragraph("none"),
        *(paragraph(f"{number}: {warning}", hang=3) for number, warning in warned if warning),
        paragraph("searched: ", *separated(limits)) if limits else None,
        _others(problem, found))


def _others(problem, found):
    """A paragraph: are there others?"""
    if problem.system.sticking is not None:
        return paragraph(HELD_ELSEWHERE, hang=None)
    if found.linear:
        return paragraph("the equations are linear: there are no others") if found.items else None
    if found.missed:
        return paragraph(MISSED.format(*map(_signed, found.indices)), hang=None)
    said = PROVED if found.complete else CUT if found.cut else OPEN_LIST
    return paragraph(said if found.indices is None else AGREE.format(said, _signed(found.indices.sum)), hang=None)


def _signed(number):
    return str(number).replace("-", "−")


def equilibrium_warning(problem):
    """A warning where the equilibrium of a problem is near a bifurcation, else None."""
    return bifurcation_warning(stiffness_condition(problem.modal))


def _warning(problem):
    """The same of one of a list, where its stability may be open."""
    return None if judged(problem.modal).kind == OPEN else equilibrium_warning(problem)


def _table(problem):
    rows = []
    for number, (item, about) in enumerate(zip(problem.equilibria.items, problem.about_each, strict=True), 1):
        found = judged(about.modal)
        rows.append((str(number), *_places(problem, item), figure(item.equilibrium.residual, digits=2),
                     _kind(found, item), _rates(about, found)))
    return TableBlock(("", *_heads(problem), "residual", "", "ω [rad/s]"), tuple(rows))


def _heads(problem):
    names = problem.scene.coordinates
    if len(names) > WIDEST:
        return ["position in SI units"]
    return [maths(Name(name), Words(f" [{unit(problem.system.dimension(name))}]")) for name in names]


def _places(problem, item):
    """The coordinates of an equilibrium, in columns where there are few."""
    names, values = problem.scene.coordinates, item.equilibrium.values
    if len(names) > WIDEST:
        return [", ".join(f"{plain.symbol(name)} = {figure(values[name])}" for name in names)]
    return [figure(values[name]) for name in names]


def _rates(problem, found):
    if found.growth_rate is not None:
        return f"grows as exp({figure(found.growth_rate)}·t)"
    if found.kind == OPEN:
        return ""
    return ", ".join(figure(None if mode.omega is None else float(mode.omega), mode.error)
                     for mode in problem.modal.modes)


def _omega(problem, found):
    """The natural angular frequencies, None of what does not oscillate."""
    if found.kind == OPEN or inertless(problem.configuration.linear_system):
        return []
    return [None if mode.omega is None else float(mode.omega) for mode in problem.modal.modes]


def _kind(found, item):
    free = ", ".join(_direction(direction) for direction in item.free)
    if not free:
        return KINDS[found.kind]
    return f"neutral along {free}" if found.kind == NEUTRAL else f"{KINDS[found.kind]}; free along {free}"


def _direction(free):
    """`x`, or `(1 x, -1 y)`."""
    parts = [f"{figure(value, digits=4)} {plain.symbol(name)}" for name, value in free.items()]
    return plain.symbol(next(iter(free))) if len(free) == 1 else f"({', '.join(parts)})"


def equilibria_data(problem):
    """{equilibria: [{coordinates, dependent, stable, kind, growth_rate, residual, omega, free, warning}],
    search: {bounds, complete, cut, indices, degree}}."""
    found, entries = problem.equilibria, []
    for item, about in zip(found.items, problem.about_each, strict=True):
        result = judged(about.modal)
        entries.append({
            "coordinates": {name: item.equilibrium.values[name] for name in problem.scene.coordinates},
            "dependent": about.configuration.dependent_values, "stable": result.stable, "kind": result.kind,
            "growth_rate": result.growth_rate, "residual": item.equilibrium.residual,
            "omega": _omega(about, result),
            "free": item.free, "warning": _warning(about)})
    limits = {name: [float(low), float(high)] for name, (low, high) in found.bounds.items()}
    indices, degree = found.indices or (None, None)
    return {"equilibria": entries, "search": {"bounds": limits, "complete": found.complete, "cut": found.cut,
                                              "indices": indices, "degree": degree}}
