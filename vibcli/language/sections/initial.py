"""The start of a motion: values of coordinates and velocities, or the equilibrium under a force that lets go."""

from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Mapping
from vibcli.language.kinds import Kind, NameOf, Quantity
from vibcli.language.reader import Expression, Record, Reference
from vibcli.language.signal_names import signal_name
from vibcli.language.spec import RELEASED
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.language.document.nodes import DocumentNode, Scalar
    from vibcli.language.reader import Reader
    from vibcli.language.spec import Spec

PLACE = "x"
FIELDS = "initial_fields"       # the section of the fields that members start with
ABOUT = ("Where a motion in time starts: `{x: 2 cm, x': 0.5 m/s}`, coordinates counted as in the drawn position. "
         "Those left out start at rest in the equilibrium without the loads that depend on time, or as drawn where "
         "nothing holds the scene. `{released: pull}` starts at rest in the equilibrium under the steady force `pull`, "
         "which then lets go and acts no more. Members start with fields of the place x along them: `{rod.u: a*x/L, "
         "rod.u': 0 m/s}`; what is attached starts with them, "
         "oscillators with springs as long as at rest. A velocity may contradict a support, a displacement may not.")


class Initial(Kind):
    """A Record whose values are {"x'": expression}; `released` the Name of a force."""

    wants = "a mapping from coordinates and velocities to values, such as {x: 2 cm, x': 0.5 m/s}"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        values, keys = {}, {}
        for key, (key_node, value) in node.entries.items():
            keys[key] = key_node.where
            if key == RELEASED:
                name = NameOf("the name of a force", "forces").read(value, reader)
                if name is not None:
                    values[RELEASED] = name
                continue
            member = signal_name(plain_name(key_node.text)).name
            if member in reader.members or (reader.members and "." in key_node.text):
                reader.references.append((Reference(member, key_node.where), ("members",), "the name of a member"))
                field = _field(key_node, value, reader)
                values |= field if member in reader.members else {}
                continue
            name = key_node.text.rstrip("'")
            primes = key_node.text[len(name):]
            if len(primes) > 1:
                reader.report(key_node.where, f"a motion starts from positions and velocities, found '{key_node.text}'",
                              f"write {name} or {name}'")
                continue
            reader.references.append((Reference(plain_name(name), key_node.where), ("coordinates",),
                                      "the name of a coordinate"))
            expression = Quantity().read(value, reader)
            if expression is not None and "." not in name:
                values[plain_name(name) + primes] = expression
        return Record(None, "initial", node.where, values, keys)

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "properties": {RELEASED: {"type": "string"}},
                "additionalProperties": {"type": ["string", "number"]}}


def _field(key_node: "Scalar", value: "DocumentNode", reader: "Reader") -> dict[str, Expression]:
    """{text of a signal: expression of x} of the field that a member starts with, which is checked once all members are
    known; nothing where it cannot be read."""
    signal = signal_name(plain_name(key_node.text))
    expression = Quantity(("rad" if signal.part == "phi" else "m") + "/s" * bool(signal.primes)).read(value, reader)
    if expression is None:
        return {}
    reader.name_within(expression, PLACE, "m")
    return {signal.text: expression}


def with_fields_apart(sections: dict[str, Any]) -> dict[str, Any]:
    """The sections with the fields of members, {SignalName: expression of x}, in one of their own."""
    record = sections.get("initial")
    fields = {key: value for key, value in record.items() if "." in key} if record is not None else {}
    if not fields:
        return sections
    others = record.with_values({key: value for key, value in record.items() if key not in fields})
    return sections | {"initial": others, FIELDS: {signal_name(key): value for key, value in fields.items()}}


KIND = Initial()


def check_let_go(spec: "Spec", reader: Any) -> None:
    """Report a load in time that lets go: nothing of it holds the scene before t = 0."""
    name = spec.let_go
    record = (spec.get("forces") or {}).get(name)
    if record is None:
        return
    given = [part for value in record.values() for part in (value if isinstance(value, list) else [value])]
    if "unbalance" in record or any("t" in {found for found, *_ in part.parts.names} for part in given
                                    if isinstance(part, Expression)):
        reader.report(spec.get("initial")[RELEASED].where, f"'{name}' depends on the time: loads in time do not act "
                      "before t = 0, so that nothing of them can let go",
                      "name a steady force; one that acts from 0 to t1 is F*(1 - step(t - t1)) without `released`")
