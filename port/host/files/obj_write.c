#include "obj_write.h"
#include "text.h"

#include <string.h>

static void write_triple(FILE *out, const char *before, const sp_real x[3])
{
    char text[32];
    fputs(before, out);
    for (int c = 0; c < 3; c++) fprintf(out, " %s", text_shortest(x[c], text));
}

static void write_setting(FILE *out, const char *word, sp_real x)
{
    char text[32];
    fprintf(out, "#@ %s %s\n", word, text_shortest(x, text));
}

static void write_name(FILE *out, const char *const *name, int32_t b)
{
    if (name) fprintf(out, " %s", name[b]);
    else fprintf(out, " b%ld", (long)b);
}

static void write_fixed(FILE *out, uint32_t held)
{
    static const char *const name[] = { " x", " y", " z", " rx", " ry", " rz" };
    fputs("#@ fixed", out);
    for (int k = 0; k < 6; k++) if (held != SP_FIXED && held >> k & 1) fputs(name[k], out);
    fputs("\n", out);
}

/* Vertices and faces are already counted through the whole scene, as OBJ counts them. */
static void write_block(FILE *out, const sp_scene *s, int32_t b, const char *const *name, int own_density)
{
    const sp_block *block = &s->block[b];
    fputs("o", out);
    write_name(out, name, b);
    fputs("\n", out);
    if (block->fixed) write_fixed(out, block->fixed);
    if (own_density && block->density > 0) write_setting(out, "density", block->density);
    for (int32_t v = 0; v < block->vertices; v++) {
        write_triple(out, "v", s->vertex[block->vertex + v]);
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
    const sp_joint *c = &s->joint[i];
    fputs(c->area > 0 ? "#@ interface" : "#@ points", out);
    write_name(out, name, c->a);
    write_name(out, name, c->b);
    if (!(c->area > 0)) write_triple(out, "", c->n);
    for (int32_t k = 0; k < c->points; k++) write_triple(out, "", s->point[c->point + k]);
    fputs("\n", out);
    if (own_mu) write_setting(out, "mu", c->strength.mu);
    if (c->strength.cohesion > 0) write_setting(out, "cohesion", c->strength.cohesion);
    if (c->strength.tension > 0) write_setting(out, "tension", c->strength.tension);
    if (c->strength.crushing > 0) write_setting(out, "crushing", c->strength.crushing);
}

static int is_zero(const sp_real x[3])
{
    for (int k = 0; k < 3; k++) if (x[k] < 0 || x[k] > 0) return 0;
    return 1;
}

/* A force at its point, a couple by itself, a mass: the form has one of them in a line. */
static void write_load(FILE *out, const sp_load *load, const char *const *name)
{
    const sp_real none[3] = { 0, 0, 0 };
    for (int couple = 0; couple < 2; couple++) {
        if (couple ? is_zero(load->couple) : is_zero(load->force) && (!is_zero(load->couple) || load->mass > 0)) continue;
        fputs(load->live ? "#@ live" : "#@ load", out);
        write_name(out, name, load->block);
        write_triple(out, "", couple ? none : load->force);
        write_triple(out, "", couple ? load->couple : load->point);
        fputs(couple ? " couple\n" : "\n", out);
    }
    if (!(load->mass > 0)) return;
    char kg[32];
    fputs("#@ mass", out);
    write_name(out, name, load->block);
    fprintf(out, " %s", text_shortest(load->mass, kg));
    write_triple(out, "", load->point);
    fputs(load->live ? " live\n" : "\n", out);
}

static int is_same(sp_real a, sp_real b) { return !(a < b) && !(a > b); }

/* A name that a line would not give back: a comment, a quotation, one that goes on in the next line. */
static int is_lost(const char *name)
{
    const size_t n = strlen(name);
    return n == 0 || name[0] == '#' || name[0] == '"' || name[n - 1] == '\\';
}

int obj_write(FILE *out, const sp_scene *s, const char *const *name, const char *path, failure *error)
{
    sp_real density = 0;                        /* of all blocks that have one */
    int one_density = 1, one_mu = s->count.joints > 0;

    if (s->live < 1 || s->live > 1 || !is_zero(s->body))
        return fail_with(error, EXIT_SCENE, path, 0, "a scene file has no word for live loads that count %g times, nor for "
                         "a live acceleration", (double)s->live);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *block = &s->block[b];
        if (name && is_lost(name[b]))
            return fail_with(error, EXIT_SCENE, path, 0, "block '%.200s': a scene file can't hold this name", name[b]);
        if (block->faces == 0 && block->fixed != SP_FIXED)
            return fail_with(error, EXIT_SCENE, path, 0, "block %ld has no mesh, which a scene file can't say", (long)b);
        if (!(density > 0)) density = block->density;
        if (block->density > 0) one_density = one_density && is_same(block->density, density);
    }
    for (int32_t i = 1; i < s->count.joints; i++)
        one_mu = one_mu && is_same(s->joint[i].strength.mu, s->joint[0].strength.mu);
    if (one_mu) write_setting(out, "mu", s->joint[0].strength.mu);
    if (one_density && density > 0) write_setting(out, "density", density);
    write_triple(out, "#@ gravity", s->gravity);
    fputs("\n", out);
    for (int32_t b = 0; b < s->count.blocks; b++) write_block(out, s, b, name, !one_density);
    for (int32_t i = 0; i < s->count.joints; i++) write_contact(out, s, i, name, !one_mu);
    for (int32_t i = 0; i < s->count.loads; i++) write_load(out, &s->load[i], name);
    return 0;
}
