"""Mutated starts, questions, loads and answers of motions in time and frequency responses: nothing but a diagnostic or
a refusal escapes, and all data are finite."""

import json
import random

from support.hostile_texts import EXTREMES, SAME, require_told

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.check.verdicts import check
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec
from vibcli.report.sections.frequency_response import frequency_response_data
from vibcli.report.sections.motion_data import response_data
from vibcli.report.wanted import Wanted
from vibcli.results.problem import Problem

BODIES = (
    "  cart: {mass: 5 kg, at: [0, 0], slide: x}\n"
    "  bob: {mass: 2 kg, at: [0, -0.7 m], pin: {at: [0, 0], carrier: cart, by: phi}}\n",
    "  cart: {mass: 5 kg, at: [0, 0], slide: x}\n  bob: {mass: 2 kg, at: [1 m, 0], slide: {along: [1, 0], by: phi}}\n")
SCENE = """gravity: 9.81 m/s^2
points:
  W: {{at: [-1 m, 0], moves: [{0}, 0]}}
bodies:
{1}springs:
  s: {{k: 400 N/m, between: [W, cart]}}
  r: {{k: 90 N/m, between: [[2 m, -0.7 m], bob]}}
dampers:
  d: {{c: {2}, between: [W, cart]}}
forces:
  pull: {{at: bob, force: [{3}, 0]}}
initial: {4}
motion: {5}
find: [{{response: {{until: {6}, of: [{7}, {8}]}}}}, {{frequency_response: {{of: [{9}]}}}}]
answers:
  "{10}": {11}
  "{12}": {11}
"""
LOADS = ("3 N*sin(6 rad/s*t)", "3 N*step(t - 0.1 s)", "2 N*s*impulse(t - 0.2 s)", "3 N*square(4 rad/s*t)",
         "3 N*ramp(t/1 s)*exp(-t/1 s)", "0 N", "3 N", "3 N*sin(5 rad/s*t)^3", "3 N*sawtooth(-4 rad/s*t)",
         "3 N*sin(6 rad/s*t)*(step(t) - step(t - 1 s))", "3 N*cos(8.944271909999159 rad/s*t)", "3 N*t^4/(1 s)^4",
         "-2 N*s*impulse(t)", "3 N*step(-t)", "3 N*x/(1 m)*sin(3 rad/s*t)", "3 N*abs(sin(6 rad/s*t))")
MOVES = ("0 m", "1 cm*sin(3 rad/s*t)", "1 cm*step(t)", "1 cm*ramp(t/1 s)", "1 cm*square(3 rad/s*t)", "1 cm*t^2/(1 s)^2")
STARTS = ("{x: 2 cm}", "{x: 0 m}", "{x': 0.5 m/s}", "{released: pull}", "{x: 1 cm, x': 0 m/s}", "{}", "{x: -1e30 m}",
          "{phi: 0, phi': 1 rad/s}", "{x: 1e-30 m}", "{phi: 180 deg}", "{x: 1 kg}", "{y: 1 m}", "{x'': 1 m/s^2}", "[x]",
          "{x: x}", "3", "{phi: 1e9}")
ENDS = ("2 s", "0.5 s", "0 s", "-1 s", "1e-30 s", "1e30 s", "2 m", "x", "1/0 s", "30 s")
SIGNALS = ("x", "phi", "x'", "phi''", "s.force", "s.stretch", "d.force", "d.power", "s.energy", "bob.x", "bob.y", "W.x",
           "ground.force.x", "x*phi", "x^2", "1/x", "sqrt(x)", "abs(x)", "0*x", "x - x", "max(x, 0)", "t", "nobody",
           "5", "bob.reaction.x", "log(x)", "x + phi", "sin(phi)", "x'*s.force")
