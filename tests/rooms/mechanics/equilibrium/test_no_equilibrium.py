"""Where nothing holds a load the report claims no equilibrium: no generalised force is 0, no small oscillations."""

import random

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run

SCENES = {
    "numbers": "parameters: {m: 1 kg, F: 3 N}\nbodies: {b: {mass: m, slide: x}}\nforces: {P: {at: b, force: F}}\n",
    "letters": "parameters: {m, F}\nbodies: {b: {mass: m, slide: x}}\nforces: {P: {at: b, force: F}}\n",
    "weight": "parameters: {m: 1 kg, g: 10 m/s^2}\ngravity: g\n"
              "bodies: {b: {mass: m, at: [0 m, 0], slide: {along: [0, 1], by: y}}}\n",
    "moment": "parameters: {J, M0}\nbodies: {b: {inertia: J, turn: phi}}\nforces: {P: {body: b, moment: M0}}\n",
    "runs off": "parameters: {m: 1 kg, V0: 1 J, a: 1 m, P: 1.5 N}\nbodies: {b: {mass: m, slide: x}}\n"
                "energies: {V: V0*log(cosh(x/a))}\nforces: {P: {at: b, force: P}}\n",
}


@pytest.mark.sweep
@pytest.mark.parametrize("command", ["solve", "equations", "frequencies"])
@pytest.mark.parametrize("name", SCENES)
def test_no_equilibrium_is_claimed(name, command, tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text(SCENES[name] + ("" if "gravity" in SCENES[name] or command != "solve" else
                                    "find: [equilibrium, virtual_work, equations]\n"))
    asked = command == "frequencies" or "find" in file.read_text()
    assert run([command, str(file)]) == (4 if asked else 0)
    out, err = capsys.readouterr()
    assert "no equilibrium" in err if asked else "Accelerations" in out and "Equilibrium\n  none" in out
    assert "Small oscillations" not in out and "in equilibrium" not in out
    assert not [row for row in out.split("\n") if "Q_" in row and row.endswith("= 0")]


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(60))
def test_a_free_network_rests_only_where_its_loads_balance(seed):
    """However soft or stiff its springs are, one load carries it away, and two that are opposed do not."""
    draw = random.Random(seed)
    n = draw.randint(2, 6)
    bodies = "".join(f"  b{i}: {{mass: 1.3 kg, slide: x{i}}}\n" for i in range(n))
    pairs = [(i, i + 1) for i in range(n - 1)] + [(0, n - 1)] * (n > 2)
    springs = "".join(f"  s{i}{j}: {{k: {10**draw.uniform(0, 8):.6g} N/m, between: [b{i}, b{j}]}}\n" for i, j in pairs)
    load = f"{draw.uniform(0.1, 10):.4g} N"
    scene = f"bodies:\n{bodies}springs:\n{springs}forces:\n  P: {{at: b0, force: {load}}}\n"
    with pytest.raises(PhysicsError, match="no equilibrium is reached"):
        problem(scene).configuration.equilibrium                                              # noqa: B018
    rest = problem(scene + f"  Q: {{at: b{n - 1}, force: -{load}}}\n").configuration.equilibrium.values
    assert all(abs(x) < 1e3 for x in rest.values())


def test_a_pole_to_which_the_energy_falls_is_none():
    """c/(d − x)² pulls harder than k x everywhere before d: k x (d − x)² ≤ 4 k d³/27 < c."""
    magnet = problem("parameters: {k: 40 N/m, c: 2e-3 N*m^2, d: 5 cm}\ncoordinates: {x: m}\n"
                     "energies: {T: \"(0.1 kg)*x'^2/2\", V: k*x^2/2 - c/(d - x)}\n")
    with pytest.raises(PhysicsError, match="the potential energy keeps falling along it"):
        magnet.configuration.equilibrium  # noqa: B018
    beyond, = magnet.equilibria.items
    x = beyond.equilibrium.values["x"]
    assert 40 * x * (0.05 - x)**2 == pytest.approx(2e-3, rel=1e-13)
