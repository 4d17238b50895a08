#include "ui/view/paint_layer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include "ui/view/colour_map.h"
#include "ui/view/model_mapper.h"
#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

// The model stays to be seen where nothing is painted, and a quarter of the range is as opaque as all of it.
constexpr double kMinOpacity = 0.06, kMaxOpacity = 0.88, kOpaqueFrom = 0.25;
constexpr int kLargestPicture = 1024; // texels of a side that are drawn

using Rgba = std::array<unsigned char, 4>;

const std::array<Rgba, 256>& table() {
    static const std::array<Rgba, 256> colours = [] {
        std::array<Rgba, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double part = double(i) / 255;
            const QColor c = mapColour(part);
            const double opacity =
                kMinOpacity + std::min(1.0, part / kOpaqueFrom) * (kMaxOpacity - kMinOpacity);
            made[i] = {(unsigned char)(c.red()), (unsigned char)(c.green()), (unsigned char)(c.blue()),
                       (unsigned char)(std::lround(255 * opacity))};
        }
        return made;
    }();
    return colours;
}

/// One corner each, for texture coordinates that differ from triangle to triangle.
void addCorners(vtkPolyData& data, const TriangleSoup& soup, Index surface, const TexelMap& map) {
    std::vector<float> places, coordinates;
    std::vector<int> corners;
    for (Index f = 0; f < Index(soup.triangles.size()); ++f) {
        if (soup.surfaceOf[f] != surface) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = soup.positions[soup.triangles[f][k]];
            const Eigen::Vector2d texel =
                map.perUv * soup.cornerUvs[3 * std::size_t(f) + k].cast<double>() + map.shift;
            corners.push_back(int(places.size() / 3));
            places.insert(places.end(), {float(p.x()), float(p.y()), float(p.z())});
            coordinates.insert(coordinates.end(),
                               {float(texel.x() / map.width), float(texel.y() / map.height)});
        }
    }
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(places));
    vtkNew<vtkFloatArray> uvs;
    uvs->SetNumberOfComponents(2);
    uvs->SetNumberOfTuples(vtkIdType(coordinates.size() / 2));
    std::ranges::copy(coordinates, uvs->GetPointer(0));
    data.SetPoints(points);
    data.SetPolys(cellArray(corners, 3));
    data.GetPointData()->SetTCoords(uvs);
}

vtkSmartPointer<vtkCellArray> cellsOf(const TriangleSoup& soup, Index surface) {
    std::vector<int> corners;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
        if (soup.surfaceOf[f] == surface)
            for (const Index corner : soup.triangles[f])
                corners.push_back(int(corner));
    return cellArray(corners, 3);
}

/// On the vertices of a surface that is drawn in another shape.
void setShape(vtkPolyData& data, const FeltMesh& shape) {
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(shape.positions));
    data.SetPoints(points);
    data.SetPolys(cellArray(shape.triangles, 3));
}

/// Calls f(triangle, weights of its corners) for each vertex of a shape.
template <class F> void eachVertex(const FeltMesh& shape, F f) {
    for (const Index face : shape.faces)
        eachCut(shape.cuts, [&](const Vec3& weights) { f(face, weights); });
}

vtkNew<vtkFloatArray> texelsOf(const FeltMesh& shape, const TriangleSoup& soup, const TexelMap& map) {
    vtkNew<vtkFloatArray> uvs;
    uvs->SetNumberOfComponents(2);
    eachVertex(shape, [&](Index face, const Vec3& weights) {
        Eigen::Vector2d uv = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            uv += weights[Eigen::Index(k)] * soup.cornerUvs[3 * std::size_t(face) + k].cast<double>();
        const Eigen::Vector2d texel = map.perUv * uv + map.shift;
        uvs->InsertNextTuple2(texel.x() / map.width, texel.y() / map.height);
    });
    return uvs;
}

} // namespace

struct PaintLayer::Part {
    vtkNew<vtkPolyData> data;
    vtkNew<ModelMapper> mapper;
    vtkNew<vtkActor> actor;
    vtkNew<vtkUnsignedCharArray> colours; ///< of every position
    vtkNew<vtkImageData> picture;
    vtkNew<vtkTexture> texture;
    std::shared_ptr<const FeltMesh> shape; ///< null: that of the soup

