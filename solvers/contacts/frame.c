/* frame: axes for the boxes of the tree. Boxes along x, y, z all overlap in a stack that leans, or in a bundle of beams across
 * the diagonal, though hardly any touch; along a face and an edge of a block they do not. Of a few such frames that one is best
 * whose boxes take least of the box of everything:
 *
 *   share = sum over blocks of  product over axes of  width of its box / width of all            [Goldsmith, Salmon 1987]
 *
 * Boxes only sieve: what they let through is asked as before, and in the same order. */
#ifndef SP__CONTACTS_FRAME_C
#define SP__CONTACTS_FRAME_C

#include "body.c"

#if !SP__WITH_SMALL

/* Blocks whose faces give frames, of each so many; blocks each frame is measured by, and corners of each. */
#define SP__FRAME_BLOCKS 8
#define SP__FRAME_FACES 6
#define SP__FRAME_SAMPLE 64

/* Box of a block along axes, with what it may touch: its planes are `reach` off at most, its corners `warp`, and faces of two
 * blocks twice the distance. Every step-th corner. */
static void sp__frame_box(const sp__touch *t, const sp__body *b, sp_real (*axis)[3], int32_t step, sp_real box[6])
{
    const sp_real margin = 4 * b->reach + 2 * b->warp;
    for (int32_t e = b->edge; e < b->edge + b->edges; e += step)
        for (int c = 0; c < 3; c++) {
            const sp_real x = sp__dot3(axis[c], t->scene->vertex[t->all.bound[e][0]]);
            if (e == b->edge || x < box[c]) box[c] = x;
            if (e == b->edge || x > box[3 + c]) box[3 + c] = x;
        }
    for (int c = 0; c < 3; c++) { box[c] -= margin; box[3 + c] += margin; }
}

/* The share of a frame, by some of the blocks. */
static sp_real sp__frame_share(const sp__touch *t, sp_real (*axis)[3])
{
    const sp__tree *tree = &t->all.tree;
    const int32_t step = tree->leaves / SP__FRAME_SAMPLE + 1;
    sp_real all[6], box[6], across[3], sum = 0;
    sp__sub3(tree->hi, tree->lo, across);
    const sp_real unit = 1 / sp__norm3(across);
    for (int32_t l = 0; l < tree->leaves; l += step) {
        const sp__body *b = &t->all.body[tree->leaf[l]];
        sp_real share = (sp_real)1;
        sp__frame_box(t, b, axis, b->edges / SP__FRAME_SAMPLE + 1, box);
        for (int c = 0; c < 3; c++) share *= unit * (box[3 + c] - box[c]);
        sum += share;
        if (!l) memcpy(all, box, sizeof all);
        sp__box_add(all, all + 3, box);
        sp__box_add(all, all + 3, box + 3);
    }
    for (int c = 0; c < 3; c++) sum /= unit * (all[3 + c] - all[c]);
    return sum;
}

/* The frame of a face: its normal, its first edge, and what is across both. */
static void sp__frame_of(const sp__touch *t, const sp__patch *p, sp_real (*axis)[3])
{
    const int32_t *edge = t->all.bound[p->edge];
    memcpy(axis[0], p->n, sizeof *axis);
    sp__sub3(t->scene->vertex[edge[1]], t->scene->vertex[edge[0]], axis[1]);
    sp__cross3(p->n, axis[1], axis[2]);
    const sp_real length = sp__norm3(axis[2]);
    if (!(length > 0)) sp__across3(p->n, axis[2]);
    else sp__scale3(1 / length, axis[2], axis[2]);
    sp__cross3(axis[2], axis[0], axis[1]);
}

/* The best frame of all for the tree. Returns 1 if it is clearly better than x, y and z. */
SP__NOINLINE static int sp__frame_choose(sp__touch *t)
{
    sp__tree *tree = &t->all.tree;
    sp_real axis[3][3] = { { (sp_real)1, 0, 0 }, { 0, (sp_real)1, 0 }, { 0, 0, (sp_real)1 } };
    sp_real least = sp__frame_share(t, axis) / 2;
    int better = 0;
    for (int32_t l = 0; l < tree->leaves; l += tree->leaves / SP__FRAME_BLOCKS + 1) {
        const sp__body *b = &t->all.body[tree->leaf[l]];
        for (int32_t p = b->patch; p < b->patch + b->patches && p < b->patch + SP__FRAME_FACES; p++) {
            if (!t->all.patch[p].edges) continue;
            sp__frame_of(t, &t->all.patch[p], axis);
            const sp_real share = sp__frame_share(t, axis);
            if (!(share < least)) continue;
            least = share;
            memcpy(tree->axis, axis, sizeof axis);
            better = 1;
        }
    }
    return better;
}

#endif

#endif /* SP__CONTACTS_FRAME_C */
