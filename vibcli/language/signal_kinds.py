"""Kinds of what responses are asked with: signals, inputs and frequencies."""

from typing import Any

from vibcli.language.document.document import Scalar
from vibcli.language.kinds import Kind, Many, Quantity
from vibcli.language.reader import Expression
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError


class SignalField(Kind):
    """An expression of signals; what its names mean is settled when all are known."""

    wants = "a signal such as x, x' or s.force"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants)
        try:
            return Expression(node, reader.at_places(parse(node.text)))
        except ExpressionError as error:
            return reader.report(node.place(error.offset, error.width), error.message, error.hint)

    def schema(self) -> dict[str, Any]:
        return {"type": "string"}


class FrequencyField(Quantity):
    """An angular frequency, or one in Hz, which counts 2π."""

    wants, sample = "a frequency (rad/s or Hz)", "20 rad/s or 5 Hz"


class InputField(SignalField):
    wants = "the name of a force, driven point or coordinate"


SIGNALS = Many(SignalField(), 1, 50, "a list of signals")
