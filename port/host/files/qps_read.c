/* qps: the QPS format, an extension of MPS.                     [Maros, Meszaros 1999, "A repository of convex QP problems"]
 *
 *   ROWS      N objective (the first; others are dropped), L <=, G >=, E =
 *   COLUMNS   column, row, value (twice); MARKER lines are noted and ignored
 *   RHS       of the objective: minus its constant
 *   RANGES    E: [rhs, rhs + R] or [rhs + R, rhs], L: [rhs - |R|, rhs], G: [rhs, rhs + |R|]
 *   BOUNDS    0 .. infinity unless said; UP below 0 without a lower bound makes that minus infinity
 *   QUADOBJ   P of 1/2 x'Px, one triangle; QMATRIX: all of it
 *
 * What is given twice, and a second set of RHS, RANGES or BOUNDS, is refused: programs differ in which of them they take.
 */
#include "file.h"
#include "qps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIELDS = 6, OBJECTIVE = -1, DROPPED = -2 };

/* Names to numbers: open addressing. */
typedef struct names { text_word *word; int32_t *value, *slot; int32_t count, room; } names;

typedef struct entry { int32_t i, j; sp_real x; } entry;
typedef struct entries { entry *at; int32_t count, room; } entries;

typedef enum section { NONE, OBJSENSE, ROWS, COLUMNS, RHS, RANGES, BOUNDS, QUADOBJ, QMATRIX, END } section;

typedef struct reader {
    const char *path;
    text_cursor at;
    int fixed;                          /* fields by columns */
    section section;
    text_word w[FIELDS];
    int words;
    names rows, columns;
    char *kind;                         /* of each row that counts: L G E */
    double *rhs, *range;                /* NaN where none */
    int32_t *filled;                    /* the last column with an entry in the row */
    text_word set[END];                 /* of sections that name one: the name */
    int32_t row_room, m;
    double *lower, *upper, *cost;       /* cost: NaN where none */
    char *given;                        /* the lower bound was given */
    int32_t column_room, marked;
    int objectives, whole;              /* whole: P is a QMATRIX */
    double constant;                    /* right-hand side of the objective, NaN where none */
    entries A, P, Q;                    /* Q: the other triangle of a QMATRIX, turned over */
    host_qp *out;
    failure *error;
} reader;

static int fail(reader *r, const char *message, text_word w)
{
    return fail_with(r->error, EXIT_SCENE, r->path, r->at.line, "%s%s%.*s%s", message, w.n ? " '" : "",
                     (int)(w.n < 60 ? w.n : 60), w.n ? w.s : "", w.n ? "'" : "");
}

static int no_memory(reader *r) { return fail_with(r->error, EXIT_MEMORY, r->path, 0, "out of memory"); }

/* Room for one more of `size` bytes in *p; 0: none. */
static int grow(void *p, int32_t count, int32_t *room, size_t size)
{
    void *more, *old;
    memcpy(&old, p, sizeof old);
    if (count < *room) return 1;
    if (*room > INT32_MAX / 4) return 0;
    *room = *room ? 2 * *room : 64;
    more = realloc(old, (size_t)*room * size);
    if (!more) return 0;
    memcpy(p, &more, sizeof more);
    return 1;
}

/* ---------------------------------------------------------------------------------------------------------------- names */

static uint32_t hash_of(text_word w)                       /* FNV-1a */
{
    uint32_t h = 2166136261u;
    for (size_t k = 0; k < w.n; k++) h = (h ^ (unsigned char)w.s[k]) * 16777619u;
    return h;
}

static int is_same(text_word a, text_word b) { return a.n == b.n && memcmp(a.s, b.s, a.n) == 0; }

/* Where the name is, or the free slot where it would be. */
static int32_t *find_slot(const names *t, text_word w)
{
    const uint32_t mask = 2 * (uint32_t)t->room - 1;
    uint32_t k = hash_of(w) & mask;
    while (t->slot[k] >= 0 && !is_same(t->word[t->slot[k]], w)) k = (k + 1) & mask;
    return t->slot + k;
}

static int names_grow(names *t)
{
    int32_t room = t->room, values = t->room;
    if (t->count < t->room) return 1;
    if (!grow(&t->word, t->count, &room, sizeof *t->word) || !grow(&t->value, t->count, &values, sizeof *t->value)) return 0;
    free(t->slot);
    t->slot = malloc(2 * (size_t)room * sizeof *t->slot);
    t->room = room;
    if (!t->slot) return 0;
    for (int32_t k = 0; k < 2 * room; k++) t->slot[k] = -1;
    for (int32_t k = 0; k < t->count; k++) *find_slot(t, t->word[k]) = k;
    return 1;
}

