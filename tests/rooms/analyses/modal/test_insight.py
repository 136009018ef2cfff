"""Shares, sensitivities and estimates: against differences of the whole pipeline, identities and closed forms."""

import json
import math
import random
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from support.scenes import problem, problem_of, value

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.program import run
from vibcli.symbolic.dual_numbers import Dual, Duals, slope
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression import Table

TIGHT = 1e-14

# sensitivities against differences: name, values of the parameters, the rest of the scene

SCENES = {
    "damped chain": ({"m": "2 kg", "k": "800 N/m", "c": "3 N*s/m"}, """
        bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}}
        springs: {s: {k: k, between: [ground, a]}, t: {k: 3*k, between: [a, b]}}
        dampers: {d: {c: c, between: [a, b]}}"""),
    "stiff chain": ({"m": "2 kg", "k": "800 N/m", "K": "8e16 N/m"}, """
        bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}, c: {mass: m, slide: z}}
        springs:
          s: {k: k, between: [ground, a]}
          t: {k: K, between: [a, b]}
          u: {k: K/3, between: [b, c]}"""),
    "sagging spring pendulum": ({"m": "2 kg", "k": "300 N/m", "l": "0.7 m", "g": "9.81 m/s^2", "F": "0.3"}, """
        gravity: [F*g, -g]
        bodies: {bob: {mass: m, at: [0, -l], move: [x, y, 0]}}
        springs: {s: {k: k, between: [[0, 0], bob]}}"""),
    "rod on a sagging mass, preload and damper": (
        {"m": "2 kg", "k": "300 N/m", "l": "0.7 m", "g": "9.81 m/s^2", "c": "3 N*s/m", "N": "20 N",
         "kt": "15 N*m/rad", "a": "0.4 m", "J": "0.3 kg*m^2"}, """
        gravity: g
        points: {P: {body: rod, at: [a, 0]}}
        bodies:
          bob: {mass: m, at: [0, -l], move: [x, y, 0]}
          rod: {shape: rod, mass: m, from: [0, -l], to: [2*a, -l - a], pin: {at: [0, 0], carrier: bob, by: phi},
                inertia: J}
        springs:
          s: {k: k, between: [[0, 0], bob]}
          t: {torsion: kt, between: [bob, rod]}
          u: {k: 2*k, between: [[3 m, 1 m], P], preload: N}
        dampers: {d: {c: c, between: [[0, 0], bob]}}"""),
    "static preload": ({"m": "3 kg", "L": "1.2 m", "k": "500 N/m", "b": "0.5 m", "g": "9.81 m/s^2"}, """
        gravity: g
        points: {A: {body: rod, at: [L, 0]}}
        bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
        springs: {s: {k: k, between: [A, [b, 2*b]], preload: static}}"""),
    "drawn at an angle that is a parameter": ({"m": "3 kg", "L": "1.2 m", "kt": "50 N*m/rad", "a": "0.4 rad",
                                               "g": "9.81 m/s^2"}, """
        gravity: g
        coordinates: {phi: {drawn: a}}
        bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [L*cos(a), L*sin(a)], pin: {at: [0, 0], by: phi}}}
        springs: {s: {torsion: kt, between: [ground, rod]}}"""),
    "massless coordinate": ({"m": "3 kg", "k": "500 N/m", "k2": "700 N/m"}, """
        bodies: {a: {mass: m, slide: x}, joint: {slide: y}}
        springs: {s: {k: k, between: [ground, joint]}, t: {k: k2, between: [joint, a]}}"""),
    "free coordinate": ({"m": "2 kg", "L": "0.5 m", "k": "900 N/m", "N": "5 N", "g": "9.81 m/s^2"}, """
        gravity: g
        bodies:
          cart: {mass: 3*m, at: [0, 0], slide: x}
          bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
          box: {mass: m, at: [1 m, 0], slide: {along: [1, 0], by: u, carrier: cart}}
        springs: {s: {k: k, between: [cart, box], preload: N}}"""),
    "floating chain with a preload": ({"m": "2 kg", "k": "800 N/m", "N": "3 N"}, """
        bodies: {a: {mass: m, slide: x}, b: {mass: 3*m, slide: y}}
        springs: {s: {k: k, between: [a, b], preload: N}}"""),
    "gyroscopic": ({"m": "2 kg", "k": "80 N/m", "h": "6 N*s/m"}, """
        coordinates: [x, y]
        matrices: {M: [[m, 0], [0, 2*m]], C: [[0, h], [-h, 0]], K: [[k, 0], [0, 3*k]]}"""),
    "gyroscopic and damped": ({"m": "2 kg", "k": "80 N/m", "h": "6 N*s/m", "c": "2 N*s/m"}, """
        coordinates: [x, y]
        matrices: {M: [[m, 0], [0, 2*m]], C: [[c, h], [-h, 0]], K: [[k, 0], [0, 3*k]]}"""),
    "over-damped": ({"m": "2 kg", "k": "80 N/m", "c": "60 N*s/m"}, """
        bodies: {a: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, a]}}
        dampers: {d: {c: c, between: [ground, a]}}"""),
    "written out": ({"m": "2 kg", "r": "0.3 m", "Om": "4 rad/s", "g": "9.81 m/s^2"}, """
        energies:
          T: m*r^2/2*(q'^2 + Om^2*sin(q)^2)
          V: -m*g*r*cos(q)"""),
}


