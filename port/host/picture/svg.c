/* The picture of a scene: an axonometric drawing in the painter's order, joints and forces over it, words around it.
 *
 * World lengths become paper lengths by one scale, y downwards. Everything drawn is measured before the scale is chosen.
 */
#include "../files/json_out.h"
#include "../motion.h"
#include "hidden.h"
#include "svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH   900.0                   /* [px] */
#define MARGIN  36.0
#define TALLEST 600.0                   /* of the drawing */
#define HEAD    84.0                    /* of the title */
#define FOOT    96.0                    /* of the legend */

static const char *const color_force = "#1d5fa6", *const color_weak = "#e07b00", *const color_motion = "#b2182b";
static const char *const color_hinge = "#6a1b9a", *const color_slide = "#00796b";

typedef struct edge { int32_t low, high, face; } edge;

/* What the drawing needs to know. */
typedef struct picture {
    FILE *out;
    const host_scene *scene;            /* NULL of a sheet */
    const sp_scene *s;
    const sp_result *x;
    const sp_limit_result *limit;       /* x is of it; NULL: of a check */
    const unsigned char *mark;          /* of each block an svg_mark, or NULL */
    view v;
    double low[2], high[2];             /* of all that is drawn, on paper in world lengths */
    double size, block;                 /* of the scene, of a usual block [m] */
    double scale, left, top;            /* px = left + scale (x - low), top + scale (high - y) */
    double force_scale;                 /* length of an arrow per force [m/N] */
    double largest;                     /* [N] force of a joint */
    double shift, largest_shift;        /* factor on dq; longest way a corner goes in the drawing [m] */
    int forces, moving;                 /* is there any? */
    int32_t hinges, slides;             /* of a limit's mechanism */
    edge *edge;                         /* of all faces, sorted by block's vertex pairs */
    int32_t edges;
    unsigned char *bend;                /* do the faces bend at the edge that follows this corner? */
    unsigned char *crease;              /* is it drawn: a bend, or the rim of what is seen? */
} picture;

/* ---------------------------------------------------------------------------------------------------------------- view */

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double norm_real(const sp_real a[3])
{
    return sqrt((double)a[0] * (double)a[0] + (double)a[1] * (double)a[1] + (double)a[2] * (double)a[2]);
}

/* How badly joints are seen from a direction: best from a little above, which shows how the blocks stand on each other. */
static double joints_seen(const sp_scene *s, const double toward[3])
{
    const double best = 0.35;           /* sine of the angle between joint and view */
    double sum = 0, area = 0;
    for (int32_t i = 0; i < s->count.interfaces; i++) {
        const sp_interface *c = &s->interface[i];
        double t = 0;
        for (int k = 0; k < 3; k++) t += toward[k] * (double)c->n[k];
        sum += fabs((c->n[2] < 0 ? -t : t) - best) * (double)c->area;
        area += (double)c->area;
    }
    return area > 0 ? sum / area : 0;
}

/* From `yaw` to the left of the front (0: -y, 1: +x) and `rise` above the horizon. */
static view look(int front, double yaw, double rise)
{
    const double f[2] = { front ? 1 : 0, front ? 0 : -1 }, side[2] = { front ? 0 : 1, front ? 1 : 0 };
    view v;
    for (int c = 0; c < 2; c++) {
        const double level = cos(yaw) * f[c] - sin(yaw) * side[c];
        v.right[c] = cos(yaw) * side[c] + sin(yaw) * f[c];
        v.toward[c] = cos(rise) * level;
        v.up[c] = -sin(rise) * level;
    }
    v.right[2] = 0;
    v.toward[2] = sin(rise);
    v.up[2] = cos(rise);
    return v;
}

/* From above and from the front left; the front is the longer side in plan. Where the plan is about square, the other side, the front right and
 * directions nearer to square on are tried, too. Thin walls are seen more squarely, towers from lower down. */
static view choose_view(const sp_scene *s)
{
    const double rad = 3.14159265358979323846 / 180;
    double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    double d[3], ratio, yaw, rise;
    view best;

    for (int32_t k = 0; k < s->count.vertices; k++)
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], (double)s->vertex[k][c]);
            high[c] = fmax(high[c], (double)s->vertex[k][c]);
        }
    for (int c = 0; c < 3; c++) d[c] = fmax(high[c] - low[c], 0);
    ratio = fmin(d[0], d[1]) / fmax(fmax(d[0], d[1]), 1e-300);
    yaw = (18 + 14 * ratio) * rad;
    rise = (d[2] > 2.5 * fmax(d[0], d[1]) ? 14 : 16 + 10 * ratio) * rad;
    best = look(d[1] > d[0], yaw, rise);
    for (int k = 1; k < 8 && ratio > 0.5; k++) {
        const view other = look(k & 1 ? d[1] <= d[0] : d[1] > d[0], (k & 2 ? -yaw : yaw) * (k & 4 ? 0.4 : 1), rise);
        if (joints_seen(s, other.toward) < 0.9 * joints_seen(s, best.toward)) best = other;
    }
    return best;
}

static void px(const picture *p, const double at[2], double out[2])
{
    out[0] = p->left + p->scale * (at[0] - p->low[0]);
    out[1] = p->top + p->scale * (p->high[1] - at[1]);
}

static void world_px(const picture *p, const sp_real x[3], double out[2])
{
    double at[2];
    view_point(&p->v, x, at);
    px(p, at, out);
}

static void cover(picture *p, const sp_real x[3])
{
    double at[2];
    view_point(&p->v, x, at);
    for (int c = 0; c < 2; c++) {
        p->low[c] = fmin(p->low[c], at[c]);
        p->high[c] = fmax(p->high[c], at[c]);
    }
}

/* ------------------------------------------------------------------------------------------------------------ creases */

