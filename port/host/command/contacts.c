/* contacts: what touches what? */
#include "commands.h"
#include "../files/json_out.h"
#include "contacts_sweep.h"
#include "../files/scene.h"

static void print_table(const host_scene *s, int quiet)
{
    if (!quiet) printf("%-16s %-16s %13s %7s   %s\n", "a", "b", "area [m^2]", "corners", "normal from a into b");
    for (int32_t i = 0; !quiet && i < s->scene.count.joints; i++) {
        const sp_joint *c = &s->scene.joint[i];
        printf("%-16s %-16s %13.6g %7ld   %9.6f %9.6f %9.6f\n", s->name[c->a], s->name[c->b], (double)c->area, (long)c->points,
               (double)c->n[0], (double)c->n[1], (double)c->n[2]);
    }
    for (int32_t i = 0; !quiet && i < s->overlaps; i++)
        printf("overlap: %s and %s are %.6g m inside each other\n", s->name[s->overlap[i].a], s->name[s->overlap[i].b],
               (double)s->overlap[i].depth);
    printf("%ld contact%s between %ld block%s, %ld overlap%s\n", (long)s->scene.count.joints,
           s->scene.count.joints == 1 ? "" : "s", (long)s->scene.count.blocks, s->scene.count.blocks == 1 ? "" : "s",
           (long)s->overlaps, s->overlaps == 1 ? "" : "s");
    if (!quiet) remarks_print(stdout, &s->remarks);
}

static void print_json(const host_scene *s)
{
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", s->path);
    json_int(&j, "blocks", s->scene.count.blocks);
    json_open(&j, "contacts", '[');
    for (int32_t i = 0; i < s->scene.count.joints; i++) {
        const sp_joint *c = &s->scene.joint[i];
        json_open(&j, NULL, '{');
        json_string(&j, "a", s->name[c->a]);
        json_string(&j, "b", s->name[c->b]);
        json_real(&j, "area", (double)c->area);
        json_reals(&j, "normal", c->n, 3);
        json_open(&j, "points", '[');
        for (int32_t k = 0; k < c->points; k++) json_reals(&j, NULL, s->scene.point[c->point + k], 3);
        json_close(&j, ']');
        json_close(&j, '}');
    }
    json_close(&j, ']');
    json_open(&j, "overlaps", '[');
    for (int32_t i = 0; i < s->overlaps; i++) {
        json_open(&j, NULL, '{');
        json_string(&j, "a", s->name[s->overlap[i].a]);
        json_string(&j, "b", s->name[s->overlap[i].b]);
        json_real(&j, "depth", (double)s->overlap[i].depth);
        json_close(&j, '}');
    }
    json_close(&j, ']');
    scene_remarks_json(&j, s);
    json_close(&j, '}');
    fputc('\n', stdout);
}

int command_contacts(int argc, char **argv)
{
    failure error = { 0, "" };
    host_scene s;
    options o;

    if (options_read(argc, argv, " --json --sweep" SCENE_OPTIONS, &o, &error) == 0 && o.files != 1)
        fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: contacts needs one scene");
    if (!error.status) {
        o.scene.contacts = SCENE_FIND;
        if (scene_read(o.file[0], &o.scene, &s, &error) == 0) {
            if (o.sweep) contacts_sweep(&s, &o, &error);
            else if (o.json) print_json(&s);
            else print_table(&s, o.quiet);
        }
        scene_free(&s);
    }
    if (error.status) fprintf(stderr, "%s\n", error.line);
    return error.status;
}
