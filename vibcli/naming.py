"""Names and dimensions of a whole file: which names are parameters, which coordinates, and what each measures."""

import re

from vibcli import units
from vibcli.algebra.meaning import (
    ANY,
    DimensionCheck,
    constant,
    counts_cycles,
    literal_unit,
    literals_in,
    names_in,
    quantities_in,
    whole_literal,
)
from vibcli.algebra.parse import ExpressionError, parse
from vibcli.diagnostics import quoted
from vibcli.questions import dimension
from vibcli.reading import Record, nearest

MOST_COORDINATES = 2000
NO_NUMBERS = ("nan", "inf", "infinity", "null", "none", "true", "false", "yes", "no", "on", "off")


def resolve(spec, reader):
    """Settle the names and dimensions of `spec`; whatever does not fit goes to reader.diagnostics."""
    before = len(reader.diagnostics)
    spec.dimensions = units.Dimensions()
    spec.used = set()
    spec.coordinates = _coordinates(spec, reader)
    _references(spec, reader)
    _units_of_symbols(spec, reader)
    expected = [answer.expected for answer in spec.answers] + [answer.asked for answer in spec.answers]
    apart = set(map(id, expected)) | {id(a.rtol) for a in spec.answers}
    apart |= {id(side) for record in (spec.get("choose") or {}).values() for side in record["so"].sides}
    spec.free_numbers = not any(part[4] for e in reader.expressions for part in literals_in(e.tree)) and not any(
        "unit" in p for p in spec.parameters.values())
    _parameters(spec, reader)
    _matrices(spec, reader)
    _start(spec, reader)
    _bounded(spec, reader)
    known = dict.fromkeys((*spec.parameters, *spec.coordinates, "t"))
    if "t" not in spec.parameters and "t" not in spec.coordinates:
        spec.dimensions.equate(spec.dimensions.unknown("t"), units.TIME)
    parameters = {id(p.get("value")) for p in spec.parameters.values()}
    moving = _moving(spec, reader)
    if "t" in spec.parameters:
        _time_is_taken(spec, reader)
    for expression in reader.expressions:
        if id(expression) not in apart and id(expression) not in parameters:
            names = known if id(expression) in moving else spec.parameters
            local = reader.local_names.get(id(expression))
            check(spec, reader, expression, names if local is None else {**names, local: None}, expression.dimension,
                  local)
    if spec.choices and reader.sound and len(reader.diagnostics) == before:
        from vibcli.choosing import check_choices

        check_choices(spec, reader)
    if spec.answers and reader.sound and len(reader.diagnostics) == before:
        from vibcli.asking import check_answers

        check_answers(spec, reader)


def _time_is_taken(spec, reader):
    """Where loads and motions are written, t is the time."""
    for expression in (*reader.motions, *reader.loads):
        for name, _, start, end in names_in(expression.tree):
            if name == "t":
                reader.report(expression.scalar.place(start, end - start), "'t' would be the time here, and is a "
                              "parameter of this scene", "give the parameter another name")


def _moving(spec, reader):
    """Coordinates and the time may stand in motions, stretches, loads and energies; all else is of parameters."""
    holders = [*(spec.get("springs") or {}).values(), *(spec.get("dampers") or {}).values()]
    energies = spec.get("energies")
    at_speed = [*(energies.values.values() if energies else ()), *reader.loads]
    spec.velocities = set(map(id, at_speed))
    return set(map(id, (*reader.motions, *(record.get("stretch") for record in holders), *at_speed)))


def _coordinates(spec, reader):
    """{name: Record} in order: the declared ones, then those that motions and energies introduce."""
    found = dict(spec.get("coordinates") or {})
    for name, record in found.items():
        if name in spec.parameters:
            reader.report(record.where, f"'{name}' is a parameter and a coordinate", "rename one of them")
    declared = set(found) if reader.sound else ()
    for motion in reader.motions:
        tree = motion.tree
        if tree[0] == "name" and not tree[4] and tree[3] not in spec.parameters and tree[3] not in ("t", "pi"):
            found.setdefault(tree[3], Record(None, tree[3], motion.where, {}, {}))
    energies = spec.get("energies")
    for expression in energies.values.values() if energies else ():
        for name, primes, start, end in names_in(expression.tree):
            if primes == 1 and name not in spec.parameters and name != "t":
                found.setdefault(name, Record(None, name, expression.scalar.place(start, end - start), {}, {}))
    matrices = spec.get("matrices")
    if matrices is not None and not declared and not found:
        n = len(next(iter(matrices.values.values())))
        found = {f"x{i + 1}": Record(None, f"x{i + 1}", matrices.where, {}, {}) for i in range(n)}
    if not declared:
        return found
    used = {name for e in reader.expressions for name, _, _, _ in names_in(e.tree)}
    for name, record in found.items():
        if name not in used and name not in spec.parameters and matrices is None:
            reader.report(record.where, f"the coordinate '{name}' is not used",
                          "let a motion or an energy depend on it")
    return found


