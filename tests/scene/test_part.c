/* A part is a view of some blocks of a scene. The problem made of it is, to the bit, that of a scene made of just these blocks,
 * their joints and loads; what is written through it lands at the scene's numbers; islands are parts that cover all free blocks. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/scene/part.c"
#include "../scenes/gen.h"

enum { MOST = 640 };                                    /* blocks, joints, loads of the scenes here */

/* ------------------------------------------------------------------------------------------------------------------- scenes */

static void somewhere(sp_real x[3]) { for (int k = 0; k < 3; k++) x[k] = test_random_real(-2, 2); }

/* A parallelogram in any plane, or some points that share a normal. */
static sp_status join_two(sp_scene *s, int32_t a, int32_t b)
{
    sp_real v[12], edge[2][3];
    const sp_strength strength = { test_random_real(0, 1), test_random_real(0, 9), test_random_real(0, 9), test_random_real(0, 99) };
    const sp_real n[3] = { 0, test_random_int(0, 1) ? R(1) : R(-1), 0 };
    const sp_strength friction = sp_strength_friction(strength.mu);
    somewhere(v);
    somewhere(edge[0]);
    somewhere(edge[1]);
    for (int k = 0; k < 3; k++) {
        v[3 + k] = v[k] + edge[0][k];
        v[9 + k] = v[k] + edge[1][k];
        v[6 + k] = v[3 + k] + edge[1][k];
    }
    if (test_random_int(0, 3) == 0) return sp_scene_points(s, a, b, n, test_random_int(1, 4), v, &friction, NULL);
    return sp_scene_joint(s, a, b, test_random_int(3, 4), v, &strength, NULL);
}

static void load_one(sp_scene *s, int live)
{
    sp_load l;
    memset(&l, 0, sizeof l);
    l.block = test_random_int(0, s->count.blocks - 1);
    l.live = live && test_random_int(0, 2) == 0;
    somewhere(l.point);
    if (test_random_int(0, 3)) somewhere(l.force);
    if (test_random_int(0, 3) == 0) somewhere(l.couple);
    if (test_random_int(0, 2) == 0) l.mass = test_random_real(0, 50);
    if (test_random_int(0, 5) == 0)                     /* carries the block: what is left of both is rounding */
        for (int k = 0; k < 3; k++) l.force[k] = -s->gravity[k] * (s->block[l.block].mass + l.mass);
    CHECK_INT(sp_scene_load(s, &l, NULL), SP_OK);
}

/* Blocks somewhere, a third of them supports, some held in some directions; joints between any two, so that some are between
 * supports and some blocks have none; loads on all of them. Nothing here need stand. */
static int any_scene(sp_scene *s)
{
    const int32_t blocks = test_random_int(2, 30), joints = test_random_int(0, 30), loads = test_random_int(0, 20);
    const int live = test_random_int(0, 1), body = test_random_int(0, 3) == 0;
    const sp_capacity cap = { blocks, 0, 0, 0, joints, 4 * joints, loads };
    if (!CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK)) return 0;
    for (int k = 0; k < 3; k++) { s->gravity[k] += test_random_real(-1, 1); s->body[k] = body ? test_random_real(-1, 1) : 0; }
    s->live = test_random_real(-2, 2);
    for (int32_t i = 0; i < blocks; i++) {
        const uint32_t fixed[6] = { SP_FIXED, SP_FIXED, 0, 0, 0, 5 };
        sp_real at[3];
        somewhere(at);
        CHECK_INT(sp_scene_body(s, test_random_real(1, 100), at, fixed[test_random_int(0, 5)], NULL), SP_OK);
    }
    for (int32_t k = 0; k < joints; k++) {
        const int32_t a = test_random_int(0, blocks - 1), b = (a + test_random_int(1, blocks - 1)) % blocks;
        const sp_status status = join_two(s, a, b);
        CHECK(status == SP_OK || status == SP_E_AREA);  /* a parallelogram may be as thin as a line */
    }
    for (int32_t k = 0; k < loads; k++) load_one(s, live);
    return 1;
}

/* Scene k: those of the generator with loads, then any. */
static int scene_number(int k, sp_scene *s)
{
    int made = 0;
    while (gen_table[made].name) made++;
    if (k >= made) return any_scene(s);
    gen_scene g;
    gen_open(&g, gen_table[k].name);
    if (!CHECK_INT(gen_build(&g, &test_arena, s), SP_OK)) return 0;
    s->load = sp__take(&test_arena, 5, sizeof *s->load);
    s->capacity.loads = 5;
    for (int q = 0; q < 5; q++) load_one(s, k % 2);
    return CHECK(s->count.blocks <= MOST && s->count.joints <= MOST);
}

