/* contacts --sweep: what touches, and does it stand, at one distance after the other? */
#ifndef STONEPACK_HOST_CONTACTS_SWEEP_H
#define STONEPACK_HOST_CONTACTS_SWEEP_H

#include "options.h"

/* Print it, as a table or as JSON.     returns 0 or an exit status */
int contacts_sweep(const host_scene *scene, const options *o, failure *error);

#endif