def _references(spec, reader):
    """Every reference must name something of its namespace; points and bodies share one namespace."""
    spaces = {space: dict.fromkeys(spec.named.get(space, ())) for space in ("points", "bodies", "surfaces")}
    spaces |= {"ground": {"ground": None}, "coordinates": spec.coordinates}
    for name, record in (spec.get("points") or {}).items():
        if name in spaces["bodies"]:
            reader.report(record.where, f"'{name}' is a point and a body", "rename one of them")
    for name, namespaces, wants in reader.references:
        if any(name.text in spaces[space] for space in namespaces) or (
                namespaces == ("coordinates",) and not reader.sound):
            continue
        valid = [word for space in namespaces for word in spaces[space]]
        if namespaces == ("bodies",) and name.text in spaces["points"]:
            reader.report(name.where, f"'{name.text}' is a point, expected the name of a body",
                          nearest(name.text, valid))
            continue
        if name.text == "ground" and "points" in namespaces and "place" in wants:
            reader.report(name.where, f"expected {wants}, found 'ground'", "a place on the ground is written [x, y]")
            continue
        kind = _KINDS.get(namespaces[0] if len(namespaces) == 1 else None, "point or body")
        reader.report(name.where, f"there is no {kind} {quoted(name.text)}",
                      nearest(name.text, valid) or f"expected {wants}")


_KINDS = {"surfaces": "surface", "bodies": "body", "coordinates": "coordinate"}


def _units_of_symbols(spec, reader):
    for name, record in spec.parameters.items():
        if "unit" in record:
            dimension = DimensionCheck(spec.dimensions, None).dimension(parse("1 " + record["unit"]))
            spec.dimensions.equate(spec.dimensions.unknown(name), dimension)


def _parameters(spec, reader):
    """Dimensions of the parameters that are given, and no circles among their definitions."""
    for name, record in spec.parameters.items():
        value = record.get("value")
        if value is None:
            continue
        if spec.free_numbers and constant(value.tree) is not None:
            continue
        check(spec, reader, value, spec.parameters, spec.dimensions.unknown(name))
    for circle in _circles(spec):
        message = f"'{circle[0]}' is defined by itself" if len(circle) == 1 else (
            "these parameters are defined by one another: " + " → ".join([*circle, circle[0]]))
        reader.report(spec.parameters[circle[0]].where, message, "give one of them a value of its own")


def _circles(spec):
    """Cycles of definitions, as lists of names."""
    needs = {name: [n for n, _, _, _ in names_in(record["value"].tree) if n in spec.parameters]
             for name, record in spec.parameters.items() if "value" in record}
    done, found = set(), []
    for start in needs:
        if start in done:
            continue
        path, stack = {start: 0}, [iter(needs[start])]
        while stack:
            following = next(stack[-1], None)
            if following is None:
                stack.pop()
                done.add(path.popitem()[0])
            elif following in path:
                found.append(list(path)[path[following]:])
            elif following not in done:
                path[following] = len(path)
                stack.append(iter(needs.get(following, ())))
    return found


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
    for record in (spec.get("forces") or {}).values():
        if "value" in record and "coordinate" in record:
            record["value"].dimension = units.times(units.parse_unit("J").dimension,
                                                    spec.dimensions.unknown(record["coordinate"].text), -1)
    for name, value in (spec.get("equilibrium") or {}).items():
        value.dimension = spec.dimensions.unknown(name)
    for name, bounds in spec.get("find").within.items() if spec.get("find") else ():
        for bound in bounds:
            bound.dimension = spec.dimensions.unknown(name)
    for name, record in (spec.get("choose") or {}).items():
        for bound in {"from", "to"} & set(record.values):
            record[bound].dimension = spec.dimensions.unknown(name)
    for name, record in spec.coordinates.items():
        if "drawn" in record:
            record["drawn"].dimension = spec.dimensions.unknown(name)


def _bounded(spec, reader):
    if len(spec.coordinates) > MOST_COORDINATES:
        where = list(spec.coordinates.values())[MOST_COORDINATES].where
        reader.report(where, f"the scene has {len(spec.coordinates)} coordinates; the limit is {MOST_COORDINATES}",
                      "leave coordinates out, or divide the scene")


def check(spec, reader, expression, names, expected, local=None):
    """Names and dimension of one expression; True where both fit. `local`: the name of a length in it alone."""
    before = len(reader.diagnostics)
    named = names_in(expression.tree)
    if not reader.sound and not all(name in names or name in ("pi", "t") for name, *_ in named):
        return True
    for name, primes, start, end in named:
        if name == local and not primes:
            continue
        if name in names:
            spec.used.add(name)
            _primes(spec, reader, expression, name, primes, start, end)
        elif name != "pi":
            reader.report(expression.scalar.place(start, end - start), *_unknown(spec, name, names))
    _ambiguous(spec, reader, expression)
    if not spec.asked_dimension:
        _no_quantities(reader, expression)
    if len(reader.diagnostics) > before:
        return False
    try:
        checker = DimensionCheck(spec.dimensions, lambda name, primes: units.LENGTH if name == local else units.times(
            spec.dimensions.of(name), units.TIME, -primes), spec.free_numbers, spec.asked_dimension, expression.text)
        found = checker.dimension(expression.tree) if expression.tree[0] != "equation" else _sides(checker, expression)
        _fits(spec, reader, expression, found, expected)
        in_cycles = expression.unit == "rad/s" and counts_cycles(expression.tree, cyclic(spec, expression.tree))
        if in_cycles and not spec.asked_dimension:
            reader.report(expression.where, "expected an angular frequency (rad/s), found Hz", "write 2*pi*f")
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
    wanted = units.wanted(expression.unit, spec.dimensions.resolve(expected))
    if not spec.dimensions.equate(expected, found):
        message = f"expected {wanted}, found {_found(expression.tree, spec.dimensions.resolve(found))}"
        reader.report(expression.scalar.place(0, len(expression.text)), message, _unit_hint(spec, expression))


