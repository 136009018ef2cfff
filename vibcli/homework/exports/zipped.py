"""Packages as zip files, the same bytes from the same files."""

import io
from collections.abc import Mapping
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

NO_DATE = 1980, 1, 1, 0, 0, 0       # the first that a zip file can tell


def zipped(files: Mapping[str, bytes]) -> bytes:
    """{path: bytes} as one zip file, in this order."""
    found = io.BytesIO()
    with ZipFile(found, "w") as package:
        for path, data in files.items():
            package.writestr(ZipInfo(path, NO_DATE), data, ZIP_DEFLATED)
    return found.getvalue()