def scene(values, rest):
    return problem("parameters: {" + ", ".join(f"{name}: {text}" for name, text in values.items()) + "}\n"
                   + "\n".join(line.removeprefix(" " * 8) for line in rest.split("\n")))


def spectra(values, rest):
    """(ω of the modes, λ, ζ of the damped modes) to 45 digits."""
    modal = scene(values, rest).modal
    natural, damped = modal.modes_to(45), modal.damped_to(45)
    return ([mode.omega for mode in natural], [mode.eigenvalue for mode in damped or ()],
            [mode.zeta for mode in damped or ()])


def varied(values, name, step):
    """The values with one of them changed, as an exact decimal."""
    number, _, unit = values[name].partition(" ")
    with mpmath.workdps(45):
        exact = mpmath.mpf(Fraction(number).numerator) / Fraction(number).denominator + step
        return values | {name: f"{mpmath.nstr(exact, 40)} {unit}".strip()}


def differences(values, rest, name):
    """Central differences of the spectra by one parameter, their own error 10⁻²⁰ or so."""
    size = abs(float(Fraction(values[name].partition(" ")[0])))
    step = mpmath.mpf(10) ** -12 * (size or 1)
    with mpmath.workdps(60):
        high, low = (spectra(varied(values, name, sign * step), rest) for sign in (1, -1))
        return [[None if a is None else (a - b) / (2 * step) for a, b in zip(up, down, strict=True)]
                for up, down in zip(high, low, strict=True)]


@pytest.mark.sweep
@pytest.mark.parametrize("which", SCENES)
def test_sensitivities_are_the_differences_of_the_pipeline(which):
    values, rest = SCENES[which]
    found = scene(values, rest).modal.result("sensitivities")
    assert not found.refused and not found.coinciding and list(found.values) == list(values)
    swept = 0
    for name in values:
        omega, roots, zeta = differences(values, rest, name)
        for index, rate in found.omega[name].items():
            assert abs(rate - omega[index - 1]) <= TIGHT * abs(omega[index - 1]) + 1e-30
            swept += 1
        moving = [(a, b) for a, b in zip(roots, zeta, strict=True)][-len(found.damped or ()):] if found.damped else []
        for one, (root, ratio) in zip(found.damped or (), moving, strict=True):
            assert abs(one.eigenvalue[name] - root) <= TIGHT * abs(root) + 1e-18
            assert abs(one.zeta[name] - ratio) <= TIGHT * abs(ratio) + 1e-18
            swept += 1
    assert swept >= len(values)


def test_the_comparison_would_see_a_fixed_equilibrium():
    """Of the sagging spring pendulum the shift of the equilibrium is half of what gravity does."""
    values, rest = SCENES["sagging spring pendulum"]
    found = scene(values, rest)
    assert not found.configuration.equilibrium.drawn
    swing = found.modal.result("sensitivities").omega["k"][1]
    assert abs(swing) > 1e-4        # ∂ω/∂k at a fixed place is not this


