#include "core/files/gltf/gltf_motion.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/readers.h"
#include "core/motion/motion_build.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;

constexpr double kSampleStep = 1e-3; // s: the servo's own
constexpr double kRigid = 1e-5;      // of single-precision transforms

std::string nameOf(int animation) {
    return "animations[" + std::to_string(animation) + "] ";
}

/// Nothing for a word that glTF does not know.
std::optional<Interpolation> interpolationOf(const std::string& name) {
    if (name == "STEP") return Interpolation::Step;
    if (name == "LINEAR") return Interpolation::Linear;
    return name == "CUBICSPLINE" ? std::optional(Interpolation::CubicSpline) : std::nullopt;
}

/// A uniform scale and rotation, no mirror: the scale; otherwise nothing.
std::optional<double> uniformScale(const Mat3& a) {
    const double volume = a.determinant();
    if (!(volume > 0)) return std::nullopt;
    const double scale = std::cbrt(volume);
    const Mat3 square = a.transpose() * a / (scale * scale);
    return square.isIdentity(kRigid) ? std::optional(scale) : std::nullopt;
}

/// The same track relative to its start: every vector turned and scaled, values less the first.
Track<Vec3> relative(Track<Vec3> track, const Vec3& start, const Quat& turn, double scale) {
    for (Vec3& value : track.values)
        value = scale * (turn * (value - start));
    for (std::vector<Vec3>* slopes : {&track.arriving, &track.leaving})
        for (Vec3& slope : *slopes)
            slope = scale * (turn * slope);
    return track;
}

Track<QuatCoefficients> relative(Track<QuatCoefficients> track, const Quat& turn) {
    for (std::vector<QuatCoefficients>* all : {&track.values, &track.arriving, &track.leaving})
        for (QuatCoefficients& q : *all)
            q = (turn * Quat(q)).coeffs(); // linear in the coefficients: right for slopes too
    return track;
}

bool standsStill(const Motion& motion) {
    const auto none = [](const auto& slopes) {
        return std::ranges::all_of(slopes, [](const auto& slope) { return slope.norm() == 0; });
    };
    const auto equal = [&none](const auto& track) {
        return none(track.leaving) && none(track.arriving) &&
               std::ranges::all_of(track.values,
                                   [&](const auto& value) { return value == track.values.front(); });
    };
    return equal(motion.translation) && equal(motion.rotation);
}

} // namespace

GltfMotions::GltfMotions(const Source& source, const tinygltf::Model& model)
    : source_(source), model_(model), motions_(model.nodes.size()) {
    std::vector<Tracks> tracks(model.nodes.size());
    for (int i = 0; i < int(model.animations.size()); ++i)
        readAnimation(i, tracks);
    for (std::size_t node = 0; node < tracks.size(); ++node) {
        Tracks& found = tracks[node];
        NodeMotion& motion = motions_[node];
        motion.slides = !found.translation.times.empty();
        motion.turns = !found.rotation.times.empty();
        if (motion.slides || motion.turns)
            motion.local =
                makeMotion(std::move(found.translation), std::move(found.rotation), found.duration);
    }
    const std::string_view file = source_.name(), first = firstFault_;
    const std::size_t from = first.starts_with(file) ? file.size() + 2 : 0; // "file: what; remedy"
    note(broken_, "damaged channel", "left out: " + firstFault_.substr(from, first.find(';') - from),
         "what it moves stands still; export the animation again");
    note(scaled_, "channel", "that animates a scale", "left out; only rigid motion is felt");
    note(weighted_, "channel", "that animates morph targets", "left out; only rigid motion is felt");
    note(doubled_, "channel", "that animates what another one animates already",
         "left out; export one animation");
    note(stretched_, "key", "with a rotation that is not of unit length",
         "brought to unit length; re-export the file");
}

void GltfMotions::note(std::size_t count, std::string_view noun, const std::string& sentence,
                       const std::string& remedy) {
    if (count > 0)
        findings_.push_back(
            {Finding::Severity::Warning, "", "animation: " + counted(count, noun) + " " + sentence, remedy});
}