/* -------------------------------------------------------------------------------------------------------- a part, and a copy */

/* Lists of a part, made here; and the scene of just that part. */
typedef struct chosen {
    int32_t block_next[MOST], joint_next[MOST], load_next[MOST], row[MOST];
    sp__part part;
    sp_scene copy;
    int32_t number[MOST], joint[MOST];                  /* of the copy's blocks and joints in the scene */
} chosen;

static chosen it;

/* The next of a list, ascending. */
static void append(int32_t k, int32_t *first, int32_t *last, int32_t *next)
{
    if (*first < 0) *first = k;
    else next[*last] = k;
    next[k] = -1;
    *last = k;
}

/* The part of those free blocks that are marked, all their joints and loads. */
static void choose(const sp_scene *s, const int *mark)
{
    int32_t last[3] = { -1, -1, -1 }, rows = 0;
    const sp__part none = { -1, -1, -1, it.block_next, it.joint_next, it.load_next, it.row };
    it.part = none;
    for (int32_t i = 0; i < s->count.blocks; i++) {
        it.row[i] = mark[i] ? rows++ : -1;
        if (mark[i]) append(i, &it.part.block, &last[0], it.block_next);
    }
    for (int32_t k = 0; k < s->count.joints; k++)
        if (mark[s->joint[k].a] || mark[s->joint[k].b]) append(k, &it.part.joint, &last[1], it.joint_next);
    for (int32_t k = 0; k < s->count.loads; k++)
        if (mark[s->load[k].block]) append(k, &it.part.load, &last[2], it.load_next);
}

static int copy_joint(const sp_scene *s, int32_t k, const int32_t *place)
{
    const sp_joint *f = &s->joint[k];
    const sp_real *xyz = s->point[f->point];
    const int32_t a = place[f->a], b = place[f->b];
    return CHECK_INT(f->area > 0 ? sp_scene_joint(&it.copy, a, b, f->points, xyz, &f->strength, NULL)
                                 : sp_scene_points(&it.copy, a, b, f->n, f->points, xyz, &f->strength, NULL), SP_OK);
}

/* The same as a scene by the public calls: blocks of the part and, as supports, all others. */
static int copy_part(const sp_scene *s)
{
    int32_t place[MOST], joints = 0;
    if (!CHECK_INT(sp_scene_create(&it.copy, &s->count, &test_arena), SP_OK)) return 0;
    memcpy(it.copy.gravity, s->gravity, sizeof s->gravity);
    memcpy(it.copy.body, s->body, sizeof s->body);
    it.copy.live = s->live;
    for (int32_t i = 0, pass = 0; pass < 2; i++) {      /* supports first, so that numbers differ */
        if (i == s->count.blocks) { pass++; i = -1; continue; }
        const sp_block *b = &s->block[i];
        if ((it.row[i] >= 0) != pass) continue;
        CHECK_INT(sp_scene_body(&it.copy, b->mass, b->centroid, pass ? b->fixed : SP_FIXED, &place[i]), SP_OK);
        it.number[place[i]] = i;
    }
    for (int32_t k = it.part.joint; k >= 0; k = it.joint_next[k]) {
        if (!copy_joint(s, k, place)) return 0;
        it.joint[joints++] = k;
    }
    for (int32_t k = it.part.load; k >= 0; k = it.load_next[k]) {
        sp_load l = s->load[k];
        l.block = place[l.block];
        CHECK_INT(sp_scene_load(&it.copy, &l, NULL), SP_OK);
    }
    return 1;
}

static int same(const void *a, const void *b, size_t bytes) { return bytes == 0 || memcmp(a, b, bytes) == 0; }

static void same_contact(const sp_contact *a, const sp_contact *b)
{
    const sp_joint *f = a->joint, *g = b->joint;
    CHECK_INT(a->a, b->a);
    CHECK_INT(a->b, b->b);
    CHECK_INT(a->point, b->point);
    CHECK_INT(a->points, b->points);
    CHECK_INT(a->id, it.joint[b->id]);
    CHECK(same(a->ra, b->ra, sizeof a->ra) && same(a->rb, b->rb, sizeof a->rb));
    CHECK(same(f->n, g->n, sizeof f->n) && same(f->t1, g->t1, sizeof f->t1) && same(f->t2, g->t2, sizeof f->t2));
    CHECK(same(&f->strength, &g->strength, sizeof f->strength) && same(&f->area, &g->area, sizeof f->area));
}

