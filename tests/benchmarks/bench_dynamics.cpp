// bench_dynamics: a step of what moves by forces, beside MuJoCo and, where it is installed, Bullet, by turns.
// Prints the table of docs/performance.md. The same bodies, joints and step in each; each as its makers
// advise for real time: MuJoCo with its own solver and warm start, Bullet with multi-bodies where there are
// joints.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>
#ifdef TACTUM_BULLET
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#endif

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "tests/benchmarks/shapes.h"
#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/soups.h"

namespace {

using namespace tactum;
using namespace tactum::test;

constexpr double kDt = 5e-4; // s
constexpr int kTurns = 9, kSteps = 1000;
constexpr double kSide = 0.04; // m, of a box

using Step = std::function<void()>;

struct Subject {
    std::string name;
    Step ours, mujoco, mujocoFour, bullet; ///< one step; empty: not measured
};

Step ofOurs(const Mechanics& scene) {
    auto running = std::make_shared<Running>(scene);
    running->run(0.5, kDt, scene.gravity);
    return
        [running, gravity = scene.gravity] { running->dynamics().step(running->state(), gravity, {}, kDt); };
}

Step ofMujoco(const std::string& inside, bool fourth) {
    const std::string file = "/tmp/bench-dynamics.xml", integrator = fourth ? "RK4" : "Euler";
    std::FILE* out = std::fopen(file.c_str(), "w");
    std::fprintf(out,
                 "<mujoco><compiler angle='radian'/><option timestep='%g' gravity='0 -9.81 0' "
                 "integrator='%s'/>%s</mujoco>",
                 kDt, integrator.c_str(), inside.c_str());
    std::fclose(out);
    char error[1000] = "";
    mjModel* model = mj_loadXML(file.c_str(), nullptr, error, sizeof error);
    if (!model) {
        std::fprintf(stderr, "MuJoCo: %s\n", error);
        return {};
    }
    mjData* data = mj_makeData(model);
    for (int i = 0; i < 1000; ++i)
        mj_step(model, data);
    return [model, data] { mj_step(model, data); };
}

std::string text(const Vec3& v) {
    std::ostringstream out;
    out << v.x() << ' ' << v.y() << ' ' << v.z();
    return out.str();
}

/// A chain as chainOf() makes it, with whatever hangs on its end.
std::string chainText(int links, const std::string& atEnd = "") {
    std::string open, close;
    for (int i = 0; i < links; ++i) {
        open += "<body name='b" + std::to_string(i) + "' pos='" + (i ? "0.1" : "0") +
                " 0 0'><joint type='hinge' axis='" + (i % 2 ? "0 1 0" : "0 0 1") +
                "'/><inertial pos='0.05 0 0' mass='0.1' diaginertia='1e-5 8.3333e-5 8.3333e-5'/>";
        close += "</body>";
    }
    return "<worldbody>" + open + close + atEnd + "</worldbody>";
}

#ifdef TACTUM_BULLET
struct BulletWorld {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btMultiBodyConstraintSolver solver;
    btMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    std::vector<std::unique_ptr<btCollisionShape>> shapes;

