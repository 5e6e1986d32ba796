/* older: calls whose version in glibc rose after 2.17, by the version they had, so that one wheel suits every Linux since 2012.
 *
 * Included before all else where the reader's library for Python is compiled (Makefile). The same code answers: hypot and pow lost
 * a wrapper that sets errno, stat and its kin were __xstat with the number of a layout. Elsewhere than on x86-64 it does nothing. */
#ifndef STONEPACK_OLDER_H
#define STONEPACK_OLDER_H

#define _XOPEN_SOURCE 700
#include <math.h>
#include <sys/stat.h>

#if defined(__GLIBC__) && defined(__x86_64__)
__asm__(".symver hypot, hypot@GLIBC_2.2.5");
__asm__(".symver pow, pow@GLIBC_2.2.5");
#if __GLIBC__ > 2 || __GLIBC_MINOR__ >= 33
__asm__(".symver __xstat, __xstat@GLIBC_2.2.5");
__asm__(".symver __lxstat, __lxstat@GLIBC_2.2.5");
__asm__(".symver __fxstat, __fxstat@GLIBC_2.2.5");
int __xstat(int layout, const char *path, struct stat *is);
int __lxstat(int layout, const char *path, struct stat *is);
int __fxstat(int layout, int file, struct stat *is);
#define stat(path, is) __xstat(1, path, is)
#define lstat(path, is) __lxstat(1, path, is)
#define fstat(file, is) __fxstat(1, file, is)
#endif
#endif
#endif