static int compare_edges(const void *pa, const void *pb)
{
    const edge *a = pa, *b = pb;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    if (a->high != b->high) return a->high < b->high ? -1 : 1;
    return (a->face > b->face) - (a->face < b->face);
}

static edge edge_after(const sp_scene *s, int32_t face, int32_t k)
{
    const sp_face *f = &s->face[face];
    const int32_t a = s->corner[f->corner + k], b = s->corner[f->corner + (k + 1) % f->corners];
    const edge e = { a < b ? a : b, a < b ? b : a, face };
    return e;
}

/* The other face at an edge of this face, -1: none, or more than one. */
static int32_t neighbour(const picture *p, edge e)
{
    const edge first = { e.low, e.high, -1 };
    int32_t low = 0, high = p->edges, n = 0;
    while (low < high) {
        const int32_t middle = low + (high - low) / 2;
        if (compare_edges(&p->edge[middle], &first) < 0) low = middle + 1;
        else high = middle;
    }
    while (low + n < p->edges && p->edge[low + n].low == e.low && p->edge[low + n].high == e.high) n++;
    if (n != 2) return -1;
    return p->edge[low].face == e.face ? p->edge[low + 1].face : p->edge[low].face;
}

/* Faces bend at an edge by more than 10 degrees, or there is no other face; it is drawn, too, if the other looks away. */
static void judge_edge(const picture *p, int32_t face, int32_t k)
{
    const int32_t other = neighbour(p, edge_after(p->s, face, k)), at = p->s->face[face].corner + k;
    double a[3], b[3];
    p->bend[at] = p->crease[at] = 1;
    if (other < 0) return;
    view_normal(p->s, face, a);
    view_normal(p->s, other, b);
    p->bend[at] = dot(a, b) < 0.985 * sqrt(dot(a, a) * dot(b, b));
    p->crease[at] = p->bend[at] || dot(b, p->v.toward) <= 0;
}

static int find_creases(picture *p)
{
    const sp_scene *s = p->s;
    p->edge = malloc(((size_t)s->count.corners + 1) * sizeof *p->edge);
    p->crease = malloc((size_t)s->count.corners + 1);
    p->bend = malloc((size_t)s->count.corners + 1);
    if (!p->edge || !p->crease || !p->bend) return 0;
    for (int32_t f = 0; f < s->count.faces; f++)
        for (int32_t k = 0; k < s->face[f].corners; k++) p->edge[p->edges++] = edge_after(s, f, k);
    qsort(p->edge, (size_t)p->edges, sizeof *p->edge, compare_edges);
    for (int32_t f = 0; f < s->count.faces; f++)
        for (int32_t k = 0; k < s->face[f].corners; k++) judge_edge(p, f, k);
    return 1;
}

/* -------------------------------------------------------------------------------------------------------------- blocks */

static int32_t block_of(const sp_scene *s, int32_t face)
{
    int32_t low = 0, high = s->count.blocks - 1;
    while (low < high) {                                /* the last block whose faces begin at or before this one */
        const int32_t middle = low + (high - low + 1) / 2;
        if (s->block[middle].face <= face) low = middle;
        else high = middle - 1;
    }
    return low;
}

/* Lambert's law with a light from the upper left, a little of the block's own tint. */
static const double color_mark[5][3] = {                /* by svg_mark */
    { 226, 213, 190 }, { 226, 213, 190 }, { 168, 200, 232 }, { 246, 190, 90 }, { 226, 140, 128 } };

static void shade(const picture *p, int32_t face, int32_t block, int rgb[3])
{
    static const double support[3] = { 158, 166, 174 };
    const double *stone = color_mark[p->mark ? p->mark[block] : SVG_PLAIN];
    double n[3], light[3], bright, tint;
    const uint32_t hash = ((uint32_t)block + 1) * 2654435761u;

    for (int c = 0; c < 3; c++) light[c] = 0.55 * p->v.up[c] + 0.75 * p->v.toward[c] - 0.25 * p->v.right[c];
    view_normal(p->s, face, n);
    bright = dot(n, light) / sqrt(fmax(dot(n, n) * dot(light, light), 1e-300));
    tint = ((hash >> 16) % 1000) / 1000.0 - 0.5;
    bright = 0.66 + 0.38 * fmax(0, bright) + 0.05 * tint;
    for (int c = 0; c < 3; c++) {
        const double base = p->s->block[block].fixed ? support[c] : stone[c];
        rgb[c] = (int)fmin(255, base * bright + (c == 0 ? 3 * tint : 0));
    }
}

static void outline(const picture *p, int32_t face)
{
    const sp_face *f = &p->s->face[face];
    for (int32_t k = 0; k < f->corners; k++) {
        double at[2];
        world_px(p, p->s->vertex[p->s->corner[f->corner + k]], at);
        fprintf(p->out, "%s%.1f %.1f", k ? "L" : "M", at[0], at[1]);
    }
    fputs("Z", p->out);
}

/* The drawn edges of a face as runs of lines. */
static void creases(const picture *p, int32_t face)
{
    const sp_face *f = &p->s->face[face];
    int pen = 0;
    for (int32_t k = 0; k < f->corners; k++) {
        double a[2], b[2];
        if (!p->crease[f->corner + k]) { pen = 0; continue; }
        world_px(p, p->s->vertex[p->s->corner[f->corner + k]], a);
        world_px(p, p->s->vertex[p->s->corner[f->corner + (k + 1) % f->corners]], b);
        if (!pen) fprintf(p->out, "M%.1f %.1f", a[0], a[1]);
        fprintf(p->out, "L%.1f %.1f", b[0], b[1]);
        pen = 1;
    }
}

static int any_crease(const picture *p, int32_t face)
{
    for (int32_t k = 0; k < p->s->face[face].corners; k++)
        if (p->crease[p->s->face[face].corner + k]) return 1;
    return 0;
}