    Part() {
        mapper->SetInputData(data);
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -1);
        actor->SetMapper(mapper);
        actor->PickableOff();
        actor->ForceTranslucentOn();
        useNoLight(*actor);
        texture->SetInputData(picture);
        texture->RepeatOn();
        texture->InterpolateOn();
    }

    void colour(const PaintedValues* values, const TriangleSoup& soup) {
        const std::size_t count = shape ? shape->positions.size() / 3 : soup.positions.size();
        colours->SetNumberOfComponents(4);
        colours->SetNumberOfTuples(vtkIdType(count));
        unsigned char* to = colours->GetPointer(0);
        const auto valueOf = [&](Index i) { return values && i < values->size() ? (*values)[i] : 0; };
        const auto put = [&](double value) {
            to = std::ranges::copy(table()[std::size_t(std::lround(255 * value))], to).out;
        };
        if (shape)
            eachVertex(*shape, [&](Index face, const Vec3& w) {
                const auto& corners = soup.triangles[face];
                put(w[0] * valueOf(corners[0]) + w[1] * valueOf(corners[1]) + w[2] * valueOf(corners[2]));
            });
        else
            for (Index i = 0; i < Index(count); ++i)
                put(valueOf(i));
        colours->Modified();
        data->GetPointData()->SetScalars(colours);
        data->Modified();
    }

    /// Of a large image the level that is small enough.
    void colour(const TextureImage& image) {
        int at = 0;
        while (at + 1 < image.levelCount() &&
               std::max(image.level(at).width, image.level(at).height) > kLargestPicture)
            ++at;
        const TextureImage::Level& level = image.level(at);
        picture->SetDimensions(level.width, level.height, 1);
        picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
        auto* to = static_cast<unsigned char*>(picture->GetScalarPointer());
        for (int y = 0; y < level.height; ++y) {
            for (int x = 0; x < level.width; ++x) {
                const double value = std::clamp(image.texel(level, x, y), 0.0, 1.0);
                to = std::ranges::copy(table()[std::size_t(255 * value)], to).out;
            }
        }
        picture->Modified();
        texture->Modified();
    }
};

PaintLayer::PaintLayer(vtkRenderer& renderer) : renderer_(renderer) {}

PaintLayer::~PaintLayer() {
    for (const auto& part : parts_)
        renderer_.RemoveActor(part->actor);
}

void PaintLayer::show(const PaintedPicture& picture) {
    const bool sameSoup = picture.soup && picture.soup == picture_.soup;
    if (picture.soup && !sameSoup) {
        points_->SetDataTypeToFloat();
        points_->SetNumberOfPoints(vtkIdType(picture.soup->positions.size()));
        for (std::size_t i = 0; i < picture.soup->positions.size(); ++i)
            points_->SetPoint(vtkIdType(i), picture.soup->positions[i].data());
        points_->Modified();
    }
    const std::size_t before = picture_.parts.size();
    for (; parts_.size() > picture.parts.size(); parts_.pop_back())
        renderer_.RemoveActor(parts_.back()->actor);
    for (; parts_.size() < picture.parts.size(); renderer_.AddActor(parts_.back()->actor))
        parts_.push_back(std::make_unique<Part>());
    const PaintedPicture old = std::exchange(picture_, picture);
    for (std::size_t i = 0; i < picture.parts.size(); ++i) {
        const PaintedPart &now = picture.parts[i], *was = i < before ? &old.parts[i] : nullptr;
        if (sameSoup && was && *was == now) continue;
        const bool sameShape = sameSoup && was && was->surface == now.surface && !was->image == !now.image &&
                               was->map == now.map;
        if (!sameShape) parts_[i]->shape.reset(); // it was another surface's
        showPart(i, now, sameShape);
    }
}

void PaintLayer::showPart(std::size_t i, const PaintedPart& part, bool sameShape) {
    Part& drawn = *parts_[i];
    if (!sameShape) {
        drawn.data->Initialize();
        drawn.actor->SetTexture(part.image ? drawn.texture.Get() : nullptr);
        if (drawn.shape) {
            setShape(*drawn.data, *drawn.shape);
            if (part.image)
                drawn.data->GetPointData()->SetTCoords(texelsOf(*drawn.shape, *picture_.soup, part.map));
        } else if (part.image) {
            addCorners(*drawn.data, *picture_.soup, part.surface, part.map);
        } else {
            drawn.data->SetPoints(points_);
            drawn.data->SetPolys(cellsOf(*picture_.soup, part.surface));
        }
    }
    if (part.image)
        drawn.colour(*part.image);
    else
        drawn.colour(part.values.get(), *picture_.soup);
}

void PaintLayer::lieOn(const std::function<std::shared_ptr<const FeltMesh>(Index)>& shapeOf) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        auto shape = shapeOf(picture_.parts[i].surface);
        if (shape == parts_[i]->shape) continue;
        parts_[i]->shape = std::move(shape);
        showPart(i, picture_.parts[i], false);
    }
}

void PaintLayer::place(vtkMatrix4x4* matrix) {
    for (const auto& part : parts_) {
        part->actor->SetVisibility(matrix != nullptr);
        part->actor->SetUserMatrix(matrix);
    }
}

} // namespace tactum
