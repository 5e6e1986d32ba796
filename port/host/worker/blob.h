/* A scene and its question, or a result, as bytes that go from one process to another.                            [seed 3.4]
 *
 * A message is a header, a body, a checksum. Numbers are little-endian; `real` is the sender's sp_real.
 *
 *     bytes  what
 *     4      magic 0x4b505453, "STPK"
 *     2      version 2
 *     2      kind: 1 request, 2 result, 3 error
 *     4      flags: 1 reals are float (4 bytes), else double (8); others must be 0
 *     4      length of the body, at most BLOB_CAP
 *     ...    body
 *     4      CRC-32 (IEEE 802.3) of all before it
 *
 *     request body, sizes by the counts alone; i: int32
 *     7 i    count of blocks, vertices, faces, corners, joints, points, loads
 *     7 r    gravity[3], live, body[3]
 *     5 i    settings: faces inscribed net localise iterations
 *     1 l    budget, 8 bytes
 *     9 i    stage_count stage[6] seed (1: sp_seed_table()) asked
 *     3 i    of the coupled check: box rounds nodes
 *     6 r    settings: tol force_bound gamma tau, coupled eps eta
 *     block      3 i 5 r   fixed vertices faces; density (0: given by its mass) mass centroid[3]
 *     vertex     3 r
 *     face       i         corners
 *     corner     i         vertex, 0-based within its block
 *     joint  4 i 13 r  a b points polygon; strength mu cohesion tension crushing, n[3] t1[3] t2[3]
 *     point      3 r
 *     load       2 i 10 r  block live; point[3] force[3] couple[3] mass
 *
 *     result body, sizes by the scene and the head
 *     head       the fields of sp_result, then of its sp_coupled, in their order (arrays: after the head), bytes of the check's
 *                arena, seconds it took; counts of what follows: see blob.c
 *     arrays     f dq y0 demand, coupled dq, alpha and penalty where asked for, proof node row (uint16) y
 *
 *     error body: i sp_status, the rest a message
 *
 * Whoever reads trusts nothing: the length is checked before a byte of the body is kept, the counts against the length before
 * anything is allocated, and scenes are built by the library's own calls, which refuse what they would refuse of anyone.
 * Names don't travel: blocks and joints go by number. Nor do pointers: custom stages, penalty.solver, a seed other than
 * sp_seed_table() are SP_E_UNSUPPORTED. */
#ifndef STONEPACK_HOST_BLOB_H
#define STONEPACK_HOST_BLOB_H

#include "../run.h"

#define BLOB_HEADER 16                          /* [byte] */
#define BLOB_CAP ((uint32_t)1 << 30)            /* [byte] longest body */
#define BLOB_STEPS 100000                       /* most settings.iterations, coupled.rounds */
#define BLOB_NODES 4000000                      /* most coupled.nodes: a proof of 1 GB */

typedef enum blob_kind { BLOB_REQUEST = 1, BLOB_RESULT, BLOB_ERROR } blob_kind;

/* A message. Zeroed, it is empty; data is malloc's. */
typedef struct blob {
    unsigned char *data;
    size_t length, room;        /* [byte] */
    int failed;                 /* memory ran out, or the body is longer than BLOB_CAP */
} blob;

/* Room for `more` bytes, which the caller writes at data + length.      returns 0: no memory */
int blob_grow(blob *b, size_t more);
void blob_free(blob *b);

/* The header's first look at a message: its kind and how long the whole of it is.
 *   returns SP_OK, SP_E_ARGUMENT (not ours), SP_E_UNSUPPORTED (version, flags), SP_E_CAPACITY (too long) */
sp_status blob_header(const unsigned char header[BLOB_HEADER], blob_kind *kind, size_t *length);

/* A whole message: header, length, checksum, kind.      returns as blob_header, SP_E_ARGUMENT */
sp_status blob_whole(const blob *b, blob_kind kind);

/* Write: what was in b is forgotten.      returns SP_OK, SP_E_MEMORY, SP_E_CAPACITY, SP_E_UNSUPPORTED (pointers in settings) */
sp_status blob_write_request(blob *b, const sp_scene *scene, const sp_settings *settings);
/* cost: what comes besides a result */
sp_status blob_write_result(blob *b, const sp_scene *scene, const sp_result *result, const run_cost *cost);
sp_status blob_write_error(blob *b, sp_status status, const char *message);

/* Read a request.
 *   out  scene, settings    the scene's arrays lie in *memory, to be freed by the caller in every case
 *   returns  SP_OK, as blob_whole, SP_E_RANGE (settings, counts that are not the body's length), SP_E_MEMORY, what the calls
 *            that build a scene return */
sp_status blob_read_request(const blob *b, sp_scene *scene, sp_settings *settings, void **memory);

/* Read a result of this scene; likewise. */
sp_status blob_read_result(const blob *b, const sp_scene *scene, sp_result *result, run_cost *cost, void **memory);

/* Read an error: its status, or SP_E_ARGUMENT; message: room for 200 bytes, control bytes become '?'. */
sp_status blob_read_error(const blob *b, char message[200]);

#endif
