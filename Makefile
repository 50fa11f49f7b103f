# The short way in; CMake does the work. Needs only make: `.ci/setup` sees to a C compiler, CMake and libraries.

BUILD   ?= build
PREFIX  ?= /usr/local
DESTDIR ?=
JOBS    ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
CMAKE_FLAGS ?=

PUBLISHED = golden/published.tsv
CONFIGURE = cmake -S . -B $(BUILD) $(CMAKE_FLAGS)
COMPILE   = cmake --build $(BUILD) --parallel $(JOBS)
CTEST     = ctest --test-dir $(BUILD) --parallel $(JOBS) --output-on-failure --no-tests=error

# What CMake and the compiler say is of interest when they fail.
quietly = @mkdir -p $(BUILD); $(1) > $(BUILD)/$(2).log 2>&1 || { cat $(BUILD)/$(2).log >&2; exit 1; }

# One build tree: goals given together take turns.
.NOTPARALLEL:
.PHONY: analyse coverage fuzz inverse mutants robots
.PHONY: page test-page check-nlopt check-builds
.PHONY: wheel test-python bench-python
.PHONY: all run check test tests golden diff era machines book book-check exercises check-faults dist install clean
.PHONY: setup

all: setup $(BUILD)/wished-expat
	$(call quietly,$(CONFIGURE),configure)
	$(call quietly,$(COMPILE),compile)

# The main job: both programs on the paper's four cases, held against the paper.
run: all
	@$(BUILD)/reproduce $(BUILD) $(PUBLISHED) $(BUILD)/run

# For every edit: all tests but those that take long, under a minute once the tests are built.
LONG_TESTS = ^(memcheck|build|fuzz|fault)_|^(install|example.*|test_legacy|test_orders_memory)$$
check: tests
	@$(CTEST) --exclude-regex '$(LONG_TESTS)'

# For every commit: all of them.
test: tests
	@$(CTEST)

tests: setup $(BUILD)/wished-expat $(BUILD)/wished-nlopt
	$(call quietly,$(CONFIGURE) -DBUILD_TESTING=ON,configure)
	$(call quietly,$(COMPILE),compile)

# Writes what the programs print today over golden/1987, golden/corrected and golden/armtol; say in the commit
# why each line changed. The published numbers are never written.
golden: all
	@$(BUILD)/reproduce --quiet $(BUILD) $(PUBLISHED) golden
	@tests/machines/answers $(BUILD)/armtol golden/armtol golden/armtol

diff: all
	@$(BUILD)/reproduce --quiet $(BUILD) $(PUBLISHED) $(BUILD)/run
	@rm -rf $(BUILD)/run/armtol && tests/machines/answers $(BUILD)/armtol golden/armtol $(BUILD)/run/armtol
	@diff -ru golden/1987 $(BUILD)/run/1987 && diff -ru golden/corrected $(BUILD)/run/corrected && \
	diff -ru golden/armtol $(BUILD)/run/armtol && echo "no difference from golden/"

# The legacy programs on an emulated 68020, nothing modelled. Needs Debian's cross compiler and qemu-user, and installs
# them where it may.
era: all
	@.ci/setup m68k-linux-gnu-gcc qemu-m68k
	@legacy/era $(BUILD)/reproduce golden $(BUILD)/era

# The programs on emulated machines of other kinds (MACHINES=aarch64 for one of them): the bytes of golden/. Needs
# Debian's cross compilers and qemu-user.
machines:
	@.ci/setup cmake x86_64-linux-gnu-gcc i686-linux-gnu-gcc aarch64-linux-gnu-gcc riscv64-linux-gnu-gcc \
	    s390x-linux-gnu-gcc m68k-linux-gnu-gcc qemu-x86_64 qemu-i386 qemu-aarch64 qemu-riscv64 qemu-s390x qemu-m68k
	@tests/machines/machines $(BUILD)/machines $(MACHINES)

# Memory, disks, system calls, signals and limits failing at every place where they can. Part of `make test` too.
check-faults: tests $(BUILD)/wished-valgrind
	@$(CTEST) --tests-regex '^fault_'
	@tests/faults/summary $(BUILD)/Testing/Temporary/LastTest.log

# What gcc and clang make of the programs at every level: the bytes of golden/. `make test` leaves -O1 and -O3 out.
check-builds: CMAKE_FLAGS += -DARMTOL_ALL_LEVELS=ON
check-builds: tests
	@.ci/setup gcc clang
	@$(CTEST) --tests-regex '^build_(gcc|clang)_'

# All that is read, given whatever clang's libFuzzer makes up: FUZZ_SECONDS for each of the harnesses, JOBS at a time.
# The inputs that reach something new stay in the build folder.
FUZZ_SECONDS ?= 600
fuzz: setup $(BUILD)/wished-expat
	@.ci/setup clang
	@tests/fuzz/run-fuzzers $(BUILD)/fuzz $(FUZZ_SECONDS) $(JOBS)

