"""A scene without bodies: a box that says what is given, with an arrow for each coordinate."""

from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import ELEMENT, Polygon, Polyline
from vibcli.drawing.layout import lettering, plane
from vibcli.drawing.symbols import arrow

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene

HEIGHT, STEP, EDGE = 46.0, 58.0, 26.0


def draw(scene: "Scene") -> list[Any]:
    """The primitives, words included."""
    names = list(scene.spec.coordinates)
    given = "given by its energies"
    if "matrices" in scene.spec.sections:
        given = "given by " + ", ".join(key for key in "MCK" if key in scene.spec.get("matrices"))
    runs = lettering.words(given)
    wide = max(lettering.width(runs) + 2 * EDGE, STEP * len(names))
    found = [Polygon(tuple(plane.box((wide / 2, 0.0), wide, HEIGHT)), layer=ELEMENT),
             lettering.text(runs, (wide - lettering.width(runs)) / 2, -6.0)]
    for i, name in enumerate(names):
        x, y = (i + 0.5) * wide / len(names) - 14, HEIGHT / 2 + 9
        found += [Polyline(((x, y - 5), (x, y + 5)), "coordinate", 0.9),
                  *arrow.straight((x, y), (x + 24, y), "coordinate"),
                  lettering.text(lettering.named(name), x + 6, y + 5, "coordinate")]
    return found
