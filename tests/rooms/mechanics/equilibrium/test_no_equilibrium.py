"""Where nothing holds a load the report claims no equilibrium: no generalised force is 0, no small oscillations."""

import pytest

from vibcli.cli import run

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
