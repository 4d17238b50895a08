#include "app/commands.h"
#include "app/results.h"
#include "app/streams.h"
#include "core/bundle/preview.h"

namespace tactum {

Result<int> runThumbnail(const ThumbnailOptions& options) {
    const auto loaded = importGiven(options.in);
    if (!loaded) return tl::unexpected(loaded.error());
    const int side = int(options.size);
    if (const auto written = writeFile(options.out, previewOf(loaded->scene, side, side)); !written)
        return tl::unexpected(written.error());
    return 0;
}

} // namespace tactum
