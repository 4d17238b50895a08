// What single objects of KHR_physics_rigid_bodies and KHR_implicit_shapes say, as values; who they belong to
// is for gltf_physics.cpp. What is no such value is said and counts as not given. Thread: any but real time.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/dynamics/collider.h"
#include "core/dynamics/joint.h"
#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/scene/findings.h"

namespace tactum {

inline std::optional<double> numberIn(const Json& holder, const char* key) {
    const Json* found = member(holder, key);
    if (!found || !found->is_number()) return std::nullopt;
    const double value = found->get<double>();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

template <int N> std::optional<Eigen::Matrix<double, N, 1>> vectorOf(const Json& list) {
    if (!list.is_array() || list.size() != N) return std::nullopt;
    Eigen::Matrix<double, N, 1> v;
    for (int i = 0; i < N; ++i) {
        const Json& entry = list[std::size_t(i)];
        if (!entry.is_number() || !std::isfinite(entry.get<double>())) return std::nullopt;
        v[i] = entry.get<double>();
    }
    return v;
}

template <int N> std::optional<Eigen::Matrix<double, N, 1>> vectorIn(const Json& holder, const char* key) {
    const Json* found = member(holder, key);
    return found ? vectorOf<N>(*found) : std::nullopt;
}

inline std::string textIn(const Json& holder, const char* key) {
    const Json* found = member(holder, key);
    return found && found->is_string() ? found->get<std::string>() : std::string();
}

/// The members of one object of a file, each said in the findings that is there and no value of its kind.
class Values {
public:
    /// `of`: whose they are, and `what`, for "has a material whose restitution is not ...".
    Values(const Json& json, std::string of, std::string what, std::vector<Finding>& findings)
        : json_(json), of_(std::move(of)), what_(std::move(what)), findings_(findings) {}

    double number(const char* key, double otherwise) const {
        return inRange(key, otherwise, -kMostNumber, kMostNumber, "a number up to 1e15");
    }
    double positive(const char* key, double otherwise) const {
        return inRange(key, otherwise, 0, kMostNumber, "from 0 to 1e15");
    }
    double ratio(const char* key, double otherwise) const {
        return inRange(key, otherwise, 0, 1, "from 0 to 1");
    }
    /// Which of the words: its index, or the first.
    std::size_t oneOf(const char* key, std::initializer_list<const char*> words) const;
    bool flag(const char* key) const;          ///< false where it is not given
    const Json* list(const char* key) const;   ///< or null
    const Json* object(const char* key) const; ///< or null
    /// A list of objects; that there is something else in it is said.
    const Json* listOfObjects(const char* key) const;
    void warn(const std::string& sentence, const std::string& remedy) const;

private:
    const Json* ofKind(const char* key, bool (Json::*is)() const noexcept, const char* words) const;
    static constexpr double kMostNumber = 1e15; ///< products of two of them, and of a step, are numbers too
    double inRange(const char* key, double otherwise, double least, double most, const char* words) const;

    const Json& json_;
    std::string of_, what_;
    std::vector<Finding>& findings_;
};

/// Stretched along its axes; nothing for one that is no shape, or that is disabled by a scale of 0.
std::optional<ColliderShape> implicitShapeOf(const Json& json, const Mat3& stretch, const std::string& of,
                                             std::vector<Finding>& findings);
/// `of`: whose it is.
TouchMaterial touchMaterialOf(const Json& json, const std::string& of, std::vector<Finding>& findings);
CollisionFilter collisionFilterOf(const Json& json, const std::string& of, std::vector<Finding>& findings);

// Of a joint; what is left out is said in `findings`.
void addLimits(const Json& description, Joint& joint, std::vector<Finding>& findings);
/// `from`: an array of drives, of the standard or of our detents, which have a spacing.
void addDrives(const Json& from, const char* array, Joint& joint, std::vector<Finding>& findings);
/// Of our own extension: the standard has none.
void addFrictions(const Json& ours, Joint& joint, std::vector<Finding>& findings);
/// Of our own extension as well. Whether it is a curve.
bool addPath(const Json& path, Joint& joint, std::vector<Finding>& findings);

} // namespace tactum
