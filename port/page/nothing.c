/* nothing: what the C library would ask its host for. A page has no files, so its error stream leads nowhere. */
#ifdef __wasm__
#include <stdio.h>
#include <wasi/api.h>

FILE *fopen(const char *path, const char *mode)
{
    (void)path, (void)mode;
    return NULL;
}

__wasi_errno_t __wasi_fd_close(__wasi_fd_t fd)
{
    (void)fd;
    return __WASI_ERRNO_NOSYS;
}

__wasi_errno_t __wasi_fd_seek(__wasi_fd_t fd, __wasi_filedelta_t by, __wasi_whence_t from, __wasi_filesize_t *at)
{
    (void)fd, (void)by, (void)from, (void)at;
    return __WASI_ERRNO_NOSYS;
}

__wasi_errno_t __wasi_fd_write(__wasi_fd_t fd, const __wasi_ciovec_t *what, size_t n, __wasi_size_t *written)
{
    (void)fd, (void)what, (void)n, (void)written;
    return __WASI_ERRNO_NOSYS;
}
#else
typedef int nothing;
#endif
