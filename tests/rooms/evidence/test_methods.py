"""The methods that are compared, how they are measured, and the sentence that is said of them."""

import math
from importlib import import_module
from pathlib import Path

import mpmath
import pytest

from vibcli import evidence
from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import PhysicsError
from vibcli.bench import scenes
from vibcli.evidence import timing, told
from vibcli.evidence.asked import subjects
from vibcli.evidence.compared import WorkPrecision
from vibcli.evidence.compared import evidence as compared
from vibcli.evidence.methods import METHODS, held_inputs
from vibcli.evidence.picture import figure
from vibcli.evidence.reference.settled import TrueValues, relative_error
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject, TimeIsOver
from vibcli.evidence.subjects import SUBJECTS
from vibcli.evidence.timing import SPENT, STOPPED, Point, measured
from vibcli.evidence.verdict import verdict
from vibcli.quantities import FAMILIES, FORMS

FOLDER = Path(evidence.__file__).parent
ONE = TrueValues([mpmath.mpf(1)], 47, 60, 30)


def test_faces_tell_of_every_file():
    assert set(METHODS) == {path.stem for path in (FOLDER / "methods").glob("*.py")} - {"__init__"}
    assert {file for file, _ in SUBJECTS.values()} == {
        path.stem for path in (FOLDER / "subjects").glob("*.py")} - {"__init__"}
    assert all(callable(import_module(f"vibcli.evidence.methods.{file}").attempts) for file in METHODS)
    assert all(callable(getattr(import_module(f"vibcli.evidence.subjects.{file}"), name))
               for file, name in SUBJECTS.values())
    assert set(SUBJECTS) <= {*FAMILIES, *FORMS}
    assert all(0 < len(about) <= 90 for _, about in METHODS.values())


def point(method, seconds, error, bound=None, setting=""):
    return Point(method, setting, (seconds, seconds, seconds), 7, error, bound)


@pytest.mark.parametrize(("others", "said"), [
    ([point("eigh", 1e-4, 3e-10)], "10 × the time of eigh and 6 digits more; nothing plain reaches 1e-10"),
    ([point("grid", 4e-2, 1e-3)], "1/40 of the time of grid and 13 digits more; nothing plain reaches 1e-4"),
    ([point("eigh", 1e-4, 2e-16)], "eigh is as good, 2.0e-16, and 10 × faster; it states no bound"),
    ([point("RK45", 1e-1, 1e-16, setting="1e-13"), point("RK45", 1e-2, 1e-4, setting="1e-03")],
     "100 × faster than RK45 at 1e-13, the fastest that is as good; it states no bound"),
    ([point("sum", 1e-4, 1e-16, setting="3 modes")], "sum with 3 modes is as good, 1.0e-16, and 10 × faster; it states "
     "no bound"),
    ([], "vibcli alone answers: there is nothing to compare it with")])
def test_the_sentence(others, said):
    assert verdict([point("vibcli", 1e-3, 1e-16, 1e-15), *others]) == said


def test_what_did_not_end_counts_for_nothing():
    slow = Point("RK45", "1e-13", (5.0, 5.0, 5.0), 0, None, None, STOPPED)
    said = verdict([point("vibcli", 1e-3, 1e-16, 1e-15), point("RK45", 1e-1, 1e-4, setting="1e-03"), slow])
    assert said == "1/100 of the time of RK45 at 1e-03 and 12 digits more; of what ended in time none reaches 1e-5"


def test_the_table_has_the_one_that_the_sentence_names():
    errors = 1e-1, 1e-2, 1e-3, 1e-4, 1e-8, 1e-6, 1e-5
    points = [point("vibcli", 1e-3, 1e-16, 1e-15), *(
        point("finite elements", 1e-4, error, setting=f"{2**k} a piece") for k, error in enumerate(errors, 1))]
    assert "finite elements with 32 a piece" in verdict(points)
    assert [one.setting for one in told._shown(points)] == ["", *(f"{n} a piece" for n in (2, 16, 32, 128))]


def test_a_refusal_of_ours_is_said():
    refused = Point("vibcli", "", (0.1, 0.1, 0.1), 0, None, None, "it is singular")
    assert verdict([refused, point("eigh", 1e-4, 1e-3)]) == "vibcli itself refuses: it is singular"


@pytest.mark.parametrize(("seconds", "said"), [(1.234e-6, "0.00123"), (0.04567, "45.7"), (0.9994, "999"),
                                               (0.9999, "1000"), (2.41234, "2412")])
def test_times_have_no_exponents(seconds, said):
    assert told._row(point("RK45", seconds, 1e-3), 20)[2] == f"{said} ({said} … {said})"
    late = Point("RK45", "1e-13", (seconds,) * 3, 0, None, None, STOPPED)
    assert told._row(late, 20)[2:4] == (f"over {said}", STOPPED)


