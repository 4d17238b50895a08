#include "core/protocol/service.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "core/protocol/attendant.h"
#include "core/protocol/edits.h"
#include "core/protocol/orders.h"
#include "core/protocol/pieces.h"
#include "core/protocol/replies.h"
#include "core/recording/recording_file.h"
#include "core/scene/scene_bytes.h"

namespace tactum {
namespace {

const grpc::Status kUnknown{grpc::StatusCode::UNAUTHENTICATED,
                            "this key is of nobody who attends: attend first"};

/// Of a Result: what is too much for the machine is refused and ends nothing else.
template <class Work> auto withinMemory(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return machineError("the server has not enough memory for this: send less, or close other programs");
    }
}

/// A file or a mesh that comes in; then it is read beside everything else. Deletes itself.
class UploadCall final : public grpc::ServerBidiReactor<v1::Piece, v1::UploadNews> {
public:
    UploadCall(HapticsService& service, Workers& workers)
        : service_(service), workers_(workers),
          incoming_(service.uploads(), [&service](std::string_view bytes) {
              return service.parts().read(bytes, *service.stage().scenery().scene);
          }) {
        StartRead(&piece_);
    }

    void OnReadDone(bool ok) override {
        if (!ok) return end(statusOf(Error{Error::Kind::Input, "the upload ended before it was complete"}));
        if (auto heard = withinMemory([this] { return hear(); }); !heard) return end(statusOf(heard.error()));
        if (ended_) return;
        if (!incoming_.complete()) return StartRead(&piece_);
        const std::lock_guard lock(mutex_);
        if (finished_) return;
        handed_ = true;
        workers_.run([this] { read(); });
    }
    void OnWriteDone(bool) override {
        const std::lock_guard lock(mutex_);
        writing_ = false;
        if (done_ && !saidDone_)
            sayDone();
        else if (saidDone_)
            finish(grpc::Status::OK);
    }
    void OnCancel() override {
        cancelled_ = true;
        const std::lock_guard lock(mutex_);
        if (!handed_) finish(grpc::Status::CANCELLED); // else the worker sees it, and ends the call
    }
    void OnDone() override { delete this; }

private:
    static constexpr std::size_t kReportEvery = std::size_t(4) << 20; // bytes

    Result<void> hear() {
        if (client_ == 0) {
            client_ = service_.stage().whoHas(piece_.head().key());
            if (client_ == 0) {
                end(kUnknown);
                return {};
            }
            if (auto begun = incoming_.begin(piece_.head()); !begun) return begun;
        }
        if (auto added = incoming_.add(piece_.bytes()); !added) return added;
        if (incoming_.received() - reported_ >= kReportEvery) {
            reported_ = incoming_.received();
            say([&] { news_.set_received(reported_); });
        }
        return {};
    }

    /// Left out while another is on its way.
    template <class Write> void say(Write write) {
        const std::lock_guard lock(mutex_);
        if (writing_ || finished_) return;
        write();
        writing_ = true;
        StartWrite(&news_);
    }

    /// On a worker.
    void read() {
        Progress progress;
        progress.cancelled = &cancelled_;
        progress.report = [this](double fraction) { say([&] { news_.set_checked(fraction); }); };
        auto loaded = cancelled_ ? Result<LoadedScene>(cancelledError())
                                 : withinMemory([&] { return incoming_.read(progress); });
        if (!loaded || cancelled_) return end(loaded ? grpc::Status::CANCELLED : statusOf(loaded.error()));
        v1::Uploaded done;
        done.set_triangles(triangleCount(loaded->scene));
        for (const Finding& finding : loaded->findings)
            done.add_finding((finding.object.empty() ? "" : finding.object + ": ") + finding.sentence + "; " +
                             finding.remedy);
        done.set_upload(service_.uploads().keep(client_, std::move(*loaded)));
        const std::lock_guard lock(mutex_);
        answer_ = std::move(done);
        done_ = true;
        if (!writing_) sayDone();
    }
    void sayDone() {
        *news_.mutable_done() = std::move(answer_);
        saidDone_ = writing_ = true;
        StartWrite(&news_);
    }

