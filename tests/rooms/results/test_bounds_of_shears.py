"""Moments, shears and rates of stepped cantilevers after sudden and slow loads: against sums over modes found by hand,
beside statics; and refusals of what has no bound."""

import json
import re

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401
from support.scenes import problem

import vibcli
from vibcli.base.errors import NoBound
from vibcli.cli.program import run
from vibcli.language.signals_of_places import with_places
from vibcli.results import enough_modes, modal_response
from vibcli.symbolic.parser import parse

COUNT, RISE = 500, 0.02
UNIFORM = ("parameters: {L: 1 m}\n"
           "beams: {arm: {length: L, EI: 1 N*m^2, mass_per_length: 1 kg/m, left: clamped}}\n"
           "points: {tip: {body: arm, at: L}}\n")
STEP = "forces: {push: {at: tip, force: 1 N*step(t)}}\n"
FORMS = {"step": "step(t)", "ramp": f"(ramp(t) - ramp(t - {RISE} s))/({RISE} s)"}
pytestmark = pytest.mark.usefixtures("modes_found_once")


def signal(scene, text):
    return scene.response.signal(with_places(parse(text), scene.spec.members))


class SteppedCantilever:
    """Of two lengths, stiffnesses EI and masses per length mu: its modes are a cos βx + b sin βx + c e^{−βx} +
    d e^{−β(l−x)} on each part."""

    def __init__(self, lengths, EI, mu):
        self.l, self.EI = lengths, EI
        self.share = [(mu[k] / EI[k]) ** 0.25 for k in range(2)]        # β = share √ω
        step = np.pi / (self.share[0] * lengths[0] + self.share[1] * lengths[1]) / 12
        roots = step * np.arange(1, 14 * COUNT)
        sign = self._sign(roots)
        at = np.flatnonzero(sign[1:] != sign[:-1])[:COUNT]
        low, high, first = roots[at], roots[at + 1], sign[at]
        for _ in range(60):
            middle = (low + high) / 2
            same = self._sign(middle) == first
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        self.root, self.omega = (low + high) / 2, ((low + high) / 2) ** 2
        self.parts = np.linalg.svd(self._matrix(self.root))[2][:, -1].reshape(-1, 2, 4)
        square = sum(mu[k] * self._square(k) for k in range(2))
        self.parts /= np.sqrt(square)[:, None, None]

    def _sign(self, root):
        return np.linalg.slogdet(self._matrix(root))[0]

    def _basis(self, k, root, x, order):
        """The order-th derivatives over βᵏ of the four functions of a part."""
        b = self.share[k] * root
        turn, far = b * x + order * np.pi / 2, (-1.0) ** order
        return np.array([np.cos(turn), np.sin(turn), far * np.exp(-b * x), np.exp(-b * (self.l[k] - x))]).T

    def _matrix(self, root):
        found = np.zeros((len(root), 8, 8))
        for order in range(2):
            found[:, order, :4] = self._basis(0, root, 0.0, order)
            found[:, 6 + order, 4:] = self._basis(1, root, self.l[1], 2 + order)
        for order in range(4):
            for k, x in enumerate((self.l[0], 0.0)):
                size = (-1) ** k * self.share[k] ** order * (self.EI[k] if order > 1 else 1.0)
                found[:, 2 + order, 4 * k:4 * k + 4] = size * self._basis(k, root, x, order)
        return found

    def _square(self, k):
        """∫ φ² of a part: 4 ∫ φ² = [x φ² + x φ″² − 2x φ′φ‴ + 3 φφ‴ − φ′φ″] with derivatives over βᵏ, and 1/β."""
        b, found = self.share[k] * self.root, 0.0
        for sign, x in ((1, self.l[k]), (-1, 0.0)):
            u, slope, bent, third = (self._on(k, x, order) for order in range(4))
            found = found + sign * (x * (u**2 + bent**2 - 2 * slope * third) + (3 * u * third - slope * bent) / b)
        return found / 4

    def _on(self, k, x, order):
        return (self._basis(k, self.root, x, order) * self.parts[:, k]).sum(axis=1)

    def read(self, x, order):
        """φ, or EI times its second or third derivative, at a place of the whole."""
        k = int(x > self.l[0])
        size = (self.share[k] * self.root) ** order * (self.EI[k] if order > 1 else 1.0)
        return size * self._on(k, x - k * self.l[0], order)

    def felt(self, a):
        """What each mode feels of a unit force at a place, or of a unit load all along (None): ∫ φ = [φ‴]/β."""
        if a is not None:
            return self.read(a, 0)
        return sum((self._on(k, self.l[k], 3) - self._on(k, 0.0, 3)) / (self.share[k] * self.root) for k in range(2))

    def moved(self, x, order, rate, a, form, t):
        """(u, moment or shear, or its rate, at an instant; what the later half of the terms adds at the most)."""
        c, turn = self.read(x, order) * self.felt(a) / self.omega**2, self.omega * t
        if form == "step":
            free = self.omega * np.sin(turn) if rate else -np.cos(turn)
        else:
            ends = turn, turn - self.omega * RISE
            free = ((np.cos(ends[1]) - np.cos(ends[0])) if rate else (np.sin(ends[1]) - np.sin(ends[0])) / self.omega)
            free = free / RISE
        return self._still(x, order, a) * (not rate) + c @ free, np.abs(c * free)[COUNT // 2:].sum()

    def _still(self, x, order, a):
        """Moment and shear at rest: dM/dx = V."""
        if a is not None:
            return (a - x if order == 2 else -1.0) * (x < a)
        left = sum(self.l) - x
        return left**2 / 2 if order == 2 else -left


def compared(seed, monkeypatch):
    """Bounds of 64 modes against the sums; how many were refused."""
    for name in ("FIRST", "MOST"):
        monkeypatch.setattr(modal_response, name, {True: 64, False: 64} if name == "MOST" else 64)
    monkeypatch.setattr(enough_modes, "FEWER", 10**9)
    draw = np.random.default_rng(seed)
    lengths, EI, mu = (draw.uniform(*ends, 2).round(2) for ends in ((0.3, 1.0), (0.5, 6.0), (0.4, 4.0)))
    beam, whole, refused = SteppedCantilever(lengths, EI, mu), float(sum(lengths)), 0
    x, a = (float(part) for part in np.round(draw.uniform(0.05, 0.95, 2) * whole, 3))
    segments = ", ".join(f"{{length: {lengths[k]} m, EI: {EI[k]} N*m^2, mass_per_length: {mu[k]} kg/m}}"
                         for k in range(2))
    for form, written in FORMS.items():
        for at in (a, None):
            where = "at: p, force: 1 N" if at else "body: arm, per_length: 1 N/m"
            scene = problem(f"beams: {{arm: {{segments: [{segments}], left: clamped}}}}\n"
                            f"points: {{p: {{body: arm, at: {a} m}}}}\nforces: {{push: {{{where}*{written}}}}}\n")
            for name, order, rate in ((f"moment({x} m)", 2, 0), (f"shear({x} m)", 3, 0), (f"u'({x} m)", 0, 1)):
                found = signal(scene, f"arm.{name}")
                for t in draw.uniform(0.03, 3.0, 2):
                    try:
                        off = found.values(np.array([t]))[0]
                    except NoBound:
                        assert (order, form, at) == (3, "step", a)
                        refused += 1
                        continue
                    expected, left = beam.moved(x, order, rate, at, form, t)
                    assert abs(off - expected) <= found.error(t) + 2 * left
                    assert 2 * left <= found.error(t)
    return refused


@pytest.mark.sweep
def test_moments_shears_and_rates_of_a_stepped_beam_are_within_their_bounds(monkeypatch):
    assert compared(1, monkeypatch) == 2


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(2, 14))
def test_bounds_of_random_stepped_beams_hold(seed, monkeypatch):
    compared(seed, monkeypatch)


