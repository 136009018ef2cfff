"""Formats of a report, one to a file: suffixes of its files, what its pictures are, and a line for the manual.

Pictures stand within the report, or beside it in files of the suffix that is given; None: there are none. A file has
`render(documents, place)`; `place(picture)` is the name of the file that a picture beside the report is written to.
"""

WITHIN = "within"
FORMATS = {
    "text": ((".txt",), None, "as in the terminal"),
    "markdown": ((".md", ".markdown"), ".svg", "Markdown with formulas between dollar signs"),
    "latex": ((".tex",), ".pdf", "a LaTeX document of its own"),
    "asciidoc": ((".adoc", ".asciidoc"), ".svg", "AsciiDoc with formulas as `stem`, in LaTeX"),
    "typst": ((".typ",), ".svg", "a Typst document of its own"),
    "html": ((".html", ".htm"), WITHIN, "a page complete in itself, its formulas in MathML"),
}
