/* The wrapper of Bullet 3: bodies from stones, the protocol of steps, poses and contacts. C++ stays inside this file. */
#include "settle.h"
#include "pieces.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <new>
#include <vector>

namespace {

typedef std::vector<btVector3> points;

const double pi = 3.14159265358979323846;
enum { HISTORY = 100 };                         /* [step] over which drift is told */

btVector3 vector(const double x[3]) { return btVector3(btScalar(x[0]), btScalar(x[1]), btScalar(x[2])); }

bool finite(const double *x, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!(std::fabs(x[k]) < 1e100)) return false;
    return true;
}

/* ------------------------------------------------------------------------------------------------------------- pieces */

double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

settle_status check_mesh(const settle_mesh &m)
{
    size_t corners = 0;
    if (!m.xyz || !m.size || !m.corner || m.vertices < 4 || m.faces < 4) return SETTLE_E_MESH;
    if (!finite(m.xyz, 3 * size_t(m.vertices))) return SETTLE_E_NUMBER;
    for (int32_t f = 0; f < m.faces; f++) {
        if (m.size[f] < 3) return SETTLE_E_MESH;
        for (int32_t k = 0; k < m.size[f]; k++, corners++)
            if (m.corner[corners] < 0 || m.corner[corners] >= m.vertices) return SETTLE_E_MESH;
    }
    return SETTLE_OK;
}

/* Volume, first and second moments of tetrahedra (0, a, b, c) from an origin near the mesh:
 *   V = D/6,  S = D/24 (a + b + c),  T = D/120 (aa' + bb' + cc' + (a+b+c)(a+b+c)')                         [D = a.(b x c)] */
struct integrals {
    double v, s[3], t[3][3];
    integrals() : v(0) { std::memset(s, 0, sizeof s); std::memset(t, 0, sizeof t); }

    void tetrahedron(const double q[3][3])
    {
        double sum[3];
        const double det = q[0][0] * (q[1][1] * q[2][2] - q[1][2] * q[2][1]) + q[0][1] * (q[1][2] * q[2][0] - q[1][0] * q[2][2])
                         + q[0][2] * (q[1][0] * q[2][1] - q[1][1] * q[2][0]);
        for (int c = 0; c < 3; c++) sum[c] = q[0][c] + q[1][c] + q[2][c];
        v += det / 6;
        for (int c = 0; c < 3; c++) {
            s[c] += det / 24 * sum[c];
            for (int d = 0; d < 3; d++)
                t[c][d] += det / 120 * (q[0][c] * q[0][d] + q[1][c] * q[1][d] + q[2][c] * q[2][d] + sum[c] * sum[d]);
        }
    }
    void mesh(const settle_mesh &m, const double origin[3])
    {
        const int32_t *corner = m.corner;
        for (int32_t f = 0; f < m.faces; corner += m.size[f++])
            for (int32_t k = 1; k + 1 < m.size[f]; k++) {
                double q[3][3];
                for (int i = 0; i < 3; i++)
                    for (int c = 0; c < 3; c++) q[i][c] = m.xyz[3 * size_t(corner[i ? k + i - 1 : 0]) + size_t(c)] - origin[c];
                tetrahedron(q);
            }
    }
};

/* A polygon solid that is freed where it goes out of scope. */
struct solid : pieces_solid {
    solid() { std::memset(static_cast<pieces_solid *>(this), 0, sizeof(pieces_solid)); }
    ~solid() { pieces_free(this); }
    solid(const solid &) = delete;
    solid &operator=(const solid &) = delete;
};

/* The faces' planes pushed out to the farthest vertex: n . x <= d holds for all of the piece. */
struct plane { double n[3], d, width; };

std::vector<plane> planes_of(const settle_mesh &m)
{
    std::vector<plane> all;
    std::vector<double> q;
    const int32_t *corner = m.corner;
    for (int32_t f = 0; f < m.faces; corner += m.size[f++]) {
        plane p;
        double low = HUGE_VAL, length;
        q.clear();
        for (int32_t k = 0; k < m.size[f]; k++) q.insert(q.end(), m.xyz + 3 * size_t(corner[k]), m.xyz + 3 * size_t(corner[k]) + 3);
        pieces_normal(m.size[f], reinterpret_cast<const double (*)[3]>(q.data()), p.n);
        length = std::sqrt(dot(p.n, p.n));
        if (!(length > 0)) continue;
        for (int c = 0; c < 3; c++) p.n[c] /= length;
        p.d = -HUGE_VAL;
        for (int32_t k = 0; k < m.vertices; k++) {
            const double h = dot(p.n, m.xyz + 3 * size_t(k));
            p.d = std::fmax(p.d, h);
            low = std::fmin(low, h);
        }
        p.width = p.d - low;
        all.push_back(p);
    }
    return all;
}

