/* Meshes: volume and centroid at any scale and place, and what is no closed body. */
#include "scene.h"

static const int32_t tri_size[12] = { 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3 };
static const int32_t tri_corner[36] = { 0, 2, 3,  0, 3, 1,  4, 5, 7,  4, 7, 6,  0, 1, 5,  0, 5, 4,
                                        2, 6, 7,  2, 7, 3,  0, 4, 6,  0, 6, 2,  1, 3, 7,  1, 7, 5 };

static sp_mesh triangles(const sp_mesh *quads)
{
    const sp_mesh mesh = { 8, 12, quads->xyz, tri_size, tri_corner };
    return mesh;
}

/* ----------------------------------------------------------------------------------------------------- mass, closed form */

TEST(cube_volume_is_its_edge_cubed_at_any_scale)
{
    for (int e = -9; e <= 9; e++) {
        const double s = pow(10, e);
        sp_real xyz[24];
        sp_mass m;
        sp_mesh mesh = box(xyz, 0, 0, 0, s, s, s);
        const double edge = (double)xyz[3];
        for (int k = 0; k < 2; k++, mesh = triangles(&mesh)) {
            CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
            CHECK_NEAR(m.volume, edge * edge * edge, 8 * U);
            CHECK_NEAR(m.diameter, edge * sqrt(3), 4 * U);
            for (int c = 0; c < 3; c++) CHECK_NEAR(m.centroid[c], edge / 2, 8 * U);
        }
    }
}

TEST(tetrahedron_centroid_is_a_quarter)
{
    static const int32_t size[4] = { 3, 3, 3, 3 }, corner[12] = { 0, 2, 1,  0, 1, 3,  0, 3, 2,  1, 2, 3 };
    const sp_real xyz[12] = { 0, 0, 0,  3, 0, 0,  0, 2, 0,  0, 0, 5 };
    const sp_mesh mesh = { 4, 4, xyz, size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 5, 4 * U);
    CHECK_NEAR(m.centroid[0], 0.75, 4 * U);
    CHECK_NEAR(m.centroid[1], 0.5, 4 * U);
    CHECK_NEAR(m.centroid[2], 1.25, 4 * U);
    CHECK_NEAR(m.diameter, sqrt(38), 4 * U);
}

/* Five-sided column between z = 0 and 2, leaning by 3 in x: area of the pentagon times height, centroid at half the lean. */
TEST(sheared_prism_keeps_its_volume)
{
    static const int32_t size[7] = { 5, 5, 4, 4, 4, 4, 4 };
    static const int32_t corner[30] = { 4, 3, 2, 1, 0,  5, 6, 7, 8, 9,  0, 1, 6, 5,  1, 2, 7, 6,  2, 3, 8, 7,  3, 4, 9, 8,
                                        4, 0, 5, 9 };
    const sp_real plan[5][2] = { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 2, 4 }, { 0, 2 } };    /* 4 x 2 and a triangle 4 x 2 / 2 */
    sp_real xyz[30];
    for (int k = 0; k < 10; k++) {
        xyz[3 * k] = plan[k % 5][0] + (k < 5 ? R(0) : R(3));
        xyz[3 * k + 1] = plan[k % 5][1];
        xyz[3 * k + 2] = k < 5 ? R(0) : R(2);
    }
    const sp_mesh mesh = { 10, 7, xyz, size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 24, 8 * U);
    CHECK_NEAR(m.centroid[0], 3.5, 8 * U);
    CHECK_NEAR(m.centroid[1], (8 * 1 + 4 * (2 + 2.0 / 3)) / 12, 8 * U);
    CHECK_NEAR(m.centroid[2], 1, 8 * U);
}

/* The same eighth-of-a-metre coordinates near the origin and 1e6 away give the same volume and the same place in it. */
TEST(far_from_the_origin_nothing_is_lost)
{
    const double far[3] = { 1e6, -1e6, 1048576 };
    for (int k = 0; k < 50; k++) {
        sp_real near_xyz[24], far_xyz[24];
        const double step = 0.125;                      /* exact at 1e6 in both precisions */
        for (int v = 0; v < 8; v++)
            for (int c = 0; c < 3; c++) {
                const double x = (v >> c & 1 ? 16 : 0) + test_random_int(-2, 2);
                near_xyz[3 * v + c] = R(step * x);
                far_xyz[3 * v + c] = R(step * x + far[c]);
            }
        const sp_mesh here = { 8, 12, near_xyz, tri_size, tri_corner }, there = { 8, 12, far_xyz, tri_size, tri_corner };
        sp_mass a, b;
        NEED(sp_mesh_mass(&here, &a) == SP_OK);
        NEED(sp_mesh_mass(&there, &b) == SP_OK);
        CHECK_NEAR(b.volume, a.volume, 0);
        CHECK_NEAR(b.diameter, a.diameter, 0);
        for (int c = 0; c < 3; c++) CHECK_NEAR(b.centroid[c], (double)a.centroid[c] + far[c], 2 * U);
    }
}

