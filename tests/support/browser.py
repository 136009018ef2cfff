"""A headless Chromium, where there is one: nothing that it does leaves this machine."""

import re
import subprocess
from shutil import which

import pytest

BROWSER = next(filter(None, map(which, ("chromium", "chromium-browser", "google-chrome"))), None)
NEEDED = pytest.mark.skipif(BROWSER is None, reason="no Chromium here")
QUIET = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync")


def dom(address, profile, *options):
    """The document as it stands when it is loaded."""
    return subprocess.run([BROWSER, *QUIET, f"--user-data-dir={profile}", *options, "--dump-dom", address],
                          capture_output=True, text=True, timeout=120).stdout


def measured(page, folder, script, *options):
    """The number that a script finds on a page, which forbids scripts elsewhere."""
    page = re.sub('<meta http-equiv="Content-Security-Policy"[^>]*>', "", page)
    script = f"document.fonts.ready.then(() => {{ document.body.textContent = 'found ' + ({script}) + ' so'; }})"
    (folder / "page.html").write_text(page.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    shown = dom((folder / "page.html").as_uri(), folder / "profile", "--virtual-time-budget=5000", *options)
    return float(re.search(r"found (\S+) so", shown)[1])


def picture(page, folder, *options):
    """The dark dots of a page: an array of truth values, a row a line of dots."""
    import numpy as np
    from PIL import Image

    (folder / "page.html").write_text(page, encoding="utf-8")
    shown = folder / "page.png"
    subprocess.run([BROWSER, *QUIET, f"--user-data-dir={folder}/profile", f"--screenshot={shown}", "--hide-scrollbars",
                    *options, (folder / "page.html").as_uri()], capture_output=True, timeout=120)
    return np.asarray(Image.open(shown).convert("L")) < 128
