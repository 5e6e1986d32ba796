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

static int put_scene(FILE *out, const subject *of)
{
    const sp_scene *s = &of->scene->scene;
    drawing d;
    forces f;
    mechanism m;
    sp_scene moved;
    double size;
    int good = 1;
    memset(&d, 0, sizeof d);
    d.s = s;
    d.v = view_choose(s, &of->view);
    scales_choose(&d, &f, &m, of->result, &size);
    put_points(out, "v", s->vertex, s->count.vertices);
    if (m.shift > 0) {
        good = mechanism_move(&m, s, &moved);
        if (good) put_points(out, "w", moved.vertex, s->count.vertices);
        mechanism_free(&moved);
    } else put_points(out, "w", NULL, 0);
    put_blocks(out, of, m.shift > 0);
    put_joints(out, s, &f);
    put_view(out, s, &d.v);
    fprintf(out, "\"weakest\":%ld", (long)weakest_told(s, of->result));
    return good;
}

int turn_moves(const subject *of)
{
    const sp_scene *s = &of->scene->scene;
    if (of->result->verdict != SP_UNSTABLE && !motion_is_virtual(of->result)) return 0;
    for (int32_t b = 0; b < s->count.blocks; b++) if (motion_speed(s, of->result, b) > 0) return 1;
    return 0;
}

int turn_write(FILE *out, const subject *of)
{
    int good;
    fputs("<ol id=\"names\" hidden>\n", out);
    for (int32_t b = 0; b < of->scene->scene.count.blocks; b++) {
        fputs("<li>", out);
        page_text(out, of->scene->name[b], 60);
        fputs("</li>\n", out);
    }
    fputs("</ol>\n<script type=\"application/json\" id=\"scene\">\n{", out);
    good = put_scene(out, of);
    fputs("}\n</script>\n<script>\n", out);
    turn_script(out);
    fputs("</script>\n", out);
    return good;
}
