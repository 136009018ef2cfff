"""What a question asks, its figure and its keys as HTML, which all formats share."""

from typing import TYPE_CHECKING

from vibcli.homework.exports.escaping import attribute
from vibcli.homework.exports.setting import SetInMathML, SetInTeX, running
from vibcli.notation.as_printed import as_printed
from vibcli.notation.numbers import figure

if TYPE_CHECKING:
    from vibcli.homework.exports.item import ExportedKey, ExportedQuestion

FIGURE = "figure.svg"


def asked(key: "ExportedKey", setting: SetInTeX | SetInMathML, lettered: bool = True) -> str:
    """(a) damped frequency of mode 1, in rad/s, to 3 figures (2 points); `lettered`: with the letter before it."""
    unit = f", in {as_printed(key.unit)}" if key.unit else ""
    figures = f", to {key.figures} figures" if key.value is not None else ""
    points = f" ({figure(key.points, digits=3)} point{'s' * (key.points != 1)})"
    said = f"{f'({key.letter}) ' if lettered else ''}{key.about}{unit}{figures}{points}"
    form = f"<br/>{setting.words(key.form)}" if key.form else ""
    return setting.words(said) + form


def figure_html(question: "ExportedQuestion", place: str, name: str = FIGURE) -> str:
    """The figure with its description, '' of none; place: what stands before the name of its file."""
    if question.figure is None:
        return ""
    return f'<p><img src="{place}{name}" alt="{attribute(question.described)}"/></p>'


def key_html(key: "ExportedKey", setting: SetInTeX | SetInMathML) -> str:
    """The right answer for who marks."""
    return f"<p>({key.letter}) {setting.words(key.quantity)}: {running(key.answer, setting)}</p>"
