"""Questions of a scene: words, the search for all equilibria, motions in time and frequency responses."""

from vibcli.analyses import FIND
from vibcli.language.document.document import Mapping, Scalar, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, Kind, Many, OneOf, Quantity
from vibcli.language.reader import Expression
from vibcli.language.sections.equilibrium import ByCoordinate
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError

SEARCH, RESPONSE, FREQUENCY_RESPONSE = "equilibria", "response", "frequency_response"
RESPONSES = (RESPONSE, FREQUENCY_RESPONSE)
INSIGHT = ("shares", "sensitivities", "estimates")
ALWAYS = ("equations", "energies", "equilibrium", "frequencies", "modes", "damping", "virtual_work")
ON_REQUEST = tuple(word for word in FIND if word not in ALWAYS)         # found only where they are asked for


class _Signal(Kind):
    """An expression of signals; what its names mean is settled when all are known."""

    wants = "a signal such as x, x' or s.force"

    def read(self, node, reader):
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants)
        try:
            return Expression(node, parse(node.text))
        except ExpressionError as error:
            return reader.report(node.place(error.offset, error.width), error.message, error.hint)

    def schema(self):
        return {"type": "string"}


class _Frequency(Quantity):
    """An angular frequency, or one in Hz, which counts 2π."""

    wants, sample = "a frequency (rad/s or Hz)", "20 rad/s or 5 Hz"


class _Input(_Signal):
    wants = "the name of a force, driven point or coordinate"


_SIGNALS = Many(_Signal(), 1, 50, "a list of signals")
_IN_TIME = Element(
    "response",
    "The motion in time: which signals, and until when.",
    {
        "of": Field(_SIGNALS, "the signals; the coordinates if left out"),
        "until": Field(Quantity("s"), "the end of the motion; some periods, or until it has died out, if left out"),
    },
    example="bump_in_the_road",
)
_IN_FREQUENCY = Element(
    "frequency_response",
    "Frequency responses of signals to a unit of an input.",
    {
        "of": Field(_SIGNALS, "the signals; the coordinates if left out"),
        "to": Field(_Input(), "the input, a unit of it; of a coordinate the generalised force on it; the first of "
                    "these if left out"),
        "from": Field(_Frequency("Hz"), "where plots and saved numbers begin"),
        "up_to": Field(_Frequency("Hz"), "where they end"),
    },
    example="frequency_response",
)
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
        RESPONSE: Field(_IN_TIME, "which signals of the motion in time, and until when"),
        FREQUENCY_RESPONSE: Field(_IN_FREQUENCY, "frequency responses of which signals, to which input"),
    },
    exclusive=((SEARCH, RESPONSE, FREQUENCY_RESPONSE), ("within", RESPONSE), ("within", FREQUENCY_RESPONSE)),
    needs=((SEARCH, RESPONSE, FREQUENCY_RESPONSE),),
    example="buckled_post",
)
AT_LENGTH = (SEARCH, RESPONSE, FREQUENCY_RESPONSE)


class Questions(list):
    """The words asked, in order; `records`: {word: Record} of those that are asked at length."""

    def __init__(self, items):
        self.records = {key: item for item in items if not isinstance(item, str) for key in AT_LENGTH if key in item}
        super().__init__(item if isinstance(item, str) else next(key for key in AT_LENGTH if key in item)
                         for item in items)

    @property
    def search(self):
        """The Record of the search for equilibria, or None."""
        return self.records.get(SEARCH)

    @property
    def within(self):
        """{coordinate: [least, most]} as written."""
        return self.search.get("within", {}) if self.search else {}

    def about(self, word):
        """The Record of what is asked of a response, or None."""
        record = self.records.get(word)
        return None if record is None else record[word]

    @property
    def in_time(self):
        """The Record of what is asked of the motion in time, or None."""
        return self.about(RESPONSE)

    @property
    def signals(self):
        """The expressions of all signals asked, and the inputs."""
        records = [record for record in map(self.about, (RESPONSE, FREQUENCY_RESPONSE)) if record is not None]
        return ([signal for record in records for signal in record.get("of", ())],
                [record["to"] for record in records if "to" in record])


class _Question(OneOf):
    """A word, or a question with particulars."""

    def read(self, node, reader):
        if isinstance(node, Scalar) and node.text == SEARCH:
            return reader.expected(node, self.wants, f"write {{{SEARCH}: all}}")
        return super().read(node, reader)


class _Find(OneOf):
    """A list of questions; a mapping stands for the list of it alone."""

    def read(self, node, reader):
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


_WORDS = Choice(*(word for word in FIND if word != SEARCH))
_ONE = _Question(f"{_WORDS.wants}, or {{{SEARCH}: all}}", scalar=_WORDS, mapping=ELEMENT)
QUESTIONS = _Find("a list of questions", sequence=Many(_ONE, 1, 20, "a list of questions"), mapping=_ONE)
