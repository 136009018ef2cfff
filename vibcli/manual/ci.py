"""The page of the manual on problem sets that are checked by CI servers. Data alone."""

from vibcli.base.rules import RULES

CI = [
    "`vibcli check problems` compares the `answers` of all scenes in a folder with what they give, and ends with the "
    "exit code of the gravest verdict (`vibcli explain exit`). `--format` says how it is told, `-o report.xml` writes "
    "it to a file as well, whatever the exit code:",
    [
        ("full", "file by file, every answer with its mark; under GitHub Actions annotations below it, by themselves"),
        ("concise", "a line for each thing that is wrong: file:line:column: rule: message"),
        ("json", "`--json` in short: of each file its `exit_code`, its `answers`, each with its `rule` (null where it "
         "agrees), and its `diagnostics`: what keeps it from being checked, with rule, hint and place"),
        ("junit", "XML (`.xml`) that CI servers show: a suite for each file, a case for each answer"),
        ("github", "annotations: each thing that is wrong on its line of the change"),
        ("sarif", "SARIF 2.1.0 (`.sarif`) for code scanning"),
    ],
    "What is wrong has a rule, the same in every form:",
    list(RULES.items()),
    [
        ("--jobs N", "N files at a time; the order and the bytes are those of one job"),
        ("--max-failures N", "stops where so many answers or files fail"),
        ("--changed-since REV", "only scenes that differ from a revision of git, are new, or name a record beside them "
         "that does"),
        ("-", "reads a scene from stdin; `--stdin-name FILE` names it"),
        ("--no-cache", "checks all anew: results are kept in `.vibcli_cache` beside the first path, which git ignores "
         "(`--cache-dir` names another folder), and hold as long as the file, its records, the options, the program's "
         "own sources and the versions of Python, NumPy, SciPy, SymPy, mpmath and PyYAML are the same. Where others "
         "may write that folder they may write results: use `--no-cache` there, or VIBCLI_NO_CACHE=1."),
    ],
    "With pytest, where the extra `pytest` is installed and `vibcli = true` stands in its configuration (`pytest.ini` "
    "under `[pytest]`, `pyproject.toml` under `[tool.pytest.ini_options]`), each answer of each scene is a test. With "
    "pre-commit, the hook `vibcli-check` of this repository checks the scenes of a commit; `files: ^problems/` names "
    "where they are, if other YAML files stand beside them. Hidden files and folders, such as `.github`, are passed "
    "over by all of these. On servers (VIBCLI: where it is installed from, a folder or git+https://…):",
]

GITHUB = """\
name: problems
on: [push, pull_request]
jobs:
  check:
    runs-on: ubuntu-latest
    env: {VIBCLI: ./vibcli}
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-python@v5
        with: {python-version: "3.12"}
      - uses: actions/cache@v4
        with: {path: .vibcli_cache, key: "v-${{ github.sha }}", restore-keys: v-}
      - run: pip install "$VIBCLI"
      - run: vibcli check problems --jobs 2
"""
GITLAB = """\
problems:
  image: python:3.12
  variables: {VIBCLI: ./vibcli}
  cache: {paths: [.vibcli_cache]}
  script:
    - pip install "$VIBCLI"
    - vibcli check problems --jobs 2 --format junit -o report.xml
  artifacts:
    when: always
    reports: {junit: report.xml}
"""
WORKFLOWS = {"`.github/workflows/problems.yml`:": GITHUB, "`.gitlab-ci.yml`:": GITLAB}
