/* write: a scene as a file; see write.h. */
#include "write.h"

static void sp_write_triple(FILE *out, const sp_real x[3]) { fprintf(out, " %.17g %.17g %.17g", x[0], x[1], x[2]); }

/* gravity + live body, which acts on all masses as gravity does. */
static void sp_write_gravity(FILE *out, const sp_scene *s)
{
    sp_real g[3];
    for (int c = 0; c < 3; c++) g[c] = s->gravity[c] + s->live * s->body[c];
    fputs("#@ gravity", out);
    sp_write_triple(out, g);
    fputs("\n", out);
}

static void sp_write_fixed(FILE *out, uint32_t held)
{
    static const char *const name[] = { " x", " y", " z", " rx", " ry", " rz" };
    if (!held) return;
    fputs("#@ fixed", out);
    for (int k = 0; k < 6; k++) if (held != SP_FIXED && held >> k & 1) fputs(name[k], out);
    fputs("\n", out);
}

static void sp_write_block(FILE *out, const sp_scene *s, int32_t b)
{
    const sp_block *block = &s->block[b];
    fprintf(out, "o b%ld\n", (long)b);
    sp_write_fixed(out, block->fixed);
    if (block->density > 0) fprintf(out, "#@ density %.17g\n", block->density);
    for (int32_t v = 0; v < block->vertices; v++) {
        fputs("v", out);
        sp_write_triple(out, s->vertex[block->vertex + v]);
        fputs("\n", out);
    }
    for (int32_t f = block->face; f < block->face + block->faces; f++) {
        fputs("f", out);
        for (int32_t c = 0; c < s->face[f].corners; c++) fprintf(out, " %ld", (long)s->corner[s->face[f].corner + c] + 1);
        fputs("\n", out);
    }
}

static void sp_write_joint(FILE *out, const sp_scene *s, const sp_joint *j)
{
    fprintf(out, "#@ %s b%ld b%ld", j->area > 0 ? "interface" : "points", (long)j->a, (long)j->b);
    if (!(j->area > 0)) sp_write_triple(out, j->n);
    for (int32_t k = 0; k < j->points; k++) sp_write_triple(out, s->point[j->point + k]);
    fprintf(out, "\n#@ mu %.17g\n", j->strength.mu);
    if (j->strength.cohesion > 0) fprintf(out, "#@ cohesion %.17g\n", j->strength.cohesion);
    if (j->strength.tension > 0) fprintf(out, "#@ tension %.17g\n", j->strength.tension);
    if (j->strength.crushing > 0) fprintf(out, "#@ crushing %.17g\n", j->strength.crushing);
}

/* A line for the force, one for the couple, one for the mass: the form has one of them in a line. */
static void sp_write_load(FILE *out, const sp_scene *s, const sp_load *load)
{
    const sp_real share = load->live ? s->live : 1, none[3] = { 0, 0, 0 };
    sp_real force[3], couple[3];
    for (int c = 0; c < 3; c++) force[c] = share * load->force[c], couple[c] = share * load->couple[c];
    fprintf(out, "#@ load b%ld", (long)load->block);
    sp_write_triple(out, force);
    sp_write_triple(out, load->point);
    fputs("\n", out);
    if (couple[0] < 0 || couple[0] > 0 || couple[1] < 0 || couple[1] > 0 || couple[2] < 0 || couple[2] > 0) {
        fprintf(out, "#@ load b%ld", (long)load->block);
        sp_write_triple(out, none);
        sp_write_triple(out, couple);
        fputs(" couple\n", out);
    }
    if (!(share * load->mass > 0)) return;
    fprintf(out, "#@ mass b%ld %.17g", (long)load->block, share * load->mass);
    sp_write_triple(out, load->point);
    fputs("\n", out);
}

sp_status sp_scene_write(const sp_scene *scene, FILE *out)
{
    for (int32_t b = 0; b < scene->count.blocks; b++)
        if (!scene->block[b].faces && scene->block[b].fixed != SP_FIXED) return SP_E_UNSUPPORTED;
    sp_write_gravity(out, scene);
    for (int32_t b = 0; b < scene->count.blocks; b++) sp_write_block(out, scene, b);
    for (int32_t k = 0; k < scene->count.joints; k++) sp_write_joint(out, scene, &scene->joint[k]);
    for (int32_t k = 0; k < scene->count.loads; k++) sp_write_load(out, scene, &scene->load[k]);
    return ferror(out) ? SP_E_ARGUMENT : SP_OK;
}