static int draw_blocks(picture *p)
{
    int32_t *order;
    const int32_t n = hidden_order(p->s, &p->v, &order);
    if (n < 0) return 0;
    fprintf(p->out, "<g stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\"%.2f\">\n", n > 2000 ? 0.5 : 1.0);
    for (int32_t i = 0; i < n; i++) {
        const int32_t block = block_of(p->s, order[i]);
        int c[3];
        shade(p, order[i], block, c);
        fprintf(p->out, "<path fill=\"#%02x%02x%02x\" stroke=\"#%02x%02x%02x\" d=\"", c[0], c[1], c[2], c[0], c[1], c[2]);
        outline(p, order[i]);
        fputs("\"/>\n", p->out);
        if (p->s->block[block].fixed) {
            fputs("<path fill=\"url(#hatch)\" d=\"", p->out);
            outline(p, order[i]);
            fputs("\"/>\n", p->out);
        }
        if (!any_crease(p, order[i])) continue;
        fprintf(p->out, "<path fill=\"none\" stroke=\"#%02x%02x%02x\" d=\"", c[0] * 45 / 100, c[1] * 43 / 100, c[2] * 42 / 100);
        creases(p, order[i]);
        fputs("\"/>\n", p->out);
    }
    fputs("</g>\n", p->out);
    free(order);
    return 1;
}

/* -------------------------------------------------------------------------------------------------------------- joints */

static void draw_weakest(const picture *p)
{
    const int32_t weakest = p->x->weakest;
    const sp_interface *c;
    double at[2];

    if (weakest < 0) return;
    c = &p->s->interface[weakest];
    fprintf(p->out, "<path fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" stroke-width=\"2.4\" stroke-linejoin=\"round\" d=\"",
            color_weak, color_weak);
    for (int32_t k = 0; k < c->points; k++) {
        world_px(p, p->s->point[c->point + k], at);
        fprintf(p->out, "%s%.1f %.1f", k ? "L" : "M", at[0], at[1]);
    }
    fputs(c->points > 2 ? "Z\"/>\n" : "\"/>\n", p->out);
    for (int32_t k = 0; k < c->points && c->points < 3; k++) {
        world_px(p, p->s->point[c->point + k], at);
        fprintf(p->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", at[0], at[1], color_weak);
    }
}

/* Joints of a limit's mechanism: hinges as thick lines with their ends, sliding joints as tinted polygons. */
static void draw_gives(picture *p)
{
    for (int32_t i = 0; p->limit && i < p->s->count.interfaces; i++) {
        const sp_interface *c = &p->s->interface[i];
        sp_joint_motion m;
        double a[2], b[2];
        if (sp_joint_moves(p->s, p->limit->dq, i, &m) != SP_OK) continue;
        if (m.kind == SP_JOINT_HINGE) {
            p->hinges++;
            world_px(p, m.a, a);
            world_px(p, m.b, b);
            fprintf(p->out, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"4\" stroke-linecap=\"round\"/>"
                    "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"#fff\" stroke=\"%s\" stroke-width=\"2\"/>\n", a[0], a[1], b[0], b[1],
                    color_hinge, a[0], a[1], color_hinge);
        }
        if (m.kind != SP_JOINT_SLIDING) continue;
        p->slides++;
        fprintf(p->out, "<path fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" stroke-width=\"2\" d=\"", color_slide, color_slide);
        for (int32_t k = 0; k < c->points; k++) {
            world_px(p, p->s->point[c->point + k], a);
            fprintf(p->out, "%s%.1f %.1f", k ? "L" : "M", a[0], a[1]);
        }
        fputs(c->points > 2 ? "Z\"/>\n" : "\"/>\n", p->out);
    }
}

/* The force of a joint on the block it holds up: the one it pushes against gravity. */
static int joint_force(const picture *p, int32_t i, sp_real from[3], sp_real to[3], double *size)
{
    sp_interface_force f;
    double lift = 0, sign;
    if (sp_interface_resultant(p->s, p->x, i, &f) != SP_OK) return 0;
    *size = norm_real(f.force);
    if (!(*size > 0)) return 0;
    for (int c = 0; c < 3; c++) lift -= (double)f.force[c] * (double)p->s->gravity[c];
    sign = lift < 0 ? -1 : 1;
    for (int c = 0; c < 3; c++) {
        from[c] = f.point[c];
        to[c] = (sp_real)((double)f.point[c] + sign * p->force_scale * (double)f.force[c]);
    }
    return 1;
}

/* Thin ones are many: they have no light rim. */
static void arrow(FILE *out, const double a[2], const double b[2], const char *color, double width, double head)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = sqrt(dx * dx + dy * dy);
    const double h = fmin(head, 0.6 * length), ux = dx / fmax(length, 1e-9), uy = dy / fmax(length, 1e-9);
    if (length < 1) return;
    for (int halo = width > 1; halo >= 0; halo--) {
        const char *ink = halo ? "#ffffff" : color;
        const double w = halo ? width + 1.8 : width;
        fprintf(out, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"%.1f\"%s fill=\"none\"/>", a[0], a[1],
                b[0] - ux * h * 0.8, b[1] - uy * h * 0.8, ink, w, halo ? " stroke-opacity=\"0.75\"" : "");
        fprintf(out, "<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fZ\" fill=\"%s\" stroke=\"%s\" stroke-width=\"%.1f\"%s/>\n", b[0], b[1],
                b[0] - ux * h - uy * h * 0.36, b[1] - uy * h + ux * h * 0.36, b[0] - ux * h + uy * h * 0.36,
                b[1] - uy * h - ux * h * 0.36, ink, ink, halo ? 1.8 : 0.0, halo ? " stroke-opacity=\"0.75\"" : "");
    }
}

typedef struct drawn_force { double depth, a[2], b[2]; } drawn_force;

