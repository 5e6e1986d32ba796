/* The simulation meets some points of a contact; here it gets its outline: of all points where two stones are within the gap,
 * those farthest in eight directions of its plane. */
#include "touch.h"
#include "pieces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void turn(const double R[9], const double x[3], double out[3])
{
    for (int c = 0; c < 3; c++) out[c] = dot(R + 3 * c, x);
}

/* x' = R (x - c) + t */
static void place(const settle_pose *p, const double x[3], double out[3])
{
    const double d[3] = { x[0] - p->c[0], x[1] - p->c[1], x[2] - p->c[2] };
    turn(p->R, d, out);
    for (int c = 0; c < 3; c++) out[c] += p->t[c];
}

/* By (a, b), then as they were met. */
static int by_bodies(const void *pa, const void *pb)
{
    const bullet_touch *a = pa, *b = pb;
    const int32_t x[4] = { a->a, a->b, a->pair, a->point }, y[4] = { b->a, b->b, b->pair, b->point };
    int k = 0;
    while (k < 3 && x[k] == y[k]) k++;
    return (x[k] > y[k]) - (x[k] < y[k]);
}

static void add_point(settle_contact *c, const bullet_touch *t)
{
    memcpy(c->point[c->points++], t->x, sizeof t->x);
    c->depth = fmax(c->depth, t->depth);
}

/* The points of two bodies, one contact for those whose normals agree within a degree. */
static int32_t group(const bullet_touch *touch, int32_t touches, double gap, settle_contact *contact)
{
    int32_t n = 0, first = 0;
    for (int32_t i = 0; i < touches; i++) {
        const bullet_touch *t = &touch[i];
        int32_t k;
        if (i == 0 || t->pair != touch[i - 1].pair) first = n;
        if (t->depth < -gap) continue;
        for (k = first; k < n && dot(contact[k].n, t->n) < cos(pi / 180); k++) {}
        if (k == n) {
            memset(&contact[n], 0, sizeof contact[n]);
            contact[n].a = t->a;
            contact[n].b = t->b;
            memcpy(contact[n].n, t->n, sizeof t->n);
            contact[n++].depth = -HUGE_VAL;
        }
        add_point(&contact[k], t);
    }
    return n;
}

/* A piece where it is, moved by `shift`. */
static int put(const settle_mesh *m, const settle_pose *at, const double shift[3], pieces_solid *out)
{
    if (!pieces_mesh(out, m)) return 0;
    for (int32_t k = 0; k < out->corners; k++) {
        const double x[3] = { out->xyz[k][0], out->xyz[k][1], out->xyz[k][2] };
        place(at, x, out->xyz[k]);
        for (int c = 0; c < 3; c++) out->xyz[k][c] += shift[c];
    }
    return 1;
}

/* The part of piece `a`, moved by the gap along n, that lies in piece `b`: its corners outline where they are that near. */
static int overlap(const settle_mesh *a, const settle_pose *at_a, const settle_mesh *b, const settle_pose *at_b, const double shift[3],
                   pieces_solid *out)
{
    pieces_solid next = { 0, 0, 0, 0, NULL, NULL };
    pieces_plane *side;
    int32_t sides;
    double origin[3];
    int good = pieces_planes(b, &side, &sides) && put(a, at_a, shift, out);
    place(at_b, (const double[3]){ 0, 0, 0 }, origin);
    for (int32_t k = 0; k < sides && good && out->faces > 0; k++) {
        const pieces_solid swap = *out;
        double n[3];
        turn(at_b->R, side[k].n, n);
        good = pieces_clip(out, n, side[k].d + dot(n, origin), 1e-9 * side[k].width, &next);
        *out = next;
        next = swap;
    }
    pieces_free(&next);
    free(side);
    return good;
}

/* Points of the plane of c where bodies a and b are within the gap, added to `near` as polygons of one corner. */
static int add_near(const touch_place *at, int32_t a, int32_t b, double gap, const settle_contact *c, pieces_solid *near)
{
    const double shift[3] = { gap * c->n[0], gap * c->n[1], gap * c->n[2] };
    int good = 1;
    for (int32_t i = 0; i < at->stone[a]->pieces; i++)
        for (int32_t j = 0; j < at->stone[b]->pieces && good; j++) {
            pieces_solid s = { 0, 0, 0, 0, NULL, NULL };
            good = overlap(&at->stone[a]->piece[i], &at->pose[a], &at->stone[b]->piece[j], &at->pose[b], shift, &s);
            for (int32_t k = 0; k < s.corners && good; k++) {
                const double h = dot(c->n, s.xyz[k]) - dot(c->n, c->point[0]);
                double x[1][3];
                for (int d = 0; d < 3; d++) x[0][d] = s.xyz[k][d] - h * c->n[d];
                if (fabs(h) <= 2 * gap) good = pieces_add(near, 1, (const double (*)[3])x);
            }
            pieces_free(&s);
        }
    return good;
}

/* Of `near` those farthest in eight directions become the points of c, but none within the gap of another. */
static void keep_farthest(const pieces_solid *near, double gap, settle_contact *c)
{
    double u[3], v[3];
    pieces_axes(c->n, u, v);
    c->points = 0;
    for (int k = 0; k < SETTLE_POINTS; k++) {
        const double x = cos(2 * pi * k / SETTLE_POINTS), y = sin(2 * pi * k / SETTLE_POINTS);
        const double way[3] = { x * u[0] + y * v[0], x * u[1] + y * v[1], x * u[2] + y * v[2] };
        int32_t best = 0;
        int fresh = 1;
        for (int32_t i = 1; i < near->corners; i++)
            if (dot(way, near->xyz[i]) > dot(way, near->xyz[best])) best = i;
        for (int32_t i = 0; i < c->points; i++) {
            double d[3];
            for (int e = 0; e < 3; e++) d[e] = c->point[i][e] - near->xyz[best][e];
            fresh = fresh && sqrt(dot(d, d)) > gap;
        }
        if (fresh) memcpy(c->point[c->points++], near->xyz[best], sizeof c->point[0]);
    }
}

static int outline(const touch_place *at, double gap, settle_contact *c)
{
    const int32_t first = c->a < 0 ? at->stones : c->a, end = c->a < 0 ? at->bodies : c->a + 1;
    pieces_solid near = { 0, 0, 0, 0, NULL, NULL };
    int good = 1;
    for (int32_t k = 0; k < c->points && good; k++) good = pieces_add(&near, 1, (const double (*)[3])&c->point[k]);
    for (int32_t a = first; a < end && good; a++) good = add_near(at, a, c->b, gap, c, &near);
    if (good) keep_farthest(&near, gap, c);
    pieces_free(&near);
    return good;
}

int touch_contacts(const touch_place *at, bullet_touch *touch, int32_t touches, double gap, settle_contact *contact,
                   int32_t *contacts)
{
    int good = 1;
    qsort(touch, (size_t)touches, sizeof *touch, by_bodies);
    *contacts = group(touch, touches, gap, contact);
    for (int32_t k = 0; k < *contacts && good; k++) good = outline(at, gap, &contact[k]);
    return good;
}
