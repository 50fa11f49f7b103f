# The short way in; CMake does the work. Needs only make: `.ci/setup` sees to a C compiler, CMake and libraries.

BUILD   ?= build
PREFIX  ?= /usr/local
DESTDIR ?=
JOBS    ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
CMAKE_FLAGS ?=

PUBLISHED = golden/published.tsv
CONFIGURE = cmake -S . -B $(BUILD) $(CMAKE_FLAGS)
COMPILE   = cmake --build $(BUILD) --parallel $(JOBS)

# What CMake and the compiler say is of interest when they fail.
quietly = @mkdir -p $(BUILD); $(1) > $(BUILD)/$(2).log 2>&1 || { cat $(BUILD)/$(2).log >&2; exit 1; }

# One build tree: goals given together take turns.
.NOTPARALLEL:
.PHONY: all run test golden diff era book book-check install clean setup

all: setup $(BUILD)/wished-expat
	$(call quietly,$(CONFIGURE),configure)
	$(call quietly,$(COMPILE),compile)

# The main job: both programs on the paper's four cases, held against the paper.
run: all
	@$(BUILD)/reproduce $(BUILD) $(PUBLISHED) $(BUILD)/run

test: setup $(BUILD)/wished-expat $(BUILD)/wished-nlopt
	$(call quietly,$(CONFIGURE) -DBUILD_TESTING=ON,configure)
	$(call quietly,$(COMPILE),compile)
	@ctest --test-dir $(BUILD) --parallel $(JOBS) --output-on-failure --no-tests=error

# Writes what the programs print today over golden/1987 and golden/corrected; say in the commit why each
# line changed. The published numbers are never written.
golden: all
	@$(BUILD)/reproduce --quiet $(BUILD) $(PUBLISHED) golden

diff: all
	@$(BUILD)/reproduce --quiet $(BUILD) $(PUBLISHED) $(BUILD)/run
	@diff -ru golden/1987 $(BUILD)/run/1987 && diff -ru golden/corrected $(BUILD)/run/corrected && \
	echo "no difference from golden/"

# The legacy programs on an emulated 68020, nothing modelled. Needs Debian's cross compiler and qemu-user.
era: all
	@legacy/era $(BUILD)/reproduce golden $(BUILD)/era

# The lab book: its tables and figures made anew (figures where gnuplot is), or held against the programs.
book: all
	@docs/lab-book/make-book $(BUILD)

book-check: all
	@docs/lab-book/make-book --check $(BUILD)
	@docs/lab-book/check-numbers

install: all
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)"

clean:
	rm -rf $(BUILD)

setup:
	@.ci/setup cc cmake

# A library that is not needed is asked for once a build tree: where it is not to be had, that is said once.
$(BUILD)/wished-%: | setup
	@mkdir -p $(BUILD) && .ci/setup --wish $* && touch $@
