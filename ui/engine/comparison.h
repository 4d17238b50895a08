// One finger stroke over two states of the scene: A as it was when it was marked, B as it is now.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QObject>

#include "core/haptics/touch_difference.h"
#include "core/runtime/engine.h"
#include "ui/base/background_job.h"
#include "ui/document/document.h"

namespace tactum {

class WorldPublisher;

/// The stroke felt in both states, with what the device can give.
struct ComparedTouch {
    std::shared_ptr<const TouchTrace> a, b;
    double limit = 0; ///< N, of the device
    TouchDifference difference;
};

/// Thread: ui. Replays happen on a worker, and the newest wins. Meshes that both states share are prepared
/// for touch once.
class Comparison : public QObject {
    Q_OBJECT
public:
    Comparison(Document& document, const Engine& engine, const WorldPublisher& publisher,
               QObject* parent = nullptr);

    /// From now until endStroke(); at most the last minute of it.
    void beginStroke();
    void endStroke();
    bool recording() const { return clock_.isValid(); }
    /// What the finger did last.
    void takeLast(double seconds);
    void setStroke(std::vector<FingerPoint> stroke);
    const std::vector<FingerPoint>& stroke() const { return *stroke_; }

    void markA();
    bool hasA() const { return a_.has_value(); }
    /// A becomes the scene, as one step of the history, and what the scene was becomes A.
    void swap();
    /// Whether each edit compares anew.
    void setAutomatic(bool on);
    bool automatic() const { return automatic_; }
    /// Does nothing while there is no stroke or no A.
    void compare();
    bool working() const { return job_.running(); }
    void cancel() { job_.cancel(); }

    const std::optional<ComparedTouch>& result() const { return result_; }

signals:
    /// Stroke, A, result or what is under way.
    void changed();
    /// One line for the person.
    void failed(const QString& sentence);

private:
    void follow(const SceneChange& change);
    void forget();
    struct Outcome;
    struct Question;
    static Outcome run(const Question& asked, const Progress& progress);

    Document& document_;
    const Engine& engine_;
    const WorldPublisher& publisher_;
    std::shared_ptr<const std::vector<FingerPoint>> stroke_;
    std::optional<Scene> a_;
    std::shared_ptr<const TouchTrace> touchedA_; ///< of this stroke and this A; null: not known yet
    double limitOfA_ = 0;                        ///< N, of the device that it was for
    std::optional<ComparedTouch> result_;
    QElapsedTimer clock_;
    bool automatic_ = true;
    BackgroundJob job_;
};

} // namespace tactum
