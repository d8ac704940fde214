# make demo      sets everything up and runs the main job: eleven Lilys shoal in a tank, recorded to runs/demo
# make test      sets everything up and runs every check
# make bench     how fast the core is, against what the machine can do
# make docs      the site of the documents, to build/site
# make prove     the sealed trial of `cocorosim diagnose`, about an hour for its 400 and more recordings
# make prove-families  the same with forms, noise, programmes and laws drawn from families
# make prove-rov       the same with another vehicle, an ROV in six degrees of freedom
# make prove-slender   the same with a third, a slender AUV whose log shows the speed over ground
# make prove-against   altered logs of real vehicles against unaltered ones; TRIAL_DATA=FOLDER says where the recordings are
# make prove-real      that, and real recordings as they are: hours
# The set-up lives in .venv alone. PYTHON=... chooses the interpreter, PYTEST_ARGS=... goes to pytest.

SHELL := /bin/sh
VENV := .venv
BIN := $(VENV)/bin
PREFIX := $(CURDIR)/$(VENV)
PYTHON ?=
PYTEST_ARGS ?=

# A ROS installation that is sourced in this shell must not mix with the one in the virtual environment.
unexport PYTHONPATH PYTHONHOME AMENT_PREFIX_PATH COLCON_PREFIX_PATH CMAKE_PREFIX_PATH LD_LIBRARY_PATH
unexport _ROS_WHEELS_BOOTSTRAP_COMPLETE VIRTUAL_ENV
export PIP_DISABLE_PIP_VERSION_CHECK := 1

# Each step of the set-up leaves a stamp that carries the digest of what it was made from.
digest = $(shell { echo $(CURDIR); find $(1) -type f ! -name '*.pyc' 2>/dev/null | LC_ALL=C sort | xargs -r sha256sum; } | sha256sum | cut -c1-16)
DEPENDENCIES := $(VENV)/.dependencies-$(call digest,requirements.lock)
MESSAGES := $(VENV)/.messages-$(call digest,msg_defs)
PACKAGE := $(VENV)/.package-$(call digest,setup.py setup.cfg package.xml config cocorosim_ros/__init__.py cocorosim_ros/graph/launch)
NUMPY1 := $(VENV)/numpy1/.installed-$(call digest,requirements-numpy1.lock)

# A Python that is asked for by name replaces another one that is there already.
VERSION_OF = $(shell { $(1) -c 'import platform; print(platform.python_version())' || echo none; } 2>/dev/null)
ifneq ($(PYTHON),)
ifneq ($(call VERSION_OF,$(PYTHON)),$(call VERSION_OF,$(BIN)/python))
.PHONY: $(DEPENDENCIES)
endif
endif

# Tests run on as many cores as PYTEST_JOBS says, a file's tests together, but for those that build or time something
# (ALONE), which take all cores. Those that start nodes, commands or documents (ROS_TESTS) run on NumPy 2 alone; all
# others in `make test` on NumPy 1.26 also, but for the longest diagnoses (WHOLE_DIAGNOSES): four fifths of the time, and
# their parts have tests of their own. `make numpy1` runs all.
ALONE := test/benchmark/ test/build/
WHOLE_DIAGNOSES := against/test_named_differences against/test_strangers test_nothing_twice test_naming test_choice \
	test_drag_forms test_water_and_surface test_errors_of_instruments test_shipped_bag test_velocity_over_ground \
	against/test_good_that_is_not_well against/test_curves_of_thrusters against/test_lengths_of_the_vehicle \
	foretelling/test_restraint test_similarity test_offset_centre against/test_axes foretelling/test_starts_and_levers \
	showing/test_untold_form test_single_thrusters test_thrust_curve test_coloured_errors test_wind_and_pods \
	test_recalibration report/test_medium against/test_halves test_waves fitting/test_growing_force \
	strangers/test_real_stops strangers/test_underwater strangers/test_ships strangers/test_blimp
