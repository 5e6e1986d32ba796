/* Painter's order of faces.
 *
 * Face p must be painted before q where they overlap on paper and p lies deeper there. Plane faces that do not cut through
 * each other have one answer over their whole overlap, so its centroid decides. Concave faces are cut into triangles first.
 * The order is then a depth-first walk along "must come before", started from the deepest face; a cycle, which stones
 * rarely make, is cut where the walk meets itself.
 */
#include "hidden.h"

#include <math.h>
#include <stdlib.h>

enum { CLIP_MAX = 64 };                 /* corners of a clipped piece; larger convex pieces are cut into triangles too */

typedef struct piece {                  /* convex, anticlockwise on paper */
    int32_t sheet, first, corners;      /* its face among the seen ones; its part of paint.at */
    double low[2], high[2], area;
} piece;

typedef struct sheet {                  /* a seen face: depth = d[0] x + d[1] y + d[2] on paper */
    int32_t face;
    double d[3], mean;
} sheet;

typedef struct before { int32_t first, then; } before;

typedef struct paint {
    sheet *sheet;
    piece *piece;
    double (*at)[2];
    before *rule;
    int32_t sheets, pieces, ats, rules, room;
    double size;                        /* of the scene on paper */
} paint;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* -------------------------------------------------------------------------------------------------------------- pieces */

