/* plan: which effects does a scene call for? */
#include "../run.h"
#include "commands.h"
#include "../files/json_out.h"
#include "options.h"
#include "../files/scene.h"
#include "../tilt.h"

static void print_table(const host_scene *s, const sp_outlook *o, int quiet)
{
    printf("%s: %ld blocks, %ld joints, %ld island%s\n", s->path, (long)s->scene.count.blocks,
           (long)s->scene.count.joints, (long)o->islands, o->islands == 1 ? "" : "s");
    if (quiet) return;
    printf("\n%-10s %-4s %12s %12s %12s   %s\n", "effect", "", "unknowns", "flops", "bytes saved", "why");
    for (int k = 0; k < SP_EFFECTS; k++) {
        const sp_planned *p = &o->effect[k];
        printf("%-10s %-4s ", sp_effect_text((sp_effect)k), sp_effect_on(p->why) ? "on" : "off");
        if (p->unknowns || p->flops || p->bytes)
            printf("%12lld %12lld %12lld", (long long)p->unknowns, (long long)p->flops, (long long)p->bytes);
        else printf("%12s %12s %12s", "-", "-", "-");
        printf("   %s\n", sp_effect_why_text(p->why));
    }
    printf("\n%-15s %12s %12s %12s\n", "check", "unknowns", "flops", "bytes");
    printf("%-15s %12lld %12lld %12llu\n", "as planned", (long long)o->unknowns, (long long)o->flops,
           (unsigned long long)o->bytes);
    printf("%-15s %12lld %12lld %12llu\n", "all effects", (long long)o->full_unknowns, (long long)o->full_flops,
           (unsigned long long)o->full_bytes);
    remarks_print(stdout, &s->remarks);
}

static void json_total(json_out *j, const char *key, int64_t unknowns, int64_t flops, size_t bytes)
{
    json_open(j, key, '{');
    json_int(j, "unknowns", unknowns);
    json_int(j, "flops", flops);
    json_int(j, "bytes", (int64_t)bytes);
    json_close(j, '}');
}

static void print_json(const host_scene *s, const sp_outlook *o)
{
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", s->path);
    json_int(&j, "islands", o->islands);
    json_open(&j, "effects", '{');
    for (int k = 0; k < SP_EFFECTS; k++) {
        const sp_planned *p = &o->effect[k];
        json_open(&j, sp_effect_text((sp_effect)k), '{');
        json_bool(&j, "on", sp_effect_on(p->why));
        json_string(&j, "why", sp_effect_why_text(p->why));
        json_bool(&j, "choice", k < SP_EFFECTS_FORCED || k == SP_EFFECT_COUPLED);
        json_int(&j, "unknowns_saved", p->unknowns);
        json_int(&j, "flops_saved", p->flops);
        json_int(&j, "bytes_saved", p->bytes);
        json_close(&j, '}');
    }
    json_close(&j, '}');
    json_total(&j, "planned", o->unknowns, o->flops, o->bytes);
    json_total(&j, "full", o->full_unknowns, o->full_flops, o->full_bytes);
    scene_remarks_json(&j, s);
    json_close(&j, '}');
    fputc('\n', stdout);
}

int command_plan(int argc, char **argv)
{
    failure error = { 0, "" };
    host_scene s;
    options o;
    sp_outlook outlook;

    if (options_read(argc, argv, " --json --effects --tol --cone --mu --stages --tilt --coupled" SCENE_OPTIONS, &o, &error) == 0
        && o.files != 1)
        fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: plan needs one scene");
    if (!error.status) {
        if (scene_read(o.file[0], &o.scene, &s, &error) == 0) {
            tilt_turn(o.tilt, o.azimuth, s.scene.gravity);
            const sp_status status = run_plan(&s.scene, &o.settings, &outlook);
            if (status) scene_refused(&s, &o.settings, status, &error);
            else if (o.json) print_json(&s, &outlook);
            else print_table(&s, &outlook, o.quiet);
        }
        scene_free(&s);
    }
    if (error.status) fprintf(stderr, "%s\n", error.line);
    return error.status;
}
