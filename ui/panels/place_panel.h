// Where the selected object is, how it is turned and how large it is, in numbers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QWidget>

#include "core/base/vec.h"
#include "ui/document/document.h"

class QLabel;

namespace tactum {

class ArrangeTool;
class ParameterField;

/// The angles of turns about x, then y, then z of the world, which together make a rotation; rad. Where y is
/// a right angle, x is 0.
Vec3 anglesOf(const Quat& rotation);
Quat rotationOf(const Vec3& angles);

/// Of the object that was selected last; the others move, turn and scale with it. Thread: ui.
class PlacePanel : public QWidget {
    Q_OBJECT
public:
    PlacePanel(Document& document, ArrangeTool& tool, QWidget* parent = nullptr);

private:
    ParameterField* add(QWidget* rows, const Parameter& parameter,
                        const std::function<void(double, Gesture)>& edited);
    void move(int axis, double value, Gesture gesture);
    void turn(int axis, double angle, Gesture gesture);
    void resize(double factor, Gesture gesture);
    double size() const;
    Vec3 angles() const;
    void refresh();

    Document& document_;
    ArrangeTool& tool_;
    QLabel *heading_, *hint_, *extent_;
    QWidget* rows_;
    std::array<ParameterField*, 3> places_{}, angles_{};
    ParameterField *size_, *scale_;
    std::optional<Vec3> typed_; ///< angles, as long as they are those of the object
    ObjectId shown_ = 0;
    double sizeWhenShown_ = 1; ///< m
};

} // namespace tactum
