#include "device/vendor/web_socket.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>

namespace tactum {
namespace {

namespace net = boost::asio;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;

constexpr std::size_t kLargest = 1 << 20; ///< bytes of one message

net::ip::tcp::endpoint hereAt(int port) {
    return {net::ip::address_v4::loopback(), static_cast<unsigned short>(port)};
}

} // namespace

std::string httpGet(int port, const std::string& path, int patience) {
    namespace http = boost::beast::http;
    net::io_context context{1};
    boost::beast::tcp_stream stream(context);
    boost::beast::flat_buffer buffer;
    http::request<http::empty_body> request(http::verb::get, path, 11);
    request.set(http::field::host, "localhost:" + std::to_string(port));
    request.set(http::field::connection, "close");
    http::response<http::string_body> response;
    bool whole = false;
    stream.expires_after(std::chrono::milliseconds(patience));
    stream.async_connect(hereAt(port), [&](error_code refused) {
        if (refused) return;
        http::async_write(stream, request, [&](error_code unsent, std::size_t) {
            if (unsent) return;
            http::async_read(stream, buffer, response,
                             [&](error_code broken, std::size_t) { whole = !broken; });
        });
    });
    context.run();
    return whole && response.result() == http::status::ok ? response.body() : std::string();
}

struct WebSocket::Impl {
    net::io_context context{1};
    websocket::stream<net::ip::tcp::socket> stream{context};
    boost::beast::flat_buffer buffer;
    error_code fault;

    /// Runs the one operation that was begun; what takes longer is broken off.
    bool finish(int patience) {
        context.restart();
        context.run_for(std::chrono::milliseconds(patience));
        if (context.stopped()) return !fault;
        breakOff();
        context.run();
        fault = net::error::timed_out;
        return false;
    }
    void breakOff() {
        error_code ignored;
        stream.next_layer().close(ignored);
    }
};

WebSocket::WebSocket(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WebSocket::WebSocket(WebSocket&& other) noexcept = default;
WebSocket& WebSocket::operator=(WebSocket&& other) noexcept = default;
WebSocket::~WebSocket() = default;

Result<WebSocket> WebSocket::connect(int port, int patience) {
    auto impl = std::make_unique<Impl>();
    const auto note = [&fault = impl->fault](error_code code) { fault = code; };
    impl->stream.next_layer().async_connect(hereAt(port), note);
    if (!impl->finish(patience)) return machineError(impl->fault.message());
    error_code ignored;
    impl->stream.next_layer().set_option(net::ip::tcp::no_delay(true), ignored);
    impl->stream.read_message_max(kLargest);
    impl->stream.async_handshake("localhost:" + std::to_string(port), "/", note);
    if (!impl->finish(patience)) return machineError(impl->fault.message());
    return WebSocket(std::move(impl));
}

bool WebSocket::send(std::string_view text, int patience) {
    if (impl_->fault) return false;
    impl_->stream.text(true);
    impl_->stream.async_write(net::buffer(text.data(), text.size()),
                              [this](error_code code, std::size_t) { impl_->fault = code; });
    return impl_->finish(patience);
}

bool WebSocket::receive(std::string& text, int patience) {
    if (impl_->fault) return false;
    impl_->buffer.clear();
    impl_->stream.async_read(impl_->buffer, [this](error_code code, std::size_t) { impl_->fault = code; });
    if (!impl_->finish(patience)) return false;
    const auto data = impl_->buffer.cdata();
    text.assign(static_cast<const char*>(data.data()), data.size());
    return true;
}

} // namespace tactum
