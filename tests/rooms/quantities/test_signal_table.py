"""Every quantity of signals for every kind of signal: the number it has by hand, or the words that refuse it.

One block on a spring, x'' + c x' + k x = F(t): x = free + steady, free = Re(A e^{λt}), steady = Re(X e^{iΩt}).
"""

import cmath
import math
import re
from pathlib import Path

import numpy as np
import pytest
from support.scenes import problem

import vibcli
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.quantities import FAMILIES
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

SCENE = """
points: {{P: {{at: [0, 0], moves: [1 cm*sin(3 rad/s*t), 0]}}}}
bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 1 kg, slide: y}}}}
springs: {{s: {{k: {k} N/m, between: [ground, a]}}, r: {{k: 16 N/m, between: [ground, b]}}}}
dampers: {{d: {{c: {c} N*s/m, between: [ground, a]}}}}
forces: {{F: {{at: a, force: {load}}}}}
initial: {{x: 0.02 m, x': 0.1 m/s}}
motion: {motion}
find: [{{response: {{until: 3 s}}}}]
"""
IN_TIME = [head for head, family in FAMILIES.items() if family == "response"]
PARTS = ("steady", "transient", "envelope")      # signals again
PROBLEM = Path(vibcli.__file__).parent / "examples" / "stop_with_clearance.yaml"
OMEGA, UNTIL, INSTANT = 3.0, 3.0, 0.4
LOADS = {"none": "0 N", "wave": "2 N*sin(3 rad/s*t)", "square": "2 N*square(3 rad/s*t)", "step": "2 N*step(t)",
         "late": "2 N*s*impulse(t - 0.5 s)", "ramp": "2 N*ramp(t/1 s)"}


def squared(t):
    """The steady state under the square wave, k = 25, c = 2: 2/k + Re(C e^{λτ}) on half a period, then its opposite."""
    half, rate = math.pi / OMEGA, complex(-1, math.sqrt(24))
    jump = complex(-0.16, -0.16 * rate.real / rate.imag)        # of x and not of x': Re = −2·2/k, Re λ(…) = 0
    C = jump / (1 + cmath.exp(rate * half))
    odd = np.floor_divide(t, half) % 2
    return (1 - 2 * odd) * (0.08 + np.real(C * np.exp(rate * np.mod(t, half))))


class Exact:
    """x(t) by hand: A, λ, X, and the functions free, steady."""

    def __init__(self, load="none", k=25.0, c=2.0):
        self.given, self.load = {"k": k, "c": c}, load
        self.rate = complex(-c / 2, math.sqrt(max(k - c * c / 4, 0.0)))
        self.X = 2 / (k - OMEGA**2 + 1j * c * OMEGA) / 1j if load == "wave" else 0j
        self.steady = {"square": squared, "step": lambda t: 0.08 + 0.0 * t,
                       "ramp": lambda t: 0.08 * t - 0.08 * c / k}.get(
                           load, lambda t: np.real(self.X * np.exp(1j * OMEGA * t)))
        x = 0.02 - float(self.steady(0.0))
        v = 0.1 - float(4 * self.steady(1e-5) - self.steady(2e-5) - 3 * self.steady(0.0)) / 2e-5
        if self.rate.imag:
            self.A = complex(x, (self.rate.real * x - v) / self.rate.imag)
            self.free = lambda t: np.real(self.A * np.exp(self.rate * t))
        else:
            slow, fast = sorted(np.roots([1, c, k]))[::-1]
            self.A = None
            self.free = (lambda t: x + v * t) if slow == fast else lambda t: (
                (v - fast * x) * np.exp(slow * t) - (v - slow * x) * np.exp(fast * t)) / (slow - fast)
        if load == "late":
            kick, before = -2j / self.rate.imag, self.A
            self.free = lambda t: np.real(before * np.exp(self.rate * t)) + np.where(
                t < 0.5, 0.0, np.real(kick * np.exp(self.rate * (t - 0.5))))
            self.A += kick * cmath.exp(-0.5 * self.rate)


