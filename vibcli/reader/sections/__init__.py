"""Sections of a scene file that name quantities, one to a file."""

NAMES = {
    "answer": "expected answers, which `check` compares",
    "choose": "parameters that conditions determine",
    "find": "what `solve` prints; all that is cheap if left out",
    "variants": "values that parameters take in homework, and what is asked of each variant",
}
