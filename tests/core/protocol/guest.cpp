#include "tests/core/protocol/guest.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/core/runtime/probe_device.h"
#include "tests/support/soups.h"

namespace tactum::test {
namespace {

Scene plateScene() {
    Scene scene;
    SceneObject object;
    object.name = "plate";
    object.geometry = sheet(0.1);
    object.surfaces.resize(1);
    scene.add(object);
    return scene;
}

} // namespace

struct Served::Shared {
    std::vector<std::shared_ptr<Probe>> probes; ///< of each hand
};

Served::Served(ServerSettings given, std::size_t hands)
    : shared(std::make_shared<Shared>()), settings(std::move(given)) {
    while (shared->probes.size() < hands)
        shared->probes.push_back(std::make_shared<Probe>());
    for (std::size_t hand = 1; hand < hands; ++hand)
        shared->probes[hand]->name += ' ' + std::to_string(hand + 1);
}
Served::~Served() = default;

std::string Served::begin() {
    stage = std::make_unique<Stage>(std::make_unique<ProbeDevice>(shared->probes[0]), nullptr, plateScene());
    for (std::size_t hand = 1; hand < shared->probes.size(); ++hand)
        if (auto added = stage->addHand(std::make_unique<ProbeDevice>(shared->probes[hand]), nullptr); !added)
            return added.error().text;
    if (auto started = stage->start(); !started) return started.error().text;
    auto made = Server::start(*stage, settings);
    if (!made) return made.error().text;
    server = std::move(*made);
    return {};
}

std::string Served::target() const {
    return "127.0.0.1:" + std::to_string(server->port());
}
void Served::setHeight(double metres, std::size_t hand) {
    shared->probes[hand]->height = metres;
}
double Served::push(std::size_t hand) const {
    return shared->probes[hand]->push;
}
void Served::setReadable(bool on, std::size_t hand) {
    shared->probes[hand]->valid = on;
}
std::uint64_t Served::exchanges() const {
    return std::uint64_t(shared->probes[0]->exchanges);
}

void setDeadline(grpc::ClientContext& context) {
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(60));
}

struct Guest::Impl {
    std::shared_ptr<grpc::Channel> channel;
    std::unique_ptr<v1::Haptics::Stub> stub;
    grpc::ClientContext context;
    std::unique_ptr<grpc::ClientReaderWriter<v1::Word, v1::News>> call;
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::mutex writing;
    bool beating = true, reading = true, ended = false, leaving = false;
    v1::Welcome welcome;
    v1::State newest;
    std::size_t states = 0;
    std::vector<v1::Event> events;
    grpc::Status status;
    std::thread reader, heart;

    void say(const v1::Word& word) {
        const std::lock_guard lock(writing);
        call->Write(word);
    }
    void read() {
        v1::News news;
        while (call->Read(&news)) {
            std::uint64_t seen = 0;
            {
                const std::lock_guard lock(mutex);
                if (news.has_welcome()) welcome = news.welcome();
                if (news.has_event()) events.push_back(news.event());
                if (news.has_state()) {
                    newest = news.state();
                    ++states;
                    if (reading) seen = newest.number();
                }
            }
            changed.notify_all();
            v1::Word word;
            word.set_seen(seen);
            if (seen != 0) say(word);
        }
        const grpc::Status end = call->Finish();
        const std::lock_guard lock(mutex);
        status = end;
        ended = true;
        changed.notify_all();
    }
    void beat() {
        std::unique_lock lock(mutex);
        while (!ended && !leaving) {
            changed.wait_for(lock, std::chrono::milliseconds(100));
            if (ended || leaving || !beating) continue;
            lock.unlock();
            say({});
            lock.lock();
        }
    }
};

Guest::Guest(const std::string& target, const std::string& certificate, const std::string& token)
    : impl_(std::make_unique<Impl>()) {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    auto credentials = grpc::InsecureChannelCredentials();
    if (!certificate.empty()) {
        credentials = grpc::SslCredentials(
            {.pem_root_certs = certificate, .pem_private_key = {}, .pem_cert_chain = {}});
        class Plugin final : public grpc::MetadataCredentialsPlugin {
        public:
            explicit Plugin(std::string token) : token_(std::move(token)) {}
            grpc::Status GetMetadata(grpc::string_ref, grpc::string_ref, const grpc::AuthContext&,
                                     std::multimap<grpc::string, grpc::string>* metadata) override {
                metadata->emplace("tactum-token", token_);
                return grpc::Status::OK;
            }

        private:
            std::string token_;
        };
        if (!token.empty())
            credentials = grpc::CompositeChannelCredentials(
                credentials, grpc::MetadataCredentialsFromPlugin(std::make_unique<Plugin>(token)));
    }
    impl_->channel = grpc::CreateCustomChannel(target, credentials, arguments);
    impl_->stub = v1::Haptics::NewStub(impl_->channel);
}