/* 1 added, 0 there already, -1 out of memory */
static int names_add(names *t, text_word w, int32_t value)
{
    int32_t *slot;
    if (!names_grow(t)) return -1;
    slot = find_slot(t, w);
    if (*slot >= 0) return 0;
    *slot = t->count;
    t->word[t->count] = w;
    t->value[t->count++] = value;
    return 1;
}

static int names_find(const names *t, text_word w, int32_t *value)
{
    const int32_t *slot = t->count ? find_slot(t, w) : NULL;
    if (!slot || *slot < 0) return 0;
    *value = t->value[*slot];
    return 1;
}

/* --------------------------------------------------------------------------------------------------------------- fields */

static int is_blank(char c) { return c == ' ' || c == '\t'; }

/* The non-empty fields of the line: columns 2-3, 5-12, 15-22, 25-36, 40-47, 50-61. */
static void fixed_fields(reader *r)
{
    static const int from[FIELDS] = { 1, 4, 14, 24, 39, 49 }, to[FIELDS] = { 3, 12, 22, 36, 47, 61 };
    const char *p = r->at.p, *end = p;
    while (end < r->at.end && *end != '\n' && *end != '\r') end++;
    r->words = 0;
    for (int k = 0; k < FIELDS; k++) {
        const char *a = end - p > from[k] ? p + from[k] : end, *b = end - p > to[k] ? p + to[k] : end;
        while (a < b && is_blank(*a)) a++;
        while (b > a && is_blank(b[-1])) b--;
        if (b == a) continue;
        r->w[r->words].s = a;
        r->w[r->words++].n = (size_t)(b - a);
    }
}

static int free_fields(reader *r)
{
    text_word w;
    r->words = 0;
    while (text_next_word(&r->at, &w)) {
        if (r->words == FIELDS) return fail(r, "too many words from", w);
        r->w[r->words++] = w;
    }
    return 0;
}

/* A number; beyond +-1e20 it is an infinity of the format. */
static int number(reader *r, text_word w, double *x)
{
    const char *s = w.s;
    const double sign = w.n && *s == '-' ? -1 : 1;
    size_t n = w.n;
    if (n && (*s == '-' || *s == '+')) { s++; n--; }
    if ((n == 3 || n == 8) && (*s == 'i' || *s == 'I') && (s[1] == 'n' || s[1] == 'N')) { *x = sign * 1e30; return 0; }
    switch (text_double(w, x)) {
    case TEXT_NUMBER: break;
    case TEXT_TOO_LARGE: *x = sign * 1e30; break;
    case TEXT_NO_NUMBER: return fail(r, "not a number:", w);
    }
    return 0;
}

/* A number that must be finite in this build. */
static int finite_number(reader *r, text_word w, double *x)
{
    const int status = number(r, w, x);
    return status || fabs(*x) < 1e20 ? status : fail(r, "too large:", w);
}

static int add_entry(reader *r, entries *e, int32_t i, int32_t j, double x)
{
    if (!grow(&e->at, e->count, &e->room, sizeof *e->at)) return no_memory(r);
    e->at[e->count].i = i;
    e->at[e->count].j = j;
    e->at[e->count++].x = (sp_real)x;
    return 0;
}

/* ------------------------------------------------------------------------------------------------------------- sections */

static int read_row(reader *r)
{
    const char kind = r->w[0].s[0];
    int32_t value = r->m;
    int32_t room_rhs = r->row_room, room_range = r->row_room, room_filled = r->row_room;
    int added;
    const text_word none = { "", 0 };
    if (r->words != 2 || r->w[0].n != 1) return fail(r, "a row is: N, L, G or E, and its name", none);
    if (kind != 'N' && kind != 'L' && kind != 'G' && kind != 'E') return fail(r, "unknown kind of row", r->w[0]);
    if (kind == 'N') value = r->objectives++ ? DROPPED : OBJECTIVE;
    added = names_add(&r->rows, r->w[1], value);
    if (added <= 0) return added ? no_memory(r) : fail(r, "a second row called", r->w[1]);
    if (kind == 'N') return 0;
    if (!grow(&r->rhs, r->m, &room_rhs, sizeof *r->rhs) || !grow(&r->range, r->m, &room_range, sizeof *r->range) ||
        !grow(&r->filled, r->m, &room_filled, sizeof *r->filled) || !grow(&r->kind, r->m, &r->row_room, 1))
        return no_memory(r);
    r->kind[r->m] = kind;
    r->rhs[r->m] = NAN;
    r->filled[r->m] = -1;
    r->range[r->m++] = NAN;
    return 0;
}

