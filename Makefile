# stonepack. No configure step; everything built goes into build/.

ifeq ($(origin CC),default)
CC = gcc
endif
CFLAGS  ?= -O2
ifeq ($(filter -j%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell nproc 2> /dev/null || echo 1)
endif
STRICTC  = -std=c99 -ffp-contract=off -fno-math-errno
WARN     = -Wall -Wextra -Wshadow
ALL_C    = $(STRICTC) $(CFLAGS) $(WARN)

PARTS    = stonepack.c stonepack.h $(wildcard solvers/*/*.c)
GEN      = tests/scenes/gen.c
GEN_H    = $(wildcard tests/scenes/gen*.h)
# The program, bottom-up: run.c and its neighbours, files/, picture/, worker/, command/, main.c; tests/checks/host_floors.sh holds it.
READ     = $(addprefix port/host/,run.c clock.c) $(wildcard port/host/files/*.c)
MAIN     = port/host/main.c
HOST     = $(filter-out $(MAIN),$(wildcard port/host/*.c port/host/*/*.c)) $(GEN)
HOST_H   = stonepack.h $(wildcard port/*/*.h port/host/*/*.h settle/*.h) $(GEN_H)

# Solvers of others, where they are: Ipopt if pkg-config knows it, OSQP 1.x by its header under a prefix (it has no .pc file).
PLUGINS  =
PLUG_C   =
PLUG_L   =
IPOPT_L := $(shell pkg-config --libs ipopt 2> /dev/null)
OSQP_H   = include/osqp/osqp_api_types.h
OSQP    ?= $(patsubst %/$(OSQP_H),%,$(firstword $(wildcard /usr/local/$(OSQP_H) /usr/$(OSQP_H))))
OSQP_L  := $(firstword $(wildcard $(addprefix $(OSQP)/lib,/libosqp.* 64/libosqp.so /*/libosqp.so /libosqpstatic.a)))
ifneq ($(IPOPT_L),)
PLUGINS += port/ipopt
PLUG_C  += -DWITH_IPOPT $(shell pkg-config --cflags ipopt)
PLUG_L  += $(IPOPT_L)
endif
ifneq ($(and $(OSQP),$(OSQP_L)),)
PLUGINS += port/osqp
PLUG_C  += -DWITH_OSQP -isystem $(OSQP)/include
PLUG_L  += $(OSQP_L) -Wl,-rpath,$(dir $(OSQP_L))
endif
PLUG     = $(wildcard $(PLUGINS:%=%/*.c)) $(SETTLE_C)

# Where stones come to rest: Bullet 3 and a C++ compiler. `make BULLET=` leaves it out.
ifeq ($(origin BULLET),undefined)
BULLET  := $(shell command -v $(CXX) > /dev/null 2>&1 && for p in bullet-float64 bullet; do \
             pkg-config --exists $$p 2> /dev/null && echo $$p && break; done)
endif
ifneq ($(BULLET),)
SETTLE_C = $(wildcard settle/*.c)
SETTLE_O = build/bullet.o
BULLET_I := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(BULLET)))
PLUG_C  += -DWITH_BULLET
PLUG_L  += -Wl,--as-needed $(shell pkg-config --libs $(BULLET)) -lstdc++
endif

# STL, PLY, glTF and others: Assimp. `make ASSIMP=` leaves it out.
ifeq ($(origin ASSIMP),undefined)
ASSIMP  := $(shell pkg-config --exists assimp 2> /dev/null && echo assimp)
endif
ifneq ($(ASSIMP),)
PLUG_C  += -DWITH_ASSIMP $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(ASSIMP)))
PLUG_L  += $(shell pkg-config --libs $(ASSIMP))
endif

# Tests: all suites, or `make test ONLY=proof` those of a wing, ONLY=refute that one. tests/small/suites.txt: what SP_SMALL answers.
# To `make check` and `make test-boards` ONLY means something else.
THESE   := $(if $(filter test,$(MAKECMDGOALS)),$(ONLY))
SUITE_C := $(wildcard $(if $(THESE),tests/$(THESE)/test_*.c tests/*/test_$(THESE).c,tests/*/test_*.c))
SMALL_C  = $(filter $(addsuffix .c,$(addprefix %/test_,$(file < tests/small/suites.txt))),$(SUITE_C))
OF      := $(if $(THESE),_of_$(THESE))
ifneq ($(and $(filter check,$(MAKECMDGOALS)),$(ONLY)),)
WRONG   := $(shell ONLY='$(ONLY)' sh tests/checks/check.sh --asked)
$(if $(WRONG),$(error $(WRONG)))
endif

.PHONY: bench-plan always all lib shared install-shared python demo test deps test-boards robot regions footprint pair package page docs install bench figures bench-coupled bench-peers check fuzz nightly help clean

all: build/libstonepack.a build/stonepack

help:
	@echo "make           the library build/libstonepack.a and the program build/stonepack"
	@echo "make lib       the library alone"
	@echo "make shared    the same as a shared library, build/libstonepack.so.VERSION; make install-shared puts it into PREFIX/lib"
	@echo "make python    a wheel for Python over it, build/stonepack-VERSION-....whl, and build/python to be used as it is"
	@echo "make demo      checks some scenes, draws them into build/demo/, a page of them: index.html"
	@echo "make test      tests in some minutes; needs gcc and make only. LONG=1: all samples of every claim, not a few"
	@echo "make test ONLY=proof   one wing of tests/; ONLY=refute one suite; then build/run_of_refute FILTER one test, -l names them"
	@echo "make check     everything else this machine can test, and what it lacks (STRICT=1: nothing may lack); ONLY=pair one group"
	@echo "make fuzz      any bytes into every reader and question, FUZZ_SECONDS (30) each; tests/fuzz/fuzz.sh TARGET one of them"
	@echo "make nightly   what takes longer still (ONLY=text: those lines); rows of tests/NIGHTLY.md"
	@echo "make test-boards  the tests on simulated microcontrollers and foreign machines; see port/board/README.md"
	@echo "make robot     a gripper asks a simulated Cortex-M4F, then an M7, whether it may let go of a stone"
	@echo "make regions   a check whose factor lies in another memory than scene and answer, on the same two"
	@echo "make footprint measures code, stack, memory and instructions on Cortex-M anew, into port/board/footprint.csv"
	@echo "make deps      installs what check can use (Debian, needs root)"
	@echo "make pair      the library as two files, in build/pair/"
	@echo "make package   one folder for CMake, Meson, Arduino, PlatformIO, ESP-IDF, Zephyr, in build/package/"
	@echo "make dist      a release as one tarball, build/dist/; the same files make the same bytes"
	@echo "               HOMEPAGE=ADDRESS: the project's page, for dist, deb, package, install, python"
	@echo "make deb       Debian packages of it, build/deb/; needs dpkg-dev and debhelper"
	@echo "make page      one HTML file that reads a model, checks it as it is changed, and shows it in 3D: build/page/stonepack.html"
	@echo "make docs      manual page, completions for bash and zsh, in build/doc/"
	@echo "make install   library, header, program, manual and completions into PREFIX (/usr/local), under DESTDIR"
	@echo "make bench     times and work as CSV"
	@echo "make bench-plan  what leaving out effects saves, as CSV; SCENES='FILE ...' of these"
	@echo "make figures   the pictures of the pages"
	@echo "make bench-coupled  the coupled check on CASES (../shared/cases), as CSV"
	@echo "make bench-peers  beside SCS, QOCO, ECOS, PIQP, OSQP and HiGHS where they are installed: SCS=PREFIX ... QPS=FOLDER"
	@echo "make clean     removes build/"

lib: build/libstonepack.a

build/stonepack.o: $(PARTS)
	@mkdir -p build
	$(Q)$(CC) $(ALL_C) -c stonepack.c -o $@

build/libstonepack.a: build/stonepack.o
	$(AR) rcs $@ $<

# The shared library: hidden but for the calls of the header. Until 1.0 every minor version has an interface of its own, hence the soname.
VERSION := $(shell awk '$$2 ~ /^SP_VERSION_(MAJOR|MINOR|PATCH)$$/ { printf "%s%s", n++ ? "." : "", $$3 }' stonepack.h)
SONAME   = libstonepack.so.$(basename $(VERSION))
SHARED   = build/libstonepack.so.$(VERSION)
SHARED_C = -fPIC -fvisibility=hidden '-DSP_API=__attribute__((visibility("default")))'

shared: $(SHARED)

build/shared.o: $(PARTS)
	@mkdir -p build
	$(Q)$(CC) $(ALL_C) $(SHARED_C) -c stonepack.c -o $@

$(SHARED): build/shared.o
	$(Q)$(CC) -shared -Wl,-soname,$(SONAME) -Wl,-z,defs $< -o $@
	ln -sf $(@F) build/$(SONAME)
	ln -sf $(SONAME) build/libstonepack.so

# Python: structs and calls read from the header, asserted by the compiler; the program's reader and pictures as a second library.
PYTHON  ?= python3
DRAW     = $(wildcard port/host/picture/*.c) $(addprefix port/host/,weakest.c motion.c reason.c command/report.c command/report_json.c)
PY_FILES = $(wildcard port/python/stonepack/*.py) port/python/stonepack/py.typed port/python/README.md LICENSE

build/libstonepack_files.so: port/python/files.c port/python/older.h $(READ) $(DRAW) $(HOST_H) $(SHARED)
	$(Q)$(CC) $(ALL_C) -include port/python/older.h -fPIC -fvisibility=hidden -ffunction-sections -fdata-sections -shared -Wl,--gc-sections -Wl,-z,defs \
	    '-Wl,-rpath,$$ORIGIN' $(filter %.c,$^) -Lbuild -l:$(SONAME) -lm -o $@

# Where stones come to rest is a third one, over Bullet, if that is there.
PY_SETTLE = $(if $(BULLET),build/libstonepack_settle.so)

build/libstonepack_settle.so: $(wildcard settle/*.c settle/*.cpp settle/*.h) $(SHARED)
	@mkdir -p build/shared
	$(Q)for c in $(wildcard settle/*.c); do $(CC) $(ALL_C) -fPIC -c $$c -o build/shared/$$(basename $$c .c).o || exit 1; done
	$(Q)$(CXX) -std=c++11 -ffp-contract=off -fPIC $(CFLAGS) $(WARN) $(BULLET_I) -c settle/bullet.cpp -o build/shared/bullet.o
	$(Q)$(CXX) -shared -Wl,-z,defs '-Wl,-rpath,$$ORIGIN' $(patsubst settle/%.c,build/shared/%.o,$(wildcard settle/*.c)) build/shared/bullet.o \
	    -Wl,--as-needed $(shell pkg-config --libs $(BULLET)) -Lbuild -l:$(SONAME) -lm -o $@

python: build/python/made
	@cat $<

build/python/made: $(SHARED) build/libstonepack_files.so $(PY_SETTLE) build/plugins build/homepage port/python/bind.py port/python/wheel.py $(PY_FILES) stonepack.h settle/settle.h
	@rm -rf build/python && mkdir -p build/python/stonepack
	@cp $(filter %.py %/py.typed,$(PY_FILES)) build/python/stonepack/
	@cp $(filter-out %.py %/py.typed,$(PY_FILES)) build/homepage build/python/
	@cp $(SHARED) build/python/stonepack/$(SONAME)
	@cp build/libstonepack_files.so $(PY_SETTLE) build/python/stonepack/
	@$(CC) -E -dM stonepack.h > build/python/macros
	$(Q)$(CC) -E -P settle/settle.h | $(PYTHON) -B port/python/bind.py build/python/macros build/python/stonepack/_bindings.py build/python/layout.c
	@$(CC) -std=c11 -I. -fsyntax-only build/python/layout.c
	@rm -f build/stonepack-*.whl
	@$(PYTHON) -B port/python/wheel.py build/python build > $@.new && mv $@.new $@

build/bullet.o: settle/bullet.cpp $(wildcard settle/*.h) stonepack.h
	@mkdir -p build
	$(Q)$(CXX) -std=c++11 -ffp-contract=off $(CFLAGS) $(WARN) $(BULLET_I) -c $< -o $@

# The program, file by file: an edit of one compiles that one, an edit of the core none. V=1 shows the commands.
Q         = $(if $(V),,@echo "  $@";)
PROGRAM_O = $(patsubst %.c,build/program/%.o,$(MAIN) $(HOST) $(PLUG))
build/program/%.o: %.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(ALL_C) $(PLUG_C) -MMD -MP -c $< -o $@

build/stonepack: $(PROGRAM_O) $(SETTLE_O) build/libstonepack.a build/plugins
	$(Q)$(CC) $(ALL_C) $(filter %.o %.a,$^) $(PLUG_L) -lpthread -lm -o $@

-include $(PROGRAM_O:.o=.d)

# The project's address, if there is one: port/package/homepage, or make HOMEPAGE=ADDRESS.
build/homepage: always
	@mkdir -p build
	@sh port/package/package.sh --homepage > $@.new && if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

# What is built in; changes when one comes or goes.
build/plugins: always
	@mkdir -p build
	@echo '$(PLUG_C) $(PLUG_L)' | cmp -s - $@ || echo '$(PLUG_C) $(PLUG_L)' > $@

# Tests: the same files in double, in float and with SP_SMALL, optimised little: a minute from nothing, seconds after an edit.
# White-box tests include parts, hence -MMD. TEST_O is the library's; what stands on it is small. With ONLY= most of the wait after an
# edit is the compiler's.
TEST_O  ?= $(if $(THESE),-Og,-O1)
TEST_CC  = $(Q)$(CC) $(STRICTC) $(if $(filter stonepack.c,$<),$(TEST_O),-O0) $(WARN) $(PLUG_C) -Wno-unused-function -MMD -MP

build/double/%.o: %.c
	@mkdir -p $(@D)
	$(TEST_CC) -c $< -o $@

build/float/%.o: %.c
	@mkdir -p $(@D)
	$(TEST_CC) -DSP_REAL_FLOAT -c $< -o $@

build/small/%.o: %.c
	@mkdir -p $(@D)
	$(TEST_CC) -DSP_SMALL -c $< -o $@

# The runner knows its suites: made anew when one comes or goes.
suites   = -DTEST_SUITES='$(patsubst test_%.c,X(%),$(notdir $1))'
build/double/run$(OF).o build/float/run$(OF).o: tests/run.c $(SUITE_C)
	@mkdir -p $(@D)
	$(TEST_CC) $(if $(findstring /float/,$@),-DSP_REAL_FLOAT) $(call suites,$(SUITE_C)) -c $< -o $@

build/small/run$(OF).o: tests/run.c $(SMALL_C) tests/small/suites.txt
	@mkdir -p $(@D)
	$(TEST_CC) -DSP_SMALL $(call suites,$(SMALL_C)) -c $< -o $@

# The program is linked where a suite looks into it.
LOOKS   := $(shell grep -lE '"../../(port|settle)/' $(SUITE_C) /dev/null)
UNDER    = $(if $(LOOKS),$(HOST) $(PLUG),$(GEN)) stonepack.c
RUN_O    = run$(OF).o $(patsubst %.c,%.o,$(SUITE_C) $(UNDER))
SMALL_O  = run$(OF).o $(patsubst %.c,%.o,$(SMALL_C) $(GEN) stonepack.c)
RUN_L    = $(if $(LOOKS),$(PLUG_L) -lpthread) -lm

build/run$(OF) build/run_float$(OF) build/run_small$(OF): Makefile
$(foreach p,double float,build/$p/tests/host/test_plugins.o build/$p/tests/settle/test_settle.o) \
  $(foreach p,double float program,build/$p/port/host/command/solvers.o build/$p/port/host/command/settle.o build/$p/port/host/files/meshes.o): build/plugins
# In double library and objects of the program, which are there anyway; of one wing a library that is made sooner.
OWN_O    = run.o $(SUITE_C:%.c=%.o)
build/run$(OF): $(if $(THESE),$(RUN_O:%=build/double/%),$(OWN_O:%=build/double/%) $(filter-out %/main.o,$(PROGRAM_O)) build/stonepack.o) \
  $(if $(LOOKS),$(SETTLE_O))
	$(Q)$(CC) $(filter %.o,$^) $(RUN_L) -o $@

build/run_float$(OF): $(RUN_O:%=build/float/%) $(if $(LOOKS),$(SETTLE_O))
	$(Q)$(CC) $(filter %.o,$^) $(RUN_L) -o $@

build/run_small$(OF): $(SMALL_O:%=build/small/%)
	$(Q)$(CC) $(filter %.o,$^) -lm -o $@

-include $(RUN_O:%.o=build/double/%.d) $(RUN_O:%.o=build/float/%.d) $(SMALL_O:%.o=build/small/%.d)

# The program in other precisions, for the pictures of what they cost.
build/stonepack_float: REAL = -DSP_REAL_FLOAT
build/stonepack_mixed: REAL = -DSP_REAL_MIXED
build/stonepack_float build/stonepack_mixed: $(MAIN) $(HOST) $(PLUG) $(HOST_H) $(PARTS) $(SETTLE_O) build/plugins
	$(CC) $(ALL_C) $(REAL) $(PLUG_C) $(MAIN) $(HOST) $(PLUG) stonepack.c $(SETTLE_O) $(PLUG_L) -lpthread -lm -o $@

ifeq ($(THESE),)
test: build/run build/run_float build/run_small build/stonepack
	@sh tests/checks/test.sh
else ifeq ($(SUITE_C),)
test:
	@echo "no suite and no wing of tests/ is called $(THESE)"; false
else
test: build/run$(OF) build/run_float$(OF) $(if $(SMALL_C),build/run_small$(OF))
	@sh tests/checks/test.sh $^
endif

# One number over the bundled scenes, verdicts and force bits; every other build must find the same. The library is optimised, what
# asks it not; without optimisation the pair finds it too (`make check ONLY=pair`), with all else `make check ONLY=bits`.
CORPUS = tests/corpus/corpus.c $(GEN)

build/scenes.h: tests/corpus/scenes.awk $(wildcard tests/scenes/*.obj)
	@mkdir -p build
	awk -f tests/corpus/scenes.awk tests/scenes/*.obj > $@

build/corpus-double.txt: build/stonepack.o
build/corpus-float.txt: build/float/stonepack.o
build/corpus-double.txt build/corpus-float.txt: build/corpus-%.txt: $(CORPUS) $(GEN_H) build/scenes.h
	LIBRARY=$(filter %stonepack.o,$^) sh tests/corpus/corpus.sh $* $(CC) -O0 > $@.new && mv $@.new $@

test-boards: build/corpus-double.txt build/corpus-float.txt
	+@sh port/board/boards.sh

robot:
	@$(MAKE) --no-print-directory -s -f port/board/board.mk BOARD=m4f REAL=float robot
	@$(MAKE) --no-print-directory -s -f port/board/board.mk BOARD=m7 REAL=double robot

regions:
	@$(MAKE) --no-print-directory -s -f port/board/board.mk BOARD=m4f REAL=float regions
	@$(MAKE) --no-print-directory -s -f port/board/board.mk BOARD=m7 REAL=double regions

footprint:
	@mkdir -p build
	sh port/board/footprint.sh > build/footprint.csv && mv build/footprint.csv port/board/footprint.csv
	sh port/board/switches.sh --write

demo: build/stonepack
	@sh tests/checks/demo.sh

pair: build/pair/stonepack.c

build/pair/stonepack.c: $(PARTS) port/pair/pair.sh
	sh port/pair/pair.sh stonepack.c build/pair

package:
	sh port/package/package.sh build/package/stonepack

# A release: one tarball, and Debian packages of it.
.PHONY: dist deb
dist: docs
	@sh port/package/dist.sh

deb: dist
	@sh port/package/deb.sh

# The page: the library, the program's reader and its reports as WebAssembly, three.js, all in one file.
PAGE_F   = $(filter-out $(addprefix port/host/files/,file.c meshes.c raster.c drawn.c done.c csv_out.c qps_read.c),$(wildcard port/host/files/*.c))
PAGE_H   = $(addprefix port/host/,run.c tilt.c motion.c reason.c weakest.c $(addprefix command/,options.c solvers.c report.c report_text.c report_json.c))
PAGE_C   = stonepack.c $(wildcard port/page/*.c port/host/picture/*.c) $(PAGE_F) $(PAGE_H)
PAGE_O   = $(PAGE_C:%.c=build/page/%.o)
WASM_CC ?= clang

page:
	@lacks=$$(sh port/page/build.sh --lacks) && if [ "$$lacks" ]; then echo "make page lacks"; echo "$$lacks"; echo "make deps installs it"; exit 1; fi
	@$(MAKE) --no-print-directory build/page/stonepack.html

build/page/stonepack.html: build/page/core.wasm $(wildcard port/page/*) tests/scenes tests/examples
	@sh port/page/build.sh

build/page/core.wasm: $(PAGE_O) port/page/build.sh
	@sh port/page/build.sh --core $(PAGE_O)

build/page/%.o: %.c
	@mkdir -p $(@D)
	$(Q)$(WASM_CC) --target=wasm32-wasi $(STRICTC) $(if $(filter stonepack.c,$<),-O2,-Os) $(WARN) -DSP_SQRT=__builtin_sqrt -MMD -MP -c $< -o $@

-include $(PAGE_O:.o=.d)

# Library, header, program, and what pkg-config and CMake look for.
PREFIX ?= /usr/local
TO      = $(DESTDIR)$(PREFIX)
SHARE   = man/man1 bash-completion/completions zsh/site-functions

# Manual page and completions, from the texts of --help.
docs: build/doc/stonepack.1 build/doc/stonepack.bash build/doc/_stonepack
build/doc/stonepack.1 build/doc/stonepack.bash build/doc/_stonepack: build/stonepack
	@mkdir -p build/doc
	build/stonepack help $(if $(filter %.1,$@),man,$(if $(filter %.bash,$@),bash,zsh)) > $@.new && mv $@.new $@

install: build/libstonepack.a build/stonepack docs
	install -d $(TO)/bin $(TO)/include $(TO)/lib/pkgconfig $(TO)/lib/cmake/stonepack $(addprefix $(TO)/share/,$(SHARE))
	install -m 644 build/doc/stonepack.1 $(TO)/share/man/man1/
	install -m 644 build/doc/stonepack.bash $(TO)/share/bash-completion/completions/stonepack
	install -m 644 build/doc/_stonepack $(TO)/share/zsh/site-functions/
	install build/stonepack $(TO)/bin/
	install -m 644 stonepack.h $(TO)/include/
	install -m 644 build/libstonepack.a $(TO)/lib/
	sh port/package/package.sh --fill port/package/stonepack.pc $(PREFIX) > $(TO)/lib/pkgconfig/stonepack.pc
	for f in stonepackConfig stonepackConfigVersion; do \
	    sh port/package/package.sh --fill port/package/$$f.cmake $(PREFIX) > $(TO)/lib/cmake/stonepack/$$f.cmake || exit 1; done

install-shared: $(SHARED)
	install -d $(TO)/lib
	install $(SHARED) $(TO)/lib/
	ln -sf $(notdir $(SHARED)) $(TO)/lib/$(SONAME)
	ln -sf $(SONAME) $(TO)/lib/libstonepack.so

# The library under sanitizers, for several groups of check.
build/asan.o: $(PARTS)
	@mkdir -p build
	$(CC) $(STRICTC) -O1 -g -fPIC -fsanitize=address,undefined -fno-sanitize-recover=all -c stonepack.c -o $@

check: all pair build/run build/run_float build/run_small build/corpus-double.txt build/corpus-float.txt build/asan.o build/bench $(SHARED) \
  $(if $(shell command -v $(PYTHON) 2> /dev/null),build/python/made)
	@PLUGINS='$(PLUGINS)' PLUG_C='$(PLUG_C)' PLUG_L='$(PLUG_L)' sh tests/checks/check.sh

fuzz: build/stonepack
	@sh tests/fuzz/fuzz.sh

nightly: all build/corpus-double.txt build/corpus-float.txt $(if $(shell command -v $(PYTHON) 2> /dev/null),build/python/made)
	@sh tests/checks/nightly.sh

deps:
	sh tests/checks/deps.sh

build/bench: tests/bench/bench.c $(GEN) $(GEN_H) build/libstonepack.a
	$(CC) $(ALL_C) -DBENCH_FLAGS='"$(CFLAGS)"' $(filter %.c %.a,$^) -lm -o $@

bench: build/bench
	@sh tests/bench/bench.sh

build/bench-plan: tests/bench/plan.c tests/scenes/kinds.h $(GEN) $(GEN_H) $(READ) build/libstonepack.a
	$(CC) $(ALL_C) $(filter %.c %.a,$^) -lm -o $@

bench-plan: build/bench-plan
	@build/bench-plan $(SCENES)

figures: build/stonepack build/stonepack_mixed build/stonepack_float
	@sh tests/bench/figures.sh

# Assemblies of known truth, and compas_cra's own against the times of Ipopt that come with them.
CASES ?= ../shared/cases
bench-coupled: build/stonepack
	@python3 -B tests/bench/coupled.py build/stonepack $(CASES)

# Others' solvers, those that are installed.
bench-peers: build/stonepack build/libstonepack.a
	@CC="$(CC)" SCS="$(SCS)" QOCO="$(QOCO)" ECOS="$(ECOS)" PIQP="$(PIQP)" OSQP="$(OSQP)" QPS="$(QPS)" LONG="$(LONG)" TEXT="$(TEXT)" \
	    sh tests/bench/peers/peers.sh

clean:
	rm -rf build
