#include "options.h"
#include "../files/text.h"
#include "jobs.h"
#include "solvers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int usage(failure *error, const char *option, const char *message)
{
    return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: %s %s", option, message);
}

/* ------------------------------------------------------------------------------------------------------------- numbers */

static int read_number(const char *s, double *x)
{
    const text_word w = { s, strlen(s) };
    return text_double(w, x) == TEXT_NUMBER;
}

static int read_real(const char *s, sp_real *x)
{
    const text_word w = { s, strlen(s) };
    return text_real(w, x) == TEXT_NUMBER;
}

/* X[,Y]; y is left as it is where there is none. */
static int read_one_or_two(const char *s, double *x, double *y)
{
    char first[64];
    const size_t n = strcspn(s, ",");
    if (n >= sizeof first) return 0;
    memcpy(first, s, n);
    first[n] = 0;
    return read_number(first, x) && (!s[n] || read_number(s + n + 1, y));
}

/* X,Y,Z, not all 0. */
static int read_three(const char *s, double x[3])
{
    for (int k = 0; k < 3; k++) {
        char word[64];
        const size_t n = strcspn(s, ",");
        if (n >= sizeof word || (k < 2) != (s[n] == ',')) return 0;
        memcpy(word, s, n);
        word[n] = 0;
        if (!read_number(word, &x[k])) return 0;
        s += n + 1;
    }
    return fabs(x[0]) + fabs(x[1]) + fabs(x[2]) > 0;
}

int options_cone(const char *text, sp_settings *settings)
{
    const size_t n = strlen(text);
    text_word digits = { text, n ? n - 1 : 0 };
    int32_t faces;

    if (strcmp(text, "true") == 0) {
        settings->faces = 0;
        return 1;
    }
    if (n < 2 || (text[n - 1] != 'i' && text[n - 1] != 'c')) return 0;
    if (text[0] < '1' || text[0] > '9' || text_int(digits, &faces) != TEXT_NUMBER || faces < 3 || faces > 64) return 0;
    settings->faces = faces;
    settings->inscribed = text[n - 1] == 'i';
    return 1;
}

/* ------------------------------------------------------------------------------------------------- options with a value
 *
 * Each takes its value, or says what it needs.                                   returns 0, EXIT_USAGE or EXIT_UNAVAILABLE */

static int take_tol(options *o, const char *name, const char *value, failure *error)
{
    sp_real *tol = &o->settings.tol;
    if (read_real(value, tol) && *tol >= 4 * SP_EPSILON && *tol <= (sp_real)0.1) return 0;
    return usage(error, name, sizeof(sp_real) == 8 ? "needs a number from 4.5e-16 to 0.1"
                                                  : "needs a number from 2.4e-7 to 0.1");
}

static int take_budget(options *o, const char *name, const char *value, failure *error)
{
    double flops;
    if (!read_number(value, &flops) || !(flops >= 1 && flops <= 1e18))
        return usage(error, name, "needs a number of flops from 1 to 1e18");
    o->settings.budget = (int64_t)flops;
    return 0;
}

static int take_mu(options *o, const char *name, const char *value, failure *error)
{
    return read_real(value, &o->scene.mu) && o->scene.mu >= 0 ? 0 : usage(error, name, "needs a number, 0 or more");
}

static int take_fixed(options *o, const char *name, const char *value, failure *error)
{
    amendments *a = &o->scene.amend;
    if (!*value) return usage(error, name, "needs names or patterns of blocks, lowest or ground");
    if (a->lists == AMEND_LISTS) return usage(error, name, "is given too often: put the names into one list");
    a->option[a->lists] = name;
    a->fixed[a->lists++] = value;
    return 0;
}

static int take_gravity(options *o, const char *name, const char *value, failure *error)
{
    amendments *a = &o->scene.amend;
    double g[3];
    if (!read_three(value, g)) return usage(error, name, "needs X,Y,Z [m/s^2], not all 0");
    for (int k = 0; k < 3; k++) a->gravity[k] = (sp_real)g[k];
    a->pull = 1;
    return a->turn ? usage(error, name, "and --up exclude each other") : 0;
}

static int take_up(options *o, const char *name, const char *value, failure *error)
{
    const text_word w = { value, strlen(value) };
    amendments *a = &o->scene.amend;
    if (!units_read_axis(w, a->up)) return usage(error, name, "needs x, y, z, -x, -y or -z");
    a->turn = 1;
    return a->pull ? usage(error, name, "and --gravity exclude each other") : 0;
}

