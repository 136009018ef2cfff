"""The section on frequency equations as it is printed, read back: its lines, and what they say of numbers."""

import re
from functools import lru_cache, partial

import numpy as np
from support.formulas import plain, symbol, value

from vibcli.analyses.continuous.shapes import shape_along
from vibcli.notation.plain import plain as write_plain
from vibcli.report.blocks import Equations, Words
from vibcli.report.document import Report
from vibcli.report.formats.formula import formula

NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)
INTEGRAL = re.compile(r"∫(.*?)·?X_i·X_j·d.(?: \((\w+)\))?(?: \((.*?) < . < (.*?)\))?(?= [+−=])")
REPEATED = re.compile("and where the denominator of (.*) is 0")
DEFINED, POWERS = re.compile(r"([^\s=²⁴]+?)([²⁴]?) = (.*)$"), {"": 1, "²": 2, "⁴": 4}
UNIT = re.compile(r"(?<=\d) (?:1/)?[A-Za-z][A-Za-z/·²³⁴]*")      # behind a number
CUT = 1e-2      # of θ in a bed, below which a θ² or θ⁴ is lost in rounding
TRIVIAL = 1e-4      # of βL and θ
MOTION = re.compile(r"(∂?)X_([ij])(?:/∂.)?\((.*?)\)(?: \((\w+)\))?(?=·| |\)|$)")


@lru_cache(maxsize=1)
def blocks(scene):
    """[[Line]]: the lines on frequency equations of a scene, those of each apart."""
    report = Report(scene)
    report.add("frequency_equation")
    assert report.refusal is None
    return [list(block.lines) for section in report.sections for block in section.blocks
            if isinstance(block, Equations)]


def printed(scene):
    """The same as text."""
    return [["".join(told(one)) for one in lines] for lines in blocks(scene)]


def told(one):
    """A line, words within it in their place."""
    yield "".join(part.text if isinstance(part, Words) else formula([part], write_plain) for part in one.parts)


def numbers(scene):
    """The values of what a scene names, by what is printed of it."""
    return {symbol(write_plain.symbol(name)): one for name, one in scene.numeric.floats.items()}


def evaluated(text, names):
    """The number that a text stands for."""
    return value(plain(UNIT.sub("", text.replace("\u00a0", " "))), {"π": np.pi, **names}.__getitem__)


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
        owner = owner or next(iter(re.findall(rf" \(({'|'.join(members)})\)", match.string[match.end():])), None)
        names[f"X{len(names)}"] = along(owner or members[0], "ij".index(mode), evaluated(place, names).real,
                                        bool(slope))
        return f"X{len(names) - 1}"

    text = MOTION.sub(motion, INTEGRAL.sub(integral, text + " =").removesuffix(" ="))
    text = re.sub(rf" \((?:{'|'.join(members)})\)", "", text)
    for letter, name in letters.items():
        for which, mode in enumerate("ij"):
            names[f"{letter}{mode}"] = float(modes[which].shape[coordinates[name]])
    terms = re.split(r" [+−] (?![^(]*\))", text)
    return evaluated(text, names).real, sum(abs(evaluated(one.lstrip("−"), names)) for one in terms)


def _denominator(text):
    """What stands behind the last / outside of brackets."""
    depth = 0
    for at in range(len(text) - 1, -1, -1):
        depth += (text[at] == ")") - (text[at] == "(")
        if text[at] == "/" and not depth:
            return text[at + 1:]
    return ""


def _turned(number, theta):
    """What is real but for a power of θ, which may be complex, as a real number."""
    for k in range(4 if theta.imag else 0):
        if abs((found := number / theta ** k).imag) < 1e-6 * abs(found):
            return found
    return number


