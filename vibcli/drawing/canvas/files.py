"""Drawings as the bytes of files: SVG written from the primitives, PNG and PDF by Matplotlib."""

from collections.abc import Sequence
from typing import Any


def data(primitives: Sequence[Any], kind: str, title: str = "", about: str = "") -> bytes:
    """The bytes of a png, svg or pdf; what it is and what it shows is told in an SVG."""
    if kind == "svg":
        from vibcli.drawing.canvas.svg_canvas import picture

        return picture(primitives, title, about)
    from vibcli.drawing.canvas.matplotlib_canvas import picture as drawn

    return drawn(primitives, kind)