static int take_unit(options *o, const char *name, const char *value, failure *error)
{
    const text_word w = { value, strlen(value) };
    return units_read_length(w, &o->scene.amend.unit) ? 0 : usage(error, name, "needs mm, cm, m or in");
}

static int take_contact_distance(options *o, const char *name, const char *value, failure *error)
{
    const text_word w = { value, strlen(value) };
    return touching_read_distance(w, &o->scene.amend.contact) ? 0
         : usage(error, name, "needs a length [m], or up to 50% of the smaller block");
}

static int take_contact_angle(options *o, const char *name, const char *value, failure *error)
{
    const text_word w = { value, strlen(value) };
    return touching_read_angle(w, &o->scene.amend.contact) ? 0 : usage(error, name, "needs degrees from 0 to 30");
}

static int take_eps(options *o, const char *name, const char *value, failure *error)
{
    return read_real(value, &o->eps) && o->eps > 0 ? 0 : usage(error, name, "needs a number above 0");
}

static int take_near(options *o, const char *name, const char *value, failure *error)
{
    return read_number(value, &o->near) && o->near > 0 ? 0 : usage(error, name, "needs a length above 0");
}

static int take_cone(options *o, const char *name, const char *value, failure *error)
{
    if (!options_cone(value, &o->settings))
        return usage(error, name, "needs true, Ki (inscribed) or Kc (circumscribed) with K = 3..64");
    snprintf(o->cone, sizeof o->cone, "%s", value);
    return 0;
}

/* "gates,exact" */
static int take_stages(options *o, const char *name, const char *value, failure *error)
{
    static const char *const stage_name[] = { "", "gates", "least-squares", "dense", "polish", "exact", "admm" };
    sp_settings *to = &o->settings;
    to->stage_count = 0;
    for (;;) {
        const size_t n = strcspn(value, ",");
        int32_t k = SP_STAGE_GATES;
        while (k <= SP_STAGE_ADMM && (strlen(stage_name[k]) != n || memcmp(stage_name[k], value, n))) k++;
        if (k > SP_STAGE_ADMM || to->stage_count == SP_STAGES_MAX)
            return usage(error, name, "needs some of gates,least-squares,dense,polish,exact,admm");
        to->stage[to->stage_count++] = (sp_stage_id)k;
        if (!value[n]) return 0;
        value += n + 1;
    }
}

static int take_sliding(options *o, const char *name, const char *value, failure *error)
{
    o->sliding = strcmp(value, "real") == 0;
    return o->sliding || strcmp(value, "associative") == 0 ? 0 : usage(error, name, "needs real or associative");
}

static int take_body(options *o, const char *name, const char *value, failure *error)
{
    return read_three(value, o->body) ? 0 : usage(error, name, "needs DX,DY,DZ, not all 0");
}

static int take_tilt(options *o, const char *name, const char *value, failure *error)
{
    if (read_one_or_two(value, &o->tilt, &o->azimuth) && fabs(o->tilt) <= 360 && fabs(o->azimuth) <= 360) return 0;
    return usage(error, name, "needs DEG or DEG,AZIMUTH, degrees within -360..360");
}

static int take_jobs(options *o, const char *name, const char *value, failure *error)
{
    int32_t n;
    const text_word w = { value, strlen(value) };
    if (text_int(w, &n) != TEXT_NUMBER || n < 1 || n > JOBS_MOST)
        return usage(error, name, "needs a number of cores from 1 to 64");
    o->jobs = n;
    return 0;
}

/* SECONDS[,MEGABYTES] */
static int take_worker(options *o, const char *name, const char *value, failure *error)
{
    double megabytes = 0;
    const int good = read_one_or_two(value, &o->worker, &megabytes) && o->worker > 0
                  && (!strchr(value, ',') || (megabytes > 0 && megabytes < 1e9));
    o->worker_memory = 1e6 * megabytes;
    return good ? 0 : usage(error, name, "needs SECONDS or SECONDS,MEGABYTES, above 0");
}

