#include "manual.h"

#include <string.h>

/* ---------------------------------------------------------------------------------------------------- reading a help text */

static const char *line_end(const char *s) { return s + strcspn(s, "\n"); }
static const char *next_line(const char *s) { return *line_end(s) ? line_end(s) + 1 : line_end(s); }
static int is_option(const char *s) { return strncmp(s, "  -", 3) == 0; }
static int goes_on(const char *s) { return strncmp(s, "   ", 3) == 0; }

/* The end of what stands before two spaces, or of the line. */
static const char *column_end(const char *s)
{
    const char *end = line_end(s);
    while (s < end && !(s[0] == ' ' && s[1] == ' ')) s++;
    return s;
}

static const char *skip_spaces(const char *s)
{
    while (*s == ' ') s++;
    return s;
}

/* A name of an option in a line that tells some, and its value behind it, if any.     returns where to go on, NULL: no more */
typedef struct option_word { const char *name, *value; int n, m; } option_word;

static const char *next_option(const char *at, const char *end, option_word *w)
{
    while (at < end && !(*at == '-' && at[-1] == ' ')) at++;
    if (at >= end) return NULL;
    w->name = at;
    w->n = (int)strcspn(at, " ,\n");
    w->value = at + w->n;
    w->m = 0;
    if (w->value[0] == ' ' && w->value + 1 < end && w->value[1] >= 'A' && w->value[1] <= 'Z') {
        w->value++;
        w->m = (int)strcspn(w->value, " \n");
    }
    return at + w->n;
}

/* What one line of options says: its text up to a default, over the lines it goes on in. */
typedef void (*put_char)(FILE *out, char c);

static void put_line(FILE *out, const char *s, const char *end, put_char put)
{
    while (s < end) put(out, *s++);
}

static void put_text(FILE *out, const char *line, put_char put)
{
    const char *s = skip_spaces(column_end(line + 2));
    for (;;) {
        const char *end = column_end(s);
        put_line(out, s, end, put);
        if (*skip_spaces(end) != '\n' && *skip_spaces(end)) {
            fputs(" (default: ", out);
            put_line(out, skip_spaces(end), line_end(end), put);
            fputc(')', out);
        }
        line = next_line(line);
        if (!goes_on(line)) return;
        s = skip_spaces(line);
        fputc(' ', out);
    }
}

/* --------------------------------------------------------------------------------------------------------------------- man */

static void put_roff(FILE *out, char c)
{
    if (c == '\\' || c == '-') fputc('\\', out);
    fputs(c == '\\' ? "e" : c == '\'' ? "\\(aq" : "", out);
    if (c != '\\' && c != '\'') fputc(c, out);
}

static void man_head(FILE *out, const char *line)
{
    fputs(".TP\n\\fB", out);
    put_line(out, line + 2, column_end(line + 2), put_roff);
    fputs("\\fR\n", out);
}

/* The text of a command: its usage as it stands, options as a list, the rest filled. */
static void man_text(FILE *out, const char *s)
{
    int listed = 0;
    for (; *s; s = next_line(s)) {
        if (is_option(s)) {
            man_head(out, s);
            put_text(out, s, put_roff);
            listed = 1;
        } else if (goes_on(s) && listed) continue;
        else if (*s == '\n') {
            fputs(".PP", out);
            listed = 0;
        } else {
            if (listed) fputs(".PP\n", out);
            listed = 0;
            fputs("\\&", out);
            put_line(out, s, line_end(s), put_roff);
        }
        fputc('\n', out);
    }
}

static void man_usage(FILE *out, const manual_entry *e)
{
    const char *s = e->help;
    fputs(".nf\n", out);
    for (; *s && *s != '\n'; s = next_line(s)) {
        fputs("\\fB", out);
        put_line(out, s, line_end(s), put_roff);
        fputs("\\fR\n", out);
    }
    fputs(".fi\n.PP\n", out);
    man_text(out, *s ? s + 1 : s);
}

static void write_man(FILE *out, const manual_entry *entry, int entries, const char *scene_lines)
{
    const char *more = NULL;
    fputs(".TH STONEPACK 1\n.SH NAME\nstonepack \\- decides whether an assembly of rigid blocks stands\n.SH SYNOPSIS\n"
          "\\fBstonepack\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] \\fISCENE\\fR...\n.SH COMMANDS\n", out);
    for (int k = 0; k < entries; k++) {
        fprintf(out, ".SS %s: %s\n", entry[k].name, entry[k].summary);
        man_usage(out, &entry[k]);
        if (entry[k].more) more = entry[k].more;
    }
    fputs(".SH OPTIONS OF EVERY COMMAND WITH A SCENE\n", out);
    if (more) man_text(out, more);
    fputs(".SH SCENE FILES\nA scene is a Wavefront OBJ file. Lines it may hold:\n.PP\n.nf\n", out);
    for (const char *s = scene_lines; *s; s++) put_roff(out, *s);
    fputs(".fi\n", out);
}