/* The corners of the piece with all faces moved in by the margin: Bullet adds it again on the outside. The margin becomes
 * smaller where the piece is thin.                                                       returns false: out of memory */
bool shrink(const settle_mesh &m, double *margin, points *out)
{
    const std::vector<plane> side = planes_of(m);
    double low[3], high[3], size = 0;
    solid now, next;

    for (int c = 0; c < 3; c++) low[c] = HUGE_VAL, high[c] = -HUGE_VAL;
    for (int32_t k = 0; k < 3 * m.vertices; k++) {
        low[k % 3] = std::fmin(low[k % 3], m.xyz[k]);
        high[k % 3] = std::fmax(high[k % 3], m.xyz[k]);
    }
    for (int c = 0; c < 3; c++) size = std::fmax(size, high[c] - low[c]);
    for (size_t k = 0; k < side.size(); k++) *margin = std::fmin(*margin, 0.2 * side[k].width);
    if (!(*margin > 1e-6 * size)) *margin = 1e-6 * size;
    for (int c = 0; c < 3; c++) low[c] -= size, high[c] += size;
    if (!pieces_box(&now, low, high)) return false;
    for (size_t k = 0; k < side.size(); k++) {
        if (!pieces_clip(&now, side[k].n, side[k].d - *margin, 1e-9 * size, &next)) return false;
        std::swap(static_cast<pieces_solid &>(now), static_cast<pieces_solid &>(next));
    }
    out->clear();
    for (int32_t k = 0; k < now.corners; k++) {
        const btVector3 x = vector(now.xyz[k]);
        bool fresh = true;
        for (size_t i = 0; fresh && i < out->size(); i++) fresh = (x - (*out)[i]).length() > btScalar(1e-7 * size);
        if (fresh) out->push_back(x);
    }
    return true;
}

/* -------------------------------------------------------------------------------------------------------------- world */

/* Bullet's world with friction set for each pair just before the contacts are solved. */
class world : public btDiscreteDynamicsWorld {
public:
    world(btDispatcher *d, btBroadphaseInterface *b, btConstraintSolver *s, btCollisionConfiguration *c, const settle_settings &set)
        : btDiscreteDynamicsWorld(d, b, s, c), settings(set)
    {
        for (int32_t k = 0; k < set.pairs; k++)
            pair[std::make_pair(std::min(set.pair[k].a, set.pair[k].b), std::max(set.pair[k].a, set.pair[k].b))] = set.pair[k].mu;
    }

protected:
    void solveConstraints(btContactSolverInfo &info) override
    {
        for (int k = 0; k < getDispatcher()->getNumManifolds(); k++) {
            btPersistentManifold *m = getDispatcher()->getManifoldByIndexInternal(k);
            const double mu = friction(m->getBody0()->getUserIndex(), m->getBody1()->getUserIndex());
            for (int i = 0; i < m->getNumContacts(); i++) m->getContactPoint(i).m_combinedFriction = btScalar(mu);
        }
        btDiscreteDynamicsWorld::solveConstraints(info);
    }

private:
    double friction(int a, int b) const
    {
        const std::map<std::pair<int, int>, double>::const_iterator own = pair.find(std::make_pair(std::min(a, b), std::max(a, b)));
        if (own != pair.end()) return own->second;
        if (settings.mu >= 0) return settings.mu;
        return (a < 0 ? settings.container_friction : settings.friction) * (b < 0 ? settings.container_friction : settings.friction);
    }

    const settle_settings &settings;
    std::map<std::pair<int, int>, double> pair;
};

/* A stone in the world. Its body lies at the centroid along the principal axes: x = body * (frame' (x0 - c)). */
struct stone {
    const settle_stone *given;
    std::vector<std::unique_ptr<btConvexHullShape>> hull;
    std::unique_ptr<btCompoundShape> compound;
    std::unique_ptr<btMotionState> motion;
    std::unique_ptr<btRigidBody> body;
    btTransform start;                          /* frame and centroid as given */
    double centroid[3], mass, radius;
    bool fixed;
};

struct simulation {
    const settle_settings &set;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    world w;
    std::vector<stone> stones;
    struct { double xyz[24]; settle_mesh mesh; settle_stone stone; } wall[5];
    std::vector<btTransform> history;           /* of all stones in the last steps, a ring */
    std::vector<settle_pose> pose;
    int32_t step, steps;

