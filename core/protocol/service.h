// The calls of the protocol, made to a stage. Everything that comes in is judged here or in edits.h and
// uploads.h.
#pragma once

#include <atomic>
#include <mutex>
#include <vector>

#include "core/protocol/messages.h"
#include "core/protocol/scene_parts.h"
#include "core/protocol/uploads.h"
#include "core/protocol/workers.h"
#include "core/session/stage.h"

namespace tactum {

class Attendant;

struct ServiceSettings {
    std::string name = "Tactum"; ///< of the server, for people
    double pushLimit = 1;        ///< N, of what clients add to the force; 0: they may not
    UploadLimits uploads;
};

/// Outlives its server, is outlived by its stage. Thread: gRPC's, and that of the stage.
class HapticsService final : public v1::Haptics::CallbackService {
public:
    HapticsService(Stage& stage, ServiceSettings settings);
    ~HapticsService() override;

    grpc::ServerBidiReactor<v1::Word, v1::News>* Attend(grpc::CallbackServerContext* context) override;
    grpc::ServerUnaryReactor* Apply(grpc::CallbackServerContext* context, const v1::Transaction* request,
                                    v1::Applied* reply) override;
    grpc::ServerUnaryReactor* Order(grpc::CallbackServerContext* context, const v1::OrderRequest* request,
                                    v1::OrderReply* reply) override;
    grpc::ServerUnaryReactor* Describe(grpc::CallbackServerContext* context,
                                       const v1::DescribeRequest* request,
                                       v1::SceneDescription* reply) override;
    grpc::ServerBidiReactor<v1::Piece, v1::UploadNews>* Upload(grpc::CallbackServerContext* context) override;
    grpc::ServerWriteReactor<v1::ReplayRows>* Replay(grpc::CallbackServerContext* context,
                                                     const v1::ReplayRequest* request) override;
    grpc::ServerWriteReactor<v1::SceneBytes>* Fetch(grpc::CallbackServerContext* context,
                                                    const v1::FetchRequest* request) override;
    grpc::ServerWriteReactor<v1::RecordBytes>* Record(grpc::CallbackServerContext* context,
                                                      const v1::RecordRequest* request) override;

    Stage& stage() { return stage_; }
    Uploads& uploads() { return uploads_; }
    SceneParts& parts() { return parts_; }
    const ServiceSettings& settings() const { return settings_; }
    /// Of an attendant that is about to end.
    void forget(Attendant* attendant);

private:
    Stage& stage_;
    ServiceSettings settings_;
    Uploads uploads_;
    SceneParts parts_;
    std::mutex mutex_;
    std::vector<Attendant*> attendants_;
    Workers quick_{1}, slow_{2}; ///< last: they end first
};

} // namespace tactum
