"""The lowest modes of more coordinates than dense matrices are made of, from scenes."""

import json
import subprocess
import sys

import mpmath
import numpy as np
import pytest

import vibcli
from vibcli.analyses.modal.lowest_modes import LowestModes
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.program import run
from vibcli.mechanics.factored_system import MOST_DENSE

N = MOST_DENSE + 100


def chain(n=N, held=True, **more):
    """A mapping: masses in a row between springs, the first held."""
    between = [[f"b{i - 1}" if i > 1 else "ground", f"b{i}"] for i in range(1 if held else 2, n + 1)]
    return {"bodies": {f"b{i}": {"mass": "1 kg", "slide": f"x{i}"} for i in range(1, n + 1)},
            "springs": {f"s{i}": {"k": "1000 N/m", "between": ends} for i, ends in enumerate(between)}, **more}


def closed_form(i, n=N, held=True):
    with mpmath.workdps(30):
        turn = mpmath.pi * (mpmath.mpf(2 * i - 1) / (2 * (2 * n + 1)) if held else mpmath.mpf(i - 1) / (2 * n))
        return float(2 * mpmath.sqrt(1000) * mpmath.sin(turn))


@pytest.fixture(scope="module")
def held():
    return vibcli.load(chain())


def refusal(model, asked):
    with pytest.raises(PhysicsError) as refused:
        _ = model[asked].value
    return str(refused.value)


@pytest.mark.sweep
def test_a_chain_by_its_closed_form(held):
    for i in (1, 2, 10, 57):
        omega = held[f"omega[{i}]"]
        exact = closed_form(i)
        assert abs(omega.value - exact) <= omega.error + 2.0**-53 * exact
        assert omega.error <= 1e-13 * exact
    assert held["stable"].value is True
    assert held["modal_mass[1]"].value > 0
    shape = [held[f"mode[2][x{i}]"].value for i in (1, 700, N)]
    with mpmath.workdps(30):
        exact = [mpmath.sin(3 * i * mpmath.pi / (2 * N + 1)) for i in (1, 700, N)]
    assert np.allclose(shape, [float(x / exact[0]) for x in exact], rtol=1e-9)


@pytest.mark.sweep
def test_a_free_chain_has_one_rigid_mode():
    model = vibcli.load(chain(held=False))
    assert (model["omega[1]"].value, model["omega[1]"].error) == (0.0, 0.0)
    assert abs(model["omega[2]"].value / closed_form(2, held=False) - 1) < 1e-13
    assert model["mode[1][x9]"].value == pytest.approx(1.0, rel=1e-10)


@pytest.mark.sweep
def test_a_spring_that_drives_away():
    """k < 0 to the ground: λ² of cosh, from the condition at the end of the chain."""
    scene = chain()
    scene["springs"]["s0"]["k"] = "-1 N/m"
    model = vibcli.load(scene)
    assert model["stable"].value is False
    with mpmath.workdps(40):
        def end(square):            # of the recurrence x₍ᵢ₊₁₎ = (2 + λ²/1000) xᵢ − x₍ᵢ₋₁₎
            before, here = mpmath.mpf(1), 1 + (square - 1) / 1000
            for _ in range(N - 2):
                before, here = here, (2 + square / 1000) * here - before
            return (1 + square / 1000) * here - before

        rate = mpmath.sqrt(mpmath.findroot(end, (1e-3, 1.1e-3)))
    growth = model["growth_rate[1]"]
    assert abs(growth.value - rate) <= growth.error + 1e-15 * rate
    assert "unstable" in refusal(model, "omega[1]")


@pytest.mark.sweep
def test_what_needs_all_coordinates_at_once_is_refused_by_name(held):
    for asked, what in (("x1(1 s)", "a motion in time"), ("rayleigh", "this"), ("zeta[1]", "nothing damps")):
        assert what in refusal(held, asked)
    assert f"the limit for those is {MOST_DENSE}" in refusal(held, "x1(1 s)")
    assert f"there is no mode {N + 1}" in refusal(held, f"omega[{N + 1}]")
    assert "the lowest 525 are found" in refusal(held, "omega[600]")
    assert held["K[x1, x2]"].value == -1000


@pytest.mark.sweep
def test_dampers_leave_the_natural_modes():
    model = vibcli.load(chain(dampers={"d": {"c": "3 N*s/m", "between": ["ground", "b1"]}}))
    assert abs(model["omega[1]"].value / closed_form(1) - 1) < 1e-13
    assert "the search for damped modes needs dense matrices" in refusal(model, "zeta[1]")