class PrintedEquation:
    """The lines on one equation: `sides` of the equation, and what each name in it is, {name: (power, text)}."""

    def __init__(self, lines):
        self.sides = lines[0].split(" = ")
        found = [DEFINED.match(line) for line in lines[1:]]
        self.repeated = [symbol(one[1]) for one in map(REPEATED.match, lines) if one]
        self.means = {symbol(one[1]): (POWERS[one[2]], re.split("   |,  ", one[3])[0]) for one in found if one}

    @property
    def variable(self):
        """What its roots are told in: βL, or ω."""
        named = [name for name, (_, text) in self.means.items() if name[0] == "θ" and re.search("β(?!L)", text)]
        return [*named, "βL"][0] if "ω" in self.means else "ω"

    @property
    def order(self):
        """4 of beams, whose (βL)⁴ may be negative, else 2."""
        return 4 if re.search("(βL.|θ)⁴", self.means.get("ω", (1, ""))[1]) else 2

    def names(self, at, numbers):
        """The values of all names where the variable has a value."""
        values = {"π": np.pi, **numbers, self.variable: at if at > 0 else abs(at) * 1j ** (2 / self.order)}

        def known(name):
            if name not in values:
                power, text = self.means[name]
                values[name] = value(plain(text), known) ** (1 / power)
            return values[name]
        return known

    def residual(self, at, numbers):
        """left − right, multiplied by the denominators of what has one."""
        try:
            return self._residual(self.names(at, numbers))
        except ZeroDivisionError:       # at a pole
            return float("inf")

    def _residual(self, known):
        left, right = (value(plain(text), known) for text in self.sides)
        found = left - right
        for power, text in self.means.values():
            below = _denominator(text)
            if power == 1 and "θ" in text and re.search("sin|cos", below):
                found *= _turned(value(plain(below), known), known(symbol(re.search("θ[₀-₉]*", text)[0])))
        return (_turned(found, known(self.variable)) if self.variable != "ω" else found).real

    def omega(self, at, numbers):
        """The frequency at a value of the variable."""
        found = self.names(at, numbers)("ω")
        return found.real if abs(found.imag) < abs(found.real) else 0.0

    def at(self, omega, numbers):
        """The variable of a frequency."""
        low = -self._reaches(-1.0, 0.0, numbers)
        high = self._reaches(1.0, omega, numbers)
        if self.omega(1e-9, numbers) > omega:
            high = 0.0
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if self.omega(middle, numbers) < omega else (low, middle)
        return high

    def roots(self, numbers, highest, steps=900):
        """The frequencies up to the highest at which the residual changes its sign through zero."""
        low, top = 0.0, highest
        if self.variable != "ω":
            top = self._reaches(1.0, highest, numbers)
            low = -self._reaches(-1.0, 0.0, numbers)
        places = low + (top - low) * np.array([1e-6, *(np.arange(steps + 1) + 0.317)]) / steps
        functions = [self.residual, *(partial(self.denominator, name) for name in self.repeated)]
        with np.errstate(over="ignore", invalid="ignore"):      # at poles
            found = [root for function in functions for root in self._zeros(partial(function, numbers=numbers), places)]
        return sorted(omega for omega in (self.omega(root, numbers) for root in found if self._moves(root, numbers))
                      if omega <= highest)

    def shape(self, root, share, numbers):
        """X at a share of the length, where βL is a root."""
        known = self.names(root, numbers)
        text = self.means["X(x)"][1]
        along = {"βx": self.variable, "αx": "αL"}
        return value(plain(text), lambda name: share * known(along[name]) if name in along else known(name))

    def _moves(self, root, numbers):
        """Is no βL or θ zero above ω = 0, at which sides vanish though nothing moves?"""
        known = self.names(root, numbers)
        return abs(known(self.variable)) > TRIVIAL and all(
            abs(known(name)) > CUT for name, (_, text) in self.means.items() if name[0] == "θ" and "−" in text)

    def denominator(self, name, at, numbers):
        """That of the dynamic stiffness of a name."""
        known = self.names(at, numbers)
        text = self.means[name][1]
        return _turned(value(plain(_denominator(text)), known), known(symbol(re.search("θ[₀-₉]*", text)[0]))).real

    def _zeros(self, function, places):
        values = [function(place) for place in places]
        for low, high, here, there in zip(places, places[1:], values, values[1:], strict=False):
            if here * there < 0:
                root = self._between(low, high, here, function)
                if root is not None:
                    yield root

    def _reaches(self, way, omega, numbers):
        """The size of the variable, of one sign, at which there is a frequency."""
        low, high = 0.0, 1.0

        def beyond(at):
            return (self.omega(way * at, numbers) - omega) * way >= 0

        while not beyond(high):
            high *= 2
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (low, middle) if beyond(middle) else (middle, high)
        return high

    @staticmethod
    def _between(low, high, here, function):
        """A root; None of a pole."""
        width = high - low
        while high - low > 4e-16 * abs(high) and low < (low + high) / 2 < high:
            middle = (low + high) / 2
            low, high = (middle, high) if (function(middle) > 0) == (here > 0) else (low, middle)
        beside = max(abs(function(low + way * width / 50)) for way in (-1, 1))
        return low if min(abs(function(one)) for one in (low, high)) < beside / 2 else None
