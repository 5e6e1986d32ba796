#include "turn.h"
#include "../motion.h"
#include "../weakest.h"
#include "page.h"
#include "scales.h"
#include "turn_script.h"

#include <math.h>
#include <string.h>

static void put_point(FILE *out, const sp_real x[3], int first)
{
    fprintf(out, "%s[%.7g,%.7g,%.7g]", first ? "" : ",", (double)x[0], (double)x[1], (double)x[2]);
}

static void put_points(FILE *out, const char *key, sp_real (*x)[3], int32_t n)
{
    fprintf(out, "\"%s\":[", key);
    for (int32_t k = 0; k < n; k++) put_point(out, x[k], k == 0);
    fputs("],\n", out);
}

/* Of each block: its first vertex, how many, is it fixed, does it move. */
static void put_blocks(FILE *out, const subject *of, int motion)
{
    const sp_scene *s = &of->scene->scene;
    fputs("\"b\":[", out);
    for (int32_t b = 0; b < s->count.blocks; b++)
        fprintf(out, "%s[%ld,%ld,%d,%d]", b ? "," : "", (long)s->block[b].vertex, (long)s->block[b].vertices,
                s->block[b].fixed != 0, motion && motion_speed(s, of->result, b) > MOTION_STILL);
    fputs("],\n\"f\":[", out);                         /* of each face: its block, its vertices */
    for (int32_t b = 0, n = 0; b < s->count.blocks; b++)
        for (int32_t i = s->block[b].face; i < s->block[b].face + s->block[b].faces; i++) {
            fprintf(out, "%s[%ld", n++ ? "," : "", (long)b);
            for (int32_t k = 0; k < s->face[i].corners; k++) fprintf(out, ",%ld", (long)s->corner[s->face[i].corner + k]);
            fputs("]", out);
        }
    fputs("],\n", out);
}

static void put_joints(FILE *out, const sp_scene *s, const forces *f)
{
    int n = 0;
    fputs("\"j\":[", out);
    for (int32_t i = 0; i < s->count.joints; i++) {
        fputs(i ? ",[" : "[", out);
        for (int32_t k = 0; k < s->joint[i].points; k++) put_point(out, s->point[s->joint[i].point + k], k == 0);
        fputs("]", out);
    }
    fputs("],\n\"a\":[", out);                         /* arrows, from and to */
    for (int32_t i = 0; i < s->count.joints; i++) {
        sp_real from[3], to[3];
        double size;
        if (!forces_arrow(f, s, i, from, to, &size) || !(size > 1e-3 * f->largest)) continue;
        fprintf(out, "%s[%.7g,%.7g,%.7g,%.7g,%.7g,%.7g]", n++ ? "," : "", (double)from[0], (double)from[1], (double)from[2],
                (double)to[0], (double)to[1], (double)to[2]);
    }
    fputs("],\n", out);
}

/* Of each joint its blocks; of the mechanism of a limit its hinges, as lines. */
static void put_pairs(FILE *out, const subject *of)
{
    const sp_scene *s = &of->scene->scene;
    sp_joint_motion m;
    int n = 0;
    fputs("\"ab\":[", out);
    for (int32_t i = 0; i < s->count.joints; i++)
        fprintf(out, "%s[%ld,%ld]", i ? "," : "", (long)s->joint[i].a, (long)s->joint[i].b);
    fputs("],\n\"h\":[", out);
    for (int32_t i = 0; of->limit && i < s->count.joints; i++) {
        if (sp_joint_moves(s, of->result->dq, i, &m) != SP_OK || m.kind != SP_JOINT_HINGE) continue;
        fputs(n++ ? ",[" : "[", out);
        put_point(out, m.a, 1);
        put_point(out, m.b, 0);
        fputs("]", out);
    }
    fputs("],\n", out);
}

