#include "ui/study/study_session.h"

#include <algorithm>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/archive/sha256.h"
#include "core/base/clock.h"
#include "core/study/stimulus.h"
#include "ui/engine/health_words.h"
#include "ui/engine/world_publisher.h"

namespace tactum {

namespace {

constexpr qint64 kKeepEvery = 1000; // ms: what a cut of the power takes at most

const QString kAnswers = QStringLiteral("-answers.csv"), kTouch = QStringLiteral("-touch.csv");

/// "stiffness-P007-" beside the study's file: what all logs of a participant begin with.
QString stemOf(const std::filesystem::path& file, int participant) {
    const QFileInfo study(QString::fromStdU16String(file.u16string()));
    return study.dir().filePath(
        QStringLiteral("%1-P%2-").arg(study.completeBaseName()).arg(participant, 3, 10, QLatin1Char('0')));
}

std::filesystem::path logPath(const QString& file) {
    return std::filesystem::path(file.toStdU16String());
}

} // namespace

std::optional<BrokenOff> brokenOff(const StudyDesign& design, const std::filesystem::path& file,
                                   int participant) {
    const QFileInfo stem(stemOf(file, participant));
    const QStringList logs =
        stem.dir().entryList({stem.fileName() + u'*' + kAnswers}, QDir::Files, QDir::Name);
    if (logs.isEmpty()) return {};
    QFile newest(stem.dir().filePath(logs.back()));
    if (!newest.open(QIODevice::ReadOnly)) return {};
    const auto read = readAnswers(newest.readAll().toStdString(), design);
    if (!read || read->answers.empty() || read->scene != fingerprintOf(file)) return {};
    const auto run = StudyRun::resume(design, read->participant, read->seed, read->answers);
    if (!run || run->step() == StudyStep::Done || read->participant != participant) return {};
    return BrokenOff{logPath(newest.fileName()), *read};
}

StudySession::StudySession(WorldPublisher& publisher, Engine& engine, QObject* parent)
    : QObject(parent), publisher_(publisher), engine_(engine) {
    ends_.setSingleShot(true);
    connect(&ends_, &QTimer::timeout, this, [this] {
        // The forces come on only by somebody who holds the handle.
        if (run_ && run_->step() == StudyStep::Pause && run_->design().forcesOffBetween)
            return emit changed();
        proceed();
    });
    connect(&publisher_, &WorldPublisher::published, this, [this] {
        if (run_) remember(*publisher_.world());
        if (stage_ == Stage::Published) startFeeling();
    });
    connect(&publisher_, &WorldPublisher::failed, this, &StudySession::fail);
}

Result<void> StudySession::begin(std::shared_ptr<const Study> study, const StudyStart& start) {
    const StudyDesign& design = study->design;
    const auto broken = start.goOn ? brokenOff(design, start.file, start.participant) : std::nullopt;
    if (start.goOn && !broken) return inputError("The run that broke off cannot be read; begin a new one.");
    auto run = broken ? StudyRun::resume(design, start.participant, broken->run.seed, broken->run.answers)
                      : StudyRun::begin(design, start.participant, start.seed);
    if (!run) return tl::unexpected<Error>(run.error());
    if (design.procedure == Procedure::Staircase)
        if (const auto bends = checkStaircase(study->conditions[0], design.staircase); !bends) return bends;
    const auto opened = broken ? goOn(*broken) : openLogs(design, start);
    if (!opened) return opened;
    scene_ = fingerprintOf(start.file);
    answersFile_ = answersLog_->path();
    study_ = std::move(study);
    run_ = std::move(*run);
    touch_ = TouchLog(run_->design().touchEvery);
    facts_ = {};
    replied_ = false;
    now_ = std::make_shared<const Scene>(study_->conditions[0]);
    stage_ = Stage::Idle;
    published_.clear();
    kept_.start();
    publisher_.setTrial(now_);
    emit changed();
    return {};
}

Result<void> StudySession::openLogs(const StudyDesign& design, const StudyStart& start) {
    const QString stem = stemOf(start.file, start.participant) +
                         QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HH-mm-ss"));
    auto answers = LogFile::create(logPath(stem + kAnswers));
    if (!answers) return tl::unexpected<Error>(answers.error());
    auto touch = LogFile::create(logPath(stem + kTouch));
    if (!touch) return tl::unexpected<Error>(touch.error());
    if (const auto written = answers->write(answerHeader(design)); !written) return written;
    if (const auto written = touch->write(TouchLog::header()); !written) return written;
    answersLog_ = std::move(*answers);
    touchLog_ = std::move(*touch);
    return {};
}

Result<void> StudySession::goOn(const BrokenOff& broken) {
    QString touchFile = QString::fromStdU16String(broken.log.u16string());
    touchFile.replace(touchFile.size() - kAnswers.size(), kAnswers.size(), kTouch);
    QFile read(touchFile);
    if (!read.open(QIODevice::ReadOnly))
        return inputError("The log of the touch is not there any more; begin a new run.");
    constexpr qint64 kLongestRow = 4096;
    read.seek(std::max<qint64>(0, read.size() - kLongestRow));
    const qint64 torn = read.size() - (read.pos() + read.peek(kLongestRow).lastIndexOf('\n') + 1);
    auto answers = LogFile::goOn(broken.log, broken.run.bytes);
    if (!answers) return tl::unexpected<Error>(answers.error());
    auto touch = LogFile::goOn(logPath(touchFile), std::size_t(read.size() - torn));
    if (!touch) return tl::unexpected<Error>(touch.error());
    answersLog_ = std::move(*answers);
    touchLog_ = std::move(*touch);
    return {};
}

void StudySession::end() {
    if (!run_) return;
    const auto kept = touchLog_->keep();
    stop();
    if (!kept) emit failed(QString::fromStdString(kept.error().text));
}

/// Nothing is felt or written any more.
void StudySession::stop() {
    ends_.stop();
    stage_ = Stage::Idle;
    run_.reset();
    answersLog_.reset();
    touchLog_.reset();
    now_.reset();
    publisher_.setTrial(nullptr);
}

void StudySession::fail(const QString& sentence) {
    if (!run_) return;
    stop();
    emit failed(sentence);
}

void StudySession::proceed() {
    if (!run_ || run_->step() == StudyStep::Choice || run_->step() == StudyStep::Question) return;
    if (run_->step() == StudyStep::Instructions && publisher_.working()) return; // the view has nothing yet
    if (run_->step() == StudyStep::Stimulus && stage_ != Stage::Felt) return;
    if (ends_.isActive() && run_->step() == StudyStep::Pause) return;
    const std::size_t done = run_->done().size();
    run_->proceed();
    follow(done);
}

void StudySession::feelAgain() {
    if (run_ && run_->feelAgain(0)) follow(run_->done().size());
}

void StudySession::choose(int chosen) {
    if (!run_) return;
    const std::size_t done = run_->done().size();
    follow(done, run_->choose(chosen));
}

void StudySession::reply(const QString& words) {
    if (!run_) return;
    const std::size_t done = run_->done().size();
    follow(done, run_->reply(words.toStdString()));
}

/// After an answer, or what was refused.
void StudySession::follow(std::size_t doneBefore, const Result<void>& answer) {
    if (!answer) return emit refused(QString::fromStdString(answer.error().text));
    if (!replied_) facts_.reaction = 1e-6 * double(asked_.nsecsElapsed());
    replied_ = true;
    follow(doneBefore);
}

/// After a step of the run.
void StudySession::follow(std::size_t doneBefore) {
    ends_.stop();
    if (run_->done().size() > doneBefore) logTrial();
    if (run_) enter(); // else the log could not be written
}

/// What the step that has come begins with.
void StudySession::enter() {
    const StudyDesign& design = run_->design();
    stage_ = Stage::Idle;
    switch (run_->step()) {
    case StudyStep::Stimulus:
        return publish();
    case StudyStep::Pause:
        ends_.start(int(1000 * design.pauseSeconds));
        break;
    case StudyStep::Choice:
    case StudyStep::Question:
        if (!replied_) asked_.start();
        break;
    case StudyStep::Instructions:
    case StudyStep::Done:
        break;
    }
    if (design.forcesOffBetween) emit forcesWanted(false);
    emit changed();
    if (run_ && run_->step() == StudyStep::Done) emit finished();
}

/// Of a stimulus with other shapes the finger may be inside, so that it waits until nothing is touched; how a
/// surface feels changes under the finger by the contact transition.
void StudySession::publish() {
    const StudyTrial& trial = run_->trial();
    const Stimulus& stimulus = trial.intervals[std::size_t(run_->interval())];
    auto next = std::make_shared<const Scene>(tactum::sceneOf(
        study_->conditions[std::size_t(stimulus.condition)], run_->design().staircase, stimulus));
    const bool touches = engine_.proxy().output.contacts > 0;
    touch_.interrupt();
    if (touches && !sameShapes(*now_, *next)) {
        stage_ = Stage::Lift;
        return emit changed();
    }
    stage_ = Stage::Published;
    now_ = std::move(next);
    publisher_.setTrial(now_);
    emit changed();
}

/// The newest last: ticks come some time after the World that they are of.
void StudySession::remember(const World& world) {
    constexpr std::size_t kMost = 8;
    published_.emplace_back(world.revision, world.scene);
    if (published_.size() > kMost) published_.erase(published_.begin());
}

const Scene* StudySession::sceneOf(std::uint64_t revision) const {
    const auto found = std::ranges::find(published_, revision, &Published::first);
    return found == published_.end() ? nullptr : found->second.get();
}

void StudySession::startFeeling() {
    stage_ = Stage::Felt;
    const StudyDesign& design = run_->design();
    const auto interval = std::size_t(run_->interval());
    if (facts_.felt == 0) faults_ = engine_.servo().faults;
    ++facts_.felt;
    if (facts_.begun.size() == interval) facts_.begun.push_back(tick_);
    if (design.stimulusSeconds > 0) ends_.start(int(1000 * design.stimulusSeconds));
    if (design.forcesOffBetween) emit forcesWanted(true);
    emit changed();
}

void StudySession::take(const std::vector<TracePoint>& ticks) {
    if (!run_) return;
    std::string rows;
    if (!ticks.empty()) tick_ = ticks.back().t;
    if (stage_ == Stage::Felt) {
        const Stimulus& stimulus = run_->trial().intervals[std::size_t(run_->interval())];
        TouchMoment moment{.trial = run_->number(),
                           .interval = run_->interval() + 1,
                           .hand = int(Hands(engine_).chosen()) + 1,
                           .condition = run_->design().conditions[std::size_t(stimulus.condition)],
                           .value = stimulus.value};
        for (const TracePoint& point : ticks) {
            moment.scene = sceneOf(point.revision);
            touch_.add(rows, point, moment);
        }
    }
    if (!rows.empty()) keep(touchLog_->write(rows));
    if (run_ && kept_.elapsed() > kKeepEvery) {
        kept_.restart();
        keep(touchLog_->keep());
    }
    if (run_ && stage_ == Stage::Lift && engine_.proxy().output.contacts == 0) publish();
}

void StudySession::logTrial() {
    facts_.scene = scene_;
    facts_.time = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    facts_.clock = 1e-6 * double(monotonicNanoseconds());
    facts_.answered = tick_;
    facts_.device = engine_.device().name;
    facts_.ceiling = ceilingNow(engine_.servo(), engine_.device()).value;
    facts_.faults = engine_.servo().faults - std::min(faults_, engine_.servo().faults);
    keep(answersLog_->write(answerRow(*run_, facts_)));
    if (run_) keep(answersLog_->keep());
    facts_ = {};
    replied_ = false;
}

void StudySession::keep(const Result<void>& written) {
    if (!written) fail(QString::fromStdString(written.error().text));
}

} // namespace tactum
