#include "core/protocol/connection.h"

#include <algorithm>
#include <mutex>

#include <grpc/support/log.h>

namespace tactum {
namespace {

constexpr auto kBeat = std::chrono::milliseconds(200); // a heartbeat each 250 ms is what the server wants
constexpr auto kSilence = std::chrono::milliseconds(750);
constexpr auto kLongest = std::chrono::seconds(60); // of a call
constexpr std::size_t kPiece = 1 << 18, kMostEvents = 4096;

class TokenPlugin final : public grpc::MetadataCredentialsPlugin {
public:
    explicit TokenPlugin(std::string token) : token_(std::move(token)) {}
    grpc::Status GetMetadata(grpc::string_ref, grpc::string_ref, const grpc::AuthContext&,
                             std::multimap<grpc::string, grpc::string>* metadata) override {
        metadata->emplace("tactum-token", token_);
        return grpc::Status::OK;
    }

private:
    std::string token_;
};

/// What it says of a network is for those who wrote it; that nobody answers is said by the program.
void quietNetwork() {
    static std::once_flag once;
    std::call_once(once, [] {
        gpr_set_log_verbosity(GPR_LOG_SEVERITY_ERROR), gpr_set_log_function([](gpr_log_func_args*) {});
    });
}

std::shared_ptr<grpc::ChannelCredentials> credentialsOf(const ConnectionOptions& options) {
    if (options.certificate.empty()) return grpc::InsecureChannelCredentials();
    grpc::SslCredentialsOptions ssl;
    ssl.pem_root_certs = options.certificate;
    return grpc::CompositeChannelCredentials(
        grpc::SslCredentials(ssl),
        grpc::MetadataCredentialsFromPlugin(std::make_unique<TokenPlugin>(options.token)));
}

constexpr std::size_t kMostBytes = std::size_t(2) << 30; ///< of an answer; a server may go on for ever
constexpr const char* kTooMuch = "the server sends more than a scene can be";

std::string sentenceOf(const grpc::Status& status) {
    if (status.ok()) return {};
    return status.error_message().empty() ? "the server did not answer" : status.error_message();
}

/// All pieces in one. False: they were too much, and the call is given up.
template <class Piece, class First>
bool gather(grpc::ClientReader<Piece>& stream, grpc::ClientContext& context, std::string& bytes,
            First first) {
    bytes.clear();
    for (Piece piece; stream.Read(&piece); bytes += piece.bytes()) {
        if (bytes.empty()) first(piece);
        if (bytes.size() + piece.bytes().size() <= kMostBytes) continue;
        context.TryCancel();
        return false;
    }
    return true;
}

} // namespace

/// One that ends when the connection does.
class Connection::Call {
public:
    explicit Call(Connection& by) : by_(by) {
        const std::lock_guard lock(by.mutex_);
        key = by.key_;
        by.calls_.insert(&context);
        if (by.leaving_) context.TryCancel();
    }
    ~Call() {
        const std::lock_guard lock(by_.mutex_);
        by_.calls_.erase(&context);
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    grpc::ClientContext context;
    std::string key;

private:
    Connection& by_;
};

// Channels that share nothing: an upload never holds up what is said meanwhile.
std::shared_ptr<grpc::Channel> Connection::channel() const {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
    arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1000);
    quietNetwork();
    return grpc::CreateCustomChannel(target_, credentials_, arguments);
}

Connection::Connection(const std::string& target, const std::string& name, const ConnectionOptions& options)
    : target_(target), heardBy_(options.heard), credentials_(credentialsOf(options)),
      stub_(v1::Haptics::NewStub(channel())), uploads_(v1::Haptics::NewStub(channel())) {
    context_.set_wait_for_ready(true);
    context_.set_initial_metadata_corked(true); // else Attend() itself waits for the server, for ever
    call_ = stub_->Attend(&context_);
    v1::Word word;
    word.set_name(name);
    word.set_wants_pen(true);
    word.set_bodies(true);
    word.set_state_rate(options.stateRate);
    word.set_telemetry(options.telemetry);
    reader_ = std::thread([this] { read(); });
    heart_ = std::thread([this, word] {
        say(word);
        beat();
    });
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(options.patience),
                      [this] { return ended_ || !key_.empty(); });
    if (!key_.empty()) return;
    if (fault_.empty()) fault_ = "no server answered at " + target;
    lock.unlock();
    context_.TryCancel();
}

