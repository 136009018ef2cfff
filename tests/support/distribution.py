"""Which tests go to one process where several share them (pytest-xdist): those of a file, so that what it sets up is
set up once; those of all files that keep what they solve (`kept_…` of support), so that each problem is solved once;
and those of the house, which is read once. Where there are many processes the problems are dealt out to some of them.
"""

import re
from functools import cache
from pathlib import Path
from zlib import crc32

from xdist.scheduler import LoadScopeScheduling

ROOT = Path(__file__).parents[2]
PER_PART = 3        # processes
KEPT = {"variants": "kept_variants_of", "problems": "kept_(problem|settled|instances|drawing)_of"}  # {name: keeper}


@cache
def _kept(file):
    """What the tests of a file keep for others, or None."""
    text = (ROOT / file).read_text(encoding="utf-8")
    return next((name for name, keeper in KEPT.items() if re.search(rf"\b{keeper}\(", text)), None)


def unit_of(nodeid, parts=1):
    """The name of what a test is done together with; `parts`: how many the solved problems are divided into."""
    file, _, test = nodeid.partition("::")
    if kept := _kept(file):
        case = test.partition("[")[2].rstrip("]").partition("-")[0]
        return f"{kept} {crc32(case.encode()) % parts}"
    return "house" if file.startswith("tests/house/") else file


class Together(LoadScopeScheduling):
    def _split_scope(self, nodeid):
        return unit_of(nodeid, max(1, self.numnodes // PER_PART))
