#include "outputs.h"
#include "../files/file.h"
#include "../files/meshes.h"
#include "report_csv.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { TABLES = 4, OUTPUTS = 7 + TABLES };

typedef struct output { const char *option, *path; } output;

/* What the options name; `table` has room for the tables of --csv.     returns how many */
static int list_outputs(const options *o, const char *own, char table[TABLES][REPORT_CSV_PATH], output list[OUTPUTS])
{
    static const char *const what[TABLES] = { "joints", "blocks", "steps", "tilt" };
    const output named[] = { { "convert", own }, { "--svg", o->svg }, { "--png", o->png }, { "--html", o->html },
                             { "--out-obj", o->model }, { "-o", o->out }, { "--frames", o->frames } };
    int n = 0;
    for (size_t k = 0; k < sizeof named / sizeof *named; k++)
        if (named[k].path && strcmp(named[k].path, "-")) list[n++] = named[k];
    for (int k = 0; k < TABLES && o->csv; k++) {
        const output one = { "--csv", table[k] };
        snprintf(table[k], REPORT_CSV_PATH, "%s-%s.csv", o->csv, what[k]);
        list[n++] = one;
    }
    return n;
}

static int check_input(const output *list, int n, const char *input, failure *error)
{
    for (int k = 0; input && k < n; k++)
        if (file_is_same(list[k].path, input))
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: %s would write over '%.200s', which is read",
                             list[k].option, list[k].path);
    return 0;
}

/* A scene and the file beside it. */
static int check_scene(const output *list, int n, const char *scene, int own, failure *error)
{
    char beside[REPORT_CSV_PATH];
    const int status = own ? check_input(list + 1, n - 1, scene, error) : check_input(list, n, scene, error);
    const int length = snprintf(beside, sizeof beside, "%s" OBJ_BESIDE, scene);
    return status || length < 0 || (size_t)length >= sizeof beside ? status : check_input(list, n, beside, error);
}

/* The name of a table needs more than a folder. */
static int check_table(const char *name, failure *error)
{
    const size_t n = name ? strlen(name) : 1;
    if (!name || (n && !strchr("/\\", name[n - 1]))) return 0;
    return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: --csv needs how the names of its tables begin, as %.200sNAME",
                     name);
}

int outputs_check(const options *o, const char *own, failure *error)
{
    char table[TABLES][REPORT_CSV_PATH];
    output list[OUTPUTS];
    const int n = list_outputs(o, own, table, list), first = own && strcmp(own, "-");
    int status = check_table(o->csv, error);
    if (n && !status) status = check_input(list, n, o->order_file, error);
    if (n && !status) status = check_input(list, n, o->done, error);
    for (int i = 0; n && !status && i < o->files; i++)
        if (o->file[i] != own) status = check_scene(list, n, o->file[i], first, error);
    for (int k = 0; !status && k < n; k++)
        for (int i = 0; !status && i < k; i++)
            if (file_is_same(list[i].path, list[k].path))
                status = fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: %s and %s both write '%.200s'", list[i].option,
                                   list[k].option, list[k].path);
    return status;
}

int outputs_check_obj(const char *option, const char *path, failure *error)
{
    static const char *const other[] = { "json", "svg", "png", "html", "csv", "3dm", "step", "stp", "iges", "igs", "skp",
                                         "blend", "dwg", "usd", "usdz", "vtk", "xyz", "qps" };
    const char *dot = path ? strrchr(path, '.') : NULL;
    int wrong = dot && meshes_is_known(path);
    for (size_t k = 0; dot && !wrong && k < sizeof other / sizeof *other; k++) {
        size_t i = 0;
        while (dot[i + 1] && tolower((unsigned char)dot[i + 1]) == other[k][i]) i++;
        wrong = !dot[i + 1] && !other[k][i];
    }
    return wrong ? fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: %s writes OBJ, not '%.20s'", option, dot) : 0;
}

/* The name of the file beside a scene.     returns 0: there is none, or no room for its name */
static int find_beside(const char *scene, char beside[REPORT_CSV_PATH])
{
    const int n = snprintf(beside, REPORT_CSV_PATH, "%s" OBJ_BESIDE, scene);
    FILE *there = n > 0 && n < REPORT_CSV_PATH ? fopen(beside, "rb") : NULL;
    if (there) fclose(there);
    return there != NULL;
}

int outputs_check_beside(const char *option, const char *scene, const char *path, failure *error)
{
    char read[REPORT_CSV_PATH], written[REPORT_CSV_PATH];
    if (!path || strcmp(path, "-") == 0 || !find_beside(scene, read) || !find_beside(path, written)) return 0;
    if (!file_is_same(read, written)) return 0;
    return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: %s: '%.200s' would count once more for what is written there; "
                     "write to another name", option, written);
}

void outputs_tell_beside(const char *path, remarks *told)
{
    char beside[REPORT_CSV_PATH];
    if (path && strcmp(path, "-") && find_beside(path, beside))
        remarks_add(told, NULL, "what is written will be read with %.300s, which is beside it", beside);
}