    explicit simulation(const settle_settings &s)
        : set(s), dispatcher(&configuration), w(&dispatcher, &broadphase, &solver, &configuration, s), step(0), steps(0)
    {
        w.getDispatchInfo().m_deterministicOverlappingPairs = true;
        w.getSolverInfo().m_numIterations = s.iterations;
        w.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }
    ~simulation()
    {
        for (size_t k = 0; k < stones.size(); k++)
            if (stones[k].body->isInWorld()) w.removeRigidBody(stones[k].body.get());
    }

    settle_status add(const settle_stone &s, int32_t id);
    settle_status shapes_of(const settle_stone &s, const btTransform &frame, stone *out);
    settle_status add_container();
    void read_poses();
    double energy() const;
    settle_status make_steps(int32_t n, double pull, bool may_end);
    settle_status protocol(int32_t count);
    double penetration() const;
    double drift() const;
    bool contacts(std::vector<settle_contact> *out);
};

settle_status simulation::shapes_of(const settle_stone &s, const btTransform &frame, stone *out)
{
    const btTransform back = frame.inverse();
    out->radius = 0;
    for (int32_t p = 0; p < s.pieces; p++) {
        double margin = set.margin;
        points x;
        if (!shrink(s.piece[p], &margin, &x)) return SETTLE_E_MEMORY;
        if (x.size() < 4) return SETTLE_E_MESH;
        out->hull.push_back(std::unique_ptr<btConvexHullShape>(new btConvexHullShape));
        for (size_t k = 0; k < x.size(); k++) out->hull.back()->addPoint(back * x[k], false);
        out->hull.back()->setMargin(btScalar(margin));
        out->hull.back()->recalcLocalAabb();
        for (int32_t k = 0; k < s.piece[p].vertices; k++)
            out->radius = std::fmax(out->radius, double((vector(s.piece[p].xyz + 3 * size_t(k)) - frame.getOrigin()).length()));
    }
    if (s.pieces == 1) return SETTLE_OK;
    out->compound.reset(new btCompoundShape);
    for (size_t k = 0; k < out->hull.size(); k++) out->compound->addChildShape(btTransform::getIdentity(), out->hull[k].get());
    return SETTLE_OK;
}

/* Inertia m (tr(C) 1 - C) / V of the covariance C about the centroid; its axes become the body's. */
settle_status simulation::add(const settle_stone &s, int32_t id)
{
    integrals sum;
    double trace = 0, C[3][3];
    btMatrix3x3 inertia, axes;
    btVector3 moments(0, 0, 0);
    settle_status status = SETTLE_OK;
    stone body;

    for (int32_t p = 0; p < s.pieces && !status; p++) status = check_mesh(s.piece[p]);
    if (status) return status;
    for (int32_t p = 0; p < s.pieces; p++) sum.mesh(s.piece[p], s.piece[0].xyz);
    if (!(sum.v > 0)) return SETTLE_E_MESH;
    for (int c = 0; c < 3; c++) body.centroid[c] = s.piece[0].xyz[c] + sum.s[c] / sum.v;
    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++) C[c][d] = sum.t[c][d] / sum.v - sum.s[c] / sum.v * (sum.s[d] / sum.v);
    trace = C[0][0] + C[1][1] + C[2][2];
    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++) inertia[c][d] = btScalar((c == d ? trace : 0) / trace - C[c][d] / trace);
    inertia.diagonalize(axes, btScalar(1e-12), 50);
    body.mass = std::fmax(s.mass, set.mass_floor);
    for (int c = 0; c < 3; c++) moments[c] = btScalar(body.mass * trace) * inertia[c][c];
    body.given = &s;
    body.fixed = s.fixed != 0;
    body.start = btTransform(axes, vector(body.centroid));
    status = shapes_of(s, body.start, &body);
    if (status) return status;

    btTransform at = body.start;
    const double size = std::sqrt(dot(set.gravity, set.gravity));
    if (!body.fixed && size > 0) at.setOrigin(at.getOrigin() - vector(set.gravity) * btScalar(set.lift / size));
    btCollisionShape *shape = body.compound ? static_cast<btCollisionShape *>(body.compound.get()) : body.hull[0].get();
    body.motion.reset(new btDefaultMotionState(at));
    btRigidBody::btRigidBodyConstructionInfo info(body.fixed ? 0 : btScalar(body.mass), body.motion.get(), shape,
                                                  body.fixed ? btVector3(0, 0, 0) : moments);
    info.m_restitution = btScalar(set.restitution);
    info.m_linearDamping = info.m_angularDamping = btScalar(set.damping);
    body.body.reset(new btRigidBody(info));
    body.body->setUserIndex(id);
    body.body->setActivationState(DISABLE_DEACTIVATION);        /* a slow fall is no rest */
    w.addRigidBody(body.body.get());
    stones.push_back(std::move(body));
    return SETTLE_OK;
}