    /// Also from a worker: nothing of this may be touched after Finish(), the mutex neither.
    void end(const grpc::Status& status) {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
            if (std::exchange(finished_, true)) return;
        }
        Finish(status);
    }
    void finish(const grpc::Status& status) {
        if (!std::exchange(finished_, true)) Finish(status);
    }

    HapticsService& service_;
    Workers& workers_;
    Incoming incoming_;
    v1::Piece piece_;
    ClientId client_ = 0;
    std::size_t reported_ = 0;
    std::atomic<bool> cancelled_{false}, ended_{false};
    std::mutex mutex_; ///< of all below
    v1::UploadNews news_;
    v1::Uploaded answer_;
    bool writing_ = false, handed_ = false, done_ = false, saidDone_ = false, finished_ = false;
};

constexpr std::size_t kMostRows = 100'000; ///< of a path
constexpr std::size_t kRowsAtOnce = 8192;

/// Row by row of four float64.
Result<std::vector<FingerPoint>> pathOf(const std::string& bytes) {
    constexpr std::size_t kRow = 4 * sizeof(double);
    if (bytes.empty() || bytes.size() % kRow != 0 || bytes.size() / kRow > kMostRows)
        return inputError("a path has from 1 to " + std::to_string(kMostRows) +
                          " rows of four float64: t, x, y, z");
    std::vector<FingerPoint> path(bytes.size() / kRow);
    for (std::size_t i = 0; i < path.size(); ++i) {
        std::array<double, 4> row;
        std::memcpy(row.data(), bytes.data() + i * kRow, kRow);
        path[i] = {row[0], {row[1], row[2], row[3]}};
    }
    if (!isFingerPath(path))
        return inputError("the times of a path have to rise, and all its numbers to be finite");
    return path;
}

/// Deletes itself.
class Replaying final : public grpc::ServerWriteReactor<v1::ReplayRows> {
public:
    explicit Replaying(const grpc::Status& refusal) { Finish(refusal); }
    Replaying(Stage& stage, Workers& workers, std::vector<FingerPoint> path) {
        workers.run([this, &stage, path = std::move(path)] { play(stage, path); });
    }
    void OnWriteDone(bool ok) override { ok ? next() : Finish(grpc::Status::CANCELLED); }
    void OnCancel() override { cancelled_ = true; }
    void OnDone() override { delete this; }

private:
    void play(Stage& stage, const std::vector<FingerPoint>& path) {
        Progress progress;
        progress.cancelled = &cancelled_;
        // A World of its own: the loops step in the memory of theirs.
        const auto scenery = stage.scenery();
        const auto world =
            withinMemory([&] { return compile(*scenery.scene, scenery.world.get(), progress); });
        if (!world) return Finish(statusOf(world.error()));
        auto rows = withinMemory([&] { return replay(**world, path, progress); });
        if (!rows) return Finish(statusOf(rows.error()));
        rows_ = std::move(*rows);
        next();
    }
    void next() {
        if (at_ == rows_.size()) return Finish(grpc::Status::OK);
        std::string& bytes = *answer_.mutable_rows();
        bytes.clear();
        for (std::size_t i = 0; i < kRowsAtOnce && at_ < rows_.size(); ++i, ++at_) {
            const TouchRow& row = rows_[at_];
            const std::array<double, 7> numbers{row.proxy.x(),       row.proxy.y(), row.proxy.z(),
                                                row.force.x(),       row.force.y(), row.force.z(),
                                                double(row.contacts)};
            bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
        }
        StartWrite(&answer_);
    }

    TouchTrace rows_;
    std::size_t at_ = 0;
    v1::ReplayRows answer_;
    std::atomic<bool> cancelled_{false};
};

bool namesUpload(const v1::Transaction& request) {
    return std::ranges::any_of(request.edit(),
                               [](const v1::Edit& edit) { return edit.has_add() || edit.has_open(); });
}

} // namespace

HapticsService::HapticsService(Stage& stage, ServiceSettings settings)
    : stage_(stage), settings_(std::move(settings)), uploads_(settings_.uploads) {
    stage_.listen([this](const StageState& state, std::span<const StageEvent> events) {
        const std::lock_guard lock(mutex_);
        for (Attendant* attendant : attendants_)
            attendant->tell(state, events);
    });
}

HapticsService::~HapticsService() {
    stage_.listen({});
}

