"""Random scenes of one body between springs in any direction, and their texts in the language."""

import random
from typing import NamedTuple


class Spring(NamedTuple):
    """`end`: its fixed end; `kind`, and the numbers that it takes: k d + b d² + c d³ as a law, N a preload; `second`: k
    and c of what is behind it in series."""

    end: tuple[float, float]
    kind: str
    k: float
    b: float = 0.0
    c: float = 0.0
    N: float = 0.0
    free: float = 0.0
    second: tuple[float, float] = (0.0, 0.0)


class Drawn(NamedTuple):
    """A particle along x or in the plane, a pendulum about (0, 0), or on a cart; mass 2, cart 3, bob drawn at `bob`."""

    kind: str
    springs: list[Spring]
    weight: bool
    load: tuple[float, float]
    bob: tuple[float, float]

    @property
    def coordinates(self) -> list[str]:
        return {"slider": ["x"], "particle": ["x", "y"], "pendulum": ["phi"], "cart": ["x", "phi"]}[self.kind]


def two_digits(chance: random.Random, low: float, high: float) -> float:
    """A number with two decimals."""
    return round(chance.uniform(low, high), 2)


def _place(chance, near):
    """At some distance from a place, in any direction."""
    while True:
        x, y = near[0] + two_digits(chance, -1, 1), near[1] + two_digits(chance, -1, 1)
        if (x - near[0])**2 + (y - near[1])**2 > 0.16:
            return round(x, 2), round(y, 2)


def _spring(chance, near):
    kind = chance.choice(("linear", "preload", "free", "duffing", "quadratic", "series"))
    k, hard = two_digits(chance, 200, 900), two_digits(chance, 50, 4000)
    more = {"linear": {}, "preload": {"N": two_digits(chance, -8, 40)}, "free": {"free": chance.choice([0, 0.3, 0.5])},
            "duffing": {"c": hard}, "quadratic": {"b": two_digits(chance, -200, 200), "c": hard},
            "series": {"c": hard, "second": (two_digits(chance, 200, 900), chance.choice([
                0.0, two_digits(chance, 50, 4000)]))}}[kind]
    return Spring(_place(chance, near), kind, k, **more)


def drawn(chance: random.Random) -> Drawn:
    """A random scene."""
    kind = chance.choice(("slider", "particle", "particle", "pendulum", "cart"))
    bob = (0.0, 0.0) if kind in ("slider", "particle") else _place(chance, (0.0, 0.0))
    springs = [_spring(chance, bob) for _ in range(chance.randint(2, 4))]
    still = chance.random() < 0.4       # in equilibrium as drawn: without loads, tensions and free lengths
    if still:
        springs = [s._replace(kind="linear") if s.kind in ("preload", "free") else s for s in springs]
        springs = [s._replace(N=0.0, free=0.0) for s in springs]
    load = (0.0, 0.0) if still or chance.random() < 0.5 else (two_digits(chance, -6, 6), two_digits(chance, -6, 6))
    return Drawn(kind, springs, not still and chance.random() < 0.6, load, bob)


def letters_of(scene: Drawn) -> dict[str, tuple[float, str]]:
    """{name: (value, unit)} of the masses and the springs."""
    values = {"m": (2.0, "kg")} | ({"M": (3.0, "kg")} if scene.kind == "cart" else {})
    for i, s in enumerate(scene.springs, 1):
        each = (("k", s.k, "N/m"), ("b", s.b, "N/m^2"), ("c", s.c, "N/m^3"), ("N", s.N, "N"), ("K", s.second[0], "N/m"),
                ("C", s.second[1], "N/m^3"))
        values |= {f"{name}{i}": (value, unit) for name, value, unit in each if value}
    return values


def _written(i, s):
    """A spring in the language."""
    law = f"k{i}*d" + f" + b{i}*d^2" * bool(s.b) + f" + c{i}*d^3" * bool(s.c)
    what = f'law: "{law}"' if s.b or s.c else f"k: k{i}"
    what += f", preload: N{i}" * bool(s.N) + f", free_length: {s.free} m" * (s.kind == "free")
    if s.kind == "series":
        behind = f'law: "K{i}*d + C{i}*d^3"' if s.second[1] else f"k: K{i}"
        what = f"series: [{{{what}}}, {{{behind}}}]"
    return f"  s{i}: {{{what}, between: [[{s.end[0]} m, {s.end[1]} m], p]}}\n"


def text(scene: Drawn, letters: bool = False) -> str:
    """The scene in the language; in letters masses and springs have no values."""
    told = ", ".join(f"{name}: {{unit: {unit}}}" if letters else f"{name}: {value} {unit}"
                     for name, (value, unit) in letters_of(scene).items())
    a, b = scene.bob
    pinned = f"p: {{mass: m, at: [{a} m, {b} m], pin: {{at: [0 m, 0 m], "
    bodies = {"slider": "p: {mass: m, at: [0 m, 0 m], slide: x}",
              "particle": "p: {mass: m, at: [0 m, 0 m], move: [x, y, 0]}",
              "pendulum": pinned + "by: phi}}",
              "cart": "cart: {mass: M, at: [0 m, 0 m], move: [x, 0, 0]}, " + pinned + "carrier: cart, by: phi}}"}
    force = f"forces: {{F: {{at: p, force: [{scene.load[0]} N, {scene.load[1]} N]}}}}\n" if any(scene.load) else ""
    springs = "".join(_written(i, s) for i, s in enumerate(scene.springs, 1))
    return (f"parameters: {{{told}}}\n" + "gravity: 9.81 m/s^2\n" * scene.weight
            + f"bodies: {{{bodies[scene.kind]}}}\nsprings:\n{springs}{force}")
