/* Pieces of an arena: aligned, side by side, none of what does not fit, also where sizes wrap; and the arena without memory. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/base/arena.c"

TEST(pieces_are_aligned_and_follow_each_other)
{
    static unsigned char room[256];
    sp_arena a = { room, sizeof room, 0, 0 };
    const unsigned char *x = sp__take(&a, 3, 1), *y = sp__take(&a, 2, 8), *none = sp__take(&a, 0, 8);
    CHECK(x == room && y == room + SP_ALIGN && none == room + SP_ALIGN + (16 + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN);
    CHECK_INT((int64_t)a.used, none - room);
    CHECK(a.peak == a.used && !sp__failed(&a));
    a.used = 1;
    CHECK(sp__take(&a, 1, 1) == room + SP_ALIGN);
    CHECK(a.used == SP_ALIGN + 1 && a.peak > a.used);
}

/* What fits to the byte is given, a byte more is not; after that nothing fits, however small. */
TEST(what_does_not_fit_fails_the_arena)
{
    static unsigned char room[256];
    for (size_t size = 1; size < 9; size++) {
        sp_arena a = { room, 24 * size, 0, 0 }, b = a;
        CHECK(sp__take(&a, 24, size) && !sp__failed(&a));
        CHECK(!sp__take(&b, 24, size + 1) && sp__failed(&b));
        CHECK(!sp__take(&b, 1, 1) && !b.used);
    }
    sp_arena late = { room, 20, 17, 0 };                                        /* its next place lies beyond its end */
    CHECK(!sp__take(&late, 0, 1) && sp__failed(&late));
}

TEST(sizes_that_wrap_do_not_fit)
{
    static unsigned char room[64];
    sp_arena many = { room, sizeof room, 0, 0 }, wide = many, high = { NULL, SIZE_MAX, SIZE_MAX - 2, 0 }, dry = sp__arena_dry();
    CHECK(!sp__take(&many, SIZE_MAX / 4 + 1, 8) && sp__failed(&many));
    CHECK(!sp__take(&wide, 2, SIZE_MAX / 2 + 1) && sp__failed(&wide));
    CHECK(!sp__take(&high, 1, 1) && sp__failed(&high));                        /* aligned it would begin at 0 again */
    CHECK(!sp__take(&dry, 5, 8) && !sp__failed(&dry) && dry.used == 40 && dry.peak == 40);
    CHECK(!sp__take(&dry, SIZE_MAX / 8, 8) && sp__failed(&dry));
}

TEST_LIST(pieces)
    RUN(pieces_are_aligned_and_follow_each_other)
    RUN(what_does_not_fit_fails_the_arena)
    RUN(sizes_that_wrap_do_not_fit)
TEST_END
