# board: one target, one precision.
#
#     make -f port/board/board.mk BOARD=m4f [REAL=float] tests | corpus | cost | sizes | robot | regions
#
#     tests      the suites of tests/, less those too large for it (named, with the reason)
#     corpus     the number over the bundled scenes, compared with that of build/corpus; bytes too where pointers have 64 bits
#     cost       a few scenes: their verdicts, and memory, stack and instructions they took
#     sizes      arches and walls of 8 to 60 stones: memory of each question, the most that checks near their limit take
#     robot      a gripper that asks whether it may let go of a stone; its answers to robot.txt, compared with those there
#     regions    a check with its factor in another memory than scene and answer
#
# A bare board is simulated by qemu-system, has its own start-up code and no C library; the others are Linux programs run by
# qemu-user. Run from the top folder.

BOARD ?= m4f
REAL  ?= double

# Bare boards: compiler prefix, start-up file, memory map, processor, simulator; CLOCK: MHz of Cortex-M's SysTick.
ARM   = arm-none-eabi-
RISCV = riscv64-unknown-elf-
QARM  = qemu-system-arm -M

m3.cross = $(ARM)
m3.start = cortexm
m3.map   = mps2-m3m4
m3.cpu   = -mcpu=cortex-m3 -mthumb -mfloat-abi=soft
m3.qemu  = $(QARM) mps2-an385

m4f.cross = $(ARM)
m4f.start = cortexm
m4f.map   = mps2-m3m4
m4f.cpu   = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
m4f.qemu  = $(QARM) mps2-an386

m7.cross = $(ARM)
m7.start = cortexm
m7.map   = mps2-m7
m7.cpu   = -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16
m7.qemu  = $(QARM) mps2-an500

m33.cross = $(ARM)
m33.start = cortexm
m33.map   = mps2-m33
m33.cpu   = -mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16
m33.qemu  = $(QARM) mps2-an505
m33.clock = 20

m55.cross = $(ARM)
m55.start = cortexm
m55.map   = mps3-m55
m55.cpu   = -mcpu=cortex-m55 -mthumb -mfloat-abi=hard
m55.qemu  = $(QARM) mps3-an547
m55.clock = 32

a53.cross = aarch64-linux-gnu-
a53.start = aarch64
a53.map   = virt-aarch64
a53.cpu   = -mcpu=cortex-a53 -mstrict-align -fno-pic -static -no-pie -Wl,--build-id=none
a53.qemu  = qemu-system-aarch64 -M virt -nic none -cpu cortex-a53

rv32imac.cross = $(RISCV)
rv32imac.start = riscv
rv32imac.map   = virt-riscv
rv32imac.cpu   = -march=rv32imac -mabi=ilp32 -mcmodel=medany
rv32imac.qemu  = qemu-system-riscv32 -M virt -bios none -cpu rv32

rv32gc.cross = $(RISCV)
rv32gc.start = riscv
rv32gc.map   = virt-riscv
rv32gc.cpu   = -march=rv32imafdc -mabi=ilp32d -mcmodel=medany
rv32gc.qemu  = $(rv32imac.qemu)

rv64gc.cross = $(RISCV)
rv64gc.start = riscv
rv64gc.map   = virt-riscv
rv64gc.cpu   = -march=rv64imafdc -mabi=lp64d -mcmodel=medany
rv64gc.qemu  = qemu-system-riscv64 -M virt -bios none -cpu rv64

# Linux programs: big-endian, 32 bits.
armhf.cross   = arm-linux-gnueabihf-
armhf.qemu    = qemu-arm
powerpc.cross = powerpc-linux-gnu-
powerpc.qemu  = qemu-ppc
mips.cross    = mips-linux-gnu-
mips.qemu     = qemu-mips
s390x.cross   = s390x-linux-gnu-
s390x.cpu     = -fexcess-precision=fast
s390x.qemu    = qemu-s390x
i686.cross    = i686-linux-gnu-
i686.cpu      = -msse2 -mfpmath=sse
i686.qemu     = qemu-i386

