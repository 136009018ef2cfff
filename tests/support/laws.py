"""Scenes that hypothesis draws for laws: bodies in a row, and a plate on springs in the plane, as data and scenes."""

from fractions import Fraction
from typing import NamedTuple

from hypothesis import HealthCheck, Phase, settings
from hypothesis import strategies as st
from hypothesis.internal.conjecture import providers

import vibcli

# what is drawn hangs on no constants of modules that happen to be imported, which hypothesis looks for in all of them
providers.is_local_module_file = lambda path: False

GROUND = -1
LAW = settings(derandomize=True, deadline=None, database=None, max_examples=12, phases=[Phase.generate],
               suppress_health_check=list(HealthCheck))
FEW = settings(LAW, max_examples=4)     # of scenes that take longer
EPS, VAGUE = 2.0**-52, 1e-9


class Row(NamedTuple):
    """Bodies on one axis: their masses, and (factor, end, end) of springs and dampers, GROUND being −1; all exact."""

    masses: tuple
    springs: tuple
    dampers: tuple = ()

    def model(self, order=None, **sections):
        """The scene, its bodies in another order where one is given; `sections`: what stands beside them."""
        order = order or range(len(self.masses))
        if self.dampers:
            sections["dampers"] = elements("d", "c", "N*s/m", self.dampers)
        return vibcli.load({
            "bodies": {f"b{i}": {"mass": written(self.masses[i], "kg"), "slide": f"x{i}"} for i in order},
            "springs": elements("s", "k", "N/m", self.springs), **sections})

    def scaled(self, masses=1, stiffnesses=1, dampers=1):
        return Row(tuple(masses * m for m in self.masses), times(stiffnesses, self.springs),
                   times(dampers, self.dampers))

    def matrices(self):
        """(M, C, K) of fractions, summed up here."""
        n = len(self.masses)
        mass = [[self.masses[i] if i == j else Fraction(0) for j in range(n)] for i in range(n)]
        return mass, summed(n, self.dampers), summed(n, self.springs)


def times(factor, parts):
    return tuple((factor * size, one, two) for size, one, two in parts)


def summed(n, parts):
    """Σ size·(eᵢ − eⱼ)(eᵢ − eⱼ)ᵀ."""
    total = [[Fraction(0)] * n for _ in range(n)]
    for size, one, two in parts:
        ends = [(i, sign) for i, sign in ((one, -1), (two, 1)) if i != GROUND]
        for i, s in ends:
            for j, t in ends:
                total[i][j] += s * t * size
    return total


def written(value, unit):
    """An exact value as the language has it."""
    exact = Fraction(value)
    return f"({exact.numerator} {unit})/{exact.denominator}"


def elements(letter, key, unit, parts):
    def name(i):
        return "ground" if i == GROUND else f"b{i}"
    return {f"{letter}{at}": {key: written(size, unit), "between": [name(i), name(j)]}
            for at, (size, i, j) in enumerate(parts)}


SIZES = st.builds(lambda digits, tens: Fraction(digits) * Fraction(10) ** tens, st.integers(101, 9999),
                  st.integers(-3, 1))


@st.composite
def rows(draw, least=2, most=5, held=True, damped=False):
    """Rows whose bodies hang together, the first on the ground where they are held."""
    n = draw(st.integers(least, most))
    springs = [(draw(SIZES), i - 1, i) for i in range(0 if held else 1, n)]
    more = [(i, j) for i in range(GROUND, n) for j in range(i + 2, n) if held or i != GROUND]
    springs += [(draw(SIZES), *pair) for pair in draw(st.lists(st.sampled_from(more), max_size=3))] if more else []
    pairs = [(i, j) for i in range(GROUND, n) for j in range(i + 1, n)]
    dampers = [(draw(SIZES) / 100, *pair) for pair in draw(st.lists(st.sampled_from(pairs), min_size=1, max_size=3))
               ] if damped else []
    return Row(tuple(draw(SIZES) for _ in range(n)), tuple(springs), tuple(dampers))


class Plate(NamedTuple):
    """A plate in the plane on springs from places of the ground to places of its own, of the lengths that they are
    drawn with; `pendulum`: the length of one that hangs on it. All lengths are in eighths of a metre, so that they are
    exact."""

    mass: Fraction
    inertia: Fraction
    springs: tuple
    pendulum: int

    def model(self, place=lambda x, y: (x, y), down=(0, -1), bits=0, **sections):
        """The scene; `place`: where a place is drawn instead; `bits`: lengths and g times 2^bits."""
        unit = Fraction(2) ** bits

        def at(x, y):
            return [written(Fraction(c) / 8 * unit, "m") for c in place(x, y)]

        points = {f"P{i}": {"body": "plate", "at": at(*own)} for i, (_, _, own) in enumerate(self.springs)}
        return vibcli.load({
            "gravity": [written(Fraction(c) * Fraction(981, 100) * unit, "m/s^2") for c in down],
            "points": points | {"O": {"body": "plate", "at": at(0, 0)}},
            "bodies": {
                "plate": {"mass": written(self.mass, "kg"), "inertia": written(self.inertia * unit**2, "kg*m^2"),
                          "at": at(0, 0), "move": ["x", "y", "phi"]},
                "bob": {"mass": "1 kg", "at": at(0, -self.pendulum), "pin": {"at": "O", "by": "psi"}}},
            "springs": {f"s{i}": {"k": written(k, "N/m"), "between": [at(*ground), f"P{i}"]}
                        for i, (k, ground, _) in enumerate(self.springs)}, **sections})


@st.composite
def plates(draw):
    """Plates that hang on three springs or more from places around them."""
    corners = ((-8, 4), (8, 4), (0, 6), (-6, -2), (7, -3))
    feet = ((-24, 21), (23, 26), (2, 31), (-27, -13), (25, -17))
    return Plate(draw(SIZES.filter(lambda m: m < 100)), draw(SIZES), tuple(
        (1000 + draw(SIZES), tuple(c + draw(st.integers(-2, 2)) for c in foot), corner)
        for foot, corner in zip(feet, corners, strict=True)), draw(st.integers(3, 9)))


def rates(model):
    """[(ω, its bound)] of all modes, ascending."""
    return [told(model, f"omega[{i + 1}]") for i in range(len(model.omega))]


def told(model, quantity, size=0.0):
    """(value, its bound) of a quantity; a bound that tells nothing of a value of that size is none."""
    found = model[quantity]
    assert found.error <= VAGUE * max(abs(found.value), size)
    return found.value, found.error


def same(pairs, others):
    """Are values equal, as far as the bounds of both tell?"""
    return len(pairs) == len(others) and all(abs(a - b) <= error + other + 4 * EPS * abs(a)
                                             for (a, error), (b, other) in zip(pairs, others, strict=True))