static int add_column(reader *r, text_word name)
{
    const int32_t n = r->columns.count;
    int32_t a = r->column_room, b = r->column_room, c = r->column_room;
    const int added = names_add(&r->columns, name, n);
    if (added <= 0) return added ? no_memory(r) : fail(r, "entries of a column must stand together:", name);
    if (!grow(&r->lower, n, &a, sizeof *r->lower) || !grow(&r->upper, n, &b, sizeof *r->upper) ||
        !grow(&r->cost, n, &c, sizeof *r->cost) || !grow(&r->given, n, &r->column_room, 1)) return no_memory(r);
    r->lower[n] = 0;
    r->upper[n] = 1e30;
    r->cost[n] = NAN;
    r->given[n] = 0;
    if (r->marked) r->out->integers++;
    return 0;
}

static int read_column(reader *r)
{
    int32_t i, j, last = r->columns.count - 1;
    const text_word none = { "", 0 };
    if (r->words >= 3 && (text_is(r->w[1], "'MARKER'") || text_is(r->w[1], "MARKER"))) {
        r->marked = text_is(r->w[2], "'INTORG'") || text_is(r->w[2], "INTORG");
        return 0;
    }
    if (r->words != 3 && r->words != 5)
        return fail(r, "a column entry is: column, row, value, and perhaps one more row and value", none);
    if (last < 0 || !is_same(r->columns.word[last], r->w[0])) {
        const int status = add_column(r, r->w[0]);
        if (status) return status;
    }
    j = r->columns.count - 1;
    for (int k = 1; k < r->words; k += 2) {
        double x;
        int status;
        if (!names_find(&r->rows, r->w[k], &i)) return fail(r, "no such row:", r->w[k]);
        status = finite_number(r, r->w[k + 1], &x);
        if (status) return status;
        if (i >= 0 ? r->filled[i] == j : i == OBJECTIVE && !isnan(r->cost[j]))
            return fail(r, "a second entry of the column in row", r->w[k]);
        if (i >= 0 && add_entry(r, &r->A, i, j, x)) return no_memory(r);
        if (i >= 0) r->filled[i] = j;
        if (i == OBJECTIVE) r->cost[j] = x;
    }
    return 0;
}

/* The section's first set names it; another one is refused. */
static int check_same_set(reader *r, text_word name)
{
    text_word *set = &r->set[r->section];
    if (!set->n) *set = name;
    return is_same(*set, name) ? 0 : fail(r, "a second set:", name);
}

/* *to <- x, the first value there. */
static int set_once(reader *r, double *to, double x, text_word what)
{
    if (!isnan(*to)) return fail(r, "a second value for", what);
    *to = x;
    return 0;
}

/* RHS and RANGES: [set] row value [row value]. */
static int read_rhs(reader *r)
{
    const text_word none = { "", 0 };
    int status = 0;
    if (r->words < 2) return fail(r, "expected a row and a value", none);
    if (r->words % 2) status = check_same_set(r, r->w[0]);
    for (int k = r->words % 2; k + 1 < r->words && !status; k += 2) {
        int32_t i;
        double x;
        if (!names_find(&r->rows, r->w[k], &i)) return fail(r, "no such row:", r->w[k]);
        status = finite_number(r, r->w[k + 1], &x);
        if (status || i == DROPPED) continue;
        if (r->section == RANGES && i < 0) return fail(r, "a range of the objective", none);
        if (r->section == RANGES) status = set_once(r, &r->range[i], x, r->w[k]);
        else status = set_once(r, i >= 0 ? &r->rhs[i] : &r->constant, x, r->w[k]);
    }
    return status;
}

