/* Elimination orders: every node once, no fill where there need be none, little fill on a grid. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/order.c"

enum { NODES = 400, EDGES = 6000 };

typedef struct graph { int32_t n, xadj[NODES + 1], adj[EDGES]; unsigned char meet[NODES][NODES]; } graph;

static graph g;                                         /* test memory, too large for a stack */
static unsigned char fill[NODES][NODES];

static void start(int32_t n)
{
    g.n = n;
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) g.meet[i][j] = 0;
}

static void edge(int32_t i, int32_t j)
{
    if (i != j) g.meet[i][j] = g.meet[j][i] = 1;
}

static void finish(void)
{
    int32_t m = 0;
    for (int32_t i = 0; i < g.n; i++) {
        g.xadj[i] = m;
        for (int32_t j = 0; j < g.n; j++)
            if (g.meet[i][j] && m < EDGES) g.adj[m++] = j;
    }
    g.xadj[g.n] = m;
}

/* Edges that elimination in this order adds, by doing it; -1 if the order is no permutation. */
static int32_t added(const int32_t *perm)
{
    unsigned char done[NODES] = { 0 };
    int32_t count = 0;
    for (int32_t i = 0; i < g.n; i++)
        for (int32_t j = 0; j < g.n; j++) fill[i][j] = g.meet[i][j];
    for (int32_t k = 0; k < g.n; k++) {
        const int32_t p = perm[k];
        if (p < 0 || p >= g.n || done[p]) return -1;
        done[p] = 1;
        for (int32_t i = 0; i < g.n; i++)
            for (int32_t j = 0; j < i; j++)
                if (!done[i] && !done[j] && fill[i][p] && fill[j][p] && !fill[i][j]) fill[i][j] = fill[j][i] = 1, count++;
    }
    return count;
}

static int32_t fill_of(int way)
{
    int32_t perm[NODES], stamp[NODES];
    sp_arena a = test_arena;
    sp_arena dry = sp__arena_dry();
    sp__order o;
    sp__order_carve(&o, g.n, g.xadj[g.n], way, &dry);
    a.capacity = a.used + dry.used;                     /* what it counts is what it takes */
    for (int32_t k = 0; k < g.n; k++) perm[k] = -1;
    sp__order_run(g.n, g.xadj, g.adj, way, a, stamp, perm);
    return added(perm);
}

/* The most of all ways: every node by itself, and those that are alike together with four ways to break ties. */
static int32_t run_order(void)
{
    finish();
    int32_t most = 0;
    for (int way = 0; way <= SP__ORDER_WAYS && most >= 0; way++) {
        const int32_t edges = fill_of(way);
        if (edges < 0 || edges > most) most = edges;
    }
    return most;
}

TEST(chain_has_no_fill)
{
    start(NODES);
    for (int32_t i = 1; i < g.n; i++) edge(i - 1, i);
    CHECK_INT(run_order(), 0);
}

TEST(tree_has_no_fill)
{
    start(300);
    for (int32_t i = 1; i < g.n; i++) edge(i, test_random_int(0, i - 1));
    CHECK_INT(run_order(), 0);
}

TEST(star_and_complete_graph_have_no_fill)
{
    start(50);
    for (int32_t i = 1; i < g.n; i++) edge(0, i);
    CHECK_INT(run_order(), 0);
    start(40);
    for (int32_t i = 0; i < g.n; i++)
        for (int32_t j = 0; j < i; j++) edge(i, j);
    CHECK_INT(run_order(), 0);
}

TEST(lone_nodes_are_ordered_too)
{
    start(1);
    CHECK_INT(run_order(), 0);
    start(7);
    CHECK_INT(run_order(), 0);
    start(9);
    edge(2, 7);
    CHECK_INT(run_order(), 0);
}

TEST(grid_fill_is_well_below_that_of_the_natural_order)
{
    const int32_t side = 18;
    start(side * side);
    for (int32_t i = 0; i < side; i++)
        for (int32_t j = 0; j < side; j++) {
            if (i) edge(side * i + j, side * (i - 1) + j);
            if (j) edge(side * i + j, side * i + j - 1);
        }
    const int32_t found = run_order();
    int32_t natural[NODES];
    for (int32_t i = 0; i < g.n; i++) natural[i] = i;
    CHECK(found >= 0);
    CHECK(found < added(natural) / 2);
}

TEST(any_graph_gets_a_permutation)
{
    for (int32_t trial = 0; trial < 60; trial++) {
        start(test_random_int(1, 60));
        const int32_t m = test_random_int(0, 6 * g.n);
        for (int32_t k = 0; k < m; k++) edge(test_random_int(0, g.n - 1), test_random_int(0, g.n - 1));
        CHECK(run_order() >= 0);
    }
}

#if SP__WITH_LARGE
/* Every node of a grid six times: blocks of equal columns, as six rows of a stone are. */
TEST(nodes_that_are_alike_fill_no_more_than_one_of_them)
{
    const int32_t side = 5, times = 6;
    start(side * side * times);
    for (int32_t i = 0; i < g.n; i++)
        for (int32_t j = 0; j < i; j++) {
            const int32_t a = i / times, b = j / times, dx = a % side - b % side, dy = a / side - b / side;
            if (dx * dx + dy * dy <= 1) edge(i, j);
        }
    finish();
    const int32_t alone = fill_of(0), merged = fill_of(1);
    CHECK(merged >= 0);
    CHECK(merged <= alone);
}

/* 10 sqrt(400) = 200 neighbours: the hub waits, the chain through which it reaches everything goes first. */
TEST(hubs_come_last)
{
    start(NODES);
    for (int32_t i = 1; i < g.n; i++) { edge(0, i); edge(i - 1, i); }
    finish();
    int32_t perm[NODES], stamp[NODES];
    sp__order_run(g.n, g.xadj, g.adj, 1, test_arena, stamp, perm);
    CHECK_INT(perm[NODES - 1], 0);
    CHECK_INT(added(perm), 0);
}
#endif

TEST_LIST(order)
    RUN(chain_has_no_fill)
    RUN(tree_has_no_fill)
    RUN(star_and_complete_graph_have_no_fill)
    RUN(lone_nodes_are_ordered_too)
    RUN(grid_fill_is_well_below_that_of_the_natural_order)
    RUN(any_graph_gets_a_permutation)
#if SP__WITH_LARGE
    RUN(nodes_that_are_alike_fill_no_more_than_one_of_them)
    RUN(hubs_come_last)
#endif
TEST_END
