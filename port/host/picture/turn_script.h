/* The script that turns the picture of a report. */
#ifndef STONEPACK_HOST_TURN_SCRIPT_H
#define STONEPACK_HOST_TURN_SCRIPT_H

#include <stdio.h>

void turn_script(FILE *out);

#endif
