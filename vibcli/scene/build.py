"""Spec to Scene: the elements contribute, what is driven is put in, constraints are closed last."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from vibcli.base.errors import SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.scene.builder import Builder
from vibcli.scene.contents import TERMS
from vibcli.scene.scene import Drives, Scene
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.parameters import Parameters
    from vibcli.language.spec import Spec
    from vibcli.scene.builder import Reports
    from vibcli.scene.member_tensions import Tensions

ATTEMPTS = 12


class Variant(NamedTuple):
    """What a scene is beside that of its file: its constraints held by multipliers, its supports `released`, its drives
    and loads as further coordinates, the `inputs`; `preloaded`: with the force that lets go where the motion starts;
    `stretched`: its beams and strings in the plane cut open at their stations, to find their tension, without what
    bends, or as they bend, `opened`; `tensions`: {member: [N of each piece]} that are not those of statics alone."""

    multipliers: bool = False
    released: bool = False
    inputs: bool = False
    preloaded: bool = False
    stretched: bool = False
    opened: bool = False
    tensions: "Mapping[str, list[Fraction]] | None" = None


class Setting(NamedTuple):
    """What is the same for a scene and those that are derived from it; `draw(attempt, variant)`: another Scene of the
    same file and values, which are what `draw.func` takes first."""

    spec: "Spec"
    attempt: int
    variant: Variant
    parameters: "Parameters"
    sample: dict[str, float]
    reports: "Reports"
    draw: partial[Scene]


def build_scene(spec: "Spec", given: "Mapping[str, Fraction] | None" = None,
                tensions: "Mapping[str, list[Fraction]] | None" = None,
                watched: Callable[[dict[str, float]], dict[str, float]] | None = None) -> Scene:
    """The Scene of a Spec, under the `tensions` of members that statics alone does not find; SpecError where its
    geometry contradicts itself. `watched`: as what the sample is that its numbers are read off, {name: float}.

    A scene with symbols is drawn with sample values, those that are `given` and others; signs such as that of R − r
    are those of the first sample in which the drawing fits together.
    """
    return _drawn(spec, given or {}, 0, Variant(tensions=tensions), watched)


def build_preloaded(spec: "Spec", given: "Mapping[str, Fraction]",
                    tensions: "Mapping[str, list[Fraction]] | None" = None) -> Scene:
    """The Scene under the force that lets go where its motion starts."""
    return _drawn(spec, given, 0, Variant(preloaded=True, tensions=tensions))


def _drawn(spec: "Spec", given: "Mapping[str, Fraction]", start: int, variant: Variant,
           watched: Callable[[dict[str, float]], dict[str, float]] | None = None) -> Scene:
    """The Scene of the first attempt in which the drawing fits together."""
    for attempt in range(start, start + ATTEMPTS):
        try:
            builder = Builder(spec, given, attempt, variant, _tensions(spec, given, attempt, variant, watched),
                              watched)
        except SpecError:   # a parameter that this sample leaves without value
            if attempt == start + ATTEMPTS - 1:
                raise
            continue
        scene = None
        try:
            scene = _assembled(builder, Setting(spec, attempt, variant, builder.parameters, builder.sample,
                                                builder.reports, partial(_drawn, spec, given, watched=watched)))
        except ExpressionError as error:
            builder.report(None, error.message)
        if not builder.diagnostics or not set(builder.parameters.free) - set(given):
            break
    builder.reports.finish()
    return scene


def _tensions(spec: "Spec", given: "Mapping[str, Fraction]", attempt: int, variant: Variant,
              watched: Callable[[dict[str, float]], dict[str, float]] | None) -> "dict[str, Tensions]":
    """{name: tension of each piece} of the beams and strings in the plane, as statics finds it; empty where none is."""
    if variant.stretched or not has_tensions(spec):
        return {}
    from vibcli.scene.member_tensions import tensions, under

    found = tensions(_drawn(spec, given, attempt, Variant(multipliers=True, stretched=True), watched))
    return under(found, variant.tensions) if variant.tensions else found


def has_tensions(spec: "Spec") -> bool:
    """Has a scene beams or strings in the plane?"""
    return any("from" in record for section in ("beams", "strings") for record in (spec.get(section) or {}).values())


def _assembled(builder: Builder, setting: Setting) -> Scene:
    """The Scene of what the elements contribute; None where they are wrong."""
    builder.add_elements()
    if builder.diagnostics:
        return None
    drives = builder.displacements
    scene = Scene(setting, builder.coordinates, builder.contents,
                  Drives(drives.driven, drives.inputs, drives.released, builder.idle))
    if scene.driven:
        scene = _driven(scene)
    if setting.variant.inputs:
        from vibcli.scene.inputs import with_input_loads

        scene = scene.with_parts(contents=with_input_loads(scene, drives.add_input))
    if scene.laws:
        scene = _with_laws(scene)
    if scene.constraints and not setting.variant.multipliers:
        from vibcli.scene.constraints import closed

        try:
            scene = closed(scene)
        except ZeroDivisionError:
            _report_singular(scene)
    last = scene.inputs if setting.variant.inputs else scene.released
    if last:
        order = [*(q for q in scene.q if q not in last), *last]
        scene = scene.with_parts(coordinates=scene.kinematics.keeping(order))
    return scene


def _driven(scene: Scene) -> Scene:
    """The scene with what is driven as functions of the time; what is driven to and fro is held as drawn in that at
    rest, while what turns or travels on does so."""
    still, drives = None, Drives({}, scene.inputs, scene.released)
    if scene.oscillating:
        still = scene.replaced(scene.held_drives, coordinates=scene.kinematics.apart(), drives=drives)
    shaken = {kind: getattr(scene, kind) for kind in TERMS if kind != "constraints"}
    moved = scene.replaced(scene.driven, still=still)
    return moved.with_parts(contents=moved.contents._replace(shaken=shaken))


def _with_laws(scene: Scene) -> Scene:
    """The scene with its laws added to V and Φ; so is that at rest."""
    energies = dict(scene.energies)
    for law in scene.laws:
        key = "Phi" if law.damper else "V"
        energies[key] = energies[key] + law.potential(scene)
    return scene.with_parts(contents=scene.contents._replace(energies=energies),
                            still=scene.still and _with_laws(scene.still))


def _report_singular(scene: Scene) -> None:
    """Name the constraints that have no slope as drawn, as of √x at x = 0."""
    for constraint in scene.constraints:
        try:
            scene.at_drawn(*gradient(constraint.node).values())
        except ZeroDivisionError:
            scene.report(constraint.where, f"the constraint '{constraint.name}' divides by zero as drawn",
                         "draw it in another position")
    if not scene.setting.reports.diagnostics:
        scene.report(scene.constraints[0].where, "these constraints divide by zero as drawn", "draw them elsewhere")
