// A consumer that is compiled for several processors and against what was installed: same_bits SCENE
// COPY.glb. Prints a fingerprint of everything that a path feels and of the layout of what it is told, which
// all of them have to have in common.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <tactum/tactum.h>

namespace {

class Fingerprint { // FNV-1a
public:
    void add(double number) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        for (int i = 0; i < 8; ++i)
            value_ = (value_ ^ (bits >> 8 * i & 255)) * 0x100000001b3;
    }
    void add(const tactum::Vec3& v) { add(v.x), add(v.y), add(v.z); }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const tactum::Scene scene = tactum::Scene::open(argv[1]);
        tactum::World world(scene);
        Fingerprint print;
        double largest = 0;
        for (const tactum::FingerPoint& point : scene.path()) {
            const tactum::Step step = world.step(point.position);
            print.add(step.force), print.add(step.proxy);
            for (const tactum::Contact& contact : step.touched())
                print.add(contact.normal), print.add(contact.normalForce);
            largest = largest < step.force.y ? step.force.y : largest;
        }
        scene.save(argv[2]);
        for (const tactum::TouchRow& row : tactum::Scene::open(argv[2]).touch())
            print.add(row.force);
        std::printf("%016llx %zu %zu %zu %.3f\n", (unsigned long long)print.value(), sizeof(tactum::Step),
                    alignof(tactum::Step), sizeof(tactum::EngineState), largest);
        return largest > 0 ? 0 : 1;
    } catch (const tactum::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