static int nearer(const void *pa, const void *pb)
{
    const drawn_force *a = pa, *b = pb;
    return (a->depth > b->depth) - (a->depth < b->depth);
}

/* Are the two sides in plan of a size? Then joints lie behind each other. */
static int deep(const picture *p)
{
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    for (int32_t k = 0; k < p->s->count.vertices; k++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], (double)p->s->vertex[k][c]);
            high[c] = fmax(high[c], (double)p->s->vertex[k][c]);
        }
    return fmin(high[0] - low[0], high[1] - low[1]) > 3 * p->block;
}

/* Far ones first and, where the scene is many blocks deep, fainter. */
static int draw_forces(const picture *p)
{
    const int many = p->s->count.interfaces > 400, fade = deep(p);
    drawn_force *f = malloc(((size_t)p->s->count.interfaces + 1) * sizeof *f);
    int32_t n = 0;
    double range;

    if (!f) return 0;
    for (int32_t i = 0; p->forces && i < p->s->count.interfaces; i++) {
        sp_real from[3], to[3];
        double size;
        if (!joint_force(p, i, from, to, &size)) continue;
        world_px(p, from, f[n].a);
        world_px(p, to, f[n].b);
        if (hypot(f[n].b[0] - f[n].a[0], f[n].b[1] - f[n].a[1]) < 2) continue;
        f[n].depth = 0;
        for (int c = 0; c < 3; c++) f[n].depth += p->v.toward[c] * (double)from[c];
        n++;
    }
    qsort(f, (size_t)n, sizeof *f, nearer);
    range = n ? f[n - 1].depth - f[0].depth : 0;
    for (int32_t i = 0; i < n; i++) {
        const double far = fade && range > 0 ? (f[n - 1].depth - f[i].depth) / range : 0;
        fprintf(p->out, "<g opacity=\"%.2f\">", 1 - 0.85 * far);
        arrow(p->out, f[i].a, f[i].b, color_force, many ? 1.0 : 1.7, many ? 5 : 8);
        if (!many) fprintf(p->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.8\" fill=\"%s\"/>", f[i].a[0], f[i].a[1], color_force);
        fputs("</g>\n", p->out);
    }
    free(f);
    return 1;
}

/* ----------------------------------------------------------------------------------------------------------- mechanism */

/* Where a corner of block b goes: x -> c + R (x - c) + shift v, R the rotation by shift w.                  [Rodrigues] */
static void moved(const picture *p, int32_t b, const sp_real x[3], double shift, sp_real out[3])
{
    const sp_real *dq = motion_shown(p->x) + 6 * (size_t)b, *o = p->s->block[b].centroid;
    const double rate = norm_real(dq + 3), angle = shift * rate, k = rate > 0 ? 1 / rate : 0;
    const double w[3] = { k * (double)dq[3], k * (double)dq[4], k * (double)dq[5] };
    double d[3], along;
    for (int c = 0; c < 3; c++) d[c] = (double)x[c] - (double)o[c];
    along = dot(w, d);
    for (int c = 0; c < 3; c++) {
        const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        const double turned = d[c] * cos(angle) + (w[c1] * d[c2] - w[c2] * d[c1]) * sin(angle) + w[c] * along * (1 - cos(angle));
        out[c] = (sp_real)((double)o[c] + (rate > 0 ? turned : d[c]) + shift * (double)dq[c]);
    }
}

/* Does this face look towards the viewer after it moved? Tells by its area on paper. */
static int moved_seen(const picture *p, int32_t b, int32_t face)
{
    const sp_face *f = &p->s->face[face];
    double area = 0, first[2] = { 0, 0 }, before[2] = { 0, 0 };
    for (int32_t k = 0; k < f->corners; k++) {
        sp_real x[3];
        double at[2];
        moved(p, b, p->s->vertex[p->s->corner[f->corner + k]], p->shift, x);
        view_point(&p->v, x, at);
        if (k == 0) { first[0] = at[0]; first[1] = at[1]; }
        if (k > 1) area += (before[0] - first[0]) * (at[1] - first[1]) - (before[1] - first[1]) * (at[0] - first[0]);
        before[0] = at[0];
        before[1] = at[1];
    }
    return area > 0;
}

/* The outline of a moved face; an edge between two seen faces is drawn with the first of them only. */
static void moved_outline(const picture *p, int32_t b, int32_t face)
{
    const sp_face *f = &p->s->face[face];
    for (int32_t k = 0; k < f->corners; k++) {
        const int32_t other = neighbour(p, edge_after(p->s, face, k));
        sp_real x[3], y[3];
        double from[2], to[2];
        if (other >= 0 && moved_seen(p, b, other) && (other < face || !p->bend[f->corner + k])) continue;
        moved(p, b, p->s->vertex[p->s->corner[f->corner + k]], p->shift, x);
        moved(p, b, p->s->vertex[p->s->corner[f->corner + (k + 1) % f->corners]], p->shift, y);
        world_px(p, x, from);
        world_px(p, y, to);
        fprintf(p->out, "M%.1f %.1fL%.1f %.1f", from[0], from[1], to[0], to[1]);
    }
}

static void draw_mechanism(const picture *p)
{
    if (!p->moving) return;
    fprintf(p->out, "<g fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\" stroke-linejoin=\"round\">\n",
            color_motion);
    for (int32_t b = 0; b < p->s->count.blocks; b++) {
        const int32_t end = p->s->block[b].face + p->s->block[b].faces;
        if (!(motion_speed(p->s, p->x, b) > 1e-3)) continue;
        fputs("<path d=\"", p->out);
        for (int32_t i = p->s->block[b].face; i < end; i++)
            if (moved_seen(p, b, i)) moved_outline(p, b, i);
        fputs("\"/>\n", p->out);
    }
    fputs("</g>\n", p->out);
}

