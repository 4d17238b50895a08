// Accelerations and effective masses of random trees beside MuJoCo's, which shares nothing with this code.
//
// What would show that the test itself is wrong: trees that MuJoCo does not compile fail by its own sentence;
// the accelerations that are compared are hundreds of rad/s^2, not zeros (which is checked); and leaving out
// one term here (gravity, the velocity products, one link's inertia) makes them differ at once.

#include <cmath>
#include <random>

#include <QTemporaryDir>
#include <QTest>
#include <mujoco/mujoco.h>

#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_mujoco {

using namespace tactum;
using namespace tactum::test;

namespace {

enum class Kind { Hinge, Slider, Ball, Free };

struct Made {
    Kind kind;
    int parent; ///< body, -1 for the world
    Vec3 at, axis;
};

/// A tree as both programs get it.
class RandomTree {
public:
    explicit RandomTree(unsigned seed) : random_(seed) {
        const int count = 1 + int(random_() % 50);
        for (int i = 0; i < count; ++i)
            addBody(i);
    }

    std::vector<RigidBody> bodies;
    std::vector<Joint> joints; ///< none for a body that is free
    std::vector<Made> made;

    static QByteArray nameOf(std::size_t body) { return "b" + QByteArray::number(qulonglong(body)); }
    QByteArray mjcf() const {
        QByteArray text = "<mujoco><compiler angle='radian' inertiafromgeom='false'/>"
                          "<option gravity='0.3 -9.81 0.7'><flag constraint='disable'/></option><worldbody>";
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (made[i].parent < 0) text += bodyText(i);
        return text + "</worldbody></mujoco>";
    }

private:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    Vec3 vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
    Quat turn() { return Quat(number(-1, 1), number(-1, 1), number(-1, 1), number(0.1, 1)).normalized(); }

    void addBody(int i) {
        const int parent = i == 0 || random_() % 8 == 0 ? -1 : int(random_() % unsigned(i));
        Made one{Kind(random_() % 3), parent, vector(), vector().normalized()};
        if (parent < 0 && random_() % 2) one.kind = Kind::Free;
        RigidBody body = bodyAt(BodyId(i + 1), one.at + 0.3 * vector(), number(0.1, 3));
        body.pose.rotation = turn();
        const double a = number(0.01, 0.1), b = number(0.01, 0.1);
        body.inertia = {a, b, a + b - number(0, 0.01)};
        if (one.kind == Kind::Free) {
            body.mass = 10; // what is free hangs on its heaviest body: here the same for both
        } else {
            body.centre = 0.2 * vector();
            body.inertiaFrame = turn();
        }
        bodies.push_back(body);
        made.push_back(one);
        const BodyId above = BodyId(parent + 1), own = BodyId(i + 1);
        if (one.kind == Kind::Hinge) joints.push_back(hingeAt(bodies, above, own, one.at, one.axis));
        if (one.kind == Kind::Slider) joints.push_back(sliderAt(bodies, above, own, one.at, one.axis));
        if (one.kind == Kind::Ball) // seen along the axes of the body, as MuJoCo sees it
            joints.push_back(
                jointAt(bodies, above, own, one.at, body.pose.rotation, {lock(false, kAllAxes)}));
    }

    static QByteArray text(const Vec3& v) {
        return QByteArray::number(v.x(), 'g', 17) + ' ' + QByteArray::number(v.y(), 'g', 17) + ' ' +
               QByteArray::number(v.z(), 'g', 17);
    }
    static QByteArray text(const Quat& q) { return QByteArray::number(q.w(), 'g', 17) + ' ' + text(q.vec()); }

