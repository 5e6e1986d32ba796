#include "view.h"

#include <math.h>
#include <string.h>

#define DEGREE (3.14159265358979323846 / 180)

static double dot_real(const double a[3], const sp_real b[3])
{
    return a[0] * (double)b[0] + a[1] * (double)b[1] + a[2] * (double)b[2];
}

double view_length(const sp_real a[3])
{
    return sqrt((double)a[0] * (double)a[0] + (double)a[1] * (double)a[1] + (double)a[2] * (double)a[2]);
}

void view_point(const view *v, const sp_real x[3], double paper[2])
{
    paper[0] = dot_real(v->right, x);
    paper[1] = dot_real(v->up, x);
}

/* n = sum p_k x p_(k+1), about the first corner */
void view_normal(const sp_scene *s, int32_t face, double n[3])
{
    const sp_face *f = &s->face[face];
    const sp_real *o = s->vertex[s->corner[f->corner]];
    n[0] = n[1] = n[2] = 0;
    for (int32_t k = 1; k + 1 < f->corners; k++) {
        double a[3], b[3];
        for (int c = 0; c < 3; c++) {
            a[c] = (double)s->vertex[s->corner[f->corner + k]][c] - (double)o[c];
            b[c] = (double)s->vertex[s->corner[f->corner + k + 1]][c] - (double)o[c];
        }
        n[0] += a[1] * b[2] - a[2] * b[1];
        n[1] += a[2] * b[0] - a[0] * b[2];
        n[2] += a[0] * b[1] - a[1] * b[0];
    }
}

/* --------------------------------------------------------------------------------------------------------- which way is up */

view_axes view_level(const sp_scene *s)
{
    view_axes a;
    int up = 2;
    memset(&a, 0, sizeof a);
    for (int c = 1; c >= 0; c--) if (fabs((double)s->gravity[c]) > fabs((double)s->gravity[up])) up = c;
    a.e[2][up] = s->gravity[up] > 0 ? -1 : 1;
    a.e[0][up == 0 ? 1 : 0] = 1;
    for (int c = 0; c < 3; c++) {                       /* away = up x right */
        const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        a.e[1][c] = a.e[2][c1] * a.e[0][c2] - a.e[2][c2] * a.e[0][c1];
    }
    return a;
}

double view_height(const view_axes *a, const sp_real x[3]) { return dot_real(a->e[2], x); }

/* ---------------------------------------------------------------------------------------------------------- from where */

/* How badly joints are seen from a direction: best from a little above, which shows how the blocks stand on each other. */
static double joints_hidden(const sp_scene *s, const view_axes *axes, const double toward[3])
{
    const double best = 0.35;           /* sine of the angle between joint and view */
    double sum = 0, area = 0;
    for (int32_t i = 0; i < s->count.joints; i++) {
        const sp_joint *c = &s->joint[i];
        const double t = dot_real(toward, c->n);
        sum += fabs((view_height(axes, c->n) < 0 ? -t : t) - best) * (double)c->area;
        area += (double)c->area;
    }
    return area > 0 ? sum / area : 0;
}

/* From `yaw` to the left of the front (0: the second axis goes away from the viewer, 1: the first comes) and `rise` above the
 * horizon. */
static view view_from(const view_axes *axes, int front, double yaw, double rise)
{
    const double f[2] = { front ? 1 : 0, front ? 0 : -1 }, side[2] = { front ? 0 : 1, front ? 1 : 0 };
    view v;
    for (int c = 0; c < 3; c++) {
        v.right[c] = 0;
        v.toward[c] = sin(rise) * axes->e[2][c];
        v.up[c] = cos(rise) * axes->e[2][c];
        for (int k = 0; k < 2; k++) {
            const double level = cos(yaw) * f[k] - sin(yaw) * side[k];
            v.right[c] += (cos(yaw) * side[k] + sin(yaw) * f[k]) * axes->e[k][c];
            v.toward[c] += cos(rise) * level * axes->e[k][c];
            v.up[c] -= sin(rise) * level * axes->e[k][c];
        }
    }
    return v;
}

/* Where the plan is about square, the other side, the front right and directions nearer to square on are tried, too. Thin walls
 * are seen more squarely, towers from lower down. */
static view suit_scene(const sp_scene *s, const view_axes *axes)
{
    double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    double d[3], ratio, yaw, rise;
    view best;

    for (int32_t k = 0; k < s->count.vertices; k++)
        for (int c = 0; c < 3; c++) {
            const double x = dot_real(axes->e[c], s->vertex[k]);
            low[c] = fmin(low[c], x);
            high[c] = fmax(high[c], x);
        }
    for (int c = 0; c < 3; c++) d[c] = fmax(high[c] - low[c], 0);
    ratio = fmin(d[0], d[1]) / fmax(fmax(d[0], d[1]), 1e-300);
    yaw = (18 + 14 * ratio) * DEGREE;
    rise = (d[2] > 2.5 * fmax(d[0], d[1]) ? 14 : 16 + 10 * ratio) * DEGREE;
    best = view_from(axes, d[1] > d[0], yaw, rise);
    for (int k = 1; k < 8 && ratio > 0.5; k++) {
        const int front = k & 1 ? d[1] <= d[0] : d[1] > d[0];
        const view other = view_from(axes, front, (k & 2 ? -yaw : yaw) * (k & 4 ? 0.4 : 1), rise);
        if (joints_hidden(s, axes, other.toward) < 0.9 * joints_hidden(s, axes, best.toward)) best = other;
    }
    return best;
}

view view_choose(const sp_scene *s, const view_wish *wish)
{
    const view_axes axes = view_level(s);
    if (!wish || !wish->given) return suit_scene(s, &axes);
    return view_from(&axes, 0, -wish->azimuth * DEGREE, wish->rise * DEGREE);
}
