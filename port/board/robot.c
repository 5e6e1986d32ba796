/* robot: a gripper holds a stone where it means to put it and asks whether it may let go.
 *
 * The wall so far is a scene in a static array. A line at a time comes over the serial port (here a file of the simulating
 * machine, `robot FILE`), in the words of an OBJ file:
 *
 *     o NAME               a stone: its corners and faces follow
 *     v X Y Z              a corner [m]
 *     f I J K ...          a face, anticlockwise seen from outside, corners of this stone counted from 1
 *     # ...                nothing
 *     fix                  it is a support and stays
 *     ask                  may it be let go of? The answer is one line; the stone is taken out of the scene again
 *     keep                 it was let go of and stays
 *     insert               the same, unless it is inside another or none
 *     check                does all of it stand?
 *     margin               how far may all of it be pushed sideways?
 *     undo                 the last stone is taken out, and the one before it by the next
 *
 * The answer is `release` if the wall stands with the stone and still does when all of it is pushed sideways by PUSH of its
 * weight, along four directions; the margin is the largest push on a ladder of them under which it stood. Anything else is
 * `hold`: it falls, it is not decided, the work is spent, memory is short, the stone is not one. `margin` goes on from that
 * ladder by halving: pushed by the first of its numbers it stands, by the second it does not, or that was not decided. Work is
 * counted in floating-point operations, the same on every board, so the answer is, too.
 */
#include "../../stonepack.h"
#include "board.h"

#include <string.h>

#define STONES   24
#define CORNERS  8                                      /* most of a stone; faces up to CORNERS of them */
#define FACES    12
#define JOINTS   48
#define ROUNDS   40                                     /* factorisations a check may spend */
#define BUDGET   700000                                 /* [flop] an answer that has spent them says what it has */
#define PATIENT  10000000                               /* [flop] of a margin, which nobody's gripper waits for */
#define PUSH     ((sp_real)0.05)                        /* of the weight */
#define GRAVITY  ((sp_real)9.80665)

typedef struct stone {
    char name[16];
    sp_mesh mesh;
    sp_real xyz[3 * CORNERS];
    int32_t size[FACES], corner[FACES * CORNERS];
    int bad;                                            /* a line of it that could not be read */
} stone;

typedef struct answer { const char *why; sp_real push; int checks; int64_t flops, budget; size_t bytes; } answer;

/* All there is: the scene, behind it what a question takes; the joints are found in the same place before. */
#define ROOM STONES, STONES * CORNERS, STONES * FACES, STONES * FACES * 4, JOINTS, JOINTS * 4, 0
static const sp_capacity room = { ROOM };
#define SCENE(...) SP_SCENE_BYTES(__VA_ARGS__)
static uint64_t memory[(SCENE(ROOM) + SP_MEMORY_BYTES(STONES, JOINTS, JOINTS * 4, 0)) / 8];

/* A number in decimal, moving on behind it; 0 if there is none. */
static int number(const char **text, sp_real *x)
{
    const char *s = *text;
    double value = 0, scale = 1;
    int digits = 0, minus = 0;
    while (*s == ' ') s++;
    if (*s == '-' || *s == '+') minus = *s++ == '-';
    for (; *s >= '0' && *s <= '9'; s++, digits++) value = 10 * value + (*s - '0');
    if (*s == '.') for (s++; *s >= '0' && *s <= '9'; s++, digits++) value = 10 * value + (*s - '0'), scale *= 10;
    if (!digits || (*s && *s != ' ')) return 0;
    *x = (sp_real)((minus ? -value : value) / scale);
    *text = s;
    return 1;
}

static int corner(stone *s, const char *text)
{
    sp_real *x = s->xyz + 3 * s->mesh.vertices;
    if (s->mesh.vertices == CORNERS || !number(&text, x) || !number(&text, x + 1) || !number(&text, x + 2)) return 0;
    s->mesh.vertices++;
    return 1;
}

static int face(stone *s, const char *text)
{
    int32_t from = 0, n = 0;
    sp_real index;
    for (int32_t f = 0; f < s->mesh.faces; f++) from += s->size[f];
    if (s->mesh.faces == FACES) return 0;
    for (; n < CORNERS && number(&text, &index); n++) s->corner[from + n] = (int32_t)index - 1;
    s->size[s->mesh.faces++] = n;
    return n >= 3;
}

