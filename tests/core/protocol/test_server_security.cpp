// Who may not come in, and what strangers can do to those who may: threats N1 to N6.
#include <chrono>
#include <thread>

#include <QTemporaryDir>
#include <QTest>

#include <arpa/inet.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/protocol/front.h"
#include "tests/core/protocol/guest.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_server_security {

using namespace tactum;
using test::eventually;
using test::Guest;
using test::Served;

namespace {

/// A bare connection to a server of this machine.
class Socket {
public:
    explicit Socket(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected_ = connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
    }
    Socket(Socket&& other) noexcept
        : socket_(std::exchange(other.socket_, -1)), connected_(other.connected_) {}
    ~Socket() {
        if (socket_ >= 0) ::close(socket_);
    }
    bool connected() const { return connected_; }
    void say(std::string_view text) const { send(socket_, text.data(), text.size(), MSG_NOSIGNAL); }
    /// Whether the other side has closed it.
    bool closed() const {
        char byte = 0;
        const ssize_t got = recv(socket_, &byte, 1, MSG_DONTWAIT);
        return got == 0 || (got < 0 && errno != EAGAIN);
    }
    std::string heard() const {
        std::string all(4096, '\0');
        const ssize_t got = recv(socket_, all.data(), all.size(), MSG_DONTWAIT);
        all.resize(got > 0 ? std::size_t(got) : 0);
        return all;
    }

private:
    int socket_;
    bool connected_ = false;
};

constexpr std::string_view kPreface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";

/// s, until a guest has been welcomed; negative when it never was.
double timeToAttend(Guest& guest) {
    const auto begin = std::chrono::steady_clock::now();
    if (!guest.attend("good", false).ok()) return -1;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Allows this process so few descriptors for a while.
class FewDescriptors {
public:
    explicit FewDescriptors(rlim_t count) {
        getrlimit(RLIMIT_NOFILE, &before_);
        const rlimit few{std::min(count, before_.rlim_max), before_.rlim_max};
        setrlimit(RLIMIT_NOFILE, &few);
    }
    ~FewDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }

private:
    rlimit before_{};
};

ServerSettings secured(const Credentials& credentials) {
    ServerSettings settings;
    settings.credentials = credentials;
    return settings;
}

} // namespace

class TestServerSecurity : public QObject {
    Q_OBJECT

private slots:
    void onlyTheLoopbackGoesWithoutCredentials();
    void loopbackIsAnAddressAndNotAName();
    void theTokenIsNeeded();
    void plainTextAtTheTlsPort();
    void tlsAtThePlainPort();
    void browsersAreNotHeard();
    void credentialsAreKeptFromOthers();
    void oversizedMessagesAreRefused();
    void nonsenseIsHarmless();
    void crowdsDoNotKeepAGuestOut_data();
    void crowdsDoNotKeepAGuestOut();
    void shortOfDescriptorsItAcceptsAgain();
};

void TestServerSecurity::onlyTheLoopbackGoesWithoutCredentials() {
    for (const char* host : {"0.0.0.0", "::", "10.1.2.3"}) {
        ServerSettings settings;
        settings.host = host;
        Served served(settings);
        COMPARE_CONTAINS(served.begin(), "--make-certificate");
    }
}

void TestServerSecurity::loopbackIsAnAddressAndNotAName() {
    for (const char* host : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
        QVERIFY2(isLoopback(host), host);
    for (const char* host :
         {"127.evil.org", "0.0.0.0", "::", "128.0.0.1", "localhost.evil.org", "", "::ffff:10.0.0.1"})
        QVERIFY2(!isLoopback(host), host);
}

void TestServerSecurity::theTokenIsNeeded() {
    const auto credentials = makeCredentials({"server.example", "10.0.0.7"}).value();
    Served served(secured(credentials));
    QCOMPARE(served.begin(), std::string());
    Guest good(served.target(), credentials.certificate, credentials.token);
    QVERIFY(good.attend("good", true).ok());
    for (const std::string& token :
         {std::string(), std::string("wrong"), credentials.token.substr(1), credentials.token + "0"}) {
        Guest bad(served.target(), credentials.certificate, token);
        QCOMPARE_EQ(int(bad.attend("bad", true).error_code()), int(grpc::StatusCode::UNAUTHENTICATED));
        v1::OrderRequest stop; // nor has it any other call
        stop.mutable_stop();
        QVERIFY(!bad.order(stop).ok());
    }
    QCOMPARE_EQ(served.stage->attending(), std::size_t(1));
    // Another server's certificate is not believed.
    Guest fooled(served.target(), makeCredentials({}).value().certificate, credentials.token);
    QVERIFY(!fooled.attend("fooled", true).ok());
}

void TestServerSecurity::plainTextAtTheTlsPort() {
    Served served(secured(makeCredentials({}).value()));
    QCOMPARE(served.begin(), std::string());
    Guest plain(served.target());
    QVERIFY(!plain.attend("plain", true).ok());
    Socket socket(served.server->port());
    socket.say(kPreface);
    QVERIFY(eventually([&] { return socket.closed(); }));
}

void TestServerSecurity::tlsAtThePlainPort() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest tls(served.target(), makeCredentials({}).value().certificate);
    QVERIFY(!tls.attend("tls", true).ok());
}

