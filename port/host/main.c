/* stonepack: the program. */
#include "command/commands.h"
#include "command/manual.h"
#include "files/obj.h"
#include "files/failure.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

/* Below the help of each command with a scene. */
static const char help_scene[] =
"\nThe model:\n"
"  --fixed LIST       supports: names of blocks, patterns ('support*', b?), lowest: the blocks that reach down to the\n"
"                     lowest point of all, or nearly: within 1 % of their own height; ground: a slab laid under the\n"
"                     model; a block that is called so comes first; may be told several times; those the file tells stay\n"
"  --support LIST     the same; of a COMPAS file (JSON) also the keys of nodes: --support 0 --support 1\n"
"  --split            shells of an object that are not joined are blocks of their own: NAME.1, NAME.2 ...\n"
"  --up AXIS          x, y, z, -x, -y or -z is up: gravity as strong as in the file, down along it    z\n"
"  --gravity X,Y,Z    instead: this gravity [m/s^2]                                0,0,-9.80665\n"
"  --unit NAME        of all coordinates: mm, cm, m or in; forces stay N, densities kg/m^3             m\n"
"  --contact-distance D   faces nearer than D [m] touch; with %, D is a share of the smaller block   0.0001%\n"
"  --contact-angle DEG    largest angle between faces that touch                   faces rise by 8 D at most, or 0.06\n"
"  --mu X             friction of every joint, whatever the scene says             0.84 where it says nothing\n"
"  --quiet            the line of the verdict alone: no details, no remarks, no progress\n\n"
"A file beside a model, MODEL.obj.stonepack, may hold what the model can't: lines as in a scene, and `o NAME` or a pattern\n"
"for the blocks that the `#@ density` and `#@ fixed` after it are of. Options come before it, and it before the model. What\n"
"`convert` writes has all of it, and goes by another name.\n";

static const char help_check[] =
"stonepack check [options] SCENE...\n\n"
"Does it stand? Tells the verdict, how sure it is, the weakest joint and what falls.\n\n"
"  --json             one JSON object per scene, one per line\n"
"  --forces           with --json: every contact force too, so that `verify` can re-check the result\n"
"  --svg FILE         draws the scene (one scene only)\n"
"  --png FILE         the same as PNG, by rsvg-convert where that is installed, else exit status 69\n"
"  --html FILE        a page that stands alone: the answer in words, a picture that turns, a table of the joints\n"
"  --out-obj FILE     a model for Rhino, Blender and others: blocks, moved blocks, forces and thrust as lines\n"
"  --csv NAME         tables: NAME-joints.csv, NAME-blocks.csv (one scene only)\n"
"  --view V           of the picture: front, side, top, or AZIMUTH,ELEVATION: degrees to the right, above   what suits\n"
"  --names            with names on all blocks that have room, not only on those told of\n"
"  --tol X            largest imbalance of a block relative to its forces          1e-9\n"
"  --budget FLOPS     stops before it would do more work, with the best found      no limit\n"
"  --cone KIND        true; Ki, Kc: pyramid of K = 3..64 faces inside, around it   true\n"
"  --stages LIST      of gates,least-squares,dense,polish,exact,admm               gates,exact\n"
"  --preset NAME      quick, standard, precise: --tol 1e-3, 1e-6, 1e-9;\n"
"                     seed: its stages gates,least-squares,polish,admm, with its pyramid, constants and gates, tol 1e-3;\n"
"                     its alternation for --coupled; other options change it       default\n"
"  --solver NAME      admm: who solves it; interior, dykstra; osqp, ipopt if built in; auto: osqp if built in, else admm;\n"
"                     the default, but for the preset seed, whose default is auto  admm\n"
"  --net              admm: friction on fp - fm, not on fp alone\n"
"  --effects LIST     of +NAME (simulate it in any case), -NAME (leave it out; where the scene calls for it: undecided),\n"
"                     where NAME is one of friction, depth (the third dimension), together (islands), coupled (as\n"
"                     --coupled); those not named as planned, see `plan`; the other effects are the scene's\n"
"  --tilt DEG[,AZ]    turns gravity by DEG degrees towards AZ, level: from x to y  0\n"
"  --localise         asks, too, where it does not stand, which joints lack tension or friction: takes up to\n"
"                     twice as long then; --json, --csv, pictures and --coupled ask by themselves\n"
"  --strong           asks, too, whether it stands whatever friction does, or by its history only\n"
"  --corners          with it: where pressure is at the corners that joints list   anywhere in the joints\n"
"  --coupled          asks, too, for a virtual motion that explains the forces\n"
"  --cra-eps M        what a joint gives in it [m]                                 1e-4 of a joint's edge\n"
"  --cra-eta M        how far joints may slip and open in it [m]                   100 eps\n"
"  --cra-box          that bound for each component of the slip, as compas_cra\n"
"  --cra-nodes N      largest proof that there is none; up to 48 corners  24 corners^3, at most 48000\n"
"  --solver ipopt     with --coupled: puts the published program's answer beside ours\n\n"
"  --worker S[,MB]    a process of its own checks each scene: S seconds, MB megabytes, then it is killed (status 70)\n"
"  --fallback         where the worker does not answer, check here\n"
"  --jobs N           N cores, up to 64, and the same answers in the same order: scenes at the same time, of one scene\n"
"                     the large factors                                            1\n"
"  --skip-done FILE   leaves out scenes with a result in FILE (JSON Lines); what they were counts for the exit status\n\n"
"memory_bytes in JSON counts scene and arena. Exit status: 0 stable, 1 unstable, 2 undecided, 65 a bad scene,\n"
"66 can't read, 64 usage, 69 a solver that is not in this build, 70 internal, 71 out of memory; of several scenes the\n"
"worst, undecided before unstable.\n";