/* The problem of the part against that of the copy. */
static void same_problem(const sp_problem *a, const sp_problem *b)
{
    NEED(CHECK_INT(a->blocks, b->blocks) && CHECK_INT(a->contacts, b->contacts) && CHECK_INT(a->points, b->points));
    for (int32_t i = 0; i < a->blocks; i++) {
        CHECK_INT(a->block[i], it.number[b->block[i]]);
        CHECK_INT(it.row[a->block[i]], i);
    }
    for (int32_t c = 0; c < a->contacts; c++) same_contact(&a->contact[c], &b->contact[c]);
    CHECK(same(a->point, b->point, (size_t)a->points * sizeof *a->point));
    CHECK(same(a->local, b->local, (size_t)a->points * sizeof *a->local));
    CHECK(same(a->p, b->p, 6 * (size_t)a->blocks * sizeof *a->p));
    CHECK_INT(a->live != NULL, b->live != NULL);
    if (a->live && b->live) CHECK(same(a->live, b->live, 6 * (size_t)a->blocks * sizeof *a->live));
    CHECK_INT(a->keep_order, 0);
    CHECK_INT(a->ignore_strength, 0);
    CHECK_INT(sp__problem_points(a), b->points);
}

/* Any free blocks, with a chance of one in `of` each; 1: all. */
static void mark_some(const sp_scene *s, int32_t of, int *mark)
{
    for (int32_t i = 0; i < s->count.blocks; i++) mark[i] = s->block[i].fixed != SP_FIXED && test_random_int(1, of) == 1;
}

TEST(problem_of_a_part_is_that_of_a_scene_of_its_own)
{
    int mark[MOST];
    for (int k = 0; k < SOME_OF(600, 150); k++) {
        test_arena.used = 0;
        sp_scene s;
        sp_problem view, own;
        NEED(scene_number(k, &s));
        mark_some(&s, 1 + k % 4, mark);
        choose(&s, mark);
        NEED(copy_part(&s));
        NEED(sp__part_build(&s, &it.part, &test_arena, &view) == SP_OK);
        NEED(sp_problem_build(&it.copy, &test_arena, &own) == SP_OK);
        same_problem(&view, &own);
    }
}

TEST(bytes_of_a_part_are_what_it_takes)
{
    int mark[MOST];
    for (int k = 0; k < SOME_OF(300, 80); k++) {
        test_arena.used = 0;
        sp_scene s;
        sp_problem pb;
        NEED(scene_number(k, &s));
        mark_some(&s, 1 + k % 3, mark);
        choose(&s, mark);
        test_arena.used += SP_ALIGN - test_arena.used % SP_ALIGN;
        const sp_arena room = test_arena;
        sp_arena a = room;
        NEED(sp__part_build(&s, &it.part, &a, &pb) == SP_OK);
        const size_t bytes = sp__part_bytes(&pb);
        CHECK_INT(a.used - room.used, bytes);
        for (size_t less = 0; less < 2 && less <= bytes; less++) {
            a = room;
            a.capacity = room.used + bytes - less;
            CHECK_INT(sp__part_build(&s, &it.part, &a, &pb), less ? SP_E_MEMORY : SP_OK);
        }
    }
}

/* ------------------------------------------------------------------------------------------------ what is written through it */

/* `width` numbers a vertex: the joint's place in the scene gets the contact's, everything else keeps what it had. */
static void write_and_read(const sp_scene *s, const sp_problem *pb, size_t width)
{
    const size_t n = width * (size_t)s->count.points, m = width * (size_t)pb->points;
    const size_t room = n + 2;                          /* a number before and one behind */
    sp_real *to = sp__take(&test_arena, room, sizeof *to), *of = sp__take(&test_arena, m + 1, sizeof *of);
    NEED(to && of);
    for (size_t q = 0; q < room; q++) to[q] = -R(q) - 1;
    for (size_t q = 0; q < m; q++) of[q] = R(q) + 1;
    sp__points_write(pb, width, of, to + 1);
    for (int32_t k = 0; k < s->count.joints; k++) {
        const sp_joint *f = &s->joint[k];
        int32_t c = 0;
        while (c < pb->contacts && pb->contact[c].id != k) c++;
        for (size_t q = 0; q < width * (size_t)f->points; q++) {
            const size_t at = width * (size_t)f->point + q;
            const sp_real want = c < pb->contacts ? of[width * (size_t)pb->contact[c].point + q] : -R(at + 1) - 1;
            CHECK(same(&to[1 + at], &want, sizeof want));
        }
    }
    CHECK_NEAR(to[0], -1, 0);
    CHECK_NEAR(to[room - 1], -(double)R(room - 1) - 1, 0);
#if SP__WITH_COUPLED
    for (size_t q = 0; q < m; q++) of[q] = 0;
    sp__points_read(pb, width, to + 1, of);
    for (size_t q = 0; q < m; q++) CHECK_NEAR(of[q], (double)q + 1, 0);
#endif
}

