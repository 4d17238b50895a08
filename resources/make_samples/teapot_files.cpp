// The teapot as a bare mesh with a finger that touches it: what a person's own model and recording look like.
#include <cmath>
#include <cstdint>
#include <fstream>

#include "resources/make_samples/samples.h"
#include "resources/make_samples/teapot_finger.h"

namespace tactum::samples {
namespace {

/// With so many decimals, of any number that is smaller than a million; the same in every locale.
std::string fixed(double value, int decimals) {
    const auto scale = std::int64_t(std::llround(std::pow(10.0, decimals)));
    const std::int64_t whole = std::llround(value * double(scale));
    std::string digits = std::to_string(std::abs(whole) % scale);
    digits.insert(0, std::size_t(decimals) - digits.size(), '0');
    return (whole < 0 ? "-" : "") + std::to_string(std::abs(whole) / scale) + "." + digits;
}

std::string fixed(const Vec3& p, int decimals, const char* separator) {
    return fixed(p.x(), decimals) + separator + fixed(p.y(), decimals) + separator + fixed(p.z(), decimals);
}

class ObjWriter {
public:
    explicit ObjWriter(const std::filesystem::path& folder)
        : obj_(folder / "teapot.obj", std::ios::binary), mtl_(folder / "teapot.mtl", std::ios::binary) {
        obj_ << "# A teapot on a table: metres, y up. Written by make-samples.\nmtllib teapot.mtl\n";
        mtl_ << "# The colours of teapot.obj. Written by make-samples.\n";
    }

    void startObject(const char* name) { obj_ << "o " << name << "\n"; }

    void write(const Part& part) {
        mtl_ << "newmtl " << part.name << "\nKd " << fixed(part.colour.cast<double>(), 2, " ") << "\n";
        obj_ << "g " << part.name << "\nusemtl " << part.name << "\n";
        for (std::size_t i = 0; i <= part.rings; ++i)
            for (std::size_t k = 0; k < part.pointsOf(i); ++k)
                obj_ << "v " << fixed(yUp(part.pointAt(i, k)), 6, " ") << "\nvn "
                     << fixed(yUp(part.normalAt(i, k)), 4, " ") << "\n";
        for (const auto& [a, b, c] : part.triangles())
            writeTriangle(first_ + a, first_ + b, first_ + c);
        first_ += part.pointCount();
    }

    bool good() { return obj_.flush().good() && mtl_.flush().good(); }

private:
    void writeTriangle(std::size_t a, std::size_t b, std::size_t c) {
        obj_ << "f " << a << "//" << a << " " << b << "//" << b << " " << c << "//" << c << "\n";
    }

    std::ofstream obj_, mtl_;
    std::size_t first_ = 1;
};

/// Approach, press the body and release, stroke it, stroke the lid, stroke the spout, press, leave. 8 s at 1
/// kHz.
bool writeFinger(const std::filesystem::path& file) {
    const Part pot = teapotBody(), cover = teapotLid(), snout = teapotSpout();
    const std::vector<TeapotKey> keys{
        {0.0, &pot, 0.48, 0.72, -50},   {0.7, &pot, 0.48, 0.72, 0},     {1.0, &pot, 0.48, 0.72, 4},
        {1.3, &pot, 0.48, 0.72, 1.5},   {2.0, &pot, 0.44, 0.84, 3},     {2.8, &pot, 0.60, 0.92, 2.5},
        {3.1, &pot, 0.60, 0.92, -12},   {3.6, &cover, 0.44, 0.92, -12}, {3.8, &cover, 0.44, 0.92, 2},
        {4.6, &cover, 0.46, 0.58, 4},   {5.2, &cover, 0.40, 0.85, 3},   {5.4, &cover, 0.40, 0.90, -12},
        {5.9, &snout, 0.45, 0.62, -12}, {6.1, &snout, 0.45, 0.62, 2},   {6.8, &snout, 0.58, 0.56, 3},
        {7.2, &snout, 0.54, 0.60, 4},   {7.5, &snout, 0.53, 0.60, 0},   {8.0, &snout, 0.53, 0.60, -40}};
    std::ofstream out(file, std::ios::binary);
    out << "t,x,y,z\n";
    for (int row = 0; row <= 8000; ++row) {
        const double t = row * 1e-3;
        out << fixed(t, 3) << "," << fixed(yUp(teapotFinger(keys, t)), 7, ",") << "\n";
    }
    return out.flush().good();
}

} // namespace

bool writeTeapotFiles(const std::filesystem::path& folder) {
    ObjWriter obj(folder);
    obj.startObject("teapot");
    for (const Part& part : {teapotBody(), teapotLid(), teapotSpout(), teapotHandle()})
        obj.write(part);
    obj.startObject("table");
    obj.write(teapotTable());
    return obj.good() && writeFinger(folder / "teapot-finger.csv");
}

} // namespace tactum::samples
