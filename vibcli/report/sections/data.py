"""Results as plain data with the documented keys of --json: SI units, null where there is nothing."""

from fractions import Fraction
from math import tau

from vibcli.notation.equation_sides import equation
from vibcli.notation.latex import latex
from vibcli.notation.scene_language import language
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import TooLong, expanded
from vibcli.symbolic.rationals import ONE

ROUNDING = 1e-13        # of the terms that add up to a coefficient, which is zero then


def energies_data(problem):
    """{T, V, Phi} as expressions of the scene language."""
    return {key: language(node) for key, node in problem.symbolic.energies.items()}


def equations_data(problem):
    """[{coordinate, text, latex, linear_text, linear_latex, left_out}]."""
    equations, loose = problem.symbolic.equations, problem.system.loose
    found = []
    for i, name in enumerate(equations.names):
        entry = {"coordinate": name, "text": None, "latex": None}
        if equations.full:
            entry["text"] = equation(loose, equations.full[i], language)
            entry["latex"] = equation(loose, equations.full[i], latex)
        text, tex, missing = None, None, None
        if name in problem.scene.coordinates and not equations.refusal:
            row = problem.scene.coordinates.index(name)
            text, tex = linear_row(problem, equations, row)
            missing = language(equations.left_out[row]) if row in equations.left_out else None
        found.append(entry | {"linear_text": text, "linear_latex": tex, "left_out": missing})
    return found


def linear_row(problem, equations, i):
    """The equation of small oscillations of coordinate i: (text, LaTeX), in letters or with numbers."""
    if equations.in_letters:
        right = equations.drive.get(i, problem.scene.table.zero)
        return tuple(f"{write(equations.linear[i])} = {write(right)}" for write in (language, latex))
    if problem.numeric.has_free_symbols:
        return None, None
    matrices = equations.M, equations.C, equations.G, equations.K
    row, drive = numeric_row(problem, matrices, i), numeric_drive(problem, equations, i)
    return tuple(f"{joined(row, times, write)} = {joined(drive, times, write)}"
                 for times, write in (("*", language), (r" \, ", latex)))


def numeric_row(problem, matrices, i):
    """[(coefficient, symbol node)] of a linear equation in numbers, of the matrices M, C, G, K."""
    scene, (M, C, G, K) = problem.scene, matrices
    row = []
    kinds = ((M,), scene.a), ((C, G), scene.v), ((K,), scene.q)
    for parts, symbols in kinds:
        for j, symbol in enumerate(symbols):
            value = float(sum(matrix.get((i, j), 0.0) for matrix in parts))
            if value:
                row.append((value, symbol))
    return row


def numeric_drive(problem, equations, i):
    """[(coefficient, function of the time)] of what drives coordinate i; the time function is 1 where it is a load
    without letters."""
    node = equations.drive.get(i)
    if node is None:
        return []
    row, sizes, table, time = {}, {}, problem.scene.table, problem.scene.time.mask
    for monomial, value in _multiplied_out(problem, node).items():
        moving = table.product(*(pair for pair in monomial if pair[0].mask & time))
        fixed = table.product((table.number(value), ONE), *(pair for pair in monomial if not pair[0].mask & time))
        part = evaluate([fixed], Floats, problem.configuration.at_rest)[0]
        row[moving], sizes[moving] = row.get(moving, 0.0) + part, sizes.get(moving, 0.0) + abs(part)
    return [(value, moving) for moving, value in row.items() if abs(value) > ROUNDING * sizes[moving]]


def _multiplied_out(problem, node):
    """{monomial: coefficient} of a function of the time; where its letters make it too long, with their numbers."""
    try:
        return expanded(node)
    except TooLong:
        time, table = problem.scene.time.mask, problem.scene.table
        fixed = [part for part in _beside(node, time) if part.op != "number"]
        numbers = evaluate(fixed, Floats, problem.configuration.at_rest)
        known = {part: table.number(Fraction(x)) for part, x in zip(fixed, numbers, strict=True)}
        return expanded(substitute([node], known)[0])


def _beside(node, time):
    """The largest parts of sums and products in a node that do not depend on the time."""
    if not node.mask & time:
        yield node
    elif node.op in ("sum", "product"):
        for part, _ in node.args:
            yield from _beside(part, time)


def joined(row, times, write, minus="-"):
    """Σ coefficient·symbol as text."""
    parts = []
    for value, symbol in row:
        sign = (minus if value < 0 else "") if not parts else (f" {minus} " if value < 0 else " + ")
        size = f"{abs(value):.6g}"
        size = write.numeral(size) if write is latex else size      # 1.2e+06 is no number in LaTeX
        factor = "" if abs(value) == 1 else f"{size}{times}"
        parts.append(sign + (size if symbol.op == "number" else factor + write(symbol)))
    return "".join(parts) or "0"


def matrices_data(problem):
    """{M, C, G, K}: lists of rows, of numbers or of expressions; null where absent."""
    symbolic = problem.numeric.has_free_symbols
    n = len(problem.scene.coordinates)
    if symbolic:
        known = problem.symbolic.matrices if problem.symbolic.linearisable else [{}] * 4
        matrices = dict(zip("MCGK", known, strict=True))
    else:
        matrices = dict(zip("MCGK", problem.configuration.linear_system.matrices(), strict=True))
    zero = "0" if symbolic else 0.0
    return {key: [[_entry(matrix.get((i, j), zero), symbolic) for j in range(n)] for i in range(n)] if matrix else None
            for key, matrix in matrices.items()}


