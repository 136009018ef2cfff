"""Names and dimensions of a whole file: which names are parameters, which coordinates, and what each measures."""

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.spelling import nearest
from vibcli.language.dimension_check import check, check_whole_literal
from vibcli.language.named_place import NamedPlace
from vibcli.language.reader import Record
from vibcli.language.record_calls import call_records, record_dimensions
from vibcli.language.sections.initial import RELEASED
from vibcli.quantities.quantity import dimension
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import DimensionCheck, constant, names_in
from vibcli.symbolic.syntax import NameRef, Number, Sum

MOST_COORDINATES = 2000


def settle(spec, reader):
    """Settle the names and dimensions of `spec`; whatever does not fit goes to reader.diagnostics."""
    before = len(reader.diagnostics)
    spec.dimensions = units.Dimensions()
    spec.used, spec.counts, spec.asked_dimension = set(), None, None
    spec.coordinates = _coordinates(spec, reader)
    call_records(spec, reader)
    _references(spec, reader)
    _named_places(spec, reader)
    _units_of_symbols(spec, reader)
    expected = [answer.expected for answer in spec.answers] + [answer.asked for answer in spec.answers]
    apart = set(map(id, expected)) | {id(a.rtol) for a in spec.answers}
    apart |= {id(side) for record in (spec.get("choose") or {}).values() for side in record["so"].sides}
    record_dimensions(spec)
    circular = _parameters(spec, reader)
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
            check(spec, reader, expression, names if local is None else {**names, local[0]: None}, expression.dimension,
                  local)
    for expression in (*reader.expressions, *(p["value"] for p in spec.parameters.values() if "value" in p)):
        if isinstance(expression.tree, (Number, Sum)):
            check_whole_literal(spec, reader, expression)
    if not circular:
        _cycles(spec, reader, apart | parameters)
    if spec.choices and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.choices import check_choices

        check_choices(spec, reader)
    if spec.get("find") and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.quantity_check import check_questions

        check_questions(spec, reader, *spec.get("find").signals)
    if spec.answers and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.answer_check import check_answers

        check_answers(spec, reader)


def _cycles(spec, reader, apart):
    """Cycles (Hz) stand nowhere where radians are due; the expressions in `apart` are no such places, or come later."""
    from vibcli.reader.cycle_check import check_radians, check_terms, uses_cycles

    if uses_cycles(spec, reader):
        values = [record["value"] for record in spec.parameters.values() if "value" in record]
        bounds = [record[key] for record in spec.choices.values() for key in ("from", "to") if key in record]
        for expression in (*values, *bounds):
            check_terms(spec, reader, expression)
        apart = apart | set(map(id, bounds))
        for expression in reader.expressions:
            if id(expression) not in apart:
                (check_terms if expression.unit == "Hz" else check_radians)(spec, reader, expression)


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
        if isinstance(tree, NameRef) and not tree.primes and tree.name not in (*spec.parameters, "t", "pi"):
            found.setdefault(tree.name, Record(None, tree.name, motion.where, {}, {}))
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
    spaces = {space: dict.fromkeys(spec.named.get(space, ())) for space in ("points", "bodies", "surfaces", "forces")}
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
        if namespaces == ("points",) and name.text in spaces["bodies"]:
            reader.report(name.where, f"'{name.text}' is a body, expected {wants}",
                          "name the place under `points`, and draw both there")
            continue
        if name.text == "ground" and "points" in namespaces and "place" in wants:
            reader.report(name.where, f"expected {wants}, found 'ground'", "a place on the ground is written [x, y]")
            continue
        kind = _KINDS.get(namespaces[0] if len(namespaces) == 1 else None, "point or body")
        reader.report(name.where, f"there is no {kind} {quoted(name.text)}",
                      nearest(name.text, valid) or f"expected {wants}")


def _named_places(spec, reader):
    """Every named place is that at which the point is drawn; points may be drawn at points, but not in a circle."""
    points = spec.get("points") or {}
    for place in reader.named_places:
        at, passed = place, []
        while isinstance(at, NamedPlace) and at.name.text in points and at.name.text not in passed:
            passed.append(at.name.text)
            at = points[at.name.text]["at"]
        if isinstance(at, NamedPlace) and at.name.text in passed:
            reader.report(place.name.where, f"the place of '{passed[0]}' is not given: it is drawn at "
                          + " → ".join(f"'{name}'" for name in [*passed[1:], at.name.text]),
                          "give one of these points a place [x, y]")
        elif at is not place:
            place[:] = at


_KINDS = {"points": "point", "surfaces": "surface", "forces": "force", "bodies": "body", "coordinates": "coordinate"}


def _units_of_symbols(spec, reader):
    for name, record in spec.parameters.items():
        if "unit" in record:
            dimension = DimensionCheck(spec.dimensions, None).dimension(parse("1 " + record["unit"]))
            spec.dimensions.equate(spec.dimensions.unknown(name), dimension)


def _parameters(spec, reader):
    """Dimensions of the parameters that are given; are there circles among their definitions?"""
    circular = False
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
        circular = True
    return circular


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
    for name, value in spec.get("initial").values.items() if spec.get("initial") else ():
        if name != RELEASED:
            plain = name.rstrip("'")
            value.dimension = units.times(spec.dimensions.unknown(plain), units.TIME, -(len(name) - len(plain)))
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
