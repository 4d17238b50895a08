#include "tests/device/usb/pty_node.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace tactum::test {

namespace {

int checked(int result) {
    if (result < 0) throw std::system_error(errno, std::generic_category(), "a pseudo-terminal");
    return result;
}

} // namespace

PtyNode::PtyNode() : master_(checked(posix_openpt(O_RDWR | O_NOCTTY))) {
    checked(grantpt(master_));
    checked(unlockpt(master_));
    path_ = ptsname(master_);
    slave_ = checked(open(path_.c_str(), O_RDWR | O_NOCTTY));
    setReady(false);
}

PtyNode::~PtyNode() {
    close(master_); // the slaves learn POLLERR and POLLHUP
    close(slave_);
}

void PtyNode::setReady(bool ready) {
    if (ready != ready_) tcflow(slave_, ready ? TCOON : TCOOFF);
    ready_ = ready;
}

} // namespace tactum::test
