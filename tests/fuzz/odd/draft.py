"""A scene while it is drawn: what it holds so far, and what further elements can be tied to."""

import re

from .as_yaml import text_of

UNITS = {"m": (("m", 1), ("cm", 100), ("mm", 1000)), "kg": (("kg", 1),), "N/m": (("N/m", 1), ("kN/m", 1e-3),
         ("N/mm", 1e-3)), "N": (("N", 1),), "rad": (("rad", 1), ("deg", 57.29577951308232)),
         "s": (("s", 1), ("ms", 1e3))}


class Draft:
    """`dice`: a seeded random.Random, by which alone all is drawn."""

    def __init__(self, dice, seed):
        self.dice, self.seed, self.parameters, self.counts = dice, seed, {}, {}
        self.bodies, self.points, self.surfaces = {}, {}, {}
        self.springs, self.dampers, self.forces, self.constraints = {}, {}, {}, {}
        self.records, self.files = {}, {}
        self.sections = {}          # whatever else stands in the scene
        self.places = {}            # what springs and loads can act on: name -> (x, y) as drawn
        self.carriers = {}          # bodies in the plane, where they are drawn
        self.turning = []           # bodies that turn
        self.axis = []              # bodies without a place that translate
        self.coordinates = {}       # name -> m or rad
        self.tied = set()           # those that a constraint gives

    def chance(self, p):
        return self.dice.random() < p

    def some(self, low, high):
        """A number of three digits."""
        return float(f"{self.dice.uniform(low, high):.3g}")

    def new(self, letter):
        self.counts[letter] = self.counts.get(letter, 0) + 1
        return f"{letter}{self.counts[letter]}"

    def given(self, letter, low, high, unit):
        """A quantity: mostly a parameter, else the number where it stands; in one of several units."""
        written, factor = self.dice.choice(UNITS.get(unit, ((unit, 1),)))
        text = f"{float(f'{self.dice.uniform(low, high) * factor:.4g}'):.12g} {written}"
        if self.chance(0.2):
            return text
        name = self.new(letter)
        self.parameters[name] = text
        return name

    def coordinate(self, unit):
        name = self.new({"m": "x", "rad": "phi"}[unit])
        self.coordinates[name] = unit
        return name

    def spot(self, x, y):
        """A place in metres."""
        return [f"{round(x, 3)} m", f"{round(y, 3)} m"]

    def text(self):
        """The scene as YAML, without parameters that nothing came to use."""
        sections = {**self.sections, "points": self.points, "surfaces": self.surfaces, "bodies": self.bodies,
                    "springs": self.springs, "dampers": self.dampers, "forces": self.forces,
                    "constraints": self.constraints}
        used = set(re.findall(r"\w+", str(sections)))
        parameters, records = ({name: value for name, value in given.items() if name in used}
                               for given in (self.parameters, self.records))
        sections = {"records": records, **sections}
        kept = {key: value for key, value in {"parameters": parameters, **sections}.items() if value or value == 0}
        return text_of(kept)

    def write(self, path):
        """The scene as a file, its records beside it."""
        path.write_text(self.text(), encoding="utf-8")
        for name, text in self.files.items():
            path.with_name(name).write_text(text, encoding="utf-8")
