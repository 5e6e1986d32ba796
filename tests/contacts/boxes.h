/* Boxes of blocks along any axes, by their definition. For white-box suites to include behind their own `scene` and `touch`. */
#ifndef BOXES_H
#define BOXES_H

/* The box of a block along `axis`, and how far it may reach. */
static void box_of(int32_t i, sp_real (*axis)[3], double box[6])
{
    const sp__body *o = &touch.all.body[i];
    const sp_block *b = &scene.block[i];
    for (int c = 0; c < 3; c++) {
        box[c] = 1e30;
        box[3 + c] = -1e30;
        for (int32_t v = b->vertex; v < b->vertex + b->vertices; v++) {
            const double x = (double)sp__dot3(axis[c], scene.vertex[v]);
            if (x < box[c]) box[c] = x;
            if (x > box[3 + c]) box[3 + c] = x;
        }
        const double more = (double)(4 * o->reach + 2 * o->warp);
        box[c] -= more;
        box[3 + c] += more;
    }
}

/* sum of the boxes' volumes over that of the box of all of them. */
static double share_of(sp_real (*axis)[3])
{
    double all[6] = { 1e30, 1e30, 1e30, -1e30, -1e30, -1e30 }, sum = 0;
    for (int32_t i = 0; i < scene.count.blocks; i++) {
        double box[6];
        if (!scene.block[i].faces) continue;
        box_of(i, axis, box);
        sum += (box[3] - box[0]) * (box[4] - box[1]) * (box[5] - box[2]);
        for (int c = 0; c < 3; c++) {
            if (box[c] < all[c]) all[c] = box[c];
            if (box[3 + c] > all[3 + c]) all[3 + c] = box[3 + c];
        }
    }
    return sum / ((all[3] - all[0]) * (all[4] - all[1]) * (all[5] - all[2]));
}

#endif /* BOXES_H */
