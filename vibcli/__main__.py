"""What `vibcli` and `python -m vibcli` run. Nothing is imported before an interrupt is provided for."""

import gc
import sys

YOUNG = 100_000     # objects between searches for garbage: what is imported and read is none, and searching it is slow


def main():
    """Run the command line and leave with its exit code; 130 where it is interrupted, while importing too."""
    gc.set_threshold(YOUNG)
    try:
        from vibcli.cli.program import run
        from vibcli.cli.streams import provide

        provide()
        code = run()
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        code = 130
    gc.freeze()         # what is left goes with the process: no search
    sys.exit(code)


if __name__ == "__main__":
    main()
