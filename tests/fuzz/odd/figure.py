"""A scene read from its text: coordinates, driven motions, and what has inertia, stretches, damps or is loaded.

Each of those is a number, or a function of numbers, beside a jet: a mass beside each component of its place, the law of
a spring beside its stretch, a force beside the displacement along it.
"""

import ast
from collections import namedtuple

import numpy as np

from . import jets, ties, words, written
from .as_yaml import scene_of
from .bodies import body_of
from .places import Bodies, length
from .scene_text import displacements, merged
from .texts import Texts, floating

Body = namedtuple("Body", "mass centre J circle radius lumped")
Drive = namedtuple("Drive", "terms steady")
Parts = namedtuple("Parts", "inertias weights springs dampers loads known bodies")
MOTIONS = ("slide", "pin", "roll", "move", "turn")


class Figure(Texts):
    """A scene in numbers. `given`: texts of parameters instead of those of the file; `folder`: that of its records."""

    def __init__(self, text, case=None, given=(), literal=floating, folder=None):
        super().__init__(merged(scene_of(text), case), given, literal, folder)
        self.gives = {}             # {body: number of the first variable} where supports give way
        self.held = {}              # {damper: force of its dry friction}
        self._coordinates()
        self._bodies()
        self.rest = dict.fromkeys(self.independent, self.literal(0, 1, 0))
        self.drawn_values = {name: self.drawn_at.get(name, self.literal(0, 1, 0)) for name in self.coordinates}
        self._laws()
        self.written_V, self.given = written.read(self)

    def _coordinates(self):
        """Names in the order of `coordinates`, else of the file; what holds the time alone is a drive."""
        declared = self.scene.get("coordinates", [])
        self.drawn_at = {name: self.number(v["drawn"]) for name, v in
                         (declared.items() if isinstance(declared, dict) else ())
                         if isinstance(v, dict) and "drawn" in v}
        self.coordinates, self.drives, self.split = list(declared), [], {}
        for body in self.scene.get("bodies", {}).values():
            for kind in MOTIONS:
                for text in displacements(kind, body.get(kind)):
                    self._divide(text)
        for point in self.scene.get("points", {}).values():
            for text in point.get("moves", ()) if isinstance(point, dict) else ():
                self._divide(text)
        for tie in self.scene.get("constraints", {}).values():
            equation = tie.get("equation") if isinstance(tie, dict) else tie
            for side in str(equation).split("=") if equation else ():
                self._divide(side)
        self.independent = list(self.coordinates)

    def _divide(self, text):
        """The terms of a displacement: those of coordinates, and the drive that those of the time make."""
        of_time, others = [], []
        for sign, tree in words.terms(self.tree(text)):
            (of_time if "t" in words.names(tree) else others).append((sign, tree))
            for name in words.names(tree):
                if name not in self.parameters and name not in ("t", "pi") and name not in self.coordinates:
                    self.coordinates.append(name)
        if of_time:
            self.drives.append(Drive(of_time, self._is_steady(of_time)))
        self.split[str(text)] = others, len(self.drives) - 1 if of_time else None

    def _is_steady(self, terms):
        """Does it grow with the time for ever?"""
        rates = [self.of_time(terms, self.literal(t, 7, 0)) for t in (1, 5, 4000)]
        return len({rate for _, rate, _ in rates}) == 1 and rates[0][1] != 0

    def driven(self, t):
        """The drives at an instant: lists of values, rates and second rates."""
        found = [self.of_time(drive.terms, t) for drive in self.drives]
        return tuple(list(column) for column in zip(*found, strict=True)) if found else ([], [], [])

    def change(self, text, known):
        """A displacement: of its coordinates since the drawn position, of its drive as it stands."""
        others, drive = self.split[str(text)]
        total = 0 if drive is None else known[drive]
        for sign, tree in others:
            if set(words.names(tree)) & set(self.coordinates):
                if isinstance(tree, ast.Name):
                    now, as_drawn = known[tree.id], self.drawn_values[tree.id]
                else:
                    now = words.value(tree, {**self.parameters, **known}, self.literal)
                    as_drawn = words.value(tree, {**self.parameters, **self.drawn_values}, self.literal)
                total = total + sign * (now - as_drawn if as_drawn else now)
        return total

    def driver(self, body):
        """The number of the drive that alone prescribes how a body slides or turns."""
        words_ = self.scene["bodies"][body]
        for kind in ("slide", "pin", "turn"):
            for text in displacements(kind, words_.get(kind)):
                others, drive = self.split[str(text)]
                if drive is not None and not others:
                    return drive
        return None

    def whole(self, text, known):
        """A side of an equation, its constants included."""
        others, drive = self.split[str(text)]
        total = 0 if drive is None else known[drive]
        return total + sum(sign * words.value(tree, {**self.parameters, **known}, self.literal)
                           for sign, tree in others)

    def _bodies(self):
        self.points = {name: {"at": point} if isinstance(point, list) else point
                       for name, point in self.scene.get("points", {}).items()}
        self.bodies = {}
        for name, body in self.scene.get("bodies", {}).items():
            if not {"at", "from", "parts"} & set(body):
                mass = self.number(body["mass"]) if "mass" in body else 0
                J = self.number(body["inertia"]) if "inertia" in body else 0
                self.bodies[name] = Body(mass, None, J, None, 0, True)
                continue
            words_ = {**body, "at": self.drawn_end(body["at"])} if "at" in body else body
            mass, x, y, J, circle, radius = body_of(words_, self.number, self._pair, self.pi)
            self.bodies[name] = Body(mass, (x, y), J, circle, radius, False)

    def _pair(self, pair):
        return pair if isinstance(pair, tuple) else self.place(pair)

    def drawn(self, name):
        """Where a named point or body is drawn."""
        return self.place(self.points[name]["at"]) if name in self.points else self.bodies[name].centre

    def drawn_end(self, end):
        return self.drawn(end) if isinstance(end, str) else self.place(end)

    def _laws(self):
        scene, self.drawn_lengths = self.scene, {}
        self.spring_laws = {name: self._spring(words_) for name, words_ in scene.get("springs", {}).items()}
        self.damper_laws = {name: self._damper(words_) for name, words_ in scene.get("dampers", {}).items()}
        self.frictions = {name: tuple(self.number(words_[key if key in words_ else "friction"])
                                      for key in ("friction", "breakaway"))
                          for name, words_ in scene.get("dampers", {}).items() if "friction" in words_}
        self.statics = {name: 0 for name, words_ in scene.get("springs", {}).items()
                        if words_.get("preload") == "static"}
        for name, words_ in {**scene.get("springs", {}), **scene.get("dampers", {})}.items():
            if "between" in words_ and "torsion" not in words_ and not self._lumped(words_):
                (ax, ay), (bx, by) = (self.drawn_end(end) for end in words_["between"])
                self.drawn_lengths[name] = length(bx - ax, by - ay)
        gravity = scene.get("gravity", "0")
        self.g = self.place(gravity) if isinstance(gravity, list) else (0, -self.number(gravity))

    def _lumped(self, words_):
        return any(isinstance(end, str) and end in self.bodies and self.bodies[end].lumped for end in words_["between"])

    def _spring(self, words_):
        """Tension as a function of the stretch since the drawn position; a free length shifts it, see `tension`."""
        if "law" in words_:
            tree = self.tree(words_["law"])
            return lambda d: words.value(tree, {**self.parameters, "d": d}, self.literal)
        k = self.number(words_.get("k", words_.get("torsion", "0")))
        gap = self.number(words_.get("gap", "0"))
        pulls, pushes = (words_.get("acts") in (None, way) for way in ("tension", "compression"))
        if not gap and pulls and pushes:
            return lambda d: k * d
        return lambda d: k * (pulls * jets.ramp(d - gap) - pushes * jets.ramp(-d - gap))

    def _damper(self, words_):
        if "law" in words_:
            tree = self.tree(words_["law"])
            return lambda v: words.value(tree, {**self.parameters, "v": v}, self.literal)
        c = self.number(words_.get("c", words_.get("torsion", "0") if words_.get("torsion") != "true" else "0"))
        return lambda v: c * v

    def slack(self, name):
        """How far a spring is stretched as drawn."""
        free = self.scene["springs"][name].get("free_length")
        return 0 if free is None else self.drawn_lengths[name] - self.number(free)

    def bends(self, name):
        """The stretches at which the tension of a spring bends."""
        gap = self.number(self.scene["springs"][name].get("gap", "0"))
        return [side * gap - self.slack(name) for side in (1, -1)]

    def tension(self, name, stretch):
        words_, slack = self.scene["springs"][name], self.slack(name)
        preload = words_.get("preload", "0")
        force = self.statics[name] if preload == "static" else self.number(preload)
        return self.spring_laws[name](stretch + slack) + force

    # jets

    def known(self, z, guess=None):
        """The jets of all coordinates and, by number, of the drives and gives; those tied are found by Newton's method.
        """
        at = jets.variables(np.array(z))
        n = len(self.independent)
        known = {**dict(zip(self.independent, at[:n], strict=True)), **dict(enumerate(at[n:]))}
        tied = [name for name in self.coordinates if name not in self.independent]
        if not tied:
            return known
        guess = guess or self.drawn_values
        values = ties.solve(self, {k: jet.v for k, jet in known.items()}, tied, [guess[name] for name in tied])
        return {**known, **ties.as_jets(self, known, tied, values, at)}

    def parts(self, z, guess=None):
        known = self.known(z, guess)
        bodies = Bodies(self, known)
        inertias, weights = [], []
        for name, body in self.bodies.items():
            if body.lumped:
                words_ = self.scene["bodies"][name]
                kind = "slide" if "slide" in words_ else "turn"
                if kind in words_:
                    inertias.append((body.mass if kind == "slide" else body.J, bodies.change(words_[kind])))
                continue
            x, y = bodies[name](body.centre)
            inertias += [(body.mass, x), (body.mass, y), (body.J, bodies[name].angle)]
            weights += [(body.mass * self.g[0], x), (body.mass * self.g[1], y)]
        springs = {name: self.stretch(name, words_, bodies) for name, words_ in self.scene.get("springs", {}).items()}
        dampers = {name: self.stretch(name, words_, bodies) for name, words_ in self.scene.get("dampers", {}).items()}
        return Parts([(w, jet) for w, jet in inertias if isinstance(jet, jets.Jet)],
                     [(f, jet) for f, jet in weights if isinstance(jet, jets.Jet)],
                     springs, dampers, self._loads(bodies), known, bodies)

    def stretch(self, name, words_, bodies):
        """How far a spring or damper is longer, or twisted further, than as drawn."""
        if "stretch" in words_:
            return sum(sign * (words.value(tree, {**self.parameters, **bodies.known}, self.literal)
                               - words.value(tree, {**self.parameters, **self.drawn_values}, self.literal))
                       for sign, tree in words.terms(self.tree(words_["stretch"])))
        if "torsion" in words_ or self._lumped(words_):
            one, two = (self._travel(end, bodies) for end in words_["between"])
            return two - one
        (ax, ay), (bx, by) = (bodies.place(end) for end in words_["between"])
        return length(bx - ax, by - ay) - self.drawn_lengths[name]

    def _travel(self, end, bodies):
        """The displacement of a body without a place, or the turn of a body."""
        if end == "ground":
            return 0
        words_ = self.scene["bodies"][end]
        if self.bodies[end].lumped:
            return bodies.change(words_["slide"] if "slide" in words_ else words_["turn"])
        return bodies[end].angle

    def _loads(self, bodies):
        """[(texts of components, how far its body has turned, jets of the displacements along them, is it of time)]"""
        found = []
        for load in self.scene.get("forces", {}).values():
            if "value" in load:
                found.append(([load["value"]], None, [bodies.known[load["coordinate"]]]))
            elif "moment" in load:
                found.append(([load["moment"]], None, [self._travel(load["body"], bodies)]))
            elif "unbalance" in load:
                size, speed = f"({load['unbalance']})*({load['speed']})^2", load["speed"]
                at = load["at"] if "at" in load else load["body"]
                if at in self.bodies and self.bodies[at].lumped:
                    found.append(([f"{size}*sin(({speed})*t)"], None, [self._travel(at, bodies)]))
                else:
                    found.append(([f"{size}*cos(({speed})*t)", f"{size}*sin(({speed})*t)"], None,
                                  list(bodies.place(at))))
            elif load["at"] in self.bodies and self.bodies[load["at"]].lumped:
                found.append(([load["force"]], None, [self._travel(load["at"], bodies)]))
            else:
                turned = bodies[load["carrier"]].angle if "carrier" in load else None
                found.append((load["force"], turned, list(bodies.place(load["at"]))))
        return found
