/* sequence: does it stand at every step of a build order, and what must be held meanwhile? */
#include "../clock.h"
#include "../files/csv_out.h"
#include "../files/file.h"
#include "../files/text.h"
#include "../run.h"
#include "../files/drawn.h"
#include "../files/json_out.h"
#include "commands.h"
#include "html_page.h"
#include "options.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "report_csv.h"
#include "../files/scene.h"
#include "../picture/model.h"
#include "../picture/page.h"
#include "../picture/sheet.h"
#include "../picture/turn.h"
#include "../tilt.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STRIP = 24, MOVES = 50000 };      /* pictures in a strip, blocks that move in a page or model, at most */

/* What became of one step. */
typedef struct outcome {
    int32_t block;
    sp_step step;                       /* its arrays are the sequence's: not read later */
    sp_held held;                       /* its lists lie in `list` */
    int32_t *list;
    sp_suggestion next;
    unsigned char *mark;                /* of each block: an block_mark; NULL: no picture wanted */
    turn_move *move;                    /* of those that move; NULL: none, or too many in all */
    int32_t moves;
} outcome;

typedef struct run {
    const options *options;
    host_scene scene;
    int32_t *order, steps;
    outcome *outcome;                   /* of each step */
    void *memory;
    sp_sequence *sequence;
    int32_t first;                      /* step that fails first, from 1; 0: none */
    sp_verdict worst;
    sp_cost cost;                       /* of the steps, without the search for what to hold and what comes next */
    size_t bytes;
    double seconds;
    int32_t moves;                      /* kept, of all steps */
    int32_t dropped;                    /* steps that fall and whose motion is not kept */
} run;

static void show_progress(const run *r, int32_t k)
{
    if (k < r->steps) progress_show("step %ld of %ld: %.60s ...", (long)k + 1, (long)r->steps, r->scene.name[r->order[k]]);
    else progress_end();
}

static void *zeroed(size_t count, size_t size)
{
    void *p = count < SIZE_MAX / size - SP_ALIGN ? calloc(count * size + SP_ALIGN, 1) : NULL;
    return p;
}

/* --------------------------------------------------------------------------------------------------------------- order */

static text_word word_of(const char *s)
{
    const text_word w = { s, strlen(s) };
    return w;
}

/* Is it the first word of a name? */
static int is_part(const run *r, text_word name)
{
    for (int32_t b = 0; b < r->scene.scene.count.blocks; b++) if (text_begins(name, word_of(r->scene.name[b]))) return 1;
    return 0;
}

/* A stone of the order, by its name. `path` NULL: from the command line.                    returns 0 or an exit status */
static int add_to_order(run *r, text_word name, const char *path, int32_t line, failure *error)
{
    const sp_scene *s = &r->scene.scene;
    const int status = path ? EXIT_SCENE : EXIT_USAGE, n = name.n > 60 ? 60 : (int)name.n;
    int32_t b = 0;
    while (b < s->count.blocks && !text_names(name, word_of(r->scene.name[b]))) b++;
    if (!path) path = "stonepack: --order";
    if (b == s->count.blocks)
        return fail_with(error, status, path, line, "the scene has no block '%.*s'%s", n, name.s,
                         is_part(r, name) ? ": blanks of a name are written _, or it stands in quotes" : "");
    if (s->block[b].fixed == SP_FIXED) return fail_with(error, status, path, line, "'%.*s' is a support", n, name.s);
    for (int32_t k = 0; k < r->steps; k++)
        if (r->order[k] == b) return fail_with(error, status, path, line, "'%.*s' comes twice", n, name.s);
    r->order[r->steps++] = b;
    return 0;
}

/* a,b,c */
static int read_list(run *r, const char *list, failure *error)
{
    for (;;) {
        const size_t n = strcspn(list, ",");
        text_word name = { list, n };
        while (name.n && *name.s == ' ') name.s++, name.n--;
        while (name.n && name.s[name.n - 1] == ' ') name.n--;
        const int status = add_to_order(r, name, NULL, 0, error);
        if (status || !list[n]) return status;
        list += n + 1;
    }
}