/* ------------------------------------------------------------------------------------------------------------- scales */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Diameter that half of the free blocks exceed. */
static double median_block(const picture *p)
{
    double *d = malloc(((size_t)p->s->count.blocks + 1) * sizeof *d), m;
    size_t n = 0;
    if (!d) return p->size / 10;
    for (int32_t b = 0; b < p->s->count.blocks; b++)
        if (!p->s->block[b].fixed && p->s->block[b].diameter > 0) d[n++] = (double)p->s->block[b].diameter;
    qsort(d, n, sizeof *d, ascending);
    m = n ? d[n / 2] : p->size / 10;
    free(d);
    return m;
}

/* Arrows: the largest is about as long as a block. */
static void scale_forces(picture *p)
{
    const double length = fmin(fmax(0.75 * p->block, 0.05 * p->size), 0.2 * p->size);
    for (int32_t i = 0; i < p->s->count.interfaces; i++) {
        sp_real from[3], to[3];
        double size;
        if (joint_force(p, i, from, to, &size)) p->largest = fmax(p->largest, size);
    }
    p->forces = p->largest > 0;
    if (p->forces) p->force_scale = length / p->largest;
    for (int32_t i = 0; i < p->s->count.interfaces && p->forces; i++) {
        sp_real from[3], to[3];
        double size;
        if (joint_force(p, i, from, to, &size)) cover(p, to);
    }
}

static double farthest(const picture *p, double shift)
{
    double most = 0;
    for (int32_t b = 0; b < p->s->count.blocks; b++)
        for (int32_t k = 0; k < p->s->block[b].vertices && motion_speed(p->s, p->x, b) > 0; k++) {
            const sp_real *x = p->s->vertex[p->s->block[b].vertex + k];
            sp_real y[3], d[3];
            moved(p, b, x, shift, y);
            for (int c = 0; c < 3; c++) d[c] = y[c] - x[c];
            most = fmax(most, norm_real(d));
        }
    return most;
}

/* Motion: the corner that goes farthest goes a third of a block, at least 4 and at most 12 % of the scene. */
static void scale_motion(picture *p)
{
    const double length = fmin(fmax(p->block / 3, 0.04 * p->size), 0.12 * p->size);
    double probe, rate;
    if (p->x->verdict != SP_UNSTABLE && !motion_is_virtual(p->x)) return;
    probe = 1e-3 * p->size * (motion_is_virtual(p->x) ? 1 / fmax((double)p->x->coupled.eta, 1e-300) : 1);
    rate = farthest(p, probe) / probe;
    if (!(rate > 0)) return;
    p->moving = 1;
    p->shift = length / rate;
    p->largest_shift = farthest(p, p->shift);
    for (int32_t b = 0; b < p->s->count.blocks; b++)
        for (int32_t k = 0; k < p->s->block[b].vertices && motion_speed(p->s, p->x, b) > 1e-3; k++) {
            sp_real y[3];
            moved(p, b, p->s->vertex[p->s->block[b].vertex + k], p->shift, y);
            cover(p, y);
        }
}

static void scale_paper(picture *p)
{
    double w, h;
    if (!(p->high[0] >= p->low[0])) p->low[0] = p->low[1] = p->high[0] = p->high[1] = 0;
    w = fmax(p->high[0] - p->low[0], 1e-12 * p->size);
    h = fmax(p->high[1] - p->low[1], 1e-12 * p->size);
    p->scale = fmin((WIDTH - 2 * MARGIN) / w, TALLEST / h);
    if (!(p->scale < HUGE_VAL)) p->scale = 1;
    p->left = (WIDTH - p->scale * w) / 2;
    p->top = HEAD + MARGIN / 2;
}

/* --------------------------------------------------------------------------------------------------------------- words */

/* Text inside an element, at most so many characters: markup escaped, bytes that are no UTF-8 shown as '?'. */
static void escaped(FILE *out, const char *s, size_t most)
{
    for (size_t n = 0; *s && n < most; n++) {
        const int bytes = json_utf8(s);
        if (*s == '<') fputs("&lt;", out);
        else if (*s == '>') fputs("&gt;", out);
        else if (*s == '&') fputs("&amp;", out);
        else if (bytes == 0 || (unsigned char)*s < 32 || *s == 127) fputc('?', out);
        else fwrite(s, 1, (size_t)bytes, out);
        s += bytes ? bytes : 1;
    }
    if (*s) fputs("...", out);
}

static void quantity(FILE *out, double x, const char *unit)
{
    static const char *const prefix[] = { "n", "&#181;", "m", "", "k", "M", "G", "T" };
    int k = 3;
    while (fabs(x) >= 999.5 && k < 7) { x /= 1000; k++; }
    while (fabs(x) > 0 && fabs(x) < 0.9995 && k > 0) { x *= 1000; k--; }
    fprintf(out, "%.3g %s%s", x, prefix[k], unit);
}

/* The largest 1, 2 or 5 times a power of ten below x. */
static double round_below(double x)
{
    const double ten = pow(10, floor(log10(x)));
    return ten * (x / ten >= 5 ? 5 : x / ten >= 2 ? 2 : 1);
}

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static void friction(const picture *p)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int32_t i = 0; i < p->s->count.interfaces; i++) {
        low = fmin(low, (double)p->s->interface[i].joint.mu);
        high = fmax(high, (double)p->s->interface[i].joint.mu);
    }
    if (!(low <= high)) return;
    fprintf(p->out, high > low ? ", friction %.4g to %.4g" : ", friction %.4g", low, high);
}

