/* The wrapper of Bullet 3. C++ stays inside this file. */
#include "bullet.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace {

btVector3 vector(const double x[3]) { return btVector3(btScalar(x[0]), btScalar(x[1]), btScalar(x[2])); }

void tell(const btVector3 &x, double out[3])
{
    for (int c = 0; c < 3; c++) out[c] = double(x[c]);
}

typedef double (*friction_of)(const void *user, int32_t a, int32_t b);

/* Bullet's world with friction set for each contact just before contacts are solved. */
class world : public btDiscreteDynamicsWorld {
public:
    world(btDispatcher *d, btBroadphaseInterface *b, btConstraintSolver *s, btCollisionConfiguration *c, friction_of f, const void *u)
        : btDiscreteDynamicsWorld(d, b, s, c), friction(f), user(u) {}

protected:
    void solveConstraints(btContactSolverInfo &info) override
    {
        for (int k = 0; k < getDispatcher()->getNumManifolds(); k++) {
            btPersistentManifold *m = getDispatcher()->getManifoldByIndexInternal(k);
            const double mu = friction(user, m->getBody0()->getUserIndex(), m->getBody1()->getUserIndex());
            for (int i = 0; i < m->getNumContacts(); i++) m->getContactPoint(i).m_combinedFriction = btScalar(mu);
        }
        btDiscreteDynamicsWorld::solveConstraints(info);
    }

private:
    friction_of friction;
    const void *user;
};

/* Its frame lies at the centroid along the principal axes. */
struct rigid {
    std::vector<std::unique_ptr<btConvexHullShape>> hull;
    std::unique_ptr<btCompoundShape> compound;
    std::unique_ptr<btMotionState> motion;
    std::unique_ptr<btRigidBody> body;
    btMatrix3x3 axes;
    btScalar mass;
};

/* Moments m (tr(C) 1 - C) along the principal axes. */
btVector3 principal(const bullet_body &b, btMatrix3x3 *axes)
{
    const double trace = b.covariance[0][0] + b.covariance[1][1] + b.covariance[2][2];
    btMatrix3x3 inertia;
    btVector3 moments;
    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++) inertia[c][d] = btScalar((c == d ? trace : 0) / trace - b.covariance[c][d] / trace);
    inertia.diagonalize(*axes, btScalar(1e-12), 50);
    for (int c = 0; c < 3; c++) moments[c] = btScalar(b.mass * trace) * inertia[c][c];
    return moments;
}

btCollisionShape *shape_of(const bullet_body &b, rigid *r)
{
    const btTransform back = btTransform(r->axes, vector(b.centroid)).inverse();
    for (int32_t p = 0; p < b.hulls; p++) {
        r->hull.push_back(std::unique_ptr<btConvexHullShape>(new btConvexHullShape));
        for (int32_t k = 0; k < b.hull[p].points; k++) r->hull.back()->addPoint(back * vector(b.hull[p].xyz[k]), false);
        r->hull.back()->setMargin(btScalar(b.hull[p].margin));
        r->hull.back()->recalcLocalAabb();
    }
    if (b.hulls == 1) return r->hull[0].get();
    r->compound.reset(new btCompoundShape);
    for (size_t k = 0; k < r->hull.size(); k++) r->compound->addChildShape(btTransform::getIdentity(), r->hull[k].get());
    return r->compound.get();
}

} // namespace

struct bullet {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    world w;
    std::vector<rigid> all;

    bullet(int32_t iterations, friction_of friction, const void *user)
        : dispatcher(&configuration), w(&dispatcher, &broadphase, &solver, &configuration, friction, user)
    {
        w.getDispatchInfo().m_deterministicOverlappingPairs = true;
        w.getSolverInfo().m_numIterations = iterations;
        w.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }
    ~bullet()
    {
        for (size_t k = 0; k < all.size(); k++) bullet_leave_out(this, int32_t(k));
    }
};

bullet *bullet_open(int32_t iterations, friction_of friction, const void *user)
{
    try {
        return new bullet(iterations, friction, user);
    } catch (...) {
        return nullptr;
    }
}

void bullet_close(bullet *w) { delete w; }

