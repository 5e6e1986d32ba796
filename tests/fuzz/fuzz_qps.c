/* A quadratic program as any text: read and solved, or refused with a line. */
#include "fuzz.h"
#include "../../port/host/files/qps.h"

#include <unistd.h>
#include <sys/mman.h>

static uint64_t room[1 << 17], more[1 << 17];

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static int fd = -1;
    static char path[64];
    host_qp q;
    failure why;
    if (size > 4000) return 0;
    if (fd < 0) {
        fd = memfd_create("qps", 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    }
    if (ftruncate(fd, 0) || pwrite(fd, data, size, 0) != (ssize_t)size) abort();
    memset(&q, 0, sizeof q);
    memset(&why, 0, sizeof why);
    const int status = qps_read(path, &q, &why);
    HOLDS(status == 0 || why.line[0], "status %d without a line", status);
    if (!status && q.qp.n < 30 && q.qp.m < 60) {
        sp_qp_settings set = sp_qp_default();
        sp_arena a, scratch;
        sp_qp_result r;
        size_t bytes = 0;
        set.iterations = 200;
        FORGET(room, sizeof room);
        FORGET(more, sizeof more);
        sp_arena_init(&a, room, sizeof room);
        sp_arena_init(&scratch, more, sizeof more);
        if (!sp_qp_memory(&q.qp, &set, scratch, &bytes) && bytes <= a.capacity &&
            !sp_qp_solve(&q.qp, &set, &a, NULL, NULL, &r)) {
            for (int32_t k = 0; k < q.qp.n; k++) HOLDS(isfinite(r.x[k]), "x");
            HOLDS(!isnan(r.objective), "objective");
        }
    }
    qps_free(&q);
    return 0;
}
