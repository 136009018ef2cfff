"""What may be asked of frequency responses."""

from vibcli.language.fields import Element, Field
from vibcli.language.signal_kinds import SIGNALS, FrequencyField, InputField

ELEMENT = Element(
    "frequency_response",
    "Frequency responses of signals to a unit of an input.",
    {
        "of": Field(SIGNALS, "the signals; the coordinates if left out"),
        "to": Field(InputField(), "the input, a unit of it; of a coordinate the generalised force on it; the first of "
                    "these if left out"),
        "from": Field(FrequencyField("Hz"), "where plots and saved numbers begin"),
        "up_to": Field(FrequencyField("Hz"), "where they end"),
    },
    example="frequency_response",
)