TEST(points_of_a_part_are_written_where_the_scene_has_them)
{
    static const size_t width[] = { 1, 3, 4 };
    int mark[MOST];
    for (int k = 0; k < SOME_OF(300, 80); k++) {
        test_arena.used = 0;
        sp_scene s;
        sp_problem pb;
        NEED(scene_number(k, &s));
        mark_some(&s, 1 + k % 4, mark);
        choose(&s, mark);
        NEED(sp__part_build(&s, &it.part, &test_arena, &pb) == SP_OK);
        write_and_read(&s, &pb, width[k % 3]);
    }
}

/* ------------------------------------------------------------------------------------------------------------------- islands */

/* Islands once more: labels spread along joints between free blocks until nothing changes, named by their lowest block. */
static int32_t flood(const sp_scene *s, int32_t *label)
{
    int32_t count = 0;
    for (int32_t i = 0; i < s->count.blocks; i++) label[i] = s->block[i].fixed == SP_FIXED ? -1 : i;
    for (int more = 1; more;) {
        more = 0;
        for (int32_t k = 0; k < s->count.joints; k++) {
            const int32_t a = s->joint[k].a, b = s->joint[k].b;
            if (label[a] < 0 || label[b] < 0 || label[a] == label[b]) continue;
            label[a] = label[b] = label[a] < label[b] ? label[a] : label[b];
            more = 1;
        }
    }
    for (int32_t i = 0; i < s->count.blocks; i++)       /* lowest blocks are met first */
        if (label[i] >= 0) label[i] = label[i] == i ? count++ : label[label[i]];
    return count;
}

/* Island k's list is, ascending, all those whose label that is.     returns how many there are */
static int32_t is_list_of(int32_t k, int32_t first, const int32_t *next, const int32_t *label, int32_t n)
{
    int32_t found = 0;
    for (int32_t i = 0; i < n; i++) {
        if (label[i] != k) continue;
        CHECK_INT(first, i);
        if (first != i) return found;
        first = next[first];
        found++;
    }
    CHECK_INT(first, -1);
    return found;
}

static void islands_cover(const sp_scene *s, const sp__islands *t, const int32_t *want)
{
    int32_t joint[MOST], load[MOST], all[3] = { 0, 0, 0 }, rank = 0, counts[3] = { 0, 0, 0 };
    for (int32_t k = 0; k < s->count.joints; k++) {
        const int32_t a = want[s->joint[k].a], b = want[s->joint[k].b];
        joint[k] = a >= 0 ? a : b;
        counts[1] += joint[k] >= 0;
    }
    for (int32_t k = 0; k < s->count.loads; k++) counts[2] += (load[k] = want[s->load[k].block]) >= 0;
    for (int32_t i = 0; i < s->count.blocks; i++) {
        CHECK_INT(t->label[i], want[i]);
        CHECK_INT(t->rank[i], want[i] < 0 ? -1 : rank++);
        if (want[i] < 0) CHECK_INT(t->row[i], -1);
        counts[0] += want[i] >= 0;
    }
    for (int32_t k = 0; k < t->count; k++) {
        const sp__part p = sp__islands_part(t, k);
        int32_t row = 0;
        all[0] += is_list_of(k, p.block, p.block_next, want, s->count.blocks);
        all[1] += is_list_of(k, p.joint, p.joint_next, joint, s->count.joints);
        all[2] += is_list_of(k, p.load, p.load_next, load, s->count.loads);
        for (int32_t i = p.block; i >= 0; i = p.block_next[i]) CHECK_INT(p.row[i], row++);
    }
    for (int q = 0; q < 3; q++) CHECK_INT(all[q], counts[q]);
}

/* Of islands small enough for a proof the most vertices and blocks, counted one by one. */
static void islands_sizes(const sp_scene *s, const int32_t *label, int32_t count, const sp__island_counts *got)
{
    int32_t most[2] = { 0, 0 };
    for (int32_t k = 0; k < count; k++) {
        int32_t n[2] = { 0, 0 };
        for (int32_t q = 0; q < s->count.joints; q++) {
            const int32_t a = label[s->joint[q].a], b = label[s->joint[q].b];
            if (a == k || (a < 0 && b == k)) n[0] += s->joint[q].points;
        }
        for (int32_t i = 0; i < s->count.blocks; i++) n[1] += label[i] == k;
        if (n[0] > SP_EXACT_POINTS || n[1] > SP_EXACT_POINTS) continue;
        for (int q = 0; q < 2; q++) if (n[q] > most[q]) most[q] = n[q];
    }
    CHECK_INT(got->points, most[0]);
    CHECK_INT(got->blocks, most[1]);
}

