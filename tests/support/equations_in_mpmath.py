"""Printed frequency equations as data: the nodes of their lines, by mpmath, at a frequency."""

import re

import mpmath
from mpmath import mp
from support.printed_equations import blocks, told

from vibcli.analyses.closed_form.free_letters import ARGUMENTS, FREQUENCY
from vibcli.notation.plain import plain
from vibcli.report.blocks import Factor
from vibcli.report.formats.formula import formula
from vibcli.symbolic.node import Node, is_measure

BESSEL = {"J0": (mpmath.besselj, 0), "J1": (mpmath.besselj, 1), "Y0": (mpmath.bessely, 0), "Y1": (mpmath.bessely, 1)}
DIGITS = 25
BESIDE, ZERO = mpmath.mpf(10) ** -4, 1e-5       # relative distance, and what is zero of what is beside it
DENOMINATOR = "and where the denominator of "
NEAR = 1e-13        # relative: of ω² in floats


def number(node, names):
    """The value of a node; `names`: a function of names of symbols."""
    if node.op == "number":
        return mpmath.mpf(node.coefficient.numerator) / node.coefficient.denominator
    if node.op == "pi":
        return +mp.pi
    if node.op == "symbol":
        return mpmath.mpf(node.name.split()[0]) if is_measure(node) else names(node.name)
    if node.op == "call":
        calls = getattr(names, "calls", {})
        if node not in calls:
            function, *order = BESSEL.get(node.name) or (getattr(mpmath, node.name),)
            calls[node] = function(*order, *(number(one, names) for one in node.args))
        return calls[node]
    found = mpmath.mpf(node.coefficient.numerator) / node.coefficient.denominator
    for part, factor in node.args:
        factor = mpmath.mpf(factor.numerator) / factor.denominator
        found = found + factor * number(part, names) if node.op == "sum" else found * number(part, names) ** factor
    return found


def _product(parts):
    """Nodes and numbers of a side; words end it."""
    found = []
    for part in parts:
        if isinstance(part, Node | Factor):
            found.append(part.node if isinstance(part, Factor) else part)
        elif isinstance(part, str) and part != "·":
            if not re.fullmatch(r"[\d.e+−-]+", part):
                return None
            found.append(mpmath.mpf(part.replace("−", "-")))
        elif not isinstance(part, str):
            break
    return found


def _split(one):
    """(left, right) parts of a line that defines or equates nodes; None of others, those of roots among them."""
    parts = list(one.parts)
    if " = " not in parts[1:] or not isinstance(parts[0], Node | Factor):
        return None
    at = parts.index(" = ")
    left, right = _product(parts[:at]), _product(parts[at + 1:])
    return None if right is None or not left else (left, right)


def is_equation(lines):
    """Do lines begin with an equation of nodes?"""
    return _split(lines[0]) is not None


def fulfilled(scene, count=3):
    """Each of the first modes fulfils one of the equations; how many equations are printed."""
    equations = [Printed(lines) for lines in blocks(scene) if is_equation(lines)]
    for mode in scene.modal.modes.first(count) if equations else []:
        omega = mode.omega if mode.growth_rate is None else 1j * mode.growth_rate
        assert not omega or any(one.vanishes(omega, scene.numeric.floats) for one in equations), mode.index
    return len(equations)


