"""Which keys of a body go together: sizes with their shape, a motion with a place, an inertia with what turns."""

from vibcli.elements.shapes import NEEDS
from vibcli.language.reader import Reader, Record, article

SIZES = ("radius", "half_angle", "width", "height", "a", "b", "from", "to", "angle")
SLENDER = ("rod", "ring", "arch")
TURNED = ("rectangle", "ellipse", "sector", "arch")
LOOKS = ("bar", "slab", "frame", "tube", "cam")
NO_PLACE = "say where it is drawn with `at: [x, y]`, or lump it: `slide: x` or `turn: phi`"


def part(record: Record, reader: Reader) -> None:
    """A part of a body: its density is per length of a rod, ring or arch, per area of the rest."""
    shape = record.get("shape", "particle")
    if "density" in record:
        reader.measured(record, "density", "kg/m" if shape in SLENDER else "kg/m^2")
        if shape == "particle":
            reader.report(record.place("density"), "a particle has no area or length", "give its mass, or its shape")
    missing = [key for key in NEEDS[shape] if key not in record]
    if missing:
        reader.report(record.where, f"{article(shape)} needs " + " and ".join(f"'{key}'" for key in missing),
                      "; ".join(f"{key}: {record.element.fields[key].about}" for key in missing[:2]))
    for key in record.places:
        if key in SIZES and key not in NEEDS[shape] and not (key == "angle" and shape in TURNED):
            reader.report(record.place(key), f"'{key}' says nothing about {article(shape)}",
                          "leave it out, or name another `shape`")


def body(record: Record, reader: Reader) -> None:
    """A body: as its shape, and with a motion that fits whether it has a place."""
    if "parts" not in record:
        part(record, reader)
    for key in SIZES if "parts" in record else ():
        if key in record:
            reader.report(record.place(key), f"'{key}' belongs to a part", "write it in the part that it describes")
    if "gyration" in record and not {"mass", "density", "parts"} & set(record.places):
        reader.report(record.place("gyration"), f"'{record.name}' has a radius of gyration but no mass",
                      "give its mass too, or `inertia` instead")
    if "looks" in record:
        _looks(record, reader)
    if any(key in record for key in ("at", "from", "to", "parts")):
        if "turn" in record:
            reader.report(record.place("turn"), f"'{record.name}' has a place, so it turns about a point",
                          "write `pin: {at: …, by: …}`")
    elif "slide" in record or "turn" in record:
        _lumped(record, reader)
    else:
        motion = next((key for key in ("pin", "roll", "move", "weld", "clamp") if key in record), None)
        reader.report(record.where, f"'{record.name}' has no place" + (f" but a '{motion}'" if motion else
                                                                       " and no motion"), NO_PLACE)


def _lumped(record: Record, reader: Reader) -> None:
    """A body without a place slides or turns on the one axis."""
    if "turn" in record:
        has_inertia = "inertia" in record or "gyration" in record or NEEDS[record.get("shape", "particle")]
        if "mass" in record and not has_inertia:
            reader.report(record.where, f"'{record.name}' turns: it needs an inertia, not only a mass",
                          "give `inertia: J`, `gyration: i` or a shape")
        return
    if not set(record["slide"]) <= {"by", "carrier"}:
        reader.report(record.place("slide"), f"'{record.name}' slides along something but has no place",
                      "say where it is drawn with `at: [x, y]`")
    for key in ("inertia", "gyration"):
        if key in record:
            reader.report(record.place(key), f"'{record.name}' slides: its moment of inertia plays no part",
                          "give `mass: m`, or let it turn with `turn: phi`")


def _looks(record: Record, reader: Reader) -> None:
    """What a body is drawn as: a slab or cam has a place; a tube of liquid has none."""
    word, placed = record["looks"], "at" in record
    if word == "cam" and not (placed and {"slide", "pin"} & set(record)):
        reader.report(record.place("looks"), f"'{record.name}' is neither lifted by a cam nor one: it does not slide "
                      "from a place, nor turn about a pin", "give it `at: [x, y]` and `slide: {along: [0, 1], by: …}`, "
                      "a cam `pin: {at: [0, 0], by: …}`")
    elif word == "tube" and (placed or "slide" not in record):
        reader.report(record.place("looks"), f"'{record.name}' is no column of liquid in a tube, which only slides",
                      "give it `slide: x` and no place")
    elif not placed and (word == "slab" or "slide" not in record):
        reader.report(record.place("looks"), f"'{record.name}' has no place, so it cannot look like {article(word)}",
                      "say where it is drawn with `at: [x, y]`, or leave `looks` out")
