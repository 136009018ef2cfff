"""`vibcli bench` of every problem that is shipped: `python -m vibcli.bench.shipped FOLDER [FILE …]`.

Of each the processor time, by how many digits the reference of a quantity goes beyond the best method, and what was not
compared; one line of JSON a file in FOLDER/shipped.json, which a run that was interrupted goes on with, then a summary.
"""

import json
import math
import sys
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from subprocess import run
from typing import Any

MOST, FULL = 60.0, 180.0        # s of processor time, where a full motion is compared
BEYOND = 8                      # digits
ROUNDED = 2.0**-53              # relative: a float is no better than this, whatever its error happens to be
SLOWEST = 10


def measured(file: Path) -> dict[str, Any]:
    """A file's entry."""
    before = getrusage(RUSAGE_CHILDREN)
    done = run([sys.executable, "-m", "vibcli", "bench", str(file), "--json"], capture_output=True, text=True)
    after = getrusage(RUSAGE_CHILDREN)
    found = json.loads(done.stdout) if done.stdout.startswith("{") else {"compared": [], "not compared": []}
    return {"file": "/".join(file.parts[-2:]), "code": done.returncode, "error": done.stderr.strip()[-200:],
            "seconds": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 2),
            "full": any(one["kind"] == "full motion" for one in found["compared"]),
            "beyond": {one["asked"]: beyond(one) for one in found["compared"]},
            "not compared": {one["asked"]: one["why"] for one in found["not compared"]}}


def beyond(one: dict[str, Any]) -> float:
    """How many digits a reference has that the best method has not."""
    best = min((point["error"] for point in one["points"] if point["error"] is not None), default=1.0)
    digits: float = round(one["reference"]["digits"] + math.log10(max(best, ROUNDED)), 1)
    return digits


def summary(found: Sequence[dict[str, Any]]) -> list[str]:
    """What is told of all files."""
    slow = sorted(found, key=lambda one: -one["seconds"])
    late = [one for one in found if one["seconds"] > (FULL if one["full"] else MOST)]
    near = [(digits, one["file"], asked) for one in found for asked, digits in one["beyond"].items() if digits < BEYOND]
    reasons = Counter(why for one in found for why in one["not compared"].values())
    return [f"{len(found)} files, {sum(len(one['beyond']) for one in found)} quantities compared, {len(late)} over "
            f"{MOST:.0f} s ({FULL:.0f} s with a full motion), {len(near)} references less than {BEYOND} digits beyond",
            *(f"slowest: {one['seconds']:7.2f} s  {one['file']}" for one in slow[:SLOWEST]),
            *(f"near: {digits} digits  {file}  {asked}" for digits, file, asked in sorted(near)),
            *(f"code {one['code']}: {one['file']}: {one['error']}" for one in found if one["code"] not in (0, 4)),
            *(f"not compared: {count:4d}  {why}" for why, count in reasons.most_common())]


def main(folder: str, files: Iterable[str]) -> None:
    """Measure what is not kept yet, and tell of all."""
    kept = Path(folder) / "shipped.json"
    found = [json.loads(line) for line in kept.read_text().splitlines()] if kept.exists() else []
    known = {one["file"] for one in found}
    wanted = list(map(Path, files)) or sorted(Path("problems").glob("[0-9]*/*.yaml"))
    with kept.open("a") as lines:
        for file in wanted:
            if "/".join(file.parts[-2:]) not in known:
                found.append(measured(file))
                print(json.dumps(found[-1]), file=lines, flush=True)
    print("\n".join(summary(found)))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
