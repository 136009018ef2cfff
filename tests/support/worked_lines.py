"""The lines of worked solutions at values of their letters, and again with other units of mass, length and time, in
which what measures the same is as much greater on both sides of an equality, and in what a line settles."""

import math
import random
import re
from itertools import pairwise

from vibcli.base import units
from vibcli.language.parameter_samples import sample_values
from vibcli.report.blocks import Factor, Name, Quotient, ShownMatrix, SumOfTerms, WithNumbers, Words
from vibcli.report.steps.worked import asks_in_full, worked
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import UNITS

SMALL = 1e-4        # of angles in radians, lengths in metres: how far from rest expansions are looked at
OTHERS = {"kg": 1.37, "m": 0.83, "s": 1.19}     # how much of an SI unit others are
RAISED = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
UNKNOWNS = re.compile(r"(omega|lambda|D|[acdnp]\d+|[MCGK]|[ABEFX]|theta|[ZF]|tau|n|u|alpha|kappa|𝔇)\d*′*")
PRINTED = 1e-5      # relative: of numbers as they are printed
ROUNDING = 1e-13    # the same, of the terms of a sum that cancel
OF_MODE = re.compile(r"equation of (?:complex )?mode (\d+)")
TELLS = " = ", "(τ) = ", "(0) = "        # behind a letter
DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


