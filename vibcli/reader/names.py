"""Names and dimensions of a whole file: which names are parameters, which coordinates, and what each measures."""

from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.language.dimension_check import check, check_whole_literal
from vibcli.language.named_place import NamedPlace
from vibcli.language.reader import Expression, Reader, Record
from vibcli.language.record_calls import own
from vibcli.language.spec import MEMBERS
from vibcli.quantities.dimensions import asked_dimension
from vibcli.reader.cycles_used import uses_cycles
from vibcli.reader.references import check_references
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import DimensionCheck, constant
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Scalar
    from vibcli.language.spec import Spec

FEW_COORDINATES, MOST_COORDINATES = 2000, 200_000
COUPLING = ("constraints", "energies", "matrices", *MEMBERS)


def settle(spec: "Spec", reader: Reader) -> "Spec":
    """`spec` with its coordinates, the dimensions of all names, and what is asked; whatever does not fit goes to
    reader.diagnostics."""
    before = len(reader.diagnostics)
    spec = spec._replace(dimensions=units.Dimensions(), coordinates=_coordinates(spec, reader), used=set(), counts={})
    if spec.get("records"):
        _records(spec, reader)
    check_references(spec, reader)
    _named_places(spec, reader)
    _units_of_symbols(spec)
    if reader.members and reader.sound:
        from vibcli.reader.member_names import name_motions

        name_motions(spec, reader)
    expected = {answer.expected.scalar for answer in spec.answers}
    apart = expected | {answer.rtol.scalar for answer in spec.answers if answer.rtol is not None}
    apart |= reader.later | {side.scalar for record in (spec.get("choose") or {}).values()
                             for side in record["so"].sides}
    circular = _parameters(spec, reader)
    due = {**_matrices(spec), **_start(spec), **_along(spec, reader)}
    if spec.get("variants") is not None:
        from vibcli.reader.variants import varied

        due |= {value.scalar: spec.dimensions.unknown(name) for value, name in varied(spec)}
    _bounded(spec, reader)
    if "t" not in spec.parameters and "t" not in spec.coordinates:
        spec.dimensions.equate(spec.dimensions.unknown("t"), units.TIME)
    values = {value.scalar: value for value in (p.get("value") for p in spec.parameters.values()) if value is not None}
    apart |= set(values)
    moving = _moving(spec, reader)
    reader.at_speed.update(expected)
    if "t" in spec.parameters:
        _time_is_taken(reader)
    _dimensions(spec, reader, apart, moving, due)
    for expression in (reader.expressions | values).values():
        if expression.parts.whole and len(expression.parts.whole.units) > 1:
            check_whole_literal(spec, reader, expression)
    if not circular:
        _cycles(spec, reader, apart)
    spec = spec._replace(asked_dimension=asked_dimension)
    return _asked(spec, reader, before)


def _dimensions(spec: "Spec", reader: Reader, apart: "set[Scalar]", moving: "set[Scalar]",
                due: "dict[Scalar, units.Dimension]") -> None:
    """Expressions fit together, and measure what is due where they stand; those in `apart` are no such, or come later;
    in `moving` ones stand coordinates and the time."""
    known = dict.fromkeys((*spec.parameters, *spec.coordinates, "t"))
    for scalar, expression in reader.expressions.items():
        if scalar not in apart:
            names = known if scalar in moving else spec.parameters
            local = reader.local_names.get(scalar)
            check(spec, reader, expression, names if local is None else {**names, local[0]: None},
                  due.get(scalar, expression.dimension), local)


def _asked(spec: "Spec", reader: Reader, before: int) -> "Spec":
    """With what is chosen, looked for and asked, each checked where there were no more than so many diagnostics."""
    if spec.choices and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.choices import check_choices

        spec = check_choices(spec, reader)
    if spec.get("find") and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.quantity_check import check_questions

        check_questions(spec, reader, *spec.get("find").signals, spec.get("find").amplitudes)
    if spec.answers and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.answer_check import checked

        spec = spec._replace(answers=[checked(spec, reader, answer) for answer in spec.answers])
    if spec.get("variants") is not None and reader.sound and len(reader.diagnostics) == before:
        from vibcli.reader.variants import with_variants

        spec = with_variants(spec, reader)
    return spec