/* From where a picture is drawn: AZIMUTH,ELEVATION in degrees, or by name. */
static int take_view(options *o, const char *name, const char *value, failure *error)
{
    static const struct { const char *name; double azimuth, rise; } known[] = {
        { "front", 0, 0 }, { "side", 90, 0 }, { "top", 0, 90 } };
    view_wish *v = &o->view;
    v->given = 1;
    for (int k = 0; k < 3; k++)
        if (strcmp(value, known[k].name) == 0) {
            v->azimuth = known[k].azimuth;
            v->rise = known[k].rise;
            return 0;
        }
    if (strchr(value, ',') && read_one_or_two(value, &v->azimuth, &v->rise) && fabs(v->azimuth) <= 360 && fabs(v->rise) <= 90)
        return 0;
    return usage(error, name, "needs front, side, top or AZIMUTH,ELEVATION, degrees within -360..360 and -90..90");
}

static int take_backend(options *o, const char *name, const char *value, failure *error)
{
    static const char *const backend[] = { "sparse", "dense", "cg" };           /* as sp_qp_backend */
    for (int k = 0; k < 3; k++)
        if (strcmp(value, backend[k]) == 0) {
            o->backend = k;
            return 0;
        }
    return usage(error, name, "needs sparse, dense or cg");
}

static int take_solver(options *o, const char *name, const char *value, failure *error)
{
    (void)name;
    o->solver_name = value;
    o->solver_asked = 1;
    if (strcmp(value, "auto") == 0) return 0;           /* chosen when all options are read */
    o->settings.penalty.solver = strcmp(value, "admm") ? &o->solver : NULL;          /* ours: by NULL */
    return solvers_find(value, &o->solver, error);
}

/* --solver auto: the first that is built in; ours for a worker, to which no other travels. */
static int choose_solver(options *o, failure *error)
{
    if (strcmp(o->solver_name, "auto")) return 0;
    return take_solver(o, "--solver", o->worker > 0 ? "admm" : solvers_first(), error);
}

/* Which effect a word of n bytes names, SP_EFFECTS: none. */
static int effect_named(const char *s, size_t n)
{
    int k = 0;
    while (k < SP_EFFECTS && (strlen(sp_effect_text((sp_effect)k)) != n || memcmp(sp_effect_text((sp_effect)k), s, n))) k++;
    return k;
}

/* "+friction,-together": what of an effect is asked for already must not be contradicted. coupled is a question: --coupled. */
static int take_effects(options *o, const char *name, const char *value, failure *error)
{
    for (;;) {
        const size_t n = strcspn(value, ",");
        const sp_choice choice = *value == '+' ? SP_WITH : SP_WITHOUT;
        const int k = n > 0 ? effect_named(value + 1, n - 1) : SP_EFFECTS;
        sp_choice *to = k < SP_EFFECTS_FORCED ? &o->settings.effect[k] : &o->couple;
        if ((*value != '+' && *value != '-') || (k >= SP_EFFECTS_FORCED && k != SP_EFFECT_COUPLED))
            return usage(error, name, k > 0 && k < SP_EFFECTS
                         ? "forces friction, depth, together, coupled; the others are the scene's, on or off"
                         : "needs a list of +NAME or -NAME of friction, depth, together, coupled");
        if (*to != SP_PLANNED && *to != choice) return usage(error, name, "contradicts itself: +NAME and -NAME of one effect");
        *to = choice;
        if (!value[n]) return 0;
        value += n + 1;
    }
}

static int take_cra_eps(options *o, const char *name, const char *value, failure *error)
{
    sp_real *eps = &o->settings.coupled.eps;
    if (!read_real(value, eps) || !(*eps >= 0 && *eps < (sp_real)1e30))
        return usage(error, name, "needs a length, 0 or more, below 1e30");
    return 0;
}

static int take_cra_eta(options *o, const char *name, const char *value, failure *error)
{
    sp_real *eta = &o->settings.coupled.eta;
    if (!read_real(value, eta) || !(*eta > 0 && *eta < (sp_real)1e30))
        return usage(error, name, "needs a length above 0, below 1e30");
    return 0;
}

static int take_cra_nodes(options *o, const char *name, const char *value, failure *error)
{
    sp_real x;
    if (!read_real(value, &x) || !(x >= 0 && x <= (sp_real)1e7) || x > (sp_real)(int32_t)x)
        return usage(error, name, "needs a whole number from 0 to 1e7");
    o->settings.coupled.nodes = (int32_t)x;
    return 0;
}