TEST(turning_a_block_turns_its_centroid)
{
    for (int k = 0; k < 50; k++) {
        double r[9];
        sp_real xyz[24], c0[3] = { R(2.5), R(-1.0), R(0.25) };
        sp_mesh mesh = box(xyz, 2, -2, 0, 1, 2, 0.5);
        sp_mass m;
        rotation(r);
        turn(r, xyz, 8);
        turn(r, c0, 1);
        CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
        CHECK_NEAR(m.volume, 1, 64 * U);
        for (int c = 0; c < 3; c++) CHECK_WITHIN(m.centroid[c], c0[c], 64 * U);
    }
}

TEST(a_hole_and_a_cavity_count_as_missing)
{
    static const int32_t size[12] = { 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4 };
    sp_real xyz[48];
    int32_t corner[48];
    box(xyz, 0, 0, 0, 4, 4, 4);
    box(xyz + 24, 1, 1, 1, 2, 2, 1);
    for (int k = 0; k < 24; k++) {
        corner[k] = box_corner[k];
        corner[24 + k] = 8 + box_corner[23 - k];        /* inward */
    }
    const sp_mesh mesh = { 16, 12, xyz, size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 60, 8 * U);
    CHECK_NEAR(m.centroid[0], 2, 8 * U);
    CHECK_NEAR(m.centroid[2], (64 * 2 - 4 * 1.5) / 60, 8 * U);
}

/* ------------------------------------------------------------------------------------------------------ mass, closedness */

TEST(equal_coordinates_are_the_same_vertex)
{
    sp_real xyz[24], own[72];
    int32_t corner[24];
    box(xyz, 0, 0, 0, 1, 1, 1);
    for (int k = 0; k < 24; k++) {
        corner[k] = 23 - k;
        for (int c = 0; c < 3; c++) {
            const sp_real x = xyz[3 * box_corner[k] + c];
            own[3 * (23 - k) + c] = x < R(0.5) && k % 2 ? -R(0.0) : x;      /* also -0 for 0 */
        }
    }
    for (int k = 0; k < 24; k++) corner[k] = 4 * (k / 4) + 3 - k % 4;       /* faces were reversed with the numbering */
    const sp_mesh mesh = { 24, 6, own, box_size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 1, 4 * U);
}

TEST(a_vertex_off_by_an_ulp_opens_the_mesh)
{
    sp_real xyz[27];
    int32_t corner[24];
    const sp_mesh mesh = { 9, 6, xyz, box_size, corner };
    box(xyz, 0, 0, 0, 1, 1, 1);
    memcpy(corner, box_corner, sizeof corner);
    memcpy(xyz + 24, xyz + 21, 3 * sizeof *xyz);
    corner[6] = 8;                                      /* vertex 7 under another number */
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    xyz[24] = R(1) + 2 * SP_EPSILON;
    mass_refused(&mesh, SP_E_OPEN, "one ulp");
}

TEST(open_meshes_are_refused)
{
    sp_real xyz[24];
    int32_t size[7] = { 4, 4, 4, 4, 4, 4, 4 }, corner[28];
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    mesh.size = size;
    mesh.corner = corner;
    memcpy(corner, box_corner, sizeof box_corner);
    mesh.faces = 5;
    mass_refused(&mesh, SP_E_OPEN, "face missing");
    mesh.faces = 7;
    memcpy(corner + 24, box_corner + 20, 4 * sizeof *corner);
    mass_refused(&mesh, SP_E_OPEN, "face twice");
    mesh.faces = 6;
    for (int k = 0; k < 4; k++) corner[20 + k] = box_corner[23 - k];
    mass_refused(&mesh, SP_E_OPEN, "face turned round");
    mesh = triangles(&mesh);
    mesh.faces = 11;
    mass_refused(&mesh, SP_E_OPEN, "triangle missing");
}

/* Whole numbers leave the low half of 113 bits 0: as they were hashed all eight vertices were one, and any faces closed. */
TEST(in_quad_a_cube_without_a_face_was_closed)
{
    sp_real xyz[24];
    for (int k = 0; k < 6; k++) {
        int32_t corner[20];
        sp_mesh mesh = box(xyz, 0, 0, 0, 1, 2, 3);
        for (int i = 0; i < 20; i++) corner[i] = box_corner[i < 4 * k ? i : i + 4];
        mesh.faces = 5;
        mesh.corner = corner;
        mass_refused(&mesh, SP_E_OPEN, "a face is missing");
    }
}

