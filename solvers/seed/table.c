/* table: the specification's constants, each with its section. */
#ifndef SP__SEED_TABLE_C
#define SP__SEED_TABLE_C

#include "../base/config.c"

#if SP__WITH_LARGE

/* The seed's constants, each with its section; what a float can't reach is float's own. */
#ifdef SP_REAL_FLOAT
#define SP__SEED(d, f) ((sp_real)(f))
#else
#define SP__SEED(d, f) ((sp_real)(d))
#endif
static const sp_seed sp__seed = {
    .faces = 8, .inscribed = 1, .net = 1,                                       /* [1.4] */
    .gamma = (sp_real)1e3, .tau = (sp_real)1,                                   /* [1.5] */
    .dense_cells = 12000000,                                                    /* [1.5] */
    .tension = (sp_real)1e-3,                                                   /* [1.6] */
    .balance = SP__SEED(1e-6, 1e-5), .cone = SP__SEED(1e-7, 1e-5),              /* [2.1] */
    .gain = (sp_real)0.05, .window = 250, .rounds = 20000,                      /* [2.2] */
    .engaged = (sp_real)0.01, .floor = (sp_real)1e-9, .reg = SP__SEED(1e-9, 1e-6),                      /* [3.2] */
    .gate = (sp_real)0.5, .drop = (sp_real)0.75, .slip_error = (sp_real)2, .turns = 12,           /* [3.3] */
    .admm = {
        .backend = SP_QP_SPARSE,
        .eps_abs = (sp_real)1e-4, .eps_rel = (sp_real)1e-4,                     /* [4.2] the checker's */
        .eps_pinf = (sp_real)1e-4, .eps_dinf = (sp_real)1e-4,                   /* [4.3] */
        .radius = SP__SEED(1e6, 1e3),                                           /* ours: what a certificate must exclude */
        .iterations = 8000, .check = 10, .passes = 3,                           /* [4.2] and so on to the end */
        .sigma = SP__SEED(1e-6, 1e-3), .relax = (sp_real)1.6, .rho = (sp_real)0.1, .rho_equal = SP__SEED(1e3, 1e2),
        .adapt = 100, .adapt_most = 10, .adapt_factor = (sp_real)5, .cg_steps = 250, .cg_tol = SP__SEED(1e-10, 1e-6)
    },
    .native = {
        .backend = SP_QP_SPARSE, .eps_abs = SP__SEED(1e-6, 1e-4), .eps_rel = SP__SEED(1e-5, 1e-4),      /* [4.4] */
        .eps_pinf = (sp_real)1e-4, .eps_dinf = (sp_real)1e-4, .radius = SP__SEED(1e6, 1e3),
        .strict = 1, .polish = 1, .iterations = 6000, .check = 10, .passes = 10,                        /* [4.4] */
        .sigma = SP__SEED(1e-6, 1e-3), .relax = (sp_real)1.6, .rho = (sp_real)0.1, .rho_equal = SP__SEED(1e3, 1e2),
        .adapt = 100, .adapt_most = 10, .adapt_factor = (sp_real)5, .cg_steps = 250, .cg_tol = SP__SEED(1e-10, 1e-6)
    }
};
#undef SP__SEED

SP_API const sp_seed *sp_seed_table(void) { return &sp__seed; }

#if SP__WITH_ADMM
/* Settings of a check as the table has them. */
static void sp__seed_settings(sp_settings *s)
{
    s->tol = sp__seed.tension;
    s->faces = sp__seed.faces;
    s->inscribed = sp__seed.inscribed;
    s->penalty.net = sp__seed.net;
    s->penalty.gamma = sp__seed.gamma;
    s->penalty.tau = sp__seed.tau;
    s->seed = &sp__seed;
    s->coupled.rounds = sp__seed.turns;
    s->coupled.box = 1;                                                         /* [3.2] */
}
#endif

#elif SP__WITH_SMALL

SP_API const sp_seed *sp_seed_table(void) { return NULL; }

#if SP__WITH_ADMM
static void sp__seed_settings(sp_settings *s) { (void)s; }
#endif

#endif

#endif /* SP__SEED_TABLE_C */