# Every chain of every robot that three Python packages ship, read and compared with a plain reader. Needs Python and
# its package index; takes some minutes the first time.
robots: all
	@.ci/setup venv
	@tests/robots/robots $(BUILD)/armtol $(abspath $(BUILD))/robots

# The optimum between bounds against NLopt's, for many random arms; `make test` does it for a few.
NLOPT_ARMS ?= 2000
NLOPT_SEED ?= 12
check-nlopt: tests
	@.ci/setup nlopt
	@$(BUILD)/tests/lib/optimum/test_bounds_nlopt $(NLOPT_ARMS) $(NLOPT_SEED)

# How fast the library is, beside loops written by hand: compiled for this machine, then as it comes.
bench: setup
	$(call quietly,$(CONFIGURE),configure)
	$(call quietly,$(COMPILE) --target armtol_bench armtol_bench_any armtol_many_tallies,compile)
	@$(BUILD)/armtol_bench
	@$(BUILD)/armtol_bench_any
	@$(BUILD)/tests/bench/armtol_many_tallies $(BUILD)/armtol $(BUILD) 10000

# Of how many positions inverse kinematics finds joint values, for every built-in arm.
inverse: tests
	@$(BUILD)/inverse_share 100000 1000

# The lab book: its tables and figures made anew, or held against the programs.
book: all
	@docs/lab-book/make-book $(BUILD)

book-check: all
	@docs/lab-book/make-book --check $(BUILD)
	@docs/lab-book/check-numbers

# The checks of the lab book's exercises: do they take what is right, and nothing else?
exercises: all
	@.ci/setup --wish python3
	@BUILD=$(BUILD) docs/lab-book/check-exercise --all

# All of it in one HTML file, build/page/index.html: docs/page.md. Needs Debian's emscripten and sources, and npm's
# packages.
page: all
	@.ci/setup emcc node npm
	@src/page/make/page . $(BUILD)

# The page's WebAssembly against golden/, and the page itself in Chromium.
test-page: page
	@.ci/setup chromium
	@BUILD=$(BUILD) node --test tests/page/golden.test.mjs tests/page/page.test.mjs

# The Python package (docs/python.md): a wheel in build/wheel; its tests, in an environment of their own, with Pinocchio
# to compare with. Needs Python and its package index.
wheel:
	@.ci/setup cc make venv --wish expat
	@src/python/make-wheel "$(CURDIR)" "$(abspath $(BUILD))"

test-python: wheel
	@tests/python/run "$(CURDIR)" "$(abspath $(BUILD))"

# How much Python adds to a call of the library.
bench-python: wheel
	@tests/python/run "$(CURDIR)" "$(abspath $(BUILD))" --bench

# Which lines and branches the tests run. Needs gcc and gcovr.
coverage: setup $(BUILD)/wished-expat $(BUILD)/wished-nlopt
	@.ci/setup gcovr
	@JOBS=$(JOBS) CMAKE_FLAGS="$(CMAKE_FLAGS)" tests/trust/coverage "$(CURDIR)" "$(abspath $(BUILD))/coverage"

# Would the tests notice? MUTANTS small changes of the sources, drawn with SEED; AGAIN=yes: those that survived the last
# time. Needs Python and its package index.
MUTANTS ?= 100
SEED    ?= 1
mutants: setup $(BUILD)/wished-expat $(BUILD)/wished-nlopt
	@.ci/setup venv
	@tests/trust/mutants "$(CURDIR)" "$(abspath $(BUILD))/mutants" --mutants $(MUTANTS) --seed $(SEED) \
	    $(if $(AGAIN),--again)

# All code but legacy/ read by gcc's and clang's analysers and cppcheck; any finding is a failure. ANALYSERS says which:
# gcc analyzer clang-tidy cppcheck.
ANALYSERS ?=
analyse: setup
	@.ci/setup gcc clang clang-tidy cppcheck --wish expat nlopt
	@tests/analysis/analyse $(BUILD)/analyse $(JOBS) $(ANALYSERS)

# The last commit as a tarball, the same bytes whenever it is made; what is not committed is not in it.
committed_version = git show HEAD:CMakeLists.txt | sed -n 's/^project(armtol VERSION \([0-9.]*\) .*/\1/p'
dist:
	@.ci/setup git
	@mkdir -p $(BUILD)
	@git diff --quiet HEAD -- || echo 'dist: what is not committed is not in the tarball' >&2
	@name=armtol-$$($(committed_version)) && rm -f "$(BUILD)/$$name.tar.gz" && \
	git -c tar.umask=0022 -c core.autocrlf=false archive --prefix="$$name/" -o "$(BUILD)/$$name.tar" HEAD && \
	gzip -9n "$(BUILD)/$$name.tar" && echo "$(BUILD)/$$name.tar.gz"

install: all
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)"

clean:
	rm -rf $(BUILD)

setup:
	@.ci/setup cc cmake

# A library that is not needed is asked for once a build tree: where it is not to be had, that is said once.
$(BUILD)/wished-%: | setup
	@mkdir -p $(BUILD) && .ci/setup --wish $* && touch $@
