// The fields of a staircase: which number of the scene it bends, where, and how its levels go.
#pragma once

#include <vector>

#include <QGroupBox>

#include "core/study/design.h"
#include "ui/base/numbers.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace tactum {

/// "Stiffness", "Layer 1: Height", "Layer 1, mask: Size": as a person counts. Thread: ui.
QString wordsFor(const SceneValue& value);

/// Levels to begin with, for a number that is `now` in the scene: the largest difference is as large as the
/// reference, where the range has room for it. Thread: any.
StaircaseRule withLevelsFor(StaircaseRule rule, const Parameter& parameter, double now);

/// Numbers are in the units that the window shows; those of rule() are SI. Thread: ui.
class StaircaseFields : public QGroupBox {
    Q_OBJECT
public:
    /// Offers what there is in the first of the conditions, and what the rule has now.
    StaircaseFields(const StaircaseRule& rule, const std::vector<Scene>& conditions,
                    QWidget* parent = nullptr);

    StaircaseRule rule() const;

signals:
    void edited();

private:
    void addParameters(QFormLayout& form);
    void addPlaces(QFormLayout& form);
    void addLevels(QFormLayout& form);
    void addCounts(QFormLayout& form);
    QComboBox* box(const char* name);
    QDoubleSpinBox* number(const char* name);
    QSpinBox* whole(const char* name, int least, int most, int now);
    QCheckBox* check(const char* name, const QString& text, bool on);
    void chooseParameter();
    void showLevels(const StaircaseRule& rule);
    void enablePlaces();
    void tell();

    StaircaseRule first_; ///< what it began with
    Scene scene_;         ///< the first condition
    bool filling_ = true;
    DisplayUnit unit_;
    QComboBox *parameter_ = nullptr, *object_ = nullptr, *surface_ = nullptr;
    QCheckBox *compares_ = nullptr, *ratio_ = nullptr;
    QDoubleSpinBox *reference_ = nullptr, *start_ = nullptr, *smallest_ = nullptr, *largest_ = nullptr;
    QLineEdit* steps_ = nullptr;
    QSpinBox *down_ = nullptr, *reversals_ = nullptr, *used_ = nullptr, *trials_ = nullptr;
};

} // namespace tactum
