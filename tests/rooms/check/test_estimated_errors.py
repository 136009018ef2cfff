"""Where the errors of motions by modes are estimates and no bounds, `check` and the data of responses say so."""

import json

import pytest

from vibcli.cli.program import run
from vibcli.results.damped_modal_response import DampedModalResponse

ARM = """
parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: RIGHT}}
initial: {arm.u: 1 mm*(6*(x/L)^2 - 4*(x/L)^3 + (x/L)^4)/3}       # as under its weight: few modes are enough
damping: {proportional: [1 s^-1, 0.001 s]}
answers:
  ANSWER
  omega[1]: {value: 69.0593 rad/s, rtol: 1 %}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("right, name, answer, estimated", [
    ("{c: 3 N*s/m}", "arm.u'(L)", "max(arm.u'(L)): {value: 51.5 mm/s, rtol: 1 %}", True),
    ("{c: 3 N*s/m}", "arm.u(L)", "max(arm.u(L)): {value: 1 mm, rtol: 1 %}", False),
    ("free", "arm.u(L)", "max(arm.u(L)): {value: 1 mm, rtol: 1 %}", False)])
def test_only_errors_that_are_estimates_are_said_to_be(tmp_path, capsys, right, name, answer, estimated):
    path = tmp_path / "arm.yaml"
    path.write_text(ARM.replace("RIGHT", right).replace("ANSWER", answer), encoding="utf-8")
    assert run(["check", str(path)]) == 0
    largest, omega = (line for line in capsys.readouterr().out.splitlines() if "✓" in line)
    assert ("error is estimated" in largest) == estimated
    assert "error is estimated" not in omega
    assert run(["check", str(path), "--json"]) == 0
    largest, omega = json.loads(capsys.readouterr().out)[0]["answers"]
    assert largest["estimated"] == estimated and not omega["estimated"]
    assert run(["response", str(path), "--json", "--of", name]) == 0
    assert json.loads(capsys.readouterr().out)["response"]["estimated"] == estimated


STARTED = """
parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {c: 3 N*s/m}}}
initial: {arm.u: FIELD}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("field, estimated", [
    ("1 mm*(6*(x/L)^2 - 4*(x/L)^3 + (x/L)^4)/3", False),
    ("1 mm*(x/L)^2", True)])        # its moment at the free end is not zero
def test_of_damped_modes_errors_of_moments_are_bounds_where_a_start_fits_the_ends(
        tmp_path, capsys, monkeypatch, field, estimated):
    monkeypatch.setattr(DampedModalResponse, "most", 128)
    path = tmp_path / "arm.yaml"
    path.write_text(STARTED.replace("FIELD", field), encoding="utf-8")
    asked = ["response", str(path), "--of", "arm.u(L)", "--of", "arm.moment(0 m)", "--until", "0.1 s"]
    assert run(asked) == 0
    told = " ".join(capsys.readouterr().out.split())
    reason = ("what those left out add is estimated in arm.moment(0 m), as it is a force, or a rate, after a start in "
              "a field that is not smooth, or does not fit all ends and joints")
    assert (reason in told) == estimated
    assert run([*asked, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)["response"]
    assert told["estimated"] == estimated
    assert [one["estimated"] for one in told["signals"]] == [False, estimated]


def _told(tmp_path, capsys, text, *names):
    path = tmp_path / "arm.yaml"
    path.write_text(text, encoding="utf-8")
    assert run(["response", str(path), *(part for name in names for part in ("--of", name)), "--until", "20 ms"]) == 0
    return " ".join(capsys.readouterr().out.split())


def test_why_dampers_beside_damping_leave_an_estimate_is_said(tmp_path, capsys):
    text = ARM[:ARM.index("answers")].replace("RIGHT", "{c: 3 N*s/m}")
    told = _told(tmp_path, capsys, text, "arm.u(L)", "arm.moment(0 m)")
    assert ("what those left out add is estimated in arm.moment(0 m), as it is a force, or a rate, and dampers couple "
            "the modes that `damping:` damps)") in told


def test_each_signal_has_its_reason_and_what_has_no_bound_too(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(DampedModalResponse, "most", 128)
    text = STARTED.replace("FIELD", "1 mm*(x/L)^2") + (
        "points: {mid: {body: arm, at: L/2}}\nforces: {push: {at: mid, force: 1 N*step(t)}}\n")
    told = _told(tmp_path, capsys, text, "arm.u(L)", "arm.moment(0 m)", "arm.shear(0 m)", "arm.shear(0 m) + 1 N")
    unfit = ("as it is a force, or a rate, after a start in a field that is not smooth, or does not fit all ends and "
             "joints")
    assert (f"estimated in arm.moment(0 m), {unfit}; in arm.shear(0 m), arm.shear(0 m) + 1 N, {unfit}, and as a load, "
            "or a rate of it, sets in or lets go at once where nothing has mass)") in told
    assert f"fall too slowly or too unevenly, {unfit}; let it start in a shape whose moments and forces fit" in told
