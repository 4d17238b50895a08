// The pictures of the self-test.
#pragma once

#include <QDir>

namespace tactum {

/// With an emulated Falcon whose x is turned round; takes a minute. Where `all` is wanted also light and in
/// German.
void takeSelfTestPictures(const QDir& folder, bool all);

} // namespace tactum
