"""What reports of members introduce shares no letter with what a scene names."""

import re

import pytest
from support.scenes import problem

from vibcli.notation.names import factors_of
from vibcli.notation.plain import plain
from vibcli.report.blocks import Equations, Factor, Maths, Name, Paragraph, TableBlock
from vibcli.report.document import EVERYTHING, Report
from vibcli.report.steps.worked import worked
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import Node

# Names of pure numbers, one in several, that reports of members would use themselves
NAMES = ("alpha", "beta", "sigma", "omega", "epsilon", "x", "X", "n", "D", "J", "tau", "u", "phi", "theta", "eta", "Z",
         "m1", "omega1", "Q1", "delta1", "c", "r", "U", "V", "W", "Y", "k", "N", "mu", "S", "l", "T", "f", "z", "C1",
         "kappa", "zeta", "lambda", "nu", "p1", "xi")
VALUES = {"L": "0.6 m", "EI": "70 N*m^2", "EA": "1 MN", "q": "0.3 kg/m", "M": "0.05 kg", "GJ": "9 N*m^2", "ip": "2 g*m",
          "I": "1 g*m^2"}
BEAM = "beams: {b: {length: L, EI: EI, mass_per_length: q, left: clamped, "
LOADED = "points: {tip: {body: b, at: L}}\nforces: {F: {at: tip, force: 2 N*sin(3 rad/s*t)}}\n"
SCENES = {
    "tip": BEAM + "attached: [{at: L, mass: M*F}]}}",
    "pulled": BEAM.replace(": L", ": 2*L") + "preload: 9 N, foundation: 8 N/m^2, attached: [{at: 2*L, mass: M*F}]}}",
    "two": BEAM + "attached: [{at: L/3, mass: M*F}, {at: L, oscillator: {mass: M, k: 40 N/m}}]}}",
    "driven": BEAM + "attached: [{at: L, mass: M*F}, {at: L, c: 2 N*s/m}]}}\n" + LOADED + """
find: [response]
answers: {"amplitude(b.u(L))": 1 m, "b.u(L)(2 s)": 1 m}
""",
    "damped": BEAM + "attached: [{at: L, mass: M*F}]}}\n" + LOADED + """
damping: {modal: 2 %}
initial: {b.u: 0.01 m*x/L}
find: [response]
""",
    "shaft": """
shafts: {b: {length: L, GIo: GJ, inertia_per_length: ip, left: clamped, attached: [{at: L, inertia: I*F}]}}
initial: {b.phi: 0.01*x/L}
find: [response]
""",
    "chain": """
gravity: 9.81 m/s^2
strings: {b: {from: [0, 0], to: [0, -L], mass_per_length: q, left: pinned, attached: [{at: L, mass: M*F}]}}
""",
    "tied": """
bars:
  one: {length: L, EA: EA, mass_per_length: q, left: {k: 3 N/m}, right: {clamped: b}}
  two: {length: L, EA: EA, mass_per_length: q, left: {clamped: b}}
bodies: {b: {mass: M*F, slide: h}}
""",
}
SIGNAL = re.compile(r"δ?\w+\.\w+\(.*?\)")
SYMBOL = re.compile(r"([α-ωΑ-Ω]|[A-Za-z]+)(_[A-Za-z0-9]+|[₀-₉]+)?")


def introduced(parts, names):
    """What is printed of symbols that the scene has not."""
    for part in parts:
        if type(part) is str:
            for letter, below in SYMBOL.findall(SIGNAL.sub("", part)):
                yield letter + below
        elif isinstance(part, Name):
            yield from () if part.text.rstrip("'") in names else (plain.symbol(part.text.rstrip("'")),)
        elif isinstance(part, Node | Factor):
            for one in reachable([getattr(part, "node", part)]):
                if one.op == "symbol" and one.name not in (*names, "t"):
                    yield from map(plain.symbol, factors_of(one.name) or [one.name])


def formulas(scene):
    """Parts of all that is printed in symbols, heads of tables among them."""
    report = Report(scene)
    for name in EVERYTHING:
        report.add(name)
    for block in [block for section in report.sections for block in section.blocks]:
        if isinstance(block, Equations):
            yield from ((*one.label, *one.parts) for one in block.lines)
        elif isinstance(block, Paragraph):
            yield from (part.parts if isinstance(part, Maths) else [part] for part in block.parts)
        elif isinstance(block, TableBlock):
            yield [head.partition("[")[0] for head in block.head]
    if not scene.numeric.has_free_symbols:
        yield from (line.parts for line in worked(scene))


def with_names(text, names):
    """A scene in which the names multiply a mass."""
    values = [f"{name}: {value}" for name, value in VALUES.items() if re.search(rf"(?<!\w){name}(?![\w:])", text)]
    values += [f"{name}: 1" for name in names]
    return f"parameters: {{{', '.join(values)}}}\n" + text.replace("*F", "".join(f"*{name}" for name in names))


@pytest.mark.parametrize("what", SCENES)
@pytest.mark.parametrize("every", [range(0, len(NAMES), 2), range(1, len(NAMES), 2)], ids=["even", "odd"])
def test_no_letter_is_one_of_the_scene(what, every):
    chosen = [NAMES[k] for k in every]
    scene = problem(with_names(SCENES[what], chosen))
    names = {*scene.scene.coordinates, *scene.scene.parameters.nodes}
    own = {plain.symbol(one) for name in names for one in factors_of(name) or [name]} - {"A", "L"}      # of δA, βL
    told = {one for parts in formulas(scene) for one in introduced(parts, names)}
    assert told & own == set()
    assert len(told) > 12


@pytest.mark.sweep
def test_natural_frequencies_beside_a_drive_named_omega():
    """ω is the drive, ω_n what the shapes hang on; ζ and λ are others where the scene has these."""
    scene = problem("""
        parameters: {m: , k: , F: {unit: N}, omega: {unit: rad/s}, lambda: {unit: kg}, c: {unit: N*s/m}}
        bodies: {a: {mass: m, slide: x}, b: {mass: lambda, slide: y}}
        springs: {one: {between: [ground, a], k: k}, two: {between: [a, b], k: k}}
        dampers: {d: {between: [ground, a], c: c}}
        forces: {f: {coordinate: x, value: F*sin(omega*t)}}
        """)
    report = Report(scene)
    for name in ("frequencies", "damping", "modes"):
        report.add(name)
    lines = [line.parts for section in report.sections for block in section.blocks if isinstance(block, Equations)
             for line in block.lines]
    told = {one for parts in lines for one in introduced(parts, scene.scene.parameters.nodes.keys())}
    assert "ω_n" in told and told.isdisjoint({"ω", "λ"})
