#include "forces.h"
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int forces_arrow(const forces *f, const sp_scene *s, int32_t i, sp_real from[3], sp_real to[3], double *size)
{
    sp_joint_force on;
    double lift = 0, sign;
    if (sp_joint_resultant(s, f->result, i, &on) != SP_OK) return 0;
    *size = view_length(on.force);
    if (!(*size > 0)) return 0;
    for (int c = 0; c < 3; c++) lift -= (double)on.force[c] * (double)s->gravity[c];
    sign = lift < 0 ? -1 : 1;
    for (int c = 0; c < 3; c++) {
        from[c] = on.point[c];
        to[c] = (sp_real)((double)on.point[c] + sign * f->scale * (double)on.force[c]);
    }
    return 1;
}

void forces_scale(forces *f, drawing *d, const sp_result *result, double length)
{
    sp_real from[3], to[3];
    double size;
    memset(f, 0, sizeof *f);
    f->result = result;
    for (int32_t i = 0; i < d->s->count.joints; i++)
        if (forces_arrow(f, d->s, i, from, to, &size)) f->largest = fmax(f->largest, size);
    if (!(f->largest > 0)) return;
    f->scale = length / f->largest;
    for (int32_t i = 0; i < d->s->count.joints; i++)
        if (forces_arrow(f, d->s, i, from, to, &size)) drawing_cover(d, to);
}

typedef struct arrow { double depth, size, a[2], b[2]; } arrow;

static int nearer(const void *pa, const void *pb)
{
    const arrow *a = pa, *b = pb;
    return (a->depth > b->depth) - (a->depth < b->depth);
}

/* Those long enough to be seen, from the farthest to the nearest.     returns their number */
static int32_t gather_arrows(const forces *f, const drawing *d, arrow *drawn)
{
    int32_t n = 0;
    for (int32_t i = 0; f->largest > 0 && i < d->s->count.joints; i++) {
        sp_real from[3], to[3];
        double size;
        if (!forces_arrow(f, d->s, i, from, to, &size)) continue;
        drawing_point(d, from, drawn[n].a);
        drawing_point(d, to, drawn[n].b);
        if (hypot(drawn[n].b[0] - drawn[n].a[0], drawn[n].b[1] - drawn[n].a[1]) < 2) continue;
        drawn[n].depth = 0;
        drawn[n].size = size;
        for (int c = 0; c < 3; c++) drawn[n].depth += d->v.toward[c] * (double)from[c];
        n++;
    }
    return n;
}

static int in_cells(const void *pa, const void *pb)
{
    const arrow *a = pa, *b = pb;
    for (int c = 0; c < 2; c++) {
        const double x = floor(a->a[c] / FORCES_CELL), y = floor(b->a[c] / FORCES_CELL);
        if (x < y || x > y) return x < y ? -1 : 1;
    }
    return (a->size < b->size) - (a->size > b->size);
}

/* The largest of each square.     returns their number */
static int32_t thin_out(arrow *drawn, int32_t n)
{
    int32_t kept = 0;
    qsort(drawn, (size_t)n, sizeof *drawn, in_cells);
    for (int32_t i = 0; i < n; i++) {
        const arrow *last = &drawn[kept ? kept - 1 : 0];
        if (kept && floor(last->a[0] / FORCES_CELL) >= floor(drawn[i].a[0] / FORCES_CELL)
            && floor(last->a[1] / FORCES_CELL) >= floor(drawn[i].a[1] / FORCES_CELL)) continue;
        drawn[kept++] = drawn[i];
    }
    return kept;
}

int forces_draw(forces *f, const drawing *d, int fade)
{
    const int many = d->s->count.joints > 400;
    arrow *drawn = malloc(((size_t)d->s->count.joints + 1) * sizeof *drawn);
    int32_t n;
    double range;

    if (!drawn) return 0;
    f->left_out = n = gather_arrows(f, d, drawn);
    if (d->s->count.joints > FORCES_MANY) n = thin_out(drawn, n);
    f->left_out -= n;
    qsort(drawn, (size_t)n, sizeof *drawn, nearer);
    range = n ? drawn[n - 1].depth - drawn[0].depth : 0;
    for (int32_t i = 0; i < n; i++) {
        const arrow *a = &drawn[i];
        const double far = fade && range > 0 ? (drawn[n - 1].depth - a->depth) / range : 0;
        fprintf(d->out, "<g opacity=\"%.2f\">", 1 - 0.85 * far);
        page_arrow(d->out, a->a, a->b, INK_FORCE, many ? 1.0 : 1.7, many ? 5 : 8);
        if (!many) fprintf(d->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.8\" fill=\"%s\"/>", a->a[0], a->a[1], INK_FORCE);
        fputs("</g>\n", d->out);
    }
    free(drawn);
    return 1;
}
