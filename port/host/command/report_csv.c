#include "../files/csv_out.h"
#include "../files/file.h"
#include "../motion.h"
#include "report_csv.h"

/* Forces act on b; compression is their part along the normal, from a into b; the last column is of a mechanism. */
static void put_joint(csv_out *c, const report *r, int32_t i)
{
    const sp_scene *s = &r->scene->scene;
    const sp_joint *j = &s->joint[i];
    sp_joint_force f;
    const int falls = r->result.verdict == SP_UNSTABLE && !motion_is_virtual(&r->result);
    sp_joint_motion m;
    csv_int(c, i);
    csv_text(c, r->scene->name[j->a]);
    csv_text(c, r->scene->name[j->b]);
    csv_real(c, j->area);
    csv_int(c, j->points);
    csv_real(c, j->strength.mu);
    csv_reals(c, j->n, 3);
    if (sp_joint_resultant(s, &r->result, i, &f) == SP_OK) {
        csv_reals(c, f.force, 3);
        csv_reals(c, f.point, 3);
        csv_real(c, f.force[0] * j->n[0] + f.force[1] * j->n[1] + f.force[2] * j->n[2]);
        csv_real(c, f.utilisation);
        csv_real(c, f.corner_utilisation);
    } else for (int k = 0; k < 9; k++) csv_none(c);
    if (r->result.demand) {
        csv_real(c, r->result.demand[i].tension);
        csv_real(c, r->result.demand[i].friction);
    } else for (int k = 0; k < 2; k++) csv_none(c);
    if (falls && sp_joint_moves(s, r->result.dq, i, &m) == SP_OK) csv_text(c, sp_joint_text(m.kind));
    else csv_none(c);
    csv_end(c);
}

void report_csv_joints(FILE *out, const report *r)
{
    csv_out c = { out, 0 };
    csv_header(&c, "joint,a,b,area_m2,corners,mu,nx,ny,nz,fx_N,fy_N,fz_N,x_m,y_m,z_m,compression_N,utilisation,"
                   "corner_utilisation,missing_tension_N,missing_friction_N,mechanism");
    for (int32_t i = 0; i < r->scene->scene.count.joints; i++) put_joint(&c, r, i);
}

/* dq of the mechanism, or of the virtual motion that a coupled check shows; empty where nothing moves. */
static void put_motion(csv_out *c, const report *r, int32_t b)
{
    const int shown = r->result.verdict == SP_UNSTABLE || motion_is_virtual(&r->result);
    const sp_real *dq = shown ? motion_shown(&r->result) : NULL;
    csv_int(c, dq && motion_speed(&r->scene->scene, &r->result, b) > MOTION_STILL);
    if (dq) csv_reals(c, dq + 6 * (size_t)b, 6);
    else for (int k = 0; k < 6; k++) csv_none(c);
}

void report_csv_blocks(FILE *out, const report *r)
{
    const sp_scene *s = &r->scene->scene;
    csv_out c = { out, 0 };
    csv_header(&c, "block,name,fixed,mass_kg,x_m,y_m,z_m,moves,dx,dy,dz,rx,ry,rz");
    for (int32_t b = 0; b < s->count.blocks; b++) {
        csv_int(&c, b);
        csv_text(&c, r->scene->name[b]);
        csv_int(&c, s->block[b].fixed != 0);
        csv_real(&c, s->block[b].mass);
        csv_reals(&c, s->block[b].centroid, 3);
        put_motion(&c, r, b);
        csv_end(&c);
    }
}

FILE *report_csv_create(const options *o, const char *what, char *path, failure *error)
{
    const int n = snprintf(path, REPORT_CSV_PATH, "%s-%s.csv", o->csv, what);
    if (n > 0 && n < REPORT_CSV_PATH) return file_create(path, error);
    fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: the name of --csv is too long");
    return NULL;
}

static int write_table(const report *r, const char *what, void (*put)(FILE *out, const report *r), failure *error)
{
    char path[REPORT_CSV_PATH];
    FILE *out = report_csv_create(r->options, what, path, error);
    if (!out) return error->status;
    put(out, r);
    return file_finish(out, path, 0, error);
}

int report_csv(const report *r, failure *error)
{
    const int status = write_table(r, "joints", report_csv_joints, error);
    return status ? status : write_table(r, "blocks", report_csv_blocks, error);
}
