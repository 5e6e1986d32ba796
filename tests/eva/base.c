/* Frama-C Eva: memory, indices and kernels at capacities that are given, of any numbers at all. */
#include "eva.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/csc.c"
#include "../../solvers/linear/chol.c"
#include "../../solvers/cone/pyramids.c"
#include "../../solvers/scene/problem.c"

enum { N = 6 };

/* Pieces of any count and size: nothing overflows. */
void eva_arena(void)
{
    sp_arena a = memory_of(0), dry = sp__arena_dry();
    a.capacity = Frama_C_unsigned_long_interval(0, sizeof memory.byte);
    for (int k = 0; k < 6; k++) {
        const size_t count = Frama_C_unsigned_long_interval(0, SIZE_MAX), size = Frama_C_unsigned_long_interval(0, SIZE_MAX);
        sp__take(&a, count, size);
        sp__take(&dry, count, size);
        sp__failed(&a);
    }
}

/* Of every capacity up to 36 three pieces, filled from the first byte to the last: a byte behind it would be an alarm. */
void eva_pieces(void)
{
    static sp_real room[6];
    for (size_t bytes = 0; bytes <= 36; bytes++)
        for (size_t count = 0; count < 4; count++)
            for (size_t size = 1; size <= 8; size += 7) {
                sp_arena a;
                a.base = (unsigned char *)room + (sizeof room - bytes) / 16 * 16;
                a.capacity = bytes; a.used = a.peak = 0;
                for (int k = 0; k < 3; k++) {
                    unsigned char *piece = sp__take(&a, count, size);
                    if (piece && count) piece[0] = piece[count * size - 1] = 1;
                }
            }
}

static int before(const void *what, int32_t i, int32_t j) { (void)what; return any_whole(0, 1) && i < j; }

/* A rule that is none sorts nothing, and steps nowhere outside. */
void eva_sort(void)
{
    int32_t p[N];
    for (int32_t n = 0; n <= N; n++) {
        for (int32_t k = 0; k < n; k++) p[k] = k;
        sp__sort(p, n, before, p);
    }
}

/* Nor of any count up to MANY. */
enum { MANY = 1000 };
void eva_sort_many(void)
{
    static int32_t p[MANY];
    const int32_t n = any_whole(0, MANY);
    for (int32_t k = 0; k < n; k++) p[k] = k;
    sp__sort(p, n, before, p);
}

/* Rows of up to N free blocks among those of a scene with up to three supports; their numbers are any. */
void eva_rows(void)
{
    static sp_scene scene;
    int32_t block[N];
    sp_problem pb;
    for (int32_t k = 0; k < N; k++) block[k] = any_whole(0, INT32_MAX);
    pb.scene = &scene;
    pb.block = block;
    for (pb.blocks = 0; pb.blocks <= N; pb.blocks++)
        for (int32_t supports = 0; supports <= 3; supports++) {
            scene.count.blocks = pb.blocks + supports;
            for (int32_t k = 0; k <= pb.blocks + supports; k++) sp__problem_row(&pb, k);
            sp__problem_row(&pb, INT32_MAX);
        }
}

/* Directions and halves of every pyramid. */
void eva_pyramids(void)
{
    sp_real d[2], c, t;
    const int32_t K = any_whole(SP__FACES_MIN, SP__FACES_MAX);
    sp__pyramid_half(K, &c, &t);
    const int32_t k = any_whole(0, SP__FACES_MAX - 1);
    if (k < K) sp__pyramid_direction(K, k, d);
}

enum { SMALL = 8, LARGE = 24 };
static sp_real A[LARGE * (LARGE + 1) / 2], x[LARGE];

/* Of up to SMALL rows, and of LARGE. */
void eva_chol(void)
{
    for (int32_t k = 0; k <= SMALL + 1; k++) {
        const int32_t n = k > SMALL ? LARGE : k;
        any_numbers(A, LARGE * (LARGE + 1) / 2);
        any_numbers(x, LARGE);
        sp__chol_factor(A, n, any());
        sp__chol_solve(A, n, x);
    }
}

/* Entries of given places, two of them equal, of any numbers; and of any places, which are refused or not. */
void eva_csc(void)
{
    int32_t i[N] = { 2, 0, 1, 0, 2, 1 }, j[N] = { 3, 0, 1, 0, 1, 3 };
    sp_real v[N];
    sp_csc out;
    sp_arena a = memory_of(0), none = memory_of(0);
    const sp_triplets t = { 3, 4, N, i, j, v };
    any_numbers(v, N);
    sp_csc_from(&t, &a, &out);
    none.capacity = 0;
    for (int32_t k = 0; k < N; k++) { i[k] = any_whole(INT32_MIN, INT32_MAX); j[k] = any_whole(INT32_MIN, INT32_MAX); }
    sp_csc_from(&t, &none, &out);
}