static void title_limit(const picture *p)
{
    const sp_limit_result *x = p->limit;
    fprintf(p->out, "<text x=\"%.0f\" y=\"40\" font-size=\"24\" font-weight=\"bold\" fill=\"#333\">", MARGIN);
    if (x->kind == SP_LIMIT_FOUND) fprintf(p->out, "falls at %.6g", (double)x->multiplier);
    else fputs(sp_limit_text(x->kind), p->out);
    fputs("<tspan font-weight=\"normal\" font-size=\"17\" fill=\"#333\" dx=\"12\">times its live loads: ", p->out);
    escaped(p->out, file_name(p->scene->path), 50);
    fprintf(p->out, "</tspan></text>\n<text x=\"%.0f\" y=\"62\" font-size=\"13\" fill=\"#555\">%ld blocks, %ld joints", MARGIN,
            (long)p->s->count.blocks, (long)p->s->count.interfaces);
    friction(p);
    fprintf(p->out, "</text>\n<text x=\"%.0f\" y=\"80\" font-size=\"13\" fill=\"#555\">", MARGIN);
    if (x->kind == SP_LIMIT_FOUND) fprintf(p->out, "forces carry %.9g, this mechanism falls at %.9g%s; ", (double)x->lower,
                                           (double)x->upper, x->verified ? ", verified" : "");
    fputs("with friction an upper value</text>\n", p->out);
}

static void title(const picture *p)
{
    const sp_result *x = p->x;
    const char *word = x->verdict == SP_STABLE ? "stable" : x->verdict == SP_UNSTABLE ? "unstable" : "undecided";
    const char *color = x->verdict == SP_STABLE ? "#1b7837" : x->verdict == SP_UNSTABLE ? color_motion : "#8a6d00";

    fprintf(p->out, "<text x=\"%.0f\" y=\"40\" font-size=\"24\" font-weight=\"bold\" fill=\"%s\">%s"
            "<tspan font-weight=\"normal\" font-size=\"17\" fill=\"#333\" dx=\"12\">", MARGIN, color, word);
    escaped(p->out, file_name(p->scene->path), 60);
    fprintf(p->out, "</tspan></text>\n<text x=\"%.0f\" y=\"62\" font-size=\"13\" fill=\"#555\">", MARGIN);
    fprintf(p->out, "%ld block%s, %ld of them free, %ld joint%s", (long)p->s->count.blocks, p->s->count.blocks == 1 ? "" : "s",
            (long)x->free_blocks, (long)x->interfaces, x->interfaces == 1 ? "" : "s");
    friction(p);
    fputs("; largest compression ", p->out);
    quantity(p->out, (double)x->max_compression, "N");
    fputs("</text>\n", p->out);
    fprintf(p->out, "<text x=\"%.0f\" y=\"80\" font-size=\"13\" fill=\"#555\">", MARGIN);
    if (x->verdict == SP_STABLE) fprintf(p->out, "largest imbalance of a block %.2g, tolerance %.2g", (double)x->omega, (double)x->tol);
    else if (x->verdict == SP_UNSTABLE && x->final) fputs("no joint forces of any size balance it", p->out);
    else if (x->reason == SP_REASON_NO_MOTION) fputs("forces exist, but no virtual motion explains any of them", p->out);
    else if (x->verdict == SP_UNSTABLE) fprintf(p->out, "at best a block stays unbalanced by %.2g of its forces", (double)x->least_imbalance);
    else fprintf(p->out, "best forces leave an imbalance of %.2g, tolerance %.2g", (double)x->omega, (double)x->tol);
    if (x->verdict != SP_UNDECIDED) fputs(x->verified ? ", verified" : ", not verified", p->out);
    fputs("</text>\n", p->out);
}

/* A word of the legend at x, y. */
static void label(FILE *out, double x, double y) { fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"13\" fill=\"#333\">", x, y); }

static void legend_forces(const picture *p, double x, double y)
{
    const double force = round_below(p->largest), length = force * p->force_scale * p->scale;
    const double a[2] = { x, y - 4 }, b[2] = { x + length, y - 4 };
    arrow(p->out, a, b, color_force, 1.7, 8);
    label(p->out, x + length + 10, y);
    quantity(p->out, force, "N");
    fputs(p->limit ? ", force of a joint at the limit</text>\n" : p->x->verdict == SP_STABLE ? ", force of a joint on the block it holds</text>\n"
                                            : ", best force that joints can give</text>\n", p->out);
}

static void legend_weakest(const picture *p, double x, double y)
{
    const int32_t i = p->x->weakest;
    const sp_demand *help = &p->x->demand[i];
    sp_interface_force f;
    fprintf(p->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" "
            "stroke-width=\"2\"/>\n", x, y - 11, color_weak, color_weak);
    label(p->out, x + 36, y);
    fputs("weakest joint ", p->out);
    escaped(p->out, p->scene->name[p->s->interface[i].a], 20);
    fputs(" | ", p->out);
    escaped(p->out, p->scene->name[p->s->interface[i].b], 20);
    if (help->tension > 0 || help->friction > 0) {
        fputs(", lacks ", p->out);
        quantity(p->out, fmax((double)help->tension, (double)help->friction), "N");
        fputs(help->friction > help->tension ? " of friction" : " of tension", p->out);
    } else if (sp_interface_resultant(p->s, p->x, i, &f) == SP_OK)
        fprintf(p->out, ", friction used to %.0f %%", 100 * (double)f.utilisation);
    fputs("</text>\n", p->out);
}

static void legend_motion(const picture *p, double x, double y)
{
    fprintf(p->out, "<path d=\"M%.1f %.1fh26v13h-26z\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" "
            "stroke-dasharray=\"5 3\"/>\n", x, y - 11, color_motion);
    label(p->out, x + 36, y);
    fputs(!motion_is_virtual(p->x) ? "how it starts to move" : p->x->level == SP_COUPLED
          ? "virtual motion that explains the forces" : "virtual motion that would, with such help, explain forces", p->out);
    fputs(", drawn to ", p->out);
    quantity(p->out, p->largest_shift, "m");
    fputs(" at most</text>\n", p->out);
}

