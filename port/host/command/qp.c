/* qp: the least of 1/2 x'Px + q'x with l <= Ax <= u, from a QPS file. */
#include "../run.h"
#include "commands.h"
#include "../files/json_out.h"
#include "options.h"
#include "../files/qps.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ITERATIONS = 100000 };           /* more than the library's: the program may wait, and tune rho as often as it likes */

typedef struct run {
    host_qp file;
    const char *solver_name;
    sp_qp_solver solver;
    sp_qp_settings set;
    sp_qp_result result;
    void *memory;
    run_cost cost;
} run;

static int solve(run *r, const char *path, failure *error)
{
    const sp_status status = run_qp(&r->solver, &r->file.qp, &r->set, &r->result, &r->cost, &r->memory);
    return status == SP_OK ? 0 : fail_status(error, status, path, 0, "");
}

static double objective(const run *r)
{
    return (r->file.maximise ? -1 : 1) * (double)r->result.objective + r->file.constant;
}

static int has_point(const run *r)
{
    return r->result.status != SP_QP_PRIMAL_INFEASIBLE && r->result.status != SP_QP_DUAL_INFEASIBLE;
}

static void print_text(const run *r)
{
    const sp_qp_result *a = &r->result;
    printf("%s", sp_qp_status_text(a->status));
    if (has_point(r)) printf(", objective %.10g", objective(r));
    else printf(", certificate good up to radius %.2g", (double)a->radius);
    printf("\n%ld column%s, %ld row%s, %ld entries, %ld of P\n", (long)r->file.qp.n, text_s(r->file.qp.n), (long)r->file.rows,
           text_s(r->file.rows), (long)r->file.entries, (long)r->file.qp.Pp[r->file.qp.n]);
    if (has_point(r))
        printf("residuals: primal %.2g, dual %.2g, gap %.2g%s\n", (double)a->primal, (double)a->dual, (double)a->gap,
               a->polished ? ", polished" : "");
    printf("%ld iteration%s, %ld factorisation%s, ", (long)a->iterations, text_s(a->iterations), (long)a->factorisations,
           text_s(a->factorisations));
    if (a->flops) printf("%.3g flops, %.3g s, %.4g MB\n", (double)a->flops, r->cost.seconds, 1e-6 * (double)r->cost.bytes);
    else printf("%.3g s, by %s\n", r->cost.seconds, r->solver_name);         /* others don't count, their memory is their own */
}

static void print_json(const run *r, const char *path)
{
    const sp_qp_result *a = &r->result;
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "file", path);
    json_string(&j, "solver", r->solver_name);
    json_string(&j, "status", sp_qp_status_text(a->status));
    if (has_point(r)) json_real(&j, "objective", objective(r));
    else json_null(&j, "objective");
    json_real(&j, "constant", r->file.constant);
    json_real(&j, "primal", (double)a->primal);
    json_real(&j, "dual", (double)a->dual);
    json_real(&j, "gap", (double)a->gap);
    json_real(&j, "radius", (double)a->radius);
    json_bool(&j, "polished", a->polished);
    json_int(&j, "columns", r->file.qp.n);
    json_int(&j, "rows", r->file.rows);
    json_int(&j, "entries", r->file.entries);
    json_int(&j, "iterations", a->iterations);
    json_int(&j, "factorisations", a->factorisations);
    json_int(&j, "flops", a->flops);
    json_real(&j, "seconds", r->cost.seconds);
    json_int(&j, "memory_bytes", (int64_t)r->cost.bytes);
    json_reals(&j, "x", a->x, r->file.qp.n);
    json_close(&j, '}');
    fputc('\n', stdout);
}

/* 0 solved, 1 proved to have no solution, 2 not decided. */
static int exit_status(sp_qp_status status)
{
    if (status == SP_QP_SOLVED) return 0;
    return status == SP_QP_PRIMAL_INFEASIBLE || status == SP_QP_DUAL_INFEASIBLE ? 1 : 2;
}

int command_qp(int argc, char **argv)
{
    failure error = { 0, "" };
    options o;
    run r;
    int status;

    memset(&r, 0, sizeof r);
    status = options_read(argc, argv, " --json --eps --backend --solver ", &o, &error);
    if (!status && o.files != 1) status = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: qp needs one QPS file");
    if (!status) status = qps_read(o.file[0], &r.file, &error);
    r.set = sp_qp_default();
    r.solver_name = o.solver_asked ? o.solver_name : "interior";
    r.solver = o.solver_asked ? o.solver : sp_qp_interior();
    r.set.iterations = ITERATIONS;
    r.set.adapt_most = ITERATIONS;
    r.set.adapt_factor = 2;
    if (!status && o.eps > 0) r.set.eps_abs = r.set.eps_rel = o.eps;
    if (!status) r.set.backend = (sp_qp_backend)o.backend;
    if (!status && r.file.integers > 0)
        fprintf(stderr, "%s: warning: %ld integer columns are taken as real\n", o.file[0], (long)r.file.integers);
    if (!status) status = solve(&r, o.file[0], &error);
    if (!status) {
        if (o.json) print_json(&r, o.file[0]);
        else print_text(&r);
        status = exit_status(r.result.status);
    }
    if (error.status) fprintf(stderr, "%s\n", error.line);
    free(r.memory);
    qps_free(&r.file);
    return status;
}
