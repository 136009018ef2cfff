"""Expansions, equivalents and laws of random scenes of springs against SymPy's own series of V and T:

    PYTHONPATH=$PWD:tests python -m fuzz.expansions 200

A particle, a pendulum, or a pendulum on a cart, between springs in any direction: linear, with a preload or a free
length, of Duffing's type, two in series; under weights and loads that take it from the drawn position. The scenes are
written out as texts; their energies are written here once more, for SymPy. Prints how many numbers agree, by kind.
"""

import random
import sys
from collections import Counter
from itertools import product
from typing import NamedTuple

import mpmath
from fuzz.spring_scenes import Drawn, Spring, drawn, letters_of, text, two_digits
from support.scenes import number, problem
from support.truncated_series import FIELD, Taylor, exact

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.scene_language import language
from vibcli.quantities.expression import measure
from vibcli.quantities.quantity import declared
from vibcli.symbolic.parser import parse

ORDER, DIGITS, RESTS = 4, 60, 14
WITHIN = 1e-11      # of what is added up
NOTHING = 1e-40


def undeformed(scene: Drawn, spring: Spring):
    """The length from which its deflection counts: the drawn one, or its free length."""
    if spring.kind == "free":
        return exact(spring.free)
    dx, dy = (exact(a) - exact(b) for a, b in zip(scene.bob, spring.end, strict=True))
    return (dx**2 + dy**2) ** FIELD(0.5)


def _law(taylor, d, k, b, c, N):
    """(V, F, F′ at rest) of N d + k d²/2 + b d³/3 + c d⁴/4."""
    rests = taylor.constant(d)
    return (taylor.composed([0, N, k / 2, b / 3, c / 4], d), taylor.composed([N, k, b, c], d),
            k + 2 * b * rests + 3 * c * rests**2)


def energy_and_force(taylor: Taylor, spring: Spring, D) -> tuple:
    """(V, F) of a spring; of two in series by Newton's method with the slopes at rest, which takes one order with each
    step, after as many as the rest itself takes."""
    k, b, c, N, K, C = map(exact, (spring.k, spring.b, spring.c, spring.N, *spring.second))
    if spring.kind != "series":
        return _law(taylor, D, k, b, c, N)[:2]
    still = taylor.ring(0) + taylor.constant(D)
    inner = taylor.ring(0)
    for step in range(RESTS + taylor.order + 1):
        behind = (still if step < RESTS else D) - inner
        (V1, F1, slope1), (V2, F2, slope2) = _law(taylor, inner, k, b, c, FIELD(0)), _law(
            taylor, behind, K, FIELD(0), C, FIELD(0))
        inner = inner - (F1 - F2) * (1 / (slope1 + slope2))
    return V1 + V2, F1