/* Blocks that have their names where it moves. */
static void put_fastest(FILE *out, const subject *of)
{
    int32_t fastest[MOTION_NAMED];
    const int32_t moving = motion_fastest(&of->scene->scene, of->result, MOTION_NAMED, fastest);
    fputs("\"fast\":[", out);
    for (int k = 0; k < moving && k < MOTION_NAMED; k++) fprintf(out, "%s%ld", k ? "," : "", (long)fastest[k]);
    fputs("],\n", out);
}

/* The axes of the scene, the last one up, and from where it is seen first: azimuth and rise [rad]. */
static void put_view(FILE *out, const sp_scene *s, const view *v)
{
    const view_axes a = view_level(s);
    double t[3] = { 0, 0, 0 };
    fputs("\"axes\":[", out);
    for (int k = 0; k < 3; k++) {
        fprintf(out, "%s[%g,%g,%g]", k ? "," : "", a.e[k][0] + 0.0, a.e[k][1] + 0.0, a.e[k][2] + 0.0);
        for (int c = 0; c < 3; c++) t[k] += v->toward[c] * a.e[k][c];
    }
    fprintf(out, "],\n\"view\":[%.7g,%.7g],\n", atan2(t[0], -t[1]), asin(fmin(fmax(t[2], -1), 1)));
}

static int put_scene(FILE *out, const subject *of, const forces *f, const mechanism *m)
{
    const sp_scene *s = &of->scene->scene;
    sp_scene moved;
    int good = 1;
    put_points(out, "v", s->vertex, s->count.vertices);
    if (m->shift > 0) {
        good = mechanism_move(m, s, &moved);
        if (good) put_points(out, "w", moved.vertex, s->count.vertices);
        mechanism_free(&moved);
    } else put_points(out, "w", NULL, 0);
    put_blocks(out, of, m->shift > 0);
    put_joints(out, s, f);
    put_pairs(out, of);
    if (m->shift > 0) put_fastest(out, of);
    return good;
}

int turn_moves(const subject *of)
{
    const sp_scene *s = &of->scene->scene;
    if (!motion_is_told(s, of->result)) return 0;
    for (int32_t b = 0; b < s->count.blocks; b++) if (motion_speed(s, of->result, b) > 0) return 1;
    return 0;
}

/* The first view, and how long forces and motions are drawn.          returns the usual block [m] */
static double choose(const subject *of, drawing *d, forces *f, mechanism *m)
{
    double size;
    memset(d, 0, sizeof *d);
    d->s = &of->scene->scene;
    d->v = view_choose(d->s, &of->view);
    return scales_choose(d, f, m, of->result, &size);
}

/* How far gravity points off the way down on paper [degree]. */
static double leaning(const sp_scene *s)
{
    const view_axes a = view_level(s);
    const double g = view_length(s->gravity);
    return g > 0 ? acos(fmax(-1, fmin(1, -view_height(&a, s->gravity) / g))) * 180 / acos(-1.0) : 0;
}

void turn_legend(FILE *out, const subject *of)
{
    forces f;
    mechanism m;
    drawing d;
    choose(of, &d, &f, &m);
    fputs("<p>", out);
    if (f.largest > 0) {
        fputs("Blue: the forces of the joints, each on the block that it holds; the longest is ", out);
        page_quantity(out, f.largest, "N");
        fputs(". ", out);
    }
    if (m.shift > 0) {
        fputs("Red: what moves, drawn to ", out);
        page_quantity(out, m.largest, "m");
        fputs(" at most. ", out);
        if (of->motion) fprintf(out, "%s. ", of->motion);
    }
    const double lean = leaning(d.s);
    if (lean > 0.1) fprintf(out, "Gravity leans by %.3g degrees from straight down. ", lean);
    fputs(of->limit ? "Violet: hinges. Orange: the joint whose number was pressed.</p>\n"
                    : "Orange: the weakest joint, or the one whose number was pressed.</p>\n", out);
}

