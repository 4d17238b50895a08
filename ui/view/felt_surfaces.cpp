#include "ui/view/felt_surfaces.h"

#include <algorithm>
#include <cmath>

#include <QObject>

#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include "ui/view/colour_map.h"
#include "ui/view/poly_arrays.h"

namespace tactum {

namespace {

/// Of all textured surfaces together: what is uploaded within a frame.
constexpr std::size_t kMaxTriangles = 500'000;
/// More of the height than this left out is worth a word.
constexpr double kNoticed = 0.1;

bool asksNothing(const FeltMeshWish& wish) {
    return !wish.value && wish.bumps == 0;
}

} // namespace

void FeltSurfaces::set(std::shared_ptr<const World> world, const FeltOptions& options) {
    world_ = std::move(world);
    wish_ = {.value = options.map, .bumps = options.bumps};
    relief_ = options.relief;
    work_.forget();
    if (!world_ || asksNothing(wish_)) {
        made_ = {};
        return dress();
    }
    std::size_t textured = 0;
    for (const WorldBody& body : world_->bodies)
        for (Index s = 0; s < Index(body.materials.size()); ++s)
            textured += varies(body, s, wish_);
    if (textured == 0) {
        made_.surfaces.clear();
        made_.wish = wish_;
        return dress();
    }
    wish_.mostTriangles = kMaxTriangles / textured;
    dress(); // what takes no time
    Result known;
    known.normals = made_.normals;
    work_.start([world = world_, wish = wish_, known = std::move(known)](const Progress& progress) {
        return make(*world, wish, known, progress);
    });
}

FeltSurfaces::Result FeltSurfaces::make(const World& world, const FeltMeshWish& wish, Result known,
                                        const Progress& progress) {
    Result result;
    result.wish = wish;
    for (const WorldBody& body : world.bodies)
        for (Index s = 0; s < Index(body.materials.size()); ++s) {
            if (!varies(body, s, wish) || progress.isCancelled()) continue;
            auto& normals = result.normals[body.mesh->soup.get()];
            if (!normals) normals = known.normals[body.mesh->soup.get()];
            if (!normals)
                normals = std::make_shared<const CornerNormals>(drawnNormalsOf(*body.mesh->soup, progress));
            Made made;
            made.object = body.object;
            made.soup = body.mesh->soup;
            made.surface = s;
            made.mesh = std::make_shared<const FeltMesh>(feltMesh(body, s, *normals, wish, progress));
            result.surfaces.push_back(std::move(made));
        }
    return result;
}

bool FeltSurfaces::takeFinished() {
    auto made = work_.take();
    if (!made) return false;
    made_ = std::move(*made);
    dress();
    return true;
}

std::shared_ptr<const FeltMesh> FeltSurfaces::shapeOf(ObjectId object, const TriangleSoup* soup,
                                                      Index surface) {
    if (!world_ || asksNothing(wish_)) return nullptr;
    for (const WorldBody& body : world_->bodies)
        if (body.object == object && body.mesh->soup.get() == soup) {
            const Made* made = madeOf(body, surface);
            return made ? made->mesh : nullptr;
        }
    return nullptr;
}

FeltSurfaces::Made* FeltSurfaces::madeOf(const WorldBody& body, Index surface) {
    if (made_.wish.value != wish_.value || !varies(body, surface, wish_)) return nullptr;
    const auto found = std::ranges::find_if(made_.surfaces, [&](const Made& made) {
        return made.object == body.object && made.surface == surface && made.soup == body.mesh->soup;
    });
    return found != made_.surfaces.end() && !found->mesh->positions.empty() ? &*found : nullptr;
}

/// Over all surfaces, those that are still being sampled at what they are without their layers.
MapRange FeltSurfaces::rangeNow(FeltValue value) {
    double low = 1e300, high = -1e300;
    for (const WorldBody& body : world_->bodies)
        for (Index s = 0; s < Index(body.materials.size()); ++s) {
            if (!isFelt(body, s)) continue;
            const Made* made = varies(body, s, {.value = value}) ? madeOf(body, s) : nullptr;
            const double plain = plainValue(body.materials[s], value);
            low = std::min(low, made ? made->mesh->low : plain);
            high = std::max(high, made ? made->mesh->high : plain);
        }
    if (low > high) low = high = 0; // nothing is felt
    return rangeOf(low, high, 1 / wordsOf(value).factor);
}

void FeltSurfaces::dress() {
    if (!world_ || (!relief_ && asksNothing(wish_))) return model_.setDresses({});
    std::erase_if(reliefs_, [](const auto& known) { return known.first.use_count() == 1; });
    if (wish_.value) range_ = rangeNow(*wish_.value);
    std::map<ObjectId, std::vector<SurfaceDress>> dresses;
    for (const WorldBody& body : world_->bodies)
        for (Index s = 0; s < Index(body.materials.size()); ++s) {
            SurfaceDress dress;
            Made* made = madeOf(body, s);
            if (made) dress.mesh = drawn(*made);
            if (wish_.value && !made)
                dress.colour = mapColour(range_.part(plainValue(body.materials[s], *wish_.value)));
            if (!wish_.value && !made) dress.relief = relief(body, s);
            dresses[body.object].push_back(std::move(dress));
        }
    model_.setDresses(std::move(dresses));
}

namespace {

/// Triangles of a painted model: what is painted is given to the shader at every corner, anew with each dab.
constexpr std::size_t kMostPainted = 300'000;

bool isPainted(const Relief& relief) {
    return std::ranges::any_of(relief.stack->layers, [](const CompiledLayer& layer) {
        return layer.pattern.source == TextureSource::Painted ||
               (layer.mask && layer.mask->source == TextureSource::Painted);
    });
}

} // namespace

std::shared_ptr<const Relief> FeltSurfaces::relief(const WorldBody& body, Index surface) {
    if (!relief_ || !stackOf(body, surface)) return nullptr;
    auto& known = reliefs_[body.textures[surface]];
    if (!known || known->smallestFeature != smallestFeature_)
        known = reliefOf(body.textures[surface], smallestFeature_);
    return known && isPainted(*known) && known->stack->soup->triangles.size() > kMostPainted ? nullptr
                                                                                             : known;
}

void FeltSurfaces::setPixel(double metres) {
    const double octave = std::exp2(std::round(std::log2(metres)));
    if (octave == smallestFeature_ || !std::isfinite(octave)) return;
    smallestFeature_ = octave;
    if (relief_) dress();
}

/// Made anew only where its colours change.
vtkPolyData* FeltSurfaces::drawn(Made& made) const {
    if (!made.drawn || (made_.wish.value && made.range != range_)) {
        made.drawn = polyData(*made.mesh);
        made.range = range_;
    }
    return made.drawn;
}

vtkSmartPointer<vtkPolyData> FeltSurfaces::polyData(const FeltMesh& mesh) const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(mesh.positions));
    data->SetPoints(points);
    data->GetPointData()->SetNormals(vectorArray(mesh.normals));
    data->SetPolys(cellArray(mesh.triangles, 3));
    if (mesh.values.empty()) return data;
    // In linear light, as all colours that are lit.
    std::array<std::array<unsigned char, 3>, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const QColor c = mapColour(double(i) / 255);
        const auto linear = [](double x) { return (unsigned char)(std::lround(255 * std::pow(x, 2.2))); };
        table[i] = {linear(c.redF()), linear(c.greenF()), linear(c.blueF())};
    }
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(vtkIdType(mesh.values.size()));
    unsigned char* to = colours->GetPointer(0);
    for (float value : mesh.values) {
        const auto& c =
            table[std::size_t(std::lround(255 * std::clamp(range_.part(double(value)), 0.0, 1.0)))];
        to = std::copy(c.begin(), c.end(), to);
    }
    data->GetPointData()->SetScalars(colours);
    return data;
}

QString FeltSurfaces::legend() const {
    if (!world_ || asksNothing(wish_)) return {};
    QStringList parts;
    double lost = 0;
    for (const Made& made : made_.surfaces)
        lost = std::max(lost, made.mesh->lost);
    if (wish_.bumps > 0) {
        if (!pending() && made_.surfaces.empty())
            parts << QObject::tr("Bumps: no surface here has a height layer");
        else
            parts << (wish_.bumps == 1
                          ? QObject::tr("Bumps as high as they are felt")
                          : QObject::tr("Bumps drawn %1 times as high as they are felt").arg(wish_.bumps));
    }
    if (pending())
        parts << QObject::tr("being sampled");
    else if (lost > kNoticed)
        parts << QObject::tr("too fine for this mesh and left out: %1 %").arg(std::lround(100 * lost));
    return parts.join(QStringLiteral("; "));
}

} // namespace tactum
