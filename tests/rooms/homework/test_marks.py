"""Answers as students write them, their marks, and what no sheet may tell."""

import random
from math import pi

import pytest

from vibcli.homework.given_answers import read_answer, without_name
from vibcli.homework.leaks import leak, text_of_page
from vibcli.homework.marks import Marker
from vibcli.homework.reasons import of_number


@pytest.mark.parametrize("text, unit, value", [
    ("21.9", "rad/s", 21.9), ("21.9 rad/s", "rad/s", 21.9), ("21,9 rad/s", "rad/s", 21.9),
    (" 21.9rad/s ", "rad/s", 21.9),
    ("21.9 1/s", "rad/s", 21.9), ("3.49 Hz", "rad/s", 3.49), ("209 rpm", "rad/s", 209 * pi / 30),
    ("2.19e1", "rad/s", 21.9),
    ("2,19·10^1", "rad/s", 21.9), ("2.19·10¹ rad/s", "rad/s", 21.9), ("219 × 10⁻¹ 1/s", "rad/s", 21.9),
    ("2.19·10^1·2", "rad/s", None), ("2.19×10^1 rad/s", "rad/s", 21.9), ("2.19*10^1", "rad/s", 21.9), ("-3", "mm", -3),
    ("−3,5 cm", "mm", -35), ("0.012 m", "mm", 12), ("0,125", "", 0.125), (".5", "", 0.5), ("12 %", "", 0.12),
    ("1,234", "", None), ("1,2345", "", 1.2345), ("1 234", "", 1234), ("9.81 m/s²", "m/s^2", 9.81),
    ("30°", "deg", 30), ("0.5236 rad", "deg", 30.0), ("40 N·s/m", "N*s/m", 40), ("", "mm", None), ("abc", "mm", None),
    ("12 kg", "mm", None), ("12 furlong", "mm", None), ("1e999", "", None), ("(", "", None), ("12; rm -rf", "", None),
    ("=1+1", "", None), ("nan", "", None), ("12 m", "", None)])
def test_answers_as_they_are_written(text, unit, value):
    found = read_answer(text, unit)
    if value is None:
        assert found.value is None and found.reason
    else:
        assert found.value == pytest.approx(value, rel=1e-4)


@pytest.mark.parametrize("text", ["1.234,5", "12,345,678", "1'234", "1,234.5 rad/s"])
def test_thousands(text):
    assert read_answer(text, "rad/s") == (None, "write the number without signs between its thousands", "", 0.0)


@pytest.mark.parametrize("text, quantity, behind", [
    ("ζ=0.199", "zeta[1]", "0.199"), ("zeta_1 = 0.2", "zeta[1]", " 0.2"), ("ζ₁ ≈ 0.2", "zeta[1]", " 0.2"),
    ("omega = 3.2 rad/s", "omega[1]", " 3.2 rad/s"), ("ω_d,1 = 3 Hz", "omega_d[1]", " 3 Hz"),
    ("ω2 = 3", "omega[1]", "ω2 = 3"), ("f = 3 Hz", "omega[1]", "f = 3 Hz"), ("x' = 2", "x(2 s)", "x' = 2"),
    ("amplitude(x) = 2 mm", "amplitude(x)", " 2 mm"), ("ω = 2", "omega[1]/omega[2]", "ω = 2"),
    ("m·x'' + k·x = 0", "equation[x]", "m·x'' + k·x = 0"), ("3 rad/s", "omega[1]", "3 rad/s")])
def test_the_name_of_what_is_asked_may_stand_before_its_value(text, quantity, behind):
    assert without_name(text, quantity) == behind


MANIFEST = {
    "problems": [{"name": "crank", "mistakes": {"Hz": "this is in Hz", "weight": "the weight"}, "variants": [
        {"variant": 7, "keys": [
            {"quantity": "omega_d[1]", "unit": "rad/s", "points": 2.0, "value": 21.909, "band": 0.11, "mistakes": [
                {"name": "Hz", "value": 21.909 / (2 * pi)}, {"name": "weight", "value": 22.6}]},
            {"quantity": "zeta[1]", "unit": "", "points": 1.0, "value": 0.1254, "band": 0.0001, "figures": 4,
             "mistakes": [{"name": "weight", "value": 0.1282}]}]}]},
        {"name": "drum", "mistakes": {}, "variants": [
            {"variant": 1, "keys": [{"quantity": "omega[1]", "unit": "rad/s", "points": 1.0, "value": 5.0, "band": 0.02,
                                     "mistakes": []}]}]}],
    "students": [{"id": "s1", "name": "", "sheets": [{"problem": "crank", "variant": 7}]},
                 {"id": "s2", "name": "", "sheets": [{"problem": "crank", "variant": 7}, {"problem": "drum",
                                                                                          "variant": 1}]}]}