void GltfMotions::readAnimation(int index, std::vector<Tracks>& tracks) {
    const tinygltf::Animation& animation = model_.animations[std::size_t(index)];
    double duration = 0;
    std::vector<Tracks*> animated;
    const auto take = [&](auto& track, Tracks& of, int sampler) {
        if (!track.times.empty()) return void(++doubled_);
        try {
            track = readTrack<typename std::decay_t<decltype(track.values)>::value_type>(index, sampler);
        } catch (const ReadFault& fault) { // the shape is as it should be
            if (++broken_ == 1) firstFault_ = fault.error.text;
        }
        if (track.times.empty()) return;
        if constexpr (std::is_same_v<decltype(track), Track<QuatCoefficients>&>)
            stretched_ += std::size_t(std::ranges::count_if(track.values, needsUnitLength));
        duration = std::max(duration, track.times.back());
        animated.push_back(&of);
    };
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
        if (channel.target_node < 0) continue; // glTF: to be ignored
        if (std::size_t(channel.target_node) >= tracks.size()) {
            if (++broken_ == 1) firstFault_ = nameOf(index) + "moves a node that is not there";
            continue;
        }
        Tracks& node = tracks[std::size_t(channel.target_node)];
        if (channel.target_path == "translation") take(node.translation, node, channel.sampler);
        if (channel.target_path == "rotation") take(node.rotation, node, channel.sampler);
        scaled_ += channel.target_path == "scale";
        weighted_ += channel.target_path == "weights";
    }
    for (Tracks* node : animated)
        node->duration = std::max(node->duration, duration);
}

template <class Value> Track<Value> GltfMotions::readTrack(int animation, int samplerIndex) const {
    constexpr int kSize = Value::RowsAtCompileTime;
    const auto fail = [&](const std::string& what) {
        source_.fail(nameOf(animation) + what + "; re-export the file");
    };
    const auto& samplers = model_.animations[std::size_t(animation)].samplers;
    if (samplerIndex < 0 || std::size_t(samplerIndex) >= samplers.size())
        fail("uses a sampler that is not there");
    const tinygltf::AnimationSampler& sampler = samplers[std::size_t(samplerIndex)];
    const GltfAccessor times(source_, model_, sampler.input, 1),
        values(source_, model_, sampler.output, kSize);
    Track<Value> track;
    const auto interpolation = interpolationOf(sampler.interpolation);
    if (!interpolation) fail("has the unknown interpolation " + inQuotes(sampler.interpolation));
    track.interpolation = *interpolation;
    const bool cubic = track.interpolation == Interpolation::CubicSpline;
    const std::size_t wanted = times.size() * (cubic ? 3 : 1);
    if (values.size() != wanted)
        fail("has " + std::to_string(values.size()) + " values for its times, which need " +
             std::to_string(wanted));
    const auto value = [&](std::size_t element) {
        Value v;
        for (int i = 0; i < kSize; ++i)
            v[i] = values.number(element, std::size_t(i));
        if (!isCoordinate(v.minCoeff()) || !isCoordinate(v.maxCoeff()) || !v.allFinite())
            fail("has a value that is not a number of at most 1e6");
        return v;
    };
    for (std::size_t key = 0; key < times.size(); ++key) {
        const double t = times.number(key, 0);
        if (key > 0 && t == track.times.back()) fail("has two keys at the same time");
        if (!(t >= 0 && t <= 1e6) || (key > 0 && t < track.times.back()))
            fail("has times that do not rise from 0 to at most 1e6 s");
        track.times.push_back(t);
        track.values.push_back(value(cubic ? 3 * key + 1 : key));
        if constexpr (kSize == 4)
            if (!isUsable(track.values.back())) fail("has no usable rotation");
        if (!cubic) continue;
        track.arriving.push_back(value(3 * key));
        track.leaving.push_back(value(3 * key + 2));
    }
    return track;
}

Pose GltfMotions::rigidAt(int node, double t) const {
    const NodeMotion& motion = motions_[std::size_t(node)];
    Pose pose = rigidOf(source_, model_, node);
    if (!motion.local) return pose;
    const Pose animated = motion.local->at(t);
    if (motion.slides) pose.translation = animated.translation;
    if (motion.turns) pose.rotation = animated.rotation;
    return pose;
}