    QByteArray bodyText(std::size_t i) const {
        const RigidBody& body = bodies[i];
        const Made& one = made[i];
        const Pose above = one.parent < 0 ? Pose{} : bodies[std::size_t(one.parent)].pose;
        const Pose local = above.inverse() * body.pose;
        QByteArray out = "<body name='" + nameOf(i) + "' pos='" + text(local.translation) + "' quat='" +
                         text(local.rotation) + "'>";
        const QByteArray at = "pos='" + text(body.pose.applyInverse(one.at)) + "' ";
        const QByteArray axis = "axis='" + text(body.pose.rotateInverse(one.axis)) + "' ";
        if (one.kind == Kind::Free) out += "<freejoint/>";
        if (one.kind == Kind::Hinge) out += "<joint type='hinge' " + at + axis + "/>";
        if (one.kind == Kind::Slider) out += "<joint type='slide' " + at + axis + "/>";
        if (one.kind == Kind::Ball) out += "<joint type='ball' " + at + "/>";
        out += "<inertial pos='" + text(body.centre) + "' quat='" + text(body.inertiaFrame) + "' mass='" +
               QByteArray::number(body.mass, 'g', 17) + "' diaginertia='" + text(body.inertia) + "'/>";
        for (std::size_t k = 0; k < bodies.size(); ++k)
            if (made[k].parent == int(i)) out += bodyText(k);
        return out + "</body>";
    }

    std::mt19937 random_;
};

/// MuJoCo's model of a tree, its bodies by the order in which the text has them.
class Other {
public:
    explicit Other(const RandomTree& tree) {
        QTemporaryDir folder;
        QFile file(folder.filePath("tree.xml"));
        if (!file.open(QIODevice::WriteOnly)) return;
        file.write(tree.mjcf());
        file.close();
        std::array<char, 1000> error{};
        model_ = mj_loadXML(file.fileName().toUtf8().constData(), nullptr, error.data(), int(error.size()));
        if (!model_) qWarning() << error.data();
        if (model_) data_ = mj_makeData(model_);
        for (std::size_t i = 0; model_ && i < tree.bodies.size(); ++i)
            bodies_.push_back(mj_name2id(model_, mjOBJ_BODY, RandomTree::nameOf(i)));
    }
    ~Other() {
        if (data_) mj_deleteData(data_);
        if (model_) mj_deleteModel(model_);
    }
    Other(const Other&) = delete;
    Other& operator=(const Other&) = delete;

    mjModel* model() { return model_; }
    mjData* data() { return data_; }
    int bodyOf(std::size_t body) const { return bodies_[body]; }
    int joint(std::size_t body) const { return model_->body_jntadr[bodies_[body]]; }
    double* q(std::size_t body) { return data_->qpos + model_->jnt_qposadr[joint(body)]; }
    int dof(std::size_t body) const { return model_->jnt_dofadr[joint(body)]; }

private:
    mjModel* model_ = nullptr;
    mjData* data_ = nullptr;
    std::vector<int> bodies_;
};

} // namespace

class MujocoTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        mju_user_error = [](const char* text) { qFatal("%s", text); };
        mju_user_warning = [](const char* text) { qWarning("%s", text); };
    }
    void accelerationsAreTheirs();
};

