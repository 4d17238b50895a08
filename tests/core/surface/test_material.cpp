// A material as a person sets it: one number at a time, in its range, and never more dynamic than static
// friction.
#include <limits>

#include <QTest>

#include "core/surface/material.h"
#include "core/surface/texture_parameters.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_material {

using namespace tactum;

namespace {

/// The field of a key, which exists.
const MaterialField& field(const Parameter& parameter) {
    return *std::ranges::find(kMaterialFields, &parameter, &MaterialField::parameter);
}

} // namespace

class TestMaterial : public QObject {
    Q_OBJECT

private slots:
    /// Values that no other field has: whoever sets another one too is seen.
    void oneNumberIsSetAndNoOther() {
        const Material before{111, 2.5, 0.75, 0.25, 3.5};
        for (const MaterialField& each : kMaterialFields) {
            const double middle = each.parameter == &kDynamicFriction  ? 0.5
                                  : each.parameter == &kStaticFriction ? 0.5
                                                                       : 0.5 * before.*each.value;
            Material wanted = before;
            wanted.*each.value = middle;
            QVERIFY2(withValue(before, each, middle) == wanted, each.parameter->key.data());
        }
    }

    void dynamicFrictionNeverExceedsStatic() {
        const Material before{111, 2.5, 0.75, 0.25, 3.5};
        const Material slippery = withValue(before, field(kStaticFriction), 0.1);
        QCOMPARE(slippery.staticFriction, 0.1);
        QCOMPARE(slippery.dynamicFriction, 0.1);
        const Material rough = withValue(before, field(kDynamicFriction), 0.9);
        QCOMPARE(rough.staticFriction, 0.9);
        QCOMPARE(rough.dynamicFriction, 0.9);
        for (const Material& made : {slippery, rough}) {
            QCOMPARE(made.stiffness, before.stiffness);
            QCOMPARE(made.damping, before.damping);
            QCOMPARE(made.viscosity, before.viscosity);
        }
    }

    void valuesAreBroughtIntoTheirRange() {
        for (const MaterialField& each : kMaterialFields) {
            const Parameter& of = *each.parameter;
            const double width = of.maximum - of.minimum;
            QCOMPARE(withValue({}, each, of.minimum - width).*each.value, of.minimum);
            QCOMPARE(withValue({}, each, of.maximum + width).*each.value, of.maximum);
            for (const double none : {std::nan(""), std::numeric_limits<double>::infinity()})
                QCOMPARE(withValue({}, each, none).*each.value, of.initial);
            QVERIFY(of.allows(of.minimum) && of.allows(of.maximum) && of.allows(of.initial));
            QVERIFY(!of.allows(of.minimum - 1e-6 * width));
            QVERIFY(!of.allows(of.maximum + 1e-6 * width));
            QVERIFY(!of.allows(std::nan("")));
        }
    }

    /// A new surface: as hard as a device can show without doubt, smooth, dry.
    void aNewOneIsFirmAndSmooth() {
        const Material made;
        QCOMPARE_GT(made.stiffness, 0.0);
        QCOMPARE(made.damping, 0.0);
        QCOMPARE(made.staticFriction, 0.0);
        QCOMPARE(made.dynamicFriction, 0.0);
        QCOMPARE(made.viscosity, 0.0);
        for (const MaterialField& each : kMaterialFields)
            QCOMPARE(made.*each.value, each.parameter->initial);
    }
};

TACTUM_TEST(TestMaterial)

} // namespace test_material

#include "test_material.moc"
