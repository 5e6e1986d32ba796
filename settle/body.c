/* Stones as bodies: volume, centroid and covariance; hulls shrunk by the margin that Bullet adds again. */
#include "body.h"
#include "pieces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static settle_status check_mesh(const settle_mesh *m)
{
    size_t corners = 0;
    if (!m->xyz || !m->size || !m->corner || m->vertices < 4 || m->faces < 4) return SETTLE_E_MESH;
    if (!pieces_finite(m->xyz, 3 * (size_t)m->vertices)) return SETTLE_E_NUMBER;
    for (int32_t f = 0; f < m->faces; f++) {
        if (m->size[f] < 3) return SETTLE_E_MESH;
        for (int32_t k = 0; k < m->size[f]; k++, corners++)
            if (m->corner[corners] < 0 || m->corner[corners] >= m->vertices) return SETTLE_E_MESH;
    }
    return SETTLE_OK;
}

static settle_status check_stone(const settle_stone *s)
{
    settle_status status = SETTLE_OK;
    if (s->pieces < 1 || !s->piece) return SETTLE_E_ARGUMENT;
    if (s->pieces > SETTLE_PIECES) return SETTLE_E_PIECES;
    if (!pieces_finite(&s->mass, 1)) return SETTLE_E_NUMBER;
    if (!s->fixed && !(s->mass > 0)) return SETTLE_E_ARGUMENT;
    for (int32_t p = 0; p < s->pieces && !status; p++) status = check_mesh(&s->piece[p]);
    return status;
}

/* Volume, first and second moments of tetrahedra (0, a, b, c) from an origin near the mesh:
 *   V = D/6,  S = D/24 (a + b + c),  T = D/120 (aa' + bb' + cc' + (a+b+c)(a+b+c)')                         [D = a.(b x c)] */
typedef struct integrals { double v, s[3], t[3][3]; } integrals;

static void add_tetrahedron(integrals *i, const double q[3][3])
{
    double sum[3];
    const double det = q[0][0] * (q[1][1] * q[2][2] - q[1][2] * q[2][1]) + q[0][1] * (q[1][2] * q[2][0] - q[1][0] * q[2][2])
                     + q[0][2] * (q[1][0] * q[2][1] - q[1][1] * q[2][0]);
    for (int c = 0; c < 3; c++) sum[c] = q[0][c] + q[1][c] + q[2][c];
    i->v += det / 6;
    for (int c = 0; c < 3; c++) {
        i->s[c] += det / 24 * sum[c];
        for (int d = 0; d < 3; d++)
            i->t[c][d] += det / 120 * (q[0][c] * q[0][d] + q[1][c] * q[1][d] + q[2][c] * q[2][d] + sum[c] * sum[d]);
    }
}

static void add_mesh(integrals *sum, const settle_mesh *m, const double origin[3])
{
    const int32_t *corner = m->corner;
    for (int32_t f = 0; f < m->faces; corner += m->size[f++])
        for (int32_t k = 1; k + 1 < m->size[f]; k++) {
            double q[3][3];
            for (int i = 0; i < 3; i++)
                for (int c = 0; c < 3; c++) q[i][c] = m->xyz[3 * (size_t)corner[i ? k + i - 1 : 0] + (size_t)c] - origin[c];
            add_tetrahedron(sum, (const double (*)[3])q);
        }
}

/* The centroid S/V, and T/V - S S'/V^2 about it. */
static settle_status mass_of(const settle_stone *s, bullet_body *b)
{
    integrals i;
    memset(&i, 0, sizeof i);
    for (int32_t p = 0; p < s->pieces; p++) add_mesh(&i, &s->piece[p], s->piece[0].xyz);
    if (!(i.v > 0)) return SETTLE_E_MESH;
    for (int c = 0; c < 3; c++) b->centroid[c] = s->piece[0].xyz[c] + i.s[c] / i.v;
    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++) b->covariance[c][d] = i.t[c][d] / i.v - i.s[c] / i.v * (i.s[d] / i.v);
    return SETTLE_OK;
}

