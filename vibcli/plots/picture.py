"""A figure drawn by Matplotlib, as the bytes of a file. Its object interface only: nothing global is left changed."""

import io
import warnings
from collections.abc import Mapping
from typing import Any

from vibcli.base.decoding import cleaned
from vibcli.plots import style

_OPTIONS: dict[str, dict[str, Any]] = {      # neither date nor version; less time for the last tenth of a PNG's size
    "png": {"metadata": {"Software": None}, "pil_kwargs": {"compress_level": 4}},
    "svg": {"metadata": {"Date": None, "Creator": None}},
    "pdf": {"metadata": {"Creator": None, "Producer": None, "CreationDate": None}}}


def library() -> Any:
    """Matplotlib, which says nothing of the folder that it would keep its cache in; imported where it draws."""
    import logging

    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    import matplotlib

    return matplotlib


def picture(figure: Any, kind: Any, inches: float = style.WIDTH) -> bytes:
    """The bytes of a PNG, SVG or PDF so many inches wide."""
    matplotlib = library()
    with matplotlib.rc_context(), warnings.catch_warnings():
        warnings.simplefilter("ignore")      # letters that no font has are drawn as boxes
        matplotlib.rcParams.update(_settings(matplotlib.rcParamsDefault))
        from vibcli.plots.layout import drawn

        data = io.BytesIO()
        options = _OPTIONS[kind]
        if kind == "svg" and figure.title:      # what a screen reader says of it
            options = {"metadata": {**options["metadata"], "Title": cleaned(figure.title)}}
        drawn(figure, inches).savefig(data, format=kind, dpi=style.DOTS, **options)
    return data.getvalue()


def _settings(defaults: Mapping[str, Any]) -> dict[str, Any]:
    """Matplotlib's own settings, whatever a file of the user's says; to ask for a backend would import pyplot."""
    return {name: value for name, value in defaults.items() if not name.startswith("backend")} | style.RC
