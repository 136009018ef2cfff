"""Shares, sensitivities and estimates: what `solve` prints only where it is asked for."""

from vibcli.base import units
from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, TableBlock, Words, maths, paragraph, section, separated
from vibcli.report.sections.insight_data import logarithmic, require_numbers

COLUMNS, ROWS = 8, 40       # of a table; the rest is in the JSON
NOTHING = 1e-9              # per cent


def _grid(title, columns, write, *told):
    """A table of [(head, {name: number})], a row to each name, and what is told under it."""
    names = list(dict.fromkeys(name for _, column in columns for name in column))
    shown = columns[:COLUMNS]
    rows = [(name, *(write(column.get(name)) for _, column in shown)) for name in names[:ROWS]]
    left = [f"{len(columns) - COLUMNS} more modes"] * (len(columns) > COLUMNS)
    left += [f"{len(names) - ROWS} more rows"] * (len(names) > ROWS)
    return section(title, TableBlock(("", *(head for head, _ in shown)), tuple(rows)),
                   paragraph(f"… {' and '.join(left)}: see --json", hang=None) if left else None, *told) if rows else ()


# shares


def shares(problem, _):
    require_numbers(problem, "shares")
    found = problem.modal.shares
    potential = [(f"mode {i}", column) for i, column in found.potential.items() if column]
    lowering = any(share < -NOTHING / 100 for _, column in potential for share in column.values())
    told = [paragraph("(negative: it lowers the stiffness of the mode)", hang=None)] * lowering
    told += [paragraph(f"(modes {_listed(group)} have one frequency: only the means of their shares are definite)",
                       hang=None) for group in found.coinciding]
    yield from _grid("Shares of the potential energy [%]", potential, _per_cent, *told)
    yield from _grid("Shares of the kinetic energy [%]",
                     [(f"mode {i}", column) for i, column in found.kinetic.items()], _per_cent)
    if found.dissipation is not None:
        yield from _grid("Shares of the energy that the damped modes lose [%]",
                         [(_damped_head(mode), column) for mode, column in found.dissipation if column], _per_cent)


def _listed(indices):
    return ", ".join(map(str, indices))


def _per_cent(share):
    return "–" if share is None else figure(0.0 if abs(100 * share) < NOTHING else 100 * share, digits=4)


def _damped_head(mode):
    """`mode 2`, with the eigenvalue where it is one of several real ones of the mode."""
    real = not mode.eigenvalue.imag
    return f"mode {mode.index}" + (f" (λ = {figure(float(mode.eigenvalue.real), digits=4)})" if real else "")


# sensitivities


def sensitivities(problem, _):
    require_numbers(problem, "sensitivities")
    found = problem.modal.sensitivities
    heads = [(f"mode {mode.index}", mode) for mode in problem.modal.modes if mode.omega]
    tables = [
        *_grid("Sensitivity of the natural frequencies: (p/ω)·∂ω/∂p", [
            (head, {maths(Name(name)): logarithmic(found.values[name], rates[mode.index], float(mode.omega))
                    for name, rates in found.omega.items()}) for head, mode in heads], _rate),
        *_grid("∂ω/∂p [rad/s per unit of p]", [
            (head, {_with_unit(problem, name): rates[mode.index] for name, rates in found.omega.items()})
            for head, mode in heads], _rate),
        *_grid("Sensitivity of the damping ratios: ∂ζ/∂p [per unit of p]", [
            (f"mode {one.mode.index}", {_with_unit(problem, name): rate for name, rate in one.zeta.items()})
            for one in _one_of_each(found.damped) if one.zeta is not None], _rate)]
    remarks = [paragraph(remark) for remark in _remarks(found)]
    if not tables:
        tables = section("Sensitivities", *remarks)
    elif remarks:
        tables[-1] = tables[-1]._replace(blocks=(*tables[-1].blocks, *remarks))
    yield from tables


def _one_of_each(damped):
    """The damped sensitivities, one of each mode."""
    return {one.mode.index: one for one in damped or ()}.values()


def _with_unit(problem, name):
    unit = units.text(problem.spec.dimensions.of(name))
    return maths(Name(name), *[Words(f" [{unit}]")] * bool(unit))


def _rate(value):
    return "–" if value is None else figure(value, digits=5)


def _remarks(found):
    """What has to be said of a table of sensitivities."""
    if not found.values:
        yield "There are no sensitivities: no number of this scene has a name under `parameters`."
    for group in found.coinciding:
        yield (f"Modes {_listed(group)} have one frequency, which splits as a parameter changes: their derivatives "
               "are in ascending order, as it grows.")
    for why in found.refused.values():
        yield why[0].upper() + why[1:] + "."
    several = dict.fromkeys(one.mode.index for one in found.damped or () if one.eigenvalue is None)
    if several:
        yield f"The eigenvalues of damped mode {_listed(several)} are not simple: they have no derivative."
    if found.remark:
        yield found.remark[0].upper() + found.remark[1:] + "."


# estimates


def estimates(problem, _):
    require_numbers(problem, "estimates")
    title = "Estimates of the lowest natural frequency"
    try:
        found = problem.modal.estimates
    except PhysicsError as error:
        yield from section(title, paragraph(f"None: {error.message}."))
        return
    rows = (("Rayleigh (from above)", figure(found.rayleigh), _off(found.rayleigh, found.omega)),
            ("exact", figure(found.omega), ""),
            ("Dunkerley (from below)", figure(found.dunkerley), _off(found.dunkerley, found.omega)))
    deflection = [maths(Name(name), " = ", figure(x, digits=4)) for name, x in list(found.deflection.items())[:ROWS]]
    alone = [f"{name}: {figure(x)} rad/s" for name, x in list(found.alone.items())[:ROWS]]
    yield from section(
        title, TableBlock(("", "ω [rad/s]", "error"), rows),
        paragraph("Rayleigh's shape is the static deflection ", *separated(deflection, ",  "))
        if len(found.deflection) > 1 else None,
        paragraph("Dunkerley: ", maths("1/ω² = Σ 1/ω_j²"), ", with the inertia of one alone ", ",  ".join(alone))
        if len(found.alone) > 1 else None)


def _off(value, exact):
    off = 100 * (value / exact - 1)
    return "0 %" if abs(off) < NOTHING else f"{off:+.2g} %".replace("-", "−")