def test_mass_of_a_massless_coordinate():
    """Of ω² = k/m with k in series, a small mass at the joint: ω′/ω = −(k₂/(k₁ + k₂))²/2m."""
    values, rest = SCENES["massless coordinate"]
    found = scene(values | {"mu": "0 kg"}, rest.replace("{slide: y}", "{mass: mu, slide: y}")).modal.result(
        "sensitivities")
    omega = math.sqrt(500 * 700 / 1200 / 3)
    assert found.omega["mu"][1] == pytest.approx(-omega / 6 * (700 / 1200) ** 2, rel=1e-14)


# identities


def random_chain(seed):
    """(number of masses, values, scene) of a chain of random masses and springs, some of them to the ground."""
    draw = random.Random(seed)
    n = draw.randint(2, 6)
    values = {f"m{i}": f"{draw.uniform(0.5, 5):.3f} kg" for i in range(n)}
    values |= {f"k{i}": f"{10 ** draw.uniform(1, 5):.3f} N/m" for i in range(n)}
    bodies = "".join(f"  b{i}: {{mass: m{i}, slide: x{i}}}\n" for i in range(n))
    ends = ["ground"] + [draw.choice([f"b{i - 1}", "ground", f"b{i - 1}"]) for i in range(1, n)]
    springs = "".join(f"  s{i}: {{k: k{i}, between: [{end}, b{i}]}}\n" for i, end in enumerate(ends))
    return n, scene(values, f"\nbodies:\n{bodies}\nsprings:\n{springs}")


@pytest.mark.parametrize("seed", range(8))
def test_identities_of_random_chains(seed):
    n, chain = random_chain(seed)
    shares, found = chain.modal.result("shares"), chain.modal.result("sensitivities")
    for mode in chain.modal.modes:
        omega = float(mode.omega)
        logs = {name: found.values[name] * found.omega[name][mode.index] / omega for name in found.values}
        assert sum(logs[f"m{i}"] for i in range(n)) == pytest.approx(-0.5, rel=1e-13)
        assert sum(logs[f"k{i}"] for i in range(n)) == pytest.approx(0.5, rel=1e-13)
        for i in range(n):      # the logarithmic sensitivity is half the share of the energy
            assert logs[f"k{i}"] == pytest.approx(shares.potential[mode.index][f"s{i}"] / 2, abs=1e-14)
            assert logs[f"m{i}"] == pytest.approx(-shares.kinetic[mode.index][f"b{i}"] / 2, abs=1e-14)
    estimate = chain.modal.result("estimates")
    assert estimate.rayleigh >= estimate.omega * (1 - 1e-15) >= estimate.dunkerley * (1 - 2e-15)
    whole = sum(1 / float(mode.omega) ** 2 for mode in chain.modal.modes)
    assert estimate.dunkerley == pytest.approx(whole**-0.5, rel=1e-13)
    assert sum(alone**-2 for alone in estimate.alone.values()) == pytest.approx(whole, rel=1e-13)


def test_estimates_of_lengths_and_angles_together():
    """A bar on two springs: δ is the deflection under inertia forces of a motion x alone, in metres or millimetres."""
    m, J, k, n, a, b = 3.0, 0.2, 900.0, 2500.0, 0.3, 0.5
    stiff = np.array([[k + n, n * b - k * a], [n * b - k * a, k * a * a + n * b * b]])
    deflection = np.linalg.solve(stiff, [m, 0.0])
    rayleigh = math.sqrt(deflection @ stiff @ deflection / (m * deflection[0] ** 2 + J * deflection[1] ** 2))
    dunkerley = np.trace(np.linalg.solve(stiff, np.diag([m, J]))) ** -0.5
    for lengths in ({"a": "0.3 m", "b": "0.5 m"}, {"a": "300 mm", "b": "500 mm"}):
        found = scene({"m": "3 kg", "J": "0.2 kg*m^2", "k": "900 N/m", "n": "2500 N/m"} | lengths, """
        bodies: {bar: {mass: m, inertia: J, at: [0, 0], move: [0, y, phi]}}
        points: {A: {body: bar, at: [-a, 0]}, B: {body: bar, at: [b, 0]}}
        springs: {s: {k: k, between: [A, [-a, -1 m]]}, r: {k: n, between: [B, [b, -1 m]]}}
        """).modal.result("estimates")
        assert found.rayleigh == pytest.approx(rayleigh, rel=1e-13)
        assert found.dunkerley == pytest.approx(dunkerley, rel=1e-13)
        assert found.deflection["y"] == pytest.approx(deflection[0] / max(deflection, key=abs), rel=1e-13)


