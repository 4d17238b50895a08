#include "core/bundle/verify_bundle.h"

#include <algorithm>

#include "core/archive/bundle_files.h"
#include "core/bundle/bundle_bytes.h"
#include "core/bundle/bundle_readme.h"
#include "core/bundle/forces_csv.h"
#include "core/files/read_finger_path.h"
#include "core/files/source.h"
#include "core/files/x3d/write_x3d.h"
#include "core/haptics/compile.h"

namespace tactum {
namespace {

std::string shown(const Vec3& v, const char* unit) {
    return "(" + shortest(v.x()) + ", " + shortest(v.y()) + ", " + shortest(v.z()) + ") " + unit;
}

/// One column group of the table beside what the scene gives: how many rows differ, and by how much at most.
class Comparison {
public:
    Comparison(const char* what, const char* unit, double same) : what_(what), unit_(unit), same_(same) {}

    void add(std::size_t row, double t, const Vec3& said, const Vec3& now) {
        const double apart = (said - now).norm();
        largest_ = std::max(largest_, apart);
        if (apart <= same_) return;
        if (count_++ > 0) return;
        first_ = "line " + std::to_string(row + 2) + " (t = " + shortest(t) + " s) says " +
                 shown(said, unit_) + ", the scene gives " + shown(now, unit_);
    }
    void tell(std::vector<std::string>& differences) const {
        if (count_ == 0) return;
        differences.push_back(std::string(bundle_name::kForces) + ": " + what_ + " differs in " +
                              std::to_string(count_) + (count_ == 1 ? " row" : " rows") + ", by up to " +
                              shortest(largest_) + " " + unit_ + "; " + first_);
    }
    double largest() const { return largest_; }

private:
    const char *what_, *unit_;
    double same_, largest_ = 0;
    std::size_t count_ = 0;
    std::string first_;
};

void compareRows(const FeltTable& said, const TouchTrace& now, BundleVerdict& verdict) {
    Comparison finger("the finger", "m", kSamePlace), proxy("the proxy", "m", kSamePlace),
        force("the force", "N", kSameForce), time("the time", "s", kSamePlace);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const FeltRow& row = said.rows[i];
        time.add(i, now[i].t, Vec3(row.t, 0, 0), Vec3(now[i].t, 0, 0));
        force.add(i, now[i].t, row.force, now[i].force);
        verdict.largestForce = std::max(verdict.largestForce, now[i].force.norm());
        verdict.touches = verdict.touches || now[i].contacts > 0;
        if (!said.whole) continue;
        finger.add(i, now[i].t, row.finger, now[i].finger);
        proxy.add(i, now[i].t, row.proxy, now[i].proxy);
    }
    for (const Comparison* comparison : {&time, &finger, &proxy, &force})
        comparison->tell(verdict.differences);
    verdict.largestDifference = force.largest();
}

/// The files for H3D hold numbers as well.
Result<void> compareX3d(const BundleFiles& files, const Scene& scene, const Progress& progress,
                        BundleVerdict& verdict) {
    const auto x3d = x3dOf(scene, {}, progress);
    if (!x3d) return tl::unexpected<Error>(x3d.error());
    const auto compare = [&](const std::string& name, std::string_view bytes) {
        if (files.file(name) != bytes)
            verdict.differences.push_back(name + ": is not what the scene gives; export the bundle again");
    };
    compare(bundle_name::kX3d, x3d->scene);
    compare(bundle_name::kDevice, x3d->device);
    for (const X3dImage& image : x3d->images)
        compare(image.name, image.bytes);
    return {};
}

} // namespace

Result<BundleVerdict> verifyBundle(const std::filesystem::path& file, const Scene& scene,
                                   const Progress& progress) {
    const auto bytes = bundleBytes(file);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    const auto files = BundleFiles::open(*bytes);
    if (!files) return inputError(shownPath(file) + ": " + files.error().text);
    const auto finger = readFingerPath(files->file(bundle_name::kFinger), file / bundle_name::kFinger);
    if (!finger) return tl::unexpected<Error>(finger.error());
    const auto said = readForces(files->file(bundle_name::kForces), file / bundle_name::kForces);
    if (!said) return tl::unexpected<Error>(said.error());
    const auto world = compile(scene);
    if (!world) return tl::unexpected<Error>(world.error());
    const auto now = replay(**world, *finger, progress);
    if (!now) return tl::unexpected<Error>(now.error());
    BundleVerdict verdict;
    verdict.steps = now->size();
    if (said->rows.size() == now->size())
        compareRows(*said, *now, verdict);
    else
        verdict.differences.push_back(std::string(bundle_name::kForces) + ": has " +
                                      std::to_string(said->rows.size()) + " rows, " + bundle_name::kFinger +
                                      " " + std::to_string(now->size()));
    if (const auto compared = compareX3d(*files, scene, progress, verdict); !compared)
        return tl::unexpected<Error>(compared.error());
    return verdict;
}

} // namespace tactum