def test_a_shear_that_is_refused_grows_without_end(monkeypatch):
    """That in the middle of a cantilever at t = L²/(2π) √(μ/EI) after a step of 1 N at its tip: with κ = (n − ½)π

        Σ 2 (−1)ⁿ⁺¹ (sin κ/2 + cos κ/2) cos(κ² t)/κ = Σ 2 √2 cos(π/8)/κ over odd n,

    as n² − n is even: ln 2 √2 cos(π/8)/π more for each doubling of the modes."""
    monkeypatch.setattr(modal_response, "MOST", {True: 512, False: 512})
    scene, t = problem(UNIFORM + STEP), np.array([0.5 / np.pi])
    found = signal(scene, "arm.shear(L/2)")
    with pytest.raises(NoBound, match="no finite sum"):
        found.values(t)
    by_modes = [scene.response.motion(count).values(found.reads, t)[0] for count in (128, 256, 512)]
    assert np.diff(by_modes) == pytest.approx(np.full(2, np.log(2) * np.sqrt(2) * np.cos(np.pi / 8) / np.pi), rel=5e-3)


@pytest.mark.parametrize(("rest", "reason", "hint"), [
    (STEP, "no finite sum", "rise within a time"),
    (STEP + "damping: {modal: 1 %}\n", "no finite sum", "later on"),
    ("initial: {arm.u: 1 mm*(x/L)^2}\n", "no finite sum", "a shape whose moments"),
    (STEP + "initial: {arm.u: 1 mm*(x/L)^2}\n", "no finite sum", "ends and joints, and loads rise within a time"),
    (STEP.replace("step(t)", "sin(3e5 rad/s*t)"), "a load changes as fast", "more slowly")])