@pytest.mark.sweep
def test_scaling_of_units():
    """Other units of mass and time: Σ over masses and stiffnesses is 0, over stiffnesses and g ½."""
    values, rest = SCENES["rod on a sagging mass, preload and damper"]
    numeric = scene(values, rest)
    found = numeric.modal.result("sensitivities")
    for mode in numeric.modal.modes:
        logs = {name: found.values[name] * found.omega[name][mode.index] / float(mode.omega) for name in values}
        assert sum(logs[name] for name in ("m", "k", "N", "kt", "J")) == pytest.approx(0, abs=1e-14)
        assert sum(logs[name] for name in ("k", "N", "kt", "g")) == pytest.approx(0.5, rel=1e-13)


@pytest.mark.parametrize("which", SCENES)
def test_shares_add_up_to_one(which):
    found = scene(*SCENES[which]).modal.result("shares")
    columns = [*found.potential.values(), *found.kinetic.values(), *(shares for _, shares in found.dissipation or ())]
    sums = [sum(column.values()) for column in columns if column]
    assert sums == pytest.approx([1] * len(sums), rel=1e-13)
    assert len(sums) >= 2


# shares


def test_shares_of_a_hanging_rod():
    """½ k a² + ½ m g L/2 of a rod that hangs on a pin, and the preload N L (L + h)/h of a spring below it."""
    m, L, h, N, g = 3, 1.2, 0.5, 40, 9.81
    found = problem(f"""
        parameters: {{m: {m} kg, L: {L} m, h: {h} m, k: 500 N/m, N: {N} N, kt: 20 N*m/rad, g: {g} m/s^2}}
        gravity: g
        points: {{A: {{body: rod, at: [0, -L]}}}}
        bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {{at: [0, 0], by: phi}}}}}}
        springs:
          s: {{k: k, between: [A, [0, -(L + h)]], preload: N}}
          t: {{torsion: kt, between: [ground, rod]}}
        """).modal.result("shares").potential[1]
    parts = {"s": 0, "t": 20, "tension of s": N * L * (L + h) / h, "the weights": m * g * L / 2}
    assert found == pytest.approx({name: part / sum(parts.values()) for name, part in parts.items()}, rel=1e-13)


def test_negative_shares():
    """Of an inverted pendulum the weight lowers the stiffness; of an unstable one all is measured by −K."""
    text = """
        parameters: {{m: 2 kg, L: 0.5 m, kt: {} N*m/rad, g: 9.81 m/s^2}}
        gravity: g
        bodies: {{bob: {{mass: m, at: [0, L], pin: {{at: [0, 0], by: phi}}}}}}
        springs: {{t: {{torsion: kt, between: [ground, bob]}}}}
        """
    K = 15 - 9.81
    assert problem(text.format(15)).modal.result("shares").potential[1] == pytest.approx(
        {"t": 15 / K, "the weights": -9.81 / K})
    K = 5 - 9.81
    assert problem(text.format(5)).modal.result("shares").potential[1] == pytest.approx(
        {"t": 5 / K, "the weights": -9.81 / K})


def test_shares_of_dampers():
    found = problem("""
        bodies: {a: {mass: 2, slide: x}, b: {mass: 2, slide: y}}
        springs: {s: {k: 800, between: [ground, a]}, t: {k: 800, between: [a, b]}, u: {k: 800, between: [ground, b]}}
        dampers: {d: {c: 3, between: [a, b]}, e: {c: 1, between: [ground, a]}, f: {c: 1, between: [ground, b]}}
        """).modal.result("shares")
    first, second = (shares for _, shares in found.dissipation)
    assert first == {"d": 0.0, "e": pytest.approx(0.5), "f": pytest.approx(0.5)}
    assert second == pytest.approx({"d": 12 / 14, "e": 1 / 14, "f": 1 / 14})


