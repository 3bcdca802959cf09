# The commands of README.md. Needs make 3.81 or newer; without make, call cargo as README.md says.

# The scene that `make play` opens: make play SCENE=scenes/shapes.ron
SCENE ?= $(firstword $(sort $(wildcard scenes/*.ron)))

# What `make dist` builds, and where cargo puts it: make dist PROFILE=dev
PROFILE ?= release
TARGET := $(or $(CARGO_TARGET_DIR),target)
BUILT := $(TARGET)/$(if $(filter dev,$(PROFILE)),debug,$(PROFILE))

.PHONY: help play quick test dist setup rust

help:
	@echo 'make play    open a scene in a window; without a display, draw all scenes to gallery/'
	@echo 'make quick   run the tests that need neither a GPU nor a display; seconds after a build'
	@echo 'make test    run all tests'
	@echo 'make dist    make an archive with a program that needs neither Rust nor this folder'
	@echo 'make setup   install what raytoy needs besides Rust (Linux)'

# The dev profile is enough: it optimizes what is hot, and the GPU does the work.
play: setup
	@if [ ! -d '$(TARGET)/debug/deps' ]; then \
	    cores=$$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 4); \
	    echo "The first build compiles some 240 crates: about $$((10 / cores + 1)) minutes on $$cores cores. Later ones take seconds."; \
	    echo 'Meanwhile, this is the scene. Its language is explained in LANGUAGE.md.'; \
	    echo; \
	    cat '$(SCENE)'; \
	fi
	@cargo build
	@case "$$(uname -s)" in \
	    Darwin | MINGW* | MSYS* | CYGWIN*) display=yes ;; \
	    *) display="$${DISPLAY:-}$${WAYLAND_DISPLAY:-}" ;; \
	esac; \
	if [ -n "$$display" ]; then \
	    echo 'Opening $(SCENE). Edit it in any editor: each save shows at once.'; \
	    exec cargo run -q -- view '$(SCENE)'; \
	fi; \
	echo 'There is no display, so the scenes are drawn to gallery/.'; \
	export XDG_RUNTIME_DIR="$${XDG_RUNTIME_DIR:-$${TMPDIR:-/tmp}}"; \
	cargo run -q -- render scenes/*.ron -o gallery/ --size 960x540 --samples 16 && \
	echo "The pictures are in $$(pwd)/gallery/."

quick: rust
	cargo test --test text

test: rust
	@.ci/setup test
	cargo test

# Everything that a scene needs is in the program; the scenes are there to be changed.
dist: rust
	cargo build --profile $(PROFILE)
	@set -e; \
	version=$$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1); \
	machine=$$(rustc -vV | sed -n 's/^host: //p'); \
	name=raytoy-$$version-$$machine; \
	case $$machine in *windows*) program=raytoy.exe ;; *) program=raytoy ;; esac; \
	folder='$(TARGET)/dist'; \
	rm -rf "$$folder/$$name"; \
	mkdir -p "$$folder/$$name/docs"; \
	cp '$(BUILT)'/$$program README.md LANGUAGE.md CHANGELOG.md LICENSE-APACHE LICENSE-MIT "$$folder/$$name/"; \
	cp -R scenes "$$folder/$$name/"; \
	cp -R docs/library docs/testing.md docs/accuracy.md "$$folder/$$name/docs/"; \
	cd "$$folder"; \
	case $$machine in \
	    *windows*) archive=$$name.zip; rm -f "$$archive"; powershell -NoProfile -Command "Compress-Archive '$$name' '$$archive'" ;; \
	    *) archive=$$name.tar.gz; tar -czf "$$archive" "$$name" ;; \
	esac; \
	echo "The archive is $$folder/$$archive."

setup: rust
	@.ci/setup

rust:
	@command -v cargo >/dev/null 2>&1 || { \
	    echo 'Rust is missing, or not in the PATH. Get it from https://rustup.rs, then try again.' >&2; \
	    exit 1; \
	}
