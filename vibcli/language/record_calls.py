"""Records in the expressions of a file: `ag(t)` is a call of the record ag, of an argument in seconds."""

from vibcli.base.units import NONE
from vibcli.symbolic.parser import FUNCTIONS, OF_SIGNALS, VALUE
from vibcli.symbolic.syntax import Call, Equation, NameRef, Power, Product, QuantityRef, Sum

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
    if isinstance(tree, QuantityRef):
        args = tuple(_called(arg, names, used) for arg in tree.args)
        if tree.head == VALUE and isinstance(args[0], NameRef) and args[0].name in names and not (
                args[0].primes or tree.component):
            used.add(own(args[0].name))
            return Call(tree.start, tree.end, args[0].name, args[1:])
        return tree._replace(args=args)
    if isinstance(tree, (Sum, Product)):
        return tree._replace(parts=tuple((sign, _called(part, names, used)) for sign, part in tree.parts))
    if isinstance(tree, Call):
        return tree._replace(args=tuple(_called(arg, names, used) for arg in tree.args))
    if isinstance(tree, Power):
        return tree._replace(base=_called(tree.base, names, used), exponent=_called(tree.exponent, names, used))
    if isinstance(tree, Equation):
        return tree._replace(left=_called(tree.left, names, used), right=_called(tree.right, names, used))
    return tree
