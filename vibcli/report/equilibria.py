"""The list of all equilibria, as text and as data."""

from vibcli import units
from vibcli.analyses.condition import bifurcation_warning, stiffness_condition
from vibcli.analyses.stability import FALLING, HELD, NEUTRAL, OPEN, STABLE, UNSTABLE, judged
from vibcli.report.figures import figure, table, with_unit, wrapped
from vibcli.report.notation import plain

KINDS = {STABLE: "stable", UNSTABLE: "unstable", NEUTRAL: "neutral", HELD: "stable by terms beyond the linear ones",
         FALLING: "unstable by terms beyond the linear ones", OPEN: "no small oscillations: a kink"}
WIDEST = 6      # coordinates side by side
CUT = "the search was cut short: there may be more; give narrower bounds under `within`"


def equilibria_lines(problem):
    """Lines of a report: a table of the equilibria, and where they were searched."""
    found = problem.equilibria
    lines = _table(problem) if found.items else ["none"]
    for number, about in enumerate(problem.about_each, 1):
        warning = _warning(about)
        lines += wrapped(f"{number}: {warning}", indent=3) if warning else []
    limits = [f"{plain.symbol(name)} from {with_unit(low, problem.dimension(name))} to "
              f"{with_unit(high, problem.dimension(name))}" for name, (low, high) in found.bounds.items()]
    lines += wrapped("searched: " + ", ".join(limits)) if limits else []
    lines += ["the equations are linear: there are no others"] if found.linear and found.items else []
    return lines if found.complete else [*lines, CUT]


def equilibrium_warning(problem):
    """A warning where the equilibrium of a problem is near a bifurcation, else None."""
    return bifurcation_warning(stiffness_condition(problem))


def _warning(problem):
    """The same of one of a list, where its stability may be open."""
    return None if judged(problem).kind == OPEN else equilibrium_warning(problem)


def _table(problem):
    rows = []
    for number, (item, about) in enumerate(zip(problem.equilibria.items, problem.about_each, strict=True), 1):
        found = judged(about)
        rows.append((str(number), *_places(problem, item), figure(item.equilibrium.residual, digits=2),
                     _kind(found, item), _rates(about, found)))
    return table(rows, ("", *_heads(problem), "residual", "", "ω [rad/s]"))


def _heads(problem):
    names = problem.scene.coordinates
    if len(names) > WIDEST:
        return ["position in SI units"]
    return [f"{plain.symbol(name)} [{_unit(problem.dimension(name))}]" for name in names]


def _places(problem, item):
    """The coordinates of an equilibrium, in columns where there are few."""
    names, values = problem.scene.coordinates, item.equilibrium.values
    if len(names) > WIDEST:
        return [", ".join(f"{plain.symbol(name)} = {figure(values[name])}" for name in names)]
    return [figure(values[name]) for name in names]


def _unit(dimension):
    return "rad" if dimension == {} else units.text(dimension)


def _rates(problem, found):
    if found.growth_rate is not None:
        return f"grows as exp({figure(found.growth_rate)}·t)"
    return ", ".join(figure(omega) for omega in _omega(problem, found))


def _omega(problem, found):
    """The natural angular frequencies, None of what does not oscillate."""
    return [] if found.kind == OPEN else [None if mode.omega is None else float(mode.omega) for mode in problem.modes]


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
    search: {bounds, complete}}."""
    found, entries = problem.equilibria, []
    for item, about in zip(found.items, problem.about_each, strict=True):
        result = judged(about)
        entries.append({
            "coordinates": {name: item.equilibrium.values[name] for name in problem.scene.coordinates},
            "dependent": about.dependent_values, "stable": result.stable, "kind": result.kind,
            "growth_rate": result.growth_rate, "residual": item.equilibrium.residual,
            "omega": _omega(about, result),
            "free": item.free, "warning": _warning(about)})
    limits = {name: [float(low), float(high)] for name, (low, high) in found.bounds.items()}
    return {"equilibria": entries, "search": {"bounds": limits, "complete": found.complete}}