/* Names with white space between them, those with blanks in quotes; # starts a comment.    *line: of the last one */
static int read_file(run *r, const char *path, int32_t *line, failure *error)
{
    char *text = NULL;
    size_t length = 0;
    int status = file_read(path, &text, &length, error);
    text_cursor c = { text, text ? text + length : NULL, 1 };
    text_word name;
    *line = 1;
    if (!status) text_skip_mark(&c);
    do {
        while (!status && text_next_name(&c, &name) && name.s[0] != '#') {
            *line = c.line;
            status = add_to_order(r, name, path, c.line, error);
        }
    } while (!status && text_next_line(&c));
    free(text);
    return status;
}

/* A stone to be built must be in the order; one that need not go may be left out of it. */
static int check_complete(const run *r, const char *path, int32_t line, failure *error)
{
    const sp_scene *s = &r->scene.scene;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        int32_t k = 0;
        while (k < r->steps && r->order[k] != b) k++;
        if (k < r->steps || s->block[b].fixed == SP_FIXED) continue;
        return fail_with(error, path ? EXIT_SCENE : EXIT_USAGE, path ? path : "stonepack: --order", line,
                         "the order ends without '%.60s'", r->scene.name[b]);
    }
    return 0;
}

static int read_order(run *r, failure *error)
{
    const options *o = r->options;
    const sp_scene *s = &r->scene.scene;
    int32_t line = 0;
    int status = 0;
    r->order = zeroed((size_t)s->count.blocks, sizeof *r->order);
    if (!r->order) return fail_with(error, EXIT_MEMORY, r->scene.path, 0, "out of memory");
    if (o->order && o->order_file)
        return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: --order and --order-file exclude each other");
    if (o->order) status = read_list(r, o->order, error);
    else if (o->order_file) status = read_file(r, o->order_file, &line, error);
    else
        for (int32_t k = 0; k < s->count.blocks; k++) {
            const int32_t b = o->remove ? s->count.blocks - 1 - k : k;
            if (s->block[b].fixed != SP_FIXED) r->order[r->steps++] = b;
        }
    return status || o->remove ? status : check_complete(r, o->order_file, line, error);
}

/* ----------------------------------------------------------------------------------------------------------------- run */

/* To be taken down: all is there. */
static sp_status place_all(run *r)
{
    const int32_t n = r->scene.scene.count.blocks;
    sp_presence *presence = zeroed((size_t)n, sizeof *presence);
    sp_step step;
    sp_status status = presence ? SP_OK : SP_E_MEMORY;
    for (int32_t b = 0; b < n && presence; b++) presence[b] = SP_PRESENT;
    if (!status) status = sp_sequence_fill(r->sequence, presence, &step);
    free(presence);
    return status;
}

/* What the strip shows of a step: who is there is told by the order. */
static sp_status mark_blocks(run *r, int32_t k)
{
    outcome *t = &r->outcome[k];
    const int32_t n = r->scene.scene.count.blocks;
    t->mark = zeroed((size_t)n, 1);
    if (!t->mark) return SP_E_MEMORY;
    for (int32_t b = 0; b < n; b++) {
        const sp_real *dq = t->step.dq + 6 * (size_t)b;
        double size = 0;
        for (int c = 0; c < 6; c++) size += fabs((double)dq[c]);
        const int there = r->scene.scene.block[b].fixed == SP_FIXED || r->options->remove;
        t->mark[b] = size > 1e-6 ? MARK_FALLS : there ? MARK_PLAIN : MARK_ABSENT;
    }
    for (int32_t i = 0; i <= k; i++) {
        unsigned char *m = &t->mark[r->order[i]];
        if (*m != MARK_FALLS) *m = r->options->remove ? MARK_ABSENT : i == k ? MARK_NEW : MARK_PLAIN;
    }
    for (int32_t i = 0; i < t->held.count; i++) t->mark[t->held.block[i]] = MARK_HELD;
    return SP_OK;
}