class Kind:
    """A signal, the motion it is read off, its values."""

    def __init__(self, signal, exact, *parts, X=None, A=None, full=False):
        self.signal, self.exact, self.parts = signal, exact, parts
        self.X, self.A = exact.X if X is None else X, exact.A if A is None else A
        self.problem = problem(SCENE.format(load=LOADS[exact.load], motion="full" if full else "small", **exact.given))

    def __call__(self, t):
        return sum((part(t) for part in self.parts), 0.0 * np.asarray(t))


def kinds():
    """{name: Kind}."""
    free, undamped, over, drift = Exact(), Exact(c=0), Exact(c=26), Exact(k=0, c=0)
    wave, wave_over, wave_undamped = Exact("wave"), Exact("wave", c=26), Exact("wave", c=0)
    square, step, late, ramp = Exact("square"), Exact("step"), Exact("late", c=0), Exact("ramp")
    place = lambda t: 0.01 * np.sin(OMEGA * t)                                                              # noqa: E731
    apart = (place, lambda t: -wave.steady(t), lambda t: -wave.free(t))
    return {
        "free": Kind("x", free, free.free), "undamped": Kind("x", undamped, undamped.free),
        "over": Kind("x", over, over.free), "drift": Kind("x", drift, drift.free), "rest": Kind("y", free),
        "zero": Kind("s.stretch - x", free), "wave": Kind("x", wave, wave.free, wave.steady),
        "wave:s": Kind("steady(x)", wave, wave.steady), "wave:t": Kind("transient(x)", wave, wave.free),
        "wave:e": Kind("envelope(transient(x))", wave, lambda t: abs(wave.A) * np.exp(wave.rate.real * t)),
        "wave:over": Kind("x", wave_over, wave_over.free, wave_over.steady),
        "wave:over:t": Kind("transient(x)", wave_over, wave_over.free),
        "wave:undamped": Kind("x", wave_undamped, wave_undamped.free, wave_undamped.steady),
        "wave:undamped:t": Kind("transient(x)", wave_undamped, wave_undamped.free), "wave:rest": Kind("y", wave, X=0j),
        "wave:place": Kind("P.x", wave, place, X=-0.01j), "wave:apart": Kind("P.x - x", wave, *apart,
                                                                              X=-0.01j - wave.X, A=-wave.A),
        "wave:composed": Kind("x - steady(x)", wave, wave.free),
        "square": Kind("x", square, square.free, square.steady),
        "square:s": Kind("steady(x)", square, square.steady), "square:t": Kind("transient(x)", square, square.free),
        "step": Kind("x", step, step.free, step.steady), "step:t": Kind("transient(x)", step, step.free),
        "late": Kind("x", late, late.free), "ramp": Kind("x", ramp, ramp.free, ramp.steady),
        "full": Kind("x", free, free.free, full=True), "full:s": Kind("steady(x)", free, full=True),
    }


QUANTITIES = """amplitude phase max min argmax argmin mean rms final overshoot decrement beat_period harmonic zero
    time_to cycles_to steady transient envelope period value"""
