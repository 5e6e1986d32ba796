/* Frama-C Eva: solvers of linear systems and programs, of any numbers at all and of a size and pattern that are given; groups
 * and words. Each piece of an arena is memory of its own. */
#define EVA_PIECES
#include "eva.h"
#include "../../solvers/base/words.c"
#include "../../solvers/base/groups.c"
#include "../../solvers/linear/band.c"
#include "../../solvers/linear/bchol.c"
#include "../../solvers/linear/cg.c"
#include "../../solvers/linear/ldl.c"
#include "../../solvers/linear/lp.c"
#include "../../solvers/linear/simplex.c"

enum { NODES = 4, BAND = 5, HALF = 2, DENSE = 3, WAYS = SP__ORDER_WAYS, STEPS = 6 };

/* Graphs of four nodes: none, a path, a star, a cycle, a cycle with a diagonal, all edges. */
enum { GRAPHS = 6, EDGES = 6 };
static const unsigned char graph[GRAPHS][EDGES][2] = {
    { { 0 } }, { { 0, 1 }, { 1, 2 }, { 2, 3 } }, { { 0, 1 }, { 0, 2 }, { 0, 3 } }, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 0, 3 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 0, 3 }, { 1, 3 } }, { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }
};
static const int edges_of[GRAPHS] = { 0, 3, 3, 4, 5, 6 };
static int32_t xadj[NODES + 1], adj[2 * EDGES], stamp[NODES], perm[NODES], parent[NODES];

static void graph_rows(int g)
{
    int32_t to = 0;
    for (int32_t i = 0; i < NODES; i++) {
        xadj[i] = to;
        for (int e = 0; e < edges_of[g]; e++)
            for (int side = 0; side < 2; side++) if (graph[g][e][side] == i) adj[to++] = graph[g][e][1 - side];
    }
    xadj[NODES] = to;
}

/* Every way to break ties. */
void eva_order(void)
{
    for (int g = 0; g < GRAPHS; g++)
        for (int way = 0; way <= WAYS; way++) {
            graph_rows(g);
            sp__order_run(NODES, xadj, adj, way, memory_of(0), stamp, perm);
        }
}

/* Factor and solution of blocks of 6 x 6 and of 3 x 3. */
static void blocks(int g, int32_t rows)
{
    static sp_real b[6 * NODES], x[6 * NODES];
    int32_t turned;
    sp_arena a = memory_of(0);
    sp__bchol f;
    graph_rows(g);
    sp__bchol_carve_pattern(&f, NODES, &a);
    f.rows = rows;
    const int32_t nnz = sp__bchol_analyse(&f, xadj, adj, parent, stamp, memory_of(0));
    sp__bchol_carve_values(&f, nnz, &a);
    sp__bchol_pattern(&f, xadj, adj, parent, stamp);
    for (int32_t i = 0; i < NODES; i++)
        for (int32_t q = xadj[i]; q < xadj[i + 1]; q++) sp__bchol_slot(&f, i, adj[q], &turned);
    sp__bchol_zero(&f);
    any_numbers(f.d, (rows == 3 ? 6 : 21) * NODES);
    any_numbers(f.x, (rows == 3 ? 9 : 36) * nnz);
    any_numbers(b, 6 * NODES);
    sp__bchol_balance(&f, any());
    if (rows == 3) {
        sp__bchol3_factor(&f, any(), NULL);
        sp__bchol_unbalance(&f);
        sp__bchol3_solve(&f, b);
    } else {
        sp__bchol_factor(&f, any(), NULL);
        sp__bchol_unbalance(&f);
        sp__bchol_solve(&f, b, x);
    }
}

void eva_bchol(void) { for (int g = 0; g < GRAPHS; g++) blocks(g, 6); }
void eva_bchol_small(void) { for (int g = 0; g < GRAPHS; g++) blocks(g, 3); }

static sp_real entry[EDGES];
static void edges(const void *what, sp__entry take, void *to)
{
    const int g = *(const int *)what;
    for (int e = 0; e < edges_of[g]; e++) take(to, graph[g][e][0], graph[g][e][1], entry[e]);
}

