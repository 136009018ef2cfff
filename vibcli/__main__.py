"""`python -m vibcli` is `vibcli`."""

from vibcli.cli import main

if __name__ == "__main__":
    main()
