/* stonepack.c: the spine. `cc -O2 -ffp-contract=off -c stonepack.c` is the whole build: it includes every part of solvers/,
 * in this order. Folders are floors: a part includes only parts of its own folder and of folders earlier in this list
 * (tests/checks/floors.sh holds that), private functions are static and defined before they are used.
 *
 * The story, as sp_check lives it:
 *
 *   scene/      A scene is blocks, joints between them and loads. It is made into a problem: rows of equilibrium about the
 *               centroids of the free blocks, Aeq f + p = 0, and a friction cone K for the force f at each contact vertex.
 *   statics/    The search. The shortest force in the cones that balances p is f = P_K(Aeq' y) for the y that minimises
 *               D(y) = 1/2 |P_K(Aeq' y)|^2 + p . y, with 6 unknowns a block: semismooth Newton, and interior points where that
 *               stalls. Where no such f exists y runs off along a collapse mechanism dq = -y.
 *   proof/      The certificate check. It takes the forces, or the motion, that a search proposes, the scene, and a first guess
 *               of f0 that it checks; projection and sums are its own. Only what it accepts becomes a verdict.
 *   check/      Settings, islands and the stages in order (sp__stage_calls in settings.c); what sp_check and sp_verify return.
 *   coupled/    Is there also a motion that explains the forces?          limit/      How much more load until it falls?
 *   sequence/   Does it stand at every step of a build order?             memory/     How many bytes does a call take?
 *   small/      With SP_SMALL: sp_check by one short search (small/check.c), on which limits and build orders run, too.
 *   seed/       The specification's own way: its table of constants, polish, penalty program; equations in seed/README.md.
 *
 * Symbols                       code            shape                           unit
 *   f; Aeq; p                   f; -; p         3 per vertex; 6b x 3v; 6b       N; 1 and m; N and N m
 *   delta q; u = -delta d       dq; u           6 per block; 3 per vertex       m and rad; m
 *   y, the dual of Aeq f + p    y = -dq         6b
 *   K, P_K, mu                  cone, project   cone of a vertex, nearest point
 *   b, v                        blocks, points  free blocks, contact vertices
 * A row of a block is (Fx Fy Fz Mx My Mz) about its centroid, a force (fn, ft1, ft2) acts on B, fn > 0 presses.
 *
 * Words
 *   f0          the bilateral force: joints may pull and slide as they like; least imbalance, then least norm
 *   sbar, Sbar  what a block's imbalance of force, of moment, is measured by: its load, and what f0 puts on it
 *   cap         the largest force at a corner that a proof counts with (force_cap): force_bound times its blocks' lesser sbar
 *   certifier   the certificate check at work: the scene it checks against, its scales and scratch
 *   metric      weights of contacts in |f|^2 by which a pebble beside a cathedral is not lost
 *   triple      forces, motion and friction per slip (f, dq, alpha) of the coupled check
 *   CRA         coupled rigid-block analysis: the coupled check, as in SP_NO_CRA and sp__cra
 *   island      free blocks that touch each other, directly or through others; supports do not join them
 *   forest      joints that close no loop between blocks
 *   stage       one way to look for forces or a motion; it proposes, the certificate check decides
 *
 * Sources: [seed n] is section n of the specification, retold in solvers/seed/README.md; [departure n] is where the library
 *   does something else, numbered in solvers/README.md. The others by name:
 *   Kao, Iannuzzo, Thomaszewski, Coros, Van Mele, Block 2022, Computer-Aided Design 146:103216; Heyman 1966; Qi, Sun 1993,
 *   Math. Programming 58; Rockafellar 1976, SIAM J. Control Optim. 14; Amestoy, Davis, Duff 1996, SIAM J. Matrix Anal. 17;
 *   Hestenes, Stiefel 1952; Stiefel 1955; Dekker 1971, Numer. Math. 18; Davis 2006, Direct Methods for Sparse Linear Systems;
 *   George, Liu 1981, Computer Solution of Large Sparse Positive Definite Systems.
 */
#include "stonepack.h"

#include "solvers/base/config.c"                /* what is built, from the switches; attributes of functions */
#include "solvers/base/arena.c"                 /* memory handed out by offsets from an aligned base */
#include "solvers/base/real.c"                  /* numbers, and what is one */
#include "solvers/base/vectors.c"               /* sums and products of vectors of any length, quotients that stay in range */
#include "solvers/base/vec3.c"                  /* vectors of three */
#include "solvers/base/sort.c"                  /* heap sort of numbers 0..n-1 by a rule of the caller's */
#include "solvers/base/groups.c"                /* groups by union-find */
#include "solvers/base/words.c"                 /* what enumerators are called */

