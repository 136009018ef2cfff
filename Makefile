# make solve: install into .venv and solve a problem.  make lint: style and types.  make bench: speed and error.
# make quick: lint and tests without sweeps: one problem a chapter, one case of each test of rooms and commands.
# make fuzz: 100,000 mutated files, expressions and scenes of each kind, which takes hours: make fuzz COUNT=1000 SEED=7.
# Then as many that atheris guides by the code they reach, where it can be installed.
# make peers: packages for course systems, read by programs that are not ours.
# make test: everything that must hold, as CI runs it; style and types are checked beside the tests.
# make test JOBS=8: in as many processes, where there are as many cores.
PYTHON ?= python3
BIN := .venv/bin
INSTALL := $(BIN)/python -m pip install --no-compile --quiet --disable-pip-version-check
COUNT ?= 100000
JOBS ?= 2
SEED ?= 1
PROBLEM ?= problems/6_two_degrees/cart_with_pendulum.yaml

export PYTHONDONTWRITEBYTECODE :=       # what is compiled is kept: commands that tests run and their own files begin with it

.PHONY: solve quick test lint chosen all peers evidence bench fuzz clean

$(BIN)/vibcli: pyproject.toml
	$(PYTHON) -m venv .venv
	$(INSTALL) -e .
	$(BIN)/python -m compileall -q vibcli
	@touch $@

$(BIN)/pytest: pyproject.toml $(BIN)/vibcli
	$(INSTALL) -e ".[test]"
	@touch $@

solve: $(BIN)/vibcli
	$(BIN)/vibcli solve $(PROBLEM)

lint: $(BIN)/pytest
	$(BIN)/ruff check vibcli tests
	$(BIN)/mypy

quick: $(BIN)/pytest
	@$(MAKE) --no-print-directory -j 2 lint chosen

test: $(BIN)/pytest
	@$(MAKE) --no-print-directory -j 2 lint all

chosen: $(BIN)/pytest
	$(BIN)/pytest -q -n $(JOBS) -m "not sweep" --ignore tests/fuzz

all: $(BIN)/pytest
	$(BIN)/pytest -q -n $(JOBS)

peers: $(BIN)/pytest
	-$(INSTALL) -e ".[peers,cluster]"
	-npm install --silent --no-fund --no-audit --prefix .venv/peers @citolab/qti-convert@0.3.52 @citolab/qti-components@7.27.4
	VIBCLI_PEERS_POOL=100 $(BIN)/pytest -q -rsP tests/peers

evidence: $(BIN)/vibcli
	$(BIN)/python -m vibcli.bench.kept

bench: $(BIN)/vibcli
	-$(INSTALL) -e ".[bench]"
	$(BIN)/python -m vibcli.bench

fuzz: $(BIN)/pytest
	-$(INSTALL) -e ".[fuzz]"
	$(BIN)/python tests/fuzz/many.py $(COUNT) $(SEED) documents expressions texts nodes scenes
	$(BIN)/python tests/fuzz/guided.py $(COUNT) $(SEED)

clean:
	rm -rf .venv build *.egg-info