void eva_ldl(void)
{
    static sp_real b[NODES], x[NODES];
    for (int g = 0; g < GRAPHS; g++) {
        sp_arena a = memory_of(0);
        sp__ldl f;
        any_numbers(entry, EDGES);
        any_numbers(b, NODES);
        sp__ldl_carve(&f, NODES, 2, edges_of[g], &a);
        sp__ldl_carve_factor(&f, sp__ldl_analyse(&f, edges, &g, memory_of(0)), &a);
        sp__ldl_values(&f, edges, &g);
        for (int32_t k = 0; k < NODES; k++) sp__ldl_diagonal(&f, k, any());
        sp__ldl_factor(&f);
        sp__ldl_solve(&f, b, x, 1);
    }
}

/* Every size up to BAND rows, every band up to HALF beside the diagonal. */
void eva_band(void)
{
    static sp_real x[BAND];
    for (int32_t n = 0; n <= BAND; n++)
        for (int32_t h = 0; h <= HALF; h++) {
            sp_arena a = memory_of(0);
            sp__band A;
            sp__band_carve(&A, n, h, &a);
            sp__band_zero(&A);
            any_numbers(A.a, n * (3 * h + 1));
            any_numbers(x, BAND);
            if (sp__band_factor(&A)) sp__band_solve(&A, x);
        }
}

static void apply(const void *what, const sp_real *v, sp_real *mv)
{
    (void)what;
    for (int i = 0; i < DENSE; i++) mv[i] = v[i] * any();
}

void eva_cg(void)
{
    static sp_real b[DENSE], x[DENSE];
    sp_arena a = memory_of(0);
    sp__cg cg;
    sp__cg_carve(&cg, DENSE, &a);
    any_numbers(b, DENSE); any_numbers(x, DENSE); any_numbers(cg.inverse, DENSE);
    sp__cg_solve(&cg, apply, NULL, b, x, any_whole(INT32_MIN, INT32_MAX), any());
}

/* Rows 0: x0 x2, 1: none, 2: x1 x2, 3: x0 x1 x2, and their columns. */
enum { ROWS = 4, ENTRIES = 7 };
static const int32_t row_start[ROWS + 1] = { 0, 2, 2, 4, 7 }, row_index[ENTRIES] = { 0, 2, 1, 2, 0, 1, 2 };
static const int32_t column_start[DENSE + 1] = { 0, 2, 4, 7 }, column_index[ENTRIES] = { 0, 3, 2, 3, 0, 2, 3 };

/* Any bounds, up to STEPS steps, then a row that leaves. */
void eva_lp(void)
{
    sp_arena a = memory_of(0);
    sp__lp lp;
    sp__lp_carve(&lp, DENSE, ROWS, ENTRIES, &a);
    memcpy(lp.start, row_start, sizeof row_start);
    memcpy(lp.index, row_index, sizeof row_index);
    any_numbers(lp.value, ENTRIES); any_numbers(lp.lower, DENSE + ROWS); any_numbers(lp.upper, DENSE + ROWS);
    sp__lp_start(&lp);
    lp.limit = any_whole(0, INT32_MAX);
    sp__lp_run(&lp, any_whole(INT32_MIN, STEPS));
    sp__lp_deactivate(&lp, any_whole(0, ROWS - 1));
}

void eva_simplex(void)
{
    sp_arena a = memory_of(0);
    sp__simplex s;
    sp__simplex_carve(&s, ROWS, DENSE, ENTRIES, &a);
    memcpy(s.start, column_start, sizeof column_start);
    memcpy(s.index, column_index, sizeof column_index);
    any_numbers(s.value, ENTRIES); any_numbers(s.b, ROWS);
    any_numbers(s.lower, DENSE + ROWS); any_numbers(s.upper, DENSE + ROWS);
    any_numbers(s.cost, DENSE + ROWS); any_numbers(s.x, DENSE + ROWS);
    s.limit = any_whole(0, INT32_MAX);
    if (sp__simplex_meet(&s, any_whole(INT32_MIN, STEPS))) sp__simplex_run(&s, any_whole(INT32_MIN, STEPS));
}

/* Of up to 1000 numbers, in any groups. */
void eva_groups(void)
{
    static int32_t up[1000];
    const int32_t n = any_whole(1, 1000);
    for (int32_t i = 0; i < n; i++) up[i] = any_whole(0, n - 1);
    sp__root(up, any_whole(0, n - 1));
    sp__join(up, any_whole(0, n - 1), any_whole(0, n - 1));
}

/* What any value of any enumeration is called. */
void eva_words(void)
{
    for (int of = -1; of < 20; of++) sp_text((sp_words)of, any_whole(-100, INT32_MAX));
}