# Tests of more work are left out, in thousands of steps of needs.txt, some eight instructions each; on processors that do
# floating point in software, which takes some thirty times as many, earlier. MOST=N: everywhere tests of more than N.
limit = 8000
soft  = 800
rv64gc.limit          = 32000
m4f-float.limit       = 99000
m3.limit              = $(soft)
rv32imac.limit        = $(soft)
m4f-double.limit      = $(soft)
m33-double.limit      = $(soft)

ifndef $(BOARD).qemu
$(error no such board: $(BOARD))
endif

bare    = $($(BOARD).start)
name    = $(BOARD)-$(REAL)
CROSS   = $($(BOARD).cross)
CC      = $(CROSS)gcc
OPT    ?= -O2
out    := build/board/$(name)$(filter-out -O2,$(OPT))
arena   = 12<<20
suite_c = $(shell grep -L '"\.\./\.\./port/' tests/*/test_*.c)
suites  = $(patsubst test_%.c,%,$(notdir $(suite_c)))
left    = $(shell printf '%s\n' $(firstword $($(name).limit) $($(BOARD).limit) $(limit)) $(MOST) | sort -n | head -n 1)
needs   = build/board/needs$(MOST:%=-%).txt

flags   = -std=c99 $(OPT) -ffp-contract=off -fno-math-errno -Wall -Wextra -Wno-unused-function $($(BOARD).cpu) -MMD -MP \
          $(if $(filter float,$(REAL)),-DSP_REAL_FLOAT) '-DTEST_ARENA_BYTES=((size_t)$(arena))' \
          -DTEST_SUITES='$(foreach s,$(suites),X($(s)))' \
          -DTEST_LEAVE_OUT='"../$(out)/left_out.h"'
# What hangs ends by its own work, not by how busy the machine is.
within  = ulimit -t $(or $(SECONDS_OF_CPU),1800); timeout 7200
ifneq ($(bare),)
flags  += -ffreestanding -ffunction-sections -fdata-sections -Iport/board/include -include port/board/board.h \
          -DTEST_PRINT=board_print \
          -DSP_SQRT=$(if $(filter float,$(REAL)),__builtin_sqrtf,__builtin_sqrt) \
          $(if $($(BOARD).clock),-DBOARD_MHZ=$($(BOARD).clock))
comma  := ,
link    = -nostdlib -nostartfiles -Wl,--gc-sections -Lport/board -T port/board/$($(BOARD).map).ld
libs    = -lgcc
own     = $(patsubst %,$(out)/port/board/%.o,$($(BOARD).start) board libc)
run     = $(within) $($(BOARD).qemu) -display none -monitor none -serial none -chardev stdio,id=c0 $(1) \
          -semihosting-config enable=on,target=native,chardev=c0,arg=program$(if $(2),$(comma)arg=$(2)) -kernel
else
link    = -static
libs    = -lm
own     =
run     = $(within) $($(BOARD).qemu)
endif

core    = $(own) $(out)/stonepack.o $(out)/tests/scenes/gen.o

.PHONY: tests corpus cost sizes robot regions compiler needs always

needs: $(needs)

.DEFAULT_GOAL = cost

compiler:
	@echo $(CC)
.SECONDARY:

# 4 MB of flash hold all tests at -Og, without optimisation they do not.
$(out)/tests/%.o: OPT = $(if $(bare),-Og -Wno-maybe-uninitialized,-O0)
$(out)/%.o: %.c
	@mkdir -p $(@D)
	@$(CC) $(flags) -c $< -o $@

$(out)/tests/corpus/corpus.o: flags += -Ibuild
$(out)/port/board/libc.o: flags += -fno-tree-loop-distribute-patterns

$(out)/run: $(core) $(out)/tests/run.o $(suite_c:%.c=$(out)/%.o)
	@$(CC) $(flags) $(link) $^ $(libs) -o $@

$(out)/corpus: $(core) $(out)/tests/corpus/corpus.o
	@$(CC) $(flags) $(link) $^ $(libs) -o $@

$(out)/cost: $(core) $(out)/port/board/cost.o
	@$(CC) $(flags) $(link) $^ $(libs) -o $@

$(out)/sizes: $(core) $(out)/port/board/sizes.o
	@$(CC) $(flags) $(link) $^ $(libs) -o $@

$(out)/regions: $(core) $(out)/port/board/regions.o
	@$(CC) $(flags) $(link) $^ $(libs) -o $@

$(out)/robot: $(filter-out %/gen.o,$(core)) $(out)/port/board/robot.o
	@$(CC) $(flags) $(link) $^ $(libs) -o $@

$(out)/tests/corpus/corpus.o: | build/scenes.h

build/scenes.h build/corpus-$(REAL).txt:
	@$(MAKE) --no-print-directory -s $@

corpus: $(out)/corpus build/corpus-$(REAL).txt
	@$(call run,,) $< > $(out)/corpus.txt; status=$$?; \
	    drop=$$(grep -q '^bytes 64-bit' $(out)/corpus.txt || echo '/^bytes/d'); \
	    sed "$$drop" build/corpus-$(REAL).txt > $(out)/host.txt; sed "$$drop" $(out)/corpus.txt | diff $(out)/host.txt - && \
	    [ $$status -eq 0 ] && tail -n 1 $(out)/corpus.txt

cost sizes: %: $(out)/%
	@$(call run,-icount shift=0,) $<

robot: $(out)/robot
	@$(call run,,port/board/robot.txt) $< > $(out)/robot.out; status=$$?; cat $(out)/robot.out; \
	    sed 's/ \[.*//' $(out)/robot.out > $(out)/robot.said; \
	    sed -n 's/^#= //p' port/board/robot.txt | diff - $(out)/robot.said && [ $$status -eq 0 ]

regions: $(out)/regions
	@$(call run,,) $<

tests: $(out)/run
	@$(call run,,) $<

$(out)/tests/run.o: $(out)/left_out.h

$(out)/left_out.h: $(needs) always
	@mkdir -p $(@D)
	@awk -v bytes=$$(($(arena))) -v work=$(left) \
	    'NF == 3 && ($$2 > bytes || $$3 > work) { \
	         printf "\"%s\", /* %.1f MB, %.0f M steps */\n", $$1, $$2 / 1048576, $$3 / 1000 }' \
	    $< > $@.new; cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# What each test needs, measured on the host: "name bytes thousands-of-steps", and no more of a test than can matter [work.h].
counted = -std=c99 -O1 -ffp-contract=off -fno-math-errno -fno-builtin -Wno-unused-function -Iport/board/include \
          -include stdio.h -include port/board/work.h -DTEST_PRINT=printf '-DTEST_WORK()=work_steps' \
          '-DTEST_TOO_MUCH()=WORK_START()' $(if $(MOST),'-DWORK_MOST=(1000*($(MOST)+1))') '-DTEST_ARENA_BYTES=((size_t)24<<20)' \
          -DSP_SQRT=__builtin_sqrt -DTEST_SUITES='$(foreach s,$(suites),X($(s)))'
$(needs): tests/run.c tests/test.h $(suite_c) $(wildcard port/board/work.*) stonepack.c stonepack.h $(wildcard solvers/*/*.c)
	@mkdir -p $(@D)
	@gcc $(counted) -c port/board/work.c -o build/board/work.o
	@gcc $(counted) -c tests/run.c -o build/board/run.o
	@gcc $(counted) -fsanitize-coverage=trace-pc $(suite_c) tests/scenes/gen.c stonepack.c port/board/libc.c \
	    build/board/work.o build/board/run.o -o build/board/measure
	@build/board/measure -m > $@.new; grep -q "passed," $@.new && mv $@.new $@

-include $(shell find $(out) -name '*.d' 2> /dev/null)
