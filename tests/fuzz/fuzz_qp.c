/* sp_qp_solve, three back ends, wild numbers: memory as told, no NaN, what is called solved is feasible. */
#include "fuzz.h"
#include "../../stonepack.h"

enum { N = 6, M = 8 };
static const uint8_t *at;
static size_t left;
static uint64_t room[1 << 16], more[1 << 16];

static unsigned next(void) { return left ? left--, *at++ : 0; }

static sp_real number(void)
{
    static const double some[16] = { 0, 1, -1, 2, -0.5, 3, 10, 1e-3, 1e-8, 1e8, -1e3, 0.1, 1e12, 1e-12, 0.3, -0.7 };
    const unsigned k = next();
    return k < 128 ? (sp_real)some[k % 16] : (sp_real)((int)k - 192) / 8;
}

/* A sparse matrix of rows by columns; `upper`: M'M of what is read, its upper triangle. */
static void matrix(int rows, int columns, int upper, int32_t *p, int32_t *i, sp_real *x)
{
    sp_real B[M][N];
    int32_t n = 0;
    for (int r = 0; r < rows; r++) for (int c = 0; c < columns; c++) B[r][c] = next() & 1 ? number() : 0;
    for (int c = 0; c < columns; c++) {
        p[c] = n;
        for (int r = 0; r < (upper ? c + 1 : rows); r++) {
            sp_real sum = upper ? 0 : B[r][c];
            for (int k = 0; upper && k < rows; k++) sum += B[k][r] * B[k][c];
            if (sum < 0 || sum > 0) { i[n] = r; x[n++] = sum; }
        }
    }
    p[columns] = n;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 8 || size > 300) return 0;
    at = data; left = size;
    const int n = 1 + (int)(next() % N), m = (int)(next() % M);
    const unsigned mode = next(), how = next();
    int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[M * N];
    sp_real Px[N * N], Ax[M * N], q[N], l[M], u[M];
    matrix(n, n, 1, Pp, Pi, Px);
    matrix(m, n, 0, Ap, Ai, Ax);
    for (int k = 0; k < n; k++) q[k] = number();
    for (int k = 0; k < m; k++) {
        const sp_real a = number(), b = number();
        const unsigned open = next();
        l[k] = open & 1 ? (sp_real)-1e20 : a < b ? a : b;
        u[k] = open & 2 ? (sp_real)1e20 : open & 4 && !(open & 1) ? l[k] : a < b ? b : a;
    }
    const sp_qp qp = { n, m, mode & 4 ? NULL : Pp, mode & 4 ? NULL : Pi, mode & 4 ? NULL : Px, q, m ? Ap : NULL, m ? Ai : NULL,
                       m ? Ax : NULL, l, u };
    sp_qp_settings set = sp_qp_default();
    set.backend = (sp_qp_backend)(how % 3);
    set.polish = how >> 2 & 1;
    set.strict = how >> 3 & 1;
    set.iterations = 300;
    if (how & 16) set.budget = 1000 * (int64_t)(how >> 4);
    sp_arena a, scratch;
    sp_qp_result r;
    size_t bytes = 0;
    sp_arena_init(&scratch, more, sizeof more);
    HOLDS(sp_qp_memory_scratch(&qp, &set) <= sizeof more, "scratch");
    scratch.capacity = sp_qp_memory_scratch(&qp, &set);
    sp_status status = sp_qp_memory(&qp, &set, scratch, &bytes);
    HOLDS(status != SP_E_MEMORY, "scratch is not enough");
    if (status || bytes > sizeof room) return 0;
    sp_arena_init(&a, room, sizeof room);
    a.capacity = bytes - 1;
    memset(&r, 0x5a, sizeof r);
    if (mode & 16) {
        status = sp_qp_solve(&qp, &set, &a, NULL, NULL, &r);
        HOLDS(status != SP_OK && a.used == 0, "one byte less: status %d", (int)status);
        for (size_t k = 0; k < sizeof r; k++) HOLDS(((unsigned char *)&r)[k] == 0x5a, "byte %zu is touched", k);
    }
    a.capacity = bytes;
    status = sp_qp_solve(&qp, &set, &a, NULL, NULL, &r);
    HOLDS(status != SP_E_MEMORY, "%zu bytes are not enough", bytes);
    if (status) return 0;
    sp_real most = 0, far = 0;
    for (int k = 0; k < n; k++) { HOLDS(isfinite(r.x[k]), "x"); far = fmax(far, fabs(r.x[k])); }
    for (int k = 0; k < m; k++) HOLDS(isfinite(r.y[k]), "y");
    HOLDS(!isnan(r.objective) && !isnan(r.primal) && !isnan(r.dual) && !isnan(r.gap), "status %d", (int)r.status);
    if (r.status != SP_QP_SOLVED) return 0;
    for (int k = 0; k < Ap[n]; k++) most = fmax(most, fabs(Ax[k]));
    for (int row = 0; row < m; row++) {
        long double sum = 0;
        for (int c = 0; c < n; c++)
            for (int k = Ap[c]; k < Ap[c + 1]; k++) if (Ai[k] == row) sum += (long double)Ax[k] * r.x[c];
        const long double below = l[row] > -1e20 && sum < l[row] ? l[row] - sum : 0;        /* 1e20 and beyond is no bound */
        const long double over = u[row] < 1e20 && sum > u[row] ? sum - u[row] : below;
        const sp_real bound = sum < l[row] ? fabs(l[row]) : fabs(u[row]);
        HOLDS(over <= 10 * (set.eps_abs + set.eps_rel * (most * far + bound)), "row %d by %Lg", row, over);
    }
    return 0;
}
