"""The section on frequency equations as it is printed, read back: its lines, and what they say of numbers."""

import re

import numpy as np
from support.formulas import plain, symbol, value

from vibcli.analyses.continuous.shapes import shape_along
from vibcli.notation.plain import plain as write_plain
from vibcli.report.blocks import Equations, Words
from vibcli.report.document import Report
from vibcli.report.formats.formula import formula

NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)
INTEGRAL = re.compile(r"∫(.*?)·?X_i·X_j·d.(?: \((\w+)\))?(?: \((.*?) < . < (.*?)\))?(?= [+−=])")
MOTION = re.compile(r"(∂?)X_([ij])(?:/∂.)?\((.*?)\)(?: \((\w+)\))?(?=·| |$)")


def printed(scene):
    """[[line]] as text: the lines on frequency equations of a scene, those of each apart."""
    report = Report(scene)
    report.add("frequency_equation")
    assert report.refusal is None
    return [["".join(_told(one)) for one in block.lines] for section in report.sections for block in section.blocks
            if isinstance(block, Equations)]


def _told(one):
    """A line, words within it in their place."""
    yield "".join(part.text if isinstance(part, Words) else formula([part], write_plain) for part in one.parts)


def numbers(scene):
    """The values of what a scene names, by what is printed of it."""
    return {symbol(write_plain.symbol(name)): one for name, one in scene.numeric.floats.items()}


def evaluated(text, names):
    """The number that a text stands for."""
    return value(plain(text.replace("\u00a0", " ")), {"π": np.pi, **names}.__getitem__)


def orthogonality(scene, text, members, modes):
    """(what a printed sum of products is for two modes, the sum of the magnitudes of its terms)."""
    names, shapes = numbers(scene), [scene.modal.fields(mode) for mode in modes]
    text, _, meaning = text.partition(" = 0")
    pieces = [(owner, moved) for owner in members for moved in shapes[0].pieces(owner)]
    letters = dict(re.findall(r"(\w) that of ([^,\s]+)", meaning))
    coordinates = {write_plain.symbol(name): i for i, name in enumerate(scene.scene.coordinates)}

    def along(owner, which, place, row):
        return float(shape_along(shapes[which].pieces(owner), [place])[0][int(row)])

    def integral(match):
        factor, owner, start, end = match.groups()
        total = 0.0
        for name in [owner] if owner else members:
            own = [moved for one, moved in pieces if one == name]
            low = evaluated(start, names).real if start else own[0].start
            high = evaluated(end, names).real if end else own[-1].start + own[-1].piece.length
            for moved in own:
                a, b = max(low, moved.start), min(high, moved.start + moved.piece.length)
                if b - a > 1e-9:
                    places = (a + b) / 2 + (b - a) / 2 * NODES
                    one, other = (shape_along(shape.pieces(name), places)[:, 0] for shape in shapes)
                    total += (b - a) / 2 * float(WEIGHTS @ (one * other))
        names[f"I{len(names)}"] = total
        return f"{factor or '1'}·I{len(names) - 1}"

    def motion(match):
        slope, mode, place, owner = match.groups()
        names[f"X{len(names)}"] = along(owner or members[0], "ij".index(mode), evaluated(place, names).real,
                                        bool(slope))
        return f"X{len(names) - 1}"

    text = MOTION.sub(motion, INTEGRAL.sub(integral, text + " =").removesuffix(" ="))
    for letter, name in letters.items():
        for which, mode in enumerate("ij"):
            names[f"{letter}{mode}"] = float(modes[which].shape[coordinates[name]])
    terms = re.split(r" [+−] (?![^(]*\))", text)
    return evaluated(text, names).real, sum(abs(evaluated(one.lstrip("−"), names)) for one in terms)
