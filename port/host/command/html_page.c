#include "../files/drawn.h"
#include "../picture/page.h"
#include "html_page.h"

#include <stdio.h>
#include <string.h>

static const char style[] =
":root { color-scheme: light dark; --ink: #222; --paper: #fcfbf8; --line: #ccc; }\n"
"@media (prefers-color-scheme: dark) { :root { --ink: #e4e2dc; --paper: #1b1c1e; --line: #555; } }\n"
"body { margin: 0 auto; padding: 1rem; max-width: 72rem; font: 16px/1.45 Helvetica, Arial, sans-serif; color: var(--ink);\n"
"  background: var(--paper); }\n"
"h1 { font-size: 1.5rem; overflow-wrap: anywhere; }\n"
"dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: 0 0 1rem; }\n"
"dt { opacity: .75; } dd { margin: 0; overflow-wrap: anywhere; }\n"
"canvas { width: 100%; height: auto; border: 1px solid var(--line); touch-action: none; cursor: grab; }\n"
"p label { margin-right: 1.2rem; white-space: nowrap; }\n"
"@media (max-width: 30rem) { p label { white-space: normal; } }\n"
":focus-visible { outline: 3px solid #2f7fd6; outline-offset: 1px; }\n"
"div { overflow-x: auto; } div > svg { min-width: 44rem; max-width: 100%; height: auto; }\n"
"div.rose > svg { min-width: 0; }\n"
"@media (max-width: 44rem) { div.wide::before { content: 'Wider than this page: move it sideways.'; display: block;\n"
"  position: sticky; left: 0; opacity: .75; } }\n"
"table { border-collapse: collapse; }\n"
"th, td { border-bottom: 1px solid var(--line); padding: .15rem .6rem; text-align: right; }\n"
"th button, td button { font: inherit; color: inherit; background: none; border: 0; text-decoration: underline; }\n";

/* What report_text says: its first line as the head, the others as terms and what is said of them. */
static void put_words(FILE *out, FILE *text)
{
    char line[1024];
    int lines = 0;
    while (fgets(line, sizeof line, text)) {
        char *said = line;
        line[strcspn(line, "\n")] = 0;
        if (lines++ == 0) {
            fputs("<h1>", out);
            page_text(out, line, 200);
            fputs("</h1>\n<dl>\n", out);
            continue;
        }
        fputs("<dt>", out);
        if (strlen(line) > 17 && line[0] == ' ') {      /* as report_row sets it */
            said = line + 17;
            for (size_t n = 16; n > 1 && line[n] == ' '; n--) line[n] = 0;
            page_text(out, line + 2, 14);
        }
        fputs("</dt><dd>", out);
        page_text(out, said, sizeof line);
        fputs("</dd>\n", out);
    }
    fputs(lines ? "</dl>\n" : "", out);
}

static void begin_page(FILE *out, const html_page *p)
{
    fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
          "<meta name=\"viewport\" content=\"width=device-width\">\n<title>", out);
    page_text(out, p->path, 100);
    fprintf(out, ": %s</title>\n<style>\n%s</style></head>\n<body>\n", p->answer, style);
}

static int put_page(FILE *out, const void *of)
{
    const html_page *p = of;
    FILE *text = tmpfile();
    int good = 0;
    if (!text) return 0;
    if (p->words(text, p->of)) {
        rewind(text);
        begin_page(out, p);
        put_words(out, text);
        good = p->body(out, p->of);
        fputs("</body></html>\n", out);
    }
    fclose(text);
    return good;
}

int html_page_write(const char *path, const html_page *p, failure *error) { return drawn_file(path, put_page, p, error); }
