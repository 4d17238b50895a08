#include "core/protocol/server.h"

#include <chrono>
#include <cstdio>

#include <arpa/inet.h>
#include <grpc/support/log.h>
#include <grpcpp/security/auth_metadata_processor.h>

#include "core/base/text.h"
#include "core/protocol/front.h"
#include "core/session/secret.h"

namespace tactum {
namespace {

constexpr int kLargestMessage = 4 << 20; ///< bytes
constexpr const char* kTokenField = "tactum-token";

/// What gRPC says holds whatever a stranger sent: shown as text that is one line, and without the names of
/// files.
void logPrintable(gpr_log_func_args* args) {
    if (args->severity != GPR_LOG_SEVERITY_ERROR) return;
    std::fprintf(stderr, "tactum serve: the network: %s\n", printable(args->message, 300).c_str());
}

void limitLog() {
    gpr_set_log_verbosity(GPR_LOG_SEVERITY_ERROR);
    gpr_set_log_function(logPrintable);
}

class TokenCheck final : public grpc::AuthMetadataProcessor {
public:
    explicit TokenCheck(std::string token) : token_(std::move(token)) {}

    bool IsBlocking() const override { return false; }
    grpc::Status Process(const InputMetadata& given, grpc::AuthContext*, OutputMetadata* used,
                         OutputMetadata*) override {
        const auto found = given.find(kTokenField);
        if (found == given.end() || !sameSecret(token_, {found->second.data(), found->second.size()}))
            return {grpc::StatusCode::UNAUTHENTICATED,
                    "the token is missing or wrong: copy the server's file token to the client"};
        used->emplace(kTokenField, std::string(found->second.data(), found->second.size()));
        return grpc::Status::OK;
    }

private:
    std::string token_;
};

std::shared_ptr<grpc::ServerCredentials> credentialsOf(const std::optional<Credentials>& given) {
    if (!given) return grpc::InsecureServerCredentials();
    grpc::SslServerCredentialsOptions options;
    options.pem_key_cert_pairs.push_back({given->key, given->certificate});
    auto credentials = grpc::SslServerCredentials(options);
    credentials->SetAuthMetadataProcessor(std::make_shared<TokenCheck>(given->token));
    return credentials;
}

/// The keepalive only tidies up: our own heartbeat is the one that counts.
void limit(grpc::ServerBuilder& builder) {
    builder.SetMaxReceiveMessageSize(kLargestMessage);
    builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, 16);
    builder.AddChannelArgument(GRPC_ARG_MAX_METADATA_SIZE, 8192);
    builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, 1000);
    builder.AddChannelArgument(GRPC_ARG_MAX_CONNECTION_IDLE_MS, 3000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 2000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 2000);
    builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
    builder.AddChannelArgument(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);
    builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 100);
    builder.AddChannelArgument(GRPC_ARG_HTTP2_MAX_PING_STRIKES, 0);
}

} // namespace

bool isLoopback(std::string_view host) {
    if (host == "localhost") return true;
    const std::string text(host);
    in_addr four{};
    in6_addr six{};
    if (inet_pton(AF_INET, text.c_str(), &four) == 1) return (ntohl(four.s_addr) >> 24) == 127;
    return inet_pton(AF_INET6, text.c_str(), &six) == 1 && IN6_IS_ADDR_LOOPBACK(&six);
}

struct Server::Impl {
    Impl(Stage& stage, ServiceSettings settings) : service(stage, std::move(settings)) {}

    HapticsService service;
    Front front;
    std::unique_ptr<grpc::experimental::ExternalConnectionAcceptor> door;
    std::unique_ptr<grpc::Server> server;
};

Server::Server(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<Server>> Server::start(Stage& stage, ServerSettings settings) {
    if (!isLoopback(settings.host) && !settings.credentials)
        return inputError(printable(settings.host) +
                          " can be reached by others: that needs a certificate and a token; "
                          "make them with tactum serve --make-certificate NAME");
    limitLog();
    raiseDescriptorLimit();
    auto impl = std::make_unique<Impl>(stage, settings.service);
    if (auto opened = impl->front.open(settings.host, settings.port); !opened)
        return tl::unexpected(opened.error());
    grpc::ServerBuilder builder;
    limit(builder);
    builder.RegisterService(&impl->service);
    impl->door = builder.experimental().AddExternalConnectionAcceptor(
        grpc::ServerBuilder::experimental_type::ExternalConnectionType::FROM_FD,
        credentialsOf(settings.credentials));
    impl->server = builder.BuildAndStart();
    if (!impl->server)
        return machineError("the server could not be started: its certificate or key may be damaged");
    impl->front.begin(settings.credentials.has_value(), [door = impl->door.get()](int descriptor) {
        grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters parameters;
        parameters.fd = descriptor;
        door->HandleNewConnection(&parameters);
    });
    return std::unique_ptr<Server>(new Server(std::move(impl)));
}

Server::~Server() {
    if (!impl_) return;
    impl_->front.close();
    impl_->server->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(200));
    impl_->server->Wait();
}

std::uint16_t Server::port() const {
    return impl_->front.port();
}

} // namespace tactum