def _entry(value, symbolic):
    if not symbolic:
        return float(value)
    return value if isinstance(value, str) else language(value)


def sticking_data(problem):
    """{conditions: [equations and inequalities], from, to}: where dry friction holds the scene at rest, and of one
    coordinate in numbers a stretch of such places."""
    from math import inf, isfinite

    from vibcli.mechanics.equilibrium.dry_friction import span

    found, table = problem.system.sticking, problem.scene.table
    told = []
    for row in found.rows:
        if row.within is not None:
            told.append(f"abs({language(row.b)}) <= {language(row.within)}")
            continue
        told.append(language(table.sum((row.b, ONE), *((a * sigma, ONE) for sigma, a in row.held.items()))) + " = 0")
        told += [f"abs({language(sigma)}) <= {language(found.bounds[sigma])}" for sigma in row.held]
    ends = None if problem.numeric.has_free_symbols else span(problem.configuration, found)
    low, high = (ends.low, ends.high) if ends is not None else (inf, inf)
    return {"conditions": list(dict.fromkeys(told)), "from": low if isfinite(low) else None,
            "to": high if isfinite(high) else None}


def reactions_data(problem):
    """{signal: value} of the forces in equilibrium; null where statics leaves one open."""
    return {reaction.signal: reaction.value for reaction in problem.configuration.reactions}


def equilibrium_data(problem):
    """{coordinates: {name: value}, dependent: {name: value}, from_start, stable, residual, condition, warning}."""
    if problem.numeric.has_free_symbols:
        from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters

        values = equilibrium_in_letters(problem.symbolic)
        coordinates = {name: language(node) for name, node in values.items()}
        dependent = {name: language(node) for name, node in problem.scene.dependent.items()}
        return {"coordinates": coordinates, "dependent": dependent,
                **dict.fromkeys(("from_start", "stable", "residual", "condition", "warning"))}
    from vibcli.analyses.modal.bifurcation_distance import bifurcation_warning, stiffness_condition
    from vibcli.quantities.equilibrium import is_stable

    found, condition = problem.configuration.equilibrium, stiffness_condition(problem.modal)
    values = {name: found.values[name] for name in problem.scene.coordinates}
    from_start = found.from_start and {name: found.from_start[name] for name in values}
    return {"coordinates": values, "dependent": problem.configuration.dependent_values, "from_start": from_start,
            "stable": is_stable(problem), "residual": found.residual, "condition": condition,
            "warning": bifurcation_warning(condition)}


def modes_data(problem, modes, normalise="first", write=float):
    """The undamped modes."""
    names = problem.scene.coordinates
    found = []
    for mode in modes:
        omega = None if mode.omega is None else write(mode.omega)
        moving = mode.omega is not None and mode.omega != 0
        shape = problem.modal.shape(mode, normalise)
        found.append({
            "index": mode.index, "omega": omega,
            "frequency": None if mode.omega is None else write(mode.omega / turn(mode.omega)),
            "period": write(turn(mode.omega) / mode.omega) if moving else None,
            "growth_rate": None if mode.growth_rate is None else write(mode.growth_rate),
            "shape": {name: amplitude(value, write) for name, value in zip(names, shape, strict=True)},
            "error": float(mode.error)})
    return found


def turn(value):
    """2π in the arithmetic of a value."""
    if isinstance(value, (int, float)):
        return tau
    import mpmath

    return 2 * mpmath.pi


def damped_data(problem, modes, normalise="first", write=float):
    """The damped modes, or None."""
    if modes is None:
        return None
    names = problem.scene.coordinates

    def maybe(value):
        return None if value is None else write(value)

    found = []
    for mode in modes:
        shape = problem.modal.shape(mode, normalise)
        found.append({
            "index": mode.index, "eigenvalue": [write(mode.eigenvalue.real), write(mode.eigenvalue.imag)],
            "omega": maybe(mode.omega), "zeta": maybe(mode.zeta), "omega_d": maybe(mode.omega_d),
            "omega_d_where": None, "decay": maybe(mode.decay), "growth_rate": maybe(mode.growth_rate),
            "shape": {name: amplitude(value, write) for name, value in zip(names, shape, strict=True)},
            "error": float(mode.error)})
    return found


def amplitude(value, write):
    if isinstance(value, complex) or hasattr(value, "_mpc_"):
        return [write(value.real), write(value.imag)] if value.imag else write(value.real)
    return write(value)


def frequencies_data(problem, normalise="first", digits=None):
    """What `vibcli frequencies --json` prints."""
    found = {"equilibrium": equilibrium_data(problem), "matrices": matrices_data(problem)}
    if "reactions" in problem.spec.get("find", ()) and not problem.numeric.has_free_symbols:
        found["reactions"] = reactions_data(problem)
    if problem.numeric.has_free_symbols:
        from vibcli.report.sections.closed_forms import closed_data

        return found | closed_data(problem)
    if digits is None:
        return found | {"modes": modes_data(problem, problem.modal.modes, normalise),
                        "damped": damped_data(problem, problem.modal.damped, normalise)}
    import mpmath

    with mpmath.workdps(digits + 15):
        modes, damped = problem.modal.to_digits(digits)

        def write(value):
            return mpmath.nstr(mpmath.mpf(value), digits, strip_zeros=False) if value else "0"

        return found | {"modes": modes_data(problem, modes, normalise, write),
                        "damped": damped_data(problem, damped, normalise, write)}
