"""What `--insight` prints."""

import pytest

from vibcli.report.sections.insight import off


@pytest.mark.parametrize(("share", "text"), [
    (1.099, "+9.9 %"), (0.77, "−23 %"), (2.2, "+120 %"), (96.3, "+9500 %"), (1.996, "+100 %"), (1 + 4.01e-7, "+4e-5 %"),
    (1 - 9.83e-9, "−9.8e-7 %"), (1.0, "0 %")])
def test_how_far_an_estimate_is_off(share, text):
    assert off(share * 3.0, 3.0) == text
