"""Springs between two ends: V = N d + ½ k d², or the integral of a law, d being the stretch from the drawn length.

With a free length ℓ₀, or a `stretch` written out, d is what it says and N = 0, or with a preload the tension as drawn
counts: N + k (d − d_drawn). Stretch, tension and preload are positive in lengthening. One-sided springs and stops act
beyond their gap g alone: through max(d − g, 0) where they pull, min(d + g, 0) where they push.
"""

from typing import TYPE_CHECKING, Any

from vibcli.elements import ends
from vibcli.elements.torsion import Torsion, settle_torsion
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import ENDS, Choice, Kind, Many, Quantity
from vibcli.language.named_elements import Lazy, LazyKind
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.elements.composition import Component
    from vibcli.language.reader import Reader, Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

    Found = tuple[Node | None, tuple[Node, Node] | None, Component | None]

PARTS = "series", "parallel"


class _Preload(Kind):
    """A force (of a torsion spring a moment), or the word static."""

    wants = "a force, or the word static"

    def read(self, node: Any, reader: Any) -> Any:
        if getattr(node, "text", None) == "static":
            return "static"
        return Quantity().read(node, reader)

    def schema(self) -> dict[str, Any]:
        return {"anyOf": [{"const": "static"}, {"type": ["string", "number"]}]}


def _settle(record: "Record", reader: "Reader") -> None:
    if any(key in record for key in PARTS):
        from vibcli.elements.series import settle_parts

        settle_parts(record, reader)
    settle_torsion(record, reader, ("preload", "law"), "d", rate=False)
    if "acts" in record and record.get("preload") == "static":
        reader.report(record.place("preload"), "a one-sided spring has no static preload", "give its tension as drawn")


ELEMENT = Element(
    "spring",
    "A spring between two ends: places, points, bodies, or `ground`. It is undeformed as drawn unless "
    "`free_length` or `preload` says otherwise. `torsion` turns between two bodies; `stretch` gives the deflection "
    "outright where no geometry is at hand. A `law` makes it nonlinear; `acts` and `gap` make it a stop, or a cable "
    "that goes slack.",
    {
        "k": Field(Quantity("N/m"), "its stiffness, force per length"),
        "torsion": Field(Torsion("N*m"), "its torsional stiffness, moment per radian; `true` beside a law"),
        "law": Field(LazyKind("law_table", "language.sections"),
                     "its tension as a function of the deflection d, as in k*d + k3*d^3 (d means this only inside a "
                     "law), or a table: points, or {table: a file or points, columns: [1, 2], units: [mm, N], beyond: "
                     "linear}"),
        "series": Field(Many(Lazy("spring_part"), 2, named="a list of two parts or more"),
                        "its parts one behind the other, which share the force: [{k: k1}, {k: k2}]; where one "
                        "softens or goes slack they are followed from rest, up to where they snap"),
        "parallel": Field(Many(Lazy("spring_part"), 2, named="a list of two parts or more"),
                          "its parts side by side, which share the deflection; nested in `series` or alone"),
        "between": Field(ENDS, "its two ends [A, B]; the stretch grows as B leaves A"),
        "stretch": Field(Quantity(), "the deflection as an expression of the coordinates, instead of two ends"),
        "free_length": Field(Quantity("m"), "its length when undeformed"),
        "preload": Field(_Preload(), "its tension as drawn; `static`: just what makes the drawn position the "
                         "equilibrium"),
        "acts": Field(Choice("tension", "compression"), "it only pulls (`tension`: a cable, slack when shorter), or it "
                      "only pushes (`compression`: a stop)"),
        "gap": Field(Quantity(), "how far the stretch goes before it acts; without `acts`, that much play to both "
                     "sides"),
    },
    exclusive=(("k", "torsion"), ("k", "law", *PARTS), ("between", "stretch"), ("free_length", "preload"),
               ("free_length", "stretch"), ("free_length", "torsion"), ("gap", "preload")),
    needs=(("k", "torsion", "law", *PARTS), ("between", "stretch")),
    settle=_settle,
    example="preloaded_spring",
    instead={"tension": "did you mean 'preload'?", "stiffness": "did you mean 'k'?", "kt": "did you mean 'torsion'?",
             "l0": "did you mean 'free_length'?"},
    signals={"stretch": ("m", "rad"), "deflection": ("m", "rad"), "force": ("N", "N*m"), "energy": ("J", "J")},
)