INPUTS = ("pull", "W", "x", "phi", "W.x", "W.y", "nobody", "cart", "5", "s")
VALUES = ("0", "0", "0", "0", "0", "0", "0", "0", "1", "1 m", "1e-300", "x")
TIMES = ("0 s", "0.4 s", "9 s", "-1 s", "1e300 s", "3", "x", "2*pi/omega[1]")
RATES = ("0 rad/s", "5 rad/s", "2 Hz", "1e12 rad/s", "1e-12 rad/s", "-4 Hz", "omega[1]", "8.944271909999159 rad/s",
         "3 m")
OF_SIGNAL = ("amplitude", "phase", "mean", "rms", "final", "period", "overshoot", "decrement", "beat_period", "max",
             "min", "argmax", "argmin", "zero[1]", "zero[0]", "zero[99]", "time_to[0.1]", "time_to[0]", "time_to[2]",
             "cycles_to[0.5]", "harmonic[1]", "harmonic[3]", "harmonic[-1]", "harmonic[0]", "peak[1]", "nothing")
OF_CURVE = ("peak[1]({}).Omega", "peak[2]({}).value", "peak[0]({}).value", "antiresonance[1]({})", "half_power[1]({})",
            "half_power[4]({})", "quality[1]({})", "quality[7]({})", "peak[1]({})", "abs({})")


def question(dice):
    """A quantity of a response."""
    signal, kind = dice.choice(SIGNALS), dice.randrange(5)
    curve = f"{dice.choice(('frf', 'frf', 'transmissibility'))}[{signal}, {dice.choice(INPUTS)}]"
    if kind == 0:
        return f"({signal})({dice.choice(TIMES)})"
    if kind == 1:
        return f"{dice.choice(OF_SIGNAL)}({signal})"
    if kind == 2:
        return f"{dice.choice(('abs', 'arg', 're', 'im', 'phase', 'max'))}({curve}({dice.choice(RATES)}))"
    if kind == 3:
        return dice.choice(OF_CURVE).format(curve)
    return f"{dice.choice(('steady', 'transient', 'envelope'))}({signal})({dice.choice(TIMES)})"


def scene(dice):
    """A scene whose parts are chosen, some spoiled."""
    good = SIGNALS[:13] if dice.random() < 0.7 else SIGNALS
    start = dice.choice(STARTS[:5] if dice.random() < 0.7 else STARTS)
    parts = [dice.choice(MOVES), dice.choice(BODIES), dice.choice(("4 N*s/m", "0 N*s/m", "-4 N*s/m", "400 N*s/m")),
             dice.choice(LOADS), start, dice.choice(("small",) * 8 + ("full", "big")),
             dice.choice(ENDS[:2] if dice.random() < 0.7 else ENDS), dice.choice(good), dice.choice(good),
             dice.choice(SIGNALS[:11]), question(dice), dice.choice(VALUES), question(dice)]
    if dice.random() < 0.3:
        place = dice.choice((0, 3, 6, 7, 10, 12))
        parts[place] = (dice.choice(EXTREMES) if dice.random() < 0.5
                        else dice.choice(SAME).replace("_", parts[place]))
    return SCENE.format(*parts)


def outcome(text):
    """The kind of outcome of a scene: its data and answers, diagnostics or refusals."""
    node, diagnostics = read(text.encode(), "s.yaml")
    found = set()
    try:
        if node is None:
            raise SpecError(diagnostics)
        spec = read_spec(node, "s.yaml", diagnostics)
        problem = Problem(spec)
        problem.draw()
        for data in (response_data, frequency_response_data):
            try:
                json.dumps(data(problem, Wanted(points=20)), allow_nan=False)
                found.add("solved")
            except PhysicsError as error:
                assert error.message
                found.add("refused")
        for verdict in check(problem):
            json.dumps([verdict.expected, verdict.found], allow_nan=False)
    except SpecError as error:
        require_told(error)
        return "invalid"
    except PhysicsError as error:
        assert error.message
        return "refused"
    return "solved" if "solved" in found else "refused"


def test_responses_with_changes():
    dice = random.Random(11)
    outcomes = [outcome(scene(dice)) for _ in range(250)]
    assert min(outcomes.count(kind) for kind in ("solved", "invalid")) >= 5
