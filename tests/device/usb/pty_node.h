// A device node that poll() can be told about: a pseudo-terminal, whose flow stands for a transfer to fetch.
#pragma once

#include <string>

namespace tactum::test {

/// A file of umockdev's own says "ready" all the time and never hangs up. Destroying this one hangs up.
class PtyNode {
public:
    PtyNode();
    ~PtyNode();
    PtyNode(const PtyNode&) = delete;
    PtyNode& operator=(const PtyNode&) = delete;

    /// What open() has to be led to.
    const std::string& path() const { return path_; }
    /// Whether poll() says POLLOUT to whoever has it open. At first it does not.
    void setReady(bool ready);

private:
    int master_ = -1, slave_ = -1;
    std::string path_;
    bool ready_ = true;
};

} // namespace tactum::test
