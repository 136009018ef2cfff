"""Names and dimensions of a whole file: which names are parameters, which coordinates, and what each measures."""

from vibcli import units
from vibcli.algebra.meaning import (
    ANY,
    DimensionCheck,
    constant,
    literals_in,
    names_in,
    whole_literal,
)
from vibcli.algebra.parse import ExpressionError, parse
from vibcli.errors import Diagnostic
from vibcli.fields import Record, nearest
from vibcli.questions import dimension


def resolve(spec, reader):
    """Settle the names and dimensions of `spec`; whatever does not fit goes to reader.diagnostics."""
    spec.dimensions = units.Dimensions()
    spec.used = set()
    spec.coordinates = _coordinates(spec, reader)
    _references(spec, reader)
    _units_of_symbols(spec, reader)
    expected = [answer.expected for answer in spec.answers] + [answer.asked for answer in spec.answers]
    apart = set(map(id, expected)) | {id(a.rtol) for a in spec.answers}
    spec.free_numbers = not any(part[4] for e in reader.expressions for part in literals_in(e.tree)) and not any(
        "unit" in p for p in spec.parameters.values())
    _parameters(spec, reader)
    _matrices(spec, reader)
    _start(spec, reader)
    known = (*spec.parameters, *spec.coordinates)
    parameters = {id(p.get("value")) for p in spec.parameters.values()}
    moving = _moving(spec, reader)
    for expression in reader.expressions:
        if id(expression) not in apart and id(expression) not in parameters:
            names = known if id(expression) in moving else spec.parameters
            check(spec, reader, expression, names, expression.dimension)
    if spec.answers and not reader.diagnostics:
        from vibcli.asking import check_answers

        check_answers(spec, reader)


def _moving(spec, reader):
    """Coordinates may stand in motions, stretches and energies; everything else is of parameters alone."""
    holders = [*(spec.get("springs") or {}).values(), *(spec.get("dampers") or {}).values()]
    energies = spec.get("energies")
    expressions = [*reader.motions, *(record.get("stretch") for record in holders),
                   *(energies.values.values() if energies else ())]
    spec.velocities = {id(expression) for expression in expressions[len(reader.motions) + len(holders):]}
    return set(map(id, expressions))


def _coordinates(spec, reader):
    """{name: Record} in order: the declared ones, then those that motions and energies introduce."""
    found = dict(spec.get("coordinates") or {})
    for name, record in found.items():
        if name in spec.parameters:
            reader.report(record.where, f"'{name}' is a parameter and a coordinate", "rename one of them")
    declared = set(found)
    for motion in reader.motions:
        tree = motion.tree
        if tree[0] == "name" and not tree[4] and tree[3] not in spec.parameters and tree[3] not in ("t", "pi"):
            found.setdefault(tree[3], Record(None, tree[3], motion.where, {}, {}))
    energies = spec.get("energies")
    for expression in energies.values.values() if energies else ():
        for name, primes, start, end in names_in(expression.tree):
            if primes == 1 and name not in spec.parameters:
                found.setdefault(name, Record(None, name, expression.scalar.place(start, end - start), {}, {}))
    matrices = spec.get("matrices")
    if matrices is not None and not declared and not found:
        n = len(next(iter(matrices.values.values())))
        found = {f"x{i + 1}": Record(None, f"x{i + 1}", matrices.where, {}, {}) for i in range(n)}
    if not declared:
        return found
    used = {name for e in reader.expressions for name, _, _, _ in names_in(e.tree)}
    for name, record in found.items():
        if name not in used and matrices is None:
            reader.report(record.where, f"the coordinate '{name}' is not used", "let a motion or an energy depend on it")
    return found


def _references(spec, reader):
    """Every reference must name something of its namespace; points and bodies share one namespace."""
    spaces = {"points": spec.get("points") or {}, "bodies": spec.get("bodies") or {},
              "surfaces": spec.get("surfaces") or {}, "ground": ("ground",)}
    for name, record in spaces["points"].items():
        if name in spaces["bodies"]:
            reader.report(record.where, f"'{name}' is a point and a body", "rename one of them")
    for space in ("points", "bodies"):
        if "ground" in spaces[space]:
            reader.report(spaces[space]["ground"].where, "'ground' is a word of the language and cannot be a name here")
    for name, namespaces, wants in reader.references:
        valid = [word for space in namespaces for word in spaces[space]]
        if name.text not in valid:
            kind = "surface" if namespaces == ("surfaces",) else "body" if namespaces == ("bodies",) else "point or body"
            reader.report(name.where, f"there is no {kind} '{name.text}'",
                          nearest(name.text, valid) or f"expected {wants}")


def _units_of_symbols(spec, reader):
    for name, record in spec.parameters.items():
        if "unit" in record:
            try:
                tree = parse("1 " + record["unit"])
                dimension = DimensionCheck(spec.dimensions, None).dimension(tree)
                spec.dimensions.equate(spec.dimensions.unknown(name), dimension)
            except ExpressionError as error:
                reader.report(record.place("unit"), error.message, error.hint)


def _parameters(spec, reader):
    """Dimensions of the parameters that are given, and no circles among their definitions."""
    for name, record in spec.parameters.items():
        value = record.get("value")
        if value is None:
            continue
        if spec.free_numbers and constant(value.tree) is not None:
            continue
        check(spec, reader, value, spec.parameters, spec.dimensions.unknown(name))
    circle = _circle(spec)
    if circle:
        reader.report(spec.parameters[circle[0]].where, "these parameters are defined by one another: "
                      + " → ".join([*circle, circle[0]]), "give one of them a value")