# f: as of a free vibration, s: as of a steady state, e: as of both, n: by its values, 0: zero; the others: REFUSED
TABLE = """
free            f f  n n n n  R R  n n  f B H n  f f  0 f f  f n
undamped        f f  n n n n  0 f  V V  0 B H n  D D  0 f f  f n
over            W W  n n n n  R R  n n  W B H Z  W W  0 f W  W n
drift           W W  n n n n  G G  L L  W B H Z  W W  0 f W  W n
rest            0 W  n n n n  R R  n O  W B H Z  W W  0 0 W  W n
zero            0 W  n n n n  R R  n O  W B H Z  W W  0 0 W  W n
wave            s s  n n n n  0 s  Y Y  K B s n  K K  s f e  s n
wave:s          s s  n n n n  0 s  Y Y  S B s n  S S  s 0 s  s n
wave:t          f f  n n n n  R R  n n  f B H n  f f  0 f f  f n
wave:e          E E  n n n n  R R  n n  E E E Z  E E  E E E  E n
wave:over       s s  n n n n  0 s  Y Y  K B s n  K K  s f s  s n
wave:over:t     W W  n n n n  R R  n n  W B H Z  W W  0 f W  W n
wave:undamped   s s  n n n n  0 s  Y Y  K B s n  K K  s f e  s n
wave:undamped:t f f  n n n n  0 f  V V  0 B H n  D D  0 f f  f n
wave:rest       0 N  n n n n  0 0  n O  K B P Z  K K  0 0 v  P n
wave:place      s s  n n n n  0 s  Y Y  K B s n  K K  s 0 s  s n
wave:apart      s s  n n n n  0 s  Y Y  K B s n  K K  s t e  s n
wave:composed   E E  n n n n  0 0  E E  E E E n  E E  0 f E  E n
square          q M  n n n n  0 q  Q Q  K B q n  K K  s f M  s n
square:s        q M  n n n n  0 q  Q Q  S B q n  S S  s 0 M  s n
square:t        f f  n n n n  R R  n n  f B H n  f f  0 f f  f n
step            f f  n n n n  R R  n n  f B H Z  f f  s f f  f n
step:t          f f  n n n n  R R  n n  f B H n  f f  0 f f  f n
late            f U  n n n n  0 f  V V  0 B H n  D D  0 f U  f n
ramp            f f  n n n n  G G  L L  f B H Z  f f  s f f  f n
full            E E  n n n n  E E  E E  E E E n  E E  E E E  T n
full:s          E E  E E E E  E E  E E  E E E E  E E  E E E  E E
"""
REFUSED = {
    "W": "does not vibrate freely", "K": "keep this signal in motion: it is no free vibration",
    "S": "a steady state is no free vibration", "R": "comes to rest: it has no period", "G": "drifts or grows",
    "V": "keeps vibrating", "Y": "loads oscillate without end",
    "L": "drifts without end", "O": "ends where it starts", "B": "has no beats",
    "H": "no load that repeats itself drives", "Z": "passes through zero 0 times", "D": "does not die out",
    "E": "(composed of others|an envelope|that is integrated)", "N": "it holds no harmonics", "P": "is at rest",
    "M": "harmonics without end", "Q": "the load is periodic", "U": "free only from t = 0.5 s on",
    "T": "no one period", "v": "this signal does not vibrate",
}
INDEX = {"harmonic": "[1]", "zero": "[1]", "time_to": "[0.1]", "cycles_to": "[0.5]"}
TIMES = np.linspace(0.0, UNTIL, 60_001)


def turned(angle):
    return -((-angle + math.pi) % (2 * math.pi) - math.pi)


def refined(function, t, rounds=60):
    """The largest value of a function about an instant of TIMES, with its place."""
    low, high = max(t - TIMES[1], 0.0), min(t + TIMES[1], UNTIL)
    for _ in range(rounds):
        a, b = low + 0.382 * (high - low), high - 0.382 * (high - low)
        low, high = (low, b) if function(a) >= function(b) else (a, high)
    return (low, function(low)) if function(low) >= function(high) else (high, function(high))


def extreme(kind, sense):
    """The earliest of equals."""
    values = sense * kind(TIMES)
    peak = np.append(values[:-1] >= values[1:], True) & np.append(True, values[1:] >= values[:-1])
    first = int(np.flatnonzero(peak & (values >= values.max() - 1e-7 * np.ptp(values)))[0])
    at, value = refined(lambda t: sense * float(kind(t)), TIMES[first])
    return at, sense * value


def limit(kind):
    return float(kind(1e3)) if any(part(np.array([0.0])).any() for part in kind.parts) else 0.0


def first_zero(kind):
    values = kind(TIMES)
    i = int(np.flatnonzero(values[:-1] * values[1:] <= 0)[0])
    return TIMES[i] - values[i] * TIMES[1] / (values[i + 1] - values[i])


def overshoot(kind):
    start, end = float(kind(0.0)), limit(kind)
    return max(0.0, (extreme(kind, 1 if end > start else -1)[1] - end) / (end - start))


def mean_square(kind):
    x, w = np.polynomial.legendre.leggauss(60)
    return 0.5 * w @ kind.exact.steady(0.5 * math.pi / OMEGA * (1 + x)) ** 2


def first_harmonic(kind):
    x, w = np.polynomial.legendre.leggauss(60)
    t = 0.5 * math.pi / OMEGA * (1 + x)
    return abs(w @ (kind.exact.steady(t) * np.exp(-1j * OMEGA * t)))


