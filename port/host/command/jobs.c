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

#include <errno.h>
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
    int status;                         /* as waitpid has it; -1: not known */
} scene_job;

static void ignore(int signal) { (void)signal; }

/* Ctrl-C is heard by whoever began this process, and waits for it; once more ends both. */
static void child_signals(void)
{
    progress_once(ignore);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);                   /* and it does not outlive that one */
#endif
}

/* Job `own` of `n`, in its process: it prints to its files, and has as many descriptors left as it would have alone. */
static int child_files(const scene_job *job, int own, int n)
{
    if (dup2(fileno(job[own].out), STDOUT_FILENO) < 0 || dup2(fileno(job[own].err), STDERR_FILENO) < 0) return 0;
    for (int k = 0; k < 2 * n; k++) {
        FILE *const file = k % 2 ? job[k / 2].out : job[k / 2].err;
        if (file && fileno(file) > STDERR_FILENO) close(fileno(file));
    }
    return 1;
}

static int child_end(int status)
{
    if ((!fflush(stdout) && !ferror(stdout)) || status == EXIT_INTERNAL) return status;
    fputs("stonepack: can't write\n", stderr);
    return EXIT_INTERNAL;
}

/* Scene k as job `own` of `n`.     returns whether it runs */
static int begin_scene(scene_job *job, int own, int n, int k, int (*one)(void *self, int k), void *self)
{
    scene_job *j = &job[own];
    j->status = -1;
    j->out = tmpfile();
    j->err = tmpfile();
    fflush(NULL);
    j->pid = j->out && j->err ? fork() : -1;
    if (j->pid == 0) {
        child_signals();
        _exit(child_files(job, own, n) ? child_end(one(self, k)) : EXIT_INTERNAL);
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
    pid_t pid;
    do pid = waitpid(-1, &status, 0); while (pid < 0 && errno == EINTR);
    for (int k = 0; k < n; k++) {
        if (!job[k].pid || (pid >= 0 && job[k].pid != pid)) continue;
        job[k].pid = 0;
        if (pid > 0) job[k].status = status;
    }
}

/* What a file holds, to another; then it is closed.     returns whether all of it could be read */
static int pour(FILE *from, FILE *to)
{
    char piece[4096];
    size_t n;
    rewind(from);
    while ((n = fread(piece, 1, sizeof piece, from)) > 0) fwrite(piece, 1, n, to);
    const int whole = !ferror(from);
    fclose(from);
    fflush(to);
    return whole;
}

/* What an ended one printed.     returns its status */
static int tell_scene(scene_job *j, const char *name)
{
    const int told = pour(j->out, stdout), whole = pour(j->err, stderr) && told;
    j->out = j->err = NULL;
    if (!whole) fprintf(stderr, "stonepack: %s: what its process printed can't be read\n", name);
    else if (j->status < 0) fprintf(stderr, "stonepack: %s: its process was lost\n", name);
    else if (WIFEXITED(j->status)) return WEXITSTATUS(j->status);
    else fprintf(stderr, "stonepack: %s: its process was ended by signal %d\n", name, WTERMSIG(j->status));
    return EXIT_INTERNAL;
}

int jobs_scenes(int n, int jobs, char *const *name, int (*one)(void *self, int k), void *self, int *status)
{
    scene_job job[AHEAD * JOBS_MOST];
    const int room = AHEAD * jobs;
    int begun = 0, told = 0, running = 0, full = -1;            /* full: so many were told when no more could be begun */
    memset(job, 0, sizeof job);
    signal(SIGCHLD, SIG_DFL);                                   /* ignored by whoever began this one, no end would be told */
    while (told < n && (told < begun || !progress_stopped())) {
        if (begun < n && running < jobs && begun - told < room && full < told && !progress_stopped()) {
            if (begin_scene(job, begun % room, room, begun, one, self)) begun++;
            else if (told < begun) full = told;
            else {                                              /* no process can be had: it is checked here */
                status[told] = one(self, told);
                fflush(stdout);
                begun = ++told;
            }
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
