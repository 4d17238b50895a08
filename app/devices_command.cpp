#include <iostream>

#include "app/commands.h"
#include "device/registry.h"

namespace tactum {

Result<int> runDevices() {
    for (const DeviceListing& listing : listDevices())
        std::cout << listing.name << ": " << (listing.usable ? "ready" : "not usable") << ": "
                  << listing.sentence << '\n';
    return 0;
}

} // namespace tactum
