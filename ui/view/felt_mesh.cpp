#include "ui/view/felt_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/corner_normals.h"
#include "core/surface/texture_feel.h"
#include "ui/view/display_mesh.h"
#include "ui/view/relief.h"

namespace tactum {

namespace {

// A repeat of a pattern is seen when this many vertices fall on it; of an image, whose details are finer.
constexpr double kPerRepeat = 16, kPerImage = 64;
constexpr int kMaxCuts = 96;

bool isTriangle(const std::array<Index, 3>& t) {
    return t[0] != t[1] && t[1] != t[2];
}

TextureTarget targetOf(FeltValue value) {
    switch (value) {
    case FeltValue::Stiffness:
        return TextureTarget::Stiffness;
    case FeltValue::StaticFriction:
        return TextureTarget::StaticFriction;
    case FeltValue::DynamicFriction:
        return TextureTarget::DynamicFriction;
    case FeltValue::Viscosity:
        return TextureTarget::Viscosity;
    case FeltValue::Damping:
    case FeltValue::Height:
        break;
    }
    return TextureTarget::Height;
}

bool changes(const CompiledLayer& layer, FeltValue value) {
    if (value == FeltValue::Damping) return false; // no layer does
    if (layer.target == targetOf(value)) return true;
    // Dynamic friction never exceeds static.
    return value == FeltValue::DynamicFriction && layer.target == TextureTarget::StaticFriction;
}

bool concerns(const CompiledLayer& layer, const FeltMeshWish& wish) {
    return (wish.value && changes(layer, *wish.value)) ||
           (wish.bumps > 0 && layer.target == TextureTarget::Height);
}

/// m, of vertices that show what the wish asks for.
double wantedSpacing(const TextureStack& stack, const FeltMeshWish& wish) {
    double spacing = 1e9;
    const auto look = [&](const CompiledPattern& pattern) {
        const double perMetre = pattern.repeatsPerMetre.norm() / std::numbers::sqrt2;
        if (!(perMetre > 0)) return;
        const double fine = pattern.source == TextureSource::Noise ? std::exp2(pattern.octaves - 1) : 1;
        const double each = pattern.source == TextureSource::Image ? kPerImage : kPerRepeat * fine;
        spacing = std::min(spacing, 1 / (perMetre * each));
    };
    for (const CompiledLayer& layer : stack.layers) {
        if (!concerns(layer, wish)) continue;
        look(layer.pattern);
        if (layer.mask) look(*layer.mask);
    }
    return spacing;
}

/// Displacement goes along one normal at each place, so that the surface does not open at its creases.
std::vector<Vec3> placeNormals(const TriangleSoup& soup, const CornerNormals& drawn) {
    std::vector<Vec3> normals(soup.positions.size(), Vec3::Zero());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            normals[soup.triangles[f][k]] += drawn[3 * f + k].cast<double>();
    for (Vec3& n : normals)
        n = n.norm() > 1e-9 ? Vec3(n.normalized()) : Vec3(Vec3::UnitZ());
    return normals;
}

struct Range {
    double low = 1e300, high = -1e300;

    void add(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
    double size() const { return std::max(0.0, high - low); }
};

/// How far a number goes over the surface, and how far where what is too fine is left out.
struct Spread {
    Range felt, seen;

    void note(double all, double drawn) {
        felt.add(all);
        seen.add(drawn);
    }
    double lost() const { return felt.size() > 0 ? std::clamp(1 - seen.size() / felt.size(), 0.0, 1.0) : 0; }
};

class Maker {
public:
    Maker(const WorldBody& body, Index surface, const CornerNormals& drawn, const FeltMeshWish& wish)
        : soup_(*body.mesh->soup), material_(body.materials[surface]), drawn_(drawn), wish_(wish),
          stack_(asOneHeight(*stackOf(body, surface))) {
        for (Index f = 0; f < Index(soup_.triangles.size()); ++f)
            if (soup_.surfaceOf[f] == surface && isTriangle(soup_.triangles[f])) faces_.push_back(f);
        chooseCuts();
        if (wish_.bumps > 0) away_ = placeNormals(soup_, drawn_);
    }

    FeltMesh make(const Progress& progress) {
        const std::size_t each = std::size_t(cuts_ + 1) * std::size_t(cuts_ + 2) / 2;
        mesh_.positions.reserve(3 * each * faces_.size());
        mesh_.normals.reserve(3 * each * faces_.size());
        mesh_.triangles.reserve(3 * faces_.size() * std::size_t(cuts_ * cuts_));
        ProgressMeter meter(progress, faces_.size(), std::max<std::size_t>(1, 4096 / each));
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (!meter.goesOn(i)) return {};
            add(faces_[i]);
        }
        if (progress.isCancelled()) return {};
        if (!mesh_.values.empty()) {
            mesh_.low = values_.seen.low;
            mesh_.high = values_.seen.high;
        }
        mesh_.cuts = cuts_;
        mesh_.lost = std::max(values_.lost(), heights_.lost());
        return std::move(mesh_);
    }

private:
    Triangle triangle(Index f) const {
        const auto& t = soup_.triangles[f];
        return {soup_.positions[t[0]], soup_.positions[t[1]], soup_.positions[t[2]]};
    }

