"""Which tests go to one process where several share them (pytest-xdist): those of a file, so that what it sets up is
set up once; those of all files that keep what they solve (`kept_…` of support), so that each problem is solved once;
those of the house, which is read once; and those of files that fork, first of all, while there is little that each fork
copies. Where there are many processes the problems are dealt out to some of them.
"""

import re
from functools import cache
from pathlib import Path
from zlib import crc32

from xdist.scheduler import LoadScopeScheduling

ROOT = Path(__file__).parents[2]
PER_PART = 3        # processes
KEPT = {"variants": "kept_variants_of", "problems": "kept_(problem|settled|instances|drawing)_of"}  # {name: keeper}
FORKS, FORKING = "forks", r"\bos\.fork\(|\bProcesses\(|\"--jobs\""


@cache
def _shared(file):
    """What the tests of a file keep for others, or that they fork, or None."""
    text = (ROOT / file).read_text(encoding="utf-8")
    kept = next((name for name, keeper in KEPT.items() if re.search(rf"\b{keeper}\(", text)), None)
    return kept or (FORKS if re.search(FORKING, text) else None)


def unit_of(nodeid, parts=1):
    """The name of what a test is done together with; `parts`: how many the solved problems are divided into."""
    file, _, test = nodeid.partition("::")
    shared = _shared(file)
    if shared in KEPT:
        case = test.partition("[")[2].rstrip("]").partition("-")[0]
        return f"{shared} {crc32(case.encode()) % parts}"
    if shared:
        return shared
    return "house" if file.startswith("tests/house/") else file


class Together(LoadScopeScheduling):
    def _split_scope(self, nodeid):
        return unit_of(nodeid, max(1, self.numnodes // PER_PART))

    def _assign_work_unit(self, node):
        if FORKS in self.workqueue:
            self.workqueue.move_to_end(FORKS, last=False)
        super()._assign_work_unit(node)