/* Floor and walls are stones, too: fixed, of number -1. */
settle_status simulation::add_container()
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 2, 3, 1,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5 };
    const double x = set.container[0] / 2, y = set.container[1] / 2, z = set.container[2], t = 2 * set.wall;
    const double box[5][6] = { { -x - t, -y - t, -t, x + t, y + t, 0 }, { -x - t, -y - t, 0, -x, y + t, z }, { x, -y - t, 0, x + t, y + t, z },
                               { -x, -y - t, 0, x, -y, z }, { -x, y, 0, x, y + t, z } };
    settle_status status = SETTLE_OK;
    if (!(set.container[0] > 0)) return SETTLE_OK;
    for (int k = 0; k < 5 && !status; k++) {
        const settle_mesh mesh = { 8, 6, wall[k].xyz, size, corner };
        for (int v = 0; v < 8; v++)
            for (int c = 0; c < 3; c++) wall[k].xyz[3 * v + c] = set.floor[c] + box[k][v >> c & 1 ? 3 + c : c];
        wall[k].mesh = mesh;
        wall[k].stone.pieces = 1;
        wall[k].stone.piece = &wall[k].mesh;
        wall[k].stone.mass = wall[k].stone.fixed = 1;
        status = add(wall[k].stone, -1);
    }
    return status;
}

/* -------------------------------------------------------------------------------------------------------------- steps */

double simulation::energy() const
{
    double sum = 0;
    for (size_t k = 0; k < stones.size(); k++) {
        const btRigidBody &b = *stones[k].body;
        if (stones[k].fixed) continue;
        const btVector3 v = b.getLinearVelocity(), spin = b.getWorldTransform().getBasis().transpose() * b.getAngularVelocity();
        const btVector3 i = b.getLocalInertia();
        sum += 0.5 * stones[k].mass * double(v.length2())
             + 0.5 * double(i.x() * spin.x() * spin.x() + i.y() * spin.y() * spin.y() + i.z() * spin.z() * spin.z());
    }
    return sum;
}

/* Angle of a rotation: sin from the antisymmetric part, cos from the trace. */
double angle_of(const btMatrix3x3 &R)
{
    const btVector3 axis(R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]);
    return std::atan2(0.5 * double(axis.length()), 0.5 * (double(R[0][0] + R[1][1] + R[2][2]) - 1)) * 180 / pi;
}

void simulation::read_poses()
{
    for (size_t k = 0; k < pose.size(); k++) {
        const btTransform &at = stones[k].body->getWorldTransform();
        const btMatrix3x3 R = at.getBasis() * stones[k].start.getBasis().transpose();
        settle_pose &p = pose[k];
        double moved = 0;
        for (int c = 0; c < 3; c++) {
            for (int d = 0; d < 3; d++) p.R[3 * c + d] = stones[k].fixed ? c == d : double(R[c][d]);
            p.c[c] = stones[k].centroid[c];
            p.t[c] = stones[k].fixed ? p.c[c] : double(at.getOrigin()[c]);
            moved += (p.t[c] - p.c[c]) * (p.t[c] - p.c[c]);
        }
        p.moved = std::sqrt(moved);
        p.turned = stones[k].fixed ? 0 : angle_of(R);
        p.settled = stones[k].fixed || p.t[2] > set.lowest;
    }
}

/* n steps at gravity times `pull`, fewer once all is quiet if that may end it. */
settle_status simulation::make_steps(int32_t n, double pull, bool may_end)
{
    int32_t quiet = 0;
    double mass = 0;
    for (size_t k = 0; k < stones.size(); k++) {
        stones[k].body->setGravity(stones[k].fixed ? btVector3(0, 0, 0) : vector(set.gravity) * btScalar(pull));
        if (!stones[k].fixed) mass += stones[k].mass;
    }
    for (int32_t i = 0; i < n; i++) {
        w.stepSimulation(btScalar(set.dt), 0);
        for (size_t k = 0; k < stones.size(); k++)
            history[size_t(step % HISTORY) * stones.size() + k] = stones[k].body->getWorldTransform();
        step++;
        const double e = energy();
        if (!(e < 1e100)) return SETTLE_E_DIVERGED;
        if (set.watch) {
            read_poses();
            if (set.watch(set.user, step, steps, e, pose.data())) return SETTLE_E_STOPPED;
        }
        quiet = e < set.energy * mass ? quiet + 1 : 0;
        if (may_end && set.energy > 0 && quiet >= set.quiet) break;
    }
    return SETTLE_OK;
}