def build(record: "Record", scene: "Builder") -> None:
    """Add the potential energy of a spring to the scene."""
    torsion, d = "torsion" in record, scene.table.variable("the deflection")
    found = _stiffness_or_law(record, scene, d)
    if found is None:
        return
    k, *_ = found
    preload = _preload(record, scene)
    if "free_length" in record and "between" in record:
        free = scene.positive(record["free_length"], "the free length", zero=True)
        dx, dy = ends.span(record, scene)
        if dx is None or ends.moving(record, scene, dx if dx.mask else dy) is None:
            return
        if free.is_zero and k is not None and not ("acts" in record or "gap" in record):
            scene.add_spring(k, preload, dx)
            scene.add_spring(k, preload, dy)
        elif (length := ends.length(record, scene, dx, dy)) is not None:
            _add(record, scene, found, preload, length - free)
        return
    stretch = ends.stretch(record, scene, torsion)
    if stretch is None:
        return
    if "preload" in record and "stretch" in record:
        drawn, = scene.at_drawn(stretch)        # which need not be zero; the preload is the tension there
        if k is None:
            stretch = stretch - drawn
        else:
            preload = preload - k * drawn
    _add(record, scene, found, preload, stretch)


def _stiffness_or_law(record: "Record", scene: "Builder", d: "Node") -> "Found | None":
    """(k or None, (force, energy) as functions of d or None, its parts if it has any); None where it was reported as
    wrong."""
    if "law" in record:
        from vibcli.elements.force_laws import force_and_energy

        found = force_and_energy(record, scene, "d", d, record.name)
        return None if found is None else (None, found, None)
    if not any(key in record for key in PARTS):
        return scene.lower(record["torsion" if "torsion" in record else "k"]), None, None
    from vibcli.elements.composition import composed, stiffness

    parts = composed(record, scene, d, record.name)
    return None if parts is None else (stiffness(parts, d), parts[:2], parts)


def _add(record: "Record", scene: "Builder", found: "Found", preload: "Node", stretch: "Node") -> None:
    k, law, parts = found
    d, one_sided = scene.table.variable("the deflection"), "acts" in record or "gap" in record
    if one_sided and k is not None:
        stretch = stretch + preload / k     # of a cable or stop under load: where its tension would vanish
    if k is None:
        if one_sided and not _begins_softly(record, scene, law[0], d):
            return
        before = _undeformed(record, scene, found, d, preload)
        if before is None:
            return
        stretch = stretch + before
    taken = _beyond_the_gap(record, scene, d) if one_sided else [d]
    if parts is not None:
        _add_parts(scene, parts, d, substitute([scene.table.total(taken)], {d: stretch})[0])
    if k is not None and not one_sided:
        scene.add_spring(k, preload, stretch)
        return
    energy = k * d * d * HALF if k is not None else law[1]
    scene.add_law(stretch, d, scene.table.total([substitute([energy], {d: u})[0] for u in taken]))


def _undeformed(record: "Record", scene: "Builder", found: "Found", d: "Node", preload: "Node") -> "Node | None":
    """The deflection as drawn of a law, or of parts that share a tension; None where it was reported."""
    if preload.is_zero:
        return preload
    _, (force, _), parts = found
    if parts is not None:
        from vibcli.elements.composition import deflection_under

        return deflection_under(record, scene, parts, d, preload)
    from vibcli.elements.preloaded_law import undeformed

    return undeformed(record, scene, force, d, preload)


def _add_parts(scene: "Builder", parts: "Component", d: "Node", deflection: "Node") -> None:
    """The stretches of the parts, which may be asked for."""
    from vibcli.elements.composition import inner_deflections

    for path, node in inner_deflections(parts, d):
        scene.add_inner_stretch(path, substitute([node], {d: deflection})[0])


def _begins_softly(record: "Record", scene: "Builder", law: "Node", d: "Node") -> bool:
    """Does a one-sided law start from zero force, with a preload of the sense in which it acts? If not, it is
    reported."""
    if scene.number(*substitute([law], {d: scene.table.zero})):
        where = record["law"].where if "law" in record else record.where
        scene.report(where, f"the law of '{record.name}' begins with a force at d = 0",
                     "a one-sided law starts from zero force; a cable under load has a `preload`")
        return False
    side = {"tension": 1, "compression": -1}.get(record.get("acts"))
    if "preload" in record and side and scene.number(scene.lower(record["preload"])) * side < 0:
        scene.report(record.place("preload"), f"'{record.name}' acts in {record['acts']} alone: it bears no such "
                     "preload", "mind the sign: tension is positive")
        return False
    return True


def _beyond_the_gap(record: "Record", scene: "Builder", d: "Node") -> "list[Node]":
    """[max(d − g, 0)] where it pulls, [min(d + g, 0)] where it pushes, both where it does either."""
    gap = scene.positive(record["gap"], "the gap", zero=True) if "gap" in record else scene.table.zero
    found = []
    if record.get("acts") != "compression":
        found.append(scene.table.call("max", d - gap, scene.table.zero))
    if record.get("acts") != "tension":
        found.append(scene.table.call("min", d + gap, scene.table.zero))
    return found


def _preload(record: "Record", scene: "Builder") -> "Node":
    if "preload" not in record:
        return scene.table.zero
    if record["preload"] == "static":
        return scene.static_preload(record)
    return scene.lower(record["preload"])
