// Wavefront OBJ: an `o` for each object, a `g` and a `usemtl` for each surface, colours in the library.
#include "core/base/numbers.h"
#include "core/files/corner_pool.h"
#include "core/files/mesh/write_mesh.h"
#include "core/files/unique_names.h"

namespace tactum {
namespace {

/// The rest of a line: a backslash at its end would join it with the next one.
std::string lineText(std::string_view name) {
    std::string text = printable(trimmed(name), 200);
    if (text.ends_with('\\')) text.back() = '/';
    return text.empty() ? "surface" : text;
}

template <class Values> void appendLine(std::string& out, std::string_view word, const Values& values) {
    out += word;
    for (int i = 0; i < values.size(); ++i) {
        out += ' ';
        appendNumber(out, values[i]);
    }
    out += '\n';
}

class ObjWriter {
public:
    explicit ObjWriter(std::string_view stem) : stem_(stem), library_(sideFileStem(stem) + ".mtl") {
        obj_ = "mtllib " + library_ + "\n";
    }

    void add(const SceneObject& object) {
        obj_ += "o " + objects_.take(lineText(object.name)) + "\n";
        for (const Vec3& p : object.geometry->positions)
            appendLine(obj_, "v", object.pose.apply(p));
        addMaterials(object);
        UniqueNames groups;
        groups_.clear();
        for (const Surface& surface : object.surfaces)
            groups_.push_back(groups.take(lineText(surface.name)));
        addFaces(object);
        firstPosition_ += object.geometry->positions.size();
    }

    std::vector<MeshFile> files() && {
        return {{stem_ + ".obj", std::move(obj_)}, {library_, std::move(mtl_)}};
    }

private:
    void addMaterials(const SceneObject& object) {
        materialOf_.clear();
        for (const Surface& surface : object.surfaces) {
            materialOf_.push_back(materials_.take(plainName(surface.name)));
            mtl_ += "newmtl " + materialOf_.back() + "\n";
            appendLine(mtl_, "Kd", surface.colour);
        }
    }

    void addFaces(const SceneObject& object) {
        const TriangleSoup& soup = *object.geometry;
        Index surface = ~Index{0};
        for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
            if (soup.surfaceOf[i] != surface) {
                surface = soup.surfaceOf[i];
                obj_ += "g " + groups_[surface] + "\nusemtl " + materialOf_[surface] + "\n";
            }
            addFace(object, i);
        }
    }

    void addFace(const SceneObject& object, std::size_t i) {
        const TriangleSoup& soup = *object.geometry;
        const int corners = cornersOf(soup.triangles[i]);
        std::string face = corners == 3 ? "f" : corners == 2 ? "l" : "p";
        for (std::size_t k = 0; k < std::size_t(corners); ++k) {
            face += " " + std::to_string(firstPosition_ + soup.triangles[i][k] + 1);
            if (corners < 3) continue;
            const std::string uv = soup.cornerUvs.empty() ? "" : uvNumber(soup.cornerUvs[3 * i + k]);
            if (!soup.cornerNormals.empty())
                face += "/" + uv + "/" + normalNumber(object.pose, soup.cornerNormals[3 * i + k]);
            else if (!uv.empty())
                face += "/" + uv;
        }
        obj_ += face + "\n";
    }

    /// Writes it where it is first needed.
    std::string uvNumber(const Eigen::Vector2f& uv) {
        const std::size_t before = uvs_.keys().size();
        const Index number = uvs_.numberOf({bitsOf(uv.x()), bitsOf(uv.y())});
        if (uvs_.keys().size() > before) appendLine(obj_, "vt", uv);
        return std::to_string(number + 1);
    }
    std::string normalNumber(const Pose& pose, const Eigen::Vector3f& n_B) {
        const Eigen::Vector3f n = pose.rotate(n_B.cast<double>()).cast<float>();
        const std::size_t before = normals_.keys().size();
        const Index number = normals_.numberOf({bitsOf(n.x()), bitsOf(n.y()), bitsOf(n.z())});
        if (normals_.keys().size() > before) appendLine(obj_, "vn", n);
        return std::to_string(number + 1);
    }

    std::string stem_, library_, obj_, mtl_;
    std::size_t firstPosition_ = 0;
    UniqueNames objects_, materials_;
    std::vector<std::string> groups_, materialOf_; ///< by surface of the object
    CornerPool<2> uvs_;
    CornerPool<3> normals_;
};

} // namespace

std::vector<MeshFile> asObj(const Scene& scene, std::string_view stem) {
    ObjWriter writer(stem);
    for (const SceneObject& object : scene.objects)
        writer.add(object);
    return std::move(writer).files();
}

} // namespace tactum