/* Ramp, settle, tamp.                                                                                       [seed 5] */
settle_status simulation::protocol(int32_t count)
{
    const double full = std::sqrt(dot(set.gravity, set.gravity));
    settle_status status = SETTLE_OK;

    steps = 3 * set.ramp_steps + set.steps + set.tamps * (set.tamp_steps + set.rest_steps);
    history.assign(HISTORY * stones.size(), btTransform::getIdentity());
    pose.resize(size_t(count));                 /* the container has none */
    read_poses();
    if (set.watch && set.watch(set.user, 0, steps, 0, pose.data())) return SETTLE_E_STOPPED;
    for (int k = 0; k < 3 && !status; k++) status = make_steps(set.ramp_steps, full > 0 ? std::fmin(set.ramp[k] / full, 1) : 0, false);
    if (!status) status = make_steps(set.steps, 1, true);
    for (int32_t k = 0; k < set.tamps && !status; k++) {
        status = make_steps(set.tamp_steps, set.tamp, false);
        if (!status) status = make_steps(set.rest_steps, 1, true);
    }
    read_poses();
    return status;
}

/* -------------------------------------------------------------------------------------------------------------- results */

/* How far the surface went since the oldest pose kept: |dc| + |2 sin(angle/2)| radius is a bound. */
double simulation::drift() const
{
    double most = 0;
    if (step == 0) return 0;
    for (size_t k = 0; k < stones.size(); k++) {
        const btTransform &then = history[size_t(step < HISTORY ? 0 : step % HISTORY) * stones.size() + k];
        const btTransform &now = stones[k].body->getWorldTransform();
        const double angle = angle_of(now.getBasis() * then.getBasis().transpose()) * pi / 180;
        if (!stones[k].fixed)
            most = std::fmax(most, double((now.getOrigin() - then.getOrigin()).length()) + 2 * std::sin(angle / 2) * stones[k].radius);
    }
    return most;
}

/* A point of a manifold seen from the stone with the smaller number: unit normal from it into the other, middle of the gap. */
struct touch {
    btVector3 n, x;
    double depth;
    touch(const btManifoldPoint &p, bool swap)
        : n(p.m_normalWorldOnB * btScalar(swap ? 1 : -1)), x((p.getPositionWorldOnA() + p.getPositionWorldOnB()) * btScalar(0.5)),
          depth(-double(p.getDistance())) {}
    double along(const settle_contact &c) const { return double(n.x()) * c.n[0] + double(n.y()) * c.n[1] + double(n.z()) * c.n[2]; }
};

void add_point(settle_contact *c, const touch &t)
{
    for (int d = 0; d < 3; d++) c->point[c->points][d] = double(t.x[d]);
    c->depth = std::fmax(c->depth, t.depth);
    c->points++;
}

typedef std::map<std::pair<int, int>, std::vector<settle_contact>> contact_map;

/* The points of a manifold, one contact for those whose normals agree within a degree. */
void add_contacts(const btPersistentManifold &m, double gap, contact_map *all)
{
    const int a = m.getBody0()->getUserIndex(), b = m.getBody1()->getUserIndex();
    std::vector<settle_contact> &out = (*all)[std::make_pair(std::min(a, b), std::max(a, b))];
    const size_t first = out.size();
    for (int i = 0; i < m.getNumContacts(); i++) {
        const touch t(m.getContactPoint(i), a > b);
        size_t k = first;
        if (t.depth < -gap) continue;
        while (k < out.size() && t.along(out[k]) < std::cos(pi / 180)) k++;
        if (k == out.size()) {
            settle_contact c;
            std::memset(&c, 0, sizeof c);
            c.a = std::min(a, b);
            c.b = std::max(a, b);
            for (int d = 0; d < 3; d++) c.n[d] = double(t.n[d]);
            c.depth = -HUGE_VAL;
            out.push_back(c);
        }
        add_point(&out[k], t);
    }
}

/* From the stone's coordinates as given to where it is. */
btTransform motion_of(const stone &s) { return s.body->getWorldTransform() * s.start.inverse(); }