    BulletWorld() { world.setGravity({0, btScalar(-9.81), 0}); }
    void step() { world.stepSimulation(btScalar(kDt), 0); }
};

Step chainInBullet(int links) {
    auto made = std::make_shared<BulletWorld>();
    auto* body = new btMultiBody(links, 0, {0, 0, 0}, true, false);
    for (int i = 0; i < links; ++i)
        body->setupRevolute(i, btScalar(0.1), {btScalar(1e-5), btScalar(8.3333e-5), btScalar(8.3333e-5)},
                            i - 1, btQuaternion(0, 0, 0, 1), i % 2 ? btVector3(0, 1, 0) : btVector3(0, 0, 1),
                            btVector3(i ? btScalar(0.05) : 0, 0, 0), btVector3(btScalar(0.05), 0, 0), true);
    body->finalizeMultiDof();
    body->setLinearDamping(0);
    body->setAngularDamping(0);
    made->world.addMultiBody(body);
    for (int i = 0; i < 1000; ++i)
        made->step();
    return [made] { made->step(); };
}

/// The first of them are boxes, the rest balls.
Step looseInBullet(const std::vector<Vec3>& places, std::size_t boxes) {
    auto made = std::make_shared<BulletWorld>();
    const auto add = [&](btCollisionShape* shape, double mass, const Vec3& at) {
        made->shapes.emplace_back(shape);
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
        btTransform pose;
        pose.setIdentity();
        pose.setOrigin({btScalar(at.x()), btScalar(at.y()), btScalar(at.z())});
        auto* body = new btRigidBody(btScalar(mass), new btDefaultMotionState(pose), shape, inertia);
        body->setActivationState(DISABLE_DEACTIVATION);
        made->world.addRigidBody(body);
    };
    add(new btStaticPlaneShape({0, 1, 0}, 0), 0, Vec3::Zero());
    const btScalar half = btScalar(kSide / 2);
    for (std::size_t i = 0; i < places.size(); ++i)
        add(i < boxes ? (btCollisionShape*)new btBoxShape({half, half, half}) : new btSphereShape(half),
            0.064, places[i]);
    for (int i = 0; i < 1000; ++i)
        made->step();
    return [made] { made->step(); };
}
#endif

Subject chain(int links) {
    Subject subject{"chain of " + std::to_string(links) + " hinges, alternating axes", {}, {}, {}, {}};
    const Chain made = chainOf(links);
    Mechanics scene;
    scene.bodies = made.bodies;
    scene.joints = made.joints;
    subject.ours = ofOurs(scene);
    subject.mujoco = ofMujoco(chainText(links), false);
    subject.mujocoFour = ofMujoco(chainText(links), true);
#ifdef TACTUM_BULLET
    subject.bullet = chainInBullet(links);
#endif
    return subject;
}

/// Eight hinges in a chain beside a crank: wheel, rod and piston, whose pin closes the loop.
Subject crank() {
    Subject subject{"8 hinges and a crank with its loop", {}, {}, {}, {}};
    Chain made = chainOf(8);
    const BodyId wheel = 9, rod = 10, piston = 11;
    const Vec3 axle(0, 0, 1), pin(0.02, 0, 1), end(0.09, 0, 1), moments = Vec3::Constant(1e-5);
    made.bodies.push_back(bodyAt(wheel, axle, 0.1, moments));
    made.bodies.push_back(bodyAt(rod, 0.5 * (pin + end), 0.05, moments));
    made.bodies.push_back(bodyAt(piston, end, 0.05, moments));
    made.bodies[8].angularVelocity = {0, 0, 20};
    made.joints.push_back(hingeAt(made.bodies, kWorldBody, wheel, axle));
    made.joints.push_back(hingeAt(made.bodies, wheel, rod, pin));
    made.joints.push_back(sliderAt(made.bodies, kWorldBody, piston, end, Vec3::UnitX()));
    made.joints.push_back(hingeAt(made.bodies, rod, piston, end));
    Mechanics scene;
    scene.bodies = made.bodies;
    scene.joints = made.joints;
    subject.ours = ofOurs(scene);
    const std::string crank =
        "<body name='wheel' pos='0 0 1'><joint type='hinge' axis='0 0 1'/><inertial pos='0 0 0' mass='0.1' "
        "diaginertia='1e-5 1e-5 1e-5'/><body name='rod' pos='0.02 0 0'><joint type='hinge' axis='0 0 "
        "1'/><inertial "
        "pos='0.035 0 0' mass='0.05' diaginertia='1e-5 1e-5 1e-5'/></body></body><body name='piston' "
        "pos='0.09 0 1'>"
        "<joint type='slide' axis='1 0 0'/><inertial pos='0 0 0' mass='0.05' diaginertia='1e-5 1e-5 "
        "1e-5'/></body>";
    const std::string whole =
        chainText(8, crank) + "<equality><connect body1='rod' body2='piston' anchor='0.07 0 0'/></equality>";
    subject.mujoco = ofMujoco(whole, false);
    subject.mujocoFour = ofMujoco(whole, true);
    return subject;
}

Subject loose(const std::string& name, const std::vector<Vec3>& places, std::size_t boxes) {
    Subject subject{name, {}, {}, {}, {}};
    Mechanics scene;
    std::string others = "<worldbody><geom type='plane' size='5 5 0.1' zaxis='0 1 0'/>";
    const double moment = 0.064 * kSide * kSide / 6;
    for (const Vec3& at : places) {
        scene.bodies.push_back(bodyAt(BodyId(scene.bodies.size() + 1), at, 0.064, Vec3::Constant(moment)));
        Collider box;
        box.body = scene.bodies.back().id;
        const bool isBox = scene.bodies.size() <= boxes;
        box.shape.kind = isBox ? ShapeKind::Box : ShapeKind::Sphere, box.shape.size = Vec3::Constant(kSide);
        box.shape.radius = kSide / 2;
        scene.colliders.push_back(box);
        others += "<body pos='" + text(at) + "'><freejoint/><geom type='" + (isBox ? "box" : "sphere") +
                  "' size='0.02 0.02 0.02' mass='0.064'/></body>";
    }
    Collider floor;
    floor.shape.kind = ShapeKind::Box, floor.shape.size = {10, 1, 10};
    floor.pose.translation.y() = -0.5;
    floor.part = 1;
    scene.colliders.push_back(floor);
    subject.ours = ofOurs(scene);
    subject.mujoco = ofMujoco(others + "</worldbody>", false);
    subject.mujocoFour = ofMujoco(others + "</worldbody>", true);
#ifdef TACTUM_BULLET
    subject.bullet = looseInBullet(places, boxes);
#endif
    return subject;
}

Subject stacks(int count, int high) {
    std::vector<Vec3> places;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < high; ++k)
            places.push_back({0.1 * i, kSide * (k + 0.5), 0});
    const std::string contacts = std::to_string(4 * count * high) + " contacts";
    const std::string what = high > 1
                                 ? std::to_string(count) + " stacks of " + std::to_string(high) + " boxes, "
                                 : std::to_string(count) + " boxes on a plane, ";
    return loose(what + contacts, places, places.size());
}

