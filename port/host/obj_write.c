/* The writer of scene files. */
#include "scene.h"

static void triple(FILE *out, const char *before, const sp_real x[3])
{
    char text[32];
    fputs(before, out);
    for (int c = 0; c < 3; c++) fprintf(out, " %s", text_shortest(x[c], text));
}

static void setting(FILE *out, const char *word, sp_real x)
{
    char text[32];
    fprintf(out, "#@ %s %s\n", word, text_shortest(x, text));
}

static void name_of(FILE *out, const char *const *name, int32_t b)
{
    if (name) fprintf(out, " %s", name[b]);
    else fprintf(out, " b%ld", (long)b);
}

/* Vertices and faces are already counted through the whole scene, as OBJ counts them. */
static void write_block(FILE *out, const sp_scene *s, int32_t b, const char *const *name, int own_density)
{
    const sp_block *block = &s->block[b];
    fputs("o", out);
    name_of(out, name, b);
    fputs("\n", out);
    if (block->fixed) fputs("#@ fixed\n", out);
    if (own_density && block->density > 0) setting(out, "density", block->density);
    for (int32_t v = 0; v < block->vertices; v++) {
        triple(out, "v", s->vertex[block->vertex + v]);
        fputs("\n", out);
    }
    for (int32_t i = block->face; i < block->face + block->faces; i++) {
        fputs("f", out);
        for (int32_t k = 0; k < s->face[i].corners; k++) fprintf(out, " %ld", (long)s->corner[s->face[i].corner + k] + 1);
        fputs("\n", out);
    }
}

static void write_contact(FILE *out, const sp_scene *s, int32_t i, const char *const *name, int own_mu)
{
    const sp_interface *c = &s->interface[i];
    fputs(c->area > 0 ? "#@ interface" : "#@ points", out);
    name_of(out, name, c->a);
    name_of(out, name, c->b);
    if (!(c->area > 0)) triple(out, "", c->n);
    for (int32_t k = 0; k < c->points; k++) triple(out, "", s->point[c->point + k]);
    fputs("\n", out);
    if (own_mu) setting(out, "mu", c->joint.mu);
}

static int same(sp_real a, sp_real b) { return !(a < b) && !(a > b); }

int scene_write(FILE *out, const sp_scene *s, const char *const *name, const char *path, text_error *error)
{
    sp_real density = 0;                        /* of all blocks that have one */
    int one_density = 1, one_mu = s->count.interfaces > 0;

    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *block = &s->block[b];
        if (block->fixed && block->fixed != SP_FIXED)
            return text_fail(error, EXIT_SCENE, path, 0, "block %ld is held in part, which a scene file can't say", (long)b);
        if (block->faces == 0 && !block->fixed)
            return text_fail(error, EXIT_SCENE, path, 0, "block %ld has no mesh, which a scene file can't say", (long)b);
        if (!(density > 0)) density = block->density;
        if (block->density > 0) one_density = one_density && same(block->density, density);
    }
    for (int32_t i = 1; i < s->count.interfaces; i++)
        one_mu = one_mu && same(s->interface[i].joint.mu, s->interface[0].joint.mu);
    if (one_mu) setting(out, "mu", s->interface[0].joint.mu);
    if (one_density && density > 0) setting(out, "density", density);
    triple(out, "#@ gravity", s->gravity);
    fputs("\n", out);
    for (int32_t b = 0; b < s->count.blocks; b++) write_block(out, s, b, name, !one_density);
    for (int32_t i = 0; i < s->count.interfaces; i++) write_contact(out, s, i, name, !one_mu);
    return 0;
}
