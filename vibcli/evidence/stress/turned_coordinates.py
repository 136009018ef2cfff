"""Which coordinates of a scene have the other sign in a mirror: those that are counted by the axes of the picture, or
counter-clockwise; and which lines and members stand in the plane."""

import re

from vibcli.language.document.nodes import Mapping, Scalar, Sequence

ACROSS = ("beams", "strings")
TURNS = {"pin": ("by",), "turn": ("by",), "move": ("by",), "roll": ("turn", "swing")}
PLAIN = re.compile(r"[^\W\d]\w*")


def turned_round(top: Mapping) -> frozenset[str]:
    """The names of coordinates that have the other sign in the mirror."""
    found: set[str] = set()
    bodies = top.entries.get("bodies", (None, None))[1]
    for _, record in bodies.entries.values() if isinstance(bodies, Mapping) else ():
        for kind, keys in TURNS.items():
            motion = record.entries.get(kind, (None, None))[1] if isinstance(record, Mapping) else None
            for key in keys if isinstance(motion, Mapping) else keys[:1]:
                found |= _names(motion.entries.get(key, (None, None))[1] if isinstance(motion, Mapping) else motion)
        slide = record.entries.get("slide", (None, None))[1] if isinstance(record, Mapping) else None
        if isinstance(slide, Mapping) and "surface" in slide.entries and not on_a_line(slide, lines_of(top)):
            found |= _names(slide.entries["by"][1])
    return frozenset(found)


def lines_of(top: Mapping) -> frozenset[str]:
    """The names of the surfaces that are lines, on which paths count from the first place on."""
    surfaces = top.entries.get("surfaces", (None, None))[1]
    return frozenset(name for name, (_, record) in surfaces.entries.items() if isinstance(record, Mapping)
                     and "line" in record.entries) if isinstance(surfaces, Mapping) else frozenset()


def on_a_line(slide: Mapping, lines: frozenset[str]) -> bool:
    """Does something slide on one of these surfaces?"""
    return slide.entries["surface"][1].text.strip() in lines


def drawn_members(top: Mapping) -> frozenset[str]:
    """The members in the plane."""
    sections = (top.entries[kind][1] for kind in ACROSS if kind in top.entries)
    return frozenset(name for section in sections if isinstance(section, Mapping)
                     for name, (_, record) in section.entries.items()
                     if isinstance(record, Mapping) and "from" in record.entries)


def _names(motion: Scalar | Sequence | None) -> set[str]:
    """Of a motion, or of [x, y, phi], those that are counted by the axes."""
    parts = motion.items[::2] if isinstance(motion, Sequence) else [motion]
    return {part.text.strip() for part in parts if isinstance(part, Scalar) and PLAIN.fullmatch(part.text.strip())}
