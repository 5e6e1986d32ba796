/* A strict reader of one JSON value (RFC 8259), into a tree. */
#ifndef STONEPACK_HOST_JSON_IN_H
#define STONEPACK_HOST_JSON_IN_H

#include "failure.h"

typedef enum json_kind { JSON_NULL, JSON_BOOL, JSON_NUMBER, JSON_STRING, JSON_ARRAY, JSON_OBJECT } json_kind;

typedef struct json_value {
    json_kind kind;
    int32_t line;
    int32_t next;               /* the next one in its array or object, -1: the last */
    int32_t first;              /* of an array or object, -1: empty */
    const char *key;            /* in an object, else NULL */
    union {
        double number;          /* 0 or 1 of a JSON_BOOL */
        const char *string;     /* UTF-8 */
    } as;
} json_value;

typedef struct json_tree {
    char *text;                 /* strings lie in it */
    json_value *value;          /* [0] is the whole */
    int32_t count, room;
} json_tree;

/* Read the first value of a file; more lines (JSON Lines) are refused.  returns 0 or an exit status; free with json_free */
int json_read(const char *path, json_tree *tree, failure *error);
int json_parse(const char *path, char *text, size_t length, json_tree *tree, failure *error);    /* text: malloc's */

/* Member of an object, or NULL. */
const json_value *json_member(const json_tree *tree, const json_value *object, const char *key);

void json_free(json_tree *tree);

#endif
