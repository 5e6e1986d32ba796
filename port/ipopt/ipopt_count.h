/* Counts Ipopt's iterations: to be set as its intermediate callback, with user data that begin with the count, an Index. */
#ifndef STONEPACK_IPOPT_COUNT_H
#define STONEPACK_IPOPT_COUNT_H

#include <IpStdCInterface.h>

static Bool ipopt_count(Index mode, Index count, Number f, Number primal, Number dual, Number mu, Number d, Number reg,
                        Number step_d, Number step_p, Index trials, UserDataPtr user)
{
    Index *iterations = user;
    (void)mode; (void)f; (void)primal; (void)dual; (void)mu; (void)d; (void)reg; (void)step_d; (void)step_p; (void)trials;
    *iterations = count;
    return TRUE;
}

#endif
