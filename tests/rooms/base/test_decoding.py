"""What a text may not hold, by the list of characters and by the quick look that spares it."""

import sys

import pytest

from vibcli.base.decoding import decode, forbidden, prints


@pytest.mark.sweep
def test_every_character_that_is_forbidden_does_not_print():
    for number in range(sys.maxunicode + 1):
        assert not (forbidden().match(chr(number)) and prints(chr(number))), hex(number)
    assert prints("a: 1\n\tb: 'αφ — µ·²'\r\n")


def test_texts_that_print_compile_no_list():
    forbidden.cache_clear()
    assert decode("k: 3 N/m   # ω₀²\r\n".encode(), "f") == ("k: 3 N/m   # ω₀²\r\n", [])
    assert forbidden.cache_info().misses == 0
    text, problems = decode("k: 3\u200b".encode(), "f")
    assert text == "k: 3\ufffd" and [each.message for each in problems] == ["found the invisible character U+200B"]