@pytest.mark.parametrize(("error", "said"), [(3e-19, "3.0e-19"), (1e-20, "< 1e-20"), (0.0, "< 1e-20")])
def test_errors_are_told_as_far_as_the_digits_of_the_true_value_go(error, said):
    assert told._row(point("RK45", 1e-3, error), 20)[3] == said


def test_no_error_is_less_than_the_true_value_leaves_open():
    subject = Subject("modes", "omega", "", None, ONE._replace(digits=12), None, None, relative_error)
    found = measured(subject, runs(vibcli=lambda _: MethodAnswer([1 + 1e-15]),
                                   eig=lambda _: MethodAnswer([1 + 1e-9])), 1)
    assert [one["error below"] for one in told._data(WorkPrecision(subject, found))["points"]] == [True, False]
    assert [one.error for one in found] == [1e-12, pytest.approx(1e-9)]


def test_long_reasons_stand_below_the_table():
    why = "the energies of this motion do not balance to the digits that are stated"
    ours, other = (Point(name, "", (0.1, 0.1, 0.1), 0, None, None, why) for name in ("vibcli", "eig"))
    subject = Subject("modes", "omega", "", None, ONE, None, None, relative_error)
    page = told.markdown(WorkPrecision(subject, [ours, other, point("eigh", 1e-4, 1e-3)]))
    table = [line for line in page.splitlines() if line.startswith("|")]
    assert len(table) == 5 and not any(why in line for line in table)
    assert f"eig: {why}." in page and f"vibcli itself refuses: {why}." in page and page.count(why) == 2


DRIVEN = """
records: {{f: {{file: f.csv, unit: N}}}}
bodies: {{a: {{mass: 2 kg, slide: x}}, b: {{mass: 1 kg, slide: y}}}}
springs: {{s: {{k: 90 N/m, between: [ground, a]}}, t: {{k: 40 N/m, between: [a, b]}}}}
dampers: {{d: {{c: 3 N*s/m, between: [ground, b]}}}}
forces: {{F: {{at: a, force: {force}}}}}
initial: {{y: 2 cm}}
find: [{{response: {{until: 3 s}}}}]
answers:
  x(1.3 s): 1 m
  max(y): 1 m
"""


@pytest.mark.sweep
@pytest.mark.parametrize(("force", "kept", "exponents"), [
    ("2*f(t - 0.5 s)", (26, 60), (-13, -6)), ("3 N*cos(7 rad/s*t)", (100, 100), (-2, -2)),
    ("0 N", (100, 100), (-13, -13))])
def test_lsim_is_exact_between_samples_and_falls_elsewhere(force, kept, exponents, tmp_path):
    """Beside Taylor's series, which knows nothing of it; a maximum is read off a polynomial through twelve steps."""
    (tmp_path / "f.csv").write_text("0,0\n0.1,3\n0.15,-1\n0.5,2\n1.5,0\n")
    text = DRIVEN.format(force=force)
    problem = problem_of(text_source(text if "f(" in force else text[text.index("bodies"):], folder=str(tmp_path)))
    for answer, steps, exponent in zip(problem.spec.answers, kept, exponents, strict=True):
        subject, = subjects(problem, [answer.asked])
        attempts = list(held_inputs.attempts(subject))[:3]
        assert [one.setting for one in attempts] == [f"{steps * part} steps" for part in (1, 10, 100)]
        errors = [subject.error(one.run(Deadline(math.inf)).values, subject.true) for one in attempts]
        falls = errors[0] > 30 * errors[1] and (errors[1] < 1e-13 or errors[1] > 30 * errors[2])
        assert errors[0] < 10.0**exponent and (exponent < -9 or falls)


def runs(**methods):
    return [MethodRun(name, "", run) for name, run in methods.items()]


def test_what_a_method_does_is_told_and_the_others_go_on():
    calls = []

    def counted(_):
        calls.append(1)
        return MethodAnswer([1 + 1e-6], 1e-5)

    def stops(deadline):
        raise TimeIsOver

    def refuses(_):
        raise PhysicsError("no")

    subject = Subject("modes", "omega", "", None, ONE, None, None, relative_error)
    found = measured(subject, [*runs(vibcli=counted, slow=stops), *runs(slow=counted),
                               *runs(no=refuses, fault=lambda _: 1 / 0, two=lambda _: MethodAnswer([1, 2]))], 3)
    assert [one.why for one in found] == ["", STOPPED, "no", "ZeroDivisionError: division by zero",
                                          "2 values, of which there are 1"]
    assert found[0].error == pytest.approx(1e-6) and found[0].bound == 1e-5 and len(calls) >= 4
    assert all(one.error is None for one in found[1:])