/* Who moves while this step falls, for the page and the model. */
static sp_status keep_moves(run *r, int32_t k)
{
    outcome *t = &r->outcome[k];
    int32_t n = 0;
    for (int32_t b = 0; b < r->scene.scene.count.blocks; b++) n += t->mark[b] == MARK_FALLS || t->mark[b] == MARK_HELD;
    if (t->step.verdict != SP_UNSTABLE) return SP_OK;
    if (n > MOVES - r->moves) {
        r->dropped++;
        return SP_OK;
    }
    t->move = zeroed((size_t)n, sizeof *t->move);
    if (!t->move) return SP_E_MEMORY;
    for (int32_t b = 0; b < r->scene.scene.count.blocks; b++) {
        if (t->mark[b] != MARK_FALLS && t->mark[b] != MARK_HELD) continue;
        t->move[t->moves].block = b;
        memcpy(t->move[t->moves++].dq, t->step.dq + 6 * (size_t)b, sizeof t->move->dq);
    }
    r->moves += t->moves;
    return SP_OK;
}

/* Page and model show fewer motions than there are. */
static void tell_dropped(run *r)
{
    if (r->dropped)
        remarks_add(&r->scene.remarks, NULL, "page and model show what moves of the first steps that fall only: %ld more have "
                    "no motion, beyond %ld blocks that move in all", (long)r->dropped, (long)MOVES);
}

static sp_status take_step(run *r, int32_t k)
{
    outcome *t = &r->outcome[k];
    const options *o = r->options;
    const double start = now();
    t->block = r->order[k];
    sp_status status = sp_sequence_set(r->sequence, t->block, o->remove ? SP_ABSENT : SP_PRESENT, &t->step);
    r->seconds += now() - start;
    if (!status && t->step.verdict != SP_STABLE) status = sp_sequence_hold(r->sequence, o->settings.budget, &t->held);
    if (status) return status;
    t->list = zeroed(2 * (size_t)t->held.count, sizeof *t->list);
    if (!t->list) return SP_E_MEMORY;
    if (t->held.count) {
        memcpy(t->list, t->held.block, (size_t)t->held.count * sizeof *t->list);
        memcpy(t->list + t->held.count, t->held.must, (size_t)t->held.count * sizeof *t->list);
    }
    t->held.block = t->list;
    t->held.must = t->list + t->held.count;
    if (o->svg || o->png || o->html || o->model) status = mark_blocks(r, k);
    if (!status && (o->html || o->model)) status = keep_moves(r, k);
    if (!status && o->suggest) status = sp_sequence_suggest(r->sequence, !o->remove, o->settings.budget, &t->next);
    return status;
}

static sp_status all_steps(run *r)
{
    sp_status status;
    const double begin = now();
    r->outcome = zeroed((size_t)r->steps, sizeof *r->outcome);
    if (!r->outcome) return SP_E_MEMORY;
    status = run_sequence(&r->scene.scene, &r->options->settings, &r->sequence, &r->bytes, &r->memory);
    if (!status && r->options->remove) status = place_all(r);
    r->seconds = now() - begin;
    r->worst = SP_STABLE;
    for (int32_t k = 0; k < r->steps && !status; k++) {
        const sp_step *s = &r->outcome[k].step;
        show_progress(r, k);
        status = take_step(r, k);
        if (status) break;
        if (s->verdict != SP_STABLE && !r->first) r->first = k + 1;
        if (s->verdict == SP_UNSTABLE || r->worst == SP_STABLE) r->worst = s->verdict;
        r->cost.flops += s->cost.flops;
        r->cost.factorisations += s->cost.factorisations;
        r->cost.iterations += s->cost.iterations;
        r->cost.interior += s->cost.interior;
    }
    show_progress(r, r->steps);
    return status;
}

/* ---------------------------------------------------------------------------------------------------------------- tell */

static const char *name_of(const run *r, int32_t block) { return block < 0 ? "none" : r->scene.name[block]; }

