// The animations of a glTF file as rigid motions of its nodes.
#pragma once

#include <optional>
#include <vector>

#include "core/files/gltf/gltf_model.h"
#include "core/files/load_scene.h"
#include "core/motion/motion.h"

namespace tactum {

/// What every node does by itself. Reads the translations and rotations of all animations; of two animations
/// of one node the first one counts, each runs over its own duration, and all of them at once.
class GltfMotions {
public:
    /// What is damaged, because it lies about its accessors or its times do not rise, is left out.
    GltfMotions(const Source& source, const tinygltf::Model& model);

    bool moves(int node) const { return bool(motions_[std::size_t(node)].local); }
    /// The transform of a node to its parent at a time in s.
    Eigen::Affine3d localAt(int node, double t) const;

    /// Where the last moving node of a chain of nodes goes, from the scene's root down to it.
    struct Course {
        Pose rest;                    ///< X_WB at the time 0
        Mat3 stretch;                 ///< what of its ancestors' scale belongs into the vertices
        std::optional<Motion> motion; ///< relative to `rest`; none if it turns out to stand still
        bool bends = false;           ///< the animation also scales or shears it, which is left out
    };
    /// `chain`: nodes from the root down; the last of them moves.
    /// Exact for one moving node under ancestors that do not distort; otherwise the product of the chain's
    /// transforms, sampled a thousand times a second, at most kMaxSamples times.
    Course courseOf(const std::vector<int>& chain) const;

    /// What was left out.
    const std::vector<Finding>& findings() const { return findings_; }

    static constexpr std::size_t kMaxSamples = 1 << 16;

private:
    struct NodeMotion {
        std::optional<Motion> local; ///< absolute, in the frame of the parent
        bool slides = false, turns = false;
    };
    struct Tracks {
        Track<Vec3> translation;
        Track<QuatCoefficients> rotation;
        double duration = 0;
    };

    void readAnimation(int index, std::vector<Tracks>& tracks);
    template <class Value> Track<Value> readTrack(int animation, int sampler) const;
    void note(std::size_t count, std::string_view noun, const std::string& sentence,
              const std::string& remedy);
    Pose rigidAt(int node, double t) const;
    Course exactCourse(int node, const Pose& parent, double scale) const;
    Course sampledCourse(const std::vector<int>& chain) const;
    std::vector<double> sampleTimes(const std::vector<int>& chain, double duration) const;
    Eigen::Affine3d frameAt(const std::vector<int>& chain, double t) const;

    const Source& source_;
    const tinygltf::Model& model_;
    std::vector<NodeMotion> motions_;
    std::vector<Finding> findings_;
    std::size_t scaled_ = 0, weighted_ = 0, doubled_ = 0; ///< channels left out
    std::size_t broken_ = 0;
    std::string firstFault_;
    std::size_t stretched_ = 0; ///< rotations of keys that had to be made unit
};

} // namespace tactum
