"""The data of a plot, before any paper: curves in panels, panels in a figure. Labels are plain text, `x [mm]`."""


from vibcli.base.named_tuple import NamedTuple


class Curve(NamedTuple):
    """Points in the units of the panel's labels; NaN breaks the line. `names`: a text beside each point, '' for none.

    Kinds: `line`; `steady`, the part that stays; `envelope`, bounds of a line; `guide`, a thin line of reference
    without entry in the legend; `markers`, points; `orbit`, many lines that are drawn thin and alike; `arrow`, of two
    points, its head at the second.
    """

    label: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    kind: str = "line"
    names: tuple[str, ...] = ()


class Mark(NamedTuple):
    """A thin line across the panel at x = `at`: a resonance, an antiresonance."""

    at: float
    label: str = ""


class Panel(NamedTuple):
    """Axes with their curves. `equal`: one scale for both; `degrees`: ticks of y at parts of a turn; `tall`: height as
    a part of the usual one."""

    x_label: str
    y_label: str
    x_log: bool = False
    y_log: bool = False
    curves: tuple[Curve, ...] = ()
    marks: tuple[Mark, ...] = ()
    equal: bool = False
    degrees: bool = False
    tall: float = 1.0
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None


class Figure(NamedTuple):
    """Panels one below the other; those that follow each other with the same x share its ticks."""

    title: str
    panels: tuple[Panel, ...]
