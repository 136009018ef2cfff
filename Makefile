# make solve: install into .venv and solve a problem.  make quick: tests without sweeps over many scenes, in under four minutes.
# make test: everything that must hold, as CI runs it.  make lint: style and types.  make bench: speed and error.
PYTHON ?= python3
BIN := .venv/bin
PROBLEM ?= problems/6_two_degrees/cart_with_pendulum.yaml

.PHONY: solve quick test lint bench clean

$(BIN)/vibcli: pyproject.toml
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e .
	$(BIN)/python -m compileall -q vibcli
	@touch $@

$(BIN)/pytest: pyproject.toml $(BIN)/vibcli
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[test]"
	@touch $@

solve: $(BIN)/vibcli
	$(BIN)/vibcli solve $(PROBLEM)

lint: $(BIN)/pytest
	$(BIN)/ruff check vibcli tests
	$(BIN)/mypy

quick: lint
	$(BIN)/pytest -q -n 2 -m "not sweep"

test: lint
	$(BIN)/pytest -q -n 2
	$(BIN)/vibcli check --quiet --jobs 2 problems

bench: $(BIN)/vibcli
	-$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[bench]"
	$(BIN)/python -m vibcli.bench

clean:
	rm -rf .venv build *.egg-info
