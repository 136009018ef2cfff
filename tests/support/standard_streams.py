"""Commands whose standard streams are full, closed or read by nobody: each in a child of one process that has imported
what they need, and that is small, so that each child copies little."""

import json
import os
import subprocess
import sys
from contextlib import chdir, contextmanager, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

TESTS = Path(__file__).parents[1]


@contextmanager
def imported(runs):
    """call(folder, arguments, how stdout is, how stderr is) -> exit code, once each of `runs` [(folder, arguments)] has
    been run, which succeed."""
    code = f"import sys; sys.path.insert(0, {str(TESTS)!r}); from support.standard_streams import serve; serve()"
    process = subprocess.Popen([sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                               cwd=TESTS.parent)

    def told(*request):
        print(json.dumps(request), file=process.stdin, flush=True)
        return json.loads(process.stdout.readline())

    try:
        assert told([[str(folder), args] for folder, args in runs]) == 0
        yield lambda folder, args, *hows: told(str(folder), args, hows)
    finally:
        process.communicate()


def serve():
    """Import what the runs of the first line need; then run what each further line asks for in a child."""
    from vibcli.cli.program import run
    from vibcli.homework import paper

    paper.find_spec = lambda name: None         # a compiler with threads does not survive a fork: pages do
    runs, = json.loads(sys.stdin.readline())
    with redirect_stdout(StringIO()), redirect_stderr(StringIO()):
        codes = [_run_in(run, folder, args) for folder, args in runs]
    print(max(codes), flush=True)
    for request in sys.stdin:
        folder, args, hows = json.loads(request)
        if not (child := os.fork()):
            _in_child(run, folder, args, hows)
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)


def _run_in(run, folder, args):
    with chdir(folder):
        return run(args)


def _in_child(run, folder, args, hows):
    from vibcli.cli import streams

    code = 99
    try:
        os.chdir(folder)
        for number, (how, file) in enumerate(zip(hows, ("out.txt", "err.txt"), strict=True), 1):
            _put(number, how, file)
        streams.provide()
        code = run(args)
        sys.stdout.flush()
    finally:
        os._exit(code)


def _put(number, how, file):
    """Let a standard stream of this process be a file, full, closed, or a pipe that nobody reads."""
    os.close(number)
    name = ("stdout", "stderr")[number - 1]
    if how == "closed":
        setattr(sys, name, None)
        return
    if how == "left":
        reader, writer = os.pipe()
        os.close(reader if reader != number else os.dup2(writer, number))
        os.dup2(writer, number)
    else:
        opened = os.open("/dev/full" if how == "full" else file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
        os.dup2(opened, number)
    setattr(sys, name, os.fdopen(number, "w", closefd=False))
