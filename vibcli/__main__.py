"""What `vibcli` and `python -m vibcli` run. Nothing is imported before an interrupt is provided for."""

import sys


def main():
    """Run the command line and leave with its exit code; 130 where it is interrupted, while importing too."""
    try:
        from vibcli.cli import run
        from vibcli.cli.streams import provide

        provide()
        code = run()
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        code = 130
    sys.exit(code)


if __name__ == "__main__":
    main()