void place(const btTransform &T, const double x[3], double out[3])
{
    const btVector3 y = T * vector(x);
    for (int c = 0; c < 3; c++) out[c] = double(y[c]);
}

/* The part of piece `a`, moved by the gap along n, that lies in piece `b`: its corners outline where they are that near. */
bool overlap(const settle_mesh &a, const btTransform &Ta, const settle_mesh &b, const btTransform &Tb, const double shift[3], solid *out)
{
    const int32_t *corner = a.corner;
    const std::vector<plane> side = planes_of(b);
    std::vector<double> q;
    solid next;
    for (int32_t f = 0; f < a.faces; corner += a.size[f++]) {
        q.resize(3 * size_t(a.size[f]));
        for (int32_t k = 0; k < a.size[f]; k++) {
            place(Ta, a.xyz + 3 * size_t(corner[k]), &q[3 * size_t(k)]);
            for (int c = 0; c < 3; c++) q[3 * size_t(k) + size_t(c)] += shift[c];
        }
        if (!pieces_add(out, a.size[f], reinterpret_cast<const double (*)[3]>(q.data()))) return false;
    }
    for (size_t k = 0; k < side.size() && out->faces > 0; k++) {
        const btVector3 n = Tb.getBasis() * vector(side[k].n);
        const double m[3] = { double(n.x()), double(n.y()), double(n.z()) };
        if (!pieces_clip(out, m, side[k].d + double(n.dot(Tb.getOrigin())), 1e-9 * side[k].width, &next)) return false;
        std::swap(static_cast<pieces_solid &>(*out), static_cast<pieces_solid &>(next));
    }
    return true;
}

/* The simulation meets some points of a contact; here it gets its outline: of all points where the stones are within the gap,
 * those farthest in eight directions of its plane. a: one stone, or the parts of the container. */
bool outline(const stone *a, const stone *a_end, const stone &b, double gap, settle_contact *c)
{
    std::vector<btVector3> near;
    const btVector3 n = vector(c->n), first = vector(c->point[0]);
    const double shift[3] = { gap * c->n[0], gap * c->n[1], gap * c->n[2] };
    btVector3 u, v;
    for (int32_t k = 0; k < c->points; k++) near.push_back(vector(c->point[k]));
    for (; a < a_end; a++)
        for (int32_t i = 0; i < a->given->pieces; i++)
            for (int32_t j = 0; j < b.given->pieces; j++) {
                solid s;
                if (!overlap(a->given->piece[i], motion_of(*a), b.given->piece[j], motion_of(b), shift, &s)) return false;
                for (int32_t k = 0; k < s.corners; k++) {
                    const btScalar h = n.dot(vector(s.xyz[k]) - first);
                    if (std::fabs(double(h)) <= 2 * gap) near.push_back(vector(s.xyz[k]) - n * h);
                }
            }
    btPlaneSpace1(n, u, v);
    c->points = 0;
    for (int k = 0; k < SETTLE_POINTS; k++) {
        const btVector3 way = u * btScalar(std::cos(2 * pi * k / SETTLE_POINTS)) + v * btScalar(std::sin(2 * pi * k / SETTLE_POINTS));
        size_t best = 0;
        bool fresh = true;
        for (size_t i = 1; i < near.size(); i++)
            if (way.dot(near[i]) > way.dot(near[best])) best = i;
        for (int32_t i = 0; i < c->points; i++) fresh = fresh && double((vector(c->point[i]) - near[best]).length()) > gap;
        for (int d = 0; d < 3 && fresh; d++) c->point[c->points][d] = double(near[best][d]);
        c->points += fresh;
    }
    return true;
}

bool simulation::contacts(std::vector<settle_contact> *out)
{
    contact_map all;
    w.performDiscreteCollisionDetection();                      /* the last ones are older than the last step */
    for (int k = 0; k < dispatcher.getNumManifolds(); k++) add_contacts(*dispatcher.getManifoldByIndexInternal(k), set.touch, &all);
    for (contact_map::iterator c = all.begin(); c != all.end(); ++c)
        for (size_t k = 0; k < c->second.size(); k++) {
            settle_contact &x = c->second[k];
            const stone *a = x.a < 0 ? stones.data() + pose.size() : &stones[size_t(x.a)];
            if (!outline(a, x.a < 0 ? stones.data() + stones.size() : a + 1, stones[size_t(x.b)], set.touch, &x)) return false;
            out->push_back(x);
        }
    return true;
}

/* ---------------------------------------------------------------------------------------------------------------- calls */