def test_no_shares_where_there_is_no_energy():
    found = problem("bodies: {a: {mass: 2, slide: x}, b: {mass: 2, slide: y}}\n"
                    "springs: {s: {k: 800, between: [a, b]}}\ndampers: {d: {c: 3, between: [a, b]}}").modal.result(
                        "shares")
    assert found.potential[1] == {} and found.kinetic[1] == {"a": 0.5, "b": 0.5}
    assert [shares for _, shares in found.dissipation] == [{"d": 1.0}]


def test_a_stiff_spring_has_a_small_share():
    """c₀ as a rigid link: its share is that of F²/K, with the force F that passes through it."""
    found = scene(*SCENES["stiff chain"]).modal.result("shares").potential[1]
    omega2 = 800 / 8
    inertia = 6 * omega2      # of b and c at unit amplitude
    assert found["t"] == pytest.approx(inertia**2 / 8e16 / 800, rel=1e-9)


# coinciding and damped modes


def test_coinciding_frequencies_split():
    """Three equal masses on a ring: the differences of the ordered frequencies as one spring stiffens."""
    values = {"m": "2 kg", "k": "800 N/m", "k1": "800 N/m"}
    rest = """
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}, c: {mass: m, slide: z}}
        springs: {s: {k: k1, between: [a, b]}, t: {k: k, between: [b, c]}, u: {k: k, between: [c, a]}}"""
    found = scene(values, rest).modal.result("sensitivities")
    assert found.coinciding == [[2, 3]]
    with mpmath.workdps(60):
        start = spectra(values, rest)[0]
        step = mpmath.mpf(10) ** -18
        grown = spectra(varied(values, "k1", step), rest)[0]
        rates = [float((a - b) / step) for a, b in zip(grown, start, strict=True)]
    assert [found.omega["k1"][i] for i in (2, 3)] == pytest.approx(rates[1:], rel=1e-9, abs=1e-12)
    assert found.omega["m"] == pytest.approx(dict.fromkeys((2, 3), -math.sqrt(1200) / 4))


def test_a_double_eigenvalue_has_no_derivative():
    text = SCENES["over-damped"][1]
    found = scene({"m": "2 kg", "k": "50 N/m", "c": "20 N*s/m"}, text).modal.result("sensitivities")
    assert [(one.eigenvalue, one.zeta) for one in found.damped] == [(None, None)] * 2
    assert found.omega["k"][1] == pytest.approx(0.05)


def test_zeta_of_one_mass():
    """ζ = c/(2√(km)), under- and over-damped."""
    for c in ("3", "60"):
        found = scene({"m": "2 kg", "k": "80 N/m", "c": f"{c} N*s/m"}, SCENES["over-damped"][1]).modal.result(
            "sensitivities")
        zeta = float(c) / (2 * math.sqrt(160))
        for one in found.damped:
            assert one.zeta == pytest.approx({"m": -zeta / 4, "k": -zeta / 160, "c": zeta / float(c)}, rel=1e-14)


# where there is none


def test_an_equilibrium_that_does_not_persist():
    """A block that moves freely on a level floor slides off as the floor tilts."""
    found = problem("""
        parameters: {m: 2 kg, k: 300 N/m, a: 0 rad, L: 1 m, g: 9.81 m/s^2}
        gravity: [g*sin(a), -g*cos(a)]
        bodies:
          block: {mass: m, at: [0, 0], slide: x}
          bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: block, by: phi}}
        """.replace("k: 300 N/m, ", "")).modal.result("sensitivities")
    assert list(found.refused) == ["a"] and "does not persist" in found.refused["a"]
    assert found.omega["g"] == {2: pytest.approx(math.sqrt(2 * 9.81) / 2 / 9.81)}


@pytest.mark.parametrize(("quantity", "words"), [
    ("sensitivity[1,k]", "rigid-body mode"), ("rayleigh", "rigid-body mode"), ("sensitivity[3,k]", "no mode 3")])