static const char help_limit[] =
"stonepack limit [options] SCENE\n\n"
"How much of the live loads does it carry on top of the others? The largest multiple for which admissible forces exist, from\n"
"both sides: forces that carry the lower one, a mechanism that falls at the upper one; its hinges and sliding joints. Live\n"
"loads are the scene's `#@ live` lines and --body. With friction the multiplier is an upper value: forces are necessary for\n"
"standing, not sufficient, and sliding that does not open joints may fall at less.\n\n"
"  --body DX,DY,DZ    live load of every block: its weight times this vector\n"
"  --sliding real     also without dilatancy: a sliding state at a lower multiple, and what stays whatever friction does\n"
"  --tilt-margin      instead: how far gravity may turn, towards every azimuth; the worst one; with\n"
"                     --sliding real also along the plane of a planar scene without dilatancy\n"
"  --forces           with --json and --sliding real: the evidence, so that `verify` can re-check it\n"
"  --json             one JSON object; multiplier: a number, null (it falls at any), \"unbounded\", \"undecided\"\n"
"  --svg FILE         draws the mechanism with its hinges and sliding joints; with --tilt-margin a polar plot\n"
"  --png FILE         the same as PNG, by rsvg-convert where that is installed, else exit status 69\n"
"  --html FILE        a page that stands alone: the answer in words, a picture that turns, a table of the joints\n"
"  --out-obj FILE     a model for Rhino, Blender and others: blocks, moved blocks, forces and thrust as lines\n"
"  --csv NAME         tables: NAME-joints.csv, NAME-blocks.csv; with --tilt-margin, whose mechanism is that of the worst\n"
"                     azimuth, as in the page and the model, also NAME-tilt.csv\n"
"  --view V, --names  of the picture, as check\n"
"  --tol X            accuracy of both ends, as that of check                      1e-9\n"
"  --cone KIND        true; Ki, Kc: pyramid of K = 3..64 faces inside, around it   true\n"
"  --tilt DEG[,AZ]    turns gravity first\n"
"  --budget FLOPS     work that is never exceeded\n"
"  --jobs N           N cores, up to 64: azimuths of a margin at the same time, else the large factors; same answer  1\n\n"
"Exit status: 0, also where no multiple or any works; 2 undecided; of --tilt-margin 1 where it does not stand level.\n";