/* -------------------------------------------------------------------------------------------------------------- completions */

/* Options that take one of a few words, or such a word as well as others. */
static const char *const words_of[][2] = {
    { "--unit", "mm cm m in" }, { "--up", "x y z -x -y -z" }, { "--view", "front side top" }, { "--fixed", "lowest ground" },
    { "--preset", "quick standard precise seed" }, { "--sliding", "real" },
};
enum { WORDED = sizeof words_of / sizeof *words_of };

static void bash_options(FILE *out, const char *s)
{
    option_word w;
    for (; s && *s; s = next_line(s))
        for (const char *at = s + 2; is_option(s) && (at = next_option(at, column_end(s + 2), &w)) != NULL; )
            fprintf(out, " %.*s", w.n, w.name);
}

static void write_bash(FILE *out, const manual_entry *entry, int entries)
{
    fputs("# bash completion of stonepack\n_stonepack()\n{\n    local word=${COMP_WORDS[COMP_CWORD]} list=\n    COMPREPLY=()\n"
          "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n        list='", out);
    for (int k = 0; k < entries; k++) fprintf(out, "%s ", entry[k].name);
    fputs("--help --version'\n    elif [ \"${word#-}\" != \"$word\" ]; then\n        case ${COMP_WORDS[1]} in\n", out);
    for (int k = 0; k < entries; k++) {
        fprintf(out, "            %s) list='", entry[k].name);
        bash_options(out, entry[k].help);
        bash_options(out, entry[k].more);
        fputs(" --help' ;;\n", out);
    }
    fputs("        esac\n    else\n        case ${COMP_WORDS[COMP_CWORD-1]} in\n", out);
    for (int k = 0; k < WORDED; k++) fprintf(out, "            %s) list='%s' ;;\n", words_of[k][0], words_of[k][1]);
    fputs("        esac\n    fi\n    if [ -n \"$list\" ]; then COMPREPLY=($(compgen -W \"$list\" -- \"$word\"))\n"
          "    else COMPREPLY=($(compgen -f -- \"$word\"))\n    fi\n}\ncomplete -o filenames -F _stonepack stonepack\n", out);
}

/* Inside '[...]' of _arguments. */
static void put_zsh(FILE *out, char c)
{
    if (c == '\'') fputs("'\\''", out);
    else {
        if (c == '[' || c == ']' || c == '\\') fputc('\\', out);
        fputc(c, out);
    }
}

/* What may stand behind an option: a file, one of some words, anything. */
static void put_values(FILE *out, const option_word *w)
{
    for (int k = 0; k < WORDED; k++)
        if (strncmp(w->name, words_of[k][0], (size_t)w->n) == 0 && strlen(words_of[k][0]) == (size_t)w->n) {
            fprintf(out, ":(%s)", words_of[k][1]);
            return;
        }
    fputs(strncmp(w->value, "FILE", 4) == 0 ? ":_files" : ": ", out);
}

static void zsh_options(FILE *out, const char *s)
{
    option_word w;
    for (; s && *s; s = next_line(s))
        for (const char *at = s + 2; is_option(s) && (at = next_option(at, column_end(s + 2), &w)) != NULL; ) {
            fprintf(out, " \\\n            '*%.*s[", w.n, w.name);
            put_text(out, s, put_zsh);
            fputc(']', out);
            if (w.m) {
                fputc(':', out);
                for (int i = 0; i < w.m; i++) put_zsh(out, w.value[i] == ':' ? ' ' : w.value[i]);
                put_values(out, &w);
            }
            fputc('\'', out);
        }
}

static void write_zsh(FILE *out, const manual_entry *entry, int entries)
{
    fputs("#compdef stonepack\nlocal context state line\n_arguments -C '1: :->command' '*:: :->rest'\ncase $state in\n"
          "    command)\n        local -a commands=(", out);
    for (int k = 0; k < entries; k++) {
        fprintf(out, "\n            '%s:", entry[k].name);
        for (const char *s = entry[k].summary; *s; s++) put_zsh(out, *s);
        fputc('\'', out);
    }
    fputs(")\n        _describe command commands ;;\n    rest)\n        case $line[1] in\n", out);
    for (int k = 0; k < entries; k++) {
        fprintf(out, "        %s) _arguments", entry[k].name);
        zsh_options(out, entry[k].help);
        zsh_options(out, entry[k].more);
        fputs(" \\\n            '--help[tells more]' '*:file:_files' ;;\n", out);
    }
    fputs("        esac ;;\nesac\n", out);
}

int manual_write(FILE *out, const char *kind, const manual_entry *entry, int entries, const char *scene_lines)
{
    if (strcmp(kind, "man") == 0) write_man(out, entry, entries, scene_lines);
    else if (strcmp(kind, "bash") == 0) write_bash(out, entry, entries);
    else if (strcmp(kind, "zsh") == 0) write_zsh(out, entry, entries);
    else return 0;
    return 1;
}
