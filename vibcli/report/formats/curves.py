"""Curves in the terminal, as pictures, and as files for other programs: CSV, NPZ or JSON by the suffix."""

from collections.abc import Callable, Sequence
from io import BytesIO, StringIO
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

    from vibcli.plots.figure import Figure

    Columns = Sequence[tuple[str, str, np.ndarray]]       # name, unit, values

DATA = (".csv", ".npz", ".json")


def in_terminal(figure: "Figure", width: int) -> str:
    """A Figure as text of so many columns."""
    from vibcli.plots.braille import braille

    return braille(figure, width=width)


def curve_file(suffix: str, title: str, figure: "Callable[[], Figure]",
               columns: "Callable[[], Columns] | None") -> bytes:
    """The bytes of a file under a title: of what `columns()` gives, or of the Figure that `figure()` gives."""
    if suffix in DATA:
        return data(suffix, title, columns())
    from vibcli.plots.picture import picture

    return picture(figure(), suffix[1:])


def data(suffix: str, title: str, columns: "Columns") -> bytes:
    """The bytes of [(name, unit, array)], complex columns as real and imaginary part; the others are over the first."""
    apart: list[tuple[str, str, np.ndarray]] = []
    for name, unit, values in columns:
        if values.dtype.kind == "c":
            apart += [(f"re {name}", unit, values.real), (f"im {name}", unit, values.imag)]
        else:
            apart.append((name, unit, values))
    return {".csv": _csv, ".npz": _npz, ".json": _json}[suffix](title, apart)


def _csv(title: str, columns: "Columns") -> bytes:
    """A header of names with units, then the rows, what is no number empty; a cell that a spreadsheet would take for a
    formula is quoted."""
    import csv

    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([_plain(f"{name} [{unit}]") for name, unit, _ in columns])
    writer.writerows([repr(float(value)) if value == value else "" for value in row]
                     for row in zip(*(values for *_, values in columns), strict=True))
    return text.getvalue().encode()


def _plain(cell: str) -> str:
    return "'" + cell if cell[0] in "=+-@" else cell


def _npz(title: str, columns: "Columns") -> bytes:
    import numpy as np

    data = BytesIO()
    arrays: dict[str, Any] = {name: values for name, _, values in columns}
    np.savez(data, **arrays,
             units=np.array([f"{name} [{unit}]" for name, unit, _ in columns]))
    return data.getvalue()


def _json(title: str, columns: "Columns") -> bytes:
    import json

    found = {"title": title, "columns": [
        {"name": name, "unit": unit, "values": [float(x) if x == x else None for x in values]}
        for name, unit, values in columns]}
    return json.dumps(found, ensure_ascii=False, allow_nan=False, indent=1).encode()