static void start(stone *s, const char *name)
{
    memset(s, 0, sizeof *s);
    for (int k = 0; k < 15 && name[k]; k++) s->name[k] = name[k];
    s->mesh.xyz = s->xyz;
    s->mesh.size = s->size;
    s->mesh.corner = s->corner;
}

/* Find all joints anew. */
static sp_status find(sp_scene *scene, sp_arena scratch, sp_contact_report *report)
{
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = (sp_real)1e-4;                       /* as well as the robot knows where its stones are */
    scene->count.joints = scene->count.points = 0;
    return sp_contacts_find(scene, &set, scratch, report);
}

/* Put the stone into the scene and find all joints anew; what it adds goes when the counts are set back. */
static sp_status add(sp_scene *scene, const stone *s, uint32_t fixed, sp_arena scratch, sp_contact_report *report)
{
    const sp_status status = s->bad ? SP_E_ARGUMENT : sp_scene_block(scene, &s->mesh, 2400, fixed, NULL);
    return status ? status : find(scene, scratch, report);
}

/* Does it stand under this push? Counts the work. */
static sp_verdict stands(sp_scene *scene, sp_real x, sp_real y, sp_arena scratch, answer *a)
{
    sp_settings set = sp_settings_default();
    sp_result r;
    set.iterations = ROUNDS;
    scene->body[0] = x * GRAVITY;
    scene->body[1] = y * GRAVITY;
    const sp_status status = sp_check(scene, &set, &scratch, &r);
    scene->body[0] = scene->body[1] = 0;
    if (status) {
        a->why = sp_status_text(status);
        return SP_UNDECIDED;
    }
    a->checks++;
    a->flops += r.spent.total.flops;
    a->bytes = r.spent.peak_bytes;
    a->why = sp_reason_text(r.reason);
    return r.verdict;
}

/* Does it stand pushed so far along +x, -x, +y and -y?
 *   returns the first along which it does not; 4: it does, 5: work is spent */