def _found(tree, dimension):
    literal = whole_literal(tree)
    if literal and literal[4]:
        if not dimension and literal[4][0][0] != "%":
            return "an angle (rad)"
        if literal_unit(literal[4]).cycles:
            return "a frequency (Hz)"
    return units.name(dimension)


def _unit_hint(spec, expression):
    """A number without unit: where and how to write it."""
    literal = whole_literal(expression.tree)
    if not expression.unit:
        return None
    if expression.unit == "N/m" and literal and literal_unit(literal[4]).dimension == units.parse_unit("N*m").dimension:
        return "a torsional stiffness is given as `torsion:`"
    if literal and not literal[4]:
        return f"write the unit: {expression.text} {expression.unit}"
    name = expression.tree[3] if expression.tree[0] == "name" else None
    value = spec.parameters[name].get("value") if name in spec.parameters else None
    if name in spec.parameters and value is None:
        return f"'{name}' is {units.name(spec.dimensions.of(name))} in another place"
    literal = value and whole_literal(value.tree)
    return f"give '{name}' its unit: {value.text} {expression.unit}" if literal and not literal[4] else None


def _no_quantities(reader, expression):
    for tree in quantities_in(expression.tree):
        reader.report(expression.scalar.place(tree[1], tree[2] - tree[1]), f"'{tree[3]}' cannot stand here",
                      "what is asked of a scene, such as omega[1], stands under answers")


def cyclic(spec, tree):
    """The parameters named in a tree whose value is in Hz."""
    values = {name: spec.parameters[name].get("value") for name, _, _, _ in names_in(tree) if name in spec.parameters}
    return {name for name, value in values.items() if value is not None and counts_cycles(value.tree)}


def _only_numbers(tree):
    return all(name == "pi" for name, _, _, _ in names_in(tree))


def _primes(spec, reader, expression, name, primes, start, end):
    if not primes:
        return
    place = expression.scalar.place(start, end - start)
    if name in spec.parameters or name not in spec.coordinates:
        what = "a parameter" if name in spec.parameters else "the time"
        reader.report(place, f"'{name}' is {what}: it has no derivative", "only coordinates move")
    elif primes > 1 and any(expression is load for load in reader.loads):
        reader.report(place, "accelerations cannot stand here",
                      "loads depend on coordinates and velocities, constraints on positions")
    elif reader.sound and id(expression) not in spec.velocities:
        reader.report(place, "velocities cannot stand here", "they stand in energies, forces and expected equations")


def _unknown(spec, name, names):
    if name == "t":
        return "the time t cannot stand here", "it stands in motions, driven points, forces, energies and constraints"
    if name in spec.coordinates:
        return f"'{name}' is a coordinate: only parameters may stand here", "write numbers and parameters"
    if name.lower() in NO_NUMBERS:
        return f"'{name}' is not a number", "write a finite number, or nothing at all: then the parameter is a symbol"
    power = re.fullmatch(r"([A-Za-z]+)([2-4])", name)
    if power and power.group(1) in units.UNITS:
        return f"unknown name '{name}'", f"a power of a unit is written {power.group(1)}^{power.group(2)}"
    hint = nearest(name, names)
    if names is not spec.parameters and (not hint or hint.startswith("valid")):
        hint = f"a parameter is declared under `parameters:`, a coordinate by a motion such as `slide: {name}`"
    return f"unknown name '{name}'", hint


def _ambiguous(spec, reader, expression):
    """`2 N*m` within a larger expression of a scene that has a name m may mean two things."""
    if whole_literal(expression.tree):
        return
    for literal in literals_in(expression.tree):
        if _in_brackets(expression.text, literal):
            continue
        for unit, _, start, end in literal[4][1:]:
            if unit in spec.parameters or unit in spec.coordinates:
                text = expression.text
                head, joined = text[literal[1]:start].rstrip(" *·/"), text[literal[1]:end]
                reader.report(expression.scalar.place(start, end - start),
                              f"'{unit}' is a unit and a name of this scene",
                              f"write ({joined}) for the unit or ({head})*{unit} for the name")


def _in_brackets(text, literal):
    """Does a literal stand alone in round brackets?"""
    return text[:literal[1]].rstrip().endswith("(") and text[literal[2]:].lstrip().startswith(")")
