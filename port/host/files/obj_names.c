#include "obj_names.h"

#include <stdlib.h>
#include <string.h>

static int byte_of(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' ? '_' : (unsigned char)c; }

/* Blanks count as the _ that they become. */
static int compare(text_word a, text_word b)
{
    for (size_t i = 0; i < a.n && i < b.n; i++)
        if (a.s[i] != b.s[i] && byte_of(a.s[i]) != byte_of(b.s[i])) return byte_of(a.s[i]) - byte_of(b.s[i]);
    return (a.n > b.n) - (a.n < b.n);
}

typedef struct named { text_word name; int32_t block; } named;

static int compare_named(const void *pa, const void *pb)
{
    const named *a = pa, *b = pb;
    const int c = compare(a->name, b->name);
    return c ? c : (a->block > b->block) - (a->block < b->block);
}

int obj_names_sort(obj_file *f, failure *error)
{
    const size_t n = (size_t)f->blocks;
    named *sorted = malloc((n + 1) * sizeof *sorted);
    int32_t twin = -1, first = -1;

    f->by_name = malloc((n + 1) * sizeof *f->by_name);
    if (!sorted || !f->by_name) {
        free(sorted);
        return fail_with(error, EXIT_MEMORY, f->path, f->lines, "out of memory while reading");
    }
    for (int32_t b = 0; b < f->blocks; b++) {
        sorted[b].name = f->block[b].name;
        sorted[b].block = b;
    }
    qsort(sorted, n, sizeof *sorted, compare_named);
    for (int32_t i = 0; i < f->blocks; i++) {
        f->by_name[i] = sorted[i].block;
        if (i > 0 && compare(sorted[i].name, sorted[i - 1].name) == 0 && (twin < 0 || sorted[i].block < twin)) {
            twin = sorted[i].block;                     /* the earliest repetition in the file */
            first = sorted[i - 1].block;
        }
    }
    free(sorted);
    if (twin < 0) return 0;
    return fail_with(error, EXIT_SCENE, f->path, f->block[twin].line, "block " WORD_FORMAT " has the name of the one in "
                     "line %ld", WORD(f->block[twin].name), (long)f->block[first].line);
}

static int32_t find_name(const obj_file *f, text_word name)
{
    int32_t low = 0, high = f->blocks;
    while (low < high) {
        const int32_t middle = low + (high - low) / 2;
        const int c = compare(f->block[f->by_name[middle]].name, name);
        if (c == 0) return f->by_name[middle];
        if (c < 0) low = middle + 1;
        else high = middle;
    }
    return -1;
}

static int find_contact_blocks(obj_file *f, failure *error)
{
    for (int32_t i = 0; i < f->contacts; i++) {
        obj_contact *c = &f->contact[i];
        for (int side = 0; side < 2; side++) {
            const int32_t b = find_name(f, c->name[side]);
            if (b < 0)
                return fail_with(error, EXIT_SCENE, f->path, c->line, "contact with block " WORD_FORMAT
                                 ", which does not exist", WORD(c->name[side]));
            *(side ? &c->b : &c->a) = b;
        }
    }
    return 0;
}

static int find_load_blocks(obj_file *f, failure *error)
{
    for (int32_t i = 0; i < f->loads; i++) {
        obj_load *load = &f->load[i];
        load->block = find_name(f, load->name);
        if (load->block < 0)
            return fail_with(error, EXIT_SCENE, f->path, load->line, "load on block " WORD_FORMAT
                             ", which does not exist", WORD(load->name));
    }
    return 0;
}

char *obj_names_stem(const char *path, text_word *name)
{
    const char *last = path, *dot;
    for (const char *p = path; *p; p++) if (*p == '/' || *p == '\\') last = p + 1;
    if (strcmp(last, "-") == 0) last = "block";
    dot = strrchr(last, '.');
    char *stem = malloc(strlen(last) + 1);
    name->s = stem;
    name->n = dot && dot > last ? (size_t)(dot - last) : strlen(last);
    if (!stem) return NULL;
    strcpy(stem, last);
    for (size_t i = 0; i < name->n; i++) if ((unsigned char)stem[i] <= ' ' || strchr("#\\,<>\177", stem[i])) stem[i] = '_';
    return stem;
}

int obj_names_resolve(obj_file *f, failure *error)
{
    const int status = find_contact_blocks(f, error);
    return status ? status : find_load_blocks(f, error);
}