/* Read before all others. */
static int take_preset(options *o, const char *name, const char *value, failure *error)
{
    (void)o, (void)name, (void)value, (void)error;
    return 0;
}

static const struct {
    const char *name;
    int (*take)(options *o, const char *name, const char *value, failure *error);
} with_value[] = {
    { "--tol", take_tol }, { "--budget", take_budget }, { "--mu", take_mu },
    { "--fixed", take_fixed }, { "--support", take_fixed },
    { "--gravity", take_gravity }, { "--up", take_up }, { "--unit", take_unit },
    { "--contact-distance", take_contact_distance }, { "--contact-angle", take_contact_angle },
    { "--eps", take_eps }, { "--near", take_near },
    { "--cone", take_cone }, { "--stages", take_stages }, { "--body", take_body }, { "--tilt", take_tilt },
    { "--sliding", take_sliding },
    { "--jobs", take_jobs },
    { "--worker", take_worker }, { "--backend", take_backend }, { "--solver", take_solver }, { "--effects", take_effects },
    { "--cra-eps", take_cra_eps }, { "--cra-eta", take_cra_eta }, { "--cra-nodes", take_cra_nodes },
    { "--preset", take_preset }, { "--view", take_view },
};

/* Where an option goes whose value is taken as it is; NULL: another. */
static const char **place_of_text(options *o, const char *name)
{
    return strcmp(name, "--svg") == 0 ? &o->svg : strcmp(name, "--csv") == 0 ? &o->csv
         : strcmp(name, "--out-obj") == 0 ? &o->model : strcmp(name, "--html") == 0 ? &o->html
         : strcmp(name, "--png") == 0 ? &o->png
         : strcmp(name, "-o") == 0 ? &o->out : strcmp(name, "--frames") == 0 ? &o->frames
         : strcmp(name, "--set") == 0 ? &o->set : strcmp(name, "--order") == 0 ? &o->order
         : strcmp(name, "--order-file") == 0 ? &o->order_file : strcmp(name, "--skip-done") == 0 ? &o->done : NULL;
}

/* One option with its value. */
static int take_value(options *o, const char *name, const char *value, failure *error)
{
    const char **text = place_of_text(o, name);
    if (text) *text = value;
    for (size_t k = 0; !text && k < sizeof with_value / sizeof *with_value; k++)
        if (strcmp(name, with_value[k].name) == 0) return with_value[k].take(o, name, value, error);
    return 0;
}

/* -------------------------------------------------------------------------------------------------------------- others */

/* Whole sets of settings, which other options then change, wherever they stand.    returns 0: unknown */
static int set_preset(const char *value, options *o)
{
    if (strcmp(value, "default") == 0) {
        o->settings = sp_settings_default();
        strcpy(o->cone, "true");
        return 1;
    }
    for (int k = 0; k < 3; k++) {
        static const struct { const char *name; sp_real tol; } dial[] = {
            { "quick", SP_TOL_QUICK }, { "standard", SP_TOL_STANDARD }, { "precise", SP_TOL_PRECISE } };
        if (strcmp(value, dial[k].name)) continue;
        o->settings = sp_settings_default();
        o->settings.tol = dial[k].tol;
        strcpy(o->cone, "true");
        return 1;
    }
    if (strcmp(value, "seed") != 0) return 0;
    o->settings = sp_settings_seed();
    o->solver_name = "auto";                            /* [seed 4.1] */
    snprintf(o->cone, sizeof o->cone, "%ld%c", (long)o->settings.faces, o->settings.inscribed ? 'i' : 'c');
    return 1;
}

/* Options without a value. */
static int set_flag(options *o, const char *name)
{
    if (strcmp(name, "--json") == 0) return o->json = 1;
    if (strcmp(name, "--quiet") == 0) return o->quiet = 1;
    if (strcmp(name, "--split") == 0) return o->scene.amend.split = 1;
    if (strcmp(name, "--forces") == 0) return o->forces = 1;
    if (strcmp(name, "--localise") == 0) return o->settings.localise = 1;
    if (strcmp(name, "--coupled") == 0) return o->settings.coupled.asked = 1;
    if (strcmp(name, "--strong") == 0) return o->strong = 1;
    if (strcmp(name, "--corners") == 0) return o->corners = 1;
    if (strcmp(name, "--cra-box") == 0) return o->settings.coupled.box = 1;
    if (strcmp(name, "--net") == 0) return o->settings.penalty.net = 1;
    if (strcmp(name, "--fallback") == 0) return o->fallback = 1;
    if (strcmp(name, "--confirm") == 0) return o->confirm = 1;
    if (strcmp(name, "--remove") == 0) return o->remove = 1;
    if (strcmp(name, "--suggest") == 0) return o->suggest = 1;
    if (strcmp(name, "--names") == 0) return o->names = 1;
    if (strcmp(name, "--sweep") == 0) return o->sweep = 1;
    if (strcmp(name, "--ram") == 0) return o->ram = 1;
    if (strcmp(name, "--tilt-margin") == 0) return o->tilt_margin = 1;
    return 0;
}

