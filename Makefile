# The commands of README.md. Needs make 3.81 or newer; without make, call cargo as README.md says.

# The scene that `make play` opens: make play SCENE=scenes/shapes.ron
SCENE ?= $(firstword $(sort $(wildcard scenes/*.ron)))

.PHONY: help play quick test setup rust

help:
	@echo 'make play    open a scene in a window; without a display, draw all scenes to gallery/'
	@echo 'make quick   run the tests that need neither a GPU nor a display; seconds after a build'
	@echo 'make test    run all tests'
	@echo 'make setup   install what raytoy needs besides Rust (Linux)'

# The dev profile is enough: it optimises the dependencies, and the GPU does the work.
play: setup
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

setup: rust
	@.ci/setup

rust:
	@command -v cargo >/dev/null 2>&1 || { \
	    echo 'Rust is missing, or not in the PATH. Get it from https://rustup.rs, then try again.' >&2; \
	    exit 1; \
	}
