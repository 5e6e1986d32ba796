/* fuzz: a target is one function that is given any bytes; what must hold whatever they are is told by HOLDS.
 *
 * The same file is linked with libFuzzer, with AFL++ (afl-clang-fast, its own driver), or with loop.c. */
#ifndef FUZZ_H
#define FUZZ_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define HOLDS(cond, ...) do { if (!(cond)) { \
    fprintf(stderr, "%s:%d: %s does not hold: ", __FILE__, __LINE__, #cond); \
    fprintf(stderr, __VA_ARGS__); \
    fputc('\n', stderr); \
    abort(); } } while (0)

/* Nobody has written there yet, to MSan; memory of the targets is static, which is written to it. */
#ifdef __has_feature
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define FORGET(at, n) __msan_allocated_memory(at, n)
#endif
#endif
#ifndef FORGET
#define FORGET(at, n) ((void)0)
#endif

#endif
