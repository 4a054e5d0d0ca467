# The front door: `make demo` shows a picture, `make test` runs the tests, `make` lists the rest.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
.PHONY: help deps build demo test speed bench accuracy gallery editors fuzz wheel clean

VENV := .venv
BIN := $(VENV)/bin
PYTHON ?=
DEBIAN := cmake ninja-build g++ libembree-dev libopenexr-dev libcgal-dev libgmp-dev libmpfr-dev \
  libboost-dev libtbb-dev libpng-dev libcli11-dev libfast-float-dev libpugixml-dev catch2 python3-dev python3-venv
# What only `make test` needs: scenes are rendered with POV-Ray too, and compared.
DEBIAN_TEST := povray povray-includes

help:
	@echo 'make demo    install what is missing, build, render scenes/calcite_on_grid.spar into out/'
	@echo 'make build   the program build/icespar, and .venv in which "import icespar" works'
	@echo 'make test    build and run the C++ and the Python tests'
	@echo 'make speed   error against time, of other renderers too, and docs/speed.md from it'
	@echo 'make bench   all of that, every scene, and the interface at length, into bench/results'
	@echo 'make accuracy measure the interface along every axis of stress, and draw docs/accuracy anew'
	@echo 'make gallery render the pictures of docs/gallery.md anew'
	@echo 'make editors write the grammar for editors anew, after a change of the language'
	@echo 'make fuzz    feed the readers of files with nonsense for FUZZ_SECONDS (60) of the processor each, with clang'
	@echo 'make wheel   a Python wheel in dist/'
	@echo 'make clean   remove what was built (.venv and out/ stay)'

# Debian packages that are missing, by apt-get where that is allowed. On other systems CMake says what it lacks.
deps:
	@command -v dpkg-query >/dev/null || exit 0; \
	missing=; for package in $(DEBIAN); do \
	  dpkg-query -W -f='$${db:Status-Status}' "$$package" 2>/dev/null | grep -qx installed || missing+=" $$package"; \
	done; \
	[ -n "$$missing" ] || exit 0; \
	echo "icespar needs these Debian packages:$$missing"; \
	if [ "$$(id -u)" = 0 ]; then as_root=; \
	elif command -v sudo >/dev/null; then as_root=sudo; \
	else echo "Install them as root, then run make again: apt-get install$$missing"; exit 1; fi; \
	install() { $$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $$missing; }; \
	{ $$as_root apt-get update -q && install; } || { \
	  echo "apt-get failed. Install these by hand, then run make again:$$missing"; exit 1; }

# The first Python 3.11 or newer that can make an environment and has its headers; Debian's own if it can.
$(BIN)/python: | deps
	@for python in $(PYTHON) /usr/bin/python3 python3 python3.14 python3.13 python3.12 python3.11; do \
	  "$$python" -c 'import ensurepip, os, sys, sysconfig, venv; \
	    sys.exit(sys.version_info < (3, 11) or not os.path.exists(sysconfig.get_path("include") + "/Python.h"))' \
	    2>/dev/null && break; python=; \
	done; \
	[ -n "$$python" ] || { echo 'No Python 3.11 or newer with venv and headers: install one, or name it: make PYTHON=...'; exit 1; }; \
	echo "$$python makes $(VENV)"; "$$python" -m venv $(VENV)

$(VENV)/.installed: python/requirements.txt | $(BIN)/python
	$(BIN)/python -m pip install -q --disable-pip-version-check -r $<
	@$(BIN)/python -c 'import pathlib, sysconfig; \
	  pathlib.Path(sysconfig.get_path("purelib"), "icespar.pth").write_text("$(CURDIR)/build/python\n")'
	@touch $@

$(VENV)/.installed-test: python/requirements-test.txt $(VENV)/.installed
	$(BIN)/python -m pip install -q --disable-pip-version-check -r $<
	@touch $@

build: deps $(VENV)/.installed
	cmake --preset release
	cmake --build --preset release --target icespar_cli icespar_python

demo: build
	@mkdir -p out
	build/icespar render scenes/calcite_on_grid.spar --size 640x480 --error 0.01 --time 45 \
	  -o out/calcite_on_grid.exr -o out/calcite_on_grid.png
	@echo "The picture is in $(CURDIR)/out/calcite_on_grid.png (to look at) and calcite_on_grid.exr (to measure)."

test: DEBIAN += $(DEBIAN_TEST)
test: build $(VENV)/.installed-test
	cmake --build --preset release
	ctest --preset release
	$(BIN)/python -m pytest tests/python tests/pov

# Other renderers take part where they are found: bench/speed/run.py --help.
speed: build $(VENV)/.installed-test
	$(BIN)/python bench/speed/run.py --docs docs

bench: speed
	cmake --build --preset release --target icespar_bench
	@for program in $(basename $(notdir $(wildcard bench/*.cpp))); do echo "$$program"; build/tests/$$program; done
	$(BIN)/python bench/run.py

accuracy: build $(VENV)/.installed-test
	cmake --build --preset release --target interface_sweeps
	@mkdir -p bench/results
	build/tests/interface_sweeps > bench/results/interface_sweeps.csv
	$(BIN)/python tools/plot_accuracy.py bench/results/interface_sweeps.csv docs/accuracy

gallery: build $(VENV)/.installed-test
	$(BIN)/python tools/make_gallery.py

editors: build
	cmake --build --preset release --target editor_files
	build/tests/editor_files .

# What is found stays in build-fuzz/found; a finding that is mended belongs into tests/fuzz/corpus.
FUZZ_SECONDS ?= 60
fuzz:
	cmake -S . -B build-fuzz -G Ninja -DICESPAR_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++ -DICESPAR_MARCH= \
	  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -g1'
	cmake --build build-fuzz --target fuzzers
	tests/fuzz/run.sh build-fuzz $(FUZZ_SECONDS)

wheel: $(VENV)/.installed
	$(BIN)/python -m pip wheel . --no-deps -w dist

clean:
	rm -rf build build-sanitize build-fuzz dist