Guest::~Guest() {
    if (!impl_->call) return;
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->leaving = true;
    }
    impl_->context.TryCancel();
    impl_->changed.notify_all();
    impl_->heart.join();
    impl_->reader.join();
}

grpc::Status Guest::attend(const std::string& name, bool wantsPen, double rate, bool bodies) {
    impl_->call = impl_->stub->Attend(&impl_->context);
    v1::Word word;
    word.set_name(name);
    word.set_wants_pen(wantsPen);
    word.set_state_rate(rate);
    word.set_bodies(bodies);
    impl_->say(word);
    impl_->reader = std::thread([this] { impl_->read(); });
    impl_->heart = std::thread([this] { impl_->beat(); });
    std::unique_lock lock(impl_->mutex);
    impl_->changed.wait_for(lock, std::chrono::seconds(60),
                            [this] { return impl_->ended || !impl_->welcome.key().empty(); });
    if (impl_->welcome.key().empty())
        return impl_->ended ? impl_->status
                            : grpc::Status(grpc::StatusCode::DEADLINE_EXCEEDED, "no welcome came");
    return grpc::Status::OK;
}

void Guest::say(const v1::Word& word) {
    impl_->say(word);
}
void Guest::setBeating(bool on) {
    const std::lock_guard lock(impl_->mutex);
    impl_->beating = on;
}
void Guest::setReading(bool on) {
    v1::Word word;
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->reading = on;
        word.set_seen(impl_->newest.number());
    }
    if (on) impl_->say(word); // what it has seen meanwhile
}
void Guest::leave() {
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->leaving = true;
    }
    const std::lock_guard lock(impl_->writing);
    impl_->call->WritesDone();
}
const v1::Welcome& Guest::welcome() const {
    return impl_->welcome;
}
std::size_t Guest::states() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->states;
}
v1::State Guest::newest() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->newest;
}
bool Guest::heard(v1::Event::Kind kind, const std::string& part) const {
    const std::lock_guard lock(impl_->mutex);
    for (const v1::Event& event : impl_->events)
        if (event.kind() == kind && event.text().find(part) != std::string::npos) return true;
    return false;
}
bool Guest::heardOf(std::uint32_t hand, v1::Event::Kind kind) const {
    const std::lock_guard lock(impl_->mutex);
    return std::ranges::any_of(
        impl_->events, [&](const v1::Event& event) { return event.kind() == kind && event.hand() == hand; });
}
bool Guest::ended() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->ended;
}

grpc::Status Guest::apply(const v1::Transaction& edits, v1::Applied* applied) {
    grpc::ClientContext context;
    setDeadline(context);
    v1::Transaction request = edits;
    if (request.key().empty()) request.set_key(impl_->welcome.key());
    v1::Applied reply;
    const grpc::Status status = impl_->stub->Apply(&context, request, &reply);
    if (applied) *applied = reply;
    return status;
}

grpc::Status Guest::apply(const v1::Edit& edit, v1::Applied* applied) {
    v1::Transaction transaction;
    *transaction.add_edit() = edit;
    return apply(transaction, applied);
}

grpc::Status Guest::order(v1::OrderRequest request, v1::OrderReply* reply) {
    grpc::ClientContext context;
    setDeadline(context);
    request.set_key(impl_->welcome.key());
    v1::OrderReply answer;
    const grpc::Status status = impl_->stub->Order(&context, request, &answer);
    if (reply) *reply = answer;
    return status;
}

grpc::Status Guest::upload(v1::UploadHead head, const std::string& bytes, v1::Uploaded* uploaded,
                           std::size_t piece) {
    grpc::ClientContext context;
    setDeadline(context);
    auto call = impl_->stub->Upload(&context);
    head.set_key(impl_->welcome.key());
    if (head.size() == 0) head.set_size(bytes.size());
    std::thread writer([&] {
        for (std::size_t at = 0; at == 0 || at < bytes.size(); at += piece) {
            v1::Piece part;
            if (at == 0) *part.mutable_head() = head;
            part.set_bytes(bytes.substr(at, piece));
            if (!call->Write(part)) break;
        }
        call->WritesDone();
    });
    v1::UploadNews news;
    while (call->Read(&news))
        if (news.has_done() && uploaded) *uploaded = news.done();
    writer.join();
    return call->Finish();
}

v1::Haptics::Stub& Guest::stub() {
    return *impl_->stub;
}

} // namespace tactum::test