TEST(islands_cover_every_free_block_once)
{
    int32_t want[MOST], up[MOST], points[MOST], blocks[MOST], several = 0;
    for (int k = 0; k < SOME_OF(600, 150); k++) {
        test_arena.used = 0;
        sp_scene s;
        sp__islands t;
        sp__island_counts most;
        NEED(scene_number(k, &s));
        const int32_t count = flood(&s, want);
        CHECK_INT(sp__islands_join(&s, up), count);
        sp__islands_proof_size(&s, up, points, blocks, &most);
        islands_sizes(&s, want, count, &most);
        sp__islands_carve(&t, &s, count, NULL, &test_arena);
        NEED(!sp__failed(&test_arena));
        sp__islands_fill(&s, &t);
        islands_cover(&s, &t, want);
        several += count > 1;
    }
    CHECK(several > 50);
}

/* The problem of an island is that of a scene of its own, too. */
TEST(islands_are_parts)
{
    int mark[MOST];
    int32_t want[MOST];
    for (int k = 0; k < SOME_OF(200, 60); k++) {
        test_arena.used = 0;
        sp_scene s;
        sp__islands t;
        NEED(scene_number(k + 10, &s));
        const int32_t count = flood(&s, want);
        sp__islands_carve(&t, &s, count, NULL, &test_arena);
        NEED(!sp__failed(&test_arena));
        sp__islands_fill(&s, &t);
        for (int32_t q = 0; q < count; q++) {
            const sp__part part = sp__islands_part(&t, q);
            sp_arena a = test_arena;
            sp_problem view, own;
            for (int32_t i = 0; i < s.count.blocks; i++) mark[i] = want[i] == q;
            choose(&s, mark);
            NEED(copy_part(&s));
            NEED(sp__part_build(&s, &part, &test_arena, &view) == SP_OK);
            NEED(sp_problem_build(&it.copy, &test_arena, &own) == SP_OK);
            same_problem(&view, &own);
            test_arena = a;
        }
    }
}

/* ------------------------------------------------------------------------------------------------------- sums of loads */

/* A sum q of terms that cancel is none where it is below 16 roundings of them; the moment's are |F| (|x| + |c|) / 4 and the
 * couple. All in parts of that: force and moment of q, the block's weight.     returns what is left: 1 the moment, 2 both */
static int left_of(double force, double moment, double weight)
{
    const sp_load load = { 0, 0, { 3, 0, 0 }, { 0, R(-1e6), 0 }, { 0, 0, R(2e6) }, 0 };
    const double noise = 16 * (double)SP_EPSILON, share = 0.5;
    const sp_real g[3] = { 0, 0, 0 }, own[3] = { 0, R(weight * noise * share * 1e6), 0 };
    sp_real q[6] = { 0, R(force * noise * share * 1e6), 0, 0, R(moment * noise * share * (1e6 * (3 + 5) / 4 + 2e6)), 0 };
    sp_block block;
    memset(&block, 0, sizeof block);
    block.centroid[1] = 5;
    block.mass = 1;
    sp__load_clear_rounding(q, &load, R(share), g, own, &block);
    return q[1] > 0 ? 2 : q[4] > 0;
}

TEST(sums_of_loads_are_cleared_of_16_roundings_of_their_terms)
{
    CHECK_INT(left_of(0.99, 0.99, 0), 0);
    CHECK_INT(left_of(0.99, 1.01, 0), 1);
    CHECK_INT(left_of(1.01, 0.99, 0), 2);
    CHECK_INT(left_of(0, 0.99, 0), 0);
    CHECK_INT(left_of(0.5, 1.01, 0), 1);
    CHECK_INT(left_of(0.9, 0.9, 0.9), 2);               /* it may be the weight that is left */
    CHECK_INT(left_of(0.9, 0.9, 1.1), 0);
}

TEST_LIST(part)
    RUN(sums_of_loads_are_cleared_of_16_roundings_of_their_terms)
    RUN_FULL(problem_of_a_part_is_that_of_a_scene_of_its_own)
    RUN_FULL(bytes_of_a_part_are_what_it_takes)
    RUN_FULL(points_of_a_part_are_written_where_the_scene_has_them)
    RUN_FULL(islands_cover_every_free_block_once)
    RUN_FULL(islands_are_parts)
TEST_END
