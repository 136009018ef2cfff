"""What a command imports, by a process of its own and sys.modules."""

import json
import subprocess
import sys
from functools import cache

HEAVY = ("numpy", "scipy", "sympy", "matplotlib", "mpmath")
RUN = """
import json, sys
from vibcli.cli.program import run
code = run(sys.argv[1:])
sys.stdout.flush()
print(json.dumps([code, sorted(sys.modules)]), file=sys.stderr)
"""


@cache
def imported(*args):
    """(exit code, modules imported) of one command in a process of its own."""
    done = subprocess.run([sys.executable, "-c", RUN, *map(str, args)], capture_output=True, text=True, timeout=60)
    code, names = json.loads(done.stderr.splitlines()[-1])
    return code, frozenset(names)


def modules(*args):
    """(exit code, heavy packages imported) of one command in a process of its own."""
    code, names = imported(*args)
    return code, {name.partition(".")[0] for name in names} & set(HEAVY)