#include "solvers/linear/order.c"               /* a fill-reducing elimination order of an undirected graph */
#include "solvers/linear/csc.c"                 /* a sparse matrix by columns from its entries in any order */
#include "solvers/linear/envelope.c"            /* Cholesky factor of a sparse matrix kept row by row from its first entry */
#include "solvers/linear/chol.c"                /* Cholesky factor of a dense symmetric positive matrix, A = L L' */
#include "solvers/linear/bchol.c"               /* Cholesky factors of a sparse symmetric matrix of 6 x 6 blocks, A = L L' */
#include "solvers/linear/ldl.c"                 /* factors of a sparse quasi-definite matrix, K = L D L' */
#include "solvers/linear/cg.c"                  /* conjugate gradients, preconditioned by the diagonal */
#include "solvers/linear/lp.c"                  /* is there an x within bounds of its rows and its own? */
#include "solvers/linear/simplex.c"             /* and the least of a sum of costs, from any point within its bounds */
#include "solvers/linear/band.c"                /* a band without symmetry, by elimination with row exchanges */

#include "solvers/qp/ruiz.c"                    /* scales that bring every row and column of the KKT matrix near 1 */
#include "solvers/qp/qp.c"                      /* a quadratic program, a point of it, and how good that point is */
#include "solvers/qp/kkt_cg.c"                  /* the matrix-free back end: conjugate gradients */
#include "solvers/qp/kkt.c"                     /* the linear system of every iteration, three ways */
#include "solvers/qp/sharpen.c"                 /* a vector near a proof that there is no solution made one that proves more */
#include "solvers/qp/certificate.c"             /* proofs that a quadratic program has no solution */
#include "solvers/qp/auglag.c"                  /* the last digits of a quadratic program by the method of multipliers */
#include "solvers/qp/admm.c"                    /* the alternating direction method of multipliers, and the public calls */
#include "solvers/qp/dykstra.c"                 /* alternating projections, the specification's first solver */

#ifndef SP_QP_ONLY

#include "solvers/geometry/local.c"             /* polygons seen from one of their points */
#include "solvers/geometry/hull.c"              /* convex hull of points in a plane, and how far inside it a point lies */
#include "solvers/geometry/clip.c"              /* what two plane regions have in common, as simple polygons */
#include "solvers/geometry/convex.c"            /* the common part of two convex polygons, for the smallest build */

#include "solvers/cone/pyramids.c"              /* face directions of a K-sided friction pyramid, without trigonometry */
#include "solvers/cone/cone.c"                  /* nearest point of a friction cone, and the derivative of that map */
#include "solvers/cone/ipm.c"                   /* what interior points need of a cone: scaling, steps to the boundary */

#include "solvers/scene/scene.c"                /* room for blocks, joints and loads in an arena */
#include "solvers/scene/mesh.c"                 /* volume and centroid; is it closed, does it look outward? */
#include "solvers/scene/block.c"                /* adding stones and supports */
#include "solvers/scene/joint.c"                /* adding joints: frames, strength; forces, couples, weights, pressures */
#include "solvers/scene/problem.c"              /* a scene made ready: rows, lever arms, loads */
#include "solvers/scene/part.c"                 /* some blocks of a scene as a problem of their own; islands */
#include "solvers/scene/inertia.c"              /* mass and inertia of the blocks, and what a force gives them */
#include "solvers/scene/matrix.c"               /* Aeq and Afr by entries [seed 1.1, 1.2, 1.4] */
#include "solvers/scene/place.c"                /* placing a stone: support, seats, resting faces, next-best-object gate */

#include "solvers/contacts/touch.c"             /* what the search for contacts knows; its settings */
#include "solvers/contacts/face.c"              /* the plane of a face, boxes of faces */
#include "solvers/contacts/patch.c"             /* faces of a block that lie in one plane, merged into patches */
#include "solvers/contacts/small_patch.c"       /* the same in the smallest build: each face a patch */
#include "solvers/contacts/body.c"              /* box, noise and patches of a block */
#include "solvers/contacts/overlap.c"           /* how deep two blocks overlap */
#include "solvers/contacts/pair.c"              /* tolerances of two blocks, the plane they are compared in */
#include "solvers/contacts/memory.c"            /* what the search takes from an arena */
#include "solvers/contacts/polygon.c"           /* the polygons that two blocks share, patch against patch */
#include "solvers/contacts/frame.c"             /* axes along which few boxes of blocks overlap */
#include "solvers/contacts/sweep.c"             /* a tree of boxes finds the blocks that are near each other */
#include "solvers/contacts/small_pair.c"        /* the same in the smallest build: hulls, every pair of blocks */
#include "solvers/contacts/find.c"              /* what touches what, over the whole scene */