static int set_bound(reader *r, text_word kind, int32_t j, double x)
{
    if (text_is(kind, "UP") || text_is(kind, "UI")) {
        r->upper[j] = x;
        if (x < 0 && !r->given[j]) r->lower[j] = -1e30;
        return 0;
    }
    r->given[j] = 1;
    if (text_is(kind, "LO") || text_is(kind, "LI")) r->lower[j] = x;
    else if (text_is(kind, "FX")) r->lower[j] = r->upper[j] = x;
    else if (text_is(kind, "FR")) { r->lower[j] = -1e30; r->upper[j] = 1e30; }
    else if (text_is(kind, "MI")) r->lower[j] = -1e30;
    else if (text_is(kind, "PL")) r->upper[j] = 1e30;
    else if (text_is(kind, "BV")) { r->lower[j] = 0; r->upper[j] = 1; }
    else return fail(r, "unknown kind of bound", kind);
    return 0;
}

/* kind [set] column [value] */
static int read_bound(reader *r)
{
    const text_word kind = r->w[0], none = { "", 0 };
    const int bare = text_is(kind, "FR") || text_is(kind, "MI") || text_is(kind, "PL") || text_is(kind, "BV");
    int32_t j;
    double x = 0;
    int status, k;
    if (r->words < 2 || r->words > 4) return fail(r, "a bound is: kind, set, column, value", none);
    if (r->words == 4) k = 2;
    else if (r->words == 2) k = 1;
    else k = bare && names_find(&r->columns, r->w[2], &j) ? 2 : 1;
    if (!bare && r->words < 3) return fail(r, "the bound has no value", none);
    if (!names_find(&r->columns, r->w[k], &j)) return fail(r, "no such column:", r->w[k]);
    status = bare ? 0 : number(r, r->w[r->words - 1], &x);
    if (!status && k == 2) status = check_same_set(r, r->w[1]);
    return status ? status : set_bound(r, kind, j, x);
}

static int read_quadratic(reader *r)
{
    const text_word none = { "", 0 };
    int32_t i, j;
    if (r->words != 3 && r->words != 5) return fail(r, "an entry is: column, column, value", none);
    if (!names_find(&r->columns, r->w[0], &j)) return fail(r, "no such column:", r->w[0]);
    for (int k = 1; k < r->words; k += 2) {
        double x;
        int status;
        if (!names_find(&r->columns, r->w[k], &i)) return fail(r, "no such column:", r->w[k]);
        status = finite_number(r, r->w[k + 1], &x);
        if (!status) status = add_entry(r, r->section == QMATRIX && i > j ? &r->Q : &r->P, i < j ? i : j, i < j ? j : i, x);
        if (status) return status;
    }
    return 0;
}

static int read_sense(reader *r, text_word w)
{
    static const char *const known[] = { "MIN", "MINIMIZE", "MINIMISE", "MINIMUM", "min",
                                         "MAX", "MAXIMIZE", "MAXIMISE", "MAXIMUM", "max" };
    const int count = (int)(sizeof known / sizeof *known);
    int k = 0;
    while (k < count && !text_is(w, known[k])) k++;
    r->out->maximise = k >= count / 2;
    return k < count ? 0 : fail(r, "neither MIN nor MAX:", w);
}

static int read_data(reader *r)
{
    const text_word none = { "", 0 };
    switch (r->section) {
    case OBJSENSE: return read_sense(r, r->w[0]);
    case ROWS: return read_row(r);
    case COLUMNS: return read_column(r);
    case RHS: case RANGES: return read_rhs(r);
    case BOUNDS: return read_bound(r);
    case QUADOBJ: case QMATRIX: return read_quadratic(r);
    case NONE: case END: break;
    }
    return fail(r, "data outside a section", none);
}

static int read_header(reader *r)
{
    static const struct { const char *name; section section; } known[] = {
        { "NAME", NONE }, { "OBJSENSE", OBJSENSE }, { "ROWS", ROWS }, { "COLUMNS", COLUMNS }, { "RHS", RHS },
        { "RANGES", RANGES }, { "BOUNDS", BOUNDS }, { "QUADOBJ", QUADOBJ }, { "QSECTION", QUADOBJ }, { "QMATRIX", QMATRIX },
        { "ENDATA", END },
    };
    text_word w, more;
    const text_word none = { "", 0 };
    if (!text_next_word(&r->at, &w)) return fail(r, "an empty header", none);
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (text_is(w, known[k].name)) {
            r->section = known[k].section;
            r->whole |= r->section == QMATRIX;
            if (k == 0 && text_next_word(&r->at, &more)) r->out->name = more;
            return k == 1 && text_next_word(&r->at, &more) ? read_sense(r, more) : 0;
        }
    return fail(r, "unknown section", w);
}

