// A service on a port of this machine that speaks as Haply's does, written from docs.haply.co, version 3.5.x,
// pages "WebSocket Protocol" (inventory, one answer a message, full state on request), "Control Commands"
// (set_cursor_force has a "vector"), "Device Configuration" and "Mount & Workspace" (a preset is an object;
// the origin of "defaults" is the device's base), "HTTP" (GET /version). What is not of these words is not
// understood: as the real one it answers nevertheless, and does nothing. As version 3.1 it knows the words of
// the programs of that time alone.
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
    std::atomic<bool> silent{false};      ///< no answers
    std::atomic<bool> keepsPreset{false}; ///< another program has the device in its workspace
    std::atomic<bool> passesForces{true}; ///< false: forces are switched off in Haply's own program
    std::atomic<int> minor{5};            ///< of its version, 3
    void setAnswer(std::string text);     ///< in place of every answer; empty for the right ones

    // What it heard.
    std::array<std::atomic<double>, 3> motors{};
    std::atomic<double> strongest{0};
    std::atomic<int> notFinite{0}, misuses{0}, heard{0}, greetings{0}, visitors{0};
    std::atomic<int> notUnderstood{0}; ///< commands that did nothing
    std::atomic<bool> centered{false}; ///< the workspace is about the origin

private:
    struct Impl;
    void serve();
    void hear(const std::string& text);
    std::string tell(bool full) const;

    std::unique_ptr<Impl> impl_;
    mutable std::mutex mutex_;
    std::string answer_;
    bool asksFull_ = false; ///< the last message
    std::jthread thread_;
};

} // namespace tactum::test
