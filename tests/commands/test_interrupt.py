"""An interrupt leaves in one line and with 130, while modules are imported, in the last moments and wherever an error
would go nowhere; it leaves no file half written."""

import json
import os
import signal
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from support.interrupting import at_each_step

from vibcli.base.output_files import write_whole
from vibcli.cli.common import fault

ROOT = Path(__file__).parents[2]
STEPS = """
import atexit, json, os, signal, sys

FIRST, told, begun, us = {first}, {{}}, False, os.getpid()
err = open(os.path.join({folder!r}, "err"), "w+")

def interrupted(place):
    global begun
    if os.fork():
        code = os.waitstatus_to_exitcode(os.wait()[1])
        err.seek(0)
        told[place] = code, err.read()
        err.seek(0), err.truncate()
        return
    begun = False
    sys.settrace(None)
    os.dup2(err.fileno(), 2)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    signal.raise_signal(signal.SIGINT)

class Finder:
    def find_spec(self, name, path=None, target=None):
        if begun and "import of " + name not in told:
            interrupted("import of " + name)

def trace(frame, event, arg):
    global begun
    file, name = frame.f_code.co_filename, frame.f_code.co_name
    if file.endswith("vibcli/__main__.py") and name == "main":
        frame.f_trace_lines, frame.f_trace_opcodes = False, True
        begun = begun or frame.f_lineno >= FIRST
        if event == "opcode" and begun:
            interrupted(f"main, line {{frame.f_lineno}}, {{frame.f_lasti}}")
        return trace
    if begun and (name == "cb" and "importlib" in file or file.endswith("threading.py") and name == "_shutdown"):
        interrupted(f"{{name}}, {{len(told)}}")

def tell():
    if os.getpid() == us:
        sys.settrace(None)
        json.dump(told, open(os.path.join({folder!r}, "told"), "w"))

atexit.register(tell)
signal.signal(signal.SIGINT, signal.default_int_handler)
sys.argv = {argv}
sys.meta_path.insert(0, Finder())
sys.settrace(trace)
try:
    {start}
except SystemExit as error:
    if os.getpid() != us:       # as `main` leaves where nothing but Python has begun it
        sys.stderr.flush()
        os._exit(error.code)
    raise
"""


def starts():
    """How the command line is started: as the module, and as the console script of the project."""
    scripts = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["scripts"]
    module, _, function = scripts["vibcli"].partition(":")
    return {"module": "import runpy; runpy.run_module('vibcli', run_name='__main__', alter_sys=True)",
            "script": f"from {module} import {function}; sys.exit({function}())"}


@pytest.mark.sweep
@pytest.mark.skipif(not hasattr(os, "fork"), reason="a process is copied at each step")
@pytest.mark.parametrize(("how", "args"), [("module", ["equations", "no.yaml"]), ("script", ["--help"])])
def test_an_interrupt_at_any_import_and_at_each_step_of_the_first_and_last_moments(how, args, tmp_path):
    lines = (ROOT / "vibcli" / "__main__.py").read_text().split("\n")
    code = STEPS.format(first=lines.index("    try:") + 2, folder=str(tmp_path), argv=["vibcli", *args],
                        start=starts()[how])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert (done.returncode, "no.yaml" in done.stderr) == ((2, True) if how == "module" else (0, False))
    told = {place: (code, err.strip()) for place, (code, err) in json.loads((tmp_path / "told").read_text()).items()}
    silent = [place for place, (_, err) in told.items() if not err]
    assert {one: found for one, found in told.items() if found not in [
        (130, "interrupted"), (-signal.SIGINT, "interrupted"), (-signal.SIGINT, "")]} == {}
    assert silent and all(place.startswith(("main", "_shutdown")) for place in silent)
    assert {f"import of {name}" for name in ("vibcli.cli", "click", "vibcli.base.errors", "vibcli.cli.streams")} < {
        *told} and any(place.startswith("cb") for place in told)


def test_an_interrupt_in_the_making_of_a_class_is_no_fault():
    class Named:
        def __set_name__(self, owner, name):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        try:
            type("Owner", (), {"named": Named()})
        except RuntimeError as error:       # of Python 3.11, made of the interrupt
            fault(error)


def test_an_interrupt_while_a_file_is_written_leaves_it_whole_or_away(tmp_path):
    path = tmp_path / "out.txt"
    found = set()
    for place in at_each_step(lambda: write_whole(path, b"whole"), ("base/output_files.py",)):
        there = list(tmp_path.iterdir())
        assert there in ([], [path]), place
        for one in there:
            assert one.read_bytes() == b"whole"
            one.unlink()
        found.add(len(there))
    assert found == {0, 1}