static void legend_support(const picture *p, double x, double y)
{
    fprintf(p->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"#9ea6ae\"/><rect x=\"%.1f\" y=\"%.1f\" "
            "width=\"26\" height=\"13\" fill=\"url(#hatch)\" stroke=\"#555\"/>\n", x, y - 11, x, y - 11);
    label(p->out, x + 36, y);
    fputs("fixed</text>\n", p->out);
}

/* A length on the paper's horizontal, which parallel projection keeps. */
static void legend_length(const picture *p, double x, double y)
{
    const double length = round_below(150 / p->scale), w = length * p->scale;
    fprintf(p->out, "<path d=\"M%.1f %.1fv8m0 -4h%.1fm0 -4v8\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.3\"/>\n", x, y - 9, w);
    label(p->out, x + w + 8, y);
    quantity(p->out, length, "m");
    fputs("</text>\n", p->out);
}

/* Gravity where it is not straight down. */
static void legend_gravity(const picture *p)
{
    const sp_real origin[3] = { 0, 0, 0 };
    const double size = norm_real(p->s->gravity);
    double o[2], g[2], a[2] = { WIDTH - 70, 26 }, b[2];
    if (!(size > 0) || (double)p->s->gravity[2] < -size * (1 - 1e-12)) return;
    view_point(&p->v, origin, o);
    view_point(&p->v, p->s->gravity, g);
    b[0] = a[0] + 44 * (g[0] - o[0]) / size;
    b[1] = a[1] - 44 * (g[1] - o[1]) / size;
    arrow(p->out, a, b, "#333333", 1.7, 8);
    label(p->out, a[0] + 12, a[1] + 6);
    fputs("gravity</text>\n", p->out);
}

/* What the marks on the joints of a mechanism mean. */
static void legend_gives(const picture *p, double x, double y)
{
    if (p->hinges) {
        fprintf(p->out, "<path d=\"M%.1f %.1fh22\" stroke=\"%s\" stroke-width=\"4\" stroke-linecap=\"round\"/><circle cx=\"%.1f\" cy=\"%.1f\" "
                "r=\"4.5\" fill=\"#fff\" stroke=\"%s\" stroke-width=\"2\"/>\n", x + 3, y - 4, color_hinge, x + 3, y - 4, color_hinge);
        label(p->out, x + 36, y);
        fprintf(p->out, "%ld hinge%s</text>\n", (long)p->hinges, p->hinges == 1 ? "" : "s");
    }
    if (!p->slides) return;
    if (p->hinges) x += 150;
    fprintf(p->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" "
            "stroke-width=\"2\"/>\n", x, y - 11, color_slide, color_slide);
    label(p->out, x + 36, y);
    fprintf(p->out, "%ld sliding joint%s</text>\n", (long)p->slides, p->slides == 1 ? "" : "s");
}

static void legend(const picture *p, double y)
{
    const double second = 400;
    legend_support(p, MARGIN, y);
    legend_length(p, MARGIN + 110, y);
    if (p->forces) legend_forces(p, second, y);
    if (p->x->weakest >= 0) legend_weakest(p, MARGIN, y + 26);
    legend_gives(p, MARGIN, y + 26);
    if (p->moving) legend_motion(p, MARGIN, y + 52);
    legend_gravity(p);
}

static void page_start(const picture *p, double height)
{
    fprintf(p->out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
            "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n", WIDTH, height, WIDTH, height);
    fputs("<defs><pattern id=\"hatch\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
          "<path d=\"M0 0V7\" stroke=\"#2f3942\" stroke-width=\"1.6\" stroke-opacity=\"0.55\"/></pattern></defs>\n", p->out);
    fprintf(p->out, "<rect width=\"%.0f\" height=\"%.0f\" fill=\"#fcfbf8\"/>\n", WIDTH, height);
}

int svg_write(FILE *out, const svg_subject *subject)
{
    picture p;
    double height, foot;
    int good;

    memset(&p, 0, sizeof p);
    p.out = out;
    p.scene = subject->scene;
    p.s = &subject->scene->scene;
    p.x = subject->result;
    p.limit = subject->limit;
    p.v = choose_view(p.s);
    for (int c = 0; c < 2; c++) { p.low[c] = HUGE_VAL; p.high[c] = -HUGE_VAL; }
    for (int32_t k = 0; k < p.s->count.vertices; k++) cover(&p, p.s->vertex[k]);
    for (int32_t k = 0; k < p.s->count.points; k++) cover(&p, p.s->point[k]);
    p.size = fmax(fmax(p.high[0] - p.low[0], p.high[1] - p.low[1]), 1e-300);
    p.block = median_block(&p);
    scale_forces(&p);
    scale_motion(&p);
    scale_paper(&p);
    foot = FOOT + (p.moving ? 26 : 0);
    height = floor(p.top + p.scale * (p.high[1] - p.low[1]) + foot);
    page_start(&p, height);
    good = find_creases(&p) && draw_blocks(&p);
    if (good) draw_weakest(&p);
    good = good && draw_forces(&p);
    if (good) {
        draw_mechanism(&p);
        draw_gives(&p);
        if (p.limit) title_limit(&p); else title(&p);
        legend(&p, height - foot + 46);
    }
    fputs("</svg>\n", out);
    free(p.edge);
    free(p.crease);
    free(p.bend);
    return good;
}

/* --------------------------------------------------------------------------------------------------------------- sheet */

enum { SHEET_COLUMNS = 3, SHEET_ROWS = 20 };
#define SHEET_GAP 14.0                  /* [px] */
#define SHEET_CAPTION 24.0

