"""Variants of a problem: keys against scenes read anew and closed forms, each gate, mistakes, printed values."""

from fractions import Fraction
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from support.homework_scenes import BY_STRETCH as BLOCK

from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import SpecError
from vibcli.homework.candidates import sampled
from vibcli.homework.document import SceneDocument
from vibcli.homework.keys import AnswerKey
from vibcli.homework.variants import solve_variants
from vibcli.reader.variants import preferred

PROBLEMS = Path(__file__).parents[3] / "problems"
GRID = """variants:
  parameters:
    m: {from: 1 kg, to: 3 kg, step: 0.5 kg}
    k: [600 N/m, 800 N/m, 1 kN/m]
"""


def solved(text, case=None):
    source = text_source(text)
    problem = problem_of(source)
    return solve_variants(problem if case is None else problem.case(case),
                          SceneDocument.of(source.node, source.file, case))


def number(variant, name):
    return float(variant.values[name].exact)


@pytest.mark.sweep
def test_keys_are_those_of_closed_forms():
    found = solved(BLOCK + GRID + '  ask: {"omega_d[1]": rad/s, "period[1]": ms, "zeta[1]": }\n')
    assert len(found.accepted) == 15 and found.reread == 15 and not found.rejected
    for variant in found.accepted:
        m, k, c = number(variant, "m"), number(variant, "k"), 8.0
        rate = sqrt(k / m - (c / (2 * m))**2)
        for key, value in zip(variant.keys, (rate, 1e3 * 2 * pi / sqrt(k / m), c / (2 * sqrt(k * m))), strict=True):
            assert key.value == pytest.approx(value, rel=1e-14)
            assert key.error <= 1e-12 * value < key.band.width


