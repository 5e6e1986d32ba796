/* sweep: pairs of blocks whose boxes come near each other, by a balanced tree of boxes along a Morton curve: n log n for boxes
 * of mixed sizes.                                                                                     [Morton 1966] */
#ifndef SP__CONTACTS_SWEEP_C
#define SP__CONTACTS_SWEEP_C

#include "frame.c"
#include "memory.c"
#include "morton.c"
#include "polygon.c"

#if !SP__WITH_SMALL

static int sp__number_before(const void *what, int32_t i, int32_t j)
{
    (void)what;
    return i < j;
}

/* Box of a block with what it may touch. */
static void sp__tree_box(sp__touch *t, const sp__body *b, sp_real box[6])
{
    if (t->all.tree.turned) { sp__frame_box(t, b, t->all.tree.axis, 1, box); return; }
    for (int c = 0; c < 3; c++) { box[c] = b->lo[c] - b->reach; box[3 + c] = b->hi[c] + b->reach; }
}

/* Leaves: the blocks with faces along a Morton curve. */
static void sp__tree_leaves(sp__touch *t)
{
    sp__tree *tree = &t->all.tree;
    sp_real *lo = tree->lo, *hi = tree->hi, box[6];
    tree->leaves = 0;
    for (int32_t i = 0; i < t->scene->count.blocks; i++) {
        if (!t->all.body[i].edges) continue;
        sp__tree_box(t, &t->all.body[i], box);
        if (!tree->leaves) sp__box_start(lo, hi, box);
        sp__box_add(lo, hi, box);
        sp__box_add(lo, hi, box + 3);
        tree->leaf[tree->leaves++] = i;
    }
    for (int32_t l = 0; l < tree->leaves; l++) {
        sp__tree_box(t, &t->all.body[tree->leaf[l]], box);
        tree->code[tree->leaf[l]] = sp__morton(box, box + 3, lo, hi);
    }
    sp__sort(tree->leaf, tree->leaves, sp__code_before, tree->code);
}

/* Boxes bottom-up; an empty one has low above high. */
static void sp__tree_build(sp__touch *t)
{
    const sp__tree *tree = &t->all.tree;
    sp__tree_leaves(t);
    for (int32_t k = 2 * tree->width - 1; k > 0; k--) {
        sp_real *box = tree->box[k];
        box[0] = (sp_real)1;
        box[3] = (sp_real)0;
        if (k >= tree->width) {
            if (k - tree->width < tree->leaves) sp__tree_box(t, &t->all.body[tree->leaf[k - tree->width]], box);
            continue;
        }
        const sp_real *left = tree->box[2 * k], *right = tree->box[2 * k + 1];
        if (left[0] > left[3]) continue;
        for (int c = 0; c < 6; c++) box[c] = left[c];
        if (right[0] > right[3]) continue;
        sp__box_add(box, box + 3, right);
        sp__box_add(box, box + 3, right + 3);
    }
}

/* The block of leaf k, if it comes after block a and is near it along x, y, z, too; else -1. */
static int32_t sp__tree_hit(const sp__touch *t, int32_t a, int32_t k)
{
    const int32_t b = t->all.tree.leaf[k - t->all.tree.width];
    const sp__body *p = &t->all.body[a], *q = &t->all.body[b];
    return b > a && sp__boxes_near(p->lo, p->hi, q->lo, q->hi, p->reach + q->reach) ? b : -1;
}

/* Blocks above a whose boxes come near a's, in order. Returns how many. */
SP__NOINLINE static int32_t sp__tree_near(sp__touch *t, int32_t a)
{
    sp__tree *tree = &t->all.tree;
    sp_real own[6];
    int32_t hits = 0, k = 1;
    if (!t->all.body[a].edges) return 0;
    sp__tree_box(t, &t->all.body[a], own);
    while (k > 0) {
        const sp_real *box = tree->box[k];
        if (!(box[0] > box[3]) && sp__boxes_near(own, own + 3, box, box + 3, 0)) {
            if (k < tree->width) { k *= 2; continue; }
            t->all.hit[hits] = sp__tree_hit(t, a, k);
            hits += t->all.hit[hits] >= 0;
        }
        while (k & 1) k >>= 1;                          /* up from right children, past the top to 0 */
        if (k) k++;
    }
    sp__sort(t->all.hit, hits, sp__number_before, NULL);
    tree->asked += hits;
    return hits;
}

/* Where boxes overlap by far more than blocks can touch, along better axes. */
static void sp__tree_turn(sp__touch *t)
{
    sp__tree *tree = &t->all.tree;
    if (tree->tried || tree->asked <= 16 * (int64_t)tree->leaves) return;
    tree->tried = 1;
    tree->turned = sp__frame_choose(t);
    if (tree->turned) sp__tree_build(t);
}

/* Patches of all blocks, then what the largest pair needs. */
static void sp__touch_blocks(sp__touch *t, sp_arena *scratch)
{
    sp__top_sizes *most = &t->most;
    for (int32_t i = 0; i < t->scene->count.blocks; i++) {
        int32_t side = 0;
        sp__touch_block(t, i);
        for (int32_t p = t->all.body[i].patch; p < t->patches; p++)
            if (t->all.patch[p].edges > side) side = t->all.patch[p].edges;
        sp__top_two_add(&most->side, side);
        sp__top_two_add(&most->total, t->all.body[i].edges);
        sp__top_two_add(&most->patches, t->all.body[i].patches);
    }
    sp__clip_carve(&t->clip, most->side.first, most->side.second, sp__crossings(&most->side), scratch);
    sp__pair_buffer_carve(&t->pair, most, scratch);
    if (sp__failed(scratch)) t->status = SP_E_MEMORY;
}

/* Every pair of blocks whose boxes come near each other. */
static void sp__touch_all(sp__touch *t, sp_arena *scratch)
{
    sp_scene *scene = t->scene;
    sp__contact_arrays_carve(&t->all, scene, scratch);
    if (sp__failed(scratch)) { t->status = SP_E_MEMORY; return; }
    sp__touch_blocks(t, scratch);
    if (!t->status) sp__tree_build(t);
    for (t->now.a = 0; t->now.a < scene->count.blocks && !t->status; t->now.a++) {
        const int32_t hits = sp__tree_near(t, t->now.a);
        for (int32_t h = 0; h < hits && !t->status; h++) sp__touch_pair(t, t->all.hit[h]);
        sp__tree_turn(t);
    }
}

#endif

#endif /* SP__CONTACTS_SWEEP_C */
