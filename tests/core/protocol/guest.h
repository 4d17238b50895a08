// A client for tests: attends, says what it is told to and remembers what it hears.
#pragma once

#include <memory>
#include <string>

#include "core/protocol/server.h"

namespace tactum::test {

/// Devices whose fingers a test leads, a stage over a plate in z = 0 (normal z, 0.2 m wide), and its server.
struct Served {
    explicit Served(ServerSettings settings = {}, std::size_t hands = 1);
    ~Served();
    /// Empty when it runs.
    std::string begin();
    std::string target() const;

    struct Shared;
    std::shared_ptr<struct Shared> shared;
    ServerSettings settings;
    std::unique_ptr<Stage> stage;
    std::unique_ptr<Server> server;

    void setHeight(double metres, std::size_t hand = 0); ///< of the finger over the plate
    double push(std::size_t hand = 0) const;             ///< newest command along z, N
    void setReadable(bool on, std::size_t hand = 0);     ///< whether its readings can be used
    std::uint64_t exchanges() const;
};

class Guest {
public:
    /// `certificate` empty: without TLS.
    explicit Guest(const std::string& target, const std::string& certificate = {},
                   const std::string& token = {});
    ~Guest();
    Guest(const Guest&) = delete;
    Guest& operator=(const Guest&) = delete;

    /// Attends; the error is what the server said.
    grpc::Status attend(const std::string& name, bool wantsPen, double rate = 60, bool bodies = false);
    void say(const v1::Word& word);
    void setBeating(bool on); ///< whether it says heartbeats by itself; at first it does
    void setReading(bool on); ///< whether it gives credits back; at first it does
    void leave();             ///< ends the attendance in order
    const v1::Welcome& welcome() const;
    std::size_t states() const;
    v1::State newest() const;
    bool heard(v1::Event::Kind kind, const std::string& part = {}) const;
    bool heardOf(std::uint32_t hand, v1::Event::Kind kind) const;
    bool ended() const; ///< the server, or the attendance

    grpc::Status apply(const v1::Transaction& edits, v1::Applied* applied = nullptr);
    grpc::Status apply(const v1::Edit& edit, v1::Applied* applied = nullptr);
    grpc::Status order(v1::OrderRequest request, v1::OrderReply* reply = nullptr);
    grpc::Status upload(v1::UploadHead head, const std::string& bytes, v1::Uploaded* uploaded,
                        std::size_t piece = 1 << 16);
    v1::Haptics::Stub& stub();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Of every call: it ends, whatever happens.
void setDeadline(grpc::ClientContext& context);

} // namespace tactum::test
