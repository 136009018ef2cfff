"""Documents as files: PDF by Typst where the extra `homework` is installed, else pages in HTML."""

from collections.abc import Sequence
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from vibcli.report.formats import html

if TYPE_CHECKING:
    from vibcli.report.blocks import Document, Picture

MAIN = "main.typ"


class Pages:
    """Documents as HTML pages."""

    suffix = ".html"

    def data(self, documents: "Sequence[Document]") -> bytes:
        """The bytes of a file."""
        return html.render(documents, listed=False).encode()


class Paper:
    """Documents as PDF, by one compiler that is kept; its fonts are its own, its time the beginning of all times, so
    that the same documents give the same bytes."""

    suffix = ".pdf"

    def __init__(self) -> None:
        from typst import Compiler

        self._compiler: Any = Compiler(ignore_system_fonts=True)

    def data(self, documents: "Sequence[Document]") -> bytes:
        """The bytes of a file."""
        from vibcli.report.formats import typst

        files: dict[str, bytes] = {}

        def place(picture: "Picture") -> str:
            name = f"{len(files)}.svg"
            files[name] = picture.draw("svg")
            return name

        files[MAIN] = typst.render(documents, place, apart=False).encode()
        found: bytes = self._compiler.compile({MAIN: files.pop(MAIN), **files}, format="pdf", timestamp=0)
        return found


def paper() -> Pages | Paper:
    """Paper where there is a compiler, else Pages."""
    return Pages() if find_spec("typst") is None else Paper()
