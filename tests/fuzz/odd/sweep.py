"""Many random scenes, answered twice: python tests/fuzz/odd/sweep.py --count 2000 --seed 1 -o folder

Prints how many agree, every refusal of the program with its count, and every disagreement, whose scene is saved.
"""

import argparse
import re
import sys
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

if __package__ in (None, ""):
    sys.path[0:0] = [str(Path(__file__).parents[2]), str(Path(__file__).parents[3])]

from fuzz.odd import other_doors
from fuzz.odd.compare import compared
from fuzz.odd.coverage import ASKED, Catalogue
from fuzz.odd.doors import Refusal
from fuzz.odd.draw import drawn

LAST = 400      # seed that is looked at for what no scene held


class Sweep:
    """Scenes by seed: how many were drawn and compared, what was refused, what disagrees."""

    def __init__(self, folder):
        self.folder, self.drawn, self.numbers = Path(folder), 0, 0
        self.catalogue = Catalogue()
        self.expected = self.catalogue.kinds | ASKED | {f"door {door}" for door in other_doors.ALL}
        self.refusals, self.holding, self.disagreements = Counter(), Counter(), []

    def scene(self, seed):
        """One scene; what it holds is counted where it was answered."""
        self.drawn += 1
        draft = drawn(seed)
        path = self.folder / f"scene_{seed}.yaml"
        draft.write(path)
        try:
            found = compared(draft, path, seed)
        except Refusal as refusal:
            self.refusals[sentence(refusal)] += 1
            if refusal.code == 101:
                self.disagreements.append((seed, [sentence(refusal)]))
            return
        except (ArithmeticError, LookupError, TypeError, ValueError) as error:
            self.disagreements.append((seed, [f"not understood, here or there: {error!r}"]))
            return
        self.numbers += found.compared
        self.refusals.update(f"(in part) {sentence(refusal)}" for refusal in found.refusals)
        self.holding.update(self.catalogue.of_scene(found.text) + found.kinds)
        if found.differences:
            self.disagreements.append((seed, found.differences))

    @property
    def never(self):
        """What the language has and no answered scene held, and what was not compared."""
        return self.expected - set(self.holding)

    def representative(self, count, most, spared=frozenset()):
        """Scenes of the first seeds; then, up to a number of all, each time that which holds most of what none before
        does, and others until all that is asked was compared, but for what is spared."""
        for seed in range(1, count + 1):
            self.scene(seed)
        held = {seed: set(self.catalogue.of_scene(drawn(seed).text())) for seed in range(count + 1, LAST + 1)}
        while held and self.drawn < most and (missing := self.never - spared):
            seed = max(held, key=lambda seed: len(held[seed] & missing))
            if not held[seed] & missing:
                if not missing - self.catalogue.kinds:
                    break
                seed = next(iter(held))
            del held[seed]
            self.scene(seed)

    @property
    def refused(self):
        """The share of scenes that were refused as a whole."""
        whole = sum(n for words, n in self.refusals.items() if not words.startswith("(in part)"))
        return whole / max(1, self.drawn)


def sentence(refusal):
    """The sentence of a refusal without file, names and numbers."""
    first = refusal.message.strip().split("\n")[0]
    first = re.sub(r"^.*?error: ", "", first)
    return re.sub(r"-?\d[\d.e+-]*", "#", re.sub(r"'[^']*'", "'…'", first))


def report(sweep):
    print(f"{sweep.drawn} scenes drawn, {sweep.drawn - round(sweep.refused * sweep.drawn)} answered, "
          f"{sweep.numbers} numbers compared, {100 * sweep.refused:.1f} % refused")
    print("answered scenes hold", ", ".join(f"{n} {words}" for words, n in sweep.holding.most_common()))
    print("never held or compared:", ", ".join(sorted(sweep.never)) or "nothing")
    for words, n in sweep.refusals.most_common():
        print(f"refused {n:5}  {words}")
    for seed, differences in sweep.disagreements:
        print(f"DISAGREES seed {seed}")
        for difference in differences[:4]:
            print("    ", difference if isinstance(difference, str) else
                  f"{difference.what}: expected {difference.expected!s}, found {difference.found!s}")


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("--count", type=int, default=200)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("-o", dest="folder", help="where scenes that disagree are saved")
    given = words.parse_args()
    with TemporaryDirectory() as scratch:
        sweep = Sweep(scratch)
        for seed in range(given.seed, given.seed + given.count):
            before = len(sweep.disagreements)
            sweep.scene(seed)
            path = Path(scratch) / f"scene_{seed}.yaml"
            if given.folder and len(sweep.disagreements) > before:
                Path(given.folder).mkdir(parents=True, exist_ok=True)
                (Path(given.folder) / path.name).write_bytes(path.read_bytes())
            path.unlink()
    report(sweep)
    return bool(sweep.disagreements)


if __name__ == "__main__":
    sys.exit(main())