static const char help_plan[] =
"stonepack plan [options] SCENE\n\n"
"Which effects does the scene call for, and what does leaving the others out save? `check` follows this plan.\n\n"
"  --json             one JSON object\n"
"  --effects LIST     of +NAME (simulate it in any case), -NAME (leave it out), where NAME is one of friction, depth,\n"
"                     together, coupled (as --coupled)\n"
"  --ram              instead: the memory of each question in this program, and as constants for firmware\n"
"  --tol, --cone, --stages, --tilt, --coupled    as in check\n\n"
"Flops are a prediction (5 steps of a search); unknowns are exact, bytes are what is enough.\n";

static const char help_verify[] =
"stonepack verify [options] SCENE RESULT.json\n\n"
"What does a stored result prove? Reads what `check --json --forces` wrote, takes its forces and mechanism but not its\n"
"verdict, and judges them with code that shares no projection and no sum with the search. The question is not taken from\n"
"the result either but from these options, as they were given to check; where the result's was another, the line says so:\n\n"
"  --tol X            1e-9; the bound on forces follows from it\n"
"  --cone KIND        true\n"
"  --tilt DEG[,AZ]    0\n"
"  --body DX,DY,DZ    0,0,0; of what `limit --sliding real --json --forces` wrote, whose state and pressure are judged\n"
"  --cra-eps M        1e-4 of a joint's edge; of what `check --coupled --json --forces` wrote\n"
"  --cra-eta M        100 eps; lengths count by eta/eps, for a motion has any scale\n"
"  --cra-box          eta bounds each component of the slip; without it the slip as a whole\n\n"
"What was found for a looser question, such as a motion that goes farther than eta, proves nothing here: undecided. Exit\n"
"status by the verdict proved.\n";

static const char help_sequence[] =
"stonepack sequence [options] SCENE\n\n"
"Does it stand at every step of a build order, and what must be held meanwhile? Stones come in the order of the file unless\n"
"an order is given; supports are there from the beginning. Each step starts from the forces of the one before.\n\n"
"  --order A,B,...    the order, by names; every stone once\n"
"  --order-file FILE  the same from a file, white space between names, # starts a comment\n"
"  --remove           everything is there and goes stone by stone: in the order given, which may leave stones out, or from\n"
"                     the last of the file to the first\n"
"  --suggest          after each step, a next stone that keeps everything standing: the lowest one, with --remove the highest\n"
"  --budget N         flops after which the search for what to hold, or what comes next, ends; also of each check   none\n"
"  --svg FILE         a strip of steps, 24 at most: those that fail, what moves, what must be held\n"
"  --png FILE         the same as PNG, by rsvg-convert where that is installed, else exit status 69\n"
"  --html FILE        a page that stands alone: the answer in words, a picture that turns, of each step\n"
"                     who comes, moves or must be held; the strip, a table of the steps\n"
"  --view V, --names  of the picture, as check\n"
"  --out-obj FILE     a model for Rhino, Blender and others: blocks named after their steps, 0012_NAME, in groups by verdict;\n"
"                     what moves while a step falls, displaced, 0012_NAME_moved, in a group `moved`\n"
"  --csv NAME         a table: NAME-steps.csv\n"
"  --json             one JSON object\n"
"  --tol, --cone, --stages, --tilt               as in check\n\n"
"hold a, b! (proof): with a and b held it stands; ! falls even when all others are held; minimal: no smaller set does,\n"
"irreducible: none of them can be let go, enough: fewer might do, the budget or an undecided check ended the search. Exit\n"
"status: 0 every step stands, 1 one is unstable, 2 one is undecided, 65 a bad scene or order file, 64 usage.\n";

static const char help_contacts[] =
"stonepack contacts [options] SCENE\n\n"
"What touches what? Finds the contacts of the meshes, whatever contacts the file gives, and blocks inside each other.\n\n"
"  --sweep            instead: how pairs that touch, their joints and the verdict of check depend on --contact-distance, from\n"
"                     1e-6 % to 1 % of the smaller block; first the widest range that changes neither pairs nor verdict\n"
"  --json             one JSON object\n";

