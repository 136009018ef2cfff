"""Records in the expressions of a file: `ag(t)` is a call of the record ag, of an argument in seconds."""

from vibcli.base.units import NONE
from vibcli.symbolic.parser import FUNCTIONS, OF_SIGNALS, VALUE

RESERVED = ("pi", "t", "power", *FUNCTIONS, *OF_SIGNALS)      # names that mean something else before a bracket


def own(name):
    """What the dimension of the values of a record is known by, and that it is used."""
    return name + "()"


def call_records(spec, reader):
    """Let `ag(…)` be a call in all expressions, where ag is a record."""
    names = spec.named.get("records", ())
    if not names:
        return
    for name, record in (spec.get("records") or {}).items():
        kind = "parameter" if name in spec.named.get("parameters", ()) else "coordinate"
        if kind == "parameter" or name in spec.coordinates:
            reader.report(record.where, f"'{name}' is a record and a {kind}", "rename one of them")
    for expression in reader.expressions:
        if "(" in expression.text:
            expression.tree = _called(expression.tree, names, spec.used)


def record_dimensions(spec):
    """The values of a record have its unit; without one they are pure numbers, in a scene without units anything."""
    records = spec.get("records") or {}
    if not records:
        return
    from vibcli.language.sections.record import dimension

    for name, record in records.items():
        measured = dimension(record)
        if measured is not None or not spec.free_numbers:
            spec.dimensions.equate(spec.dimensions.unknown(own(name)), NONE if measured is None else measured)


def _called(tree, names, used):
    kind = tree[0]
    if kind == "quantity":
        args = tuple(_called(arg, names, used) for arg in tree[7])
        if tree[4] == VALUE and args[0][0] == "name" and args[0][3] in names and not (args[0][4] or tree[6]):
            used.add(own(args[0][3]))
            return ("call", tree[1], tree[2], args[0][3], list(args[1:]))
        return (*tree[:7], args)
    if kind in ("sum", "product"):
        return (*tree[:3], [(sign, _called(part, names, used)) for sign, part in tree[3]])
    if kind == "call":
        return (*tree[:4], [_called(arg, names, used) for arg in tree[4]])
    if kind in ("power", "equation"):
        return (*tree[:3], _called(tree[3], names, used), _called(tree[4], names, used))
    return tree
