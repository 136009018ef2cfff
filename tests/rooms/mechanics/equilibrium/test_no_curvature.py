"""Forces however large on what nothing holds: refused or followed without a word of what computes."""

import warnings

import pytest

from vibcli.cli.program import run


@pytest.mark.sweep
@pytest.mark.parametrize("force", ["-1e20 N", "1e50 N", "1e-50 N"])
@pytest.mark.parametrize("command", ["solve", "frequencies"])
def test_no_warning_of_arithmetic_is_printed(force, command, tmp_path):
    path = tmp_path / "pushed.yaml"
    path.write_text(f"bodies: {{a: {{mass: 3 kg, slide: x}}}}\nforces: {{f: {{at: a, force: {force}}}}}\n"
                    "initial: {x: 2 m}\nfind: [response]\n")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert run([command, str(path)]) == 4