class Checked:
    """The lines of a scene at values of its letters: how many equalities hold, and those that do not."""

    def __init__(self, scene, lines=None):
        self.problem, self.lines, self.count, self.wrong = scene, lines or worked(scene), 0, []
        numeric, self.values = scene.numeric, {}
        draw = random.Random(7)
        parameters = numeric.floats if not numeric.has_free_symbols else scene.scene.parameters.values(
            Floats, sample_values(scene.scene.parameters.free, 60))
        small = {}
        for one in (scene.scene, *([scene.system.scene_with_multipliers] if asks_in_full(scene) else [])):
            for node in (*one.q, *one.v, *one.a):
                small.setdefault(node.name, SMALL * draw.uniform(0.5, 1))
        self.values = {**parameters, **dict.fromkeys(UNITS.values(), 1.0), scene.scene.time.name: 0.3, **small}
        self.defined = {}
        for one in self.lines:
            if one.letter and one.node is not None:
                self.defined[one.letter] = one.node
            elif one.letter and one.value is not None:
                self.values[one.letter] = one.value
            self.each(one)
            self.matrices(one)
            self.valued(one)
            if one.node is not None and re.fullmatch(r"\w+[′]*", one.settles) and one.settles not in small:
                self.defined[one.settles] = one.node
            if one.value is not None and (mode := re.fullmatch(r"omega\[(\d+)\]", one.settles)):
                self.values[f"omega{mode[1]}"] = one.value
            if one.value is not None and one.settles not in self.values and one.node is None:
                self.values[one.settles] = one.value

    def value(self, node):
        """The value of an expression, its letters by the lines that define them; None where one has none."""
        known = dict(self.values)
        for part in reachable([node]):
            if part.op == "symbol" and part.name not in known:
                name = part.name.rstrip("'")
                found = self.defined.get(part.name) or self.defined.get(name)
                if found is None:
                    return None
                value = self.value(found)
                if value is None:
                    return None
                known[part.name] = value
        return evaluate([node], Floats, known)[0]

    def valued(self, line):
        """The value of a line by its expression, in the letters of the lines before."""
        found = None if line.node is None or line.value is None else self.value(line.node)
        if found is not None:
            self.count += 1
            if not math.isclose(found, line.value, rel_tol=1e-9, abs_tol=1e-12):
                self.wrong.append((line.number, found, line.value))

    def matrices(self, line):
        """The matrices of a line, entry by entry; the unit of numbers stands behind them or behind each."""
        behind = (*line.parts[1:], None)
        found = [[(self.entry(cell, after), self.rounding(cell[0])) for row in part.rows for cell in row]
                 for part, after in zip(line.parts, behind, strict=False) if isinstance(part, ShownMatrix)]
        for one, other in pairwise(found):
            for (x, rounding), (y, _) in zip(one, other, strict=True):
                self.count += 1
                if not math.isclose(x, y, rel_tol=PRINTED, abs_tol=rounding):
                    self.wrong.append((line.number, x, y))

    def entry(self, cell, after):
        """The value of an entry of a matrix."""
        if not isinstance(cell[0], str):
            return self.value(cell[0])
        unit = next((part.text for part in (*cell[1:], after) if isinstance(part, Words)), "")
        return float(cell[0].replace("−", "-")) * self.of_unit(unit.strip())

    def rounding(self, node):
        """What may be left of the terms of a sum that cancel, 0 of what is none."""
        if getattr(node, "op", "") != "sum":
            return 0.0
        return ROUNDING * sum(abs(c * self.value(part)) for part, c in node.args)

    def of_unit(self, _):
        return 1.0

    def each(self, line):
        """Every equality of a line between expressions, those that motions alone fulfil apart."""
        if line.settles.startswith(("equation[", "motion[")):
            return
        sides, rough = [[]], False
        for part in line.parts:
            if isinstance(part, Words):
                rough |= "order" in part.text
        for part in (*line.parts, Words(",  ")):
            if isinstance(part, Words) and (",  " in part.text or "being deflected" in part.text or ":" in part.text):
                self.compared(line, sides, rough)
                sides = [[]]
            elif isinstance(part, str) and " = " in part:
                sides.append([])
                if part.removeprefix(" = ").strip():
                    sides[-2:] = [[None], [part]]
            elif not isinstance(part, Words):
                sides[-1].append(part)

    def letter(self, sides):
        """A letter, or its square, that is defined by the side behind it."""
        (head, *_), (node, *_) = sides[0] or [None], sides[-1] or [None]
        if not (hasattr(head, "op") and hasattr(node, "op")) or head is node:
            return
        symbol, square = (head.args[0][0], True) if head.op == "product" and len(head.args) == 1 else (head, False)
        if symbol.op == "symbol" and symbol.name not in {**self.values, **self.defined}:
            self.defined[symbol.name] = node.table.sqrt(node) if square else node

    def compared(self, line, sides, rough):
        self.letter(sides)
        values = []
        for side in sides:
            if len(side) == 1 and not isinstance(side[0], (str, type(None))):
                node = side[0].node if isinstance(side[0], (WithNumbers, Factor, Quotient)) else side[0]
                if isinstance(node, SumOfTerms):
                    node = node.nodes[0].table.total(node.nodes)
                if isinstance(node, Name):
                    found = self.defined.get(node.text)
                    node = found if found is not None and node.text != line.settles else None
                value = None if node is None or not hasattr(node, "op") else self.value(node)
                if value is not None:
                    values.append(value)
        for one, other in pairwise(value for value in values if math.isfinite(value)):
            self.count += 1
            if not math.isclose(one, other, rel_tol=2e-2 if rough else 1e-9, abs_tol=1e-13 if rough else 1e-17):
                self.wrong.append((line.number, one, other))


class InOtherUnits(Checked):
    """The same with OTHERS for the units of SI, of a scene whose letters have known dimensions."""

    def __init__(self, scene, lines):
        super().__init__(scene, [one._replace(value=one.value * of_unit(one.unit) if one.value else None)
                                 for one in lines])

    @property
    def values(self):
        return self._values

    @values.setter
    def values(self, found):
        self._values = {name: value * self._factor(name) for name, value in found.items()}

    def of_unit(self, text):
        return of_unit(text)

    def _factor(self, name):
        spec, letter = self.problem.spec, name.rstrip("'")
        if letter == self.problem.scene.time.name:
            return OTHERS["s"]
        if letter in UNITS.values():
            return OTHERS[letter.removeprefix("1 ")]
        known = letter in spec.parameters
        dimension = spec.dimensions.of(letter) if known else self.problem.system.dimension(letter)
        return of_dimension(dimension) / OTHERS["s"] ** (len(name) - len(letter))