def test_quantities_refused(quantity, words):
    free = problem("parameters: {k: 3}\nbodies: {a: {mass: 2, slide: x}, b: {mass: 2, slide: y}}\n"
                   "springs: {s: {k: k, between: [a, b]}}")
    with pytest.raises(PhysicsError, match=words):
        value(free, quantity)


def test_estimates_refused():
    with pytest.raises(PhysicsError, match="gyroscopic"):
        _ = scene(*SCENES["gyroscopic"]).modal.result("estimates")
    with pytest.raises(PhysicsError, match="unstable"):
        _ = problem("coordinates: [x]\nmatrices: {M: [[1]], K: [[-4]]}").modal.result("estimates")
    with pytest.raises(PhysicsError, match="massless"):
        _ = problem("coordinates: [x, y]\nmatrices: {M: [[1, 0], [0, 0]], K: [[4, 1], [1, -1]]}").modal.result(
            "estimates")


def test_too_many_coordinates():
    n = 81
    text = ("bodies:\n" + "".join(f"  b{i}: {{mass: 1, slide: x{i}}}\n" for i in range(n))
            + "springs:\n" + "".join(f"  s{i}: {{k: 1, between: [ground, b{i}]}}\n" for i in range(n)))
    with pytest.raises(PhysicsError, match="up to 80"):
        _ = problem(text).modal.result("shares")


def test_letters_are_refused():
    with pytest.raises(PhysicsError, match="needs numbers"):
        _ = problem("parameters: {k: }\nbodies: {a: {mass: 1, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, a]}}").modal.result("sensitivities")


def test_which_parameters_may_be_asked_for():
    scene = """
        parameters: {k: 3, k2: 2*k}
        bodies: {a: {mass: 1, slide: x}}
        springs: {s: {k: k2, between: [ground, a]}}
        answers: {"sensitivity[1,%s]": 1}
        """
    assert value(problem(scene % "k"), "sensitivity[1,k]") == pytest.approx(1 / math.sqrt(6))
    with pytest.raises(SpecError, match="'k2' is defined by other parameters"):
        problem(scene % "k2")
    with pytest.raises(SpecError, match="no parameter 'x'"):
        problem(scene % "x")


def test_dimension_of_a_sensitivity():
    scene = """
        parameters: {m: 3 kg, k: 12 N/m}
        bodies: {a: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, a]}}
        answers: {"sensitivity[1,m]": -0.3333 rad/s%s}
        """
    assert value(problem(scene % "/kg"), "sensitivity[1,m]") == pytest.approx(-1 / 3)
    with pytest.raises(SpecError, match="expected"):
        problem(scene % "/N")


# dual numbers

