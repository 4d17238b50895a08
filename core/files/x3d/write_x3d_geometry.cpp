#include "core/files/x3d/write_x3d_geometry.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/files/corner_pool.h"

namespace tactum {
namespace {

template <class Values> void append(std::string& list, const Values& values) {
    for (int i = 0; i < values.size(); ++i) {
        if (!list.empty()) list += i == 0 ? ", " : " ";
        appendNumber(list, values[i]);
    }
}

void append(std::string& list, Index index) {
    if (!list.empty()) list += ' ';
    list += std::to_string(index);
}

/// The lists of one geometry: values in the order in which they are first used.
class Lists {
public:
    Lists(const TriangleSoup& soup, const UvCanvas& canvas) : soup_(soup), canvas_(canvas) {}

    void add(std::size_t face, int corners, bool normals, bool uvs) {
        for (std::size_t k = 0; k < std::size_t(corners); ++k) {
            append(corners_, positionNumber(soup_.triangles[face][k]));
            if (normals) append(normalCorners_, normalNumber(soup_.cornerNormals[3 * face + k]));
            if (uvs) append(uvCorners_, uvNumber(soup_.cornerUvs[3 * face + k]));
        }
        corners_ += " -1";
        if (normals) normalCorners_ += " -1";
        if (uvs) uvCorners_ += " -1";
    }

    void setIndices(XmlElement& geometry) const {
        geometry.setPlain("coordIndex", corners_);
        if (!uvCorners_.empty()) geometry.setPlain("texCoordIndex", uvCorners_);
        if (!normalCorners_.empty()) geometry.setPlain("normalIndex", normalCorners_);
    }

    void writeValues(XmlElement& geometry) const {
        XmlElement(geometry, "Coordinate").setPlain("point", points_);
        if (!uvCorners_.empty()) XmlElement(geometry, "TextureCoordinate").setPlain("point", uvPoints_);
        if (!normalCorners_.empty()) XmlElement(geometry, "Normal").setPlain("vector", vectors_);
    }

private:
    Index positionNumber(Index position) {
        const std::size_t before = positions_.keys().size();
        const Index number = positions_.numberOf({position});
        if (positions_.keys().size() > before) append(points_, soup_.positions[position]);
        return number;
    }
    Index normalNumber(const Eigen::Vector3f& n) {
        const std::size_t before = normals_.keys().size();
        const Index number = normals_.numberOf({bitsOf(n.x()), bitsOf(n.y()), bitsOf(n.z())});
        if (normals_.keys().size() > before) append(vectors_, n);
        return number;
    }
    Index uvNumber(const Eigen::Vector2f& uv) {
        const std::size_t before = uvs_.keys().size();
        const Index number = uvs_.numberOf({bitsOf(uv.x()), bitsOf(uv.y())});
        if (uvs_.keys().size() > before) appendUv(uv);
        return number;
    }
    void appendUv(const Eigen::Vector2f& uv) {
        if (canvas_.low == Eigen::Vector2d(0, 0) && canvas_.size == Eigen::Vector2d(1, 1))
            append(uvPoints_, uv); // as it is, and in fewer digits
        else
            append(uvPoints_, Eigen::Vector2d((uv.cast<double>() - canvas_.low).cwiseQuotient(canvas_.size)));
    }

    const TriangleSoup& soup_;
    const UvCanvas& canvas_;
    CornerPool<1> positions_; ///< of the soup
    CornerPool<3> normals_;
    CornerPool<2> uvs_;
    std::string points_, vectors_, uvPoints_, corners_, normalCorners_, uvCorners_;
};

constexpr std::array<std::string_view, 3> kNodes{"PointSet", "IndexedLineSet", "IndexedFaceSet"};
constexpr std::array<std::string_view, 4> kTouchable{"FRONT_AND_BACK", "FRONT", "BACK",
                                                     "FRONT_AND_BACK"}; // by Sides

void writeOptions(XmlElement& geometry, const SceneObject& object, const Surface& surface) {
    XmlElement(geometry, "HapticsOptions")
        .set("containerField", "options")
        .set("touchableFace", kTouchable[std::size_t(surface.sides)])
        .set("dynamicMode", object.motion ? "ALWAYS" : "TRANSFORM_CHANGED");
}

} // namespace

std::vector<FacesByKind> facesBySurface(const SceneObject& object) {
    std::vector<FacesByKind> faces(object.surfaces.size());
    const TriangleSoup& soup = *object.geometry;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        faces[soup.surfaceOf[i]][std::size_t(cornersOf(soup.triangles[i]) - 1)].push_back(Index(i));
    return faces;
}

void writeGeometry(XmlElement& shape, const SceneObject& object, const Surface& surface, int corners,
                   const std::vector<Index>& faces, const UvCanvas& canvas) {
    const TriangleSoup& soup = *object.geometry;
    const bool isComputed = surface.shading.on && surface.shading.normals == NormalSource::Computed;
    const bool normals = corners == 3 && !soup.cornerNormals.empty() && !isComputed;
    const bool uvs = corners == 3 && !soup.cornerUvs.empty();
    Lists lists(soup, canvas);
    for (const Index face : faces)
        lists.add(face, corners, normals, uvs);
    XmlElement geometry(shape, kNodes[std::size_t(corners - 1)]);
    if (corners == 3) {
        geometry.set("solid", false); // H3D would draw and feel one side alone
        if (!normals) geometry.set("creaseAngle", surface.shading.on ? surface.shading.creaseAngle : 0.0);
    }
    if (corners > 1) lists.setIndices(geometry);
    writeOptions(geometry, object, surface);
    lists.writeValues(geometry);
}

} // namespace tactum