/* Twice the area of the triangle a b c, positive anticlockwise. */
static double area_twice(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static void add_piece(paint *p, int32_t sheet_id, int32_t first, int32_t corners)
{
    piece *q = &p->piece[p->pieces];
    q->sheet = sheet_id;
    q->first = first;
    q->corners = corners;
    q->area = 0;
    for (int c = 0; c < 2; c++) q->low[c] = q->high[c] = p->at[first][c];
    for (int32_t k = 0; k < corners; k++)
        for (int c = 0; c < 2; c++) {
            q->low[c] = fmin(q->low[c], p->at[first + k][c]);
            q->high[c] = fmax(q->high[c], p->at[first + k][c]);
        }
    for (int32_t k = 1; k + 1 < corners; k++) q->area += area_twice(p->at[first], p->at[first + k], p->at[first + k + 1]) / 2;
    if (q->area > 1e-12 * p->size * p->size) p->pieces++;
}

static int is_convex(const double (*at)[2], int32_t n, double tiny)
{
    for (int32_t k = 0; k < n; k++)
        if (area_twice(at[k], at[(k + 1) % n], at[(k + 2) % n]) < -tiny) return 0;
    return 1;
}

/* Is corner k of the polygon left[0..n) an ear: turning left, with no other corner inside? */
static int is_ear(const double (*at)[2], const int32_t *left, int32_t n, int32_t k)
{
    const double *a = at[left[(k + n - 1) % n]], *b = at[left[k]], *c = at[left[(k + 1) % n]];
    if (area_twice(a, b, c) <= 0) return 0;
    for (int32_t i = 0; i < n - 3; i++) {
        const double *x = at[left[(k + 2 + i) % n]];
        if (area_twice(a, b, x) > 0 && area_twice(b, c, x) > 0 && area_twice(c, a, x) > 0) return 0;
    }
    return 1;
}

/* Cut a concave polygon into triangles [ear clipping]; where no ear is left (it crosses itself) any corner goes. */
static int add_ears(paint *p, int32_t sheet_id, int32_t first, int32_t n)
{
    int32_t *left = malloc((size_t)n * sizeof *left);
    if (!left) return 0;
    for (int32_t k = 0; k < n; k++) left[k] = first + k;
    while (n >= 3) {
        int32_t k = 0;
        while (k < n && !is_ear((const double (*)[2])p->at, left, n, k)) k++;
        if (k == n) k = 0;
        for (int i = 0; i < 3; i++) {
            const double *x = p->at[left[(k + n - 1 + i) % n]];
            p->at[p->ats + i][0] = x[0];
            p->at[p->ats + i][1] = x[1];
        }
        add_piece(p, sheet_id, p->ats, 3);
        p->ats += 3;
        for (n--; k < n; k++) left[k] = left[k + 1];
    }
    free(left);
    return 1;
}

/* Depth over paper of the face's mean plane: n . x = n . m, x = X right + Y up + Z toward. */
static void find_plane(sheet *h, const view *v, const double n[3], const double mean[3])
{
    const double t = dot(n, v->toward);
    h->d[0] = -dot(n, v->right) / t;
    h->d[1] = -dot(n, v->up) / t;
    h->d[2] = dot(n, mean) / t;
    h->mean = dot(mean, v->toward);
}

static int add_face(paint *p, const sp_scene *s, const view *v, int32_t face)
{
    const sp_face *f = &s->face[face];
    const int32_t first = p->ats, n = f->corners;
    double normal[3], mean[3] = { 0, 0, 0 };

    view_normal(s, face, normal);
    if (!(dot(normal, v->toward) > 1e-3 * sqrt(dot(normal, normal)))) return 1;     /* away, or edge on */
    for (int32_t k = 0; k < n; k++) {
        const sp_real *x = s->vertex[s->corner[f->corner + k]];
        view_point(v, x, p->at[p->ats++]);
        for (int c = 0; c < 3; c++) mean[c] += (double)x[c] / n;
    }
    p->sheet[p->sheets].face = face;
    find_plane(&p->sheet[p->sheets], v, normal, mean);
    p->sheets++;
    if (n <= CLIP_MAX / 2 && is_convex((const double (*)[2])p->at + first, n, 1e-9 * p->size * p->size))
        add_piece(p, p->sheets - 1, first, n);
    else return add_ears(p, p->sheets - 1, first, n);
    return 1;
}

/* --------------------------------------------------------------------------------------------------------------- pairs */

/* The part of polygon a[0..n) left of the line p q.                                                 [Sutherland, Hodgman] */
static int clip_line(double (*a)[2], int n, const double p[2], const double q[2])
{
    double out[CLIP_MAX][2];
    int m = 0;
    for (int k = 0; k < n && m + 2 < CLIP_MAX; k++) {
        const double *x = a[k], *y = a[(k + 1) % n], dx = area_twice(p, q, x), dy = area_twice(p, q, y);
        if (dx >= 0) { out[m][0] = x[0]; out[m++][1] = x[1]; }
        if ((dx > 0 && dy < 0) || (dx < 0 && dy > 0)) {
            const double t = dx / (dx - dy);
            out[m][0] = x[0] + t * (y[0] - x[0]);
            out[m++][1] = x[1] + t * (y[1] - x[1]);
        }
    }
    for (int k = 0; k < m; k++) { a[k][0] = out[k][0]; a[k][1] = out[k][1]; }
    return m;
}

/* Centroid of what two pieces have in common; its area. */
static double overlap_of(const paint *p, const piece *a, const piece *b, double c[2])
{
    double x[CLIP_MAX][2], area = 0;
    int n = (int)a->corners;
    for (int k = 0; k < n; k++) { x[k][0] = p->at[a->first + k][0]; x[k][1] = p->at[a->first + k][1]; }
    for (int32_t k = 0; k < b->corners && n >= 3; k++)
        n = clip_line(x, n, p->at[b->first + k], p->at[b->first + (k + 1) % b->corners]);
    c[0] = c[1] = 0;
    for (int k = 1; k + 1 < n; k++) {
        const double t = area_twice(x[0], x[k], x[k + 1]) / 2;
        area += t;
        for (int i = 0; i < 2; i++) c[i] += t * (x[0][i] + x[k][i] + x[k + 1][i]) / 3;
    }
    if (area > 0) { c[0] /= area; c[1] /= area; }
    return area;
}

static int add_rule(paint *p, int32_t first, int32_t then)
{
    if (p->rules == p->room) {
        const int32_t room = p->room ? 2 * p->room : 1024;
        before *more = room > p->room ? realloc(p->rule, (size_t)room * sizeof *more) : NULL;
        if (!more) return 0;
        p->rule = more;
        p->room = room;
    }
    p->rule[p->rules].first = first;
    p->rule[p->rules++].then = then;
    return 1;
}

static double depth_at(const sheet *h, const double c[2]) { return h->d[0] * c[0] + h->d[1] * c[1] + h->d[2]; }

static int compare_pieces(paint *p, const piece *a, const piece *b)
{
    double c[2], d;
    if (a->sheet == b->sheet || a->low[0] >= b->high[0] || b->low[0] >= a->high[0] || a->low[1] >= b->high[1]
        || b->low[1] >= a->high[1])
        return 1;
    if (overlap_of(p, a, b, c) < 1e-6 * fmin(a->area, b->area)) return 1;       /* they only share an edge */
    d = depth_at(&p->sheet[a->sheet], c) - depth_at(&p->sheet[b->sheet], c);
    if (fabs(d) < 1e-7 * p->size) return 1;                                 /* one plane */
    return d < 0 ? add_rule(p, a->sheet, b->sheet) : add_rule(p, b->sheet, a->sheet);
}

/* Pieces by cells of a grid over the paper, so that only near ones are compared. */
typedef struct grid {
    int32_t n, *start, *item;           /* n x n cells */
    double low[2], cell[2];
} grid;

static int32_t cell_of(const grid *g, double x, int axis)
{
    const double k = floor((x - g->low[axis]) / g->cell[axis]);
    return k < 0 ? 0 : k > g->n - 1 ? g->n - 1 : (int32_t)k;
}

/* For each cell a piece touches: count it, or put it there. */
static void touch_cells(grid *g, const piece *q, int32_t id)
{
    const int32_t x1 = cell_of(g, q->high[0], 0), y1 = cell_of(g, q->high[1], 1);
    for (int32_t y = cell_of(g, q->low[1], 1); y <= y1; y++)
        for (int32_t x = cell_of(g, q->low[0], 0); x <= x1; x++) {
            if (id < 0) g->start[y * g->n + x + 1]++;
            else g->item[g->start[y * g->n + x]++] = id;
        }
}

/* Cells that all pieces touch together. */
static double count_touched(const paint *p, const grid *g)
{
    double sum = 0;
    for (int32_t k = 0; k < p->pieces; k++) {
        const piece *q = &p->piece[k];
        sum += (1.0 + cell_of(g, q->high[0], 0) - cell_of(g, q->low[0], 0))
             * (1.0 + cell_of(g, q->high[1], 1) - cell_of(g, q->low[1], 1));
    }
    return sum;
}

/* About as many cells as pieces; fewer where pieces are so large that the lists would run away. */
static void grid_choose(const paint *p, grid *g)
{
    double high[2] = { -HUGE_VAL, -HUGE_VAL };
    g->low[0] = g->low[1] = HUGE_VAL;
    for (int32_t k = 0; k < p->pieces; k++)
        for (int c = 0; c < 2; c++) {
            g->low[c] = fmin(g->low[c], p->piece[k].low[c]);
            high[c] = fmax(high[c], p->piece[k].high[c]);
        }
    g->n = 2 + 2 * (int32_t)sqrt((double)(p->pieces < 250000 ? p->pieces : 250000));
    do {
        g->n /= 2;
        for (int c = 0; c < 2; c++) g->cell[c] = high[c] > g->low[c] ? (high[c] - g->low[c]) / g->n : 1;
    } while (g->n > 1 && count_touched(p, g) > 64.0 * p->pieces);
}

static int grid_make(const paint *p, grid *g)
{
    int32_t cells, k;

    grid_choose(p, g);
    cells = g->n * g->n;
    g->start = calloc((size_t)cells + 2, sizeof *g->start);
    if (!g->start) return 0;
    for (k = 0; k < p->pieces; k++) touch_cells(g, &p->piece[k], -1);
    for (k = 0; k < cells; k++) g->start[k + 1] += g->start[k];
    g->item = malloc(((size_t)g->start[cells] + 1) * sizeof *g->item);
    if (!g->item) return 0;
    for (k = 0; k < p->pieces; k++) touch_cells(g, &p->piece[k], k);         /* start[k] moves to the end of cell k */
    for (k = cells; k > 0; k--) g->start[k] = g->start[k - 1];
    g->start[0] = 0;
    return 1;
}

/* A pair that shares several cells is compared in the first of them. */
static int compare_cell(paint *p, const grid *g, int32_t cell)
{
    for (int32_t i = g->start[cell]; i < g->start[cell + 1]; i++)
        for (int32_t k = i + 1; k < g->start[cell + 1]; k++) {
            const piece *a = &p->piece[g->item[i]], *b = &p->piece[g->item[k]];
            if (cell_of(g, fmax(a->low[1], b->low[1]), 1) * g->n + cell_of(g, fmax(a->low[0], b->low[0]), 0) != cell) continue;
            if (!compare_pieces(p, a, b)) return 0;
        }
    return 1;
}

static int compare_all(paint *p)
{
    grid g = { 0, NULL, NULL, { 0, 0 }, { 0, 0 } };
    int good = grid_make(p, &g);
    for (int32_t cell = 0; good && cell < g.n * g.n; cell++) good = compare_cell(p, &g, cell);
    free(g.start);
    free(g.item);
    return good;
}

/* --------------------------------------------------------------------------------------------------------------- order */

static int deeper(const void *pa, const void *pb)
{
    const sheet *a = pa, *b = pb;
    if (a->mean < b->mean || a->mean > b->mean) return a->mean < b->mean ? -1 : 1;
    return (a->face > b->face) - (a->face < b->face);
}

typedef struct walk {
    int32_t *start, *first;             /* what must come before sheet k: first[start[k] .. start[k + 1]) */
    int32_t *at, *stack;                /* next of them to look at; the path */
    int32_t *order, count;
} walk;

/* Put everything before sheet k into the order, then k. */
static void walk_from(walk *w, int32_t k)
{
    int32_t top = 0;
    if (w->at[k] >= 0) return;
    w->stack[top++] = k;
    w->at[k] = w->start[k];
    while (top > 0) {
        const int32_t here = w->stack[top - 1];
        if (w->at[here] == w->start[here + 1]) {
            w->order[w->count++] = here;
            top--;
        } else {
            const int32_t next = w->first[w->at[here]++];
            if (w->at[next] >= 0) continue;             /* done, or on the path: a cycle */
            w->at[next] = w->start[next];
            w->stack[top++] = next;
        }
    }
}

static int walk_make(const paint *p, walk *w)
{
    const size_t n = (size_t)p->sheets;
    w->start = calloc(n + 2, sizeof *w->start);
    w->first = malloc(((size_t)p->rules + 1) * sizeof *w->first);
    w->at = malloc((n + 1) * sizeof *w->at);
    w->stack = malloc((n + 1) * sizeof *w->stack);
    w->order = malloc((n + 1) * sizeof *w->order);
    if (!w->start || !w->first || !w->at || !w->stack || !w->order) return 0;
    for (int32_t k = 0; k < p->rules; k++) w->start[p->rule[k].then + 2]++;
    for (size_t k = 2; k < n + 2; k++) w->start[k] += w->start[k - 1];
    for (int32_t k = 0; k < p->rules; k++) w->first[w->start[p->rule[k].then + 1]++] = p->rule[k].first;
    for (size_t k = 0; k < n; k++) w->at[k] = -1;
    return 1;
}

static int32_t sort_faces(paint *p, int32_t **order)
{
    walk w = { NULL, NULL, NULL, NULL, NULL, 0 };
    const int good = walk_make(p, &w);
    if (good) {
        for (int32_t k = 0; k < p->sheets; k++) walk_from(&w, k);           /* sheets stand deepest first */
        for (int32_t k = 0; k < w.count; k++) w.order[k] = p->sheet[w.order[k]].face;
    } else {
        free(w.order);
        w.order = NULL;
    }
    *order = w.order;
    free(w.start);
    free(w.first);
    free(w.at);
    free(w.stack);
    return good ? w.count : -1;
}

/* Sheets deepest first, pieces following them. */
static int sort_sheets(paint *p)
{
    int32_t *place = malloc(((size_t)p->sheets + 1) * sizeof *place), *by_face;
    int32_t most = 0;
    for (int32_t k = 0; k < p->sheets; k++) most = p->sheet[k].face > most ? p->sheet[k].face : most;
    by_face = malloc(((size_t)most + 1) * sizeof *by_face);
    if (place && by_face) {
        for (int32_t k = 0; k < p->sheets; k++) place[k] = p->sheet[k].face;
        qsort(p->sheet, (size_t)p->sheets, sizeof *p->sheet, deeper);
        for (int32_t k = 0; k < p->sheets; k++) by_face[p->sheet[k].face] = k;
        for (int32_t k = 0; k < p->pieces; k++) p->piece[k].sheet = by_face[place[p->piece[k].sheet]];
    }
    most = place && by_face;
    free(place);
    free(by_face);
    return most;
}

int32_t hidden_order(const sp_scene *s, const view *v, int32_t **order)
{
    const size_t faces = (size_t)s->count.faces, corners = (size_t)s->count.corners;
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    paint p = { NULL, NULL, NULL, NULL, 0, 0, 0, 0, 0, 0 };
    int32_t count = -1;
    int good;

    for (int32_t k = 0; k < s->count.vertices; k++) {
        double x[2];
        view_point(v, s->vertex[k], x);
        for (int c = 0; c < 2; c++) { low[c] = fmin(low[c], x[c]); high[c] = fmax(high[c], x[c]); }
    }
    p.size = fmax(high[0] - low[0], high[1] - low[1]);
    p.sheet = malloc((faces + 1) * sizeof *p.sheet);
    p.piece = malloc((corners + 1) * sizeof *p.piece);          /* a polygon of n corners gives n - 2 triangles at most */
    p.at = malloc((4 * corners + 1) * sizeof *p.at);
    good = p.sheet && p.piece && p.at;
    for (int32_t f = 0; good && f < s->count.faces; f++) good = add_face(&p, s, v, f);
    if (good && sort_sheets(&p) && compare_all(&p)) count = sort_faces(&p, order);
    free(p.sheet);
    free(p.piece);
    free(p.at);
    free(p.rule);
    return count;
}
