// Recordings in the window: saving them, and what a person can do while one is shown in the document's place.
#pragma once

#include <functional>

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class ArrangeTool;
class Arming;
class HandLink;
class RecordingSaver;
class Stage;

/// Thread: ui.
class RecordingController : public QObject {
    Q_OBJECT
public:
    RecordingController(const Workbench& bench, Arming& arming, Stage& stage, HandLink& hand,
                        ArrangeTool& arranging, RecordingSaver& saver);

signals:
    /// Commands may be given again to document, hand and forces, or not any more; others of them may depend
    /// on more.
    void liveChanged(bool live);
    /// A recording begins: its first frame is to be drawn.
    void shown();

private:
    void onKey(Qt::Key key, const std::function<void()>& act);
    void save();
    void setLive(bool live);
    void begin();
    void end();

    Workbench bench_;
    Arming& arming_;
    Stage& stage_;
    HandLink& hand_;
    ArrangeTool& arranging_;
    RecordingSaver& saver_;
};

} // namespace tactum