@pytest.mark.sweep
@pytest.mark.parametrize("name, varied", [
    ("4_free_damped/bell_crank_dashpot", "m1: {from: 4 kg, to: 8 kg, step: 0.5 kg}, k: [1.6 kN/m, 2 kN/m, 2.4 kN/m]"),
    ("6_two_degrees/car_bounce_and_pitch", "m: {from: 900 kg, to: 1200 kg, step: 50 kg}, kf: [16 kN/m, 18 kN/m, "
                                           "20 kN/m]"),
    ("5_forced/compressor_to_be_isolated", "m: {from: 150 kg, to: 200 kg, step: 10 kg}, c: [200 N*s/m, 240 N*s/m, "
                                           "280 N*s/m, 300 N*s/m]"),
])
def test_keys_are_those_of_scenes_read_anew(name, varied):
    path = PROBLEMS / f"{name}.yaml"
    text = path.read_text(encoding="utf-8").partition("\nvariants:")[0]
    text += f"\nvariants: {{parameters: {{{varied}}}, without: [told, readable, routes]}}\n"
    source = text_source(text)
    found = solved(text)
    document = SceneDocument.of(source.node, source.file, None)
    assert len(found.accepted) >= 20 and not found.reread
    for variant in found.accepted[::max(1, len(found.accepted) // 20)]:
        fresh = document.anew(variant.values)
        for key, one in zip(found.keys, variant.keys, strict=True):
            value, error = key.value(fresh)
            assert abs(value - one.value) <= 1e-12 * abs(value) + error + one.error


def test_two_ways_that_differ_are_a_fault(monkeypatch):
    right = AnswerKey.value

    def off(self, problem, expression=None):
        value, error = right(self, problem, expression)
        return value * (1 + 1e-6 * (problem.spec.get("variants") is None or not problem.modal._known[0])), error

    monkeypatch.setattr(AnswerKey, "value", off)
    with pytest.raises(RuntimeError, match="two ways to omega_d"):
        solved(BLOCK + GRID)


def reasons(found):
    return {one.gate: one.reason for one in found.rejected}


def test_what_is_required():
    found = solved(BLOCK + GRID + '  require: ["18 rad/s < omega[1] <= 25 rad/s"]\n')
    kept = {(number(one, "m"), number(one, "k")) for one in found.accepted}
    assert kept == {(m, k) for m in (1, 1.5, 2, 2.5, 3) for k in (600, 800, 1000) if 18 < sqrt(k / m) <= 25}
    assert found.counts["require"] == 15 - len(kept) and set(reasons(found)) == {"require"}


def test_the_file_itself_is_to_fulfil_what_is_required():
    with pytest.raises(SpecError) as error:
        solved(BLOCK + GRID + '  require: ["omega[1] < 5 rad/s"]\n')
    assert error.value.diagnostics[0].where.line == 12


def test_another_regime():
    text = BLOCK.replace('"omega_d[1]": 19.90', '"omega[1]": 20.00') + (
        "variants: {parameters: {c: [8 N*s/m, 40 N*s/m, 100 N*s/m]}}\n")
    found = solved(text)
    assert [number(one, "c") for one in found.accepted] == [8, 40]
    assert "2 × decay" in reasons(found)["regime"]
    assert len(solved(text.replace("]}}", "]}, without: [regime]}")).accepted) == 3


@pytest.mark.sweep
def test_what_is_told_nowhere():
    text = BLOCK.replace("question: A block {m} on a spring {k} and a damper {c}.", "question: A block.")
    assert len(solved(text + GRID).accepted) == 15          # k, c and m are lettered in the figure
    hidden = BLOCK.replace("c: 8", "r: 1.5, K: r*k, c: 8").replace("{k: k, stretch", "{k: K, stretch")
    found = solved(hidden + GRID)
    assert not found.accepted and found.counts["told"] == 15 and "figure tells r" in found.advice
    assert len(solved(hidden.replace("a damper {c}", "a damper {c}, {r} times") + GRID).accepted) == 15
    assert len(solved(hidden + GRID + "  without: [told]\n").accepted) == 15


@pytest.mark.sweep
def test_keys_that_cannot_be_read():
    small = solved(BLOCK + GRID + '  ask: {"K[x,x]": GN/m}\n')
    assert "write it in another unit" in reasons(small)["readable"]
    found = solved(BLOCK + GRID + '  ask: {"omega_d[1]": rad/s, "omega[1]": rad/s}\n')
    assert 1 <= found.counts["readable"] <= 6       # where ζ²/2 is within the band
    assert reasons(found)["readable"] == "omega[1] is omega_d[1]"
    given = solved(BLOCK + GRID + '  ask: {"K[x,x]": N/m}\n')
    assert reasons(given)["readable"] == "K[x,x] is the given k"
    for unit in ("kN/m", "N/mm"):
        assert reasons(solved(BLOCK + GRID + f'  ask: {{"K[x,x]": {unit}}}\n'))["readable"] == "K[x,x] is the given k"
    share = BLOCK.partition("dampers")[0].replace("c: 8 N*s/m", "z: 5 %").replace("a damper {c}", "with {z}") + (
        'damping: {modal: z}\nanswers: {"omega[1]": 20.00 rad/s}\n' + GRID + '  ask: {"zeta[1]": , "omega[1]": }\n')
    assert reasons(solved(share))["readable"] == "zeta[1] is the given z"


@pytest.mark.sweep
def test_a_mistake_asks_for_more_figures_or_rejects():
    mistake = '  mistakes: {natural: {answers: {"omega_d[1]": "omega[1]"}}}\n'
    found = solved(BLOCK + GRID + mistake)
    assert {one.keys[0].band.figures for one in found.accepted} == {3, 4}
    for one in found.accepted:
        wrong, key = one.keys[0].wrong[0].value, one.keys[0]
        assert wrong == pytest.approx(sqrt(number(one, "k") / number(one, "m")), rel=1e-14)
        assert abs(wrong - key.value) > 2 * key.band.width * (1 - 1e-6)
    close = solved(BLOCK.replace("c: 8 N*s/m", "c: 0.08 N*s/m").replace("19.90", "20.00") + GRID + mistake)
    assert close.counts["apart"] == 15 and "'natural' gives" in reasons(close)["apart"]
    fixed = solved(BLOCK + GRID + mistake + '  ask: {"omega_d[1]": {rtol: 1 %}}\n')
    assert fixed.counts["apart"] == 15


@pytest.mark.sweep
def test_a_mistake_of_the_model_is_solved_anew_and_one_that_drops_out_is_told():
    found = solved(BLOCK + GRID + "  mistakes:\n    two springs: {springs: {t: {k: k, stretch: x}}}\n"
                   "    no weight: {gravity: 9.81 m/s^2}\n")
    assert found.same == [("no weight", "omega_d[1]")]
    for one in found.accepted:
        m, k = number(one, "m"), number(one, "k")
        given = {wrong.mistake: wrong.value for wrong in one.keys[0].wrong}
        assert given["two springs"] == pytest.approx(sqrt(2 * k / m - (4 / m)**2), rel=1e-13)
        assert given["cycles for radians"] == pytest.approx(sqrt(k / m - (4 / m)**2) / (2 * pi), rel=1e-13)
        assert "no weight" not in given


@pytest.mark.sweep
def test_a_key_that_is_zero_has_mistakes_that_are_not():
    """The first mode has no damper; held fast, its block leaves the damped one."""
    found = solved("""title: Two blocks
question: A block {m} on a spring {k} stands beside one of 1 kg on a spring 900 N/m and a damper 6 N*s/m.
parameters: {m: 1 kg, k: 100 N/m}
bodies: {a: {mass: m, slide: x}, b: {mass: 1 kg, slide: y}}
springs: {r: {k: k, stretch: x}, s: {k: 900 N/m, stretch: y}}
dampers: {d: {c: 6 N*s/m, stretch: y}}
variants: {parameters: {m: [1 kg, 2 kg], k: [100 N/m, 150 N/m]}, ask: {"zeta[1]": }, without: [readable, told]}
""")
    assert len(found.accepted) == 4 and all(one.keys[0].value == 0.0 for one in found.accepted)
    assert all([(one.mistake, round(one.value, 9)) for one in each.keys[0].wrong] == [("coordinate held (x)", 0.1)]
               for each in found.accepted)


@pytest.mark.sweep
def test_a_mistake_keeps_the_value_that_it_gives_to_what_is_varied():
    found = solved(BLOCK + GRID + "  mistakes: {always 800: {parameters: {k: 0.8 kN/m}}}\n")
    for one in found.accepted:
        given = {wrong.mistake: wrong.value for wrong in one.keys[0].wrong}
        assert given["always 800"] == pytest.approx(sqrt(800 / number(one, "m") - (4 / number(one, "m"))**2), rel=1e-13)
    assert found.counts["apart"] == 5 and len(found.accepted) == 10      # where it is 800
    with pytest.raises(SpecError, match="'k' is varied, and the mistake 'as m' gives it no number"):
        solved(BLOCK + GRID + "  mistakes: {as m: {parameters: {k: m*100 s^-2}}}\n")


@pytest.mark.sweep
def test_a_mistake_that_gives_nothing_in_any_variant_is_told_with_its_reason():
    found = solved(BLOCK + GRID + "  mistakes:\n    pushed: {springs: {s: {k: -k, stretch: x}}}\n"
                   "    stiffer: {springs: {s: {k: 2*k, stretch: x}}}\n")
    assert found.unsolved == [("pushed", "damped mode 1 has no damped frequency"),
                              ("damper forgotten (d)", "nothing damps this scene: it has no damped modes")]
    assert "pushed" not in {wrong.mistake for one in found.accepted for key in one.keys for wrong in key.wrong}


def test_each_gate_that_took_some_is_named_where_none_is_left():
    found = solved(BLOCK + GRID + '  require: ["m < 2.9 kg"]\n'
                   "  mistakes: {near: {springs: {s: {k: 1.00001*k, stretch: x}}}}\n")
    assert found.advice.startswith("'apart' took 12 of 15, 'require' 3; for example: ")


def test_a_mistake_that_is_no_scene_is_refused():
    with pytest.raises(SpecError) as error:
        solved(BLOCK + GRID + "  mistakes: {twice: {springs: {s: {k: k2}}}}\n")
    assert "in the mistake 'twice'" in error.value.diagnostics[0].message
    with pytest.raises(SpecError, match="is not asked"):
        solved(BLOCK + GRID + '  mistakes: {twice: {answers: {"zeta[1]": "2*zeta[1]"}}}\n')


@pytest.mark.sweep
def test_chosen_parameters_are_printed_and_the_scene_solved_with_them():
    text = BLOCK.replace(", c: 8 N*s/m", "").replace("answers", "choose: {c: \"zeta[1] = 0.1\"}\nanswers")
    for how, allowed in (("3", None), ("R20", {str(x) for x in preferred("R20", 1, 1000)})):
        found = solved(text + GRID + f"  printed: {{c: {how}}}\n")
        assert len(found.accepted) == 15
        for one in found.accepted:
            m, k, c = (number(one, name) for name in "mkc")
            wanted = 0.2 * sqrt(k * m)
            assert c == float(f"{wanted:.3g}") if allowed is None else str(one.values["c"].exact) in allowed
            assert one.keys[0].value == pytest.approx(sqrt(k / m - (c / (2 * m))**2), rel=1e-13)


@pytest.mark.sweep
def test_a_chosen_parameter_that_is_asked_is_not_rounded():
    text = BLOCK.replace(", c: 8 N*s/m", "").replace("answers", "choose: {c: \"zeta[1] = 0.1\"}\nanswers")
    found = solved(text.replace('{"omega_d[1]": 19.90 rad/s}', "{c: 8 N*s/m}").replace(" and a damper {c}", "") + GRID)
    assert [one.keys[0].value for one in found.accepted] == pytest.approx(
        [0.2 * sqrt(number(one, "k") * number(one, "m")) for one in found.accepted], rel=1e-12)


@pytest.mark.sweep
def test_a_scene_in_letters_becomes_one_with_numbers():
    text = BLOCK.replace("k: 800 N/m", "k: ").replace('"omega_d[1]": 19.90 rad/s', '"omega[1]": sqrt(k/m)')
    found = solved(text + GRID)
    assert [one.keys[0].value for one in found.accepted] == pytest.approx(
        [sqrt(number(one, "k") / number(one, "m")) for one in found.accepted], rel=1e-14)


def test_rows_go_together():
    found = solved(BLOCK + "variants: {rows: [{m: 1 kg, k: 900 N/m}, {m: 2 kg, k: 500 N/m}], "
                           "parameters: {c: [4 N*s/m, 5 N*s/m]}}\n")
    assert {tuple(number(one, name) for name in "mkc") for one in found.accepted} == {
        (1, 900, 4), (1, 900, 5), (2, 500, 4), (2, 500, 5)}


def test_a_case_has_variants_of_its_own():
    text = BLOCK + GRID + 'cases:\n  soft: {parameters: {k: 200 N/m}, answers: {"omega[1]": 10.0 rad/s}, variants: ' \
                          "{parameters: {m: [1 kg, 2 kg]}}}\n  bare: {parameters: {k: 300 N/m}}\n"
    found = solved(text, "soft")
    assert [one.keys[0].value for one in found.accepted] == pytest.approx([sqrt(200), 10.0], rel=1e-14)
    assert problem_of(text_source(text)).case("bare").spec.get("variants") is None


@pytest.mark.sweep
def test_a_sample_is_the_same_everywhere():
    rules = problem_of(text_source(BLOCK + GRID + "  sample: 5\n")).spec.get("variants")
    assert sampled(rules) == SAMPLE
    found = solved(BLOCK + GRID + "  sample: 5\n")
    assert [one.place for one in found.accepted] == SAMPLE
    whole = {one.place: one.keys for one in solved(BLOCK + GRID).accepted}
    assert all(one.keys[0].value == whole[one.place][0].value for one in found.accepted)
    assert sampled(problem_of(text_source(BLOCK + GRID + "  sample: 15\n")).spec.get("variants")) is None


SAMPLE = [(1, 1), (3, 0), (3, 2), (4, 1), (4, 2)]


def test_preferred_numbers():
    assert [float(x) for x in preferred("R10", 20, 100)] == [20, 25, 31.5, 40, 50, 63, 80, 100]
    for series, count in (("R5", 5), ("R10", 10), ("R20", 20), ("R40", 40)):
        found = [float(x) for x in preferred(series, 1, 9.9)]
        assert len(found) == count
        assert all(abs(x / 10**(k / count) - 1) < 0.0127 for k, x in enumerate(found))       # ISO 3


@pytest.mark.sweep
def test_bands_hold_what_students_round():
    """On the crank of the problems, by formulas written out here: J, ω and δ rounded on the way to ω_d and ζ."""
    path = PROBLEMS / "4_free_damped" / "bell_crank_dashpot.yaml"
    found = solved(path.read_text(encoding="utf-8").partition("variants:")[0] + (
        "variants:\n  parameters: {m1: {from: 4 kg, to: 8 kg, step: 0.5 kg}, k: [1.6 kN/m, 2 kN/m, 2.5 kN/m], "
        "c: {from: 20 N*s/m, to: 100 N*s/m, series: R10}}\n"
        '  ask: {"omega_d[1]": rad/s, "zeta[1]": }\n  without: [readable, apart]\n'))
    random, off = np.random.default_rng(3), ([], [])
    for one in found.accepted:
        m1, k, c = (number(one, name) for name in ("m1", "k", "c"))
        for i, key in enumerate(one.keys):
            def told(x, count=key.band.figures):
                return float(f"{x:.{count}g}") if random.random() < 0.8 else x

            for _ in range(10):
                inertia = told((m1 * 0.25 + 4 * 0.09) / 3)
                omega, delta = told(sqrt((k * 0.25 - 4 * 9.81 * 0.15) / inertia)), told(c * 0.09 / (2 * inertia))
                answer = (sqrt(omega**2 - delta**2), delta / omega)[i]
                off[i].append(abs(float(f"{answer:.{key.band.figures}g}") - key.value) / key.band.width)
    for shares in off:
        assert len(shares) >= 1500
        assert 0.75 <= np.percentile(shares, 99) <= 1.0
        assert np.mean(np.array(shares) <= 1) >= 0.98


CAR = """parameters: {m: 1000 kg, kf: 18 kN/m, kr: 20 kN/m}
bodies: {front: {mass: m, slide: x}, rear: {mass: 300 kg, slide: y}}
springs: {f: {k: kf, stretch: x}, r: {k: kr, stretch: y - x}}
answers: {"omega[1]": 4.099 rad/s}
variants:
  parameters: {m: {from: 500 kg, to: 1500 kg, step: 10 kg}, kf: [16 kN/m, 18 kN/m, 20 kN/m]}
  ask: {"omega[1]": rad/s, "omega[2]": Hz, "mode[1][y]": }
  without: [told, apart]
"""


@pytest.mark.sweep
def test_closed_forms_are_held_against_all_variants():
    found = solved(CAR.replace("Hz", "rad/s"))
    assert found.closed == {"omega[1]": 303, "omega[2]": 303, "mode[1][y]": 303}
    for one in found.accepted[::30]:
        m, kf = number(one, "m"), number(one, "kf")
        squares = np.linalg.eigvals([[(kf + 20e3) / m, -20e3 / m], [-20e3 / 300, 20e3 / 300]])
        assert [key.value for key in one.keys[:2]] == pytest.approx(np.sqrt(np.sort(squares)), rel=1e-12)


def test_a_closed_form_that_differs_is_a_fault(monkeypatch):
    from vibcli.homework import routes

    right = routes._closed
    monkeypatch.setattr(routes, "_closed", lambda problem, key: right(problem, key) * (1 + Fraction(1, 10**8)))
    with pytest.raises(RuntimeError, match=r"two ways to omega_d\[1\] differ, .* and in closed form"):
        solved(BLOCK + GRID)


@pytest.mark.sweep
def test_where_the_form_of_another_variant_does_not_agree_its_own_is_found_to_more_digits(monkeypatch):
    from vibcli.homework import routes

    derived, right, closed = [], routes._at, routes._closed
    monkeypatch.setattr(routes, "_at", lambda *given: right(*given) * (1 + 1e-6))
    monkeypatch.setattr(routes, "_closed", lambda problem, key: derived.append(key.text) or closed(problem, key))
    assert solved(BLOCK + GRID).closed == {"omega_d[1]": 15} and len(derived) == 16