static int is_allowed(const char *allowed, const char *name)
{
    char key[40];
    if (strlen(name) > 32 || strchr(name, ' ')) return 0;
    snprintf(key, sizeof key, " %s ", name);
    return strstr(allowed, key) != NULL;
}

/* ------------------------------------------------------------------------------------------------------- a command line */

static void set_defaults(options *o, char **argv)
{
    const options none = { 0 };
    *o = none;
    o->scene = scene_settings_default();
    o->solver_name = "admm";
    o->solver = sp_qp_admm();
    o->jobs = 1;
    o->program = argv[0];
    o->file = argv + 2;
    set_preset("default", o);
}

/* Every --preset of the line: it comes before all other options, wherever it stands. */
static int read_presets(int argc, char **argv, options *o, failure *error)
{
    for (int i = 2; i < argc && strcmp(argv[i], "--"); i++) {
        const char *value = strcmp(argv[i], "--preset") == 0 ? argv[i + 1] : NULL;
        if (strncmp(argv[i], "--preset=", 9) == 0) value = argv[i] + 9;
        if (value && !set_preset(value, o)) return usage(error, "--preset", "needs default, quick, standard, precise or seed");
    }
    return 0;
}

/* The option argv[*i], with its value behind = or in the next word, to which *i then goes on. */
static int read_option(int argc, char **argv, int *i, const char *allowed, options *o, failure *error)
{
    char *name = argv[*i], *value = strchr(name, '=');
    if (value) *value++ = 0;
    if (!is_allowed(allowed, name))
        return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: unknown option '%.60s', see stonepack %.20s --help", name,
                         argv[1]);
    if (set_flag(o, name)) return value ? usage(error, name, "takes no value") : 0;
    if (!value && *i + 1 == argc) return usage(error, name, "needs a value");
    return take_value(o, name, value ? value : argv[++*i], error);
}

/* What --effects says of coupled must agree with --coupled; `only` is an option that belongs to it, or NULL. */
static int join_coupled(options *o, const char *only, failure *error)
{
    int32_t *asked = &o->settings.coupled.asked;
    if (o->couple == SP_WITHOUT && *asked) return usage(error, "--effects", "contradicts --coupled");
    if (o->couple == SP_WITH) *asked = 1;
    return only && !*asked ? usage(error, only, "belongs to --coupled") : 0;
}

int options_read(int argc, char **argv, const char *allowed, options *o, failure *error)
{
    const char *coupled_only = NULL;
    int only_files = 0, status = 0;

    set_defaults(o, argv);
    if (is_allowed(allowed, "--preset")) status = read_presets(argc, argv, o, error);
    for (int i = 2; i < argc && !status; i++) {
        char *word = argv[i];
        if (only_files || word[0] != '-' || word[1] == 0) o->file[o->files++] = word;          /* at or before i */
        else if (strcmp(word, "--") == 0) only_files = 1;
        else {
            status = read_option(argc, argv, &i, allowed, o, error);
            if (strncmp(word, "--cra-", 6) == 0 && is_allowed(allowed, "--coupled")) coupled_only = word;
        }
    }
    if (!status) status = choose_solver(o, error);
    if (!status && o->strong && o->worker > 0) status = usage(error, "--strong", "can't go to a worker");
    if (!status && o->corners && !o->strong) status = usage(error, "--corners", "belongs to --strong");
    if (!status && o->strong && o->settings.faces) status = usage(error, "--strong", "asks for the true cone");
    if (!status && o->sliding && o->settings.faces) status = usage(error, "--sliding", "asks for the true cone");
    return status ? status : join_coupled(o, coupled_only, error);
}
