#include "options.h"
#include "solvers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const stage_name[] = { "", "gates", "least-squares", "dense", "polish", "exact", "admm" };

static int usage(text_error *error, const char *option, const char *message)
{
    return text_fail(error, EXIT_USAGE, NULL, 0, "stonepack: %s %s", option, message);
}

static int number(const char *s, double *x)
{
    const text_word w = { s, strlen(s) };
    return text_double(w, x) == TEXT_NUMBER;
}

static int real(const char *s, sp_real *x)
{
    const text_word w = { s, strlen(s) };
    return text_real(w, x) == TEXT_NUMBER;
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

/* "gates,exact" */
static int stages(const char *s, sp_settings *settings)
{
    settings->stage_count = 0;
    for (;;) {
        const size_t n = strcspn(s, ",");
        int32_t k = SP_STAGE_GATES;
        while (k <= SP_STAGE_ADMM && (strlen(stage_name[k]) != n || memcmp(stage_name[k], s, n))) k++;
        if (k > SP_STAGE_ADMM || settings->stage_count == SP_STAGES_MAX) return 0;
        settings->stage[settings->stage_count++] = (sp_stage_id)k;
        if (!s[n]) return 1;
        s += n + 1;
    }
}

/* X[,Y]; y is left as it is where there is none. */
static int one_or_two(const char *s, double *x, double *y)
{
    char first[64];
    const size_t n = strcspn(s, ",");
    if (n >= sizeof first) return 0;
    memcpy(first, s, n);
    first[n] = 0;
    return number(first, x) && (!s[n] || number(s + n + 1, y));
}

/* X,Y,Z, not all 0. */
static int three(const char *s, double x[3])
{
    for (int k = 0; k < 3; k++) {
        char word[64];
        const size_t n = strcspn(s, ",");
        if (n >= sizeof word || (k < 2) != (s[n] == ',')) return 0;
        memcpy(word, s, n);
        word[n] = 0;
        if (!number(word, &x[k])) return 0;
        s += n + 1;
    }
    return fabs(x[0]) + fabs(x[1]) + fabs(x[2]) > 0;
}

/* DEG[,AZIMUTH] */
static int tilt(const char *s, options *o)
{
    return one_or_two(s, &o->tilt, &o->azimuth) && fabs(o->tilt) <= 360 && fabs(o->azimuth) <= 360;
}

/* SECONDS[,MEGABYTES] */
static int worker(const char *s, options *o)
{
    double megabytes = 0;
    const int some = strchr(s, ',') != NULL;
    if (!one_or_two(s, &o->worker, &megabytes) || !(o->worker > 0)) return 0;
    o->worker_memory = 1e6 * megabytes;
    return some ? megabytes > 0 && megabytes < 1e9 : 1;
}

/* "+friction,-together": what of an effect is asked for already must not be contradicted. coupled is a question: --coupled. */
static int effects(const char *s, options *o, text_error *error)
{
    for (;;) {
        const size_t n = strcspn(s, ",");
        const sp_choice choice = *s == '+' ? SP_WITH : SP_WITHOUT;
        int k = 0;
        while (k < SP_EFFECTS && n > 0
               && (strlen(sp_effect_text((sp_effect)k)) != n - 1 || memcmp(sp_effect_text((sp_effect)k), s + 1, n - 1))) k++;
        if ((*s != '+' && *s != '-') || (k >= SP_EFFECTS_FORCED && k != SP_EFFECT_COUPLED))
            return usage(error, "--effects", k > 0 && k < SP_EFFECTS
                         ? "forces friction, depth, together, coupled; the others are the scene's, on or off"
                         : "needs a list of +NAME or -NAME of friction, depth, together, coupled");
        sp_choice *to = k < SP_EFFECTS_FORCED ? &o->settings.effect[k] : &o->couple;
        if (*to != SP_PLANNED && *to != choice) return usage(error, "--effects", "contradicts itself: +NAME and -NAME of one effect");
        *to = choice;
        if (!s[n]) return 0;
        s += n + 1;
    }
}

static int backend(const char *s, int *which)
{
    static const char *const name[] = { "sparse", "dense", "cg" };              /* as sp_qp_backend */
    for (int k = 0; k < 3; k++)
        if (strcmp(s, name[k]) == 0) {
            *which = k;
            return 1;
        }
    return 0;
}

/* Where an option goes whose value is taken as it is; NULL: another. */
static const char **text_of(options *o, const char *name)
{
    return strcmp(name, "--svg") == 0 ? &o->svg : strcmp(name, "-o") == 0 ? &o->out : strcmp(name, "--frames") == 0 ? &o->frames
         : strcmp(name, "--set") == 0 ? &o->set : strcmp(name, "--order") == 0 ? &o->order
         : strcmp(name, "--order-file") == 0 ? &o->order_file : strcmp(name, "--skip-done") == 0 ? &o->done : NULL;
}

/* One of the coupled check's: --cra-eps, --cra-eta, --cra-nodes. */
static int take_coupled(sp_coupled_settings *c, const char *name, const char *value, text_error *error)
{
    sp_real x;
    const int read = real(value, &x);
    if (strcmp(name, "--cra-eps") == 0) {
        if (!read || x < 0) return usage(error, name, "needs a length, 0 or more");
        c->eps = x;
    } else if (strcmp(name, "--cra-eta") == 0) {
        if (!read || !(x > 0)) return usage(error, name, "needs a length above 0");
        c->eta = x;
    } else {
        if (!read || !(x >= 0 && x <= (sp_real)1e7) || x > (sp_real)(int32_t)x)
            return usage(error, name, "needs a whole number from 0 to 1e7");
        c->nodes = (int32_t)x;
    }
    return 0;
}

/* One option with its value. */
static int take(options *o, const char *name, const char *value, text_error *error)
{
    const char **text = text_of(o, name);
    if (text) {
        *text = value;
    } else if (strncmp(name, "--cra-", 6) == 0) {
        return take_coupled(&o->settings.coupled, name, value, error);
    } else if (strcmp(name, "--effects") == 0) {
        return effects(value, o, error);
    } else if (strcmp(name, "--near") == 0) {
        if (!number(value, &o->near) || !(o->near > 0)) return usage(error, name, "needs a length above 0");
    } else if (strcmp(name, "--tol") == 0) {
        if (!real(value, &o->settings.tol) || !(o->settings.tol >= 4 * SP_EPSILON && o->settings.tol <= (sp_real)0.1))
            return usage(error, name, sizeof(sp_real) == 8 ? "needs a number from 4.5e-16 to 0.1"
                                                          : "needs a number from 2.4e-7 to 0.1");
    } else if (strcmp(name, "--budget") == 0) {
        double flops;
        if (!number(value, &flops) || !(flops >= 1 && flops <= 1e18)) return usage(error, name, "needs a number of flops from 1 to 1e18");
        o->settings.budget = (int64_t)flops;
    } else if (strcmp(name, "--mu") == 0) {
        if (!real(value, &o->mu) || o->mu < 0) return usage(error, name, "needs a number, 0 or more");
    } else if (strcmp(name, "--cone") == 0) {
        if (!options_cone(value, &o->settings))
            return usage(error, name, "needs true, Ki (inscribed) or Kc (circumscribed) with K = 3..64");
        snprintf(o->cone, sizeof o->cone, "%s", value);
    } else if (strcmp(name, "--stages") == 0) {
        if (!stages(value, &o->settings)) return usage(error, name, "needs some of gates,least-squares,dense,polish,exact,admm");
    } else if (strcmp(name, "--body") == 0) {
        if (!three(value, o->body)) return usage(error, name, "needs DX,DY,DZ");
    } else if (strcmp(name, "--preset") == 0) {
        (void)value;                                    /* read before all others */
    } else if (strcmp(name, "--eps") == 0) {
        if (!real(value, &o->eps) || !(o->eps > 0)) return usage(error, name, "needs a number above 0");
    } else if (strcmp(name, "--worker") == 0) {
        if (!worker(value, o)) return usage(error, name, "needs SECONDS or SECONDS,MEGABYTES, above 0");
    } else if (strcmp(name, "--backend") == 0) {
        if (!backend(value, &o->backend)) return usage(error, name, "needs sparse, dense or cg");
    } else if (strcmp(name, "--solver") == 0) {
        o->solver_name = value;
        o->settings.qp_solver = strcmp(value, "admm") ? &o->solver : NULL;         /* ours: by NULL */
        return solvers_find(value, &o->solver, error);
    } else if (strcmp(name, "--tilt") == 0) {
        if (!tilt(value, o)) return usage(error, name, "needs DEG or DEG,AZIMUTH, degrees within -360..360");
    }
    return 0;
}

/* Whole sets of settings, which other options then change, wherever they stand.    returns 0: unknown */
static int preset(const char *value, options *o)
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
    snprintf(o->cone, sizeof o->cone, "%ld%c", (long)o->settings.faces, o->settings.inscribed ? 'i' : 'c');
    return 1;
}

