/* worker_client: starts a worker, talks to it until a deadline, ends it. */
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE                 /* RLIMIT_AS where POSIX alone hides it, prctl */
#include "../clock.h"
#include "worker_client.h"

#ifdef _WIN32

#include <stdio.h>
#include <string.h>

/* No process is started without POSIX: nobody answers, or the check is made here. */
sp_status worker_check(const worker_client *client, const sp_scene *scene, const sp_settings *settings, worker_answer *answer)
{
    memset(answer, 0, sizeof *answer);
    answer->end = WORKER_NOT_STARTED;
    answer->status = SP_E_UNSUPPORTED;
    snprintf(answer->message, sizeof answer->message, "can't start a worker: that needs POSIX");
    if (!client->fallback) return answer->status;
    answer->fell_back = 1;
    answer->status = run_check(scene, settings, &answer->result, &answer->cost, &answer->memory);
    return answer->status;
}

#else

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static void set_limit(int what, rlim_t most)
{
    struct rlimit r;
    if (getrlimit(what, &r) != 0) return;
    if (r.rlim_max != RLIM_INFINITY && most > r.rlim_max) most = r.rlim_max;
    r.rlim_cur = most;
    if (what != RLIMIT_CPU) r.rlim_max = most;          /* SIGXCPU ends it, SIGKILL at the hard limit isn't needed */
    setrlimit(what, &r);
}

/* In the new process: only calls that are safe between fork and exec. It leads a group, so that what it starts ends with it,
 * and on Linux ends when the caller does. */
static void become_worker(const worker_client *c, pid_t caller, int fd)
{
    const double seconds = c->seconds < 1e9 ? c->seconds : 1e9;
    setpgid(0, 0);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != caller) _exit(127);
#else
    (void)caller;
#endif
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, (rlim_t)(seconds > 0 ? seconds : 0) + 1);
    if (c->memory) set_limit(RLIMIT_AS, (rlim_t)c->memory);
    if (dup2(fd, STDIN_FILENO) < 0 || dup2(fd, STDOUT_FILENO) < 0) _exit(127);
    if (fd > STDOUT_FILENO) close(fd);
    execvp(c->command[0], (char *const *)c->command);
    _exit(127);
}

/* A worker with one socket for both directions.       returns its process, fd in *fd; -1: none */
static pid_t start_worker(const worker_client *c, int *fd)
{
    const pid_t caller = getpid();
    int pair[2];
    pid_t pid;
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0) return -1;
    if (fcntl(pair[0], F_SETFD, FD_CLOEXEC) != 0 || fcntl(pair[0], F_SETFL, O_NONBLOCK) != 0 || (pid = fork()) < 0) {
        close(pair[0]);
        close(pair[1]);
        return -1;
    }
    if (pid == 0) become_worker(c, caller, pair[1]);
    setpgid(pid, pid);                  /* whichever of the two comes first */
    close(pair[1]);
    *fd = pair[0];
    return pid;
}

/* Send what the worker takes.     returns bytes sent so far; all of them if it takes no more */
static size_t send_some(int fd, const blob *b, size_t sent)
{
    const ssize_t n = send(fd, b->data + sent, b->length - sent, MSG_NOSIGNAL);
    if (n >= 0) return sent + (size_t)n;
    return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? sent : b->length;
}

/* Take what the worker says, at most up to *want bytes.     returns 1: go on, 0: it is all there, or over */
static int receive_some(int fd, blob *b, size_t *want, worker_end *end)
{
    blob_kind kind;
    const size_t room = *want - b->length < 65536 ? *want - b->length : 65536;
    ssize_t n;
    if (!blob_grow(b, room)) {
        *end = WORKER_GARBLED;
        return 0;
    }
    n = recv(fd, b->data + b->length, room, 0);
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return 1;
    *end = WORKER_DIED;
    if (n <= 0) return 0;
    b->length += (size_t)n;
    if (b->length < *want) return 1;
    *end = WORKER_GARBLED;
    if (*want == BLOB_HEADER) return blob_header(b->data, &kind, want) == SP_OK;        /* *want: the whole message */
    *end = WORKER_ANSWERED;
    return 0;
}

