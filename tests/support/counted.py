"""What answering a scene counts, exactly and the same at every run: calls of what is dear, expressions, modules.

Each scene is answered by `check` in a process of its own, whose calls are looked at; what is counted is told by the
names of functions, so that nothing is counted where nothing asks.
"""

import json
import os
import subprocess
import sys
from collections.abc import Mapping

CALLS = {       # {what is counted: {file, from the package or library on: its functions}}
    "force evaluations": {"vibcli/mechanics/numeric_equations.py": ("accelerations", "solved"),
                          "vibcli/mechanics/compiled_statics.py": ("at",),       # the first ones by `in_numbers` too
                          "vibcli/mechanics/numeric_linearisation.py": ("in_numbers",)},
    "Newton's methods": {"vibcli/mechanics/high_precision.py": ("_newton_step",),
                         "vibcli/mechanics/equilibrium/energy_descent.py": ("newton",),
                         "vibcli/numerics/newton_systems.py": ("newton",),
                         "vibcli/analyses/time_integration/collocation_step.py": ("newton",)},
    "factorisations": {"numpy/linalg/_linalg.py": (
        "cholesky", "eig", "eigh", "eigvals", "eigvalsh", "inv", "lstsq", "qr", "solve", "svd")},
}
KERNELS = "Nehalem"         # of OpenBLAS: how often a search looks hangs on last digits, and these on the processor
IN_A_PROCESS = """
import contextlib, io, json, sys
calls, names, found = json.loads(sys.argv[2]), {}, {}
for what, files in calls.items():
    for file, functions in files.items():
        for function in functions:
            names[function] = names.get(function, []) + [(file, what)]
found = dict.fromkeys(calls, 0)
nodes = 0

def looked(frame, event, _):
    global nodes
    if event == "call":
        code = frame.f_code
        for file, what in names.get(code.co_name, ()):
            if code.co_filename.replace("\\\\", "/").endswith(file):
                found[what] += 1
        if code.co_name == "_make" and code.co_filename.replace("\\\\", "/").endswith("vibcli/symbolic/expression.py"):
            nodes += 1

from vibcli.cli.program import run
exec(sys.argv[3])
sys.setprofile(looked)
with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
    code = run(["check", "--no-cache", sys.argv[1]])
sys.setprofile(None)
found |= {"expressions made": nodes, "modules": sum(name.startswith("vibcli.") for name in sys.modules), "exit": code}
print(json.dumps(found))
"""


def counters(file: str, planted: str = "") -> dict[str, int]:
    """{what is counted: how often} in checking a scene, with the exit code; planted: what is done before."""
    same = {"PYTHONHASHSEED": "0", "OPENBLAS_CORETYPE": KERNELS}
    done = subprocess.run([sys.executable, "-c", IN_A_PROCESS, file, json.dumps(CALLS), planted], capture_output=True,
                          text=True, check=True, env=os.environ | same)
    return json.loads(done.stdout)


def differences(before: Mapping[str, Mapping[str, int]], now: Mapping[str, Mapping[str, int]]) -> list[str]:
    """What has changed, a line for each counter of each scene; scenes of one side alone are told too."""
    found = [f"{name}: counted on one side alone" for name in sorted(before.keys() ^ now.keys())]
    for name in sorted(before.keys() & now.keys()):
        found += [f"{name}: {what} {before[name].get(what)} → {now[name].get(what)}"
                  for what in sorted(before[name].keys() | now[name].keys())
                  if before[name].get(what) != now[name].get(what)]
    return found
