"""References by name: each names something of its namespace, and no name stands for two things."""

import re
from typing import TYPE_CHECKING

from vibcli.base.diagnostics import quoted
from vibcli.base.spelling import nearest
from vibcli.language.kinds import in_square_brackets
from vibcli.language.reader import article
from vibcli.language.spec import MEMBERS

if TYPE_CHECKING:
    from collections.abc import Container

    from vibcli.language.reader import Reader
    from vibcli.language.spec import Spec

STILL = {"wall", "floor", "ceiling", "frame", "earth", "fixed", "support", "base", "foundation", "0"}
_KINDS = {"points": "point", "surfaces": "surface", "forces": "force", "bodies": "body", "coordinates": "coordinate",
          "members": "member"}
# the sections whose names stand before `.force`
_WITH_FORCES = {"springs": "spring", "dampers": "damper", "inerters": "inerter", "forces": "force",
                "constraints": "constraint"}


def check_references(spec: "Spec", reader: "Reader") -> None:
    """Every reference must name something of its namespace; points and bodies share one namespace."""
    spaces = {space: dict.fromkeys(spec.named.get(space, ())) for space in ("points", "bodies", "surfaces", "forces")}
    spaces["members"] = dict.fromkeys(reader.members)
    spaces |= {"ground": {"ground": None}, "coordinates": spec.coordinates}
    _of_one_name(spec, reader, spaces)
    _of_one_force(spec, reader)
    for name, namespaces, wants in reader.references:
        if name.text in reader.lost or any(name.text in spaces[space] for space in namespaces) or (
                namespaces == ("coordinates",) and not reader.sound):
            continue
        valid = [word for space in namespaces for word in spaces[space]]
        if "points" not in namespaces and "bodies" in namespaces and name.text in spaces["points"]:
            wanted = wants if "members" in namespaces else "the name of a body"
            reader.report(name.where, f"'{name.text}' is a point, expected {wanted}",
                          nearest(name.text, spaces["bodies"]) or "a point moves nothing but what is pinned or sprung "
                          "there: draw a body at it, and give that the motion")
            continue
        if namespaces == ("points",) and name.text in spaces["bodies"]:
            reader.report(name.where, f"'{name.text}' is a body, expected {wants}",
                          "name the place under `points`, and draw both there")
            continue
        if name.text == "ground" and "points" in namespaces and "place" in wants:
            reader.report(name.where, f"expected {wants}, found 'ground'", "a place on the ground is written [x, y]")
            continue
        if name.text in spaces["members"] and "points" in namespaces:
            reader.report(name.where, f"'{name.text}' is a member, expected {wants}",
                          f"a place on it is a point, `points: {{p: {{body: {name.text}, at: …}}}}`")
            continue
        if namespaces == ("coordinates",) and (written := _as_written(name.text, valid)):
            reader.report(name.where, f"there is no coordinate {quoted(name.text)}", f"write {written}")
            continue
        if name.text.lower() in STILL and "ground" in valid:
            reader.report(name.where, f"there is no point or body {quoted(name.text)}",
                          "what stands still is called ground, a place on it is written [x, y]")
            continue
        kind = " or ".join(_KINDS[space] for space in namespaces if space in _KINDS)
        reader.report(name.where, f"there is no {kind} {quoted(name.text)}",
                      in_square_brackets(name.text) or nearest(name.text, valid) or f"expected {wants}")


def _as_written(text: str, coordinates: "Container[str]") -> str | None:
    """What x(0), x_dot or x'(0) are at a start, x or x'; None of what is no coordinate then either."""
    written = re.sub(r"_?dot$", "'", re.sub(r"\(0(?: s)?\)$", "", text))
    return written if written != text and written.rstrip("'") in coordinates else None


def _of_one_name(spec: "Spec", reader: "Reader", spaces: dict[str, dict[str, None]]) -> None:
    """Points, bodies and members share one namespace."""
    for name, record in (*(spec.get("points") or {}).items(), *(spec.get("member_points") or {}).items()):
        if name in spaces["bodies"]:
            reader.report(record.where, f"'{name}' is a point and a body", "rename one of them")
    seen = dict.fromkeys(spaces["points"], "a point") | dict.fromkeys(spaces["bodies"], "a body")
    for section in MEMBERS if reader.members else ():
        for name, record in (spec.get(section) or {}).items():
            if name in seen or name == "ground":
                kind = seen.get(name, "the ground")
                reader.report(record.where, f"'{name}' is {kind} and a {section[:-1]}", "rename one of them")
            seen[name] = f"a {section[:-1]}"


def _of_one_force(spec: "Spec", reader: "Reader") -> None:
    """Kinetic energy is told by the names of bodies and inerters, forces within members and of elements by theirs."""
    seen = {name: section[:-1] for section in MEMBERS if reader.members for name in spec.get(section) or ()}
    for section, kind in _WITH_FORCES.items():
        for name, record in (spec.get(section) or {}).items():
            other = seen.get(name) or (kind == "inerter" and name in spec.named.get("bodies", ()) and "body")
            if other:
                reader.report(record.where, f"'{name}' is {article(other)} and {article(kind)}", "rename one of them")