class Written:
    """Energies of a scene about a place [of its coordinates] by SymPy's series."""

    def __init__(self, scene: Drawn, place: list, order: int = ORDER):
        self.scene, self.place, self.n = scene, place, len(scene.coordinates)
        names = scene.coordinates
        self.taylor = Taylor([*names, *(name + "_rate" for name in names)], order)
        self.q = [self.taylor.moving(i) for i in range(self.n)]
        self.v = [self.taylor.moving(self.n + i) for i in range(self.n)]
        self.bob, self.velocity = self._bob()

    def _bob(self):
        kind, q, v = self.scene.kind, [s + c for s, c in zip(self.q, self.place, strict=True)], self.v
        zero = self.taylor.ring(0)
        if kind == "slider":
            return (q[0], zero), (v[0], zero)
        if kind == "particle":
            return tuple(q), tuple(v)
        (a, b), (cosine, sine) = map(exact, self.scene.bob), self._turned()
        x, y, rate = a * cosine - b * sine, a * sine + b * cosine, v[-1]
        along, speed = (q[0], v[0]) if kind == "cart" else (zero, zero)
        cut = self.taylor.cut
        return (x + along, y), (cut(speed - y * rate), cut(x * rate))

    def _turned(self):
        """cos and sin of the angle."""
        with mpmath.workdps(DIGITS):
            angle = mpmath.mpf(str(self.place[-1]))
            c, s = FIELD(mpmath.cos(angle)), FIELD(mpmath.sin(angle))
        cosine = self.taylor.composed([FIELD(1), 0, FIELD(-1) / 2, 0, FIELD(1) / 24], self.q[-1])
        sine = self.taylor.composed([0, FIELD(1), 0, FIELD(-1) / 6, 0], self.q[-1])
        return c * cosine - s * sine, s * cosine + c * sine

    def deflection(self, spring: Spring):
        """Of its length from where its law counts."""
        dx, dy = (one - exact(end) for one, end in zip(self.bob, spring.end, strict=True))
        return self.taylor.root(self.taylor.cut(dx**2 + dy**2)) - undeformed(self.scene, spring)

    def potentials(self) -> list:
        """V of each spring, then that of the weights."""
        found = [energy_and_force(self.taylor, s, self.deflection(s))[0] for s in self.scene.springs]
        return [*found, self.bob[1] * (2 * exact(9.81))] if self.scene.weight else found

    def kinetic(self):
        """½ m v²."""
        cut, (x, y) = self.taylor.cut, self.velocity
        T = cut(x**2) + cut(y**2)
        return T + self.v[0]**2 * FIELD(1.5) if self.scene.kind == "cart" else T

    def geometric(self, spring: Spring):
        """V less that of a deflection of the first order."""
        d = self.deflection(spring)
        whole, first = (energy_and_force(self.taylor, spring, each)[0] for each in (d, self.taylor.first(d)))
        return whole - first

    def slopes(self) -> tuple:
        """The gradient of V less the work of loads, and its second derivatives."""
        W = self.bob[0] * exact(self.scene.load[0]) + self.bob[1] * exact(self.scene.load[1])
        terms, n = self.taylor.coefficients(sum(self.potentials(), self.taylor.ring(0)) - W), self.n

        def of(*which):
            powers = tuple(which.count(i) for i in range(2 * n))
            return terms.get(powers, FIELD(0)) * (2 if max(powers) == 2 else 1)
        return [of(i) for i in range(n)], [[of(i, j) for j in range(n)] for i in range(n)]


def at_rest(scene: Drawn, start: list) -> list:
    """The equilibrium next to a place, by Newton's method."""
    place = [FIELD(one) for one in start]
    for _ in range(3):
        g, H = Written(scene, place, 2).slopes()
        if len(g) == 1:
            place = [place[0] - g[0] / H[0][0]]
            continue
        size = H[0][0] * H[1][1] - H[0][1] * H[1][0]
        place = [place[0] - (H[1][1] * g[0] - H[0][1] * g[1]) / size,
                 place[1] - (H[0][0] * g[1] - H[1][0] * g[0]) / size]
    return place


class Compared(NamedTuple):
    """One number: by the program with the bound of its error, by SymPy, and how large the parts of it are."""

    text: str
    found: float
    bound: float
    exact: float
    size: float

    @property
    def agrees(self) -> bool:
        """Within its bound, and that is no larger than rounding of its parts."""
        off = abs(self.found - self.exact)
        if off < NOTHING:       # of the digits of SymPy's series
            return True
        return off <= max(self.bound, 4 * 2.0**-52 * abs(self.exact)) and off <= WITHIN * self.size