/* Largest side of the box around a mesh. */
static double box_of(const settle_mesh *m, double low[3], double high[3])
{
    double size = 0;
    for (int c = 0; c < 3; c++) low[c] = HUGE_VAL, high[c] = -HUGE_VAL;
    for (int32_t k = 0; k < m->vertices; k++)
        for (int c = 0; c < 3; c++) {
            low[c] = fmin(low[c], m->xyz[3 * (size_t)k + (size_t)c]);
            high[c] = fmax(high[c], m->xyz[3 * (size_t)k + (size_t)c]);
        }
    for (int c = 0; c < 3; c++) size = fmax(size, high[c] - low[c]);
    return size;
}

/* The corners of a solid, each once. */
static int corners_of(const pieces_solid *s, double apart, bullet_hull *out)
{
    out->xyz = malloc(((size_t)s->corners + 1) * sizeof *out->xyz);
    if (!out->xyz) return 0;
    for (int32_t k = 0; k < s->corners; k++) {
        int fresh = 1;
        for (int32_t i = 0; fresh && i < out->points; i++) {
            double d[3];
            for (int c = 0; c < 3; c++) d[c] = s->xyz[k][c] - out->xyz[i][c];
            fresh = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) > apart;
        }
        if (fresh) memcpy(out->xyz[out->points++], s->xyz[k], sizeof *out->xyz);
    }
    return 1;
}

/* The corners of the piece with all faces moved in by the margin, which becomes smaller where the piece is thin.
 *                                                                                          returns 0: out of memory */
static int shrink(const settle_mesh *m, double margin, bullet_hull *out)
{
    double low[3], high[3];
    const double size = box_of(m, low, high);
    pieces_solid now = { 0, 0, 0, 0, NULL, NULL }, next = now;
    pieces_plane *side;
    int32_t sides;
    int good = pieces_planes(m, &side, &sides);

    for (int32_t k = 0; k < sides; k++) margin = fmin(margin, 0.2 * side[k].width);
    if (!(margin > 1e-6 * size)) margin = 1e-6 * size;
    for (int c = 0; c < 3; c++) low[c] -= size, high[c] += size;
    good = good && pieces_box(&now, low, high);
    for (int32_t k = 0; k < sides && good; k++) {
        const pieces_solid swap = now;
        good = pieces_clip(&now, side[k].n, side[k].d - margin, 1e-9 * size, &next);
        now = next;
        next = swap;
    }
    out->margin = margin;
    good = good && corners_of(&now, 1e-7 * size, out);
    pieces_free(&now);
    pieces_free(&next);
    free(side);
    return good;
}

static double radius_of(const settle_stone *s, const double centre[3])
{
    double most = 0;
    for (int32_t p = 0; p < s->pieces; p++)
        for (int32_t k = 0; k < s->piece[p].vertices; k++) {
            const double *x = s->piece[p].xyz + 3 * (size_t)k, d[3] = { x[0] - centre[0], x[1] - centre[1], x[2] - centre[2] };
            most = fmax(most, sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
        }
    return most;
}

settle_status body_make(const settle_stone *stone, int32_t id, const settle_settings *set, bullet_body *body, double *radius)
{
    const double *g = set->gravity, size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    bullet_hull *hull;
    settle_status status;

    memset(body, 0, sizeof *body);
    status = check_stone(stone);
    if (!status) status = mass_of(stone, body);
    if (status) return status;
    body->id = id;
    body->fixed = stone->fixed != 0;
    body->mass = fmax(stone->mass, set->mass_floor);
    body->restitution = set->restitution;
    body->damping = set->damping;
    for (int c = 0; c < 3 && !body->fixed && size > 0; c++) body->lift[c] = -(g[c] * (set->lift / size));
    *radius = radius_of(stone, body->centroid);
    body->hull = hull = calloc((size_t)stone->pieces, sizeof *hull);
    if (!hull) return SETTLE_E_MEMORY;
    for (; body->hulls < stone->pieces; body->hulls++) {
        if (!shrink(&stone->piece[body->hulls], set->margin, &hull[body->hulls])) return SETTLE_E_MEMORY;
        if (hull[body->hulls].points < 4) status = SETTLE_E_MESH;
    }
    return status;
}

void body_free(bullet_body *body)
{
    for (int32_t k = 0; k < body->hulls; k++) free(body->hull[k].xyz);
    free((void *)(uintptr_t)body->hull);
}