def test_refusals_say_why_there_is_no_bound(rest, reason, hint, monkeypatch):
    """Of a load that is too fast for the modes that are counted the reason was that of a jump."""
    monkeypatch.setattr(modal_response, "MOST", {True: 128, False: 128})
    found = signal(problem(UNIFORM + rest), "arm.shear(0 m)")
    with pytest.raises(NoBound, match=reason) as refusal:
        found.extreme(0.0, 1.0, 1) if "damping" not in rest else found.values(np.zeros(1))
    assert hint in refusal.value.hint


def test_what_moves_a_support_has_to_begin_smoothly(monkeypatch):
    """A ramp, which was the advice, is not enough."""
    monkeypatch.setattr(modal_response, "MOST", {True: 128, False: 128})
    text = ("parameters: {L: 1 m}\nbodies: {hand: {slide: 1 mm*RISE}}\n" + UNIFORM.split("\n")[1].replace(
        "left: clamped", "left: {clamped: hand}"))
    t = np.array([0.33])
    with pytest.raises(NoBound, match="no finite sum") as refusal:
        signal(problem(text.replace("RISE", "(ramp(t) - ramp(t - 0.1 s))/(0.1 s)")), "arm.moment(0 m)").values(t)
    assert "as smoothly as t^4" in refusal.value.hint
    found = signal(problem(text.replace("RISE", "(t/(0.1 s))^4*exp(-t/(0.1 s))")), "arm.moment(0 m)")
    assert found.error(0.33) <= 1e-6 * abs(found.values(t)[0])


@pytest.mark.sweep
@pytest.mark.parametrize("asked", ["rms(arm.shear(0 m))", "max(steady(arm.shear(0 m)))"])
def test_what_repeats_itself_with_jumps_has_no_later_on(asked, monkeypatch):
    monkeypatch.setattr(modal_response, "MOST", {True: 128, False: 128})
    scene = vibcli.loads(UNIFORM + STEP.replace("step(t)", "square(4 rad/s*t)") + "damping: {modal: 5 %}\n")
    with pytest.raises(NoBound, match="no finite sum") as refusal:
        _ = scene[asked].value
    assert "later on" not in refusal.value.hint
    assert "ask for harmonic[1]" in refusal.value.hint
    assert scene["harmonic[1](arm.shear(0 m))"].value > 0


def test_bounds_below_a_fast_load_are_found(monkeypatch):
    """Its hundredth derivative is too large for a float."""
    monkeypatch.setattr(modal_response, "MOST", {True: 128, False: 128})
    scene, t = problem(UNIFORM + STEP.replace("step(t)", "cos(6100 rad/s*t)")), np.array([0.3])
    few = signal(scene, "arm.u(L)")
    many = scene.response.motion(1024).values(few.reads, t)[0]
    assert abs(few.values(t)[0] - many) <= few.error(0.3) <= 1e-4


def test_a_mean_square_of_what_has_no_bound_is_refused():
    with pytest.raises(NoBound, match="no finite sum"):
        _ = vibcli.loads(UNIFORM + STEP)["rms(arm.shear(0 m))"].value


@pytest.mark.sweep
def test_texts_and_data_tell_bounds_and_why_there_is_none(tmp_path, monkeypatch, capsys):
    """Of the first 128 modes: max(arm.moment(0 m)) is 2.4485(6), which check told to nine digits."""
    monkeypatch.setattr(modal_response, "MOST", {True: 128, False: 128})
    monkeypatch.setattr(modal_response, "FINEST", {True: 128, False: 128})
    path = tmp_path / "arm.yaml"
    path.write_text(UNIFORM + STEP + "answers: {max(arm.moment(0 m)): 1 N*m}\n", encoding="utf-8")
    asked = ["response", str(path), "--of", "arm.moment(0 m)", "--of", "arm.shear(0 m)", "--until", "2", "--at", "1"]
    run(asked)
    told = " ".join(capsys.readouterr().out.split())
    assert "arm.shear(0 m) [N] no bound no bound" in told
    assert "no bound: what the modes left out" in told and "let loads rise within a time" in told
    run([*asked, "--json"])
    moment, shear = json.loads(capsys.readouterr().out)["response"]["signals"]
    assert 1e-3 < moment["max_error"] < 1e-2 and 1e-3 < moment["at"][0]["error"] < 1e-2 and moment["no_bound"] is None
    assert [shear["max"], shear["max_error"], shear["at"][0]["error"]] == [None] * 3
    assert "no finite sum" in shear["no_bound"]
    run(["check", str(path)])
    assert re.search(r"expected 1, found \d\.\d\d\d ± 0\.00\d ", capsys.readouterr().out)