def of_dimension(dimension):
    """By how much what measures that is greater."""
    return math.prod(OTHERS[base] ** float(e) for base, e in dimension.items())


def of_unit(text):
    """The same of a unit as it is printed, kg²·m²/s⁴."""
    plain = RAISED.sub(lambda found: "^" + found[0].translate(DIGITS), text)
    below = re.sub(r"/\((.*)\)", lambda found: "/" + found[1].replace("·", "/"), plain)
    return of_dimension(units.parse_unit(below).dimension)


def told_later(problem, lines):
    """[(number of a line, letter)] of letters that stand in it and that neither the scene has nor lines up to it tell:
    by what they settle, alone before an equality, or alone among words, those of modes that have lines by the one of
    mode k; but for UNKNOWNS of a form that is tried."""
    scenes = [problem.scene, problem.system.scene_with_multipliers]
    known = {*UNITS.values(), *problem.spec.parameters, *problem.scene.parameters.nodes, *problem.spec.coordinates}
    known |= {node.name for one in scenes for node in (*one.q, *one.v, *one.a, one.time)}
    known |= {name for one in scenes for name in one.dependent}
    known |= {name + mark for name in known for mark in ("'", "''")}
    found, modes = [], set()
    for number in dict.fromkeys(line.number for line in lines):
        here = [line for line in lines if line.number == number]
        known |= {name for line in here for name in (line.letter, line.settles)}
        modes |= {of[1] for line in here if (of := OF_MODE.fullmatch(line.settles))}
        known |= {name for line in here for name in _alone(line.parts)}
        found += [(number, name) for name in dict.fromkeys(name for line in here for name in _names(line.parts))
                  if known.isdisjoint((name, name.rstrip("'"), *_of_any_mode(name, modes)))
                  and not UNKNOWNS.fullmatch(name)]
    return found


def _of_any_mode(name, modes):
    """s_k of s1, where mode 1 is one of these, and s1 of s_k."""
    letter, index = re.fullmatch(r"(.*?)_?(k|\d*)", name).groups()
    return [f"{letter}_k"] if index in modes else [letter + one for one in modes if index == "k"]


def _alone(parts):
    """Names that stand alone before an equality or among words."""
    for i, part in enumerate(parts):
        before, after = (parts[k] if 0 <= k < len(parts) else Words("") for k in (i - 1, i + 1))
        opens = isinstance(before, Words) or (isinstance(before, str) and not before.endswith(" = "))
        if opens and (isinstance(after, Words) or (isinstance(after, str) and after.startswith(TELLS))):
            node = part.node if isinstance(part, Factor) else part
            if not isinstance(node, Name) and not hasattr(node, "table"):
                continue
            powers = node.args if getattr(node, "op", "") == "product" and len(node.args) == 1 else ((node, 1),)
            (base, _), = powers
            if isinstance(base, Name):
                yield base.text
            elif getattr(base, "op", "") == "symbol":
                yield base.name
            elif getattr(base, "op", "") == "call":     # tan θ = …
                yield from _of_node(base)


def _names(parts):
    for before, part in zip(("", *parts), parts, strict=False):
        if isinstance(part, Name):
            if not (isinstance(before, str) and before.endswith("∂")):
                yield part.text
        elif isinstance(part, SumOfTerms):
            for node in part.nodes:
                yield from _of_node(node)
        elif isinstance(part, ShownMatrix):
            for row in part.rows:
                yield from (name for cell in row for name in _names(cell))
        elif isinstance(part, WithNumbers):
            yield from (name for name in _of_node(part.node) if name not in part.values)
        elif not isinstance(part, (str, Words)):
            yield from _of_node(getattr(part, "node", part))


def _of_node(node):
    return [one.name for one in reachable([node]) if one.op == "symbol"] if hasattr(node, "table") else []
