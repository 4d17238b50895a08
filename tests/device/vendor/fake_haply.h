// A service on a port of this machine that speaks as Haply's does, as far as its public pages say.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace tactum::test {

class FakeHaply {
public:
    FakeHaply();
    ~FakeHaply();
    FakeHaply(const FakeHaply&) = delete;
    FakeHaply& operator=(const FakeHaply&) = delete;

    int port() const;
    /// Ends what is spoken, and hears nobody any more.
    void stop();

    // What it tells. Metre, its own axes.
    std::array<std::atomic<double>, 3> position{}, velocity{};
    std::atomic<bool> button{false}, calibrated{true}, present{true};
    std::atomic<bool> silent{false};  ///< no answers
    void setAnswer(std::string text); ///< in place of every answer; empty for the right ones

    // What it heard.
    std::array<std::atomic<double>, 3> motors{};
    std::atomic<double> strongest{0};
    std::atomic<int> notFinite{0}, misuses{0}, heard{0}, greetings{0}, visitors{0};

private:
    struct Impl;
    void serve();
    void hear(const std::string& text);
    std::string tell() const;

    std::unique_ptr<Impl> impl_;
    mutable std::mutex mutex_;
    std::string answer_;
    std::jthread thread_;
};

} // namespace tactum::test
