/* sp_qp_solve, every method and back end, wild numbers: memory as told, no NaN, what is called solved is feasible. */
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

/* A problem: its numbers, and what is asked of the calls. */
typedef struct drawn {
    int n, m;
    unsigned mode, how;
    int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[M * N];
    sp_real Px[N * N], Ax[M * N], q[N], l[M], u[M];
    sp_qp qp;
    sp_qp_settings set;
} drawn;

static void bounds(drawn *d)
{
    for (int k = 0; k < d->m; k++) {
        const sp_real a = number(), b = number();
        const unsigned open = next();
        d->l[k] = open & 1 ? (sp_real)-1e20 : a < b ? a : b;
        d->u[k] = open & 2 ? (sp_real)1e20 : open & 4 && !(open & 1) ? d->l[k] : a < b ? b : a;
    }
}

static void ask(drawn *d)
{
    static const sp_qp_method methods[4] = { SP_QP_AUTO, SP_QP_ADMM, SP_QP_INTERIOR, SP_QP_AUTO };
    d->set = sp_qp_default();
    d->set.method = methods[d->mode >> 5 & 3];
    d->set.backend = (sp_qp_backend)(d->how % 3);
    d->set.polish = d->how >> 2 & 1;
    d->set.strict = d->how >> 3 & 1;
    d->set.iterations = 300;
    if (d->how & 16) d->set.budget = 1000 * (int64_t)(d->how >> 4);
}

static void draw(drawn *d)
{
    d->n = 1 + (int)(next() % N);
    d->m = (int)(next() % M);
    d->mode = next();
    d->how = next();
    matrix(d->n, d->n, 1, d->Pp, d->Pi, d->Px);
    matrix(d->m, d->n, 0, d->Ap, d->Ai, d->Ax);
    for (int k = 0; k < d->n; k++) d->q[k] = number();
    bounds(d);
    const int linear = d->mode & 4 ? 1 : 0, free = d->m ? 0 : 1;
    const sp_qp qp = { d->n, d->m, linear ? NULL : d->Pp, linear ? NULL : d->Pi, linear ? NULL : d->Px, d->q,
                       free ? NULL : d->Ap, free ? NULL : d->Ai, free ? NULL : d->Ax, d->l, d->u };
    d->qp = qp;
    ask(d);
}

/* How many bytes sp_qp_solve wants, told within exactly the scratch it asked for; 0: the problem is refused or too large. */
static size_t memory(const drawn *d)
{
    sp_arena scratch;
    size_t bytes = 0;
    FORGET(more, sizeof more);
    sp_arena_init(&scratch, more, sizeof more);
    HOLDS(sp_qp_memory_scratch(&d->qp, &d->set) <= sizeof more, "scratch");
    scratch.capacity = sp_qp_memory_scratch(&d->qp, &d->set);
    const sp_status status = sp_qp_memory(&d->qp, &d->set, scratch, &bytes);
    HOLDS(status != SP_E_MEMORY, "scratch is not enough");
    return status || bytes > sizeof room ? 0 : bytes;
}

/* With one byte less it refuses and touches neither arena nor result. */
static void refused(const drawn *d, size_t bytes)
{
    sp_arena a;
    sp_qp_result r;
    sp_arena_init(&a, room, sizeof room);
    a.capacity = bytes - 1;
    memset(&r, 0x5a, sizeof r);
    const sp_status status = sp_qp_solve(&d->qp, &d->set, &a, NULL, NULL, &r);
    HOLDS(status != SP_OK && a.used == 0, "one byte less: status %d", (int)status);
    for (size_t k = 0; k < sizeof r; k++) HOLDS(((unsigned char *)&r)[k] == 0x5a, "byte %zu is touched", k);
}

static void numbers(const drawn *d, const sp_qp_result *r)
{
    for (int k = 0; k < d->n; k++) HOLDS(isfinite(r->x[k]), "x");
    for (int k = 0; k < d->m; k++) HOLDS(isfinite(r->y[k]), "y");
    HOLDS(!isnan(r->objective) && !isnan(r->primal) && !isnan(r->dual) && !isnan(r->gap), "status %d", (int)r->status);
}

/* l <= A x <= u within ten times what was asked; 1e20 and beyond is no bound. */
static void feasible(const drawn *d, const sp_qp_result *r)
{
    sp_real most = 0, far = 0;
    for (int k = 0; k < d->n; k++) far = fmax(far, fabs(r->x[k]));
    for (int k = 0; k < d->Ap[d->n]; k++) most = fmax(most, fabs(d->Ax[k]));
    for (int row = 0; row < d->m; row++) {
        const sp_real l = d->l[row], u = d->u[row];
        long double sum = 0;
        for (int c = 0; c < d->n; c++)
            for (int k = d->Ap[c]; k < d->Ap[c + 1]; k++) if (d->Ai[k] == row) sum += (long double)d->Ax[k] * r->x[c];
        const long double below = l > -1e20 && sum < l ? l - sum : 0;
        const long double over = u < 1e20 && sum > u ? sum - u : below;
        const sp_real bound = sum < l ? fabs(l) : fabs(u);
        HOLDS(over <= 10 * (d->set.eps_abs + d->set.eps_rel * (most * far + bound)), "row %d by %Lg", row, over);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static drawn d;
    sp_arena a;
    sp_qp_result r;
    if (size < 8 || size > 300) return 0;
    at = data; left = size;
    draw(&d);
    const size_t bytes = memory(&d);
    if (!bytes) return 0;
    if (d.mode & 16) refused(&d, bytes);
    FORGET(room, sizeof room);
    sp_arena_init(&a, room, bytes);
    const sp_status status = sp_qp_solve(&d.qp, &d.set, &a, NULL, NULL, &r);
    HOLDS(status != SP_E_MEMORY, "%zu bytes are not enough", bytes);
    if (status) return 0;
    numbers(&d, &r);
    if (r.status == SP_QP_SOLVED) feasible(&d, &r);
    return 0;
}