static const char help_convert[] =
"stonepack convert [options] SCENE [OUT]\n\n"
"Reads a scene and writes it (OUT or standard output) with its contacts, found if it has none.\n";

static const char help_cost[] =
"stonepack cost [options] SCENE\n\n"
"What does accuracy cost on this scene? Checks it with every cone (true, 4, 8, 16, 32 faces inside and around it), every\n"
"stage alone (least squares, polish, ADMM, exact) and six tolerances, 216 checks; tells verdict, work and imbalance of "
"each.\n\n"
"  --json             one JSON object, with times\n"
"  --svg FILE         draws imbalance over work and over time\n"
"  --png FILE         the same as PNG, by rsvg-convert where that is installed, else exit status 69\n"
"  --budget FLOPS     no check does more than that      a hundred times the exact stage, at least 1e8\n"
"  --tilt DEG[,AZ]    as check\n\n"
"Exit status as check, by the exact stage with the true cone.\n";

static const char help_qp[] =
"stonepack qp [options] FILE.qps\n\n"
"The optimiser on its own: the least of 1/2 x'Px + q'x with l <= Ax <= u, from a QPS file (fixed or free).\n\n"
"  --eps X            largest residual, absolute and relative    1e-6 and 1e-5\n"
"  --backend NAME     sparse, dense or cg                        sparse\n"
"  --solver NAME      interior, admm, dykstra; osqp, ipopt where built in; auto: osqp if built in, else admm  interior\n"
"  --json             one JSON object, with x\n\n"
"Exit status: 0 solved, 1 proved to have no solution (infeasible or unbounded), 2 not decided, 65 a bad file,\n"
"69 a solver that is not in this build.\n";

static const char help_settle[] =
"stonepack settle [options] SCENE -o OUT.obj\n"
"stonepack settle --confirm [options] SCENE\n\n"
"Where do the stones come to rest? They fall under gravity, are tamped, and are written with the points they touch in, for\n"
"`check` to decide. --confirm instead asks whether the scene keeps still, and whether statics says the same. Needs Bullet.\n\n"
"  --confirm          does it keep still, and do statics say so?\n"
"  -o FILE            writes the scene as it came to rest\n"
"  --near X           contacts written are faces nearer than X m, not Bullet's points\n"
"  --frames FILE      draws the fall in nine pictures (SVG)\n"
"  --view V           of these, as check\n"
"  --set LIST         settings NAME=VALUE,...; names and defaults: stonepack settle --set help\n"
"  --json             one JSON object\n\n"
"Exit status: 0 all settled, 1 some fell out; of --confirm 0 both say it stands, 1 both say it falls, 2 they differ or\n"
"statics is undecided; 69 this program was built without Bullet.\n";

static const char help_worker[] =
"stonepack worker\n"
"stonepack worker --selftest | --roundtrip SCENE\n\n"
"Answers checks that other programs send to its standard input, one after the other, on its standard output, until the input\n"
"ends; port/host/worker/blob.h tells the form. `check --worker SECONDS` starts one for each scene.\n\n"
"  --selftest         are its answers those of this process, bit by bit?\n"
"  --roundtrip SCENE  does a scene come through as it was?\n";

static const char help_gen[] =
"stonepack gen                              lists the scenes and their numbers\n"
"stonepack gen NAME [NUMBER=VALUE ...]      writes a scene made by formula to standard output, e.g. gen arch n=15 t=0.1\n";

/* What each command tells of itself, and below it the commands in the same order. */
static const manual_entry entry[] = {
    { "check",    "does it stand?",                        help_check, help_scene },
    { "limit",    "how much load until it falls?",        help_limit, help_scene },
    { "verify",   "what does a stored result prove?",      help_verify, help_scene },
    { "plan",     "which effects does a scene call for?",  help_plan, help_scene },
    { "sequence", "does it stand while it is built?",      help_sequence, help_scene },
    { "contacts", "what touches what?",                    help_contacts, help_scene },
    { "convert",  "read a scene, write it with contacts",  help_convert, help_scene },
    { "cost",     "what does accuracy cost on it?",        help_cost, help_scene },
    { "qp",       "solve a quadratic program",             help_qp, NULL },
    { "settle",   "where do stones come to rest?",         help_settle, help_scene },
    { "worker",   "answers checks of other programs",      help_worker, NULL },
    { "gen",      "write a scene made by formula",         help_gen, NULL },
};