def marks(**answers):
    found = Marker(MANIFEST).marks("s1", "crank", {"omega_d[1]": answers.get("omega", ""), "zeta[1]":
                                                   answers.get("zeta", "")})
    return [(one.verdict, one.points, one.mistake, one.said) for one in found]


def test_an_answer_with_its_name_is_marked_as_one_without():
    assert marks(omega="ω_d = 21.9 rad/s", zeta="ζ=0.1254") == marks(omega="21.9 rad/s", zeta="0.1254")
    assert marks(zeta="omega = 0.1254")[1][0] == "unreadable"
    first, second = Marker(MANIFEST).marks("s1", "crank", {"zeta[1]": "ζ = 0.1254"})
    assert (first.answer, second.answer) == ("", "ζ = 0.1254")


def test_marks():
    assert marks(omega="21.9 rad/s", zeta="0.1254") == [("right", 2, "", ""), ("right", 1, "", "")]
    assert marks(omega="3.49 Hz") == [("wrong", 0, "Hz", "this is in Hz"), ("missing", 0, "", "")]
    assert marks(omega="22,6", zeta="12.5 kg") == [("wrong", 0, "weight", "the weight"), (
        "unreadable", 0, "", "'kg' measures something else than a pure number")]
    assert marks(omega="-21.9")[0] == ("wrong", 0, "", "the number is right but for its sign")


def test_cycles_are_no_radians():
    """Their number is not right where the unit is not."""
    assert marks(omega="21.9 Hz")[0] == ("wrong", 0, "", "the number is right in rad/s, but Hz is written")
    assert marks(omega="21.9 1/s")[0][0] == marks(omega="21.9")[0][0] == marks(omega="209.2 rpm")[0][0] == "right"


def test_answers_of_fewer_figures_than_are_asked():
    """They are told so where they are right, and their mistake where they are not, as far as their last figure goes."""
    assert marks(zeta="12.5 %")[1] == ("wrong", 0, "", "right as far as it goes, but 4 figures are asked")
    assert marks(zeta="0.128")[1] == ("wrong", 0, "weight", "the weight")
    for text in ("0.1280", "0.1"):
        assert marks(zeta=text)[1][:3] == ("wrong", 0, "") and "ten times as far" in marks(zeta=text)[1][3]


BUT, UNKNOWN = "the number is right but for ", "no known mistake leads to this: it "
WHY = [
    ("2.191", BUT + "a factor of 1/10"), ("-2.19e4", BUT + "its sign and a factor of 1000"),
    ("43.8", BUT + "a factor of 2"), ("137.6", BUT + "a factor of 2π"), ("0.382", BUT + "a factor of 1/(180/π)"),
    ("21.9 rpm", "the number is right in rad/s, but rpm is written"),
    ("22.1", UNKNOWN + "lies further from the key than its band reaches, but not twice as far"),
    ("23", UNKNOWN + "lies further from the key than its band reaches, but not ten times as far"),
    ("30", UNKNOWN + "lies more than ten times as far from the key as its band reaches"),
    ("60", UNKNOWN + "is more than twice what is right"), ("5", UNKNOWN + "is less than half of what is right"),
    ("-5", "no known mistake leads to this: sign and size differ from those of the key")]


@pytest.mark.parametrize("text, said", WHY)
def test_why_a_number_is_wrong_that_no_known_mistake_gives(text, said):
    assert marks(omega=text)[0] == ("wrong", 0, "", said)