bool within(double x, double low, double high) { return x >= low && x <= high; }

settle_status check_settings(const settle_settings &s, int32_t stones)
{
    const double number[] = { s.tamp, s.friction, s.container_friction, s.mu, s.restitution, s.damping, s.margin, s.touch, s.mass_floor, s.wall,
                              s.lift, s.lowest, s.energy, s.moved, s.turned, s.reach, s.dt };
    if (!finite(number, sizeof number / sizeof *number) || !finite(s.gravity, 3) || !finite(s.ramp, 3) || !finite(s.container, 3)
        || !finite(s.floor, 3)) return SETTLE_E_NUMBER;
    for (int k = 0; k < 3; k++)
        if (s.ramp[k] < 0 || s.container[k] < 0 || (s.container[k] > 0) != (s.container[0] > 0)) return SETTLE_E_SETTINGS;
    if (!within(s.ramp_steps, 0, 1e6) || !within(s.steps, 0, 1e7) || !within(s.tamps, 0, 1000) || !within(s.tamp_steps, 0, 1e5)
        || !within(s.rest_steps, 0, 1e5) || !within(s.iterations, 1, 10000) || s.quiet < 1) return SETTLE_E_SETTINGS;
    if (!within(s.dt, 1e-6, 0.1) || !within(s.tamp, 0, 100) || s.friction < 0 || s.container_friction < 0 || !within(s.restitution, 0, 1)
        || !within(s.damping, 0, 1) || !(s.margin > 0) || s.touch < 0 || !(s.mass_floor > 0) || !(s.wall > 0) || s.lift < 0 || s.energy < 0
        || s.moved < 0 || s.turned < 0 || s.reach < 0) return SETTLE_E_SETTINGS;
    if (s.pairs < 0 || (s.pairs > 0 && !s.pair)) return SETTLE_E_ARGUMENT;
    for (int32_t k = 0; k < s.pairs; k++) {
        if (!within(s.pair[k].a, -1, stones - 1) || !within(s.pair[k].b, -1, stones - 1)) return SETTLE_E_ARGUMENT;
        if (!finite(&s.pair[k].mu, 1) || s.pair[k].mu < 0) return SETTLE_E_SETTINGS;
    }
    return SETTLE_OK;
}

settle_status check_stone(const settle_stone &s)
{
    if (s.pieces < 1 || !s.piece) return SETTLE_E_ARGUMENT;
    if (s.pieces > SETTLE_PIECES) return SETTLE_E_PIECES;
    if (!finite(&s.mass, 1)) return SETTLE_E_NUMBER;
    return s.fixed || s.mass > 0 ? SETTLE_OK : SETTLE_E_ARGUMENT;
}

template <class T> T *copy(const std::vector<T> &v)
{
    T *p = static_cast<T *>(std::malloc((v.size() + 1) * sizeof(T)));
    if (!p) throw std::bad_alloc();
    if (!v.empty()) std::memcpy(p, v.data(), v.size() * sizeof(T));
    return p;
}

settle_status finish(simulation &sim, settle_result *out)
{
    std::vector<settle_contact> touch;
    settle_result r;
    std::memset(&r, 0, sizeof r);
    if (!sim.contacts(&touch)) return SETTLE_E_MEMORY;
    r.stones = int32_t(sim.pose.size());
    r.held = 1;
    for (size_t k = 0; k < sim.pose.size(); k++) {
        const settle_pose &p = sim.pose[k];
        r.settled += p.settled;
        r.moved = std::fmax(r.moved, p.moved);
        r.turned = std::fmax(r.turned, p.turned);
        if (!(p.moved <= sim.set.moved && p.turned <= sim.set.turned)) r.held = 0;
    }
    r.steps = sim.step;
    r.energy = sim.energy();
    r.drift = sim.drift();
    for (size_t k = 0; k < touch.size(); k++) r.penetration = std::fmax(r.penetration, touch[k].depth);
    r.contacts = int32_t(touch.size());
    std::unique_ptr<settle_pose, void (*)(void *)> pose(copy(sim.pose), settle_free);
    r.contact = copy(touch);
    r.pose = pose.release();
    *out = r;
    return SETTLE_OK;
}

settle_status run(int32_t n, const settle_stone *stone, const settle_settings &settings, settle_result *result)
{
    simulation sim(settings);
    settle_status status = SETTLE_OK;
    for (int32_t k = 0; k < n && !status; k++) status = check_stone(stone[k]);
    for (int32_t k = 0; k < n && !status; k++) status = sim.add(stone[k], k);
    if (status) return status;
    status = sim.add_container();
    if (!status) status = sim.protocol(n);
    return status ? status : finish(sim, result);
}