enum { COMMANDS = sizeof entry / sizeof *entry };

static int (*const run[COMMANDS])(int argc, char **argv) = {
    command_check, command_limit, command_verify, command_plan, command_sequence, command_contacts, command_convert,
    command_cost, command_qp, command_settle, command_worker, command_gen,
};

static void print_help(void)
{
    puts("stonepack COMMAND [options] SCENE...     decides whether an assembly of rigid blocks stands\n");
    for (int k = 0; k < COMMANDS; k++) printf("  %-10s %s\n", entry[k].name, entry[k].summary);
    puts("\nAn export that knows no supports, y up and in millimetres:\n\n"
         "  stonepack check --unit mm --up y --fixed 'support*' --svg picture.svg model.obj\n\n"
         "stonepack COMMAND --help, or -h, tells more; stonepack help man, bash, zsh: a manual page, completions. A scene is\n"
         "a Wavefront OBJ file, - reads standard input; lines it may hold:\n");
    fputs(obj_format, stdout);
    puts("\nWithout interface and points lines contacts are found.");
}

static int is_help(const char *word) { return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0; }

static int wants_help(int argc, char **argv)
{
    for (int i = 2; i < argc && strcmp(argv[i], "--"); i++)
        if (is_help(argv[i])) return 1;
    return 0;
}

/* What was printed has to arrive.      returns status, or EXIT_INTERNAL */
static int flush_output(int status)
{
    if ((!fflush(stdout) && !ferror(stdout)) || status == EXIT_INTERNAL) return status;
    fputs("stonepack: can't write\n", stderr);
    return EXIT_INTERNAL;
}

/* Which command has this name, COMMANDS: none. */
static int find_command(const char *name)
{
    int k = 0;
    while (k < COMMANDS && strcmp(entry[k].name, name)) k++;
    return k;
}

static int unknown_command(const char *name)
{
    fprintf(stderr, "stonepack: unknown command '%.60s', see stonepack --help\n", name);
    return EXIT_USAGE;
}

/* Of a command, or as a manual page or completions; NULL: of all in short.     returns the exit status */
static int help_on(const char *what)
{
    const int k = what ? find_command(what) : 0;
    if (!what) print_help();
    else if (k < COMMANDS) {
        fputs(entry[k].help, stdout);
        if (entry[k].more) fputs(entry[k].more, stdout);
    } else if (!manual_write(stdout, what, entry, COMMANDS, obj_format)) return unknown_command(what);
    return flush_output(0);
}

int main(int argc, char **argv)
{
#ifdef _WIN32                           /* the same bytes everywhere */
    _setmode(0, _O_BINARY);
    _setmode(1, _O_BINARY);
    _setmode(2, _O_BINARY);
#endif
#ifdef SIGXFSZ                          /* a limit of file sizes is an error of writing, not death */
    signal(SIGXFSZ, SIG_IGN);
#endif
    if (argc < 2) {
        fputs("stonepack: a command is missing, see stonepack --help\n", stderr);
        return EXIT_USAGE;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("stonepack %d.%d.%d%s\n", SP_VERSION_MAJOR, SP_VERSION_MINOR, SP_VERSION_PATCH,
               sizeof(sp_real) == 4 ? " float" : "");
        return flush_output(0);
    }
    if (is_help(argv[1])) return help_on(NULL);
    if (strcmp(argv[1], "help") == 0) return help_on(argc > 2 && !is_help(argv[2]) ? argv[2] : NULL);
    const int k = find_command(argv[1]);
    if (k == COMMANDS) return unknown_command(argv[1]);
    return wants_help(argc, argv) ? help_on(argv[1]) : flush_output(run[k](argc, argv));
}
