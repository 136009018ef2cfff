"""Damping of the small oscillations by ratios of modes, or in proportion to inertia and stiffness."""

from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Mapping, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Kind, Many, Quantity

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

RATIO = Quantity("1")


class OneOrMore(Kind):
    """A ratio, or a list of them."""

    wants = "a damping ratio such as 1 %, or a list of them"

    def read(self, node: Any, reader: Any) -> Any:
        if isinstance(node, Sequence):
            return Many(RATIO, 1, 2000, self.wants).read(node, reader)
        one = reader.expected(node, self.wants) if isinstance(node, Mapping) else RATIO.read(node, reader)
        return None if one is None else [one]

    def schema(self) -> dict[str, Any]:
        return {"anyOf": [RATIO.schema(), Many(RATIO, 1, 2000).schema()]}


class ByMode(Kind):
    """{number of a mode: its ratio}."""

    wants = "a mapping from numbers of modes to damping ratios, such as {1: 1 %, 4: 2 %}"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Mapping) or not node.entries:
            return reader.expected(node, self.wants)
        found = {}
        for key, (key_node, value) in node.entries.items():
            if not key.isdecimal() or not int(key):
                reader.report(key_node.where, f"expected the number of a mode, found '{key}'", "modes count from 1")
                continue
            ratio = RATIO.read(value, reader)
            if ratio is not None:
                found[int(key)] = ratio
        return found

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "additionalProperties": RATIO.schema()}


class Factors(Kind):
    """[α, β]."""

    wants = "two factors [alpha, beta], in s^-1 and s"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Sequence) or len(node.items) != 2:
            return reader.expected(node, self.wants)
        found = [Quantity(unit).read(item, reader) for unit, item in zip(("s^-1", "s"), node.items, strict=True)]
        return None if None in found else found

    def schema(self) -> dict[str, Any]:
        return Many(RATIO, 2, 2).schema()


ELEMENT = Element(
    "damping",
    "Damping of the small oscillations as a whole, added to what dampers do: C = M Φ diag(2 ζ ω) Φᵀ M, Φ the modes "
    "without dampers, ΦᵀMΦ = 1, numbered as `omega[i]` is. It resists velocities, with `modal` and `caughey` those "
    "against what driven supports would give at rest. Full equations, forces of elements and reactions are without it. "
    "Responses of members with inertia are exact sums over all modes. Beside their dampers `modal` and `caughey` give "
    "frequency responses and steady states, exact too, and motions in time under loads, without damped modes; beside "
    "drag and gyroscopic terms `proportional` alone is taken. Beside whatever else damps members α and β stand in the "
    "differential equations, without motions in time where drag or driven supports stand beside β.",
    {
        "modal": Field(OneOrMore(), "the ratio ζ of every mode, or a list of them by number, whose last holds for all "
                                    "that follow; what does not vibrate has none"),
        "proportional": Field(Factors(), "[α, β] of C = α M + β K, in s^-1 "
                              "and s: ζ = α/(2ω) + βω/2"),
        "caughey": Field(ByMode(), "ratios at given modes, {1: 1 %, 4: 2 %}: C = M Σ aₖ (M⁻¹K)ᵏ with the powers k = 0, "
                         "1, … as many as modes are given (Caughey 1960); at two modes it is proportional"),
    },
    exclusive=(("modal", "proportional", "caughey"),),
    needs=(("modal", "proportional", "caughey"),),
    example="damping_by_modes",
)


def build(record: "Record", scene: "Builder") -> None:
    """Checks the ratios and factors, and that the motion is small."""
    if scene.spec.in_full:
        scene.report(record.where, "damping by modes belongs to small oscillations",
                     "leave `motion:` out, or write the dampers one by one under dampers")
    for given in (record.get("modal") or (), (record.get("caughey") or {}).values(), record.get("proportional") or ()):
        for expression in given:
            if scene.number(scene.lower(expression)) < 0:
                scene.report(expression.where, "damping takes energy out: expected a number of 0 or more",
                             "leave the sign out")