/* A fifth corner on an edge that the neighbour does not have is a gap; a triangle without area closes it, legally. */
TEST(a_face_without_area_closes_a_gap)
{
    sp_real xyz[27];
    static const int32_t size[7] = { 5, 4, 4, 4, 4, 4, 3 };
    static const int32_t corner[28] = { 0, 2, 3, 1, 8,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5,
                                        8, 1, 0 };
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    sp_mass m;
    mesh.vertices = 9;
    mesh.size = size;
    mesh.corner = corner;
    xyz[24] = R(0.375); xyz[25] = xyz[26] = 0;
    mass_refused(&mesh, SP_E_OPEN, "corner on an edge");
    mesh.faces = 7;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 1, 4 * U);
    for (int c = 0; c < 3; c++) CHECK_NEAR(m.centroid[c], 0.5, 4 * U);
}

TEST(inward_meshes_say_so)
{
    sp_real xyz[24];
    int32_t corner[36];
    sp_mesh mesh = box(xyz, 5, 5, 5, 1, 2, 3);
    for (int k = 0; k < 24; k++) corner[k] = box_corner[23 - k];
    mesh.corner = corner;
    mass_refused(&mesh, SP_E_INWARD, "quads");
    mesh = triangles(&mesh);
    for (int k = 0; k < 36; k++) corner[k] = tri_corner[35 - k];
    mesh.corner = corner;
    mass_refused(&mesh, SP_E_INWARD, "triangles");
    for (int k = 0; k < 8; k++) xyz[3 * k] = -xyz[3 * k];      /* a mirror image of an inward mesh is outward */
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 6, 8 * U);
}

/* ------------------------------------------------------------------------------------------------------- mass, thin and flat */

TEST(needles_and_plates_have_a_volume)
{
    const double dims[3][3] = { { 1, 1e-6, 1e-6 }, { 1, 1, 1e-6 }, { 1e-6, 1, 1e-3 } };
    for (int e = -9; e <= 9; e += 3)
        for (int d = 0; d < 3; d++) {
            const double s = pow(10, e);
            sp_real xyz[24];
            sp_mass m;
            sp_mesh mesh = box(xyz, 0, 0, 0, s * dims[d][0], s * dims[d][1], s * dims[d][2]);
            const double v = (double)xyz[21] * (double)xyz[22] * (double)xyz[23];
            if (v < (double)TOL(0, 1e-36f)) continue;   /* float has no such numbers */
            CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
            CHECK_NEAR(m.volume, v, 16 * U);
            mesh = triangles(&mesh);
            CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
            CHECK_NEAR(m.volume, v, 16 * U);
        }
}

/* Turned, the coordinates themselves carry u per unit of length, 1e6 u of the thickness. */
TEST(turned_needles_and_plates_pass_too)
{
    const double dims[2][3] = { { 1, 1e-6, 1e-6 }, { 1, 1, 1e-6 } };
    for (int k = 0; k < 100; k++) {
        const double *d = dims[k % 2], s = pow(10, (double)test_random_real(-6, 6));
        double r[9];
        sp_real xyz[24];
        sp_mass m;
        sp_mesh mesh = box(xyz, 0, 0, 0, s * d[0], s * d[1], s * d[2]);
        rotation(r);
        turn(r, xyz, 8);
        if (k % 4 > 1) mesh = triangles(&mesh);
        CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
        CHECK_NEAR(m.volume, s * s * s * d[0] * d[1] * d[2], 8e6 * U);
    }
}

TEST(flat_bodies_are_degenerate_at_any_scale_and_place)
{
    const double dims[4][3] = { { 1, 1, 0 }, { 1, 1e-6, 0 }, { 1, 0, 0 }, { 0, 0, 0 } };
    for (int k = 0; k < 400; k++) {
        const double *d = dims[k % 4], s = pow(10, (double)test_random_real(-9, 9)), off = k % 3 ? 0 : s * 1e6;
        double r[9];
        sp_real xyz[24];
        sp_mesh mesh = box(xyz, 0, 0, 0, s * d[0], s * d[1], s * d[2]);
        rotation(r);
        turn(r, xyz, 8);
        for (int c = 0; c < 24; c++) xyz[c] += R(off);
        if (k % 5 > 1) mesh = triangles(&mesh);
        mass_refused(&mesh, SP_E_DEGENERATE, "flat");
    }
}

