#include "tests/device/vendor/fake_haply.h"

#include <cmath>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <sys/socket.h>

namespace tactum::test {
namespace {

namespace net = boost::asio;
using net::ip::tcp;
using Json = nlohmann::json;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using Stream = websocket::stream<tcp::socket>;

constexpr std::array<double, 3> kCentre{0, -0.12, 0.15}; ///< m, of the workspace as "defaults" counts
constexpr const char* kNames[] = {"x", "y", "z"};
constexpr int kNewWords = 5;

Json vectorOf(const std::array<std::atomic<double>, 3>& values, const std::array<double, 3>& offset = {}) {
    return {{"x", values[0] + offset[0]}, {"y", values[1] + offset[1]}, {"z", values[2] + offset[2]}};
}

/// Answers a question for a page, and says whether it was one.
bool answersPage(tcp::socket& socket, const http::request<http::string_body>& request, int minor) {
    if (websocket::is_upgrade(request)) return false;
    const bool known = request.target() == "/version";
    http::response<http::string_body> response(known ? http::status::ok : http::status::not_found, 11);
    if (known) {
        const std::string version = "3." + std::to_string(minor) + ".0";
        response.body() = Json{{"git_tag", version}, {"project_version", version + ".0"}}.dump();
    }
    response.prepare_payload();
    boost::system::error_code ignored;
    http::write(socket, response, ignored);
    return true;
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

std::string FakeHaply::tell(bool full) const {
    const std::lock_guard lock(mutex_);
    if (!answer_.empty()) return answer_;
    Json message{{"session_id", 7}, {"inverse3", Json::array()}};
    if (present) {
        const std::array<std::atomic<double>, 3> none{};
        Json device{{"device_id", "049D"},
                    {"state",
                     {{"cursor_position", vectorOf(position, centered ? std::array<double, 3>{} : kCentre)},
                      {"cursor_velocity", vectorOf(velocity)},
                      {"current_cursor_force", vectorOf(passesForces ? motors : none)}}},
                    {"status", {{"calibrated", calibrated.load()}}}};
        if (full)
            device["config"] = {{"preset", centered ? "arm_front_centered" : "defaults"},
                                {"filters", {{"force_gate", {{"gain", 0.3}}}}}};
        message["inverse3"].push_back(device);
    }
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
    const Json session = message.value("session", Json::object());
    if (session.contains("configure")) ++greetings;
    asksFull_ = minor >= kNewWords && session.contains("force_render_full_state");
    const bool newWords = minor >= kNewWords;
    const Json& device = message["inverse3"][0];
    if (const Json configure = device.value("configure", Json::object()); configure.contains("preset")) {
        const Json& preset = configure["preset"];
        const Json wanted = newWords ? Json{{"preset", "arm_front_centered"}} : Json("arm_front_centered");
        if (configure.contains("mount") || preset != wanted)
            ++notUnderstood;
        else if (!keepsPreset)
            centered = true;
    }
    const Json& force = device["commands"]["set_cursor_force"];
    const char* const word = newWords ? "vector" : "values";
    if (!force.is_object() || force.size() != 1 || !force.contains(word)) {
        ++notUnderstood;
        return;
    }
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Json number = force[word].value(kNames[i], Json());
        const double value = number.is_number() ? number.get<double>() : std::nan("");
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
        boost::beast::flat_buffer buffer;
        http::request<http::string_body> request;
        http::read(stream.next_layer(), buffer, request, fault);
        if (fault || answersPage(stream.next_layer(), request, minor)) continue;
        ++visitors;
        stream.accept(request, fault);
        if (!fault && !silent) stream.write(net::buffer(tell(true)), fault);
        while (!fault && !impl_->stopped) {
            stream.read(buffer, fault);
            if (fault) break;
            hear(boost::beast::buffers_to_string(buffer.data()));
            buffer.clear();
            if (!silent) stream.write(net::buffer(tell(asksFull_)), fault);
        }
        impl_->setVisitor(-1);
    }
}

} // namespace tactum::test