ROS_TESTS := architecture benchmark build commands documentation examples graph trial_tests
PYTEST_JOBS ?= 2
ON_ALL_CORES = -n $(PYTEST_JOBS) --dist loadfile
CORE_TESTS := $(filter-out $(ROS_TESTS:%=test/%/),$(sort $(wildcard test/*/)))

.NOTPARALLEL:
.DEFAULT_GOAL := help
.PHONY: help demo test docs bench prove prove-families prove-rov prove-slender prove-against prove-real set-up lint types contracts tests tests-numpy1 numpy1 bench-graph bench-diagnosis lock clean

help:
	@echo "make demo | test | docs | bench | bench-graph | bench-diagnosis | prove | prove-families | prove-rov | prove-slender | prove-against | prove-real | numpy1 | lock | clean   (see the head of the Makefile)"

demo: set-up
	$(BIN)/cocorosim run config/scenarios/eleven_lilys.yaml --out runs/demo --force

test: lint types contracts tests-numpy1 tests

# Warnings are errors; the notebooks run, so that it takes a minute.
docs: set-up
	$(BIN)/sphinx-build -q -W --keep-going -j auto -d build/doctrees -b html docs build/site
	@echo "build/site/index.html"

bench: set-up
	$(BIN)/python test/benchmark/bench.py

bench-graph: set-up
	$(BIN)/python test/benchmark/bench_graph.py

bench-diagnosis: set-up
	$(BIN)/python test/benchmark/bench_diagnosis.py

# --- proof ------------------------------------------------------------------------------------------------------------
# Resumable: what is there already in TRIAL_OUT is not made again. test/trial/README.md explains the rest.

TRIAL_COUNT ?= 400
TRIAL_PARTS ?=
TRIAL_JOBS ?= 2
TRIAL_MINUTES ?= inf
TRIAL_OUT ?= runs/trial
TRIAL_PAGES ?= $(TRIAL_OUT)/pages
TRIAL_DATA ?=
TRIAL_ALTERED ?= 200
PROVE = $(BIN)/python test/trial/prove.py

prove: set-up
	$(PROVE) sealed --warm --count $(TRIAL_COUNT) --parts "$(TRIAL_PARTS)" --jobs $(TRIAL_JOBS) --minutes $(TRIAL_MINUTES) --out $(TRIAL_OUT) --pages $(TRIAL_PAGES)

prove-families: set-up
	$(PROVE) families --warm --count $(TRIAL_COUNT) --jobs $(TRIAL_JOBS) --minutes $(TRIAL_MINUTES) --out $(TRIAL_OUT)-families --pages $(TRIAL_OUT)-families/pages

prove-rov: set-up
	$(PROVE) rov --warm --count $(TRIAL_COUNT) --jobs $(TRIAL_JOBS) --minutes $(TRIAL_MINUTES) --out $(TRIAL_OUT)-rov --pages $(TRIAL_OUT)-rov/pages

prove-slender: set-up
	$(PROVE) slender --warm --count $(TRIAL_COUNT) --jobs $(TRIAL_JOBS) --minutes $(TRIAL_MINUTES) --out $(TRIAL_OUT)-slender --pages $(TRIAL_OUT)-slender/pages

prove-against: set-up
	@test -n "$(TRIAL_DATA)" || { echo "Say where the recordings are: make prove-against TRIAL_DATA=FOLDER" >&2; exit 1; }
	$(PROVE) against --data $(TRIAL_DATA) --count $(TRIAL_ALTERED) --limit 900 --jobs $(TRIAL_JOBS) --minutes $(TRIAL_MINUTES) --out $(TRIAL_OUT)-against --pages $(TRIAL_PAGES)

# Its page has rows on altered logs, so that these come first.
prove-real: prove-against
	$(PROVE) real --data $(TRIAL_DATA) --limit 1500 --jobs $(TRIAL_JOBS) --minutes $(TRIAL_MINUTES) --out $(TRIAL_OUT)-real --pages $(TRIAL_PAGES)

# --- checks -----------------------------------------------------------------------------------------------------------

lint: set-up
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: set-up
	$(BIN)/mypy --strict cocorosim_ros

contracts: set-up
	$(BIN)/lint-imports

# Compiled once beforehand, lest many processes of the first tests compile the same at a time.
tests: set-up
	@folder=$$(mktemp -d) && for scenario in eleven_lilys turbulence_T5e-3; do \
	$(BIN)/cocorosim run $$scenario --in-process --duration "2 s" --out $$folder/$$scenario > /dev/null || exit 1; done; rm -rf $$folder
	$(BIN)/python -m pytest $(PYTEST_ARGS) $(ON_ALL_CORES) $(CORE_TESTS) $(filter-out $(ALONE),$(wildcard $(ROS_TESTS:%=test/%/)))
	$(BIN)/python -m pytest $(PYTEST_ARGS) $(wildcard $(ALONE))

# NumPy 1.26 is laid over NumPy 2 by PYTHONPATH: every other dependency in the lock accepts both, but for the
# optional rerun-sdk, whose tests are left out there.
ON_NUMPY1 = PYTHONPATH=$(PREFIX)/numpy1 XDG_CACHE_HOME=$(PREFIX)/numpy1/.cache $(BIN)/python
PYTHON_HAS_NUMPY1 = $(BIN)/python -c 'import sys; sys.exit(sys.version_info >= (3, 13))'

tests-numpy1: set-up
	@if ! $(PYTHON_HAS_NUMPY1); then echo "NumPy 1.26 does not exist for this Python: the tests run on NumPy 2 alone."; \
	elif [ -n "$(CORE_TESTS)" ]; then $(MAKE) --no-print-directory $(NUMPY1) && echo "The core on NumPy 1.26:" && \
	$(ON_NUMPY1) -m pytest $(PYTEST_ARGS) $(ON_ALL_CORES) $(WHOLE_DIAGNOSES:%=--ignore=test/diagnosis/%.py) $(CORE_TESTS); fi

numpy1: set-up
	@$(PYTHON_HAS_NUMPY1) || { echo "NumPy 1.26 does not exist for this Python: use PYTHON=python3.12 or python3.11." >&2; exit 1; }
	@$(MAKE) --no-print-directory $(NUMPY1)
	$(ON_NUMPY1) -m pytest $(PYTEST_ARGS)

$(NUMPY1):
	@rm -rf $(VENV)/numpy1
	$(BIN)/python -m pip install --quiet --require-hashes --no-deps --only-binary :all: --target $(VENV)/numpy1 -r requirements-numpy1.lock
	@PYTHONPATH=$(PREFIX)/numpy1 $(BIN)/python -c 'import numpy; assert numpy.__version__.startswith("1.26."), numpy.__version__'
	@PYTHONPATH=$(PREFIX)/numpy1 $(BIN)/python -m pip check | grep -vE '^(rerun-sdk .* requirement numpy|No broken)' | \
		{ ! grep .; }
	@touch $@

# --- set-up -----------------------------------------------------------------------------------------------------------

set-up: $(PACKAGE)
	@:

# setuptools comes first, because two dependencies are source archives and are built with this pinned one.
$(DEPENDENCIES):
	@python=$$(sh find_python.sh $(PYTHON)) && echo "Setting up $(VENV) with $$($$python --version); this happens once." && \
	$$python -m venv --clear $(VENV)
	@sed -n '/^setuptools==/,/[^\\]$$/p' requirements.lock > $(VENV)/setuptools.lock
	$(BIN)/python -m pip install --quiet --require-hashes --only-binary :all: -r $(VENV)/setuptools.lock
	$(BIN)/python -m pip install --quiet --require-hashes --no-deps --no-build-isolation -r requirements.lock
	@touch $@

# tf2_msgs is not on PyPI; it is built only where it is missing.
$(MESSAGES): $(DEPENDENCIES)
	@rm -rf $(VENV)/.messages-* $(VENV)/msg_defs_build
	@echo "Building msg_defs."
	@$(call build_messages,msg_defs,cocorosim_msgs)
	@$(BIN)/python -c 'import tf2_msgs' 2>/dev/null || { $(call build_messages,msg_defs/tf2_msgs,tf2_msgs); }
	@touch $@

define build_messages
export AMENT_PREFIX_PATH=$(PREFIX) CMAKE_PREFIX_PATH=$(PREFIX) LD_LIBRARY_PATH=$(PREFIX)/lib PATH=$(PREFIX)/bin:$$PATH; \
	mkdir -p $(VENV)/msg_defs_build/$(2) && { \
		$(BIN)/cmake -S $(1) -B $(VENV)/msg_defs_build/$(2) -G Ninja -DCMAKE_BUILD_TYPE=Release \
			-DCMAKE_INSTALL_PREFIX=$(PREFIX) -DPython3_EXECUTABLE=$(PREFIX)/bin/python && \
		$(BIN)/cmake --build $(VENV)/msg_defs_build/$(2) && \
		$(BIN)/cmake --install $(VENV)/msg_defs_build/$(2); \
	} > $(VENV)/msg_defs_build/$(2)/output.txt 2>&1 || { cat $(VENV)/msg_defs_build/$(2)/output.txt >&2; exit 1; }
endef

$(PACKAGE): $(MESSAGES)
	@rm -rf $(VENV)/.package-*
	$(BIN)/python -m pip install --quiet --no-deps --no-build-isolation --use-pep517 --editable .
	@touch $@

# --- upkeep -----------------------------------------------------------------------------------------------------------

COMPILE_LOCK = $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
	--no-emit-find-links --upgrade --custom-compile-command "make lock"

lock: set-up
	$(COMPILE_LOCK) requirements.in --output-file requirements.lock
	$(COMPILE_LOCK) requirements-numpy1.in --output-file requirements-numpy1.lock

clean:
	rm -rf .venv build install log *.egg-info .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache
	find cocorosim_ros test -name __pycache__ -type d -prune -exec rm -rf {} +
