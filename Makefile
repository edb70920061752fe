# Every task of the project has one target here; `make help` lists them. All set-up happens by itself, under build/.
# Needed on the machine: Rust, Python 3.11 and make.

BLENDERS := 4.2 4.5 5.0
NEWEST := 5.0

ifndef PYTHON
PYTHON := $(shell for python in python3.11 python3 python; do \
    $$python -c 'import sys; sys.exit(sys.version_info[:2] != (3, 11))' 2>/dev/null && echo $$python && break; done)
endif

# A step that hangs is ended, wherever the machine can do that (seconds).
STEP_SECONDS ?= 900
LIMIT := $(if $(shell command -v timeout),timeout --kill-after=30 $(STEP_SECONDS))

TOOLS := build/venv/tools/bin
RUST := $(shell find core/src core/cli/src core/library/src core/python/src -name '*.rs') Cargo.toml Cargo.lock core/Cargo.toml core/cli/Cargo.toml core/library/Cargo.toml \
    $(wildcard core/python/Cargo.toml core/python/pyproject.toml core/python/*.pyi)
ADDON := $(shell find addon -type f -not -path '*/__pycache__/*') LICENSE README.md .ci/package.py .ci/notices.py

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: help demo test test-rust test-python test-blender $(BLENDERS:%=test-blender-%) test-install test-gui \
    lint format bench fuzz fuzz-smoke package clean python-3.11

help: ## List the targets
	@awk -F ':.*## ' '/^[a-z0-9.-]+:.*## / { printf "  %-18s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

demo: build/venv/bpy-$(NEWEST)/.module ## Run the tutorial: out/ gets a .blend, a picture and a moving preview
	build/venv/bpy-$(NEWEST)/bin/python -m tests.demo.tutorial --out out

# -- Tests ------------------------------------------------------------------------------------------------------------

test: test-rust test-python test-blender test-install fuzz-smoke ## Run every test that needs no window

test-rust: ## Test the core
	$(LIMIT) cargo test --locked --package motion-theater-core --package motion-theater-cli --package motion-theater-library

# Folders of tests that need no Blender.
PURE := tests/native tests/library tests/logic tests/testdata tests/demo tests/docs
test-python: build/venv/tools/.module ## Test the Python module and all logic that needs no Blender
	$(LIMIT) $(TOOLS)/python -m pytest $(wildcard $(PURE))

test-blender: $(BLENDERS:%=test-blender-%) ## Test the add-on in every Blender; in one: test-blender-4.2, -4.5, -5.0

$(BLENDERS:%=test-blender-%): test-blender-%: build/venv/bpy-%/.module
	$(LIMIT) build/venv/bpy-$*/bin/python -m pytest tests/scene tests/panels

test-install: build/package/.built $(BLENDERS:%=build/venv/bpy-%/.ready) ## Install the zip into an empty Blender of each version
	for blender in $(BLENDERS); do \
	    $(LIMIT) build/venv/bpy-$$blender/bin/python -m pytest tests/install || exit 1; done

# Where the windowed Blender is kept: its run.sh opens it with the script of a session.
GUI ?= ../shared/gui
test-gui: build/package/.built ## Drive a windowed Blender with mouse and keys, session by session
	GUI=$(GUI) $(PYTHON) tests/gui/run.py

# -- Checks -----------------------------------------------------------------------------------------------------------

PYTHON_CODE := addon tests testdata .ci

lint: build/venv/tools/.module ## Check layout, style and types; warnings are errors
	cargo fmt --all --check
	cargo clippy --locked --workspace --all-targets -- --deny warnings
	cargo fmt --manifest-path core/fuzz/Cargo.toml --check
	$(TOOLS)/ruff check $(PYTHON_CODE)
	$(TOOLS)/ruff format --check $(PYTHON_CODE)
	$(TOOLS)/python -m mypy
	$(TOOLS)/python -m mypy.stubtest motion_theater --allowlist core/python/stubtest-allowed.txt

format: build/venv/tools/.ready ## Lay the code out anew
	cargo fmt --all
	cargo fmt --manifest-path core/fuzz/Cargo.toml
	$(TOOLS)/ruff check --fix $(PYTHON_CODE)
	$(TOOLS)/ruff format $(PYTHON_CODE)

bench: build/venv/bpy-$(NEWEST)/.module ## Measure the speed, as ratios against fixed references
	build/venv/bpy-$(NEWEST)/bin/python -m tests.bench

# libFuzzer alone, without the address sanitizer: that works with the stable compiler, and the readers hold no unsafe code.
FUZZ_TARGETS := asf amc bvh c3d csm trc
FUZZ_SECONDS ?= 600
FUZZ_KEEP ?= build/fuzz
fuzz fuzz-smoke: export PATH := $(CURDIR)/build/tools/bin:$(PATH)
fuzz: build/fuzz/.ready ## Fuzz each reader for ten minutes
	for target in $(FUZZ_TARGETS); do \
	    mkdir -p $(FUZZ_KEEP)/$$target core/fuzz/corpus/$$target && \
	    cargo fuzz run --fuzz-dir core/fuzz --sanitizer none $$target $(FUZZ_KEEP)/$$target core/fuzz/corpus/$$target -- \
	        -dict=core/fuzz/words.dict -max_total_time=$(FUZZ_SECONDS) -print_final_stats=1 $(FUZZ_FLAGS) || exit 1; \
	done

# A count instead of a time, and one seed: what a slow machine tries is what a fast one tries.
FUZZ_RUNS ?= 50000
fuzz-smoke: ## Fuzz each reader for some seconds, where there is a C++ compiler
	@rm -rf build/fuzz-smoke
	@if command -v c++ >/dev/null; then \
	    $(LIMIT) $(MAKE) fuzz FUZZ_SECONDS=100 FUZZ_KEEP=build/fuzz-smoke FUZZ_FLAGS="-seed=1 -runs=$(FUZZ_RUNS)"; \
	else echo "fuzz-smoke: not run, libFuzzer needs a C++ compiler (c++), which is not here"; fi

# -- The extension ----------------------------------------------------------------------------------------------------

package: build/package/.built ## Build dist/motion_theater-<version>-<platform>.zip

build/package/.built: build/wheels/.built build/venv/bpy-$(NEWEST)/.ready $(ADDON)
	build/venv/bpy-$(NEWEST)/bin/python .ci/package.py build/wheels/*.whl
	touch $@

# Portable on Linux: linked against glibc 2.28, the oldest that Blender runs on, whatever this machine has.
ifeq ($(shell uname -sm),Linux x86_64)
PORTABLE := --zig --target x86_64-unknown-linux-gnu --compatibility manylinux_2_28
endif

# Messages of panics name source files: without the folders of the machine that built them.
PATHLESS := --remap-path-prefix=$(CURDIR)=motion-theater --remap-path-prefix=$(or $(CARGO_HOME),$(HOME)/.cargo)=cargo

build/wheels/.built: $(RUST) build/venv/tools/.ready
	rm -rf build/wheels
	PATH="$(CURDIR)/$(TOOLS):$$PATH" RUSTFLAGS="$(PATHLESS)" $(TOOLS)/maturin build --release --locked $(PORTABLE) \
	    --manifest-path core/python/Cargo.toml --out build/wheels
	touch $@

# -- Set-up -----------------------------------------------------------------------------------------------------------

build/venv/%/.ready: tests/requirements/%.txt | python-3.11
	$(PYTHON) -m venv --clear build/venv/$*
	build/venv/$*/bin/python -m pip install --quiet --disable-pip-version-check --requirement $<
	touch $@

build/venv/%/.module: build/wheels/.built build/venv/%/.ready
	build/venv/$*/bin/python -m pip install --quiet --disable-pip-version-check --force-reinstall --no-deps build/wheels/*.whl
	touch $@

# The exact version that the targets are tried with, in a folder of our own.
build/fuzz/.ready:
	command -v cargo-fuzz >/dev/null || cargo install --quiet --locked --root build/tools --version 0.13.2 cargo-fuzz
	mkdir -p $(@D) && touch $@

python-3.11:
	@test -n "$(PYTHON)" && $(PYTHON) -c 'import sys; sys.exit(sys.version_info[:2] != (3, 11))' || { \
	    echo "Python 3.11 was not found: Blender's packages are made for it. Where it is: make PYTHON=/path/to/python3.11"; \
	    exit 1; }

clean: ## Remove everything that was built, the demo's output too
	rm -rf build dist out target core/fuzz/target
