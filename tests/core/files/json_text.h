// How QCOMPARE prints a part of a glTF file.
#pragma once

#include <QTest>

#include "core/files/gltf/gltf_file.h"

namespace QTest {

template <> inline char* toString(const tactum::Json& json) {
    return qstrdup(json.dump(-1, ' ', false, tactum::Json::error_handler_t::replace).c_str());
}

} // namespace QTest
