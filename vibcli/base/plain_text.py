"""Texts of a file or a file name, without what could steer a terminal or a reader: controls, bidirectional marks."""

import re

from vibcli.base.decoding import FORBIDDEN, STAND_IN


def cleaned(text):
    """The text with a stand-in for every control, bidirectional and invisible character; lines stay."""
    return FORBIDDEN.sub(STAND_IN, text).replace("\r", STAND_IN)


def on_one_line(text):
    """The same with its white space as single spaces."""
    return re.sub(r"\s+", " ", cleaned(text))