void Connection::leave() {
    {
        const std::lock_guard lock(mutex_);
        leaving_ = true;
        for (grpc::ClientContext* call : calls_)
            call->TryCancel();
    }
    changed_.notify_all();
    context_.TryCancel();
}

Connection::~Connection() {
    leave();
    heart_.join();
    reader_.join();
}

bool Connection::open() const {
    const std::lock_guard lock(mutex_);
    return !key_.empty() && !ended_ && Clock::now() - heard_ < kSilence;
}

std::string Connection::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

bool Connection::answered() const {
    const std::lock_guard lock(mutex_);
    return answered_;
}

void Connection::read() {
    v1::News news;
    while (call_->Read(&news))
        hear(news);
    const grpc::Status status = call_->Finish();
    const std::string why = sentenceOf(status);
    const std::lock_guard lock(mutex_);
    answered_ = answered_ || status.error_code() == grpc::StatusCode::UNAUTHENTICATED ||
                status.error_code() == grpc::StatusCode::FAILED_PRECONDITION ||
                status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED;
    if (fault_.empty()) fault_ = why.empty() ? "the server has ended" : why;
    ended_ = true;
    changed_.notify_all();
}

void Connection::hear(const v1::News& news) {
    std::unique_lock lock(mutex_);
    heard_ = Clock::now();
    if (news.has_welcome()) key_ = news.welcome().key();
    if (news.has_event() && events_.size() < kMostEvents) events_.push_back(news.event());
    if (news.has_state()) state_ = news.state();
    changed_.notify_all();
    lock.unlock();
    if (heardBy_) heardBy_(news);
    if (!news.has_state()) return;
    v1::Word seen;
    seen.set_seen(news.state().number());
    say(seen);
}

void Connection::beat() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kBeat, [this] { return leaving_ || ended_; })) {
        lock.unlock();
        say({});
        lock.lock();
    }
}

void Connection::say(const v1::Word& word) {
    const std::lock_guard lock(writing_);
    call_->Write(word);
}

std::string Connection::apply(v1::Transaction& transaction, v1::Applied& applied) {
    Call call(*this);
    call.context.set_deadline(std::chrono::system_clock::now() + kLongest);
    transaction.set_key(call.key);
    return sentenceOf(stub_->Apply(&call.context, transaction, &applied));
}

std::string Connection::order(v1::OrderRequest& request, v1::OrderReply& reply) {
    Call call(*this);
    call.context.set_deadline(std::chrono::system_clock::now() + kLongest);
    request.set_key(call.key);
    return sentenceOf(stub_->Order(&call.context, request, &reply));
}

std::string Connection::upload(v1::UploadHead head, const std::string& bytes, std::uint64_t& number) {
    Call call(*this);
    auto stream = uploads_->Upload(&call.context);
    head.set_key(call.key);
    head.set_size(bytes.size());
    // What the server says meanwhile is little: it waits until all is written.
    for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
        v1::Piece piece;
        if (at == 0) *piece.mutable_head() = head;
        piece.set_bytes(bytes.substr(at, kPiece));
        if (!stream->Write(piece)) break;
    }
    stream->WritesDone();
    v1::UploadNews news;
    while (stream->Read(&news))
        if (news.has_done()) number = news.done().upload();
    return sentenceOf(stream->Finish());
}

std::string Connection::fetch(std::string& bytes, std::uint64_t& revision) {
    Call call(*this);
    v1::FetchRequest request;
    request.set_key(call.key);
    const auto stream = uploads_->Fetch(&call.context, request);
    const bool all = gather(*stream, call.context, bytes,
                            [&](const v1::SceneBytes& piece) { revision = piece.revision(); });
    const std::string why = sentenceOf(stream->Finish());
    return all ? why : kTooMuch;
}

std::string Connection::record(std::string& bytes) {
    Call call(*this);
    v1::RecordRequest request;
    request.set_key(call.key);
    const auto stream = uploads_->Record(&call.context, request);
    const bool all = gather(*stream, call.context, bytes, [](const v1::RecordBytes&) {});
    const std::string why = sentenceOf(stream->Finish());
    return all ? why : kTooMuch;
}

v1::State Connection::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

bool Connection::nextEvent(v1::Event& event) {
    const std::lock_guard lock(mutex_);
    if (events_.empty()) return false;
    event = std::move(events_.front());
    events_.pop_front();
    return true;
}

} // namespace tactum