#include "solvers/proof/scale.c"                /* f0 and what each block's imbalance is measured by */
#include "solvers/proof/forces.c"               /* what forces prove, and what a motion proves */
#include "solvers/proof/moving.c"               /* what pressure alone proves, and what moves for all that friction does */
#include "solvers/proof/sliding.c"              /* a state in which a scene slides, its joints without dilatancy */
#include "solvers/proof/still.c"                /* what a tree of multipliers proves: whatever friction does, nothing moves */
#include "solvers/proof/shear.c"                /* the same of friction in proportion to pressure, where joints close no loop */
#include "solvers/proof/triple.c"               /* what forces, motion and slip of a coupled check prove */
#include "solvers/proof/refute.c"               /* what a tree of multipliers proves: no triple exists */

#include "solvers/statics/constants.c"          /* tolerances of the search */
#include "solvers/statics/mirror.c"             /* planar and level scenes: which 3 rows a block are enough */
#include "solvers/statics/system.c"             /* the dual D(y): its unknowns, weights and settings */
#include "solvers/statics/motion.c"             /* rates at contact vertices of a motion, and forces gathered to blocks */
#include "solvers/statics/wedge.c"              /* a vertex of a search in 3 rows a block: fn and one slip */
#include "solvers/statics/map.c"                /* from blocks to a contact's vertices and back, two kernels behind one face */
#include "solvers/statics/gradient.c"           /* the forces of y, and the gradient of D */
#include "solvers/statics/hessian.c"            /* the Hessian of D, block by block */
#include "solvers/statics/factor.c"             /* its factor, and what it solves */
#include "solvers/statics/size.c"               /* what imbalances are measured by, as the search sees it */
#include "solvers/statics/lift.c"               /* from 3 rows a block to 6 and back */
#include "solvers/statics/open.c"               /* making the system in an arena */
#include "solvers/statics/gates.c"              /* no contact, no support, no load */
#include "solvers/statics/bilateral.c"          /* the bilateral force: least squares [seed 2.1] */
#include "solvers/statics/line.c"               /* line search, proofs on the way */
#include "solvers/statics/rigid.c"              /* rigid groups: joints that do not open tie blocks together */
#include "solvers/statics/newton.c"             /* semismooth Newton, proximal path */
#include "solvers/statics/interior.c"           /* interior points, where Newton stalls */
#include "solvers/statics/exact.c"              /* the exact stage: its run, in 6 rows a block or in 3 */
#include "solvers/statics/penalty.c"            /* the penalty form: where help is wanted [seed 1.5] */

#include "solvers/seed/table.c"                 /* the seed's constants, one table */
#include "solvers/seed/stages.c"                /* least squares as a stage, sparse and dense [seed 2.1] */
#include "solvers/seed/polish.c"                /* alternating projections [seed 2.2] */
#include "solvers/seed/program.c"               /* the penalty form as a quadratic program [seed 1.5, 4] */

#include "solvers/coupled/decide.c"             /* branch and bound over the states of joints */
#include "solvers/coupled/point.c"              /* a triple looked for by cases */
#include "solvers/coupled/springs.c"            /* the search: springs at pressing joints, drag at slipping ones */
#include "solvers/coupled/offer.c"              /* triples made of forces and a motion, to be judged */
#include "solvers/coupled/held.c"               /* motions with joints held fast */
#include "solvers/coupled/search.c"             /* rounds of the search */
#include "solvers/coupled/help.c"               /* where help is wanted so that a motion explains the forces */
#include "solvers/coupled/alternate.c"          /* the seed's alternation [seed 3] */
#include "solvers/coupled/open.c"               /* what a coupled check needs, in an arena */
#include "solvers/coupled/forest.c"             /* joints that form a forest: the triple without a search */
#include "solvers/coupled/coupled.c"            /* the coupled check's run */

#include "solvers/check/parts.c"                /* into how many islands a check takes a scene apart */
#include "solvers/check/settings.c"             /* settings, resolved against the scene; which function is which stage */
#include "solvers/check/memory.c"               /* what a check keeps, and what its stages need */
#include "solvers/check/ladder.c"               /* one stage after the other, and the judgement of each */
#include "solvers/check/read.c"                 /* resultants of joints and blocks */
#include "solvers/check/extremes.c"             /* extremes of a force state, the weakest joint */
#include "solvers/check/one.c"                  /* the check of one part */
#include "solvers/check/islands.c"              /* the check of all islands, one after the other */
#include "solvers/check/check.c"                /* how a check begins, goes on and ends */
#include "solvers/check/verify.c"               /* sp_verify */
#include "solvers/check/plan.c"                 /* sp_plan: which effects a scene calls for, and what that saves */

