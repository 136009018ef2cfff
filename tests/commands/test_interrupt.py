"""An interrupt leaves in one line and with 130, even while modules are being imported."""

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SCENE = ROOT / "vibcli" / "examples" / "free_vibration.yaml"
INTERRUPTED = """
import sys

class Interrupts:
    def find_spec(self, name, path=None, target=None):
        if name == {name!r}:
            raise KeyboardInterrupt

sys.meta_path.insert(0, Interrupts())
sys.argv = ["vibcli", "check", {file!r}]
{start}
"""


def starts():
    """How the command line is started: as the module, and as the console script of the project."""
    scripts = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["scripts"]
    module, _, function = scripts["vibcli"].partition(":")
    return {"module": "import runpy; runpy.run_module('vibcli', run_name='__main__', alter_sys=True)",
            "script": f"from {module} import {function}; sys.exit({function}())"}


@pytest.mark.parametrize("how", ["module", "script"])
@pytest.mark.parametrize("name", ["vibcli.cli", "click", "vibcli.base.errors", "vibcli.cli.check", "yaml", "numpy"])
def test_an_interrupt_while_importing(name, how):
    code = INTERRUPTED.format(name=name, file=str(SCENE), start=starts()[how])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert (done.returncode, done.stderr.strip()) == (130, "interrupted")