static void print_held(FILE *out, const run *r, const outcome *t)
{
    for (int32_t k = 0; k < t->held.count && k < 12; k++)
        fprintf(out, "%s%s%s", k ? ", " : "  hold ", name_of(r, t->held.block[k]), t->held.must[k] ? "!" : "");
    if (t->held.count > 12) fprintf(out, " and %ld more", (long)t->held.count - 12);
    fprintf(out, " (%s)", sp_held_proof_text(t->held.proof));
}

static const char *const verdict_word[] = { "undecided", "stable", "UNSTABLE" };

static void print_head(FILE *out, const run *r)
{
    fprintf(out, "%s: %ld step%s, ", r->scene.path, (long)r->steps, text_s(r->steps));
    if (!r->first) fputs("every one stands\n", out);
    else {
        fprintf(out, "step %ld is the first that %s (%s)", (long)r->first,
                r->outcome[r->first - 1].step.verdict ? "fails" : "is undecided", name_of(r, r->order[r->first - 1]));
        report_near(out, r->scene.near, r->scene.inside, r->scene.across);
    }
}

static void print_steps(const run *r)
{
    const options *o = r->options;
    size_t wide = 5;
    for (int32_t k = 0; k < r->steps; k++) {
        const size_t n = strlen(name_of(r, r->order[k]));
        if (n > wide) wide = n < 24 ? n : 24;
    }
    for (int32_t k = 0; k < r->steps; k++) {
        const outcome *t = &r->outcome[k];
        const int more = t->step.verdict != SP_STABLE || o->suggest;
        printf("  %5ld %s %-*s  %-*s", (long)k + 1, o->remove ? "-" : "+", (int)wide, name_of(r, t->block), more ? 9 : 0,
               verdict_word[t->step.verdict]);
        if (t->step.verdict != SP_STABLE) print_held(stdout, r, t);
        if (o->suggest) printf("  next %s", name_of(r, t->next.block));
        putchar('\n');
    }
}

static void print_foot(FILE *out, const run *r)
{
    int32_t most = 0;
    for (int32_t k = 0; k < r->steps; k++) if (r->outcome[k].held.count > most) most = r->outcome[k].held.count;
    if (r->first) {
        report_row(out, "to be held");
        fprintf(out, "at most %ld at once; ! falls even when all others are held\n", (long)most);
    }
    report_row(out, "cost");
    fprintf(out, "%ld factorisation%s, %.3g Mflop, %.1f KiB, %.3g ms for all steps\n", (long)r->cost.factorisations,
            text_s(r->cost.factorisations), 1e-6 * (double)r->cost.flops, (double)r->bytes / 1024, 1e3 * r->seconds);
    remarks_print(out, &r->scene.remarks);
}

static void print_text(const run *r)
{
    print_head(stdout, r);
    if (r->options->quiet) return;
    print_steps(r);
    print_foot(stdout, r);
}

static void json_cost(json_out *j, const char *key, const sp_cost *c)
{
    json_open(j, key, '{');
    json_int(j, "flops", c->flops);
    json_int(j, "factorisations", c->factorisations);
    json_int(j, "iterations", c->iterations);
    json_int(j, "interior", c->interior);
    json_close(j, '}');
}

static void json_name(json_out *j, const run *r, const char *key, int32_t block)
{
    if (block < 0) json_null(j, key);
    else json_string(j, key, r->scene.name[block]);
}

static void json_held(json_out *j, const run *r, const outcome *t)
{
    json_open(j, "hold", '{');
    json_open(j, "blocks", '[');
    for (int32_t k = 0; k < t->held.count; k++) json_name(j, r, NULL, t->held.block[k]);
    json_close(j, ']');
    json_open(j, "must", '[');
    for (int32_t k = 0; k < t->held.count; k++) if (t->held.must[k]) json_name(j, r, NULL, t->held.block[k]);
    json_close(j, ']');
    json_string(j, "proof", sp_held_proof_text(t->held.proof));
    json_int(j, "checks", t->held.checks);
    json_cost(j, "cost", &t->held.cost);
    json_close(j, '}');
}

