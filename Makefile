# `make demo` and `make test` set everything up by themselves; they need Python 3.11 or newer, make and the package index.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP = $(BIN)/python -m pip --disable-pip-version-check install -c constraints.txt
PROMPT ?= A calm bedroom, 4 m by 5 m, with a double bed against the long wall, two nightstands with a lamp on each, a wardrobe, and a small desk with a chair by the window.

# Bytecode is kept even where the shell says otherwise: the tests start hundreds of interpreters.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test slow lint types bench pictures schemas constraints clean

demo: $(VENV)/installed
	$(BIN)/thinkblox generate "$(PROMPT)" --out out/demo --overwrite

test: lint types
	$(BIN)/python -m pytest -n auto -m "not slow"

slow: $(VENV)/installed-dev
	$(BIN)/python -m pytest -n auto -m slow

lint: $(VENV)/installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports --no-logo

types: $(VENV)/installed-dev
	$(BIN)/mypy

bench: $(VENV)/installed
	$(BIN)/python -m tests.bench.rooms
	$(BIN)/python -m tests.bench.startup
	$(BIN)/python -m tests.bench.verdicts
	$(BIN)/python -m tests.bench.pool
	$(BIN)/python -m tests.bench.suites

# Every picture of docs/pictures.
pictures: $(VENV)/installed
	$(BIN)/python -m tests.bench.gallery

# The published schemas in docs/schema; a test holds them against the code.
schemas: $(VENV)/installed
	mkdir -p docs/schema
	for name in $$($(BIN)/thinkblox schema); do $(BIN)/thinkblox schema $$name > docs/schema/$$name.schema.json; done

# What `make demo` needs: the package and what it runs on, nothing else.
$(VENV)/installed: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed; call make with PYTHON=...")'
	@echo "Setting up $(VENV), once: about 120 MB to download, 560 MB on disk, a minute or two."
	@$(PYTHON) -m venv $(VENV)
	$(PIP) setuptools
	$(PIP) --no-build-isolation -e .
	@touch $@

# The tools of development besides: tests, linters, types.
$(VENV)/installed-dev: $(VENV)/installed
	@echo "Adding the tools of development and what models need, once: about 500 MB to download, two minutes."
	$(PIP) "torch==2.13.0"
	$(PIP) --no-build-isolation -e ".[dev]"
	@touch $@

# Resolve every dependency anew and pin what comes out.
constraints:
	$(PYTHON) -m venv out/resolve
	out/resolve/bin/python -m pip install --quiet --upgrade "torch==2.13.0" setuptools ".[dev]"
	out/resolve/bin/python -m pip freeze --all --exclude thinkblox --exclude pip > constraints.txt

clean:
	rm -rf $(VENV) out build dist *.egg-info
