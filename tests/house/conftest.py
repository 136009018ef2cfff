"""The house, and houses of few files in which a rule of the house is broken."""

import pytest

from house.measure import House


@pytest.fixture(scope="session")
def house():
    return House()


@pytest.fixture
def planted(tmp_path):
    """A house of few files: {path: text}."""
    def build(files):
        package = tmp_path / "vibcli"
        for name, text in {"__init__.py": "", **files}.items():
            path = package / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return House(package)
    return build