static void begin_data(FILE *out, const host_scene *scene)
{
    fputs("<ol id=\"names\" hidden>\n", out);
    for (int32_t b = 0; b < scene->scene.count.blocks; b++) {
        fputs("<li>", out);
        page_text(out, scene->name[b], 60);
        fputs("</li>\n", out);
    }
    fputs("</ol>\n<script type=\"application/json\" id=\"scene\">\n{", out);
}

static void end_data(FILE *out)
{
    fputs("}\n</script>\n<script>\n", out);
    turn_script(out);
    fputs("</script>\n", out);
}

int turn_write(FILE *out, const subject *of)
{
    drawing d;
    forces f;
    mechanism m;
    const double block = choose(of, &d, &f, &m);
    int good;
    begin_data(out, of->scene);
    good = put_scene(out, of, &f, &m);
    put_view(out, d.s, &d.v);
    fprintf(out, "\"block\":%.7g,\n\"weakest\":%ld", block, (long)weakest_told(d.s, of->result));
    end_data(out);
    return good;
}

/* ------------------------------------------------------------------------------------------------------------- build order */

#define FAR 0.4                         /* of the usual block, as far as the fastest goes */

/* dq about the centroid as a motion about the origin: t - r x c, r.   Its speed at most: |t| + |r| diameter / 2 */
static double about_origin(const sp_scene *s, const turn_move *m, double t[3])
{
    const sp_real *v = m->dq, *r = m->dq + 3, *c = s->block[m->block].centroid;
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        t[k] = (double)v[k] - (double)(r[i] * c[j] - r[j] * c[i]);
    }
    return view_length(v) + view_length(r) * (double)s->block[m->block].diameter / 2;
}

static void put_moves(FILE *out, const sp_scene *s, const turn_step *step, double length)
{
    double most = 0, t[3];
    for (int32_t i = 0; i < step->moves; i++) most = fmax(most, about_origin(s, &step->move[i], t));
    for (int32_t i = 0; i < step->moves && most > 0; i++) {
        const double by = length / most;
        const turn_move *m = &step->move[i];
        about_origin(s, m, t);
        fprintf(out, "%s[%ld,%.5g,%.5g,%.5g,%.5g,%.5g,%.5g]", i ? "," : "", (long)m->block, by * t[0], by * t[1], by * t[2],
                by * (double)m->dq[3], by * (double)m->dq[4], by * (double)m->dq[5]);
    }
}

static void put_steps(FILE *out, const sp_scene *s, int32_t steps, const turn_step *step, double length)
{
    fputs("\"s\":[", out);
    for (int32_t k = 0; k < steps; k++) {
        fprintf(out, "%s[%ld,%d,[", k ? ",\n" : "", (long)step[k].block, step[k].how);
        for (int32_t i = 0; i < step[k].helds; i++) fprintf(out, "%s%ld", i ? "," : "", (long)step[k].held[i]);
        fputs("],[", out);
        put_moves(out, s, &step[k], length);
        fputs("]]", out);
    }
    fputs("],\n", out);
}

int turn_write_steps(FILE *out, const host_scene *scene, const view_wish *wish, int remove, int32_t steps,
                     const turn_step *step)
{
    const sp_result none = { 0 };
    const subject of = { scene, &none, NULL, *wish, 0, NULL, NULL };
    const sp_scene *s = &scene->scene;
    const view v = view_choose(s, wish);
    double block = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) if (!s->block[b].fixed) block += (double)s->block[b].diameter;
    block /= fmax(1, (double)steps);
    begin_data(out, scene);
    put_points(out, "v", s->vertex, s->count.vertices);
    put_points(out, "w", NULL, 0);
    put_blocks(out, &of, 0);
    fprintf(out, "\"j\":[],\"a\":[],\"ab\":[],\"h\":[],\"remove\":%d,\n", remove);
    put_steps(out, s, steps, step, FAR * block);
    put_view(out, s, &v);
    fprintf(out, "\"block\":%.7g,\n\"weakest\":-1", block);
    end_data(out);
    return !ferror(out);
}
