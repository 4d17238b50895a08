// The frame of a mapping: where its handles are, what a drag of each does, and how it is drawn.
#include <cmath>

#include <QPainter>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "ui/base/theme.h"
#include "ui/view/mapping_gizmo.h"

namespace test_mapping_gizmo {

using namespace tactum;
using namespace tactum::test;
using enum MappingHandle;

namespace {

const MappingHandle kAll[] = {Size, Move, MoveX, MoveY, MoveZ, TurnX, TurnY, TurnZ};

/// A thousand pixels to a metre at the focus, looked at a little from above and the side.
ViewCamera camera() {
    ViewCamera c;
    c.size = {800, 600};
    c.fieldOfView = 0.6;
    c.distance = 0.3 / std::tan(0.3);
    c.yaw = 0.4;
    c.pitch = 0.3;
    return c;
}

MappingFrame frameOf(TextureMapping mapping) {
    MappingFrame frame;
    frame.mapping = mapping;
    frame.pose.translation = {0.01, 0.02, -0.03};
    frame.pose.rotation = Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()));
    frame.size = 0.08;
    frame.proportion = 0.5;
    frame.radius = 0.12;
    return frame;
}

double apart(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

class TestMappingGizmo : public QObject {
    Q_OBJECT

private slots:
    void nothingIsThereWithoutAFrame() {
        MappingGizmo gizmo;
        QVERIFY(!gizmo.frame());
        QVERIFY(!gizmo.at({400, 300}, camera()));
        for (const MappingHandle handle : kAll)
            QVERIFY(!gizmo.placeOf(handle, camera()));
        gizmo.grab(Move, {400, 300});
        QVERIFY(!gizmo.held());
        QVERIFY(gizmo.dragged({410, 300}, camera()) == MappingFrame());
        QCOMPARE(drawnBy({800, 600}, [&](QPainter& p) { gizmo.draw(p, camera(), kDarkTheme, {}); }), "\n");
        MappingFrame behind = frameOf(TextureMapping::Planar);
        behind.pose.translation = camera().eye() - camera().forward();
        gizmo.show(behind);
        QVERIFY(!gizmo.at({400, 300}, camera()));
        QVERIFY(!gizmo.placeOf(Move, camera()));
    }

    void handlesLieOnArrowsRingsAndTheRepeat() {
        const ViewCamera c = camera();
        for (const TextureMapping mapping : {TextureMapping::Triplanar, TextureMapping::Planar,
                                             TextureMapping::Cylindrical, TextureMapping::Spherical}) {
            MappingGizmo gizmo;
            const MappingFrame frame = frameOf(mapping);
            gizmo.show(frame);
            const Vec3 origin = frame.pose.translation;
            const QPointF centre = *c.project(origin);
            const double pixel = c.pixelSize(origin);
            QCOMPARE_LT(apart(*gizmo.placeOf(Move, c), centre), 1e-9);
            for (int i = 0; i < 3; ++i) {
                const Vec3 axis = frame.pose.rotate(Vec3::Unit(i));
                QCOMPARE_LT(apart(*gizmo.placeOf(MappingHandle(int(MoveX) + i), c),
                                  *c.project(origin + 78 * pixel * axis)),
                            1e-9);
                const Vec3 between =
                    std::sqrt(0.5) * 54 * pixel *
                    (frame.pose.rotate(Vec3::Unit((i + 1) % 3)) + frame.pose.rotate(Vec3::Unit((i + 2) % 3)));
                QCOMPARE_LT(
                    apart(*gizmo.placeOf(MappingHandle(int(TurnX) + i), c), *c.project(origin + between)),
                    1e-9);
            }
            const bool round = mapping == TextureMapping::Cylindrical || mapping == TextureMapping::Spherical;
            QCOMPARE(gizmo.placeOf(Radius, c).has_value(), round);
            if (round)
                QCOMPARE_LT(
                    apart(*gizmo.placeOf(Radius, c),
                          *c.project(frame.pose.apply(0.12 * Vec3(std::cos(0.6), -std::sin(0.6), 0)))),
                    1e-9);
        }
    }

    /// The corner of one repeat, but never nearer to the origin than 34 pixels.
    void theSizeIsAtTheCornerOfARepeat() {
        const ViewCamera c = camera();
        MappingGizmo gizmo;
        MappingFrame frame = frameOf(TextureMapping::Planar);
        const auto corner = [&] { return *gizmo.placeOf(Size, c); };
        gizmo.show(frame);
        QCOMPARE_LT(apart(corner(), *c.project(frame.pose.apply({0.08, 0.04, 0}))), 1e-9);
        frame.offset = {0.01, 0.02};
        frame.rotation = EIGEN_PI / 2;
        gizmo.show(frame);
        QCOMPARE_LT(apart(corner(), *c.project(frame.pose.apply({0.01 - 0.04, 0.02 + 0.08, 0}))), 1e-9);
        frame.offset.setZero();
        frame.rotation = 0;
        frame.size = 0.001;
        gizmo.show(frame);
        const QPointF centre = *c.project(frame.pose.translation);
        COMPARE_NEAR(apart(corner(), centre), 34, 1e-9, "pixels");
        frame.mapping = TextureMapping::Cylindrical;
        frame.size = 0.06;
        gizmo.show(frame);
        const double turn = 0.06 / 0.12;
        QCOMPARE_LT(apart(corner(),
                          *c.project(frame.pose.apply({0.12 * std::cos(turn), 0.12 * std::sin(turn), 0.03}))),
                    1e-9);
        frame.mapping = TextureMapping::Spherical;
        gizmo.show(frame);
        const double high = 0.03 / 0.12;
        QCOMPARE_LT(apart(corner(), *c.project(frame.pose.apply(0.12 * Vec3(std::cos(high) * std::cos(turn),
                                                                            std::cos(high) * std::sin(turn),
                                                                            std::sin(high))))),
                    1e-9);
        // Of the three sides the one that looks most to the eye.
        frame.mapping = TextureMapping::Triplanar;
        frame.size = 0.08;
        frame.pose.rotation = Quat::Identity();
        ViewCamera look = c;
        for (const auto& [yaw, pitch, p] : {std::tuple(0.1, 0.1, Vec3(0.08, 0.04, 0)),
                                            {EIGEN_PI / 2, 0.1, Vec3(0, 0.08, 0.04)},
                                            {0.1, 1.4, Vec3(0.04, 0, 0.08)}}) {
            look.yaw = yaw;
            look.pitch = pitch;
            gizmo.show(frame);
            QCOMPARE_LT(apart(*gizmo.placeOf(Size, look), *look.project(frame.pose.apply(p))), 1e-9);
        }
    }

    void handlesAreGrabbedWhereTheyAre() {
        const ViewCamera c = camera();
        MappingGizmo gizmo;
        gizmo.show(frameOf(TextureMapping::Cylindrical));
        for (const MappingHandle handle : {Size, Radius, Move, MoveX, MoveY, MoveZ, TurnX, TurnY, TurnZ}) {
            const QPointF place = *gizmo.placeOf(handle, c);
            QVERIFY(gizmo.at(place, c).has_value());
            QVERIFY(gizmo.at(place + QPointF(0, 1), c).has_value());
        }
        QCOMPARE(gizmo.at(*gizmo.placeOf(Move, c), c), std::optional(Move));
        QCOMPARE(gizmo.at(*gizmo.placeOf(Size, c), c), std::optional(Size));
        QCOMPARE(gizmo.at(*gizmo.placeOf(MoveY, c) + QPointF(8, 0), c), std::optional(MoveY));
        QVERIFY(gizmo.at(*gizmo.placeOf(MoveY, c) + QPointF(0, -10), c) != std::optional(MoveY));
        QVERIFY(!gizmo.at({5, 5}, c));
        // Along an arrow, from a fifth of it on.
        const MappingFrame frame = *gizmo.frame();
        const double pixel = c.pixelSize(frame.pose.translation);
        const Vec3 y = frame.pose.rotate(Vec3::UnitY());
        QCOMPARE(gizmo.at(*c.project(frame.pose.translation + 0.85 * 78 * pixel * y), c),
                 std::optional(MoveY));
        // A ring can be taken anywhere.
        MappingGizmo flat;
        flat.show(frameOf(TextureMapping::Planar));
        const Vec3 x = frame.pose.rotate(Vec3::UnitX());
        const QPointF onRing = *c.project(frame.pose.translation + 54 * pixel * (-0.8 * x - 0.6 * y));
        QCOMPARE(flat.at(onRing, c), std::optional(TurnZ));
        QCOMPARE(flat.at(onRing + QPointF(-4, 0), c), std::optional(TurnZ));
        QVERIFY(!flat.at(onRing + QPointF(-12, 12), c));
    }

    /// Each handle changes one thing, from where it was taken.
    void dragsChangeOneThing() {
        const ViewCamera c = camera();
        const MappingFrame frame = frameOf(TextureMapping::Cylindrical);
        MappingGizmo gizmo;
        gizmo.show(frame);
        const auto drag = [&](MappingHandle handle, QPointF by) {
            const QPointF from = *gizmo.placeOf(handle, c);
            gizmo.grab(handle, from);
            const MappingFrame made = gizmo.dragged(from + by, c);
            const MappingFrame rest = gizmo.dragged(from, c);
            gizmo.letGo();
            if (!(rest.pose.translation - frame.pose.translation).isZero(1e-9)) qFatal("it moves at rest");
            return made;
        };
        // The point under the cursor stays under it.
        MappingFrame moved = drag(Move, {30, -20});
        QCOMPARE_LT(
            apart(*c.project(moved.pose.translation), *c.project(frame.pose.translation) + QPointF(30, -20)),
            1e-6);
        COMPARE_NEAR(c.depth(moved.pose.translation), c.depth(frame.pose.translation), 1e-9, "m");
        moved.pose.translation = frame.pose.translation;
        QVERIFY(moved == frame);
        for (int i = 0; i < 3; ++i) {
            const auto handle = MappingHandle(int(MoveX) + i);
            const Vec3 axis = frame.pose.rotate(Vec3::Unit(i));
            const QPointF along = *gizmo.placeOf(handle, c) - *c.project(frame.pose.translation);
            MappingFrame made = drag(handle, along * 0.5);
            const Vec3 way = made.pose.translation - frame.pose.translation;
            COMPARE_NEAR(way.cross(axis).norm(), 0, 1e-9, "m"); // along its axis alone
            QCOMPARE_GT(way.dot(axis), 0.0);
            const double pixel = c.pixelSize(frame.pose.translation);
            COMPARE_NEAR(way.norm() / (39 * pixel), 1, 0.2, ""); // half of the arrow, but for the perspective
            made.pose.translation = frame.pose.translation;
            QVERIFY(made == frame);
            const auto turn = MappingHandle(int(TurnX) + i);
            // By a tenth of a radian: the place on the ring goes along with the cursor.
            const QPointF on = *gizmo.placeOf(turn, c);
            MappingFrame turned = frame;
            turned.pose.rotation = frame.pose.rotation * Quat(Eigen::AngleAxisd(0.1, Vec3::Unit(i)));
            MappingGizmo then;
            then.show(turned);
            made = drag(turn, *then.placeOf(turn, c) - on);
            const Quat by = frame.pose.rotation.conjugate() * made.pose.rotation;
            COMPARE_NEAR(Eigen::AngleAxisd(by).angle(), 0.1, 0.02, "rad");
            COMPARE_NEAR(by.vec().normalized(), Vec3(Vec3::Unit(i)), 1e-6, "");
            COMPARE_NEAR(made.pose.rotation.norm(), 1, 1e-12, "");
            made.pose.rotation = frame.pose.rotation;
            QVERIFY(made == frame);
        }
        const QPointF centre = *c.project(frame.pose.translation);
        for (const MappingHandle handle : {Size, Radius}) {
            const QPointF out = *gizmo.placeOf(handle, c) - centre;
            MappingFrame twice = drag(handle, out), half = drag(handle, -0.5 * out),
                         least = drag(handle, -out);
            double MappingFrame::*value = handle == Size ? &MappingFrame::size : &MappingFrame::radius;
            COMPARE_NEAR(twice.*value, 2 * frame.*value, 1e-9, "m");
            COMPARE_NEAR(half.*value, 0.5 * frame.*value, 1e-9, "m");
            COMPARE_NEAR(least.*value, 6 / std::hypot(out.x(), out.y()) * frame.*value, 1e-9, "m");
            twice.*value = frame.*value;
            QVERIFY(twice == frame);
        }
        gizmo.grab(Size, centre + QPointF(40, 0));
        QCOMPARE(gizmo.dragged(centre + QPointF(1e9, 0), c).size, kTextureSize.maximum);
        QVERIFY(gizmo.held());
        gizmo.letGo();
        QVERIFY(!gizmo.held());
        QVERIFY(gizmo.dragged(centre, c) == frame);
    }

    void anArrowThatPointsIntoTheEyeStays() {
        ViewCamera c = camera();
        c.yaw = c.pitch = 0;
        MappingFrame frame = frameOf(TextureMapping::Planar);
        frame.pose = {};
        MappingGizmo gizmo;
        gizmo.show(frame);
        gizmo.grab(MoveZ, {400, 300});
        QVERIFY(gizmo.dragged({480, 300}, c) == frame);
    }

    void itIsDrawn() {
        const ViewCamera c = camera();
        MappingGizmo gizmo;
        const auto drawn = [&](QPointF cursor) {
            return drawnBy({800, 600}, [&](QPainter& p) { gizmo.draw(p, c, kDarkTheme, cursor); });
        };
        for (const auto& [mapping, name] : {std::pair(TextureMapping::Triplanar, "gizmo-triplanar"),
                                            {TextureMapping::Planar, "gizmo-planar"},
                                            {TextureMapping::Cylindrical, "gizmo-cylinder"},
                                            {TextureMapping::Spherical, "gizmo-sphere"}}) {
            gizmo.show(frameOf(mapping));
            COMPARE_SHOWN(drawn({5, 5}), name);
        }
        COMPARE_SHOWN(drawn(*gizmo.placeOf(MoveX, c)), "gizmo-over-arrow");
        COMPARE_SHOWN(drawn(*gizmo.placeOf(Radius, c)), "gizmo-over-radius");
        gizmo.grab(TurnY, *gizmo.placeOf(TurnY, c));
        COMPARE_SHOWN(drawn({5, 5}), "gizmo-held-ring");
    }
};

TACTUM_GUI_TEST(TestMappingGizmo)

} // namespace test_mapping_gizmo

#include "test_mapping_gizmo.moc"
