"""Questions of a scene: words, the search for all equilibria, and analyses with particulars."""

from typing import TYPE_CHECKING, Any

from vibcli.analyses import ANALYSES
from vibcli.analyses import FIND as FIND
from vibcli.analyses import OF_MODES as OF_MODES
from vibcli.language.document.document import Mapping, Scalar, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, Many, OneOf, Quantity
from vibcli.language.named_elements import Lazy
from vibcli.language.sections.equilibrium import ByCoordinate

if TYPE_CHECKING:
    from collections.abc import Iterable

    from vibcli.language.reader import Expression, Record

SEARCH, RESPONSE, FREQUENCY_RESPONSE, MODES = "equilibria", "response", "frequency_response", "modes"
RESPONSES = (RESPONSE, FREQUENCY_RESPONSE)
BACKBONE = "backbone"
INSIGHT = tuple(word for word in OF_MODES if ANALYSES[word][1] is None)      # what needs no particulars
ALWAYS = ("equations", "matrices", "energies", "equilibrium", "frequencies", "modes", "damping", "virtual_work",
          "accelerations")
ON_REQUEST = tuple(word for word in FIND if word not in ALWAYS)         # found only where they are asked for
WITH_PARTICULARS = {word: row for word, row in ANALYSES.items() if row[1] is not None}
AT_LENGTH = (SEARCH, MODES, *WITH_PARTICULARS)
MARKS = set("[(.")       # of quantities and signals; no word of a question has one
WRITTEN = {SEARCH: f"{{{SEARCH}: all}}"} | {word: form for word, (_, _, form) in WITH_PARTICULARS.items() if form}


def _room(file: str) -> str:
    return "analyses." + file.rpartition("/")[0]


ELEMENT = Element(
    "request",
    "A question with particulars. Of all equilibria: each within bounds, with its residual and whether it is stable, "
    "and whether it is proved that there are no others (of up to three coordinates without closed loops, by interval "
    "arithmetic; not at degenerate ones, nor where forces jump). "
    "Without bounds angles are searched over one turn and lengths to twice the size of the figure on either side of "
    "the drawn position. Positions one turn apart count once where the forces are the same there; a line of neutral "
    "positions counts once.",
    {
        SEARCH: Field(Choice("all"), "which are asked: all of them"),
        "within": Field(ByCoordinate(Many(Quantity(), 2, 2, "two bounds [least, most]"),
                                     "a mapping from coordinates to bounds [least, most]"),
                        "bounds of coordinates in the search, such as {phi: [-90 deg, 90 deg]}"),
        MODES: Field(Lazy(MODES, "analyses"), "which natural frequencies and mode shapes: {modes: 5}, "
                     "{modes: [990, 1000]}, {modes: {up_to: 2 kHz}}"),
        **{word: Field(Lazy(word, _room(file)), about) for word, (file, about, _) in WITH_PARTICULARS.items()},
    },
    exclusive=(AT_LENGTH, *(("within", word) for word in (MODES, *WITH_PARTICULARS))),
    needs=(AT_LENGTH,),
    example="buckled_post",
)


class Questions(list[str]):
    """The words asked, in order; `records`: {word: Record} of those that are asked at length."""

    def __init__(self, items: "Iterable[str | Record]") -> None:
        self.records = {key: item for item in items if not isinstance(item, str) for key in AT_LENGTH if key in item}
        super().__init__(item if isinstance(item, str) else next(key for key in AT_LENGTH if key in item)
                         for item in items)

    @property
    def search(self) -> "Record | None":
        """The Record of the search for equilibria, or None."""
        return self.records.get(SEARCH)

    @property
    def within(self) -> "dict[str, list[Expression]]":
        """{coordinate: [least, most]} as written."""
        bounds: dict[str, list[Expression]] = self.search.get("within", {}) if self.search else {}
        return bounds

    def about(self, word: str) -> "Record | None":
        """The Record of what is asked of a response, or None."""
        record = self.records.get(word)
        asked: Record | None = None if record is None else record[word]
        return asked

    @property
    def in_time(self) -> "Record | None":
        """The Record of what is asked of the motion in time, or None."""
        return self.about(RESPONSE)

    @property
    def amplitudes(self) -> "list[tuple[Expression | None, Expression]]":
        """The signals, None where it is the coordinate, whose amplitudes are asked, and the largest of these."""
        record = self.about(BACKBONE)
        return [] if record is None else [(next(iter(record.get("of", ())), None), record["up_to"])]

    @property
    def signals(self) -> "tuple[list[Expression], list[Expression]]":
        """The expressions of all signals asked, and the inputs."""
        records = [record for record in map(self.about, (*RESPONSES, BACKBONE)) if record is not None]
        return ([signal for record in records for signal in record.get("of", ())],
                [record["to"] for record in records if "to" in record])


class _Question(OneOf):
    """A word, or a question with particulars."""

    def read(self, node: Any, reader: Any) -> Any:
        if isinstance(node, Scalar) and node.text in WRITTEN:
            return reader.expected(node, self.wants, f"write {WRITTEN[node.text]}")
        if isinstance(node, Scalar) and MARKS & set(node.text):
            return reader.expected(node, _WORDS.wants, "a quantity is compared with a value in `answers`; a "
                                                     "signal's motion is asked by {response: {of: [x]}}")
        return super().read(node, reader)


class _Find(OneOf):
    """A list of questions; a mapping stands for the list of it alone."""

    def read(self, node: Any, reader: Any) -> Any:
        if isinstance(node, Scalar):
            return reader.expected(node, self.wants, f"write [{node.text}]" if node.text in FIND else None)
        items = super().read(node, reader)
        if items is None:
            return None
        for word in AT_LENGTH:
            again = [item for item in node.items if isinstance(item, Mapping) and word in item.entries] if isinstance(
                node, Sequence) else ()
            if len(again) > 1:
                return reader.report(again[1].where, f"'{word}' is asked twice", "leave one of the two out")
        return Questions(items if isinstance(items, list) else [items])


_WORDS = Choice(*(word for word in FIND if word not in WRITTEN))
_ONE = _Question(f"{_WORDS.wants}, or {' or '.join(WRITTEN.values())}", scalar=_WORDS, mapping=ELEMENT)
QUESTIONS = _Find("a list of questions", sequence=Many(_ONE, 1, 20, "a list of questions"), mapping=_ONE)