#include "solvers/small/check.c"                /* sp_check, sp_plan by the smallest search */

#include "solvers/limit/bracket.c"              /* what proves each end of the bracket */
#include "solvers/limit/falls.c"                /* does a motion fall at a multiple, and at every larger one? */
#include "solvers/limit/exact.c"                /* the exact stage as the engine that a limit asks */
#include "solvers/limit/small_engine.c"         /* the smallest search as that engine */
#include "solvers/limit/verify.c"               /* sp_limit_verify: every end that a claim has */
#include "solvers/limit/newton.c"               /* the bracket, by Newton's method on the power balance */
#include "solvers/limit/interior.c"             /* interior points in forces, motion and multiplier at once */
#include "solvers/limit/strong.c"               /* joints with strength: Newton's method with the multiplier in it */
#include "solvers/limit/start.c"                /* both ends by these quick ways */
#include "solvers/limit/small_start.c"          /* no such ways, in the smallest build */
#include "solvers/limit/limit.c"                /* sp_limit: both ends, what they say, and from where on it stands */
#include "solvers/limit/joints.c"               /* hinges and sliding joints of a motion */

#include "solvers/strong/sweep.c"               /* contact forces and accelerations, by sweeps over the corners */
#include "solvers/strong/starts.c"              /* from many starts: is there a motion that friction does not hinder? */
#include "solvers/strong/cases.c"               /* cases of sticking and slipping, a linear program each */
#include "solvers/strong/strong.c"              /* sp_strong: pressure alone, then a motion; sp_strong_verify */

#include "solvers/sliding/plane.c"              /* a planar scene in 3 rows a block */
#include "solvers/sliding/push.c"               /* a history: live loads pushed on until forces stay as they are */
#include "solvers/sliding/descend.c"            /* from its end to an exact state at a lower multiple */
#include "solvers/sliding/sliding.c"            /* sp_sliding: limits without dilatancy; sp_sliding_verify */

#include "solvers/sequence/state.c"             /* a build order under way */
#include "solvers/sequence/part.c"              /* some blocks of what is there, as a part */
#include "solvers/sequence/local.c"             /* forces of the step before, changed near the change only */
#include "solvers/sequence/steps.c"             /* a step: what came, went or is held */
#include "solvers/sequence/hold.c"              /* the smallest sets of blocks to hold */
#include "solvers/sequence/next.c"               /* may a stone come, or go, next, and would all stand then? */
#include "solvers/sequence/small_steps.c"        /* all of that in the smallest build: each step one check */
#include "solvers/sequence/calls.c"              /* the public calls, over either */

#include "solvers/memory/memory.c"              /* sp_memory: what a call takes */

#if SP__WITH_LARGE                                      /* SP_SMALL: sp_check is in small/check.c */

/* Does it stand? Part by part: islands one after the other, or the whole as one. The stages propose forces or a motion, each is
 * certified as it comes; where that is asked a motion that explains the forces is looked for, too. What the islands gave is
 * certified once more, on the whole. The result keeps its arrays in the arena, all else is given back. */
SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result)
{
    sp_status status = sp__check_arguments(scene, settings, arena, result);
    if (status) return status;
    sp_arena a = *arena;
    sp__check *whole = NULL, *part = NULL;
    sp__island_loop *islands = NULL;                    /* NULL: the whole is the only part */
    status = sp__check_begin(scene, settings, &a, &whole, &islands);
    for (int32_t k = 0; !status && sp__check_more(islands, whole, k); k++) {
        status = sp__check_part(scene, islands, k, whole, &a, &part);
        if (!status && part->pb.blocks) status = sp__run_stages(&part->pb, &part->set, &part->state, &a, &part->r);
        if (!status && part->set.coupled.asked) status = sp__run_coupled(part, &a);
        if (!status && islands) sp__island_loop_collect(islands, part, whole, &a);
    }
    if (!status && islands) status = sp__islands_certify(scene, islands, whole, &a);
    if (status) return status;
    sp__check_close(scene, whole);
    whole->r.spent.peak_bytes = arena->peak = a.peak;
    arena->used = whole->r.coupled.proof.nodes ? whole->kept : whole->arrays;
    *result = whole->r;
    return SP_OK;
}

#endif

#endif /* SP_QP_ONLY */
