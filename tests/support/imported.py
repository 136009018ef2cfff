"""What a command imports, by a process of its own and sys.modules."""

import atexit
import json
import os
import subprocess
import sys
from functools import cache

HEAVY = ("numpy", "scipy", "sympy", "matplotlib", "mpmath")
# each command in a child of a process that has imported what all begin with
RUN = """
import json, os, sys
from vibcli.cli.program import run
for line in sys.stdin:
    if not (child := os.fork()):
        told = os.dup(1)
        for stream in (1, 2):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
        folder, args = json.loads(line)
        os.chdir(folder)
        code = run(args)
        sys.stdout.flush()
        os.write(told, json.dumps([code, sorted(sys.modules)]).encode())
        os._exit(0)
    os.waitpid(child, 0)
    os.write(1, bytes([10]))
"""


@cache
def _begun():
    """The process that each command begins with; it ends with this one."""
    process = subprocess.Popen([sys.executable, "-c", RUN], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(process.communicate)
    return process


@cache
def imported(*args):
    """(exit code, modules imported) of one command in a process of its own."""
    print(json.dumps([os.getcwd(), list(map(str, args))]), file=_begun().stdin, flush=True)
    code, names = json.loads(_begun().stdout.readline())
    return code, frozenset(names)


def modules(*args):
    """(exit code, heavy packages imported) of one command in a process of its own."""
    code, names = imported(*args)
    return code, {name.partition(".")[0] for name in names} & set(HEAVY)