def _circle(spec):
    """A cycle of definitions, as a list of names; None where there is none."""
    needs = {name: [n for n, _, _, _ in names_in(record["value"].tree) if n in spec.parameters]
             for name, record in spec.parameters.items() if "value" in record}
    done = set()
    for start in needs:
        path, stack = [], [(start, iter(needs.get(start, ())))]
        path.append(start)
        while stack:
            following = next(stack[-1][1], None)
            if following is None:
                stack.pop()
                done.add(path.pop())
            elif following in path:
                return path[path.index(following):]
            elif following not in done:
                path.append(following)
                stack.append((following, iter(needs.get(following, ()))))
    return None


def _matrices(spec, reader):
    """The entry (q, r) of M, C, K has the dimension energy·timeᵖ/(q·r)."""
    matrices = spec.get("matrices")
    if matrices is None:
        return
    names = list(spec.coordinates)
    for key, rows in matrices.values.items():
        for i, row in enumerate(rows[:len(names)]):
            for j, entry in enumerate(row[:len(names)]):
                entry.dimension = dimension(key, (names[i], names[j]), spec.dimensions.unknown)


def _start(spec, reader):
    for name, value in (spec.get("equilibrium") or {}).items():
        if name not in spec.coordinates:
            reader.report(value.where, f"'{name}' is not a coordinate", nearest(name, spec.coordinates))
        value.dimension = spec.dimensions.unknown(name)
    for name, record in spec.coordinates.items():
        if "drawn" in record:
            record["drawn"].dimension = spec.dimensions.unknown(name)


def check(spec, reader, expression, names, expected):
    """Names and dimension of one expression; True where both fit."""
    before = len(reader.diagnostics)
    for name, primes, start, end in names_in(expression.tree):
        if name in names:
            spec.used.add(name)
            _primes(spec, reader, expression, name, primes, start, end)
        elif name != "pi":
            reader.report(expression.scalar.place(start, end - start), *_unknown(spec, name, names))
    _ambiguous(spec, reader, expression)
    if len(reader.diagnostics) > before:
        return False
    try:
        checker = DimensionCheck(spec.dimensions, lambda name, primes: units.times(
            spec.dimensions.of(name), units.TIME, -primes), spec.free_numbers, spec.asked_dimension)
        found = checker.dimension(expression.tree) if expression.tree[0] != "equation" else _sides(checker, expression)
        _fits(spec, reader, expression, found, expected)
    except ExpressionError as error:
        reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
    return len(reader.diagnostics) == before


def _sides(checker, expression):
    tree = expression.tree
    checker.dimension(("sum", tree[1], tree[2], [(1, tree[3]), (1, tree[4])]))
    return ANY


def _fits(spec, reader, expression, found, expected):
    if expected is None or found is ANY or (spec.free_numbers and _only_numbers(expression.tree)):
        return
    wanted = units.name(spec.dimensions.resolve(expected))
    if not spec.dimensions.equate(expected, found):
        message = f"expected {wanted}, found {units.name(spec.dimensions.resolve(found))}"
        literal = whole_literal(expression.tree)
        hint = None
        if literal and not literal[4] and expression.unit:
            hint = f"write the unit: {expression.text} {expression.unit}"
        reader.report(expression.scalar.place(0, len(expression.text)), message, hint)


def _only_numbers(tree):
    return all(name == "pi" for name, _, _, _ in names_in(tree))


def _primes(spec, reader, expression, name, primes, start, end):
    if not primes:
        return
    place = expression.scalar.place(start, end - start)
    if name in spec.parameters:
        reader.report(place, f"'{name}' is a parameter: it has no derivative")
    elif id(expression) not in spec.velocities:
        reader.report(place, "a motion depends on coordinates, not on their derivatives")


def _unknown(spec, name, names):
    if name == "t":
        return "the time t cannot stand here", "scenes are driven by nothing yet: motions and loads do not depend on time"
    if name in spec.coordinates:
        return f"'{name}' is a coordinate: only parameters may stand here", None
    hint = nearest(name, names)
    if names is not spec.parameters and (not hint or hint.startswith("valid")):
        hint = f"a parameter is declared under `parameters:`, a coordinate by a motion such as `slide: {name}`"
    return f"unknown name '{name}'", hint


def _ambiguous(spec, reader, expression):
    """`2 N*m` within a larger expression of a scene that has a name m may mean two things."""
    if whole_literal(expression.tree):
        return
    for literal in literals_in(expression.tree):
        for unit, _, start, end in literal[4][1:]:
            if unit in spec.parameters or unit in spec.coordinates:
                text = expression.text
                head, joined = text[literal[1]:start].rstrip(" *·/"), text[literal[1]:end]
                reader.report(expression.scalar.place(start, end - start),
                              f"'{unit}' is a unit and a name of this scene",
                              f"write ({joined}) for the unit or ({head})*{unit} for the name")


def report_unused(spec, used, diagnostics):
    """An unused parameter is an error, unless it says `unused: allowed`."""
    for name, record in spec.parameters.items():
        if name not in used and record.get("unused") != "allowed":
            diagnostics.append(Diagnostic(record.where, f"the parameter '{name}' is not used",
                                          f"take it out, or write {name}: {{value: …, unused: allowed}}"))