static int read_lines(reader *r)
{
    const text_word none = { "", 0 };
    do {
        int status = 0;
        const char *p = r->at.p;
        while (p < r->at.end && is_blank(*p)) p++;
        if (p == r->at.end || *p == '\n' || *p == '\r' || *p == '*') continue;
        if (p == r->at.p) status = read_header(r);
        else {
            if (r->fixed) fixed_fields(r);
            else status = free_fields(r);
            if (!status && r->words > 0) status = read_data(r);
        }
        if (status) return status;
    } while (r->section != END && text_next_line(&r->at));
    if (r->section != END) return fail(r, "the file ends without ENDATA", none);
    if (r->columns.count == 0) return fail(r, "there is no column", none);
    return 0;
}

/* ---------------------------------------------------------------------------------------------------------- the problem */

static int is_bounded(const reader *r, int32_t j) { return r->lower[j] > -1e20 || r->upper[j] < 1e20; }

/* [l, u] of row i. */
static void row_bounds(const reader *r, int32_t i, double *l, double *u)
{
    const double b = isnan(r->rhs[i]) ? 0 : r->rhs[i], R = r->range[i], size = fabs(R);
    *l = r->kind[i] == 'L' ? -1e30 : b;
    *u = r->kind[i] == 'G' ? 1e30 : b;
    if (isnan(R)) return;
    if (r->kind[i] == 'L' || (r->kind[i] == 'E' && R < 0)) *l = b - size;
    else *u = b + size;
}

/* Entries to columns in the arena; sign turns a problem of the largest. */
static sp_status make_columns(const entries *e, int32_t rows, int32_t cols, double sign, sp_arena *arena, sp_csc *out)
{
    sp_triplets t = { rows, cols, e->count, NULL, NULL, NULL };
    const size_t room = (size_t)e->count + 1;
    sp_status status = SP_E_MEMORY;
    t.i = malloc(room * sizeof *t.i);
    t.j = malloc(room * sizeof *t.j);
    t.x = malloc(room * sizeof *t.x);
    if (t.i && t.j && t.x) {
        for (int32_t k = 0; k < e->count; k++) {
            t.i[k] = e->at[k].i;
            t.j[k] = e->at[k].j;
            t.x[k] = (sp_real)sign * e->at[k].x;
        }
        status = sp_csc_from(&t, arena, out);
    }
    free(t.i);
    free(t.j);
    free(t.x);
    return status;
}

/* Has Q the entries of P above its diagonal, and no others? */
static int is_symmetric(const sp_csc *P, const sp_csc *Q)
{
    int32_t q = 0;
    for (int32_t j = 0; j < P->cols; j++)
        for (int32_t k = P->p[j]; k < P->p[j + 1]; k++) {
            if (P->i[k] == j) continue;
            if (q >= Q->p[j + 1] || Q->i[q] != P->i[k] || Q->x[q] < P->x[k] || Q->x[q] > P->x[k]) return 0;
            q++;
        }
    return q == Q->p[Q->cols];
}

static int fail_whole(reader *r, const char *what) { return fail_with(r->error, EXIT_SCENE, r->path, 0, "%s", what); }

/* Rows of the file, then one row for each bounded column: count them, refuse bounds that leave nothing.    *m: of all rows */
static int add_bound_rows(reader *r, int32_t *m)
{
    const int32_t n = r->columns.count;
    int32_t bounds = 0;
    for (int32_t j = 0; j < n; j++) {
        const text_word name = r->columns.word[j];
        if (!(r->lower[j] <= r->upper[j] && r->lower[j] < 1e20 && r->upper[j] > -1e20))
            return fail_with(r->error, EXIT_SCENE, r->path, 0, "the bounds of column '%.*s' leave nothing",
                             (int)(name.n < 60 ? name.n : 60), name.s);
        bounds += is_bounded(r, j);
    }
    *m = r->m;
    if (bounds > INT32_MAX / 2 - *m) return no_memory(r);
    r->out->rows = r->m;
    r->out->entries = r->A.count;
    for (int32_t j = 0; j < n; j++)
        if (is_bounded(r, j) && add_entry(r, &r->A, (*m)++, j, 1)) return no_memory(r);
    return 0;
}