NUMBERS = {
    "n": {"max": lambda o: extreme(o, 1)[1], "min": lambda o: extreme(o, -1)[1], "argmax": lambda o: extreme(o, 1)[0],
          "argmin": lambda o: extreme(o, -1)[0], "final": limit, "overshoot": overshoot, "zero": first_zero,
          "value": lambda o: float(o(INSTANT))},
    "f": {"amplitude": lambda o: abs(o.exact.A), "phase": lambda o: turned(-cmath.phase(o.exact.A)),
          "rms": lambda o: abs(o.exact.A) / math.sqrt(2),
          "decrement": lambda o: -2 * math.pi * o.exact.rate.real / o.exact.rate.imag,
          "time_to": lambda o: math.log(0.1) / o.exact.rate.real,
          "cycles_to": lambda o: math.log(0.5) / o.exact.rate.real * o.exact.rate.imag / (2 * math.pi),
          "transient": lambda o: float(o.exact.free(INSTANT)), "period": lambda o: 2 * math.pi / o.exact.rate.imag,
          "envelope": lambda o: abs(o.exact.A) * math.exp(o.exact.rate.real * INSTANT)},
    "s": {"amplitude": lambda o: abs(o.X), "phase": lambda o: turned(-cmath.phase(o.X) - math.pi / 2),
          "rms": lambda o: abs(o.X) / math.sqrt(2), "harmonic": lambda o: abs(o.X),
          "steady": lambda o: (o.X * cmath.exp(1j * OMEGA * INSTANT)).real if o.X else float(o.exact.steady(INSTANT)),
          "envelope": lambda o: abs(o.X), "period": lambda o: 2 * math.pi / OMEGA},
    "e": {"envelope": lambda o: abs(o.X * cmath.exp(1j * OMEGA * INSTANT) + o.A * cmath.exp(o.exact.rate * INSTANT))},
    "t": {"transient": lambda o: -float(o.exact.free(INSTANT))},
    "q": {"amplitude": lambda o: np.ptp(o.exact.steady(np.linspace(0, 2 * math.pi / OMEGA, 100_001))) / 2,
          "rms": lambda o: math.sqrt(mean_square(o)), "harmonic": first_harmonic},
    "0": dict.fromkeys((*IN_TIME, "period", "value"), lambda o: 0.0),
}
HEAD, ROWS = QUANTITIES.split(), [line.split() for line in TABLE.strip().splitlines()]
KINDS = kinds()


def asked(quantity, signal):
    if quantity == "value":
        return f"({signal})({INSTANT} s)"
    return f"{quantity}{INDEX.get(quantity, '')}({signal})" + f"({INSTANT} s)" * (quantity in PARTS)


def test_the_table_is_full():
    assert sorted(HEAD) == sorted((*IN_TIME, "period", "value"))
    assert [row[0] for row in ROWS] == list(KINDS) and all(len(row) == len(HEAD) + 1 for row in ROWS)


def hinted(hint):
    """The quantities and signals that a hint tells to ask for."""
    return re.findall(r"\b[a-z]+(?:\[1\])?\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)", hint or "")


@pytest.mark.sweep
@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
def test_each_cell(row):
    kind = KINDS[row[0]]
    for quantity, cell in zip(HEAD, row[1:], strict=True):
        text = asked(quantity, kind.signal)
        if cell not in REFUSED:
            found = measure(kind.problem, parse(text))[0]
            assert found == pytest.approx(NUMBERS[cell][quantity](kind), rel=2e-7, abs=1e-9), text
            continue
        with pytest.raises(PhysicsError, match=REFUSED[cell]) as refusal:
            measure(kind.problem, parse(text))
        for follow in hinted(refusal.value.hint):
            if follow.split("(")[0] in PARTS:
                follow = f"max({follow})"
            assert math.isfinite(measure(kind.problem, parse(follow))[0]), (text, refusal.value.hint)


def test_values_name_their_instants_where_nobody_says_how_long():
    """A buffer at rest at its kink has no small oscillations, and x'' = −k x/m on one side, −c x/m on the other."""
    scene = problem("""
        bodies: {a: {mass: 2 kg, slide: x}}
        springs:
          s: {k: 800 N/m, between: [ground, a]}
          b: {k: 800 N/m, acts: compression, gap: 0, between: [a, ground]}
        initial: {x: 0, x': 1 m/s}
        motion: full
    """)
    w = math.sqrt(800)
    for text, value in (("x(0.09 s)", math.sin(w * 0.09) / w), ("period(x)", math.pi / w + math.pi / 20),
                        ("period(x')", math.pi / w + math.pi / 20), ("period(x + 1 m)", math.pi / w + math.pi / 20)):
        assert measure(scene, parse(text))[0] == pytest.approx(value, rel=1e-9), text
    with pytest.raises(PhysicsError, match="not known how long") as refusal:
        measure(scene, parse("max(x)"))
    assert "until" in refusal.value.hint