/* Gap between the boxes around two stones: no more than the distance of the stones. */
double box_gap(const settle_stone &a, const settle_stone &b)
{
    double gap = 0;
    for (int c = 0; c < 3; c++) {
        double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
        for (int i = 0; i < 2; i++) {
            const settle_stone &s = i ? b : a;
            for (int32_t p = 0; p < s.pieces; p++)
                for (int32_t k = 0; k < s.piece[p].vertices; k++) {
                    low[i] = std::fmin(low[i], s.piece[p].xyz[3 * k + c]);
                    high[i] = std::fmax(high[i], s.piece[p].xyz[3 * k + c]);
                }
        }
        const double d = std::fmax(std::fmax(low[0] - high[1], low[1] - high[0]), 0);
        gap += d * d;
    }
    return std::sqrt(gap);
}

settle_status seat(int32_t n, const settle_stone *stone, int32_t which, const settle_settings &settings, settle_result *result)
{
    std::vector<settle_stone> held(stone, stone + n);
    settle_status status = SETTLE_OK;
    simulation sim(settings);
    for (int32_t k = 0; k < n && !status; k++) status = check_stone(stone[k]);
    for (int32_t k = 0; k < n && !status; k++) {
        held[size_t(k)].fixed = k != which;
        status = sim.add(held[size_t(k)], k);
    }
    if (status) return status;
    for (int32_t k = 0; k < n; k++)
        if (k != which && box_gap(stone[k], stone[which]) > settings.reach) sim.w.removeRigidBody(sim.stones[size_t(k)].body.get());
    status = sim.add_container();
    if (!status) status = sim.protocol(n);
    return status ? status : finish(sim, result);
}

} // namespace

extern "C" {

settle_settings settle_default(void)
{
    settle_settings s;
    std::memset(&s, 0, sizeof s);
    s.gravity[2] = -9.81;
    s.ramp[0] = 0.5, s.ramp[1] = 2, s.ramp[2] = 5;
    s.ramp_steps = 250;
    s.steps = 1500;
    s.tamps = 1;
    s.tamp = 3.5;
    s.tamp_steps = 200;
    s.rest_steps = 400;
    s.dt = 1.0 / 600;
    s.iterations = 80;
    s.friction = 0.85;
    s.container_friction = 0.9;
    s.mu = -1;
    s.damping = 0.4;
    s.margin = 0.0015;
    s.mass_floor = 1e-4;
    s.touch = 0.0005;
    s.wall = 0.05;
    s.lift = 0.06;
    s.lowest = -0.3;
    s.quiet = 100;
    s.moved = 0.02;
    s.turned = 8;
    s.reach = 0.35;
    return s;
}

settle_settings settle_confirm_default(void)
{
    settle_settings s = settle_default();
    s.ramp_steps = s.tamps = 0;
    s.steps = 700;
    s.friction = 0.7;
    s.lift = s.damping = 0;
    return s;
}

settle_settings settle_seat_default(void)
{
    settle_settings s = settle_default();
    s.ramp_steps = 60;
    s.steps = 220;
    s.iterations = 60;
    s.tamps = 0;
    s.friction = 0.8;
    s.lift = 0.003;
    return s;
}

settle_status settle_run(int32_t stones, const settle_stone *stone, const settle_settings *settings, settle_result *result)
{
    if (stones < 1 || stones > SETTLE_STONES || !stone || !settings || !result) return SETTLE_E_ARGUMENT;
    try {
        const settle_status status = check_settings(*settings, stones);
        return status ? status : run(stones, stone, *settings, result);
    } catch (...) {
        return SETTLE_E_MEMORY;
    }
}

settle_status settle_seat(int32_t stones, const settle_stone *stone, int32_t which, const settle_settings *settings,
                          settle_result *result)
{
    if (stones < 1 || stones > SETTLE_STONES || !stone || !settings || !result || which < 0 || which >= stones) return SETTLE_E_ARGUMENT;
    try {
        const settle_status status = check_settings(*settings, stones);
        return status ? status : seat(stones, stone, which, *settings, result);
    } catch (...) {
        return SETTLE_E_MEMORY;
    }
}

void settle_result_free(settle_result *result)
{
    if (!result) return;
    std::free(result->pose);
    std::free(result->contact);
    result->pose = nullptr;
    result->contact = nullptr;
}

} // extern "C"
