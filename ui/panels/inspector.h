// What can be set on the selected surface, and on the scene as a whole.
#pragma once

#include <vector>

#include <QWidget>

#include "ui/document/document.h"
#include "ui/engine/health_words.h"

class QButtonGroup;
class QCheckBox;
class QLabel;
class QToolButton;

namespace tactum {

class ParameterField;

/// Generated from kMaterialFields; every edit goes through the document and can be undone.
class Inspector : public QWidget {
    Q_OBJECT
public:
    explicit Inspector(Document& document, QWidget* parent = nullptr);

    /// The stiffness that is rendered at most, as a tick on its slider; `overridden`: it is not kept.
    void setCeiling(const CeilingNow& ceiling, bool overridden);

signals:
    /// The swatch was pressed.
    void colourAsked();

private:
    QWidget* makeSurfaceSection();
    QWidget* makeSidesRow();
    QWidget* makeShadingRows();
    QWidget* makeSceneSection();
    /// Changes the shading of every selected surface.
    template <class Change> void editShading(Gesture gesture, Change&& change);
    void refresh(const SceneChange& change);
    void refreshHeading();
    void refreshLocked();
    void refreshValues();
    void refreshShading();

    Document& document_;
    QLabel* heading_;
    QToolButton* swatch_;
    QWidget* surfaceFields_;
    QLabel* hint_;
    QLabel* locked_;                      ///< why nothing can be set
    std::vector<ParameterField*> fields_; ///< in the order of kMaterialFields
    QButtonGroup* sides_;                 ///< the buttons have the numbers of Sides
    QCheckBox* shading_;
    QCheckBox* fileNormals_;
    ParameterField* creaseAngle_;
    ParameterField* proxyRadius_;
    QString ceilingText_;
};

} // namespace tactum