// What a page in a browser can make it send: it is not answered at all.
void TestServerSecurity::browsersAreNotHeard() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    for (const char* request : {"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
                                "POST /tactum.v1.Haptics/Order HTTP/1.1\r\nHost: evil.org\r\nContent-Type: "
                                "application/grpc\r\n\r\n"}) {
        Socket socket(served.server->port());
        socket.say(request);
        QVERIFY(eventually([&] { return socket.closed(); }));
        QCOMPARE(socket.heard(), std::string());
    }
}

void TestServerSecurity::credentialsAreKeptFromOthers() {
    QTemporaryDir folder;
    const auto place = std::filesystem::path(folder.path().toStdString()) / "server";
    const auto made = makeCredentials({"a.example"}).value();
    QCOMPARE_EQ(made.token.size(), std::size_t(32));
    VERIFY_RESULT(saveCredentials(made, place));
    for (const char* name : {"key.pem", "token"}) {
        struct stat file {};
        QCOMPARE_EQ(stat((place / name).c_str(), &file), 0);
        QCOMPARE_EQ(unsigned(file.st_mode & 0777), 0600u);
    }
    const auto loaded = loadCredentials(place);
    VERIFY_RESULT(loaded);
    QCOMPARE(loaded->token, made.token);
    QCOMPARE(loaded->key, made.key);
    QCOMPARE_EQ(chmod((place / "token").c_str(), 0644), 0);
    COMPARE_CONTAINS(test::refusal(loadCredentials(place)), "others may read it");
    COMPARE_CONTAINS(test::refusal(loadCredentials(place / "nowhere")), "--make-certificate");
    COMPARE_CONTAINS(test::refusal(makeCredentials({"a,DNS:evil"})), "no name");
}

void TestServerSecurity::oversizedMessagesAreRefused() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    v1::Transaction large;
    large.add_edit()->mutable_layers()->add_layer()->mutable_image()->set_texels(std::string(5 << 20, 'x'));
    QCOMPARE_EQ(int(guest.apply(large).error_code()), int(grpc::StatusCode::RESOURCE_EXHAUSTED));
    QVERIFY(guest.apply(v1::Transaction()).ok()); // it goes on
}

/// HTTP/2 that begins rightly and goes on as it likes.
void TestServerSecurity::nonsenseIsHarmless() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    std::srand(21);
    for (int i = 0; i < 200; ++i) {
        Socket socket(served.server->port());
        std::string text(kPreface);
        for (int k = 0; k < 500; ++k)
            text += char(std::rand());
        socket.say(text);
    }
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
}

void TestServerSecurity::crowdsDoNotKeepAGuestOut_data() {
    QTest::addColumn<bool>("tls");
    QTest::addColumn<QByteArray>("begins");
    QTest::addColumn<bool>("drips");
    for (const bool tls : {false, true}) {
        const char* name = tls ? "tls" : "plain";
        QTest::addRow("half-open, %s", name) << tls << QByteArray() << false;
        QTest::addRow("a byte a second, %s", name) << tls << QByteArray() << true;
        QTest::addRow("preface and silence, %s", name)
            << tls
            << (tls ? QByteArray("\x16\x03\x01\x02\x00", 5) : QByteArray(kPreface.data(), kPreface.size()))
            << false;
    }
}

void TestServerSecurity::crowdsDoNotKeepAGuestOut() {
    QFETCH(bool, tls);
    QFETCH(QByteArray, begins);
    QFETCH(bool, drips);
    const auto credentials = makeCredentials({}).value();
    Served served(tls ? secured(credentials) : ServerSettings{});
    QCOMPARE(served.begin(), std::string());
    raiseDescriptorLimit();
    std::vector<Socket> crowd;
    for (int i = 0; i < 1000; ++i) {
        crowd.emplace_back(served.server->port());
        QVERIFY(crowd.back().connected());
        crowd.back().say({begins.data(), std::size_t(begins.size())});
    }
    std::atomic<bool> ending{false};
    std::thread dripping([&] {
        for (std::size_t at = 0; drips && !ending; ++at) {
            for (const Socket& socket : crowd)
                socket.say(std::string(1, tls ? '\x16' : kPreface[at % kPreface.size()]));
            for (int k = 0; k < 100 && !ending; ++k)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    });
    Guest guest(served.target(), tls ? credentials.certificate : "", tls ? credentials.token : "");
    const double seconds = timeToAttend(guest);
    ending = true;
    dripping.join();
    QCOMPARE_GT(seconds, 0.0);
    if (!qEnvironmentVariableIsSet("TACTUM_BUSY")) QCOMPARE_LT(seconds, 1.0);
    const std::uint64_t ticks = served.exchanges();
    QVERIFY(eventually([&] { return served.exchanges() > ticks + 200; }));
}

// gRPC itself would never accept again.
void TestServerSecurity::shortOfDescriptorsItAcceptsAgain() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest early(served.target());
    QVERIFY(early.attend("early", false).ok());
    {
        const FewDescriptors few(300);
        std::vector<Socket> crowd; // until this process can open no more
        for (int i = 0; i < 1000; ++i) {
            Socket socket(served.server->port());
            if (!socket.connected()) break;
            crowd.push_back(std::move(socket));
        }
        QCOMPARE_GT(crowd.size(), std::size_t(20));
    }
    Guest guest(served.target());
    QCOMPARE_GT(timeToAttend(guest), 0.0);
}

TACTUM_TEST(TestServerSecurity)

} // namespace test_server_security

#include "test_server_security.moc"