    /// So many parts for each edge, the same for all: no triangle of the surface then gapes at another.
    void chooseCuts() {
        double sum = 0, weights = 0; // the edges that most of the area has
        for (Index f : faces_) {
            const Triangle t = triangle(f);
            const double longest = std::max({(t.b - t.a).norm(), (t.c - t.b).norm(), (t.a - t.c).norm()});
            const double area = (t.b - t.a).cross(t.c - t.a).norm();
            sum += area * longest;
            weights += area;
        }
        const double edge = weights > 0 ? sum / weights : 0;
        const double room =
            std::sqrt(double(wish_.mostTriangles) / double(std::max<std::size_t>(1, faces_.size())));
        const double wanted = std::ceil(edge / wantedSpacing(stack_, wish_));
        cuts_ = int(std::clamp(std::min(wanted, std::floor(room)), 1.0, double(kMaxCuts)));
        spacing_ = edge / cuts_;
    }

    void add(Index f) {
        const Triangle t = triangle(f);
        const Vec3 facet = (t.b - t.a).cross(t.c - t.a);
        if (!(facet.norm() > 0)) return;
        CornerUvs uvs{};
        Eigen::Matrix<double, 2, 3> uvGradient = Eigen::Matrix<double, 2, 3>::Zero();
        if (!soup_.cornerUvs.empty()) {
            for (std::size_t k = 0; k < 3; ++k)
                uvs[k] = soup_.cornerUvs[3 * f + k].cast<double>();
            uvGradient = uvGradientOf(t, uvs);
        }
        const int first = int(mesh_.positions.size() / 3);
        eachCut(cuts_, [&](const Vec3& w) { vertex(f, t, facet.normalized(), w, uvs, uvGradient); });
        mesh_.faces.push_back(f);
        const auto row = [&](int i) { return first + i * (cuts_ + 1) - i * (i - 1) / 2; };
        for (int i = 0; i < cuts_; ++i)
            for (int j = 0; j < cuts_ - i; ++j) {
                const int a = row(i) + j, b = row(i + 1) + j;
                mesh_.triangles.insert(mesh_.triangles.end(), {a, b, a + 1});
                if (j + 1 < cuts_ - i) mesh_.triangles.insert(mesh_.triangles.end(), {b, b + 1, a + 1});
            }
    }

    void vertex(Index f, const Triangle& t, const Vec3& facet, const Vec3& w, const CornerUvs& uvs,
                const Eigen::Matrix<double, 2, 3>& uvGradient) {
        TexturePoint point;
        point.position = w[0] * t.a + w[1] * t.b + w[2] * t.c;
        Vec3 normal = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            normal += w[Eigen::Index(k)] * drawn_[3 * f + k].cast<double>();
            point.uv += w[Eigen::Index(k)] * uvs[k];
        }
        point.normal = normal.norm() > 1e-9 ? Vec3(normal.normalized()) : facet;
        point.uvGradient = uvGradient;
        const TextureFeel felt = feel(stack_, point, 0), seen = feel(stack_, point, 2 * spacing_);
        if (wish_.value) {
            mesh_.values.push_back(float(valueOf(seen)));
            values_.note(valueOf(felt), mesh_.values.back());
        }
        if (wish_.bumps == 0) return put(point.position, point.normal);
        heights_.note(felt.height, seen.height);
        Vec3 away = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            away += w[Eigen::Index(k)] * away_[soup_.triangles[f][k]];
        put(point.position + wish_.bumps * seen.height * away.normalized(),
            bumpedNormal(point.normal, wish_.bumps * seen.slope));
    }

    double valueOf(const TextureFeel& felt) const {
        return *wish_.value == FeltValue::Height ? felt.height
                                                 : plainValue(modulated(material_, felt), *wish_.value);
    }
    void put(const Vec3& position, const Vec3& normal) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            mesh_.positions.push_back(float(position[k]));
            mesh_.normals.push_back(float(normal[k]));
        }
    }

    const TriangleSoup& soup_;
    const Material& material_;
    const CornerNormals& drawn_;
    FeltMeshWish wish_;
    TextureStack stack_;
    std::vector<Index> faces_;
    std::vector<Vec3> away_; ///< of each place
    int cuts_ = 1;
    double spacing_ = 0; ///< m, between vertices
    FeltMesh mesh_;
    Spread values_, heights_;
};

} // namespace

CornerNormals drawnNormalsOf(const TriangleSoup& soup, const Progress& progress) {
    if (!soup.cornerNormals.empty()) return soup.cornerNormals;
    auto normals = cornerNormalsOf(soup, kDrawnCrease, progress);
    return normals ? std::move(*normals) : CornerNormals{};
}

double plainValue(const Material& material, FeltValue value) {
    switch (value) {
    case FeltValue::Stiffness:
        return material.stiffness;
    case FeltValue::Damping:
        return material.damping;
    case FeltValue::StaticFriction:
        return material.staticFriction;
    case FeltValue::DynamicFriction:
        return material.dynamicFriction;
    case FeltValue::Viscosity:
        return material.viscosity;
    case FeltValue::Height:
        break;
    }
    return 0;
}

bool varies(const WorldBody& body, Index surface, const FeltMeshWish& wish) {
    const TextureStack* stack = stackOf(body, surface);
    return stack && std::ranges::any_of(stack->layers,
                                        [&](const CompiledLayer& layer) { return concerns(layer, wish); });
}

FeltMesh feltMesh(const WorldBody& body, Index surface, const CornerNormals& drawn, const FeltMeshWish& wish,
                  const Progress& progress) {
    if (drawn.size() != 3 * body.mesh->soup->triangles.size()) return {};
    return Maker(body, surface, drawn, wish).make(progress);
}

} // namespace tactum