static void json_step(json_out *j, const run *r, int32_t k)
{
    const outcome *t = &r->outcome[k];
    json_open(j, NULL, '{');
    json_int(j, "step", k + 1);
    json_name(j, r, r->options->remove ? "remove" : "add", t->block);
    json_string(j, "verdict", sp_verdict_text(t->step.verdict));
    json_string(j, "reason", sp_reason_text(t->step.reason));
    json_bool(j, "final", t->step.final);
    json_name(j, r, "falls", t->step.block);
    json_real(j, "omega", (double)t->step.imbalance);
    json_real(j, "least_imbalance", (double)t->step.least_imbalance);
    json_int(j, "blocks", t->step.blocks);
    json_int(j, "islands", t->step.islands);
    json_int(j, "checked", t->step.checked);
    json_int(j, "local", t->step.local);
    json_int(j, "again", t->step.again);
    json_held(j, r, t);
    if (r->options->suggest) json_name(j, r, "next", t->next.block);
    json_cost(j, "cost", &t->step.cost);
    json_close(j, '}');
}

static void print_json(const run *r)
{
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", r->scene.path);
    json_string(&j, "verdict", sp_verdict_text(r->worst));
    if (r->first) json_int(&j, "first_failing", r->first);
    else json_null(&j, "first_failing");
    json_open(&j, "steps", '[');
    for (int32_t k = 0; k < r->steps; k++) json_step(&j, r, k);
    json_close(&j, ']');
    json_cost(&j, "cost", &r->cost);
    json_int(&j, "memory_bytes", (int64_t)(r->bytes + r->scene.bytes));
    json_real(&j, "seconds", r->seconds);
    scene_remarks_json(&j, &r->scene);
    json_close(&j, '}');
    fputc('\n', stdout);
}

/* One line a step; blocks to be held have ; between them. */
static int write_csv(const run *r, failure *error)
{
    char path[REPORT_CSV_PATH];
    FILE *out = report_csv_create(r->options, "steps", path, error);
    csv_out c = { out, 0 };
    if (!out) return error->status;
    csv_header(&c, "step,block,verdict,reason,final,falls,hold,hold_blocks,hold_proof,blocks,checked,flops");
    for (int32_t k = 0; k < r->steps; k++) {
        const outcome *t = &r->outcome[k];
        csv_int(&c, k + 1);
        csv_text(&c, name_of(r, t->block));
        csv_text(&c, sp_verdict_text(t->step.verdict));
        csv_text(&c, sp_reason_text(t->step.reason));
        csv_int(&c, t->step.final);
        csv_text(&c, t->step.block < 0 ? "" : name_of(r, t->step.block));
        csv_int(&c, t->held.count);
        csv_names(&c, r->scene.name, t->held.block, t->held.count);
        csv_text(&c, t->held.count ? sp_held_proof_text(t->held.proof) : "");
        csv_int(&c, t->step.blocks);
        csv_int(&c, t->step.checked);
        csv_int(&c, t->step.cost.flops);
        csv_end(&c);
    }
    return file_finish(out, path, 0, error);
}

/* Which steps the strip shows: all, or some evenly between the first and the last, and the first that fails. */
static int choose_steps(const run *r, int32_t step[STRIP])
{
    const int n = r->steps < STRIP ? (int)r->steps : STRIP;
    for (int i = 0; i < n; i++) step[i] = n < 2 ? 0 : (int32_t)((int64_t)i * (r->steps - 1) / (n - 1));
    for (int i = 0; i < n; i++)
        if (r->first && (i + 1 == n || step[i + 1] > r->first - 1)) {
            if (i > 0 && i + 1 < n) step[i] = r->first - 1;
            break;
        }
    return n;
}

static void write_caption(const run *r, const outcome *t, int32_t k, char text[SHEET_CAPTION])
{
    static const char *const word[] = { "undecided", "stands", "falls" };
    snprintf(text, SHEET_CAPTION, "%ld: %s%.12s %s", (long)k + 1, r->options->remove ? "without " : "", name_of(r, t->block),
             word[t->step.verdict]);
    if (t->held.count) snprintf(text + strlen(text), SHEET_CAPTION - strlen(text), "; %ld to hold", (long)t->held.count);
}

