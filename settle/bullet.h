/* What settle asks of Bullet 3, for C: bodies made of hulls, steps, where they are, where they touch. */
#ifndef SETTLE_BULLET_H
#define SETTLE_BULLET_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bullet bullet;                   /* a world */

/* Points whose hull, grown by the margin, is a convex piece. */
typedef struct bullet_hull {
    int32_t points;
    double (*xyz)[3];
    double margin;              /* [m] */
} bullet_hull;

/* A rigid body. It is given where it starts without its lift. */
typedef struct bullet_body {
    int32_t id, fixed, hulls;   /* id: what bullet_touches calls it */
    const bullet_hull *hull;
    double mass, centroid[3];   /* [kg], [m] */
    double covariance[3][3];    /* of its volume about the centroid: integral of x x' over V [m^2] */
    double lift[3];             /* [m] */
    double restitution, damping;
} bullet_body;

/* A point of a contact, seen from the body with the smaller id a. */
typedef struct bullet_touch {
    int32_t a, b;               /* ids */
    int32_t pair, point;        /* number of the two bodies that touch, of the point among theirs */
    double n[3], x[3];          /* unit normal from a into b; middle of the gap */
    double depth;               /* < 0: a gap [m] */
} bullet_touch;

/* A world without gravity. friction: of a contact between two bodies, by id.                      returns NULL: out of memory */
bullet *bullet_open(int32_t iterations, double (*friction)(const void *user, int32_t a, int32_t b), const void *user);
void bullet_close(bullet *w);

/* Add a body; bodies are numbered from 0.                                                      returns 0: out of memory */
int bullet_add(bullet *w, const bullet_body *body);

/* Take one out: it stays where it is, and nothing touches it. */
void bullet_leave_out(bullet *w, int32_t body);

void bullet_gravity(bullet *w, const double g[3]);

/* One step.                                                                                    returns 0: out of memory */
int bullet_step(bullet *w, double dt);

/* Where a body is: x' = R (x - centroid) + t of its points as given. */
void bullet_where(const bullet *w, int32_t body, double R[9], double t[3]);

/* Kinetic energy of a free body [J]. */
double bullet_energy(const bullet *w, int32_t body);

/* Where bodies touch now, as met by the simulation; *touch is malloc's.                        returns 0: out of memory */
int bullet_touches(bullet *w, bullet_touch **touch, int32_t *touches);

#ifdef __cplusplus
}
#endif

#endif
