/* plan: which effects does a scene call for? */
#include "../run.h"
#include "commands.h"
#include "../files/json_out.h"
#include "options.h"
#include "../files/scene.h"
#include "../tilt.h"

static void print_table(const host_scene *s, const sp_outlook *o, int quiet)
{
    printf("%s: %ld block%s, %ld joint%s, %ld island%s\n", s->path, (long)s->scene.count.blocks, text_s(s->scene.count.blocks),
           (long)s->scene.count.joints, text_s(s->scene.count.joints), (long)o->islands, text_s(o->islands));
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

/* Memory of each question, behind the scene in one arena. */
enum { RAM_CONTACTS, RAM_CHECK, RAM_VERIFY, RAM_LIMIT, RAM_SEQUENCE, RAM_OF };
static const struct { const char *name; sp_memory_for what; } ram_of[RAM_OF] = {
    [RAM_CONTACTS] = { "contacts", SP_FOR_CONTACTS }, [RAM_CHECK] = { "check", SP_FOR_CHECK },
    [RAM_VERIFY] = { "verify", SP_FOR_VERIFY }, [RAM_LIMIT] = { "limit", SP_FOR_LIMIT },
    [RAM_SEQUENCE] = { "sequence", SP_FOR_SEQUENCE }
};

typedef struct ram { size_t scene, bytes[RAM_OF]; long fill; } ram;

/* Blocks of the factor below its diagonal, at most: what a check takes, less what it takes at least without them. */
static long ram_fill(const sp_scene *s, size_t check)
{
    const size_t r = sizeof(sp_real);
    size_t loose = 0, least = r > 4 ? 2000 : 1700;      /* [byte] of structs */
    for (int32_t k = 0; k < s->count.blocks; k++) loose += s->block[k].fixed != SP_FIXED;
    least += 6 * r * (size_t)s->count.blocks + (80 * r + 24) * loose + 9 * r * (size_t)s->count.points
          + (sizeof(sp_demand) + sizeof(sp_contact) + 12) * (size_t)s->count.joints;
    return check > least ? (long)((check - least) / (36 * r + 4)) : 0;
}

static sp_status ram_count(const sp_scene *s, const sp_settings *settings, ram *m)
{
    sp_status status = SP_OK;
    m->scene = sp_scene_memory(&s->count);
    for (int k = 0; !status && k < RAM_OF; k++) status = run_bytes_of(s, ram_of[k].what, settings, &m->bytes[k]);
    m->fill = ram_fill(s, m->bytes[RAM_CHECK]);
    return status;
}

static void ram_text(const host_scene *s, const ram *m, int quiet)
{
    const sp_capacity *n = &s->scene.count;
    printf("%s: %ld block%s, %ld joint%s, %ld contact point%s\n", s->path, (long)n->blocks,
           text_s(n->blocks), (long)n->joints, text_s(n->joints), (long)n->points, text_s(n->points));
    if (quiet) return;
    printf("\n%-10s %12s %12s\n%-10s %12lu\n", "", "bytes", "with scene", "scene", (unsigned long)m->scene);
    for (int k = 0; k < RAM_OF; k++)
        printf("%-10s %12lu %12lu\n", ram_of[k].name, (unsigned long)m->bytes[k], (unsigned long)(m->scene + m->bytes[k]));
    printf("\nin firmware, whatever its precision, where all free blocks hang together:\n"
           "  SP_SCENE_BYTES(%ld, %ld, %ld, %ld, %ld, %ld, %ld) + SP_CHECK_BYTES(%ld, %ld, %ld, %ld)\n",
           (long)n->blocks, (long)n->vertices, (long)n->faces, (long)n->corners, (long)n->joints, (long)n->points,
           (long)n->loads, (long)n->blocks, (long)n->joints, (long)n->points, m->fill);
    remarks_print(stdout, &s->remarks);
}

static void ram_json(const host_scene *s, const ram *m)
{
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", s->path);
    json_open(&j, "ram", '{');
    json_int(&j, "scene", (int64_t)m->scene);
    for (int k = 0; k < RAM_OF; k++) json_int(&j, ram_of[k].name, (int64_t)m->bytes[k]);
    json_int(&j, "fill", m->fill);
    json_close(&j, '}');
    scene_remarks_json(&j, s);
    json_close(&j, '}');
    fputc('\n', stdout);
}

static void ram_tell(const host_scene *s, const options *o, failure *error)
{
    ram m;
    const sp_status status = ram_count(&s->scene, &o->settings, &m);
    if (status) scene_refused(s, &o->settings, status, error);
    else if (o->json) ram_json(s, &m);
    else ram_text(s, &m, o->quiet);
}

int command_plan(int argc, char **argv)
{
    failure error = { 0, "" };
    host_scene s;
    options o;
    sp_outlook outlook;

    if (options_read(argc, argv, " --json --ram --effects --tol --cone --mu --stages --tilt --coupled" SCENE_OPTIONS, &o,
                     &error) == 0 && o.files != 1)
        fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: plan needs one scene");
    if (!error.status) {
        if (scene_read(o.file[0], &o.scene, &s, &error) == 0) {
            tilt_turn(o.tilt, o.azimuth, s.scene.gravity);
            const sp_status status = o.ram ? SP_OK : run_plan(&s.scene, &o.settings, &outlook);
            if (o.ram) ram_tell(&s, &o, &error);
            else if (status) scene_refused(&s, &o.settings, status, &error);
            else if (o.json) print_json(&s, &outlook);
            else print_table(&s, &outlook, o.quiet);
        }
        scene_free(&s);
    }
    if (error.status) fprintf(stderr, "%s\n", error.line);
    return error.status;
}