/// Each box has four contacts, each ball one.
Subject boxesAndBalls(std::size_t boxes, std::size_t balls) {
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < boxes + balls; ++i)
        places.push_back({0.1 * double(i), kSide / 2, 0});
    return loose(std::to_string(boxes) + " boxes and " + std::to_string(balls) + " balls on a plane, " +
                     std::to_string(4 * boxes + balls) + " contacts",
                 places, boxes);
}

/// Of this thread, s: what other programs take does not count.
double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// us a step.
double timeOf(const Step& step) {
    const double begin = processorTime();
    for (int i = 0; i < kSteps; ++i)
        step();
    return 1e6 * (processorTime() - begin) / kSteps;
}

std::string cell(const std::vector<double>& times) {
    if (times.empty()) return "-";
    char out[32];
    std::snprintf(out, sizeof out, "%.1f", *std::ranges::min_element(times));
    return out;
}

void measure(const Subject& subject) {
    const Step* all[] = {&subject.ours, &subject.mujoco, &subject.mujocoFour, &subject.bullet};
    std::vector<double> times[4];
    for (int turn = 0; turn < kTurns; ++turn)
        for (int i = 0; i < 4; ++i)
            if (*all[i]) times[i].push_back(timeOf(*all[i]));
    std::printf("| %s | %s | %s | %s | %s |\n", subject.name.c_str(), cell(times[0]).c_str(),
                cell(times[1]).c_str(), cell(times[2]).c_str(), cell(times[3]).c_str());
    std::fflush(stdout);
}

/// Whole haptic steps: a finger that strokes a model of that many triangles, beside a chain of bodies.
void measureHaptics(int triangles, int links) {
    const Soup soup = std::make_shared<const TriangleSoup>(
        bench::soupOf({bench::Family::Sphere, int(std::sqrt(triangles / 12.0))}));
    Scene scene;
    SceneObject still;
    still.name = "model";
    still.geometry = soup;
    still.surfaces.resize(1);
    scene.add(std::move(still));
    const Chain made = chainOf(links);
    scene.mechanics.bodies = made.bodies;
    scene.mechanics.joints = made.joints;
    for (const RigidBody& body : made.bodies) {
        SceneObject link;
        link.name = body.name;
        link.geometry = plate(0.02, 0.02);
        link.pose = Pose{Quat::Identity(), body.pose.translation + Vec3(0.3, 0, 0)};
        link.surfaces.resize(1);
        link.body = body.id;
        scene.add(std::move(link));
    }
    const auto world = compile(scene).value();
    SimState state;
    std::vector<double> times;
    const double radius = boundsOf(*soup).diagonal() / 2 / std::sqrt(3.0);
    for (int i = 0; i < 20000; ++i) {
        const double a = i * kDt * 0.15 / radius;
        const Vec3 finger = (radius - 0.002) * Vec3(std::cos(a), std::sin(a), 0.1);
        const double begin = processorTime();
        hapticStep(*world, state, {.finger = finger}, kDt);
        times.push_back(1e6 * (processorTime() - begin));
    }
    std::ranges::sort(times);
    double sum = 0;
    for (const double time : times)
        sum += time;
    std::printf("\nHaptic step over %zu triangles with %d bodies: mean %.1f us, median %.1f us, 99 %% %.1f "
                "us: %.1f kHz\n",
                soup->triangles.size(), links, sum / double(times.size()), times[times.size() / 2],
                times[times.size() * 99 / 100], 1e3 * double(times.size()) / sum);
}

} // namespace

int main() {
    std::puts("| us a step of 0.5 ms | Tactum | MuJoCo 2.2.2, Euler | MuJoCo, RK4 | Bullet 3.24 |\n| :-- | "
              "--: | --: | --: | --: |");
    for (const int links : {10, 50})
        measure(chain(links));
    measure(crank());
    measure(stacks(5, 3));
    measure(stacks(15, 1));
    measure(boxesAndBalls(8, 7));
    measureHaptics(200000, 50);
}