class Printed:
    """The lines on one equation: its sides and what each letter is."""

    def __init__(self, lines):
        self.sides = _split(lines[0])
        self.text = formula(lines[0].parts, plain).replace("\u00a0", " ")
        self.lines, self.told = lines, "\n".join("".join(told(one)) for one in lines)
        self.repeated = [one.parts[1].name for one in lines if getattr(one.parts[0], "text", "") == DENOMINATOR]
        meant = [one for one in map(_split, lines[1:]) if one is not None]
        shapes = [one.parts for one in lines if str(one.parts[0]).startswith("X(")]
        self.drawn = shapes[0] if len(shapes) == 1 and isinstance(shapes[0][1], Node) else None
        self.sigma = next((_product(one.parts[1:]) for one in lines if one.parts[0] == "σ = "), None)
        self.means = {}
        for left, right in meant:
            base, power = (left[0], 1) if left[0].op == "symbol" else left[0].args[0]
            self.means[base.name] = power, right
        self.omega = next((name for name in FREQUENCY if name in self.means), None)

    def at(self, omega, floats, other=False):
        """names(name) at a frequency; `other`: with the other βL that has it, of a pressed beam in a bed."""
        values = {name: mpmath.mpf(one) for name, one in floats.items()}
        if self.omega is None:
            values |= {name: omega for name in FREQUENCY if name not in values}
        else:
            values[self.omega] = omega
            wave = self._wave()
            values[wave] = self._argument(wave, omega, values, -1 if other else 1)

        def known(name):
            if name not in values:
                power, right = self.means[name]
                values[name] = _times(right, known) ** (mpmath.mpf(1) / int(power))
            return values[name]
        known.calls = {}
        return known

    def _wave(self):
        """What ω is told by."""
        names = {one.name for part in self.means[self.omega][1] if isinstance(part, Node) for one in _symbols(part)}
        return next(name for name in ("βL", "z", "z1", *ARGUMENTS) if name in names)

    def _argument(self, wave, omega, values, sign):
        """A z with ω² = a + b z² + c z⁴."""
        power, right = self.means[self.omega]

        def square(z2):
            return _times(right, (values | {wave: mpmath.sqrt(z2)}).__getitem__) ** (2 / mpmath.mpf(int(power)))

        a, one, two = square(mpmath.mpf(0)), square(mpmath.mpf(1)), square(mpmath.mpf(2))
        c = (two - 2 * one + a) / 2
        b = one - a - c
        rest = omega ** 2 - a
        if abs(c) <= mpmath.mpf(10) ** -20 * abs(one):
            return mpmath.sqrt(rest / b)
        return mpmath.sqrt((sign * mpmath.sqrt(b ** 2 + 4 * c * rest) - b) / (2 * c))

    def _values(self, omega, floats, other):
        """left − right, times the denominators of stiffnesses, and those that are told to vanish by themselves."""
        names = self.at(omega, floats, other)
        below = {name: mpmath.fprod(number(base, names) ** -int(e) for node in right if isinstance(node, Node)
                                    and node.op == "product" for base, e in node.args if e < 0 and _calls(base))
                 for name, (_, right) in self.means.items()}
        found = _times(self.sides[0], names) - _times(self.sides[1], names)
        return [found * mpmath.fprod(below.values()), *(below[name] for name in self.repeated)]

    def shape(self, omega, share, floats):
        """X at a share of the length, at a frequency."""
        with mp.workdps(DIGITS):
            known = self.at(mpmath.mpf(omega), floats)
            along = {"βx": self._wave(), "βξ": self._wave(), "αx": "αL" if "αL" in self.means else "eta",
                     "x": "L", "ξ": "L"}
            parts = self.drawn

            def names(name):
                if name == "σ":
                    return _times(self.sigma, known)
                return share * known(along[name]) if name in along else known(name)

            first, second = parts[1], parts[3:]
            return number(first, names) - (names("σ") * _times(_product(second), names) if second else 0)

    def vanishes(self, omega, floats):
        """Is it zero at a frequency, and not beside it?"""
        with mp.workdps(DIGITS):
            omega = mpmath.mpmathify(omega)
            return any(self._vanishes(omega, floats, other) for other in (False, True))

    def _rests(self, omega, floats):
        """Is a frequency that of βL = 0, but for rounding?"""
        power, right = self.means[self.omega]
        at_rest = _times(right, {**floats, self._wave(): mpmath.mpf(0)}.__getitem__) ** (2 / mpmath.mpf(int(power)))
        return abs(omega ** 2 - at_rest) < NEAR * abs(omega ** 2)

    def _vanishes(self, omega, floats, other):
        if self.omega is not None and self._rests(omega, floats):
            return bool(re.search(r"(βL|θ) = 0|n = 0| is 0\b", self.told))
        found = zip(*(self._values(omega * (1 + sign * BESIDE), floats, other) for sign in (0, -1, 1)), strict=True)
        return any(min(abs(one), abs(two)) > 0 and abs(here) <= ZERO * max(abs(one), abs(two))
                   for here, one, two in found)


def _times(parts, names):
    return mpmath.fprod(one if not isinstance(one, Node) else number(one, names) for one in parts)


def _walk(node):
    yield node
    for part in node.parts:
        yield from _walk(part)


def _symbols(node):
    return [one for one in _walk(node) if one.op == "symbol"]


def _calls(node):
    return any(one.op == "call" for one in _walk(node))
