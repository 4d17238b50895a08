// A study as it is run with a participant: what is felt now, the participant's answers, and the logs.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/runtime/hands.h"
#include "core/study/answer_log.h"
#include "core/study/log_file.h"
#include "core/study/study_file.h"
#include "core/study/touch_log.h"

namespace tactum {

class WorldPublisher;

/// With whom a study is run, and where its logs go.
struct StudyStart {
    std::filesystem::path file; ///< of the study, saved as it is run; the logs come beside it
    int participant = 1;
    std::uint64_t seed = 1; ///< not 0
    bool goOn = false;      ///< with the run that broke off, under its seed
};

/// A run of this study that can be gone on with.
struct BrokenOff {
    std::filesystem::path log;
    LoggedRun run;
};
/// The newest one of the participant beside the study's file; nothing where that came to its end.
std::optional<BrokenOff> brokenOff(const StudyDesign& design, const std::filesystem::path& file,
                                   int participant);

/// Thread: ui. Each stimulus is published as every edit is, and the document stays as it is.
class StudySession : public QObject {
    Q_OBJECT
public:
    StudySession(WorldPublisher& publisher, Engine& engine, QObject* parent = nullptr);

    /// Ends with began(), or an error: one sentence; then nothing has changed.
    Result<void> begin(std::shared_ptr<const Study> study, const StudyStart& start);
    /// Safe to call when nothing runs. What was answered so far is in the log.
    void end();
    bool running() const { return run_.has_value(); }
    /// Only while it runs.
    const StudyRun& run() const { return *run_; }
    const Study& study() const { return *study_; }
    /// The log of answers, of the last run.
    const std::filesystem::path& answers() const { return answersFile_; }

    /// Whether the stimulus of this step is felt already.
    bool felt() const { return stage_ == Stage::Felt; }
    /// Whether it waits until nothing is touched: the next stimulus has other shapes.
    bool waitsForLift() const { return stage_ == Stage::Lift; }
    /// Whether a pause is not over.
    bool rests() const { return run_ && run_->step() == StudyStep::Pause && ends_.isActive(); }

    // What the participant does. Refused in a sentence, of which nothing comes but the signal.
    void proceed();
    void feelAgain();
    void choose(int chosen);
    void reply(const QString& words);

    /// Once a frame, with the servo ticks that came in it.
    void take(const std::vector<TracePoint>& ticks);

signals:
    /// Another step, or the stimulus of this one is felt now.
    void changed();
    /// The last trial is done.
    void finished();
    /// One line for the person.
    void refused(const QString& sentence);
    /// A log cannot be written: the run has ended.
    void failed(const QString& sentence);
    /// Before a stimulus, and after the last one of a trial, where the design has it so.
    void forcesWanted(bool on);

private:
    enum class Stage { Idle, Lift, Published, Felt };

    Result<void> openLogs(const StudyDesign& design, const StudyStart& start);
    Result<void> goOn(const BrokenOff& broken);
    void stop();
    void fail(const QString& sentence);
    void follow(std::size_t doneBefore);
    void follow(std::size_t doneBefore, const Result<void>& answer);
    void enter();
    void publish();
    void startFeeling();
    void remember(const World& world);
    const Scene* sceneOf(std::uint64_t revision) const;
    void logTrial();
    void keep(const Result<void>& written);

    WorldPublisher& publisher_;
    Engine& engine_;
    std::shared_ptr<const Study> study_;
    std::optional<StudyRun> run_;
    std::optional<LogFile> answersLog_, touchLog_;
    std::filesystem::path answersFile_;
    std::string scene_; ///< fingerprint
    TouchLog touch_{1};
    Stage stage_ = Stage::Idle;
    std::shared_ptr<const Scene> now_; ///< what is felt
    using Published = std::pair<std::uint64_t, std::shared_ptr<const Scene>>;
    std::vector<Published> published_; ///< the last Worlds: their revisions, and what they were made of
    QTimer ends_;                      ///< of a stimulus or a pause with a limit
    QElapsedTimer asked_, kept_;
    TrialFacts facts_;
    bool replied_ = false;     ///< the time of reaction is known
    double tick_ = 0;          ///< s: the last one
    std::uint64_t faults_ = 0; ///< at the begin of the trial
};

} // namespace tactum