def _cycles(spec: "Spec", reader: Reader, apart: "set[Scalar]") -> None:
    """Cycles (Hz) stand nowhere where radians are due; the expressions in `apart` are no such places, or come later."""
    if uses_cycles(spec, reader):
        from vibcli.reader.cycle_check import check_radians, check_terms
        values = [record["value"] for record in spec.parameters.values() if "value" in record]
        bounds = [record[key] for record in spec.choices.values() for key in ("from", "to") if key in record]
        for expression in (*values, *bounds):
            check_terms(spec, reader, expression)
        apart = apart | {bound.scalar for bound in bounds}
        for scalar, expression in reader.expressions.items():
            if scalar not in apart:
                (check_terms if expression.unit == "Hz" else check_radians)(spec, reader, expression)


def _time_is_taken(reader: Reader) -> None:
    """A parameter t in loads and motions, where it would be the time."""
    for expression in (reader.motions | reader.loads).values():
        for name, _, start, end in expression.parts.names:
            if name == "t":
                reader.report(expression.scalar.place(start, end - start), "'t' would be the time here, and is a "
                              "parameter of this scene", "give the parameter another name")


def _moving(spec: "Spec", reader: Reader) -> "set[Scalar]":
    """Scalars in which coordinates and the time may stand: motions, stretches, loads and energies, and in these two
    velocities; all else is of parameters."""
    reader.at_speed.update(reader.loads, (expression.scalar for expression in (spec.get("energies") or {}).values()))
    return {*reader.motions, *reader.at_speed, *(record["stretch"].scalar for record in spec.connections
                                                 if "stretch" in record)}


def _coordinates(spec: "Spec", reader: Reader) -> dict[str, Record]:
    """{name: Record} in order: the declared ones, then those that motions and energies introduce."""
    found = dict(spec.get("coordinates") or {})
    for name, record in found.items():
        if name in spec.parameters:
            reader.report(record.where, f"'{name}' is a parameter and a coordinate", "rename one of them")
    declared = set(found) if reader.sound else ()
    for motion in reader.motions.values():
        tree = motion.tree
        if isinstance(tree, NameRef) and not tree.primes and tree.name not in (*spec.parameters, "t", "pi"):
            found.setdefault(tree.name, Record(None, tree.name, motion.where, {}, {}))
    for expression in (spec.get("energies") or {}).values():
        for name, primes, start, end in expression.parts.names:
            if primes == 1 and name not in spec.parameters and name != "t":
                found.setdefault(name, Record(None, name, expression.scalar.place(start, end - start), {}, {}))
    matrices = spec.get("matrices")
    if matrices is not None and not declared and not found:
        n = len(next(iter(matrices.values())))
        found = {f"x{i + 1}": Record(None, f"x{i + 1}", matrices.where, {}, {}) for i in range(n)}
    if not declared:
        return found
    used = {name for e in reader.expressions.values() for name, *_ in e.parts.names}
    for name, record in found.items():
        if name not in used and name not in spec.parameters and matrices is None:
            reader.report(record.where, f"the coordinate '{name}' is not used",
                          "let a motion or an energy depend on it")
    return found


def _records(spec: "Spec", reader: Reader) -> None:
    """A record is neither a parameter nor a coordinate. Its values have its unit; without one they are pure numbers, in
    a scene without units anything."""
    from vibcli.language.sections.record import dimension

    for name, record in spec.get("records").items():
        kind = "parameter" if name in spec.named.get("parameters", ()) else "coordinate"
        if kind == "parameter" or name in spec.coordinates:
            reader.report(record.where, f"'{name}' is a record and a {kind}", "rename one of them")
        measured = dimension(record)
        if measured is not None or not spec.free_numbers:
            spec.dimensions.equate(spec.dimensions.unknown(own(name)), units.NONE if measured is None else measured)


def _named_places(spec: "Spec", reader: Reader) -> None:
    """Every named place is that at which the point is drawn; points may be drawn at points, but not in a circle."""
    points = spec.get("points") or {}
    for place in reader.named_places:
        at, passed = place, []
        if place.name.text in (spec.get("member_points") or {}):
            reader.report(place.name.where, f"'{place.name.text}' is on a member: it has no place [x, y]",
                          "write the place itself")
        while isinstance(at, NamedPlace) and at.name.text in points and at.name.text not in passed:
            passed.append(at.name.text)
            at = points[at.name.text]["at"]
        if isinstance(at, NamedPlace) and at.name.text in passed:
            reader.report(place.name.where, f"the place of '{passed[0]}' is not given: it is drawn at "
                          + " → ".join(f"'{name}'" for name in [*passed[1:], at.name.text]),
                          "give one of these points a place [x, y]")
        elif at is not place:
            place[:] = at


