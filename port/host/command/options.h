/* What the command line asks for. */
#ifndef STONEPACK_HOST_OPTIONS_H
#define STONEPACK_HOST_OPTIONS_H

#include "../files/scene.h"
#include "../picture/view.h"

typedef struct options {
    int json, forces;
    int quiet;                  /* the first line alone: no remarks, no progress */
    const char *svg;            /* file, or NULL */
    const char *model;          /* OBJ of --out-obj, or NULL */
    const char *png;            /* picture of --png, or NULL */
    const char *html;           /* page of --html, or NULL */
    const char *csv;            /* tables NAME-joints.csv and so on, or NULL */
    view_wish view;             /* of it */
    int names;                  /* on its blocks */
    const char *out, *frames;   /* of settle: files, or NULL */
    const char *set;            /* of settle: NAME=VALUE,... or NULL */
    int sweep;                  /* of contacts */
    int ram;                    /* of plan */
    int tilt_margin;            /* of limit */
    double body[3];             /* of limit: live load of every block, in its weight; 0: not given */
    double near;                /* of settle: contacts are faces nearer than this [m]; 0: Bullet's points */
    int confirm;                /* of settle */
    const char *order, *order_file;     /* of sequence: names a,b,c, or a file of them; NULL */
    int remove, suggest;        /* of sequence */
    scene_settings scene;       /* of every command that reads one: SCENE_OPTIONS */
    double tilt, azimuth;       /* [degree] gravity is turned by tilt towards azimuth, counted from x to y */
    sp_real eps;                /* of qp; 0: not given */
    int backend;                /* of qp: an sp_qp_backend */
    const char *solver_name;    /* "admm", ours, unless --solver or the preset of the seed says otherwise; never "auto" */
    int solver_asked;           /* by --solver */
    sp_qp_solver solver;        /* settings.penalty.solver, where not ours */
    sp_settings settings;
    int strong;                 /* of check */
    int corners;                /* of check --strong: pressure is at the corners that joints list */
    int sliding;                /* of limit: real sliding, without dilatancy */
    sp_choice couple;           /* of --effects: coupled */
    char cone[16];              /* "true", "8i", "4c" */
    const char *program;        /* argv[0]: what a worker is started as */
    double worker;              /* [s] the check is made by a worker that has so long; 0: here */
    double worker_memory;       /* [byte] and this much memory; 0: unlimited */
    int fallback;               /* where it doesn't answer: here */
    int jobs;                   /* of check, limit: cores, >= 1 */
    const char *done;           /* scenes with a result in this file are left out, or NULL */
    int files;
    char **file;                /* what is no option, in order */
} options;

/* Options of whatever reads a scene; `allowed` of such a command has them behind its own. */
#define SCENE_OPTIONS " --mu --fixed --support --split --gravity --up --unit --contact-distance --contact-angle --quiet "

/* Read argv[2..] for a command; argv is reordered, files keep their order. `allowed`: the command's options, space around
 * each: " --json --mu ".                                                       returns 0 or EXIT_USAGE */
int options_read(int argc, char **argv, const char *allowed, options *o, failure *error);

/* "true", K"i" or K"c" with K = 3..64.     returns 1, 0: not a cone */
int options_cone(const char *text, sp_settings *settings);

#endif
