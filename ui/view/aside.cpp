#include "ui/view/aside.h"

namespace tactum {

QThreadPool& asidePool() {
    static QThreadPool pool;
    static const bool prepared = [] {
        pool.setMaxThreadCount(2);
        pool.setThreadPriority(QThread::LowPriority);
        return true;
    }();
    (void)prepared;
    return pool;
}

} // namespace tactum
