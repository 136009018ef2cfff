"""What is asked of a scene: words, and the search for all equilibria."""

from vibcli.document import Mapping, Scalar, Sequence
from vibcli.elements.equilibrium import ByCoordinate
from vibcli.fields import Choice, Element, Field, Many, OneOf, Quantity
from vibcli.questions import FIND

SEARCH = "equilibria"
ELEMENT = Element(
    "search",
    "All equilibria within bounds, each with its residual and whether it is stable. Without bounds angles are searched "
    "over one turn and lengths to twice the size of the figure on either side of the drawn position. Positions one "
    "turn apart count once where the forces are the same there; a line of neutral positions counts once.",
    {
        SEARCH: Field(Choice("all"), "which are asked: all of them", required=True),
        "within": Field(ByCoordinate(Many(Quantity(), 2, 2, "two bounds [least, most]"),
                                     "a mapping from coordinates to bounds [least, most]"),
                        "bounds of coordinates, such as {phi: [-90 deg, 90 deg]}"),
    },
    example="buckled_post",
)


class Questions(list):
    """The words asked, in order; search: the Record of the search for equilibria, or None."""

    def __init__(self, items):
        super().__init__(item if isinstance(item, str) else SEARCH for item in items)
        self.search = next((item for item in items if not isinstance(item, str)), None)

    @property
    def within(self):
        """{coordinate: [least, most]} as written."""
        return self.search.get("within", {}) if self.search else {}


class _Question(OneOf):
    def __init__(self):
        words = Choice(*(word for word in FIND if word != SEARCH))
        super().__init__(f"{words.wants}, or {{{SEARCH}: all}}", scalar=words, mapping=ELEMENT)

    def read(self, node, reader):
        if isinstance(node, Scalar) and node.text == SEARCH:
            return reader.expected(node, self.wants, f"write {{{SEARCH}: all}}")
        return super().read(node, reader)


class _Find(OneOf):
    """A list of questions; a mapping stands for the list of it alone."""

    def __init__(self):
        super().__init__("a list of questions", sequence=Many(_Question(), 1, 20, "a list of questions"),
                         mapping=ELEMENT)

    def read(self, node, reader):
        if isinstance(node, Scalar):
            return reader.expected(node, self.wants, f"write [{node.text}]" if node.text in FIND else None)
        items = super().read(node, reader)
        if items is None:
            return None
        searches = [item for item in node.items if isinstance(item, Mapping)] if isinstance(node, Sequence) else ()
        if len(searches) > 1:
            return reader.report(searches[1].where, f"'{SEARCH}' is asked twice", "leave one of the two out")
        return Questions(items if isinstance(items, list) else [items])


QUESTIONS = _Find()
