"""The built-in manual, generated from the declarations that the reading of scenes runs on.

`page(word)` and `overview()` are the pages of `vibcli explain`, `words()` all that can be looked up, and
`schema()` is the JSON Schema of scene files.
"""

from vibcli.manual.index import nearest_words, page, words
from vibcli.manual.json_schema import schema
from vibcli.manual.overview import overview

__all__ = ["nearest_words", "overview", "page", "schema", "words"]
