// How the view is divided: plain values.
#pragma once

namespace tactum {

/// One view; two side by side or one above the other, the own one and that from the right; or four, with
/// those from above and from the front.
enum class ViewSplit { One, Columns, Rows, Four };

} // namespace tactum
