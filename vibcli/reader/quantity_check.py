"""Expected answers: does each name a quantity that can be asked of this scene, in the dimension it has?"""

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.language.dimension_check import check
from vibcli.language.fields import nearest
from vibcli.language.parameters import independent
from vibcli.language.signals import near_signals, signal_dimension
from vibcli.quantities.quantity import (
    ALL,
    ASKED,
    BARE,
    IN_FREQUENCY,
    OF_SPEED,
    SEVERAL,
    SIGNAL,
    STATE_FUNCTIONS,
    declared,
    dimension,
)
from vibcli.reader.cycle_check import check_radians, check_same, check_terms, is_frequency
from vibcli.reader.signal_check import (
    arguments_fit,
    input_dimension,
    inputs,
    output_dimension,
    response_dimension,
    usage_here,
)
from vibcli.symbolic.cycles import left_over
from vibcli.symbolic.parser import ExpressionError
from vibcli.symbolic.semantics import DimensionCheck, names_in, quantities_in

MOST_COUNTED = 1000
ANGULAR = ("omega", "omega_d", "decay", "growth_rate", "rayleigh", "dunkerley")


def check_answers(spec, reader):
    """Report whatever is wrong with the answers of a file."""
    spec.asked_dimension = lambda tree: asked_dimension(spec, tree)
    spec.velocities |= {id(a.expected) for a in spec.answers}
    for answer in spec.answers:
        _answer(spec, reader, answer)


def asked_dimension(spec, tree):
    if is_choice(spec, tree):
        return spec.dimensions.of(tree[4])
    if (tree[7] or tree[4] in IN_FREQUENCY) and tree[4] not in OF_SPEED:
        return response_dimension(spec, tree)
    indices = [coordinate_name(spec, index) or index for index in tree[5]]

    def of(name):
        known = name in spec.coordinates or name in spec.parameters
        return spec.dimensions.of(name) if known else signal_dimension(spec, name)

    return dimension(tree[4], indices, of)


def is_choice(spec, tree):
    """Does a tree ask for a chosen parameter: c, or its second solution c[2]?"""
    choices = spec.get("choose") or ()
    if tree[0] == "name":
        return tree[3] in choices and not tree[4]
    indices = tree[5]
    return tree[4] in choices and len(indices) == 1 and indices[0].isdecimal() and (
        tree[4] not in ASKED or len(ASKED[tree[4]].indices) != 1)


def coordinate_name(spec, index):
    """A coordinate by its name or its number from 1; None where there is none."""
    names = list(spec.coordinates)
    if index.isdecimal() and index.isascii():
        return names[int(index) - 1] if 1 <= int(index) <= len(names) else None
    return index if index in spec.coordinates else None


def _is_parameter(spec, name):
    """Is a name that can be asked for, such as T, that of a chosen parameter or of one that measures something else?"""
    measured = spec.dimensions.of(name) if name in spec.parameters else None
    return name in spec.choices or (measured is not None and measured != units.parse_unit(ASKED[name].unit).dimension)


def as_quantity(spec, tree):
    """The tree of a quantity that is written as a name alone, such as rayleigh or T; other trees as they are."""
    if tree[0] == "name" and tree[3] in BARE and not tree[4] and not _is_parameter(spec, tree[3]):
        return ("quantity", tree[1], tree[2], tree[3], tree[3], (), "", ())
    return tree


