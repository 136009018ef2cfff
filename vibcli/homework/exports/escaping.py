"""Texts as they stand in XML, the same when they are read back."""

from html import escape
from urllib.parse import quote


def cdata(text: str) -> str:
    """A text in a section without markup, divided where it holds the end of one."""
    return "<![CDATA[" + text.replace("]]>", "]]]]><![CDATA[>") + "]]>"


def attribute(text: str) -> str:
    """A text in an element, or in an attribute between double quotes, on one line."""
    return escape(" ".join(text.split()))


def address(path: str) -> str:
    """The path of a file as the address of a link, in an attribute."""
    return escape(quote(path, safe="/"))
