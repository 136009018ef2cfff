"""Names of letters and their commands in LaTeX."""

from vibcli.notation.plain import GREEK

COMMANDS = {"phi": "varphi", "epsilon": "varepsilon"}
NAMES = {letter: name for name, letter in GREEK.items()}