/* Paper for some moments, without what fell below where everything began. */
static void cover_moments(picture *p, const sp_scene *s, int frames, const svg_frame *frame, double lowest)
{
    for (int c = 0; c < 2; c++) { p->low[c] = HUGE_VAL; p->high[c] = -HUGE_VAL; }
    for (int i = 0; i < frames; i++)
        for (int32_t k = 0; k < s->count.vertices; k++)
            if ((double)frame[i].vertex[k][2] >= lowest) cover(p, frame[i].vertex[k]);
    for (int c = 0; c < 2 && !(p->high[0] >= p->low[0]); c++) p->low[c] = p->high[c] = 0;
}

/* Only the faces of blocks that are there; `s` has arrays of its own for blocks and faces. */
static void leave_absent(sp_scene *s, const sp_scene *all, const unsigned char *mark)
{
    s->count.faces = 0;
    for (int32_t b = 0; b < all->count.blocks; b++) {
        const sp_block *from = &all->block[b];
        const int there = !mark || mark[b] != SVG_ABSENT;
        s->block[b] = *from;
        s->block[b].face = s->count.faces;
        s->block[b].faces = there ? from->faces : 0;
        for (int32_t f = 0; there && f < from->faces; f++) s->face[s->count.faces++] = all->face[from->face + f];
    }
}

static int draw_moment(picture *p, sp_scene *s, const sp_scene *all, const svg_frame *f, double x, double y, double w, double h)
{
    int good;
    s->vertex = f->vertex;
    p->edges = 0;
    p->mark = f->mark;
    leave_absent(s, all, f->mark);
    if (f->bad) fprintf(p->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#fbeae7\" stroke=\"%s\"/>\n", x - 3,
                        y - 3, w + 6, h + SHEET_CAPTION + 2, color_motion);
    fprintf(p->out, "<svg x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\">\n", x, y, w, h);
    good = find_creases(p) && draw_blocks(p);
    fputs("</svg>\n", p->out);
    label(p->out, x, y + h + 16);
    escaped(p->out, f->caption, sizeof f->caption);
    fputs("</text>\n", p->out);
    free(p->edge);
    free(p->crease);
    free(p->bend);
    return good;
}

/* What the colours say. */
static void legend_marks(const picture *p)
{
    static const char *const word[5] = { NULL, NULL, "new", "to be held", "moves" };
    double x = WIDTH - MARGIN - 240;
    for (int k = SVG_NEW; k <= SVG_FALLS; x += k == SVG_NEW ? 66 : 106, k++) {
        const double *c = color_mark[k];
        fprintf(p->out, "<rect x=\"%.0f\" y=\"29\" width=\"12\" height=\"12\" fill=\"#%02x%02x%02x\" stroke=\"#555\"/>\n", x, (int)c[0],
                (int)c[1], (int)c[2]);
        label(p->out, x + 18, 40);
        fprintf(p->out, "%s</text>\n", word[k]);
    }
}

int svg_sheet(FILE *out, const sp_scene *scene, int frames, const svg_frame *frame, const char *title)
{
    const double w = (WIDTH - 2 * MARGIN - (SHEET_COLUMNS - 1) * SHEET_GAP) / SHEET_COLUMNS;
    double lowest = HUGE_VAL, bottom, height[SHEET_ROWS], y = 62, total = y + SHEET_GAP;
    const int rows = (frames + SHEET_COLUMNS - 1) / SHEET_COLUMNS;
    sp_scene s = *scene;
    picture p;
    int good = frames > 0 && rows <= SHEET_ROWS;

    if (!good) return 0;
    memset(&p, 0, sizeof p);
    s.block = malloc(((size_t)scene->count.blocks + 1) * sizeof *s.block);
    s.face = malloc(((size_t)scene->count.faces + 1) * sizeof *s.face);
    if (!s.block || !s.face) {
        free(s.block);
        free(s.face);
        return 0;
    }
    leave_absent(&s, scene, NULL);
    p.out = out;
    p.s = &s;
    s.vertex = frame[frames - 1].vertex;
    p.v = choose_view(&s);
    for (int32_t k = 0; k < s.count.vertices; k++) lowest = fmin(lowest, (double)frame[0].vertex[k][2]);
    cover_moments(&p, scene, frames, frame, lowest);
    bottom = p.low[1];
    p.size = fmax(fmax(p.high[0] - p.low[0], p.high[1] - p.low[1]), 1e-300);
    p.scale = (w - 2) / fmax(fmax(p.high[0] - p.low[0], 0.6 * (p.high[1] - p.low[1])), 1e-12 * p.size);
    p.left = (w - p.scale * (p.high[0] - p.low[0])) / 2;
    p.top = 1;
    for (int r = 0; r < rows; r++) {                    /* a row is as high as what it shows */
        const int first = r * SHEET_COLUMNS, n = frames - first < SHEET_COLUMNS ? frames - first : SHEET_COLUMNS;
        cover_moments(&p, scene, n, frame + first, lowest);
        height[r] = p.scale * (p.high[1] - bottom) + 2;
        total += height[r] + SHEET_CAPTION + SHEET_GAP;
    }
    page_start(&p, total);
    fprintf(out, "<text x=\"%.0f\" y=\"40\" font-size=\"20\" font-weight=\"bold\" fill=\"#333\">", MARGIN);
    escaped(out, title, 90);
    fputs("</text>\n", out);
    if (frame[0].mark) legend_marks(&p);
    cover_moments(&p, scene, frames, frame, lowest);
    for (int i = 0; i < frames && good; i++) {
        const int r = i / SHEET_COLUMNS;
        if (i % SHEET_COLUMNS == 0) {
            if (r) y += height[r - 1] + SHEET_CAPTION + SHEET_GAP;
            p.high[1] = p.low[1] + (height[r] - 2) / p.scale;
        }
        good = draw_moment(&p, &s, scene, &frame[i], MARGIN + i % SHEET_COLUMNS * (w + SHEET_GAP), y, w, height[r]);
    }
    fputs("</svg>\n", out);
    free(s.block);
    free(s.face);
    return good;
}
