"""Pages of the topics, quantities, shapes, functions, units and JSON keys."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.elements.rigid_body import MOTIONS
from vibcli.elements.shapes import LAWS, NEEDS
from vibcli.manual import scenes, topics
from vibcli.manual.ci import WORKFLOWS
from vibcli.manual.expressions import FUNCTIONS
from vibcli.manual.layout import blocks, in_short, paragraph, table
from vibcli.manual.python import EXAMPLE
from vibcli.quantities import FAMILIES, quantity
from vibcli.quantities.quantity import named
from vibcli.reader.sections.find import FIND
from vibcli.report import json_keys, keys

if TYPE_CHECKING:
    from vibcli.manual.catalogue import Catalogue
    from vibcli.quantities.quantity import Declaration
    from vibcli.symbolic.node import Node


def topic_page(catalogue: "Catalogue", word: str) -> str:
    """A topic: its texts and tables, or what is generated for it."""
    about, parts = topics.TOPICS[word]
    head = [f"{word} — {about}"]
    made = {"units": units_table, "functions": functions_table, "quantities": quantities_table, "exit": exit_table,
            "json": json_table, "shapes": shapes_table, "motions": motions_table,
            "python": python_example, "ci": ci_examples}
    own = made[word](catalogue) if word in made else []
    texts = [paragraph(part) if isinstance(part, str) else table(part) for part in parts or ()]
    return blocks(head, *texts, *own)


def python_example(catalogue: "Catalogue") -> list[list[str]]:
    return [["An example that runs:"], ["  " + line if line else "" for line in EXAMPLE.split("\n")]]


def ci_examples(catalogue: "Catalogue") -> list[list[str]]:
    return [[name, *("  " + line for line in text.rstrip().split("\n"))] for name, text in WORKFLOWS.items()]


def exit_table(catalogue: "Catalogue") -> list[list[str]]:
    return [table(topics.EXIT_CODES)]


def functions_table(catalogue: "Catalogue") -> list[list[str]]:
    text = "Angles are in radians; arguments are pure numbers where nothing else is said."
    return [paragraph(text), table(FUNCTIONS.items())]


def motions_table(catalogue: "Catalogue") -> list[list[str]]:
    fields = catalogue.elements["body"].fields
    return [table((word, in_short(fields[word].about)) for word in MOTIONS),
            ["Each has a page of its own: `vibcli explain pin`."]]


def shapes_table(catalogue: "Catalogue") -> list[list[str]]:
    rows = []
    for word in NEEDS:
        needs = ", ".join(NEEDS[word]) or "nothing"
        rows.append((word, f"needs {needs}", *shape_facts(word)))
    return [table(rows), ["A scene with all of them: vibcli new bodies_of_every_shape"]]


def shape_facts(word: Any) -> list[str]:
    """J, mass centre and measure of a shape, from the law that the code runs on."""
    from vibcli.symbolic.expression import Table

    values = Table()
    m = values.parameter("m")
    sizes = [values.parameter(key) for key in NEEDS[word]] if word != "rod" else [values.parameter("length")]
    law = LAWS[word](values, *sizes)
    facts = []
    if law.offset is None:
        facts.append(f"J_C = {_text(m * law.gyration2)}")
    else:
        at_circle = m * (law.gyration2 + law.offset * law.offset)
        facts += [f"J_O = {_text(at_circle)}, J_C = J_O − m*OC^2", f"OC = {_text(law.offset)}"]
    if law.measure is not None:
        what = "length" if word in ("rod", "ring", "arch") else "area"
        facts.append(f"{what} {_text(law.measure)}" if word != "rod" else "length from `from` to `to`")
    return facts


def _text(node: "Node") -> str:
    from vibcli.symbolic.normal_form import textbook

    return str(keys.plain(textbook(node)))


def shape_page(catalogue: "Catalogue", word: str) -> str:
    needs = ", ".join(f"`{key}`" for key in NEEDS[word]) or "no size"
    return blocks([f"{word} — a shape of a body"], table([("needs", needs), ("has", *shape_facts(word))]),
                  ["All shapes: vibcli explain shapes"])


def usage(head: str) -> str:
    """How a quantity is written: M[q,r], J[body, O], amplitude(x)."""
    asked = named(head)
    if asked.args:
        return quantity.usage(head)
    if not asked.indices:
        return head
    from vibcli.quantities.index_kinds import INDICES

    letters = [INDICES[kind].letters[asked.indices[:i].count(kind)] for i, kind in enumerate(asked.indices)]
    joined = "][" if head == "mode" else ", " if "body" in asked.indices else ","
    text = f"{head}[{joined.join(letters)}]" if head != "node" else f"{head}[{letters[0]}][{', '.join(letters[1:])}]"
    if asked.spare:
        text = f"{head}[{joined.join(letters[:-asked.spare])}], {text}"
    if asked.components == ("",):
        return text
    return ", ".join(f"{text}.{a}" for a in asked.components[:2]) + ", …" * (len(asked.components) > 2)


def _at_an_instant(head: str) -> list[tuple[str, str]]:
    """[(how it is written, what it is)] of the form of a quantity at an instant of a motion, where there is one."""
    asked = named(head + "()")
    return [(f"{usage(head)}(2 s)", asked.about)] if asked is not None and asked.args == ("time",) else []


def _of_products(head: str) -> list[tuple[str, str]]:
    """The same of the form of a quantity that has an index, where it has none itself."""
    asked = named(head + "[]")
    return [] if asked is None or named(head).indices or not asked.indices[0].startswith("product") else [
        (usage(head + "[]").replace("[][", "["), asked.about)]


def quantities_table(catalogue: "Catalogue") -> list[list[str]]:
    rows = [row for head in FAMILIES for row in ((usage(head), named(head).about + _unit(named(head))),
                                                 *_at_an_instant(head), *_of_products(head))]
    first = usage(next(head for head in FAMILIES if named(head).args))
    rows.insert([text for text, _ in rows].index(first), ("x(2 s)", named("value").about))
    lines = ["`answers` names a quantity and the value that it is expected to have; `vibcli check` compares them. "
             "i counts modes from 1; q and r are coordinates, by name or by number; p is a parameter. "
             "`equilibrium` and `mode` also take signals such as `P.x` or `hoist.force`: see `vibcli explain signals`. "
             "Of motions: `vibcli explain response`, `vibcli explain frequency_response`."]
    return [paragraph(lines[0]), table(rows),
            paragraph(topics.SEVERAL + ", ".join(head for head in FAMILIES if named(head).several) + "."),
            ["How they are compared", *table(topics.COMPARED)]]


def _unit(asked: "Declaration") -> str:
    return f" [{asked.unit}]" if asked.own_unit not in (None, "1") else ""


def quantity_page(catalogue: "Catalogue", head: str) -> str:
    """One quantity: how it is written, and a scene whose answers ask for it."""
    asked = named(head)
    rows = [("means", asked.about), *_at_an_instant(head), ("unit", _unit(asked).strip(" []") or None)]
    compared = {quantity.EQUATION: "equations", quantity.FUNCTION: asked.unit and "energies",
                quantity.TRUTH: "stable"}.get(asked.kind)
    rows.append(("compared", dict(topics.COMPARED)[compared] if compared else topics.IN_SHORT))
    scene = scenes.asking(head)
    return blocks([f"{usage(head)} — a quantity, for `answers`"], table(row for row in rows if row[1]),
                  [f"A scene that asks for it: vibcli new {scene}"] if scene else [], [_more(head)])


def _more(head: str) -> str:
    topic = named(head).topic
    return f"More: vibcli explain {topic}; all quantities: vibcli explain quantities" if topic else (
        "All quantities: vibcli explain quantities")


def find_page(catalogue: "Catalogue", word: str) -> str:
    return blocks([f"{word} — a word of `find`"], table([("prints", FIND[word])]),
                  ["All words of `find`: vibcli explain find"])


def function_page(catalogue: "Catalogue", name: str) -> str:
    return blocks([f"{name} — a function"], table([("means", FUNCTIONS[name])]),
                  ["All functions: vibcli explain functions"])


def units_table(catalogue: "Catalogue") -> list[list[str]]:
    """The units by what they measure, each in the SI unit."""
    groups = {}
    for name, unit in units.UNITS.items():
        groups.setdefault((tuple(sorted(unit.dimension.items())), unit.cycles), []).append(name)
    rows = []
    for names in groups.values():
        label = _measured(names[0]).removeprefix("a ").removeprefix("an ")
        rows.append((label, ", ".join(f"`{_in_si(name)}`" for name in names)))
    text = "Units are joined by `*`, `/` and `^`: `9.81 m/s^2`, `2 kN*m/rad`. In SI units:"
    return [paragraph(text), [line.replace("`", "") for line in table(rows)]]


def _measured(name: str) -> str:
    unit = units.UNITS[name]
    if unit.cycles:
        return "cycles per time (Hz)"
    if not unit.dimension:
        return "a pure number or angle"
    return "a pressure (Pa)" if unit.dimension == units.UNITS["Pa"].dimension else units.wanted(name, unit.dimension)


def _in_si(name: str) -> str:
    unit = units.UNITS[name]
    if unit.value == 1 and not unit.pi:
        return name
    above, below = unit.value.numerator, unit.value.denominator
    angle = (f"{above}π" if above > 1 else "π") + (f"/{below}" if below > 1 else "")
    size = angle if unit.pi else f"{float(unit.value):.8g}"
    return f"{name} = {size}".replace("e-0", "e-").replace("e+0", "e")


def unit_page(catalogue: "Catalogue", name: str) -> str:
    return blocks([f"{name} — a unit"], table([("measures", _measured(name)), ("in SI", _in_si(name))]),
                  ["All units: vibcli explain units"])


def json_table(catalogue: "Catalogue") -> list[list[str]]:
    return [paragraph(json_keys.ABOUT), table(json_keys.KEYS.items())]


def json_page(catalogue: "Catalogue", word: str) -> str:
    rows = [(key, about) for key, about in json_keys.KEYS.items() if key.replace("[]", "").split(".")[-1] == word]
    return blocks([f"{word} — a key of --json"], table(rows), ["All keys: vibcli explain json"])
