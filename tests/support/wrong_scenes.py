"""Wrong scenes with what must be said of them, as their first comments tell, and the diagnostics of a printed text.

    # exit 3                        or: # exit 4 check, where the command is not `solve`
    # 7:12: message | hint          one line for each diagnostic; "-" for the place means the file as a whole
"""

import re
from pathlib import Path

BAD = sorted((Path(__file__).parents[1] / "bad").glob("*.yaml"))
PLACE = re.compile(r"# (\d+:\d+|-): (.*)")
SHOWN = re.compile(r"(?:(?P<place>\d+:\d+): |: )?error: (?P<message>.*)")


def expected(path):
    """(exit code, command, [(place, message, hint)]) as written at the top of a file."""
    first, *rest = path.read_text(encoding="utf-8").split("\n")
    code, command = re.fullmatch(r"# exit (\d)( \w+)?", first).groups()
    found = []
    for line in rest:
        match = PLACE.fullmatch(line)
        if not match:
            break
        message, _, hint = match[2].partition(" | ")
        found.append((match[1], message, hint))
    return int(code), (command or " solve").strip(), found


def diagnostics(text, file):
    """[(place, message, hint, source line, column of the caret)] of what was printed."""
    found = []
    for line in text.rstrip("\n").split("\n"):
        if line.startswith(file + ":"):
            match = SHOWN.fullmatch(line[len(file):].removeprefix(":").removeprefix(" "))
            found.append([match["place"] or "-", match["message"], "", "", None])
        elif line.startswith("hint: "):
            found[-1][2] = line[6:]
        elif line.startswith("  ") and set(line.strip()) == {"^"}:
            found[-1][4] = line.index("^") - 2
        elif line.startswith("  "):
            found[-1][3] = line[2:]
        else:
            assert re.fullmatch(r"\d+ errors", line), line
    return found
