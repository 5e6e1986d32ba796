/* One JSON object on one line: commas kept, strings escaped to valid UTF-8, numbers that read back as the same number. */
#ifndef STONEPACK_HOST_JSON_OUT_H
#define STONEPACK_HOST_JSON_OUT_H

#include <stdint.h>
#include <stdio.h>
#include "../../../stonepack.h"

typedef struct json_out {
    FILE *out;
    int comma;                  /* something stands before on this level */
} json_out;

/* key is NULL for what stands in an array. Brackets come in pairs: json_open(j, key, '{') ... json_close(j, '}'). */
void json_open(json_out *j, const char *key, char bracket);
void json_close(json_out *j, char bracket);
void json_string(json_out *j, const char *key, const char *s);      /* bytes that are no UTF-8 are taken as Latin-1 */
void json_real(json_out *j, const char *key, double x);             /* null where not finite */
void json_int(json_out *j, const char *key, int64_t x);
void json_bool(json_out *j, const char *key, int x);
void json_null(json_out *j, const char *key);
void json_reals(json_out *j, const char *key, const sp_real *x, int32_t n);

/* The bytes of one UTF-8 character at s (1..4), 0 if there is none. */
int json_utf8(const char *s);

#endif
