#include "reason.h"

const char *reason_words(sp_reason reason)
{
    switch (reason) {
    case SP_REASON_FORCES:     return "forces that the joints can carry hold every block in equilibrium";
    case SP_REASON_NOTHING:    return "nothing to carry: no free block, or no load";
    case SP_REASON_NO_CONTACT: return "a block touches nothing";
    case SP_REASON_NO_SUPPORT: return "a group of blocks has no path to a support";
    case SP_REASON_MECHANISM:  return "the blocks can move in a way that no force of the joints can resist";
    case SP_REASON_LIMIT:      return "neither forces nor a motion within tol: the limit is nearer than that";
    case SP_REASON_BUDGET:     return "the search gave up, its work spent or without progress: "
                                      "neither forces nor a motion within tol";
    case SP_REASON_STAGES:     return "the chosen stages can't decide this";
    case SP_REASON_NO_MOTION:  return "forces exist, but no virtual motion explains any of them";
    case SP_REASON_NOT_COUPLED: return "forces exist; neither a virtual motion that explains them nor a proof against one was "
                                       "found";
    case SP_REASON_TENSION:    return "the penalty form is solved, but wants tension: no proof either way";
    case SP_REASON_UNVERIFIED: return "a solver's answer did not pass verification: no forces, and no motion that proves "
                                      "anything";
    case SP_REASON_EFFECT:     return "an effect was left out that the scene calls for";
    default:                   return "";
    }
}
