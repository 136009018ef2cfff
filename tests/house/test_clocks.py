"""What is printed hangs on no clock: budgets count work. Clocks are read where times are told, and their jumps change
no byte of what is found."""

import ast
import random
from contextlib import redirect_stderr, redirect_stdout
from importlib import import_module
from io import StringIO

import pytest

from vibcli.cli.program import run

MODULES = {"time", "datetime", "timeit", "sched", "asyncio", "resource"}
TIMERS = {"alarm", "setitimer", "Timer"}        # of signal, and of threads
MEASURING = "vibcli.bench."
READ = {                # where a clock is read, and what for
    "vibcli.api.source": "perf_counter",                # --timings
    "vibcli.base.stage": "perf_counter",                # --timings
    "vibcli.cli.progress": "monotonic",                 # how far long work is
    "vibcli.cli.checking.work": "process_time",         # which file is begun first by several processes
    "vibcli.evidence.timing": "process_time",           # bench FILE
    "vibcli.evidence.subject": "process_time",          # bench FILE
    "vibcli.cli.viewing.following": "sleep",            # between two looks at a file that is edited
}
SCENE = """
parameters: {m: 2 kg, k: 800 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: m, at: [0, 0], slide: x}
  bob: {mass: m/2, at: [0, -0.5 m], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [[-1 m, 0], cart]}}
initial: {phi: 2 rad}
motion: full
find: [frequencies, modes, {response: {until: 1 s}}]
answers: {"omega[1]": 4.400 rad/s, "max(x)": 5.0 cm}
"""


def clocks(nodes):
    """Names of clocks and timers that a file imports or calls, of the nodes of its syntax tree."""
    found = []
    for node in nodes:
        if isinstance(node, ast.Import):
            found += [one.name for one in node.names if one.name.split(".")[0] in MODULES]
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in MODULES:
            found += [one.name for one in node.names]
        elif isinstance(node, ast.Attribute) and node.attr in TIMERS:
            found.append(node.attr)
        elif isinstance(node, ast.ImportFrom):
            found += [one.name for one in node.names if one.name in TIMERS]
    return found


@pytest.mark.sweep
def test_clocks_are_read_where_times_are_told_alone(house):
    found = {module: names for module, nodes in house.nodes.items() if (names := clocks(nodes))}
    elsewhere = {module: names for module, names in found.items() if not module.startswith(MEASURING)}
    assert elsewhere == {module: [name] for module, name in READ.items()}


def test_what_is_looked_for_is_seen(planted):
    house = planted({"a.py": "import time\nfrom datetime import date\nimport signal\nsignal.alarm(3)\n"
                             "from threading import Timer\nimport math\n"})
    assert sorted(clocks(house.nodes["vibcli.a"])) == ["Timer", "alarm", "date", "time"]


def said(*args):
    out, err = StringIO(), StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run(list(args))
    return code, out.getvalue(), err.getvalue()


@pytest.mark.parametrize("command", ["solve", "check", "response"])
def test_a_clock_that_jumps_changes_no_byte(command, tmp_path, monkeypatch):
    scene = tmp_path / "scene.yaml"
    scene.write_text(SCENE)
    wanted = said(command, str(scene))
    dice = random.Random(command)
    for file, name in READ.items():
        if name != "sleep":
            module = import_module(file.removesuffix(".py").replace("/", "."))
            monkeypatch.setattr(module, name, lambda: dice.choice([-1e9, 0.0, 1e-9, 1e9]))
    assert wanted[1] and said(command, str(scene)) == wanted