FUNCTIONS = ["sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "abs", "sign"]


@pytest.mark.parametrize("arithmetic", [Floats, None], ids=["floats", "mpmath"])
@pytest.mark.parametrize("name", [*FUNCTIONS, "atan2", "min", "max", "power"])
def test_slopes_of_functions(name, arithmetic):
    """Against central differences; of two arguments both change."""
    with mpmath.workdps(40):
        plain, exact = arithmetic or multiprecision(), multiprecision()
        args = [mpmath.mpf("0.37"), mpmath.mpf("0.81")][:1 if name in FUNCTIONS else 2]
        function = exact.functions[name]
        step = mpmath.mpf(10) ** -13
        rate = (function(*(x + step for x in args)) - function(*(x - step for x in args))) / (2 * step)
        number = float if arithmetic else mpmath.mpf
        found = Duals(plain).functions[name](*(Dual(number(x), 1) for x in args))
        assert slope(found) == pytest.approx(float(rate), rel=1e-14)


def test_duals_of_expressions():
    """d/dp of (p² + 3)^(3/2)/sin(p) − p, with a part that does not depend on p kept plain."""
    table = Table()
    p, q = table.parameter("p"), table.parameter("q")
    node = (p * p + 3) ** Fraction(3, 2) / table.call("sin", p) - p
    found, still = evaluate([node, q * q], Duals(Floats), {"p": Dual(1.3, 1.0), "q": 2.0})
    s, c, r = math.sin(1.3), math.cos(1.3), math.sqrt(1.3**2 + 3)
    assert found.value == pytest.approx(r**3 / s - 1.3)
    assert found.slope == pytest.approx(3 * 1.3 * r / s - r**3 * c / s**2 - 1)
    assert still == 4.0 and not isinstance(still, Dual)


# command line

CART = """
title: Cart
parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, a]}, t: {k: k, between: [a, b]}}
dampers: {d: {c: c, between: [a, b]}}
"""
TITLES = ("Shares of the potential energy", "Sensitivity of the natural frequencies", "Sensitivity of the damping",
          "Estimates of the lowest")


@pytest.fixture
def solve(tmp_path, capsys):
    def solved(text, *options, code=0):
        path = tmp_path / "scene.yaml"
        path.write_text(text)
        assert run(["solve", str(path), *options]) == code
        return capsys.readouterr().out
    return solved


def test_only_on_request(solve):
    plain = solve(CART)
    assert not any(title in plain for title in TITLES)
    full = solve(CART, "--insight")
    assert full.startswith(plain.rstrip()) and all(title in full for title in TITLES)
    some = solve(CART + "find: [shares]\n")
    assert TITLES[0] in some and not any(title in some for title in TITLES[1:])
    assert "insight" not in json.loads(solve(CART, "--json"))
    assert list(json.loads(solve(CART + "find: [estimates, shares]\n", "--json"))["insight"]) == ["shares", "estimates"]


def test_json(solve):
    found = json.loads(solve(CART, "--json", "--insight"))["insight"]
    assert [mode["index"] for mode in found["shares"]["modes"]] == [1, 2]
    mass, stiffness, damping = found["sensitivities"]["parameters"]
    assert (mass["parameter"], mass["value"]) == ("m", 2.0)
    assert [mode["logarithmic"] for mode in mass["modes"]] == pytest.approx([-0.5, -0.5])
    assert [mode["logarithmic"] for mode in stiffness["modes"]] == pytest.approx([0.5, 0.5])
    assert [mode["omega"] for mode in damping["modes"]] == [0.0, 0.0]
    assert all(one["zeta"] > 0 for one in damping["damped"])
    assert found["estimates"]["refusal"] is None


@pytest.mark.parametrize("text", [
    "bodies: {a: {mass: 2, slide: x}}\n",
    "bodies: {a: {mass: 2, slide: x}, b: {mass: 2, slide: y}}\nsprings: {s: {k: 3, between: [a, b]}}\n",
    "coordinates: [x]\nmatrices: {M: [[1]], K: [[-4]]}\n",
    "parameters: {h: 3}\ncoordinates: [x, y]\nmatrices: {M: [[1, 0], [0, 1]], C: [[0, h], [-h, 0]], "
    "K: [[0, 0], [0, 0]]}\n",
    "parameters: {c: 2}\nbodies: {a: {mass: 1, slide: x}}\nsprings: {s: {k: 1, between: [ground, a]}}\n"
    "dampers: {d: {c: c, between: [ground, a]}}\n",
], ids=["free", "rigid", "unstable", "magnetic", "critical"])
def test_odd_scenes_are_printed(solve, text):
    assert "Estimates of the lowest natural frequency" in solve(text, "--insight")
    json.loads(solve(text, "--insight", "--json"), parse_constant=lambda constant: pytest.fail(constant))


def test_letters_are_refused_last(solve):
    out = solve(CART.replace("k: 800 N/m", "k: "), "--insight", code=4)
    assert "Natural frequencies" in out and not any(title in out for title in TITLES)


def test_wide_tables_are_cut(solve):
    text = ("bodies:\n" + "".join(f"  b{i}: {{mass: 1, slide: x{i}}}\n" for i in range(10))
            + "springs:\n" + "".join(f"  s{i}: {{k: {i + 1}, between: [ground, b{i}]}}\n" for i in range(10)))
    assert "… 2 more modes: see --json" in solve(text, "--insight")


def test_what_rounds_of_a_static_deflection_is_zero():
    """Pulled sideways a disc on three springs does not turn, not even by 1e-91 of how far it moves."""
    path = Path(__file__).parents[4] / "problems/6_more_degrees/disc_on_three_tight_springs.yaml"
    assert problem_of(path).modal.result("estimates").deflection == {"x": 1.0, "y": 1.0, "phi": 0.0}
