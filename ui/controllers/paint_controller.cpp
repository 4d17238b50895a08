#include "ui/controllers/paint_controller.h"

#include <QActionGroup>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/parameter_field.h"
#include "ui/showing/playback.h"
#include "ui/tools/paint_tool.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

namespace tactum {

namespace {

constexpr double kGrow = 1.15, kStronger = 0.05;

/// "paint-height": the command that makes it the brush's.
QByteArray idOf(const char* what, const NamedChoice& choice) {
    return QByteArray(what) + QByteArray(choice.key.data(), qsizetype(choice.key.size()));
}

} // namespace

PaintController::PaintController(const Workbench& bench, PaintTool& tool, ToolStrip& strip,
                                 LayerPanel& layers)
    : QObject(&bench.window), bench_(bench), tool_(tool), strip_(strip) {
    connectChoices();
    change("brush-bigger", [](Brush& brush) { brush.radius *= kGrow; });
    change("brush-smaller", [](Brush& brush) { brush.radius /= kGrow; });
    change("brush-stronger", [](Brush& brush) { brush.strength += kStronger; });
    change("brush-weaker", [](Brush& brush) { brush.strength -= kStronger; });
    connect(&layers, &LayerPanel::currentLayerChanged, &tool,
            [&tool, &layers] { tool.setLayer(layers.currentLayer()); });
    connect(&tool, &PaintTool::refused, &bench.notice, &NoticeBar::showNote);
    connect(&bench.actions["paint"], &QAction::toggled, this, [this](bool on) {
        tool_.setActive(on && !bench_.playback.active());
        strip_.setVisible(on);
    });
}

void PaintController::connectChoices() {
    const auto choose = [this](QActionGroup& group, const QByteArray& id, auto&& chosen) {
        group.addAction(&bench_.actions[id.constData()]);
        bench_.on(id.constData(), this, [this, chosen] {
            chosen();
            bench_.actions["paint"].trigger();
        });
    };
    auto* goals = new QActionGroup(this);
    for (std::size_t i = 0; i < kPaintGoals.size(); ++i)
        choose(*goals, idOf("paint-", kPaintGoals[i]), [this, i] { tool_.setGoal(PaintGoal(i)); });
    auto* modes = new QActionGroup(this);
    for (std::size_t i = 0; i < kBrushModes.size(); ++i)
        choose(*modes, idOf("brush-", kBrushModes[i]), [this, i] {
            Brush brush = tool_.brush();
            brush.mode = BrushMode(i);
            tool_.setBrush(brush);
        });
    bench_.actions["paint-height"].setChecked(true);
    bench_.actions["brush-add"].setChecked(true);
    fillStrip(goals->actions(), modes->actions());
}

void PaintController::change(const char* id, void (*how)(Brush&)) {
    bench_.on(id, this, [this, how] {
        if (bench_.actions["select"].isChecked()) return; // its own brush has these keys
        Brush brush = tool_.brush();
        how(brush);
        tool_.setBrush(brush);
    });
}

void PaintController::fillStrip(const QList<QAction*>& goals, const QList<QAction*>& modes) {
    strip_.setObjectName(QStringLiteral("paint-strip"));
    QStringList goalNames, modeNames;
    for (const NamedChoice& goal : kPaintGoals)
        goalNames << wordsOf(goal.label);
    for (const NamedChoice& mode : kBrushModes)
        modeNames << wordsOf(mode.label);
    strip_.addLabel(tr("The brush"));
    strip_.addChoices(tr("What the brush does"), modes, modeNames);
    strip_.addChoices(tr("What the brush paints"), goals, goalNames);
    for (const BrushField& each : kBrushFields) {
        auto* field = new ParameterField(*each.parameter);
        field->setCompact();
        field->setFixedWidth(18 * kRhythm);
        connect(field, &ParameterField::edited, this, [this, value = each.value](double to) {
            Brush brush = tool_.brush();
            brush.*value = to;
            tool_.setBrush(brush);
        });
        const auto show = [this, field, value = each.value] {
            field->setValue(tool_.brush().*value);
            field->setVisible(value != &Brush::value || tool_.brush().mode == BrushMode::Set);
        };
        connect(&tool_, &PaintTool::brushChanged, field, show);
        show();
        strip_.addField(field);
    }
    strip_.addGap();
}

} // namespace tactum