static void add(bullet *w, const bullet_body &b)
{
    rigid r;
    const btVector3 moments = principal(b, &r.axes);
    r.mass = btScalar(b.mass);
    r.motion.reset(new btDefaultMotionState(btTransform(r.axes, vector(b.centroid) + vector(b.lift))));
    btRigidBody::btRigidBodyConstructionInfo info(b.fixed ? 0 : r.mass, r.motion.get(), shape_of(b, &r),
                                                  b.fixed ? btVector3(0, 0, 0) : moments);
    info.m_restitution = btScalar(b.restitution);
    info.m_linearDamping = info.m_angularDamping = btScalar(b.damping);
    r.body.reset(new btRigidBody(info));
    r.body->setUserIndex(b.id);
    r.body->setActivationState(DISABLE_DEACTIVATION);           /* a slow fall is no rest */
    w->all.push_back(std::move(r));
    w->w.addRigidBody(w->all.back().body.get());
}

int bullet_add(bullet *w, const bullet_body *body)
{
    try {
        add(w, *body);
        return 1;
    } catch (...) {
        return 0;
    }
}

void bullet_leave_out(bullet *w, int32_t body)
{
    btRigidBody *b = w->all[size_t(body)].body.get();
    if (b->isInWorld()) w->w.removeRigidBody(b);
}

void bullet_gravity(bullet *w, const double g[3])
{
    for (size_t k = 0; k < w->all.size(); k++)
        w->all[k].body->setGravity(w->all[k].body->isStaticObject() ? btVector3(0, 0, 0) : vector(g));
}

int bullet_step(bullet *w, double dt)
{
    try {
        w->w.stepSimulation(btScalar(dt), 0);
        return 1;
    } catch (...) {
        return 0;
    }
}

void bullet_where(const bullet *w, int32_t body, double R[9], double t[3])
{
    const rigid &r = w->all[size_t(body)];
    const btMatrix3x3 turn = r.body->getWorldTransform().getBasis() * r.axes.transpose();
    for (int c = 0; c < 3; c++) tell(turn[c], R + 3 * c);
    tell(r.body->getWorldTransform().getOrigin(), t);
}

double bullet_energy(const bullet *w, int32_t body)
{
    const rigid &r = w->all[size_t(body)];
    const btRigidBody &b = *r.body;
    const btVector3 v = b.getLinearVelocity(), i = b.getLocalInertia();
    const btVector3 spin = b.getWorldTransform().getBasis().transpose() * b.getAngularVelocity();
    return 0.5 * double(r.mass) * double(v.length2())
         + 0.5 * double(i.x() * spin.x() * spin.x() + i.y() * spin.y() * spin.y() + i.z() * spin.z() * spin.z());
}

static void add_touch(const btPersistentManifold &m, int32_t pair, int32_t point, std::vector<bullet_touch> *all)
{
    const btManifoldPoint &p = m.getContactPoint(point);
    const int a = m.getBody0()->getUserIndex(), b = m.getBody1()->getUserIndex();
    bullet_touch t;
    t.a = std::min(a, b);
    t.b = std::max(a, b);
    t.pair = pair;
    t.point = point;
    tell(p.m_normalWorldOnB * btScalar(a > b ? 1 : -1), t.n);
    tell((p.getPositionWorldOnA() + p.getPositionWorldOnB()) * btScalar(0.5), t.x);
    t.depth = -double(p.getDistance());
    all->push_back(t);
}

int bullet_touches(bullet *w, bullet_touch **touch, int32_t *touches)
{
    try {
        std::vector<bullet_touch> all;
        w->w.performDiscreteCollisionDetection();               /* the last ones are older than the last step */
        for (int k = 0; k < w->dispatcher.getNumManifolds(); k++) {
            const btPersistentManifold &m = *w->dispatcher.getManifoldByIndexInternal(k);
            for (int i = 0; i < m.getNumContacts(); i++) add_touch(m, k, i, &all);
        }
        *touch = static_cast<bullet_touch *>(std::malloc((all.size() + 1) * sizeof **touch));
        if (!*touch) return 0;
        if (!all.empty()) std::memcpy(*touch, all.data(), all.size() * sizeof **touch);
        *touches = int32_t(all.size());
        return 1;
    } catch (...) {
        return 0;
    }
}
