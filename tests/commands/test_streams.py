"""Every command with a stdout that is full, closed or read by nobody, and with a stderr that is: codes and words."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from support.standard_streams import imported

from vibcli.cli import COMMANDS
from vibcli.homework.manifest import seal

ROOT = Path(__file__).parents[2]
ENDING = [command for command in COMMANDS if command != "view"]      # which goes on until it is interrupted
TIMED = "bench",        # what these print tells times
INVALID = str(ROOT / "tests" / "bad" / "parts_with_several_circles.yaml")
SCENE = """
parameters: {k: 4 N/m}
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
forces: {f: {at: a, force: 3 N*cos(1 rad/s*t)}}
answers:
  omega[NUMBER]: RATE rad/s
variants: {parameters: {k: [4 N/m, 5 N/m]}, without: [told]}
"""
SILENT = ("draw", "animate")        # these print nothing on stdout
CALLS = {"explain": ["springs"], "schema": [], "new": [], "grade": ["manifest.json"]}      # the others read a scene
MORE = {"sweep": ["--over", "k=3 .. 5"], "bench": ["--quick"],
        "grade": ["--student", "1", "--answer", "omega[1]=2 rad/s"],
        "homework": ["--paper", "2", "--salt-file", "salt", "--force", "-o", "sheets_for_all"]}
MANIFEST = """{"form": "vibcli homework 1", "title": "set", "course": "", "due": "", "attempt": 1, "problems": [
{"name": "scene", "title": "scene", "file": "scene.yaml", "scene": "", "accepted": 2, "ranges": [], "mistakes": {},
"files": {},
"variants": [{"variant": 1, "values": {"k": "4 N/m"}, "keys": [{"quantity": "omega[1]", "unit": "rad/s", "points": 1,
"value": 2, "error": 0, "figures": 4, "band": 0.01, "mistakes": []}]}]}],
"students": [{"id": "1", "name": "", "sheets": [{"problem": "scene", "variant": 1}]}]}"""


@pytest.fixture(scope="module")
def called(tmp_path_factory):
    """What runs a command in a process that has imported what they all need."""
    folder = tmp_path_factory.mktemp("once")
    beside(folder)
    (folder / "scene.yaml").write_text(SCENE.replace("NUMBER", "1").replace("RATE", "2"))
    runs = [(folder, [command, *CALLS.get(command, ["scene.yaml"]), *MORE.get(command, []),
                      *(["-o", f"{command}.{'gif' if command == 'animate' else 'png'}"] * (command in SILENT))])
            for command in ENDING]
    with imported(runs) as call:
        yield call


def beside(folder):
    """What homework and marks read beside a scene."""
    (folder / "salt").write_text("a secret text")
    manifest = json.loads(MANIFEST)
    (folder / "manifest.json").write_text(json.dumps({**manifest, "seal": seal(manifest)}))


@pytest.fixture
def call(called, tmp_path):
    """call(arguments, how stdout is, how stderr is) -> (exit code, stdout, stderr) of a process of its own."""
    for name, number, rate in (("right", 1, 2), ("wrong", 1, 3), ("refused", 2, 3)):
        text = SCENE.replace("NUMBER", str(number)).replace("RATE", str(rate))
        (tmp_path / f"{name}.yaml").write_text(text)
    beside(tmp_path)

    def of(args, stdout="file", stderr="file"):
        files = [tmp_path / "out.txt", tmp_path / "err.txt"]
        code = called(tmp_path, args, stdout, stderr)
        for picture in (*tmp_path.glob("*.png"), *tmp_path.glob("*.gif")):
            picture.unlink()
        return code, *(file.read_text() if file.exists() else "" for file in files)
    return of


@pytest.mark.sweep
@pytest.mark.parametrize("command", ENDING)
def test_each_command(call, command):
    args = [command, *CALLS.get(command, ["right.yaml"]), *MORE.get(command, [])]
    code, out, err = call(args)
    assert code == 0
    if command in SILENT:
        assert call(args, "full") == (0, "", err) and call(args, "closed", "closed")[0] == 0
        return
    assert len(out) > 40
    for how, words in (("full", "No space left on device"), ("closed", "stdout is closed")):
        found, _, told = call(args, how)
        assert found == 4 and told.endswith(f"error: the output cannot be written: {words}\n")
        assert told.count("\n") == 1
    assert call(args, "left")[::2] == (0, err)
    for how in ("full", "closed", "left"):
        found, told, _ = call(args, "file", how)
        assert found == 0 and (told == out if command not in TIMED else len(told) > 40)


@pytest.mark.sweep
@pytest.mark.parametrize(("args", "code"), [
    (["check", "wrong.yaml"], 1), (["solve"], 2), (["nonsense"], 2), (["solve", INVALID], 3), (["check", INVALID], 3),
    (["check", "refused.yaml"], 4), (["check", "wrong.yaml", "right.yaml", INVALID], 3), (["explain", "nonsense"], 2),
    (["--help"], 0), (["solve", "--help"], 0), (["--version"], 0)])
def test_the_code_is_that_of_the_work(call, args, code):
    wanted = call(args)
    assert wanted[0] == code
    assert call(args, "left")[::2] == wanted[::2]
    for how in ("full", "closed", "left"):
        assert call(args, "file", how)[:2] == wanted[:2]
        assert call(args, how, how)[0] == (4 if wanted[1] and how != "left" else code)


@pytest.mark.parametrize(("redirection", "code", "words"), [
    ("> /dev/full", 4, "No space left on device"), ("| head -1", 0, "")])
def test_a_process_leaves_without_a_trace(redirection, code, words):
    done = subprocess.run(["bash", "-c", f"{sys.executable} -m vibcli explain {redirection}; exit ${{PIPESTATUS[0]}}"],
                          capture_output=True, text=True)
    assert done.returncode == code and done.stderr.count("\n") == bool(words) and words in done.stderr


@pytest.mark.sweep
def test_a_pipe_that_does_not_block_is_waited_for():
    """As one is that is shared with a program that made it so: all arrives, however slowly it is read."""
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    process = subprocess.Popen([sys.executable, "-m", "vibcli", "schema"], stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    found = b""
    while part := os.read(reader, 512):
        found += part
    assert process.communicate() == (None, b"") and process.returncode == 0
    assert len(found) > 1 << 16 and json.loads(found)