static worker_end exchange(int fd, double until, const blob *request, blob *answer)
{
    worker_end end = WORKER_LATE;
    size_t sent = 0, want = BLOB_HEADER;
    for (;;) {
        struct pollfd p = { fd, POLLIN, 0 };
        const double left = until - now();
        if (!(left > 0)) return WORKER_LATE;
        if (sent < request->length) p.events |= POLLOUT;
        if (poll(&p, 1, left < 1e6 ? (int)(left * 1000) + 1 : INT_MAX) < 0 && errno != EINTR) return WORKER_DIED;
        if (p.revents & POLLOUT && sent < request->length) {
            sent = send_some(fd, request, sent);
            if (sent == request->length) shutdown(fd, SHUT_WR);
        }
        if (p.revents & (POLLIN | POLLHUP | POLLERR) && !receive_some(fd, answer, &want, &end)) return end;
    }
}

/* Nothing stays: whatever it is doing, it is killed and waited for. One that ended its output by itself has what is left of its
 * time to end itself, so that its own status is seen.      returns its exit status, or minus the signal */
static int end_worker(pid_t pid, int fd, double until, worker_end end)
{
    const struct timespec pause = { 0, 1000000 };
    int status = 0;
    pid_t gone = 0;
    close(fd);
    while (end == WORKER_DIED && gone == 0 && now() < until) {
        siginfo_t ended = { 0 };
        gone = waitid(P_PID, (id_t)pid, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 ? ended.si_pid : -1;
        if (gone == 0) nanosleep(&pause, NULL);
    }
    kill(-pid, SIGKILL);                /* not yet waited for, its number is still its own */
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {}
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

/* What the message says. */
static void take_answer(const blob *b, const sp_scene *scene, worker_answer *a)
{
    a->status = blob_read_result(b, scene, &a->result, &a->cost, &a->memory);
    if (a->status == SP_OK) return;
    a->end = WORKER_GARBLED;
    if (blob_whole(b, BLOB_ERROR) != SP_OK) return;
    a->end = WORKER_REFUSED;
    a->status = blob_read_error(b, a->message);
}

static void explain_end(const worker_client *c, worker_answer *a)
{
    char *m = a->message;
    const size_t n = sizeof a->message;
    switch (a->end) {
    case WORKER_LATE:        snprintf(m, n, "no answer within %g s, the worker was killed", c->seconds); break;
    case WORKER_GARBLED:     snprintf(m, n, "what the worker said is no answer"); break;
    case WORKER_NOT_STARTED: snprintf(m, n, "can't start a worker: %s", strerror(errno)); break;
    case WORKER_DIED:
        if (a->code < 0) snprintf(m, n, "the worker was ended by signal %d", -a->code);
        else snprintf(m, n, "the worker ended without an answer, exit status %d", a->code);
        break;
    case WORKER_ANSWERED:
    case WORKER_REFUSED: break;
    }
}

sp_status worker_check(const worker_client *client, const sp_scene *scene, const sp_settings *settings, worker_answer *answer)
{
    const sp_settings plain = sp_settings_default();
    const double until = now() + client->seconds;
    blob request = { NULL, 0, 0, 0 }, said = { NULL, 0, 0, 0 };
    pid_t pid;
    int fd;

    memset(answer, 0, sizeof *answer);
    if (!settings) settings = &plain;
    answer->status = blob_write_request(&request, scene, settings);
    if (answer->status) {
        blob_free(&request);
        answer->end = WORKER_REFUSED;
        return answer->status;
    }
    answer->status = SP_E_UNSUPPORTED;
    pid = start_worker(client, &fd);
    answer->end = pid < 0 ? WORKER_NOT_STARTED : exchange(fd, until, &request, &said);
    if (pid >= 0) answer->code = end_worker(pid, fd, until, answer->end);
    if (answer->end == WORKER_ANSWERED) take_answer(&said, scene, answer);
    blob_free(&request);
    blob_free(&said);
    explain_end(client, answer);
    if (client->fallback && (answer->end > WORKER_REFUSED || answer->status == SP_E_MEMORY)) {
        free(answer->memory);
        answer->memory = NULL;
        answer->fell_back = 1;
        answer->status = run_check(scene, settings, &answer->result, &answer->cost, &answer->memory);
    }
    return answer->status;
}

#endif
