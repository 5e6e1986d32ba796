#define _POSIX_C_SOURCE 200809L         /* isatty, sigaction */
#include "../clock.h"
#include "progress.h"

#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define LONG_WORK 1.0                   /* [s] from then on a check is told of */
#define OFTEN     0.1                   /* [s] between two lines */

static int telling, told;
static volatile sig_atomic_t stopped;

void progress_begin(int quiet) { telling = !quiet && isatty(STDERR_FILENO); }

void progress_show(const char *format, ...)
{
    va_list args;
    if (!telling) return;
    fputs("\r\033[K", stderr);
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    told = 1;
}

void progress_end(void)
{
    if (told) fputs("\r\033[K", stderr);
    told = 0;
}

/* ------------------------------------------------------------------------------------------------------------ a check */

typedef struct watcher {
    char what[80];
    double since, last;
    const char *stage;
    int32_t factorisations, before;     /* of this stage; of those before it */
} watcher;

static void watch_step(void *self, sp_stage_id stage, const sp_cost *cost)
{
    watcher *w = self;
    const double t = now();
    if (stage) w->stage = sp_stage_text(stage);
    if (stage || cost->factorisations < w->factorisations) w->before += w->factorisations;
    w->factorisations = cost->factorisations;
    if (t - w->since < LONG_WORK || t - w->last < OFTEN) return;
    w->last = t;
    const long n = (long)w->before + w->factorisations;
    progress_show("%s: %s, %ld factorisation%s, %.1f s ...", w->what, w->stage, n, n == 1 ? "" : "s", t - w->since);
}

const sp_watch *progress_watch(const char *what)
{
    static watcher one;
    static const sp_watch watch = { watch_step, &one };
    if (!telling) return NULL;
    memset(&one, 0, sizeof one);
    snprintf(one.what, sizeof one.what, "%s", what);
    one.stage = "";
    one.since = now();
    return &watch;
}

/* ------------------------------------------------------------------------------------------------------------- Ctrl-C */

static void hear(int signal)
{
    static const char text[] = "\nstopping after this one; Ctrl-C once more ends at once\n";
    (void)signal;
    stopped = 1;
    if (write(STDERR_FILENO, text, sizeof text - 1) < 0) return;
}

#ifdef _WIN32                           /* there a handler is heard once by itself */
void progress_once(void (*heard)(int signal)) { signal(SIGINT, heard); }
#else
void progress_once(void (*heard)(int signal))
{
    struct sigaction once;
    memset(&once, 0, sizeof once);
    once.sa_handler = heard;
    once.sa_flags = SA_RESETHAND | SA_RESTART;
    sigemptyset(&once.sa_mask);
    sigaction(SIGINT, &once, NULL);
}
#endif

void progress_hear(void) { progress_once(hear); }

int progress_stopped(void) { return stopped; }