static void write_title(const run *r, int shown, char title[160])
{
    const char *slash = strrchr(r->scene.path, '/');
    char some[24] = "", how[48] = "every one stands";
    if (shown < r->steps) snprintf(some, sizeof some, " (%d shown)", shown);
    if (r->first) snprintf(how, sizeof how, "step %ld is the first that fails", (long)r->first);
    snprintf(title, 160, "%.40s: %ld step%s%s, %s", slash ? slash + 1 : r->scene.path, (long)r->steps,
             text_s(r->steps), some, how);
}

static int put_strip(FILE *out, const void *of)
{
    const run *r = of;
    sheet_frame frame[STRIP];
    int32_t step[STRIP];
    char title[160];
    const int n = choose_steps(r, step);
    if (n == 0) return 1;
    for (int i = 0; i < n; i++) {
        const outcome *t = &r->outcome[step[i]];
        frame[i].vertex = r->scene.scene.vertex;
        frame[i].mark = t->mark;
        frame[i].bad = t->step.verdict != SP_STABLE;
        write_caption(r, t, step[i], frame[i].caption);
    }
    write_title(r, n, title);
    const sheet_page page = { title, &r->options->view, &r->scene.remarks, r->scene.name, r->options->names };
    return sheet_write(out, &r->scene.scene, n, frame, &page);
}

static int put_words(FILE *out, const void *of)
{
    print_head(out, of);
    print_foot(out, of);
    return !ferror(out);
}

static void put_controls(FILE *out, const run *r)
{
    fprintf(out, "<canvas id=\"view\" width=\"1400\" height=\"840\" tabindex=\"0\" role=\"img\" "
            "aria-label=\"The blocks of a step. Arrow keys turn, plus and minus zoom, 0 goes back.\"></canvas>\n"
            "<p><label>step <input id=\"step\" type=\"range\" min=\"1\" max=\"%ld\" step=\"1\" value=\"1\"></label>\n"
            "<output id=\"said\" for=\"step\"></output></p>\n<p>", (long)r->steps);
    if (r->moves)
        fputs("<label>as it stands <input id=\"motion\" type=\"range\" min=\"0\" max=\"1\" step=\"0.05\" value=\"0\"> "
              "as it starts to move</label>\n", out);
    fputs("<label><input id=\"labels\" type=\"checkbox\"> names</label>\n"
          "<button id=\"home\" type=\"button\">first view</button></p>\n"
          "<p>Drag, or with the picture in focus arrow keys, turn it; the wheel, + and - zoom. Grey: fixed, blue: new, amber: "
          "to be held, red: moves.</p>\n", out);
}

static void put_row(FILE *out, const run *r, int32_t k)
{
    const outcome *t = &r->outcome[k];
    fprintf(out, "<tr><td><button type=\"button\">%ld</button></td><td>", (long)k + 1);
    page_text(out, name_of(r, t->block), 60);
    fprintf(out, "</td><td>%s</td><td>", verdict_word[t->step.verdict]);
    for (int32_t i = 0; i < t->held.count; i++) {
        fputs(i ? ", " : "", out);
        page_text(out, name_of(r, t->held.block[i]), 60);
    }
    fputs("</td></tr>\n", out);
}

static int put_turning(FILE *out, const run *r)
{
    turn_step *step = zeroed((size_t)r->steps, sizeof *step);
    int good = step != NULL;
    for (int32_t k = 0; good && k < r->steps; k++) {
        const outcome *t = &r->outcome[k];
        const int how = t->step.verdict == SP_STABLE ? 0 : t->step.verdict == SP_UNSTABLE ? 1 : 2;
        const turn_step s = { t->block, t->held.count, t->moves, how, t->held.block, t->move };
        step[k] = s;
    }
    good = good && turn_write_steps(out, &r->scene, &r->options->view, r->options->remove, r->steps, step);
    free(step);
    return good;
}

