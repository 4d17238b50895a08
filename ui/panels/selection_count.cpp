#include "ui/panels/selection_count.h"

#include <map>
#include <memory>
#include <vector>

#include "core/geometry/surfaces.h"
#include "core/geometry/triangle_set.h"
#include "ui/base/numbers.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

/// Of one mesh: its triangles where some are selected, else those of some of its surfaces.
struct Share {
    std::shared_ptr<const TriangleSoup> soup;
    std::vector<Index> faces;
    std::vector<char> surfaces; ///< of each whether it is selected
};

std::vector<Share> selectedShares(const Document& document) {
    const auto soupOf = [&](ObjectId id) { return document.scene().find(id)->geometry; };
    if (const FaceSelection& faces = document.selectedFaces(); !faces.empty())
        return {{soupOf(faces.object), faces.faces, {}}};
    std::map<ObjectId, Share> shares;
    for (const SurfaceRef ref : document.selected()) {
        Share& share = shares[ref.object];
        share.soup = soupOf(ref.object);
        share.surfaces.resize(document.scene().find(ref.object)->surfaces.size());
        share.surfaces[ref.surface] = true;
    }
    std::vector<Share> result;
    for (auto& [id, share] : shares)
        result.push_back(std::move(share));
    return result;
}

struct Sum {
    std::size_t triangles = 0;
    double area = 0; ///< m^2
};

Sum sumOf(const std::vector<Share>& shares) {
    Sum sum;
    for (const Share& share : shares) {
        TriangleSet faces = share.faces;
        if (faces.empty())
            for (Index t = 0; t < share.soup->triangles.size(); ++t)
                if (share.surfaces[share.soup->surfaceOf[t]]) faces.push_back(t);
        sum.triangles += faces.size();
        sum.area += areaOf(*share.soup, faces);
    }
    return sum;
}

/// How many surfaces the outliner and the panel say: the row has no room for it.
QString amountText(const Sum& sum) {
    const QString triangles = sum.triangles == 1 ? SelectionCount::tr("1 triangle")
                                                 : SelectionCount::tr("%1 triangles").arg(sum.triangles);
    return triangles + QStringLiteral(", ") + areaText(sum.area);
}

} // namespace

SelectionCount::SelectionCount(Document& document, QWidget* parent) : QLabel(parent), document_(document) {
    setObjectName(QStringLiteral("selection-count"));
    setToolTip(tr("What is selected, and its area"));
    // Later: the document keeps its selection to what there is after it has told of a change.
    connect(&document_, &Document::changed, this, [this](const SceneChange& change) {
        if (change.what == SceneChange::What::Selection || change.touchesShape())
            QMetaObject::invokeMethod(this, &SelectionCount::count, Qt::QueuedConnection);
    });
    connect(&job_, &BackgroundJob::finished, this, [this] {
        if (std::exchange(again_, false)) count();
    });
    count();
}

void SelectionCount::count() {
    if (job_.running()) {
        again_ = true;
        return;
    }
    const auto shares = selectedShares(document_);
    if (shares.empty()) return clear();
    job_.start([this, shares](const Progress&) -> BackgroundJob::Delivery {
        return [this, text = amountText(sumOf(shares))] { setText(text); };
    });
}

} // namespace tactum