grpc::ServerBidiReactor<v1::Word, v1::News>* HapticsService::Attend(grpc::CallbackServerContext*) {
    auto* attendant = new Attendant(*this);
    const std::lock_guard lock(mutex_);
    attendants_.push_back(attendant);
    return attendant;
}

void HapticsService::forget(Attendant* attendant) {
    const std::lock_guard lock(mutex_);
    std::erase(attendants_, attendant);
}

grpc::ServerUnaryReactor* HapticsService::Apply(grpc::CallbackServerContext* context,
                                                const v1::Transaction* request, v1::Applied* reply) {
    grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
    (namesUpload(*request) ? slow_ : quick_).run([this, request, reply, reactor] {
        const ClientId who = stage_.whoHas(request->key());
        if (who == 0) return reactor->Finish(kUnknown);
        const auto uploadOf = [&](std::uint64_t number) { return uploads_.find(who, number); };
        const auto done = withinMemory([&] {
            return stage_.change(who, request->base(), [&](Scene& scene) {
                return makeEdits(scene, request->edit(), uploadOf, parts_);
            });
        });
        if (!done) return reactor->Finish(statusOf(done.error()));
        reply->set_revision(done->revision);
        reply->set_felt_after(done->feltAfter);
        for (const ObjectId object : done->added)
            reply->add_added(object);
        reactor->Finish(grpc::Status::OK);
    });
    return reactor;
}

grpc::ServerUnaryReactor* HapticsService::Order(grpc::CallbackServerContext* context,
                                                const v1::OrderRequest* request, v1::OrderReply* reply) {
    grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
    const ClientId who = stage_.whoHas(request->key());
    if (request->has_stop()) {
        stage_.stop(who); // first of all, and whoever says so
    } else if (who == 0) {
        reactor->Finish(kUnknown);
        return reactor;
    } else if (const auto obeyed = obey(stage_, who, *request); !obeyed) {
        reactor->Finish(statusOf(obeyed.error()));
        return reactor;
    }
    reply->set_pen(stage_.hasPen(who));
    reply->set_armed(stage_.armed());
    reactor->Finish(grpc::Status::OK);
    return reactor;
}

grpc::ServerUnaryReactor* HapticsService::Describe(grpc::CallbackServerContext* context,
                                                   const v1::DescribeRequest* request,
                                                   v1::SceneDescription* reply) {
    grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
    if (stage_.whoHas(request->key()) == 0) {
        reactor->Finish(kUnknown);
        return reactor;
    }
    write(*reply, stage_.scenery());
    reactor->Finish(grpc::Status::OK);
    return reactor;
}

grpc::ServerBidiReactor<v1::Piece, v1::UploadNews>* HapticsService::Upload(grpc::CallbackServerContext*) {
    return new UploadCall(*this, slow_);
}

grpc::ServerWriteReactor<v1::SceneBytes>* HapticsService::Fetch(grpc::CallbackServerContext*,
                                                                const v1::FetchRequest* request) {
    if (stage_.whoHas(request->key()) == 0) return new Pieces<v1::SceneBytes>(kUnknown);
    return new Pieces<v1::SceneBytes>(slow_, [this](v1::SceneBytes& first) {
        const auto scenery = stage_.scenery();
        first.set_revision(scenery.revision);
        return bytesOf(withoutKept(*scenery.scene));
    });
}

grpc::ServerWriteReactor<v1::RecordBytes>* HapticsService::Record(grpc::CallbackServerContext*,
                                                                  const v1::RecordRequest* request) {
    if (stage_.whoHas(request->key()) == 0) return new Pieces<v1::RecordBytes>(kUnknown);
    return new Pieces<v1::RecordBytes>(slow_, [this](v1::RecordBytes&) {
        return recordingBytes({stage_.recorded(), "A client asked for it.", {}});
    });
}

grpc::ServerWriteReactor<v1::ReplayRows>* HapticsService::Replay(grpc::CallbackServerContext*,
                                                                 const v1::ReplayRequest* request) {
    if (stage_.whoHas(request->key()) == 0) return new Replaying(kUnknown);
    auto path = pathOf(request->path());
    if (!path) return new Replaying(statusOf(path.error()));
    return new Replaying(stage_, slow_, std::move(*path));
}

} // namespace tactum