def test_where_no_time_is_left_methods_are_left_out():
    subject = Subject("modes", "omega", "", None, ONE, None, None, relative_error)
    found = measured(subject, [*runs(vibcli=lambda _: MethodAnswer([1])), *runs(other=lambda _: MethodAnswer([1]))], 3,
                     patience=-1.0)
    assert [one.why for one in found] == ["", SPENT]


@pytest.fixture
def lasting(monkeypatch):
    """(makes an attempt that takes so many seconds of a clock of its own, what was begun)."""
    clock, begun = [0.0], []
    monkeypatch.setattr(timing, "process_time", lambda: clock[0])

    def attempt(method, setting, seconds):
        def run(_):
            begun.append(method + setting)
            clock[0] += seconds
            return MethodAnswer([1])

        return MethodRun(method, setting, run)

    return attempt, begun


ANY = Subject("motion", "x(1 s)", "", None, ONE, None, None, relative_error)


def test_methods_are_tried_in_turns_and_what_would_outgrow_the_time_left_is_not_begun(lasting):
    attempt, begun = lasting
    found = measured(ANY, [attempt("vibcli", "", 0.01), *(attempt("grid", str(k), 0.6 * 8**k) for k in range(4)),
                           attempt("odeint", "0", 1.0), attempt("odeint", "1", 1.0)], 3, patience=40.0)
    assert begun[:6] == ["vibcli", "grid0", "odeint0", "grid1", "odeint1", "vibcli"] and "grid2" not in begun
    assert [(one.method, one.setting, one.why) for one in found] == [
        ("vibcli", "", ""), ("grid", "0", ""), ("grid", "1", ""), ("grid", "2", SPENT), ("odeint", "0", ""),
        ("odeint", "1", "")]


def test_each_is_run_seven_times_by_turns_after_a_warm_up_and_what_takes_over_half_a_second_three(lasting):
    attempt, begun = lasting
    found = measured(ANY, [attempt("vibcli", "", 0.02), attempt("eig", "", 0.5), attempt("odeint", "", 0.75)])
    assert [one.runs for one in found] == [7, 7, 3]
    assert begun == 4 * ["vibcli", "eig", "odeint"] + 4 * ["vibcli", "eig"]
    assert [one.seconds for one in found] == [pytest.approx((x, x, x)) for x in (0.02, 0.5, 0.75)]


def test_what_is_short_is_repeated_within_one_measurement(lasting):
    attempt, begun = lasting
    one, = measured(ANY, [attempt("vibcli", "", 1e-4)])
    assert one.runs == 7 and begun.count("vibcli") == 1 + 7 * 10


@pytest.mark.parametrize("ours, allowed", [(0.01, 5.0), (0.2, 20.0)])
def test_a_method_may_take_five_seconds_and_a_hundred_times_ours(lasting, monkeypatch, ours, allowed):
    given = []
    monkeypatch.setattr(timing, "Deadline", lambda seconds: given.append(seconds))
    measured(ANY, [lasting[0]("vibcli", "", ours), lasting[0]("odeint", "", 0.1)])
    assert given[:2] == [5.0, pytest.approx(allowed)] and set(given[2:]) == {math.inf}


def test_what_one_leaves_of_the_time_is_for_those_after_it(lasting):
    attempt, _ = lasting
    whole, dear = 24.0, [attempt("odeint", str(k), 4.0) for k in range(3)]      # half of 12 s is enough for one of them
    found = timing.measured_in_shares([(ANY, [attempt("vibcli", "", 0.01)]), (ANY, dear)], 3, whole)
    assert [[one.why for one in points] for points in found] == [[""], ["", "", SPENT]]


def test_a_deadline_ends_what_asks():
    with pytest.raises(TimeIsOver):
        Deadline(-1.0).check()
    assert Deadline(math.inf).check() is None


def test_stiff_and_soft_springs_show_what_assembled_matrices_lose():
    stiffnesses = [f"{10 ** (16 * place / 5):.17e}" for place in (0, 5, 2, 4, 1, 3)]
    found = compared(problem_of(text_source(scenes.chain(6, stiffnesses, "3 kg"))), (), 1)
    one, = found.compared
    errors = {point.method: point.error for point in one.points}
    assert errors["vibcli"] <= 1e-15 <= one.points[0].bound and errors["scipy eigh"] > 1e-3
    assert "nothing plain reaches" in verdict(one.points)
    panel, = figure([one]).panels
    assert panel.x_log and panel.y_log
    assert {curve.label for curve in panel.curves} >= {"vibcli", "scipy eigh", "numpy eig", "bound that is stated"}
