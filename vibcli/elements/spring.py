"""Linear springs between two ends: V = N d + ½ k d², d being the stretch from the drawn length.

With a free length ℓ₀, or a `stretch` written out, d is what it says and N = 0, or with a preload the tension as drawn
counts: N + k (d − d_drawn). Stretch, tension and preload are positive in lengthening.
"""

from vibcli import units
from vibcli.fields import ENDS, Choice, Element, Expression, Field, Kind, OneOf, Quantity


class _Preload(Kind):
    """A force (of a torsion spring a moment), or the word static."""

    wants = "a force, or the word static"

    def read(self, node, reader):
        if getattr(node, "text", None) == "static":
            return "static"
        return Quantity().read(node, reader)

    def schema(self):
        return OneOf(self.wants, scalar=Choice("static")).schema() | {"anyOf": [{"const": "static"}, {"type": [
            "string", "number"]}]}



def _settle(record, reader):
    torsion = "torsion" in record
    if "stretch" in record:
        record["stretch"].dimension = units.NONE if torsion else units.LENGTH
    if isinstance(record.get("preload"), Expression):
        record["preload"].dimension = units.parse_unit("N*m" if torsion else "N").dimension


ELEMENT = Element(
    "spring",
    "A linear spring between two ends: places, points, bodies, or `ground`. It is undeformed as drawn unless "
    "`free_length` or `preload` says otherwise. `torsion` turns between two bodies; `stretch` gives the deflection "
    "outright where no geometry is at hand.",
    {
        "k": Field(Quantity("N/m"), "its stiffness, force per length"),
        "torsion": Field(Quantity("N*m"), "its torsional stiffness, moment per radian"),
        "between": Field(ENDS, "its two ends [A, B]; the stretch grows as B leaves A"),
        "stretch": Field(Quantity(), "the deflection as an expression of the coordinates, instead of two ends"),
        "free_length": Field(Quantity("m"), "its length when undeformed"),
        "preload": Field(_Preload(), "its tension as drawn; `static`: just what makes the drawn position the "
                         "equilibrium"),
    },
    exclusive=(("k", "torsion"), ("between", "stretch"), ("free_length", "preload"),
               ("free_length", "stretch"), ("free_length", "torsion")),
    needs=(("k", "torsion"), ("between", "stretch")),
    settle=_settle,
    instead={"law": "a nonlinear law is written as its potential under energies", "series": "k: k1*k2/(k1 + k2)",
             "parallel": "write two springs with the same ends, or k: k1 + k2"},
    example="preloaded_spring",
)


def build(record, scene):
    """Add the potential energy of a spring to the scene."""
    torsion = "torsion" in record
    k = scene.lower(record["torsion" if torsion else "k"])
    preload = _preload(record, scene)
    if "free_length" in record and "between" in record:
        free = scene.positive(record["free_length"], "the free length", zero=True)
        dx, dy = scene.span(record)
        if dx is None or scene.moving(record, dx if dx.mask else dy) is None:
            return
        if free.is_zero:
            scene.add_spring(k, preload, dx)
            scene.add_spring(k, preload, dy)
        elif (length := scene.length(record, dx, dy)) is not None:
            scene.add_spring(k, preload, length - free)
        return
    stretch = scene.stretch(record, torsion)
    if stretch is None:
        return
    if "preload" in record and "stretch" in record:
        preload = preload - k * scene.at_drawn(stretch)[0]  # the tension as drawn, where the stretch need not be zero
    scene.add_spring(k, preload, stretch)


def _preload(record, scene):
    if "preload" not in record:
        return scene.table.zero
    if record["preload"] == "static":
        return scene.static_preload(record)
    return scene.lower(record["preload"])