def _products(chance, names, count, rates=False):
    """[(text, powers)] of random products."""
    powers = [p for p in product(range(ORDER + 1), repeat=len(names)) if 0 < sum(p) <= ORDER and (
        not rates or sum(p[len(names) // 2:]) == 2)]
    return [("*".join(f"{name}^{n}" for name, n in zip(names, p, strict=True) if n), p)
            for p in chance.sample(powers, min(count, len(powers)))]


def expected(scene: Drawn, place: list, chance: random.Random) -> list[tuple[str, float, float]]:
    """[(quantity, its value, size of its parts)] of a scene in equilibrium."""
    here, names = Written(scene, place), scene.coordinates
    n, found, of = here.n, [], here.taylor.coefficients
    parts, T = [of(one) for one in here.potentials()], of(here.kinetic())
    for factors, p in _products(chance, names, 6):
        found.append((f"V[{factors}]", *_summed([part.get(p + (0,) * n, 0) for part in parts])))
    for factors, p in _products(chance, [*names, *(name + "'" for name in names)], 3, rates=True):
        found.append((f"T[{factors}]", *_summed([T.get(p, 0)], 1.0)))
    for i in chance.sample(range(len(scene.springs)), 2):
        found += _of_geometry(scene.springs[i], f"s{i + 1}", here, parts[i], chance)
        found += _of_law(scene.springs[i], f"s{i + 1}", chance)
    return found + _equivalent(scene, here)


def _of_geometry(spring, name, here, whole, chance):
    """Of the force along the first coordinate of a product."""
    geometric, none = here.taylor.coefficients(here.geometric(spring)), (0,) * here.n
    for factors, p in _products(chance, here.scene.coordinates, 2):
        first = next(j for j, n in enumerate(p) if n)
        p = (*(n + (j == first) for j, n in enumerate(p)), *none)
        if sum(p) <= ORDER:
            value = float(geometric.get(p, 0))
            yield (f"stiffness_correction[{name}, {factors}]", p[first] * value,
                   p[first] * (abs(value) + 2 * abs(float(whole.get(p, 0)))))


def _summed(parts, least=0.0):
    return float(sum(parts, FIELD(0))), max(least, float(sum(map(abs, parts), FIELD(0))))


def _of_law(spring, name, chance):
    """Of its law about its undeformed length, whatever its tension."""
    taylor = Taylor(["D"], 6)
    spring, D = spring._replace(N=0.0), taylor.moving(0)
    series = taylor.coefficients(energy_and_force(taylor, spring, D)[0])
    for n in (1, 3, chance.choice((2, 4, 5))):
        value = (n + 1) * float(series.get((n + 1,), 0))
        yield f"law[{name}, d^{n}]", value, abs(value) or spring.k
    D = two_digits(chance, -0.3, 0.3)
    force = float(taylor.constant(energy_and_force(taylor, spring, taylor.ring(0) + exact(D))[1]))
    yield f"law[{name}]({D} m)", force, abs(force) or spring.k


def _equivalent(scene, here):
    """Second derivatives of V of the springs by the place of their end."""
    place = [here.taylor.constant(one) for one in here.bob]
    moved = Written(scene._replace(kind="particle", weight=False, load=(0.0, 0.0)), place, 2)
    _, ((xx, xy), (_, yy)) = moved.slopes()
    size = sum(2 * s.k for s in scene.springs) + float(abs(xx) + abs(xy) + abs(yy))
    middle, half = (xx + yy) / 2, (((xx - yy) / 2)**2 + xy**2) ** FIELD(0.5)
    return [(f"stiffness[p].{part}", float(value), size) for part, value in (
        ("xx", xx), ("xy", xy), ("yy", yy), ("max", middle + half), ("min", middle - half))]


def compared(seed: int) -> tuple[Drawn, list[Compared], list[str], list[Compared]]:
    """A scene; its numbers, what is refused, and the same in letters where it rests as drawn."""
    chance = random.Random(seed)
    scene = drawn(chance)
    one = problem(text(scene))
    try:
        start = [one.configuration.equilibrium.values[name] for name in scene.coordinates]
    except PhysicsError as refusal:
        return scene, [], [f"equilibrium: {refusal.message}"], []
    found, refused, letters = [], [], []
    spelt = problem(text(scene, letters=True))
    for quantity, value, size in expected(scene, at_rest(scene, start), chance):
        tree = parse(quantity)
        try:
            number, error = measure(one, tree)
            found.append(Compared(quantity, number, error * abs(number), value, size))
        except PhysicsError as refusal:
            refused.append(f"{quantity}: {refusal.message}")
        try:
            node = declared(tree).symbolic(spelt, tree)
        except NotInLetters:
            continue
        number = float(value_of(language(node), scene))
        letters.append(Compared(quantity, number, WITHIN * size, value, size))
    return scene, found, refused, letters


def value_of(written: str, scene: Drawn) -> float:
    """The number of an expression in letters, by a walk of the tests over its syntax, to many digits."""
    with mpmath.workdps(DIGITS):
        values = {name: mpmath.mpf(repr(value)) for name, (value, _) in letters_of(scene).items()}
        return number(parse(written), values, mpmath)


def main(count: int, seed: int = 0) -> None:
    numbers, wrong, refusals = Counter(), [], Counter()
    for i in range(seed, seed + count):
        _, found, refused, letters = compared(i)
        for kind, group in (("numbers", found), ("letters", letters)):
            for one in group:
                numbers[f"{one.text.partition('[')[0]} in {kind}"] += 1
                if not one.agrees:
                    wrong.append((i, kind, one))
        refusals.update(one.partition(": ")[2] for one in refused)
    print(f"{count} scenes: {sum(numbers.values())} numbers, {len(wrong)} disagree; {dict(numbers)}")
    for told in [*wrong[:20], *refusals.items()]:
        print(told)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
