/* constants: tolerances of the search. */
#ifndef SP__STATICS_CONSTANTS_C
#define SP__STATICS_CONSTANTS_C

#include "../base/config.c"

#ifdef SP_REAL_FLOAT
#define SP__SHIFT ((sp_real)1e-6)       /* diagonal shift that keeps a semidefinite matrix of unit size factorable */
#define SP__HELD ((sp_real)2e-3)        /* share of the load that rounding leaves where bilateral joints hold it */
#define SP__RUNS_OFF ((sp_real)0.25)    /* of a residual: where a correction leaves more, null vectors have a part in it */
#define SP__FORETELLS ((sp_real)3e-5)   /* the same: where it leaves more, that is rounding, which foretells nothing */
#define SP__PROX ((sp_real)3e-7)        /* end of the proximal path: a few roundings of the diagonal */
#define SP__DEEP ((sp_real)1e-4)        /* so far down the path proofs are tried even while the imbalance falls */
#define SP__TIE ((sp_real)2e-4)         /* where on the path rigid groups show */
#define SP__PLAY ((sp_real)1e-3)        /* motion within a group, relative */
#define SP__GAIN ((sp_real)0.9)         /* a round of balancing that leaves no less is the last: factors have few digits */
#define SP__FAR 10                      /* a Newton step that long runs off along what falls: factors may show no more of it */
#define SP__FELL_LAST 0                 /* is a motion within tol that the interior points came to the last word? */
#define SP__PATH_FELL ((sp_real)1e-3)   /* if not, start of the proximal path from there */
#define SP__HELP_LEAST ((sp_real)0.01)  /* imbalance of the penalty form that will do, at least: rounding leaves that much */
#define SP__HELP_SHIFT ((sp_real)1e-7)  /* shift of the penalty form, well below the price of tension, which makes it regular */
#define SP__HELP_MOST 12                /* factorisations of the penalty form: what takes more does not come there */
#else
#define SP__SHIFT ((sp_real)1e-13)
#define SP__HELD SP__SCALE_TOL
#define SP__RUNS_OFF ((sp_real)1e-3)
#define SP__FORETELLS 1
#define SP__PROX ((sp_real)1e-15)
#define SP__DEEP SP__SHIFT
#define SP__TIE ((sp_real)1e-8)
#define SP__PLAY ((sp_real)1e-6)
#define SP__GAIN ((sp_real)0.5)
#define SP__FAR SP__HUGE
#define SP__FELL_LAST 1
#define SP__PATH_FELL ((sp_real)0.1)
#define SP__HELP_LEAST 0
#define SP__HELP_SHIFT SP__SHIFT
#define SP__HELP_MOST 40
#endif
#define SP__CLOSE (512 * (sp_real)SP_EPSILON)   /* imbalance whose further digits are rounding, not worth a solution, */
#define SP__CLOSE_TOL ((sp_real)0.05)   /* if it is this share of tol at most: in float the former is more than a fine tol */
#define SP__ASTRAY ((sp_real)1e6)      /* slope at the end of a first step in 3 rows, relative to its start, that ends Newton */
#define SP__NEARER_STEPS 12             /* with the bilateral factor, before Newton's, */
#define SP__NEARER_FALLS 28             /* or so many where it falls */
#define SP__NEARER_LONG ((sp_real)1.8)  /* length of the first; nothing would open or slide: 1 */
#define SP__NEARER_MORE 3               /* times the last one that it may be at most */
#define SP__NEARER_NEAR ((sp_real)0.25) /* share of a step that is not corrected */
#define SP__NEARER_CLEAR ((sp_real)2e-3)        /* imbalance from which on Newton's steps are better, */
#define SP__NEARER_CLEAR3 ((sp_real)1.2e-3)     /* and in 3 rows */
#define SP__NEARER_PAYS 6               /* solutions that a factor takes the work of, at least */
#define SP__NO_START 2                  /* imbalance of forces inside the cones from which balancing does not come to any */
#define SP__RUB ((sp_real)1e-6)        /* friction of joints that have none, where a motion is looked for */
#define SP__ITERATIONS 300              /* factorisations of an exact solve, unless the caller wants others */
#define SP__PLAY_IDLE ((sp_real)0.1)    /* SP__PLAY where rounding has ended the search */
#define SP__HELP ((sp_real)1e-3)        /* imbalance of the penalty form that will do to see where help is wanted, at most */
#define SP__IPM_MOST 120                /* interior-point iterations */
#define SP__IPM_LATE ((sp_real)1e-5)    /* theta from which on a motion is worth more work than steps: the limit is near */
#define SP__IPM_KEEP ((sp_real)0.99)    /* share of the way to the boundary */
#define SP__IPM_NOWHERE ((sp_real)0.1)  /* length of a step that gets nowhere */
#define SP__BRIEF_FELL 2                /* state->brief: the search in the plane has come to a motion that was within tol */
#define SP__BRIEF_FORCES 3              /* the same: only forces are wanted, of a motion no more than that there is one */
#define SP__IPM_IDLE 8                  /* so many of them one after the other end it: rounding holds theta */
#define SP__IPM_PATIENT 24              /* with strength: steps that got nowhere are often followed by some that do */
#ifdef SP_REAL_MIXED
#define SP__IPM_LAST 0                  /* factors in float hold them, but other ways refine in double */
#else
#define SP__IPM_LAST 1                  /* where they get nowhere nothing else does */
#endif
#ifdef SP_REAL_MIXED
#define SP__IPM_NONE 0                  /* rounding ends theta long before */
#else
#define SP__IPM_NONE ((sp_real)1e-3)    /* tau that is none at the end: there are no forces */
#endif
#if defined SP_REAL_FLOAT || defined SP_REAL_MIXED
#define SP__IPM_SHIFT (16 * (sp_real)SP_EPSILON)        /* relative to each diagonal */
#else
#define SP__IPM_SHIFT ((sp_real)SP_EPSILON)     /* a mechanism 1e-6 from its limit is resisted by no more */
#endif

#endif /* SP__STATICS_CONSTANTS_C */
