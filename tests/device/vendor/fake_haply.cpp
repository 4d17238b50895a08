#include "tests/device/vendor/fake_haply.h"

#include <cmath>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <sys/socket.h>

namespace tactum::test {
namespace {

namespace net = boost::asio;
using net::ip::tcp;
using Json = nlohmann::json;
using Stream = boost::beast::websocket::stream<tcp::socket>;

Json vectorOf(const std::array<std::atomic<double>, 3>& values) {
    return {{"x", values[0].load()}, {"y", values[1].load()}, {"z", values[2].load()}};
}

} // namespace

struct FakeHaply::Impl {
    net::io_context context{1};
    tcp::acceptor acceptor{context, {net::ip::address_v4::loopback(), 0}};
    std::mutex mutex;
    int visitor = -1; ///< descriptor, to hang up from another thread
    std::atomic<bool> stopped{false};

    void setVisitor(int descriptor) {
        const std::lock_guard lock(mutex);
        visitor = descriptor;
    }
};

FakeHaply::FakeHaply() : impl_(std::make_unique<Impl>()), thread_([this] { serve(); }) {}

FakeHaply::~FakeHaply() {
    stop();
}

int FakeHaply::port() const {
    return impl_->acceptor.local_endpoint().port();
}

void FakeHaply::stop() {
    impl_->stopped = true;
    if (impl_->acceptor.is_open()) shutdown(impl_->acceptor.native_handle(), SHUT_RDWR);
    {
        const std::lock_guard lock(impl_->mutex);
        if (impl_->visitor >= 0) shutdown(impl_->visitor, SHUT_RDWR);
    }
    if (thread_.joinable()) thread_.join();
    boost::system::error_code ignored; // here: one thread has the acceptor at a time
    impl_->acceptor.close(ignored);
}

void FakeHaply::setAnswer(std::string text) {
    const std::lock_guard lock(mutex_);
    answer_ = std::move(text);
}

std::string FakeHaply::tell() const {
    const std::lock_guard lock(mutex_);
    if (!answer_.empty()) return answer_;
    Json message{{"session_id", 7}, {"inverse3", Json::array()}};
    if (present)
        message["inverse3"].push_back(
            {{"device_id", "049D"},
             {"state", {{"cursor_position", vectorOf(position)}, {"cursor_velocity", vectorOf(velocity)}}},
             {"status", {{"calibrated", calibrated.load()}}}});
    message["wireless_verse_grip"] = Json::array(
        {{{"device_id", "61548"}, {"state", {{"buttons", {{"a", false}, {"b", button.load()}}}}}}});
    return message.dump();
}

void FakeHaply::hear(const std::string& text) {
    const Json message = Json::parse(text, nullptr, false);
    if (message.is_discarded() || message["inverse3"][0]["device_id"] != "049D") {
        ++misuses;
        return;
    }
    ++heard;
    if (message.contains("session")) ++greetings;
    const Json& force = message["inverse3"][0]["commands"]["set_cursor_force"]["values"];
    double square = 0;
    constexpr const char* kNames[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = force[kNames[i]].is_number() ? force[kNames[i]].get<double>() : std::nan("");
        motors[i] = value;
        square += value * value;
    }
    if (!std::isfinite(square)) ++notFinite;
    if (std::sqrt(square) > strongest) strongest = std::sqrt(square);
}

void FakeHaply::serve() {
    while (!impl_->stopped) {
        boost::system::error_code fault;
        Stream stream(impl_->context);
        impl_->acceptor.accept(stream.next_layer(), fault);
        if (fault) break;
        impl_->setVisitor(stream.next_layer().native_handle());
        ++visitors;
        stream.accept(fault);
        if (!fault && !silent) stream.write(net::buffer(tell()), fault);
        boost::beast::flat_buffer buffer;
        while (!fault && !impl_->stopped) {
            stream.read(buffer, fault);
            if (fault) break;
            hear(boost::beast::buffers_to_string(buffer.data()));
            buffer.clear();
            if (!silent) stream.write(net::buffer(tell()), fault);
        }
        impl_->setVisitor(-1);
    }
}

} // namespace tactum::test