static int pushed(sp_scene *scene, sp_real push, sp_arena scratch, answer *a)
{
    static const sp_real along[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
    for (int k = 0; k < 4; k++) {
        if (a->flops > a->budget) return 5;
        if (stands(scene, push * along[k][0], push * along[k][1], scratch, a) != SP_STABLE) return k;
    }
    a->push = push;
    return 4;
}

/* The largest push of the ladder under which it stands; -1: not even without one.
 *   out  next      the push after it, which it does not withstand along the side that is returned, or as pushed() */
static int question(sp_scene *scene, sp_arena scratch, answer *a, sp_real *next)
{
    int side = 4;
    *next = 0;
    if (stands(scene, 0, 0, scratch, a) != SP_STABLE) return 0;
    a->push = 0;
    for (*next = PUSH; *next < 1; *next *= 2) {
        side = pushed(scene, *next, scratch, a);
        if (side != 4) break;
    }
    return side;
}

static void cost(const answer *a)
{
    board_print(" [%d checks, %lu kflop, %lu bytes]\n", a->checks, (unsigned long)(a->flops / 1000), (unsigned long)a->bytes);
}

static void ask(sp_scene *scene, const stone *s, sp_arena scratch)
{
    answer a = { "", -1, 0, 0, BUDGET, 0 };
    const sp_capacity before = scene->count;
    sp_contact_report report = { 0 };
    sp_real next;
    const sp_status status = add(scene, s, 0, scratch, &report);
    if (status) a.why = sp_status_text(status);
    else if (report.overlaps) a.why = "it is inside another";
    else question(scene, scratch, &a, &next);
    scene->count = before;
    if (a.push >= PUSH) board_print("%s: release, stands pushed by %g of its weight", s->name, (double)a.push);
    else if (a.push >= 0) board_print("%s: hold, stands, but not pushed by %g of its weight", s->name, (double)PUSH);
    else board_print("%s: hold, %s", s->name, a.why);
    cost(&a);
}

static char names[STONES][16];                          /* of the stones in the scene */

static void keep(sp_scene *scene, const stone *s, uint32_t fixed, sp_arena scratch)
{
    const sp_capacity before = scene->count;
    sp_contact_report report = { 0 };
    const sp_status status = add(scene, s, fixed, scratch, &report);
    if (status) scene->count = before;
    else memcpy(names[before.blocks], s->name, sizeof s->name);
    board_print("%s: %s\n", s->name, status ? sp_status_text(status) : "kept");
}

static void insert(sp_scene *scene, const stone *s, sp_arena scratch)
{
    const sp_capacity before = scene->count;
    sp_contact_report report = { 0 };
    const sp_status status = add(scene, s, 0, scratch, &report);
    if (status || report.overlaps) scene->count = before;
    else memcpy(names[before.blocks], s->name, sizeof s->name);
    board_print("%s: %s\n", s->name,
                status ? sp_status_text(status) : report.overlaps ? "refused, it is inside another" : "inserted");
}

/* The last stone goes, unless it is a support; arrays of a scene are in the order of blocks, so the counts tell all. */
static void undo(sp_scene *scene)
{
    const int32_t last = scene->count.blocks - 1;
    if (last < 0 || scene->block[last].fixed) {
        board_print("undo: nothing was inserted\n");
        return;
    }
    const sp_block *b = &scene->block[last];
    for (int32_t k = 0; k < b->faces; k++) scene->count.corners -= scene->face[b->face + k].corners;
    scene->count.faces -= b->faces;
    scene->count.vertices -= b->vertices;
    scene->count.blocks--;
    board_print("%s: taken out, %d left\n", names[last], (int)scene->count.blocks);
}

/* Joints are found anew: a stone that was asked about, or taken out, left others behind. */
static void check(sp_scene *scene, sp_arena scratch)
{
    answer a = { "", -1, 0, 0, BUDGET, 0 };
    sp_contact_report report = { 0 };
    const sp_status status = find(scene, scratch, &report);
    if (status) board_print("check: %s\n", sp_status_text(status));
    else {
        const sp_verdict verdict = stands(scene, 0, 0, scratch, &a);
        const int fell = verdict != SP_STABLE;
        board_print("check: %s%s%s", sp_verdict_text(verdict), fell ? ", " : "", fell ? a.why : "");
        cost(&a);
    }
}

static void margin(sp_scene *scene, sp_arena scratch)
{
    static const char *const along[4] = { "+x", "-x", "+y", "-y" };
    answer a = { "", -1, 0, 0, PATIENT, 0 };
    sp_contact_report report = { 0 };
    const sp_status status = find(scene, scratch, &report);
    sp_real high;
    if (status) {
        board_print("margin: %s\n", sp_status_text(status));
        return;
    }
    int side = question(scene, scratch, &a, &high);
    while (side < 4 && a.push >= 0 && high - a.push > (sp_real)0.01) {
        const sp_real middle = (a.push + high) / 2;
        const int failed = pushed(scene, middle, scratch, &a);
        if (failed == 5) break;
        if (failed < 4) side = failed, high = middle;
    }
    if (a.push < 0) board_print("margin: none, %s", a.why);
    else {
        board_print("margin: stands pushed by %g of its weight, ", (double)a.push);
        if (side < 4) board_print("not by %g along %s", (double)high, along[side]);
        else board_print("no more was tried");
    }
    cost(&a);
}

int main(int argc, char **argv)
{
    static char line[160];
    static stone s;
    sp_arena arena;
    sp_scene scene;
    sp_status status = sp_arena_init(&arena, memory, sizeof memory);
    if (!status) status = sp_scene_create(&scene, &room, &arena);
    if (status) return board_print("%s\n", sp_status_text(status)), 1;
    const long serial = argc > 1 ? board_open(argv[1]) : -1;
    if (serial < 0) return board_print("nobody speaks: robot FILE\n"), 1;
    start(&s, "");
    while (board_line(serial, line, sizeof line) >= 0) {
        if (line[0] == 'o' && line[1] == ' ') start(&s, line + 2);
        else if (line[0] == 'v' && line[1] == ' ') s.bad |= !corner(&s, line + 2);
        else if (line[0] == 'f' && line[1] == ' ') s.bad |= !face(&s, line + 2);
        else if (!strcmp(line, "fix")) keep(&scene, &s, SP_FIXED, arena);
        else if (!strcmp(line, "ask")) ask(&scene, &s, arena);
        else if (!strcmp(line, "keep")) keep(&scene, &s, 0, arena);
        else if (!strcmp(line, "insert")) insert(&scene, &s, arena);
        else if (!strcmp(line, "check")) check(&scene, arena);
        else if (!strcmp(line, "margin")) margin(&scene, arena);
        else if (!strcmp(line, "undo")) undo(&scene);
        else if (line[0] && line[0] != '#') board_print("what is \"%s\"?\n", line);
    }
    return 0;
}