@pytest.mark.sweep
def test_a_motion_that_dies_out_has_no_period_and_it_is_said_what_was_tried():
    with pytest.raises(PhysicsError, match="does not repeat itself for 0 ≤ t ≤ 24 s"):
        measure(KINDS["full"].problem, parse("period(x)"))


def test_drifts_that_places_share_cancel_in_their_differences():
    """Masses on springs and dampers to one another towed by a ramp: the stretches tend to (K⁻¹ C 1) v."""
    dice = np.random.default_rng(5)
    for n in (1, 2, 4):
        k, c = dice.uniform(20, 80, n), dice.uniform(1, 5, n)
        names = ["P", *(f"b{i}" for i in range(n))]
        scene = problem("points: {P: {at: [0, 0], moves: [0.3 m/s*t, 0]}}\nbodies:\n" + "".join(
            f"  b{i}: {{mass: {1 + i} kg, at: [{i + 1} m, 0], slide: {{along: [1, 0], by: x{i}}}}}\n" for i in range(n))
            + "springs:\n" + "".join(f"  s{i}: {{k: {k[i]} N/m, between: [{names[i]}, b{i}]}}\n" for i in range(n))
            + "dampers:\n" + "".join(f"  d{i}: {{c: {c[i]} N*s/m, between: [[0, 0], b{i}]}}\n" for i in range(n)))
        for i in range(n):
            lag = 0.3 * c[i:].sum() / k[i]          # all that this spring tows
            found = measure(scene, parse(f"final({names[i]}.x - b{i}.x)"))[0]
            assert found == pytest.approx(lag, rel=1e-11)
            assert measure(scene, parse(f"final(b{i}.x')"))[0] == pytest.approx(0.3, rel=1e-11)
            with pytest.raises(PhysicsError, match="drifts without end"):
                measure(scene, parse(f"final(b{i}.x)"))


@pytest.mark.sweep
@pytest.mark.parametrize("part", ["steady", "transient"])
def test_parts_of_integrated_motions_are_refused_before_they_are_integrated(part, tmp_path, capsys):
    target = tmp_path / "motion.csv"
    for options in (["--plot"], ["--save", str(target)], ["--json", "--save", str(target)]):
        assert run(["response", str(PROBLEM), f"--{part}", *options]) == 4
        out, err = capsys.readouterr()
        assert not out and f"has no {part} part" in err and not target.exists()
        options = [option for option in options if option != "--json"]
        assert run(["response", str(PROBLEM), *options]) == 0       # as the hint tells
        capsys.readouterr()
        target.unlink(missing_ok=True)


def test_vibrations_that_a_dying_load_forces_are_not_free():
    """An over-damped block under F e^{−t} sin 3t swings as the load does, and has no free vibration."""
    scene = problem(SCENE.format(load="2 N*exp(-t/(1 s))*sin(3 rad/s*t)", motion="small", k=25, c=26))
    for quantity in ("amplitude", "phase", "decrement", "time_to[0.1]", "cycles_to[0.5]", "period"):
        with pytest.raises(PhysicsError, match="does not vibrate freely"):
            measure(scene, parse(f"{quantity}(x)"))


def test_the_period_of_a_signal_that_passes_its_middle_more_than_twice_in_it():
    scene = problem("""
        bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
        springs: {s: {k: 4 N/m, between: [ground, a]}, r: {k: 36 N/m, between: [ground, b]}}
        initial: {x: 1 cm, y: 1 cm}
        motion: full
        find: [{response: {until: 7 s}}]
    """)
    assert measure(scene, parse("period(x + y)"))[0] == pytest.approx(math.pi, rel=1e-9)
    assert measure(scene, parse("period(x + 0.3*y)"))[0] == pytest.approx(math.pi, rel=1e-9)
