"""The built-in manual, generated from the declarations that the reading of scenes runs on.

`index.page(word)` and `overview.overview()` are the pages of `vibcli explain`, `index.words()` all that can be looked
up, and `json_schema.schema()` is the JSON Schema of scene files.
"""
