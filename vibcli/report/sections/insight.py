"""Shares, sensitivities and estimates, as sections of a report and as data: only where they are asked for."""

from vibcli.base import units
from vibcli.base.errors import PhysicsError
from vibcli.language.parameters import require_values
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, TableBlock, Words, maths, paragraph, section, separated
from vibcli.report.keys import Key, data

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


def insight_data(problem, words):
    """{word: what it found} of those that are asked for."""
    for word in words:
        require_numbers(problem, word)
    return data([key for key in INSIGHT.of if key.name in words], problem)


def require_numbers(problem, word):
    """Refuse a scene with symbols."""
    if problem.numeric.has_free_symbols:
        require_values(problem.scene.parameters, f"`{word}`")


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


SHARES = Key("shares", "whose energy each mode has, in fractions of one; negative those of what lowers the stiffness",
             lambda problem: problem.modal.shares, of=(
    Key("modes", "a list, one entry to each mode", lambda found: [
        {"index": i, "potential": found.potential[i], "kinetic": found.kinetic[i]} for i in found.kinetic], each=(
            Key("index", "number of the mode"),
            Key("potential", "{name of a spring, `tension of` it, `the weights` or `written out`: share}; empty of a "
                "rigid mode"),
            Key("kinetic", "{name of a body, or `written out`: share}"))),
    Key("damped", "a list, one entry to each eigenvalue; null where nothing damps",
        lambda found: found.dissipation, each=(
            Key("index", "number of the damped mode", lambda one: one[0].index),
            Key("dissipation", "{name of a damper: its share of the energy that is lost}", lambda one: one[1])))))


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


def logarithmic(value, rate, omega):
    """(p/ω) ∂ω/∂p; None where there is no derivative."""
    return None if rate is None else value * rate / omega


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


def _sensitivities(problem):
    found = problem.modal.sensitivities
    omega = {mode.index: float(mode.omega) for mode in problem.modal.modes if mode.omega}
    entries = []
    for name, value in found.values.items():
        modes = [(i, rate, logarithmic(value, rate, omega[i])) for i, rate in found.omega.get(name, {}).items()]
        damped = None if found.damped is None or name in found.refused else [
            (one.mode.index, one.eigenvalue[name], one.zeta and one.zeta[name])
            for one in found.damped if one.eigenvalue]
        entries.append(PARAMETERS.row(name, value, modes, damped, found.refused.get(name)))
    return SENSITIVITIES.row(entries, found.coinciding, found.remark)


PARAMETERS = Key("parameters", "a list, one entry to each parameter", each=(
    Key("parameter", "its name"),
    Key("value", "its value p"),
    Key("modes", "a list, one entry to each mode that oscillates", each=(
        Key("index", "number of the mode", lambda one: one[0]),
        Key("omega", "derivative of omega by p; null of gyroscopic modes that coincide", lambda one: one[1]),
        Key("logarithmic", "that derivative times p/omega", lambda one: one[2]))),
    Key("damped", "a list, one entry to each simple eigenvalue; null where nothing damps", each=(
        Key("index", "number of the damped mode", lambda one: one[0]),
        Key("eigenvalue", "[re, im] of the derivative of the eigenvalue by p",
            lambda one: [one[1].real, one[1].imag]),
        Key("zeta", "derivative of zeta by p; null where there is no zeta", lambda one: one[2]))),
    Key("refusal", "why there is no derivative by p, or null")))
SENSITIVITIES = Key("sensitivities", "exact derivatives by the parameters that no others define, the shift of the "
                    "equilibrium included", _sensitivities, of=(
    PARAMETERS,
    Key("coinciding", "lists of the modes whose frequencies coincide: their derivatives are those of the frequencies "
        "in ascending order as p grows"),
    Key("refusal", "why there are none of the damped modes, or null")))


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



def _estimates(problem):
    try:
        found = problem.modal.estimates
    except PhysicsError as error:
        return ESTIMATES.row(*[None] * 5, error.message)
    return ESTIMATES.row(found.omega, found.rayleigh, found.dunkerley, found.deflection, found.alone, None)


ESTIMATES = Key("estimates", "of the lowest natural frequency; null each where the bounds do not hold", _estimates, of=(
    Key("omega", "its exact value"),
    Key("rayleigh", "Rayleigh's quotient of the static deflection, an upper bound of omega"),
    Key("dunkerley", "Dunkerley's lower bound of omega"),
    Key("deflection", "{coordinate: static deflection}, the largest being 1"),
    Key("alone", "{name of a body: omega with its inertia alone}, from which Dunkerley's bound is made"),
    Key("refusal", "why the bounds do not hold, or null")))
INSIGHT = Key("insight", "only where `find` or --insight asks for it", of=(SHARES, SENSITIVITIES, ESTIMATES))