void MujocoTest::accelerationsAreTheirs() {
    double worst = 0, worstMass = 0, largest = 0;
    int trees = 0;
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        const RandomTree tree(seed);
        Running run(tree.bodies, tree.joints);
        Other other(tree);
        QVERIFY(other.model());
        const Mechanism& mechanism = run.mechanism();
        QCOMPARE(mechanism.vs, other.model()->nv);
        std::mt19937 random(seed);
        const auto any = [&](double most) { return std::uniform_real_distribution(-most, most)(random); };
        DynamicState& state = run.state();
        std::vector<int> ours(std::size_t(mechanism.vs)); // of each of theirs
        for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
            const Link& link = mechanism.links[std::size_t(mechanism.places[i].link)];
            const int dof = other.dof(i);
            double* q = other.q(i);
            if (tree.made[i].kind == Kind::Free) {
                for (int k = 0; k < 3; ++k) {
                    q[k] = state.q[link.q - 3 + k] += any(1);
                    ours[std::size_t(dof + k)] = link.v - 3 + k;
                }
                q += 3;
            }
            const int first = tree.made[i].kind == Kind::Free ? dof + 3 : dof;
            if (link.kind == LinkKind::Ball) {
                const Quat turn = Quat(any(1), any(1), any(1), 1.1).normalized();
                state.q.segment<4>(link.q) = turn.coeffs();
                q[0] = turn.w();
                for (int k = 0; k < 3; ++k) {
                    q[1 + k] = turn.vec()[k];
                    ours[std::size_t(first + k)] = link.v + k;
                }
            } else {
                q[0] = any(2);
                state.q[link.q] += q[0];
                ours[std::size_t(first)] = link.v;
            }
        }
        for (int i = 0; i < mechanism.vs; ++i)
            state.v[ours[std::size_t(i)]] = other.data()->qvel[i] = any(3);
        // A force off the centre of one body.
        const std::size_t pushed = random() % tree.bodies.size();
        const Vec3 force(any(5), any(5), any(5));
        const RigidBody& body = tree.bodies[pushed];
        Place place = mechanism.places[pushed];
        place.pose = place.pose * Pose{Quat::Identity(), body.centre + Vec3(0.1, 0.2, 0.3)};
        const AppliedForce push{place, force};
        Coordinates acceleration = Coordinates::Zero(mechanism.vs);
        run.dynamics().accelerations(state, Vec3(0.3, -9.81, 0.7), {&push, 1}, acceleration);
        mj_kinematics(other.model(), other.data());
        mj_comPos(other.model(), other.data());
        Articulation articulation(mechanism);
        articulation.place(state.q, state.v);
        articulation.factor();
        const Vec3 point = articulation.poseOf(place).translation;
        const Vec3 zero = Vec3::Zero();
        mju_zero(other.data()->qfrc_applied, mechanism.vs);
        mj_applyFT(other.model(), other.data(), force.data(), zero.data(), point.data(), other.bodyOf(pushed),
                   other.data()->qfrc_applied);
        mj_forward(other.model(), other.data());
        const double scale = acceleration.norm();
        for (int i = 0; i < mechanism.vs; ++i)
            worst =
                std::max(worst, std::abs(acceleration[ours[std::size_t(i)]] - other.data()->qacc[i]) / scale);
        largest = std::max(largest, scale);
        // J M^-1 J^T at that point, along one direction.
        const Vec3 way = force.normalized();
        const Island& island =
            mechanism.islands[std::size_t(mechanism.links[std::size_t(place.link)].island)];
        Coordinates jacobian = Coordinates::Zero(island.velocities), change = jacobian;
        articulation.addJacobian(place.link, {way, point, Vec3::Zero()}, 1, jacobian.data());
        articulation.respond(island, jacobian.data(), change.data());
        std::vector<double> theirs(3 * std::size_t(mechanism.vs)), row(std::size_t(mechanism.vs)),
            solved(std::size_t(mechanism.vs));
        mj_jac(other.model(), other.data(), theirs.data(), nullptr, point.data(), other.bodyOf(pushed));
        for (int i = 0; i < mechanism.vs; ++i)
            for (int k = 0; k < 3; ++k)
                row[std::size_t(i)] += way[k] * theirs[std::size_t(k * mechanism.vs + i)];
        mj_solveM(other.model(), other.data(), solved.data(), row.data(), 1);
        const double mass = mju_dot(row.data(), solved.data(), mechanism.vs);
        worstMass = std::max(worstMass, std::abs(jacobian.dot(change) / mass - 1));
        ++trees;
    }
    QCOMPARE(trees, 1000);
    QVERIFY(largest > 100);
    COMPARE_NEAR(worst, 0, 1e-9, "");
    COMPARE_NEAR(worstMass, 0, 1e-9, "");
    qInfo("1000 trees: accelerations within %.2g, effective masses within %.2g", worst, worstMass);
}

TACTUM_TEST(MujocoTest)

} // namespace test_mujoco

#include "test_mujoco.moc"
