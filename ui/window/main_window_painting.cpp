// The brush: its commands, and the row above the view.
#include "ui/window/main_window.h"

#include <QActionGroup>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/parameter_field.h"
#include "ui/showing/playback.h"
#include "ui/tools/paint_tool.h"
#include "ui/view/scene_view.h"
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

void MainWindow::connectPainting() {
    const auto choose = [this](QActionGroup& group, const QByteArray& id, auto&& chosen) {
        QAction& action = actions_[id.constData()];
        group.addAction(&action);
        connect(&action, &QAction::triggered, this, [this, chosen] {
            chosen();
            actions_["paint"].trigger();
        });
    };
    auto* goals = new QActionGroup(this);
    for (std::size_t i = 0; i < kPaintGoals.size(); ++i)
        choose(*goals, idOf("paint-", kPaintGoals[i]), [this, i] { painting_->setGoal(PaintGoal(i)); });
    auto* modes = new QActionGroup(this);
    for (std::size_t i = 0; i < kBrushModes.size(); ++i)
        choose(*modes, idOf("brush-", kBrushModes[i]), [this, i] {
            Brush brush = painting_->brush();
            brush.mode = BrushMode(i);
            painting_->setBrush(brush);
        });
    actions_["paint-height"].setChecked(true);
    actions_["brush-add"].setChecked(true);
    const auto change = [this](const char* id, void (*how)(Brush&)) {
        connect(&actions_[id], &QAction::triggered, this, [this, how] {
            if (actions_["select"].isChecked()) return; // its own brush has these keys
            Brush brush = painting_->brush();
            how(brush);
            painting_->setBrush(brush);
        });
    };
    change("brush-bigger", [](Brush& brush) { brush.radius *= kGrow; });
    change("brush-smaller", [](Brush& brush) { brush.radius /= kGrow; });
    change("brush-stronger", [](Brush& brush) { brush.strength += kStronger; });
    change("brush-weaker", [](Brush& brush) { brush.strength -= kStronger; });
    connect(docks_.layers, &LayerPanel::currentLayerChanged, painting_,
            [this] { painting_->setLayer(docks_.layers->currentLayer()); });
    connect(painting_, &PaintTool::refused, notice_, &NoticeBar::showNote);
    connect(&actions_["paint"], &QAction::toggled, this, [this](bool on) {
        painting_->setActive(on && !playback_->active());
        paintStrip_->setVisible(on);
    });
    fillPaintStrip(goals->actions(), modes->actions());
}

void MainWindow::fillPaintStrip(const QList<QAction*>& goals, const QList<QAction*>& modes) {
    paintStrip_->setObjectName(QStringLiteral("paint-strip"));
    QStringList goalNames, modeNames;
    for (const NamedChoice& goal : kPaintGoals)
        goalNames << wordsOf(goal.label);
    for (const NamedChoice& mode : kBrushModes)
        modeNames << wordsOf(mode.label);
    paintStrip_->addLabel(tr("The brush"));
    paintStrip_->addChoices(tr("What the brush does"), modes, modeNames);
    paintStrip_->addChoices(tr("What the brush paints"), goals, goalNames);
    for (const BrushField& each : kBrushFields) {
        auto* field = new ParameterField(*each.parameter);
        field->setCompact();
        field->setFixedWidth(18 * kRhythm);
        connect(field, &ParameterField::edited, this, [this, value = each.value](double to) {
            Brush brush = painting_->brush();
            brush.*value = to;
            painting_->setBrush(brush);
        });
        const auto show = [this, field, value = each.value] {
            field->setValue(painting_->brush().*value);
            field->setVisible(value != &Brush::value || painting_->brush().mode == BrushMode::Set);
        };
        connect(painting_, &PaintTool::brushChanged, field, show);
        show();
        paintStrip_->addField(field);
    }
    paintStrip_->addStretch();
}

} // namespace tactum
