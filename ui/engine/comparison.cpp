#include "ui/engine/comparison.h"

#include <algorithm>
#include <utility>

#include "core/haptics/compile.h"
#include "ui/engine/world_publisher.h"

namespace tactum {

/// What a worker has found out.
struct Comparison::Outcome {
    std::optional<ComparedTouch> result;
    std::string fault; ///< for the person; empty when it was only cancelled
};

/// What a worker finds out.
struct Comparison::Question {
    Scene a, b;
    std::shared_ptr<const std::vector<FingerPoint>> stroke;
    std::shared_ptr<const TouchTrace> knownA;
    std::shared_ptr<const World> previous;
    double limit = 0; ///< N, of the device
};

namespace {

/// The finger of the last `seconds` of a recording, its time from 0. It begins where the proxy was then: a
/// finger that was inside of a body already would not feel it otherwise.
std::vector<FingerPoint> strokeOf(const RecordedRun& run, double seconds) {
    std::vector<FingerPoint> stroke;
    const auto& rows = run.proxy.rows;
    if (rows.empty()) return stroke;
    const double begin = rows.back().time - seconds;
    for (const ProxyRow& row : rows) {
        const double t = row.time - begin;
        if (t < 0 || (!stroke.empty() && t <= stroke.back().t)) continue;
        if (stroke.empty()) stroke.push_back({t - row.dt, vectorOf(row.proxy)});
        stroke.push_back({t, vectorOf(row.finger)});
    }
    for (const double first = stroke.front().t; FingerPoint & point : stroke)
        point.t -= first;
    return stroke;
}

} // namespace

Comparison::Comparison(Document& document, const Engine& engine, const WorldPublisher& publisher,
                       QObject* parent)
    : QObject(parent), document_(document), engine_(engine), publisher_(publisher),
      stroke_(std::make_shared<const std::vector<FingerPoint>>()) {
    connect(&document_, &Document::changed, this, &Comparison::follow);
    connect(&document_, &Document::opened, this, &Comparison::forget);
}

void Comparison::beginStroke() {
    clock_.start();
    emit changed();
}

void Comparison::endStroke() {
    if (!recording()) return;
    const double seconds = 1e-3 * double(clock_.elapsed());
    clock_.invalidate();
    takeLast(seconds);
}

void Comparison::takeLast(double seconds) {
    std::vector<FingerPoint> stroke = strokeOf(engine_.recorded(), seconds);
    if (stroke.size() < 2)
        emit failed(tr("No stroke was recorded: the device has not run. Start it first."));
    else
        setStroke(std::move(stroke));
    emit changed();
}

void Comparison::setStroke(std::vector<FingerPoint> stroke) {
    stroke_ = std::make_shared<const std::vector<FingerPoint>>(std::move(stroke));
    touchedA_.reset();
    result_.reset();
    emit changed();
    compare();
}

void Comparison::markA() {
    a_ = document_.scene();
    touchedA_.reset();
    result_.reset();
    emit changed();
    compare();
}

void Comparison::swap() {
    if (!a_) return;
    const Scene a = std::exchange(*a_, document_.scene());
    touchedA_.reset();
    result_.reset();
    document_.replaceScene(tr("Swap A and B"), a);
    emit changed();
    compare();
}

void Comparison::setAutomatic(bool on) {
    automatic_ = on;
    emit changed();
    if (on) compare();
}

void Comparison::follow(const SceneChange& change) {
    if (change.touchesFeel() && automatic_) compare();
}

// A state of another scene is nothing to compare with.
void Comparison::forget() {
    job_.cancel();
    a_.reset();
    touchedA_.reset();
    result_.reset();
    emit changed();
}

Comparison::Outcome Comparison::run(const Question& asked, const Progress& progress) {
    const auto touched =
        [&](const Scene& scene, const World* shared,
            std::shared_ptr<const World>* kept) -> Result<std::shared_ptr<const TouchTrace>> {
        auto world = compile(scene, shared, progress);
        if (!world) return tl::unexpected<Error>(world.error());
        if (kept) *kept = *world;
        auto rows = replay(**world, *asked.stroke, progress);
        if (!rows) return tl::unexpected<Error>(rows.error());
        limitForces(*rows, asked.limit);
        return std::make_shared<const TouchTrace>(std::move(*rows));
    };
    std::shared_ptr<const World> worldOfB;
    const auto ofB = touched(asked.b, asked.previous.get(), &worldOfB);
    const auto ofA = !ofB || asked.knownA ? Result<std::shared_ptr<const TouchTrace>>(asked.knownA)
                                          : touched(asked.a, worldOfB.get(), nullptr);
    for (const auto* each : {&ofB, &ofA})
        if (!*each) return {{}, progress.isCancelled() ? std::string() : each->error().text};
    return {ComparedTouch{*ofA, *ofB, asked.limit, differenceOf(**ofA, **ofB)}, {}};
}

void Comparison::compare() {
    if (!a_ || stroke_->empty()) return;
    const double limit = engine_.device().maxForce;
    Question asked{
        *a_, document_.scene(), stroke_, limit == limitOfA_ ? touchedA_ : nullptr, publisher_.world(), limit};
    job_.start([this, asked = std::move(asked)](const Progress& progress) -> BackgroundJob::Delivery {
        const Outcome outcome = run(asked, progress);
        return [this, outcome] {
            if (!a_) return; // another scene was opened meanwhile
            if (outcome.result) touchedA_ = outcome.result->a, limitOfA_ = outcome.result->limit;
            if (outcome.result) result_ = outcome.result;
            emit changed();
            if (!outcome.fault.empty()) emit failed(QString::fromStdString(outcome.fault));
        };
    });
    emit changed();
}

} // namespace tactum