def _units_of_symbols(spec: "Spec") -> None:
    for name, record in spec.parameters.items():
        if "unit" in record:
            dimension = DimensionCheck(spec.dimensions, None).dimension(parse("1 " + record["unit"]))
            spec.dimensions.equate(spec.dimensions.unknown(name), dimension)


def _parameters(spec: "Spec", reader: Reader) -> bool:
    """Dimensions of the parameters that are given; are there circles among their definitions?"""
    circular = False
    for name, record in spec.parameters.items():
        value = record.get("value")
        if value is None or (spec.free_numbers and constant(value.tree) is not None):
            continue
        check(spec, reader, value, spec.parameters, spec.dimensions.unknown(name))
    for circle in _circles(spec):
        message, which = (f"'{circle[0]}' is defined by itself", "it") if len(circle) == 1 else (
            "these parameters are defined by one another: " + " → ".join([*circle, circle[0]]), "one of them")
        reader.report(spec.parameters[circle[0]].where, message, f"give {which} a value of its own")
        circular = True
    return circular


def _circles(spec: "Spec") -> list[list[str]]:
    """Cycles of definitions, as lists of names."""
    needs = {name: [n for n, *_ in record["value"].parts.names if n in spec.parameters]
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


def _matrices(spec: "Spec") -> "dict[Scalar, units.Dimension]":
    """{scalar: dimension} of the entries of M, C, K."""
    if "matrices" not in spec.sections:
        return {}
    from vibcli.quantities.matrices import entry_dimension

    names, matrices = list(spec.coordinates), spec.get("matrices")
    return {entry.scalar: entry_dimension(key, spec.dimensions.unknown(q), spec.dimensions.unknown(r))
            for key, rows in matrices.items() for q, row in zip(names, rows, strict=False)
            for r, entry in zip(names, row, strict=False)}


def _start(spec: "Spec") -> "dict[Scalar, units.Dimension]":
    """{scalar: dimension} of what is measured as coordinates and chosen parameters are."""
    unknown, initial = spec.dimensions.unknown, spec.get("initial") or {}
    pairs = [(record["value"], units.times(units.ENERGY, unknown(record["coordinate"].text), -1))
             for record in (spec.get("forces") or {}).values() if "value" in record and "coordinate" in record]
    pairs += [(value, units.times(unknown(name.rstrip("'")), units.TIME, -name.count("'")))
              for name, value in initial.items() if isinstance(value, Expression)]
    pairs += [(record[bound], unknown(name)) for name, record in (spec.get("choose") or {}).items()
              for bound in ("from", "to") if bound in record]
    pairs += [(record["per_length"], {**units.parse_unit("N" if record["body"].text in (spec.get("shafts") or {}) else
                                                      "N/m").dimension})
              for record in (spec.get("forces") or {}).values() if "per_length" in record and "body" in record]
    pairs += [(record["drawn"], unknown(name)) for name, record in spec.coordinates.items() if "drawn" in record]
    return {expression.scalar: measured for expression, measured in pairs}


def _along(spec: "Spec", reader: Reader) -> "dict[Scalar, units.Dimension]":
    """{scalar: dimension} of what is given along coordinates, but for a factor where that is unknown."""
    unknown = spec.dimensions.unknown
    return {scalar: unknown(name) if factor is None else units.times(unknown(name), unknown(factor))
            for scalar, (name, factor) in reader.along.items()}


def _bounded(spec: "Spec", reader: Reader) -> None:
    """No more coordinates than can be told apart, few where a part of the scene may move with all of them."""
    count = len(spec.coordinates)
    if count > MOST_COORDINATES:
        where = list(spec.coordinates.values())[MOST_COORDINATES].where
        reader.report(where, f"the scene has {count} coordinates; the limit is {MOST_COORDINATES}",
                      "leave coordinates out, or divide the scene")
    elif count > FEW_COORDINATES:
        tie = _tie(spec)
        if tie:
            reader.report(list(spec.coordinates.values())[FEW_COORDINATES].where,
                          f"the scene has {count} coordinates; the limit is {FEW_COORDINATES} where {tie}",
                          "leave coordinates out, or let each body move by itself, between springs")


def _tie(spec: "Spec") -> str | None:
    """What may move a part of the scene with all its coordinates, in words; None where nothing does."""
    from vibcli.elements.rigid_body import carriers, touched

    section = next((key for key in COUPLING if key in spec.sections), None)
    if section:
        return f"`{section}:` ties them"
    bodies = (spec.get("bodies") or {}).items()
    return next((f"other bodies carry one, as '{name}'" for name, record in bodies
                 if touched(record) or carriers(record, spec)), None)