/* A picture that turns, of the step that is chosen; the strip; a table of all steps. */
static int put_body(FILE *out, const void *of)
{
    const run *r = of;
    if (r->steps) put_controls(out, r);
    fputs("<div class=\"wide\">\n", out);
    if (!put_strip(out, r)) return 0;
    fprintf(out, "</div>\n<div><table id=\"steps\">\n<thead><tr><th scope=\"col\">step</th><th scope=\"col\">%s</th>"
            "<th scope=\"col\">verdict</th><th scope=\"col\">hold</th></tr></thead>\n<tbody>\n",
            r->options->remove ? "goes" : "comes");
    for (int32_t k = 0; k < r->steps; k++) put_row(out, r, k);
    fputs("</tbody></table></div>\n", out);
    return r->steps == 0 || put_turning(out, r);
}

static int put_model(FILE *out, const void *of)
{
    const run *r = of;
    model_step *step = zeroed((size_t)r->steps, sizeof *step);
    int good = step != NULL;
    for (int32_t k = 0; good && k < r->steps; k++) {
        step[k].block = r->order[k];
        step[k].move = r->outcome[k].move;
        step[k].moves = r->outcome[k].moves;
        step[k].group = r->outcome[k].step.verdict == SP_STABLE ? "stands" : r->outcome[k].step.verdict ? "falls" : "undecided";
    }
    good = good && model_write_steps(out, &r->scene, step, r->steps);
    free(step);
    return good;
}

static int draw(const run *r, failure *error)
{
    const options *o = r->options;
    const html_page page = { r->scene.path, sp_verdict_text(r->worst), put_words, put_body, r };
    int status = r->steps ? drawn_file(o->svg, put_strip, r, error) : 0;
    if (!status && r->steps) status = drawn_png(o->png, put_strip, r, error);
    if (!status) status = html_page_write(o->html, &page, error);
    if (!status) status = drawn_file(o->model, put_model, r, error);
    return status;
}

static void free_run(run *r)
{
    for (int32_t k = 0; r->outcome && k < r->steps; k++) {
        free(r->outcome[k].list);
        free(r->outcome[k].mark);
        free(r->outcome[k].move);
    }
    free(r->outcome);
    free(r->order);
    free(r->memory);
    scene_free(&r->scene);
}

int command_sequence(int argc, char **argv)
{
    failure error = { 0, "" };
    options o;
    run r;
    int status;

    memset(&r, 0, sizeof r);
    r.options = &o;
    status = options_read(argc, argv, " --json --svg --png --html --out-obj --csv --view --names"
                          " --tol --cone --stages --tilt --budget --order --order-file --remove"
                          " --suggest" SCENE_OPTIONS, &o, &error);
    if (!status && o.files != 1) status = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: sequence needs one scene");
    if (!status) status = outputs_check(&o, NULL, &error);
    if (!status) status = outputs_check_obj("--out-obj", o.model, &error);
    for (int32_t k = 0; !status && k < o.settings.stage_count; k++)
        if (o.settings.stage[k] == SP_STAGE_ADMM)
            status = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: --stages: a sequence has no stage admm");
    progress_begin(o.quiet);
    if (!status) status = scene_read(o.file[0], &o.scene, &r.scene, &error);
    if (!status) tilt_turn(o.tilt, o.azimuth, r.scene.scene.gravity);
    if (!status) status = read_order(&r, &error);
    if (!status) {
        const sp_status s = all_steps(&r);
        if (s) status = scene_refused(&r.scene, &o.settings, s, &error);
    }
    if (!status) {
        tell_dropped(&r);
        status = draw(&r, &error);                      /* the answer is told in any case */
        if (!status && o.csv) status = write_csv(&r, &error);
        if (o.json) print_json(&r);
        else print_text(&r);
        fflush(stdout);
    }
    if (status) fprintf(stderr, "%s\n", error.line);
    else status = report_exit(r.worst);
    free_run(&r);
    return status;
}