Affine GltfMotions::localAt(int node, double t) const {
    if (!moves(node)) return transformOf(source_, model_, node);
    const Pose pose = rigidAt(node, t);
    return Eigen::Translation3d(pose.translation) * pose.rotation * scaleOf(model_, node);
}

GltfMotions::Course GltfMotions::courseOf(const std::vector<int>& chain) const {
    Affine parent = Affine::Identity();
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        if (moves(chain[i])) return sampledCourse(chain);
        parent = parent * transformOf(source_, model_, chain[i]);
    }
    const auto scale = uniformScale(parent.linear());
    if (!scale) return sampledCourse(chain);
    return exactCourse(chain.back(),
                       {Quat(Mat3(parent.linear() / *scale)).normalized(), parent.translation()}, *scale);
}

// X(t) = parent scale T(t) R(t): the scale goes into the vertices, and into T.
GltfMotions::Course GltfMotions::exactCourse(int node, const Pose& parent, double scale) const {
    const Motion& local = *motions_[std::size_t(node)].local;
    Pose start = rigidAt(node, 0);
    const Quat back = start.rotation.conjugate();
    Course course;
    course.stretch = scale * Mat3::Identity();
    course.motion = makeMotion(relative(local.translation, start.translation, back, scale),
                               relative(local.rotation, back), local.duration);
    if (standsStill(*course.motion)) course.motion.reset();
    start.translation *= scale;
    course.rest = parent * start;
    return course;
}

Affine GltfMotions::frameAt(const std::vector<int>& chain, double t) const {
    Affine frame = Affine::Identity();
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        frame = frame * localAt(chain[i], t);
    const Pose last = rigidAt(chain.back(), t);
    return frame * Eigen::Translation3d(last.translation) * last.rotation;
}

// Evenly, and on both sides of every jump.
std::vector<double> GltfMotions::sampleTimes(const std::vector<int>& chain, double duration) const {
    const std::size_t steps =
        std::clamp<std::size_t>(std::size_t(std::ceil(duration / kSampleStep)), 1, kMaxSamples);
    std::vector<double> times;
    for (std::size_t i = 0; i <= steps; ++i)
        times.push_back(duration * double(i) / double(steps));
    for (int node : chain)
        if (moves(node))
            for (double jump : motions_[std::size_t(node)].local->jumps) {
                if (times.size() >= 2 * kMaxSamples) break;
                times.insert(times.end(), {std::nextafter(jump, -1.0), jump});
            }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.front() < 0) times.erase(times.begin());
    return times;
}

GltfMotions::Course GltfMotions::sampledCourse(const std::vector<int>& chain) const {
    double duration = 0;
    for (int node : chain)
        if (moves(node)) duration = std::max(duration, motions_[std::size_t(node)].local->duration);
    const RigidAndStretch first = polarDecomposition(frameAt(chain, 0).linear());
    Course course;
    course.rest = {Quat(first.rotation).normalized(), frameAt(chain, 0).translation()};
    course.stretch = first.stretch;
    Track<Vec3> translation;
    Track<QuatCoefficients> rotation;
    for (double t : sampleTimes(chain, duration)) {
        const Affine frame = frameAt(chain, t);
        const RigidAndStretch parts = polarDecomposition(frame.linear());
        course.bends |= !parts.stretch.isApprox(first.stretch, kRigid);
        // Where a jump was, the last double before it and its own time count as one.
        const bool jump = !translation.times.empty() && t == std::nextafter(translation.times.back(), t + 1);
        if (jump) translation.times.back() = rotation.times.back() = t;
        translation.times.push_back(t);
        rotation.times.push_back(t);
        translation.values.push_back(course.rest.applyInverse(frame.translation()));
        rotation.values.push_back((course.rest.rotation.conjugate() * Quat(parts.rotation)).coeffs());
    }
    course.motion = makeMotion(std::move(translation), std::move(rotation), duration);
    if (standsStill(*course.motion)) course.motion.reset();
    return course;
}

} // namespace tactum