/* Options without a value. */
static int flag(options *o, const char *name)
{
    if (strcmp(name, "--json") == 0) return o->json = 1;
    if (strcmp(name, "--forces") == 0) return o->forces = 1;
    if (strcmp(name, "--coupled") == 0) return o->settings.coupled.asked = 1;
    if (strcmp(name, "--cra-box") == 0) return o->settings.coupled.box = 1;
    if (strcmp(name, "--net") == 0) return o->settings.net = 1;
    if (strcmp(name, "--fallback") == 0) return o->fallback = 1;
    if (strcmp(name, "--confirm") == 0) return o->confirm = 1;
    if (strcmp(name, "--remove") == 0) return o->remove = 1;
    if (strcmp(name, "--suggest") == 0) return o->suggest = 1;
    if (strcmp(name, "--tilt-margin") == 0) return o->tilt_margin = 1;
    return 0;
}

static int known(const char *allowed, const char *name)
{
    char key[40];
    if (strlen(name) > 32 || strchr(name, ' ')) return 0;
    snprintf(key, sizeof key, " %s ", name);
    return strstr(allowed, key) != NULL;
}

int options_read(int argc, char **argv, const char *allowed, options *o, text_error *error)
{
    const options none = { 0 };
    const char *coupled_only = NULL;
    int only_files = 0;

    *o = none;
    o->mu = -1;
    o->solver_name = "admm";
    o->solver = sp_qp_admm();
    preset("default", o);
    for (int i = 2; known(allowed, "--preset") && i < argc && strcmp(argv[i], "--"); i++) {
        const char *value = strncmp(argv[i], "--preset=", 9) == 0 ? argv[i] + 9 : strcmp(argv[i], "--preset") ? NULL : argv[i + 1];
        if (value && !preset(value, o)) return usage(error, "--preset", "needs default, quick, standard, precise or seed");
    }
    o->program = argv[0];
    o->file = argv + 2;
    for (int i = 2; i < argc; i++) {
        char *name = argv[i], *value;
        int status;
        if (only_files || name[0] != '-' || name[1] == 0) {
            o->file[o->files++] = name;                 /* at or before i */
            continue;
        }
        if (strcmp(name, "--") == 0) {
            only_files = 1;
            continue;
        }
        value = strchr(name, '=');
        if (value) *value++ = 0;
        if (!known(allowed, name))
            return text_fail(error, EXIT_USAGE, NULL, 0, "stonepack: unknown option '%.60s', see stonepack %.20s --help", name, argv[1]);
        if (strncmp(name, "--cra-", 6) == 0) coupled_only = name;
        if (!value && flag(o, name)) continue;
        if (value && flag(o, name)) return usage(error, name, "takes no value");
        if (!value && i + 1 == argc) return usage(error, name, "needs a value");
        status = take(o, name, value ? value : argv[++i], error);
        if (status) return status;
    }
    if (o->couple == SP_WITHOUT && o->settings.coupled.asked) return usage(error, "--effects", "contradicts --coupled");
    if (o->couple == SP_WITH) o->settings.coupled.asked = 1;
    return coupled_only && !o->settings.coupled.asked ? usage(error, coupled_only, "belongs to --coupled") : 0;
}
