#include "ui/panels/world_fields.h"

#include <array>

#include "core/scene/bodies.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/parameter_field.h"
#include "ui/widgets/columns.h"

namespace tactum {
namespace {

constexpr std::array<Parameter, 3> kGravity{{
    {"gravity-x", QT_TR_NOOP("Gravity x"), "m/s\u00b2", -1e4, 1e4, 0.1, 0, 2,
     QT_TR_NOOP("What makes bodies fall, along x of the world.")},
    {"gravity-y", QT_TR_NOOP("Gravity y"), "m/s\u00b2", -1e4, 1e4, 0.1, -kEarthGravity, 2,
     QT_TR_NOOP("What makes bodies fall, along y of the world: upward.")},
    {"gravity-z", QT_TR_NOOP("Gravity z"), "m/s\u00b2", -1e4, 1e4, 0.1, 0, 2,
     QT_TR_NOOP("What makes bodies fall, along z of the world.")},
}};

} // namespace

WorldFields::WorldFields(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    columnIn(this, kRhythm);
    for (int i = 0; i < 3; ++i)
        add(kGravity[std::size_t(i)], i, [](Mechanics& of, int axis) -> double& { return of.gravity[axis]; });
    for (int i = 0; i < int(kWorldFields.size()); ++i)
        add(*kWorldFields[std::size_t(i)].parameter, i,
            [](Mechanics& of, int field) -> double& { return of.*kWorldFields[std::size_t(field)].value; });
    connect(&document_, &Document::changed, this, &WorldFields::refresh);
    refresh();
}

void WorldFields::add(const Parameter& parameter, int index, Value value) {
    auto* field = new ParameterField(parameter);
    layout()->addWidget(field);
    rows_.push_back({field, index, value});
    connect(
        field, &ParameterField::edited, this,
        [this, &parameter, index, value](double wanted, Gesture gesture) {
            document_.editBodies(
                tr("%1 of the world").arg(wordsOf(parameter.label)),
                [=, &parameter](Scene& scene) { value(scene.mechanics, index) = parameter.clamped(wanted); },
                gesture);
            refresh();
        });
}

void WorldFields::refresh() {
    Mechanics mechanics = document_.scene().mechanics;
    for (const Row& row : rows_)
        row.field->setValue(row.value(mechanics, row.index));
}

} // namespace tactum