@pytest.mark.sweep
def test_given_damping_leaves_the_natural_modes():
    model = vibcli.load(chain(damping={"modal": "0.02"}))
    assert abs(model["omega[1]"].value / closed_form(1) - 1) < 1e-13
    assert "the search for damped modes needs dense matrices" in refusal(model, "zeta[1]")
    assert "`damping:` needs dense matrices" in refusal(model, "stable")


@pytest.mark.sweep
def test_a_coordinate_without_inertia_is_refused():
    scene = chain()
    del scene["bodies"]["b7"]["mass"]
    assert "need an inertia at each of them" in refusal(vibcli.load(scene), "omega[1]")


@pytest.mark.sweep
def test_a_scene_whose_parts_move_with_all_coordinates_keeps_the_old_limit():
    scene = chain(constraints={"c": {"equal": ["x1", "2*x2"]}})
    with pytest.raises(SpecError, match="the limit is 2000 where `constraints:` ties them"):
        vibcli.load(scene)
    links = {f"b{i}": {"mass": "1 kg", "slide": {"by": f"x{i}", "carrier": f"b{i - 1}"} if i else "x0"}
             for i in range(N)}
    with pytest.raises(SpecError, match="other bodies carry one, as 'b1'"):
        vibcli.load({"bodies": links})


@pytest.mark.sweep
def test_the_command_tells_the_lowest_and_their_count(tmp_path, capsys):
    lines = ["bodies:"] + [f"  b{i}: {{mass: 1 kg, slide: x{i}}}" for i in range(1, N + 1)] + ["springs:"]
    lines += [f"  s{i}: {{k: 1 kN/m, between: [{f'b{i - 1}' if i > 1 else 'ground'}, b{i}]}}" for i in range(1, N + 1)]
    lines += ["dampers: {d: {c: 1 N*s/m, between: [ground, b1]}}"]
    path = tmp_path / "chain.yaml"
    path.write_text("\n".join(lines))
    assert run(["frequencies", str(path)]) == 0
    told = capsys.readouterr().out
    assert "Natural frequencies (of the undamped system)" in told
    assert "J = 5 just above ω₅: none is missing" in told
    assert f"… ({N} in all)" in told
    assert f"not found of more than {MOST_DENSE} coordinates" in told
    assert run(["frequencies", str(path), "--modes", "3", "--json"]) == 4
    assert "damped modes needs dense matrices" in capsys.readouterr().err
    path.write_text("\n".join(lines[:-1]))
    assert run(["frequencies", str(path), "--modes", "3", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["count"], told["matrices"], len(told["modes"])) == (3, None, 3)
    assert abs(told["modes"][2]["omega"] / closed_form(3) - 1) < 1e-13


@pytest.mark.sweep
def test_up_to_a_frequency(held):
    modes = held._problem.modal.modes
    reach = (closed_form(7) + closed_form(8)) / 2
    assert [mode.index for mode in modes.up_to(reach)] == list(range(1, 8))
    assert [mode.index for mode in modes.up_to(closed_form(1) / 2)] == []
    with pytest.raises(PhysicsError, match="what needs all modes"):
        list(modes)


@pytest.mark.sweep
def test_slices_agree_with_dense_matrices():
    """The same scene of few coordinates, by both ways."""
    n = 150
    model = vibcli.load(chain(n))
    source = LowestModes(model._problem.configuration.element_data)
    found = source.numbered(1, 30)
    dense = model._problem.modal.modes
    for one, other in zip(found, dense, strict=False):
        assert abs(one.omega - other.omega) <= (one.error + other.error) * other.omega
        assert abs(abs(one.shape @ other.shape) - 1) < 1e-9
    assert source.counted_above(found[9]) == 10


@pytest.mark.sweep
def test_element_data_take_no_scipy():
    code = ("import sys, vibcli; m = vibcli.load({'bodies': {f'b{i}': {'mass': '1 kg', 'slide': f'x{i}'} for i in "
            "range(2100)}, 'springs': {f's{i}': {'k': '1 N/m', 'between': ['ground', f'b{i}']} for i in range(2100)}})"
            "\n"
            "m._problem.configuration.element_data\nassert 'scipy' not in sys.modules")
    subprocess.run([sys.executable, "-c", code], check=True)