def _answer(spec, reader, answer):
    """The quantity asked for must exist, and the expected value must have its dimension."""
    asked, expected = answer.asked, answer.expected
    tree = asked.tree = as_quantity(spec, asked.tree)
    whole = tree[0] == "quantity"
    for quantity in quantities_in(tree):
        if not can_be_asked(spec, reader, asked, quantity):
            return
    names = {name for name, *_ in names_in(tree)} - {"pi"}
    of_parameters = names & set(spec.choices) or (names and names <= set(spec.parameters))
    if not whole and not quantities_in(tree) and not of_parameters:
        if asked.text in ASKED:
            needs = "an index" if ASKED[asked.text].indices else "a signal"
            reader.report(asked.where, f"{quoted(asked.text)} needs {needs}", f"write {usage_here(spec, asked.text)}")
        elif at_no_time(spec, tree):
            reader.report(asked.where, f"{quoted(asked.text)} is a function of time",
                          f"ask for its value as in {asked.text}(2 s), or for max({asked.text})")
        else:
            reader.report(asked.where, f"{quoted(asked.text)} is not a quantity", nearest(asked.text, ASKED) or ALL)
        return
    head = tree[4] if whole else None
    if head == "stable":
        if expected.text not in ("true", "false"):
            reader.report(expected.where, f"expected true or false, found {quoted(expected.text)}",
                          "write stable: true")
        return
    for part in (expected, answer.rtol) if answer.rtol is not None else (expected,):
        for quantity in quantities_in(part.tree):
            if not can_be_asked(spec, reader, part, quantity):
                return
    if head in STATE_FUNCTIONS and quantities_in(expected.tree):
        quantity = quantities_in(expected.tree)[0]
        reader.report(expected.scalar.place(quantity[1], quantity[2] - quantity[1]),
                      f"'{quantity[3]}' cannot stand in an expected '{head}'", "write it in parameters and coordinates")
        return
    names = spec.parameters if head not in STATE_FUNCTIONS else (*spec.parameters, *spec.coordinates, "t")
    fits = check(spec, reader, asked, spec.parameters, None)
    dimension_asked = asked_dimension(spec, tree) if whole else dimension_of(spec, asked)
    expected.unit = unit_asked(tree) if whole and not is_choice(spec, tree) else None
    if check(spec, reader, expected, names, dimension_asked) and fits:
        check_cycles(spec, reader, asked, expected)
    if answer.rtol is not None:
        check(spec, reader, answer.rtol, spec.parameters, units.NONE)


def at_no_time(spec, tree):
    """Is this a signal alone, without an instant?"""
    return tree[0] == "name" and output_dimension(spec, tree[3]) is not None


def unit_asked(tree):
    """The unit that the value of a quantity is expected in; None where its indices or arguments settle it."""
    unit = declared(tree).unit
    return None if unit == SIGNAL else unit


def dimension_of(spec, expression):
    try:
        return DimensionCheck(spec.dimensions, lambda name, primes: spec.dimensions.of(name), spec.free_numbers,
                              lambda tree: asked_dimension(spec, tree)).dimension(expression.tree)
    except ExpressionError:
        return None


def can_be_asked(spec, reader, expression, tree, bare=False):
    """Is this a quantity that can be asked of this scene? Reports what is wrong with it. `bare`: a frequency response
    stands without a frequency."""
    head, indices, attribute = tree[4], tree[5], tree[6]
    place = expression.scalar.place(tree[1], tree[2] - tree[1])
    if is_choice(spec, tree):
        return True
    asked = declared(tree)
    if asked is None:
        reader.report(place, f"unknown quantity '{head}'", nearest(head, ASKED) or ALL)
        return False
    kinds = (*asked.indices, "equilibrium") if head in SEVERAL and len(indices) > len(asked.indices) else asked.indices
    if len(indices) != len(kinds) and not (head == "J" and len(indices) == 1):
        takes = {0: "no index", 1: "one index", 2: "two indices"}[len(asked.indices)]
        reader.report(place, f"'{head}' takes {takes}, found {len(indices) or 'none'}",
                      f"write {usage_here(spec, head)}")
        return False
    if not arguments_fit(spec, reader, expression, tree, bare):
        return False
    if attribute not in asked.attributes:
        reader.report(place, f"'{head}' has no '.{attribute}'" if attribute else f"'{tree[3]}' needs a component",
                      "write " + " or ".join(tree[3].partition(".")[0] + (a and "." + a) for a in asked.attributes))
        return False
    pairs = zip(kinds, indices, strict=False)
    if not all(_index(spec, reader, place, head, kind, index) for kind, index in pairs):
        return False
    bodies = spec.get("bodies") or {}
    lumped = [name for name in indices if name in bodies and not {"at", "from", "parts"} & set(bodies[name].keys)]
    if lumped and (head == "centre" or (head == "J" and len(indices) == 2)):
        reader.report(place, f"'{lumped[0]}' has no place", "say where it is drawn with `at: [x, y]`")
        return False
    return True