TEST(faces_may_warp_by_a_hundredth_and_no_more)
{
    const double d = sqrt(3);
    sp_real xyz[24];
    sp_mass m;
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    xyz[23] = R(1 + 4 * 0.9e-2 * d);                    /* one corner of four lifted by h: each is about h/4 off */
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 1 + 0.9e-2 * d, 1e-3);
    xyz[23] = R(1 + 4 * 1.1e-2 * d);
    mass_refused(&mesh, SP_E_WARPED, "lifted corner");
    mesh = triangles(&mesh);                            /* triangles cannot warp */
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
}

/* -------------------------------------------------------------------------------------------------------- mass, refusals */

TEST(broken_meshes_are_refused)
{
    sp_real xyz[24];
    int32_t size[6], corner[24];
    const sp_mesh good = box(xyz, 0, 0, 0, 1, 1, 1);
    sp_mesh mesh = good;
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&good, NULL), SP_E_ARGUMENT);
    mass_refused(NULL, SP_E_ARGUMENT, "no mesh");
    mesh.xyz = NULL;             mass_refused(&mesh, SP_E_ARGUMENT, "no xyz");
    mesh = good; mesh.size = NULL;    mass_refused(&mesh, SP_E_ARGUMENT, "no size");
    mesh = good; mesh.corner = NULL;  mass_refused(&mesh, SP_E_ARGUMENT, "no corner");
    mesh.faces = 1;                   mass_refused(&mesh, SP_E_ARGUMENT, "one face, no corner");
    mesh.size = NULL;                 mass_refused(&mesh, SP_E_ARGUMENT, "one face, no size");
    mesh = good; mesh.vertices = -1;  mass_refused(&mesh, SP_E_ARGUMENT, "vertices < 0");
    mesh = good; mesh.faces = -1;     mass_refused(&mesh, SP_E_ARGUMENT, "faces < 0");
    mesh = good; mesh.faces = 0;      mass_refused(&mesh, SP_E_DEGENERATE, "no faces");
    mesh.vertices = 0;                mass_refused(&mesh, SP_E_DEGENERATE, "nothing");
    mesh = good; mesh.vertices = 7;   mass_refused(&mesh, SP_E_INDEX, "corner beyond the vertices");
    mesh = good; mesh.corner = corner; mesh.size = size;
    memcpy(corner, box_corner, sizeof corner);
    memcpy(size, box_size, sizeof size);
    corner[5] = -1;                   mass_refused(&mesh, SP_E_INDEX, "corner -1");
    corner[5] = 5; size[2] = 2;       mass_refused(&mesh, SP_E_DEGENERATE, "two corners");
    size[2] = -4;                     mass_refused(&mesh, SP_E_DEGENERATE, "negative corners");
    size[2] = INT32_MAX;              mass_refused(&mesh, SP_E_ARGUMENT, "more corners than can be counted");
    size[2] = 4;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
}

TEST(infinities_and_overflow_are_refused)
{
    const sp_real bad[3] = { (sp_real)HUGE_VAL, -(sp_real)HUGE_VAL, (sp_real)NAN };
    const double large = (double)TOL(1e110, 1e14f), widest = (double)TOL(1.7e308, 3e38f);
    sp_real xyz[24];
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    for (int k = 0; k < 24; k += 5)
        for (int b = 0; b < 3; b++) {
            const sp_real was = xyz[k];
            xyz[k] = bad[b];
            mass_refused(&mesh, SP_E_NOT_FINITE, "not a number");
            xyz[k] = was;
        }
    mesh = box(xyz, 0, 0, 0, large, large, large);
    mass_refused(&mesh, SP_E_NOT_FINITE, "cube overflows");
    mesh = box(xyz, -widest, 0, 0, 2, 1, 1);
    xyz[3] = R(widest);
    mass_refused(&mesh, SP_E_NOT_FINITE, "difference overflows");
}

TEST_LIST(mesh)
    RUN(cube_volume_is_its_edge_cubed_at_any_scale)
    RUN(tetrahedron_centroid_is_a_quarter)
    RUN(sheared_prism_keeps_its_volume)
    RUN(far_from_the_origin_nothing_is_lost)
    RUN(turning_a_block_turns_its_centroid)
    RUN(a_hole_and_a_cavity_count_as_missing)
    RUN(equal_coordinates_are_the_same_vertex)
    RUN(a_vertex_off_by_an_ulp_opens_the_mesh)
    RUN(open_meshes_are_refused)
    RUN(in_quad_a_cube_without_a_face_was_closed)
    RUN(a_face_without_area_closes_a_gap)
    RUN(inward_meshes_say_so)
    RUN(needles_and_plates_have_a_volume)
    RUN(turned_needles_and_plates_pass_too)
    RUN(flat_bodies_are_degenerate_at_any_scale_and_place)
    RUN(faces_may_warp_by_a_hundredth_and_no_more)
    RUN(broken_meshes_are_refused)
    RUN(infinities_and_overflow_are_refused)
TEST_END
