"""Modes of scenes with members that have inertia: shapes along members."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.normalisation import words
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Section, TableBlock, note, section
from vibcli.report.keys import Key
from vibcli.report.own_letters import own_letters

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.continuous.mode_fields import ModeFields
    from vibcli.analyses.continuous.shapes import Moved
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.elements.member_fields import MemberKind
    from vibcli.results.problem import Problem

LISTED = 6                  # nodes, and antinodes, in a line of the table
NOTHING = 1e-15             # of the largest displacement
PLACES, PER_NODE = 101, 16  # along a member in the JSON
FORCES = {"bar": "force", "shaft": "moment"}      # what u′ times the stiffness is


def along_members(problem: "Problem", modes: "Sequence[Mode]", how: str) -> Iterator[Section]:
    """Of each member a table: the largest displacement in each mode, where it rests and where it moves most."""
    stated = None if problem.scene.coordinates else note(words(how, problem.scene.members))
    others = own_letters(problem.scene).others
    for name, member in problem.scene.members.items():
        rows = []
        for mode in modes:
            fields, scale = _told(problem, mode, how)
            place, largest = fields.largest(name)
            rows.append((str(mode.index), *_row(place, largest * scale, fields.nodes_in_floats(name),
                                                fields.antinode_places(name))))
        motion = "φ" if member.kind.torsional else member.kind.letter
        x, moved = (others.get(letter, letter) for letter in ("x", motion))
        head = ("mode", f"largest {moved}", f"at {x} [m]", f"nodes at {x} [m]", f"antinodes at {x} [m]")
        yield from section(f"Modes along {name}", TableBlock(head, tuple(rows)), stated)


def _told(problem: "Problem", mode: "Mode", how: str) -> "tuple[ModeFields, Any]":
    """(its ModeFields, what they are multiplied by, in floats), found in more digits where floats mix it with
    another."""
    told = problem.modal.told_apart(mode)
    scale = problem.modal.scale(told, how)
    return problem.modal.fields(told), complex(scale) if scale.imag else float(scale.real)


def _row(place: "float | mpmath.mpf", largest: "float | mpmath.mpf", nodes: list[float],
         antinodes: list[float]) -> tuple[str, str, str, str]:
    if not largest:
        return "0", "–", "rests", "–"
    size = f"{abs(complex(largest)):.6g}" if largest.imag else figure(float(largest.real))
    return size, figure(float(place)), _listed(nodes), _listed(antinodes)


def _listed(places: list[float]) -> str:
    told = ", ".join(figure(x) for x in places[:LISTED]) + (
        f", … ({len(places)} in all)" if len(places) > LISTED else "")
    return told or "none"


def member_shapes(problem: "Problem", index: int, how: str) -> dict[str, dict[str, Any]]:
    """{member: its shape in a mode, with the keys of MEMBERS}."""
    fields, scale = _told(problem, *problem.modal.modes.numbered(index, index), how)
    return {name: _shape(member.kind, fields.in_floats(name), scale, float(fields.largest(name)[0]))
            for name, member in problem.scene.members.items()}


def _shape(kind: "MemberKind", pieces: "list[Moved]", scale: float, top: float) -> dict[str, list[float] | None]:
    """x, u and what follows of it; `top`: where the member moves most."""
    import numpy as np

    from vibcli.analyses.continuous.shapes import antinodes, resting_and_turning, shape_along

    resting, turning = resting_and_turning(pieces)
    starts = np.array([moved.start for moved in pieces])
    end, count = pieces[-1].start + pieces[-1].piece.length, max(PLACES, PER_NODE * (len(resting) + 1) + 1)
    places = np.unique([*np.linspace(starts[0], end, count), *starts, *resting, *turning, top])
    values = shape_along(pieces, places).T * scale
    values[0][abs(values[0]) < NOTHING * abs(values[0]).max()] = 0
    which = np.maximum(np.searchsorted(starts, places, side="right") - 1, 0)
    stiffness = np.array([moved.piece.bending or moved.piece.tension for moved in pieces])[which]
    forces: dict[str, Any] = {"moment": None, "shear": None, "force": None}
    if kind.bends:
        forces |= {"moment": stiffness * values[2], "shear": stiffness * values[3]}
    elif kind.name in FORCES:
        forces[FORCES[kind.name]] = stiffness * values[1]
    forces = {name: value if value is None else value.tolist() for name, value in forces.items()}
    return {"x": places.tolist(), "u": values[0].tolist(), "slope": values[1].tolist(), **forces,
            "nodes": resting, "antinodes": antinodes(pieces, turning)}


MEMBERS = Key("members", "of scenes with members that have inertia: {name: its shape}", of=(
    Key("NAME", "the shape of a member; of a beam that stretches `NAME.along` besides, what it does along", of=(
        Key("x", "places from the left end on [m], nodes and antinodes among them"),
        Key("u", "displacements there, of shafts turns, normalised as the coordinates are"),
        Key("slope", "u′ there"),
        Key("moment", "EI u″, of shafts GI_o φ′; null of others"),
        Key("shear", "(EI u″)′ of beams; null of others"),
        Key("force", "EA u′ of bars, and of beams along; null of others"),
        Key("nodes", "the places at rest, ends and supports not counted"),
        Key("antinodes", "the places that move more than those around them, ends among them"))),))
COUNT = Key("count", "of scenes with members that have inertia: how many modes are certain to have at most the "
            "frequency of the last one, by a count just above it; null where that does not tell")