def _index(spec, reader, place, head, kind, index):
    n = len(spec.coordinates)
    bodies, points = spec.get("bodies") or {}, spec.get("points") or {}
    if kind == "mode":
        good, valid = index.isdecimal() and index.isascii() and 1 <= int(index) <= 2 * n, [str(i + 1) for i in range(n)]
    elif kind == "equilibrium":
        good, valid = index.isdecimal() and index.isascii() and int(index) > 0, ["1", "2", "3"]
    elif kind == "coordinate":
        good, valid = coordinate_name(spec, index) is not None, list(spec.coordinates)
    elif kind == "signal":
        good = coordinate_name(spec, index) is not None or signal_dimension(spec, index) is not None
        valid = near_signals(spec, index)
    elif kind == "output":
        good, valid = output_dimension(spec, index) is not None, near_signals(spec, index)
    elif kind == "input":
        good, valid = input_dimension(spec, index) is not None, inputs(spec)
    elif kind == "number":
        return _counted(reader, place, index.isdecimal() and index.isascii() and 0 < int(index) <= MOST_COUNTED,
                        f"a whole number from 1 to {MOST_COUNTED}", index)
    elif kind == "fraction":
        return _counted(reader, place, _is_fraction(index), "a fraction between 0 and 1", index)
    elif kind == "parameter":
        good, valid = index in independent(spec.parameters), independent(spec.parameters)
        if not good and index in spec.parameters:
            reader.report(place, f"'{index}' is defined by other parameters", nearest(index, valid))
            return False
    elif kind == "damper":
        good, valid = index in (spec.get("dampers") or {}), list(spec.get("dampers") or {})
    elif kind == "body":
        good, valid = index in bodies, list(bodies)
    else:
        good, valid = index in points or index in bodies, [*points, *bodies]
    if not good:
        kind = "coordinate or signal" if kind == "signal" else kind
        reader.report(place, f"this scene has no {kind} {quoted(index)}", nearest(index, valid) or "it has none at all")
    return good


def _counted(reader, place, good, wants, index):
    if not good:
        reader.report(place, f"expected {wants} in square brackets, found {quoted(index)}")
    return good


def _is_fraction(text):
    try:
        return 0 < float(text) < 1
    except ValueError:
        return False


def check_cycles(spec, reader, asked, expected):
    """Hz is not rad/s: an angular frequency refuses it, and a frequency the other; all else counts no cycles."""
    tree = asked.tree
    head = tree[4] if tree[0] == "quantity" and not is_choice(spec, tree) else None
    asks_frequency = head is not None and declared(tree).unit == "Hz"
    count = check_terms(spec, reader, expected)
    if count is None or check_terms(spec, reader, asked) is None:
        return
    if asks_frequency and not is_frequency(spec, expected):
        reader.report(expected.where, f"expected a frequency (Hz) for '{head}', found an angular frequency",
                      "divide by 2*pi, or ask for omega[i]")
    elif head in ANGULAR and left_over(count) == 1:
        reader.report(expected.where, f"expected an angular frequency (rad/s) for '{head}', found Hz",
                      "write 2*pi*f, or ask for frequency[i]")
    elif head is None:
        check_same(spec, reader, asked, expected)
    elif not asks_frequency:
        check_radians(spec, reader, expected)
