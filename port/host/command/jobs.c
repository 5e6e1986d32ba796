#define _POSIX_C_SOURCE 200809L         /* fork, fileno */
#include "jobs.h"
#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32

int jobs_begin(int jobs, const sp_parallel **parallel, failure *error)
{
    *parallel = NULL;
    return jobs < 2 ? 0 : fail_with(error, EXIT_UNAVAILABLE, NULL, 0, "stonepack: --jobs needs POSIX");
}

void jobs_end(void) { }

int jobs_scenes(int n, int jobs, char *const *name, int (*one)(void *self, int k), void *self, int *status)
{
    (void)n, (void)jobs, (void)name, (void)one, (void)self, (void)status;
    return -1;
}

#else

#include <pthread.h>
#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

/* ------------------------------------------------------------------------------------------------------------- threads */

/* One job at a time: its tasks are taken one by one by whoever is free. */
static struct {
    pthread_mutex_t lock;               /* of all that follows */
    pthread_cond_t given, done;         /* a job, or the end; its last task */
    pthread_t thread[JOBS_MOST];
    int threads, over;
    void (*task)(void *job, int32_t k);
    void *job;                          /* NULL: there is none */
    int32_t n, next, left;              /* its tasks; the first that no one took; how many have not ended */
} pool = { .lock = PTHREAD_MUTEX_INITIALIZER, .given = PTHREAD_COND_INITIALIZER, .done = PTHREAD_COND_INITIALIZER };

/* Take tasks until none is left. The lock is held before and after, not during a task. */
static void take_tasks(void)
{
    while (pool.job && pool.next < pool.n) {
        void (*const task)(void *, int32_t) = pool.task;
        void *const job = pool.job;
        const int32_t k = pool.next++;
        pthread_mutex_unlock(&pool.lock);
        task(job, k);
        pthread_mutex_lock(&pool.lock);
        if (--pool.left == 0) pthread_cond_signal(&pool.done);
    }
}

static void *serve(void *none)
{
    pthread_mutex_lock(&pool.lock);
    while (!pool.over) {
        take_tasks();
        if (!pool.over) pthread_cond_wait(&pool.given, &pool.lock);
    }
    pthread_mutex_unlock(&pool.lock);
    return none;
}

static void run_tasks(void *self, void (*task)(void *job, int32_t k), void *job, int32_t n)
{
    (void)self;
    pthread_mutex_lock(&pool.lock);
    if (pool.job) {
        pthread_mutex_unlock(&pool.lock);
        for (int32_t k = 0; k < n; k++) task(job, k);
        return;
    }
    pool.task = task;
    pool.job = job;
    pool.n = pool.left = n;
    pool.next = 0;
    pthread_cond_broadcast(&pool.given);
    take_tasks();
    while (pool.left) pthread_cond_wait(&pool.done, &pool.lock);
    pool.job = NULL;
    pthread_mutex_unlock(&pool.lock);
}

int jobs_begin(int jobs, const sp_parallel **parallel, failure *error)
{
    static const sp_parallel threads = { run_tasks, NULL };
    *parallel = NULL;
    pool.over = 0;
    while (pool.threads < jobs - 1) {
        if (pthread_create(&pool.thread[pool.threads], NULL, serve, NULL)) {
            jobs_end();
            return fail_with(error, EXIT_UNAVAILABLE, NULL, 0, "stonepack: --jobs %d: no more threads can be started", jobs);
        }
        pool.threads++;
    }
    if (jobs > 1) *parallel = &threads;
    return 0;
}

void jobs_end(void)
{
    pthread_mutex_lock(&pool.lock);
    pool.over = 1;
    pthread_cond_broadcast(&pool.given);
    pthread_mutex_unlock(&pool.lock);
    while (pool.threads > 0) pthread_join(pool.thread[--pool.threads], NULL);
}

/* ------------------------------------------------------------------------------------------------------------- scenes */

enum { AHEAD = 4 };                     /* scenes for each job that may have ended before one in front of them has */

/* A scene's process, and what it prints. */
typedef struct scene_job {
    pid_t pid;                          /* 0: it does not run */
    FILE *out, *err;
    int status;                         /* as waitpid has it; -1: it never ran */
} scene_job;

/* returns whether it runs */
static int begin_scene(scene_job *j, int k, int (*one)(void *self, int k), void *self)
{
    j->status = -1;
    j->out = tmpfile();
    j->err = tmpfile();
    fflush(NULL);
    j->pid = j->out && j->err ? fork() : -1;
    if (j->pid == 0) {
        signal(SIGINT, SIG_IGN);                        /* whoever began it hears Ctrl-C, and waits for this one */
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGTERM);               /* but does not outlive it */
#endif
        if (dup2(fileno(j->out), STDOUT_FILENO) < 0 || dup2(fileno(j->err), STDERR_FILENO) < 0) _exit(EXIT_INTERNAL);
        const int status = one(self, k);
        _exit(fflush(stdout) ? EXIT_INTERNAL : status);
    }
    if (j->pid > 0) return 1;
    j->pid = 0;
    if (j->out) fclose(j->out);
    if (j->err) fclose(j->err);
    j->out = j->err = NULL;
    return 0;
}

/* Wait until one of `n` has ended. */
static void await_any(scene_job *job, int n)
{
    int status;
    const pid_t pid = waitpid(-1, &status, 0);
    for (int k = 0; k < n; k++) {
        if (!job[k].pid || (pid >= 0 && job[k].pid != pid)) continue;
        job[k].pid = 0;
        if (pid > 0) job[k].status = status;
    }
}

/* What a file holds, to another; then it is closed. */
static void pour(FILE *from, FILE *to)
{
    char piece[4096];
    size_t n;
    if (!from) return;
    rewind(from);
    while ((n = fread(piece, 1, sizeof piece, from)) > 0) fwrite(piece, 1, n, to);
    fclose(from);
    fflush(to);
}

/* What an ended one printed.     returns its status */
static int tell_scene(const scene_job *j, const char *name)
{
    pour(j->out, stdout);
    pour(j->err, stderr);
    if (j->status >= 0 && WIFEXITED(j->status)) return WEXITSTATUS(j->status);
    if (j->status >= 0) fprintf(stderr, "stonepack: %s: its process was ended by signal %d\n", name, WTERMSIG(j->status));
    else fprintf(stderr, "stonepack: %s: no process could be started for it\n", name);
    return EXIT_INTERNAL;
}

int jobs_scenes(int n, int jobs, char *const *name, int (*one)(void *self, int k), void *self, int *status)
{
    scene_job job[AHEAD * JOBS_MOST];
    const int room = AHEAD * jobs;
    int begun = 0, told = 0, running = 0, full = -1;            /* full: so many were told when no more could be begun */
    memset(job, 0, sizeof job);
    while (told < n && (told < begun || !progress_stopped())) {
        if (begun < n && running < jobs && begun - told < room && full < told && !progress_stopped()) {
            if (begin_scene(&job[begun % room], begun, one, self) || told == begun) begun++;
            else full = told;
        } else if (told < begun && !job[told % room].pid) {
            status[told] = tell_scene(&job[told % room], name[told]);
            told++;
        } else await_any(job, room);
        running = 0;
        for (int k = 0; k < room; k++) running += job[k].pid > 0;
    }
    return told;
}

#endif
