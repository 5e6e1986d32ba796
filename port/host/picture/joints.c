#include "joints.h"
#include "page.h"
#include "seen.h"

#include <math.h>

static void put_polygon(const drawing *d, const sp_joint *c)
{
    for (int32_t k = 0; k < c->points; k++) {
        double at[2];
        drawing_point(d, d->s->point[c->point + k], at);
        fprintf(d->out, "%s%.1f %.1f", k ? "L" : "M", at[0], at[1]);
    }
    fputs(c->points > 2 ? "Z\"/>\n" : "\"/>\n", d->out);
}

#define RING 17.0                       /* radius [px] */

double joints_ring(const drawing *d, const sp_joint *c, double middle[2])
{
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL }, at[2];
    for (int32_t k = 0; k < c->points; k++) {
        drawing_point(d, d->s->point[c->point + k], at);
        for (int i = 0; i < 2; i++) {
            low[i] = fmin(low[i], at[i]);
            high[i] = fmax(high[i], at[i]);
        }
    }
    for (int i = 0; i < 2; i++) middle[i] = (low[i] + high[i]) / 2;
    return high[0] - low[0] + high[1] - low[1] < 40 ? RING : 0;
}

static void draw_ring(const drawing *d, const sp_joint *c)
{
    double at[2];
    const double r = joints_ring(d, c, at);
    for (int halo = 1; r > 0 && halo >= 0; halo--)
        fprintf(d->out, "<circle class=\"ring\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.0f\" fill=\"none\" stroke=\"%s\" "
                "stroke-width=\"%s\"/>\n", at[0], at[1], r, halo ? "#fff" : INK_WEAK, halo ? "6" : "3");
}

int joints_draw_weakest(const drawing *d, int32_t weakest, int *behind)
{
    const sp_joint *c = &d->s->joint[weakest < 0 ? 0 : weakest];
    seen look;
    int good;
    *behind = 0;
    if (weakest < 0) return 1;
    good = seen_begin(&look, d);
    if (good) *behind = !seen_joint(&look, c);
    seen_end(&look);
    draw_ring(d, c);
    fprintf(d->out, "<path fill=\"%s\" fill-opacity=\"%s\" stroke=\"%s\" stroke-width=\"2.4\" stroke-linejoin=\"round\"%s d=\"",
            INK_WEAK, *behind ? "0.15" : "0.35", INK_WEAK, *behind ? " stroke-dasharray=\"5 3\"" : "");
    put_polygon(d, c);
    for (int32_t k = 0; k < c->points && c->points < 3; k++) {
        double at[2];
        drawing_point(d, d->s->point[c->point + k], at);
        fprintf(d->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", at[0], at[1], INK_WEAK);
    }
    return good;
}

#define SHORT 10.0                      /* [px] */

/* A line, or the disc at its end; among many not of short ones. */
static void draw_hinge(const drawing *d, const sp_joint_motion *m, int disc)
{
    double a[2], b[2];
    drawing_point(d, m->a, a);
    drawing_point(d, m->b, b);
    if (!disc) fprintf(d->out, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"4\" stroke-linecap=\"round\"/>\n",
                       a[0], a[1], b[0], b[1], INK_HINGE);
    else if (d->s->count.joints < 400 || hypot(b[0] - a[0], b[1] - a[1]) > SHORT)
        fprintf(d->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"#fff\" stroke=\"%s\" stroke-width=\"2\"/>\n",
                a[0], a[1], INK_HINGE);
}

void joints_draw_mechanism(const drawing *d, const sp_real *dq, int32_t *hinges, int32_t *slides)
{
    for (int32_t i = 0; i < d->s->count.joints; i++) {
        sp_joint_motion m;
        if (sp_joint_moves(d->s, dq, i, &m) != SP_OK) continue;
        if (m.kind == SP_JOINT_HINGE) {
            ++*hinges;
            draw_hinge(d, &m, 0);
        }
        if (m.kind != SP_JOINT_SLIDING) continue;
        ++*slides;
        fprintf(d->out, "<path fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" stroke-width=\"2\" d=\"", INK_SLIDE, INK_SLIDE);
        put_polygon(d, &d->s->joint[i]);
    }
    for (int32_t i = 0; i < d->s->count.joints; i++) {          /* no line over a disc */
        sp_joint_motion m;
        if (sp_joint_moves(d->s, dq, i, &m) == SP_OK && m.kind == SP_JOINT_HINGE) draw_hinge(d, &m, 1);
    }
}