/* q of the columns, l and u of all rows. */
static void write_vectors(const reader *r, double sign, sp_real *q, sp_real *l, sp_real *u)
{
    for (int32_t j = 0, i = r->m; j < r->columns.count; j++) {
        q[j] = isnan(r->cost[j]) ? 0 : (sp_real)(sign * r->cost[j]);
        if (!is_bounded(r, j)) continue;
        l[i] = (sp_real)r->lower[j];
        u[i++] = (sp_real)r->upper[j];
    }
    for (int32_t i = 0; i < r->m; i++) {
        double low, high;
        row_bounds(r, i, &low, &high);
        l[i] = (sp_real)low;
        u[i] = (sp_real)high;
    }
}

/* Bytes of n + 2 m numbers, of the matrices, and of what sp_csc_from takes for itself. */
static size_t bytes_of(const reader *r, int32_t n, int32_t m)
{
    const size_t numbers = (size_t)n + 2 * (size_t)m, each = sizeof(sp_real) + 2 * sizeof(int32_t);
    const size_t count = (size_t)r->A.count + (size_t)r->P.count + (size_t)r->Q.count;
    return 1024 + numbers * sizeof(sp_real) + (count * 2 + 5 * ((size_t)n + (size_t)m)) * each;
}

static int build_problem(reader *r)
{
    const int32_t n = r->columns.count;
    const double sign = r->out->maximise ? -1 : 1;
    int32_t m = 0;
    int status = add_bound_rows(r, &m);
    if (status) return status;

    const size_t bytes = bytes_of(r, n, m);
    sp_arena arena;
    sp_csc A, P, Q;
    r->out->memory = malloc(bytes);
    if (!r->out->memory || sp_arena_init(&arena, r->out->memory, bytes) != SP_OK) return no_memory(r);
    sp_real *q = (sp_real *)(void *)arena.base, *l = q + n, *u = l + m;
    arena.used = ((size_t)n + 2 * (size_t)m) * sizeof(sp_real);
    write_vectors(r, sign, q, l, u);
    if (make_columns(&r->A, m, n, 1, &arena, &A) != SP_OK || make_columns(&r->P, n, n, sign, &arena, &P) != SP_OK
        || make_columns(&r->Q, n, n, sign, &arena, &Q) != SP_OK) return no_memory(r);
    if (P.p[n] + Q.p[n] < r->P.count + r->Q.count)
        return fail_whole(r, "an entry of P is given twice (of QUADOBJ, either triangle)");
    if (r->whole && !is_symmetric(&P, &Q)) return fail_whole(r, "QMATRIX is not symmetric");
    const sp_qp qp = { n, m, P.p, P.i, P.x, q, A.p, A.i, A.x, l, u };
    r->out->qp = qp;
    return 0;
}

static void reader_free(reader *r)
{
    free(r->rows.word); free(r->rows.value); free(r->rows.slot);
    free(r->columns.word); free(r->columns.value); free(r->columns.slot);
    free(r->kind); free(r->rhs); free(r->range); free(r->filled);
    free(r->lower); free(r->upper); free(r->cost); free(r->given);
    free(r->A.at); free(r->P.at); free(r->Q.at);
}

static int read_as(int fixed, const char *path, size_t length, host_qp *qp, failure *error)
{
    reader r;
    int status;
    memset(&r, 0, sizeof r);
    r.path = path;
    r.fixed = fixed;
    r.out = qp;
    r.error = error;
    r.at.p = qp->text;
    r.at.end = qp->text + length;
    r.at.line = 1;
    qp->constant = 0;
    qp->maximise = 0;
    qp->integers = 0;
    r.constant = NAN;
    status = read_lines(&r);
    if (!status && !isnan(r.constant)) qp->constant = -r.constant;
    if (!status) status = build_problem(&r);
    if (status) {
        free(qp->memory);
        qp->memory = NULL;
    }
    reader_free(&r);
    return status;
}

int qps_read(const char *path, host_qp *qp, failure *error)
{
    size_t length;
    failure other;
    int status;
    memset(qp, 0, sizeof *qp);
    status = file_read(path, &qp->text, &length, error);
    if (status) return status;
    status = read_as(0, path, length, qp, error);
    if (status != EXIT_SCENE || read_as(1, path, length, qp, &other)) return status;
    error->status = 0;                                  /* names with blanks: the columns told them apart */
    return 0;
}

void qps_free(host_qp *qp)
{
    free(qp->text);
    free(qp->memory);
}