def test_reasons_of_numbers_are_true_and_tell_no_key():
    """What they say of sign, factor and distance holds; and of answers that are no multiple of it the key may be one
    of many."""
    draw, seen = random.Random("reasons"), set()
    for _ in range(4000):
        key, band = draw.choice((1, -1)) * 10 ** draw.uniform(-3, 5), 10 ** draw.uniform(-4, -1.7)
        value = key * draw.choice((1, -1)) * draw.choice((1 + draw.uniform(-20, 20) * band, 10 ** draw.uniform(-4, 4)))
        if abs(value - key) <= band * abs(key):
            continue
        said = of_number(value, key, band * abs(key))
        if said.startswith(BUT):
            factor = said.removeprefix(BUT).removeprefix("its sign").partition("a factor of ")[2] or "1"
            sign = -1 if "sign" in said else 1
            assert abs(sign * value / eval(factor.replace("2π", "tau").replace("π", "pi"), {"pi": pi, "tau": 2 * pi})
                       - key) <= band * abs(key) * (1 + 1e-9)
        else:
            far, ratio = abs(value / key - 1) / band, value / key
            holds = {"sign and size": ratio < 0, "more than twice": ratio > 2, "less than half": 0 < ratio < 0.5,
                     "not twice": 1 < far <= 2, "not ten": 2 < far <= 10, "ten times as far from": far > 10}
            name, = (words for words in holds if words in said)
            assert holds[name]
            seen.add(name)
    assert len(seen) == 6
    assert of_number(0.3, 0.0, 0.0) == UNKNOWN + "lies outside the band of the key"


def test_how_far_a_number_is_off():
    for text, off in (("22.1", 0.191), ("3.49 Hz", 3.49 - 21.909), ("21.9", -0.009)):
        one, other = Marker(MANIFEST).marks("s1", "crank", {"omega_d[1]": text})
        assert (one.off, one.band, one.unit) == (pytest.approx(off), 0.11, "rad/s")
        assert (other.verdict, other.off, other.band) == ("missing", None, None)


def test_edges_of_the_band():
    for value, verdict in ((21.909 + 0.11, "right"), (21.909 - 0.11, "right"), (21.909 + 0.11 * (1 + 1e-9), "wrong"),
                           (21.909 - 0.11 * (1 + 1e-9), "wrong")):
        assert marks(omega=repr(value))[0][0] == verdict


def test_names_of_students_problems_and_quantities():
    marker = Marker(MANIFEST)
    assert marker.problem("s1", None) == "crank" and marker.quantity("crank", " zeta [1]") == "zeta[1]"
    for call, said in ((lambda: marker.problem("s3", None), "no student 's3'"),
                       (lambda: marker.problem("s2", None), "has several problems"),
                       (lambda: marker.problem("s1", "drum"), "no problem 'drum'"),
                       (lambda: marker.quantity("crank", "omega[1]"), "does not ask for 'omega[1]'")):
        with pytest.raises(ValueError, match=said.replace("[", "\\[")):
            call()
    with pytest.raises(ValueError, match="no student 's3'; valid here: s1, s2"):
        marker.sheet("s3")
    crowd = Marker(MANIFEST | {"students": [{"id": f"{i:03}", "sheets": []} for i in range(60)]})
    with pytest.raises(ValueError, match=r"no student 'zz'$"):      # neither one that is near, nor all
        crowd.sheet("zz")


@pytest.mark.parametrize("text, found", [
    ("the answer is 21.9 rad/s", "the key 21.9"), ("21,91", "the key 21,91"), ("2.19e1", "the key 2.19e1"),
    ("2.19·10¹", "the key 2.19·101"), ("2.19 × 10 rad/s", "the key 2.19 × 10"),
    ("0.219 · 10^2", "the key 0.219 · 10^2"),
    ("2191*10^-2", "the key 2191*10^-2"), ("2.19·10.5", None), ("2.19 · 10 · 3", "the key 2.19 · 10"),
    ("22 rad/s", None), ("k = 219 N/m", None), ("\U0001d7d0\U0001d7cf.\U0001d7d7\U0001d7cf", "the key 21.91"),
    ("m21.9x", None), ("−21.9", "the key −21.9"), ("a secret text", "the salt, or a comment of the scene")])
def test_leaks(text, found):
    assert leak(text, [21.909], ["a secret text"]) == found


def test_what_is_read_in_a_page():
    page = ('<p title="21.9">a</p><svg><title>t1</title><path d="M 21.9 3"/><text>t2</text></svg><img alt="t3" src="x">'
            "<!-- t4 --><style>p {margin: 21.9px}</style><meta name='a' content='t5'>")
    found = text_of_page(page)
    assert all(word in found for word in ("21.9", "a", "t1", "t2", "t3", "t4", "t5"))
    assert "M 21.9" not in found and "margin" not in found
