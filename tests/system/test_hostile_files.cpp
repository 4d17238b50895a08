// Files that nobody should open, opened as the program does: each is refused in one line, or it loads and
// what it is can be touched, in bounded time and memory.
#include <QTest>

#include "core/import/import_scene.h"
#include "tests/support/random_touch.h"
#include "tests/support/test_program.h"
#include "tests/system/hostile_files.h"

namespace test_hostile_files {

using namespace tactum;
using namespace tactum::test;
using namespace std::chrono_literals;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kMemory = std::uint64_t(1) << 46; // a sanitizer needs more than any limit
#else
constexpr std::uint64_t kMemory = std::uint64_t(512) << 20;
#endif

} // namespace

class TestHostileFiles : public QObject {
    Q_OBJECT

private slots:
    void soundOnesAreOpened() {
        for (const WrittenMesh& file : soundFiles())
            QVERIFY2(open(file), (file.name + ": " + answer_).c_str());
    }
    void cutOnesAreAnswered() { answered(cutFiles()); }
    void lyingOnesAreAnswered() { answered(lyingFiles()); }
    void degenerateOnesAreAnswered() { answered(degenerateFiles()); }
    void unbearableOnesAreAnswered() { answered(unbearableFiles()); }

private:
    /// Whether it was; `answer_`: the line that says why not.
    std::optional<Scene> open(const WrittenMesh& file) {
        ImportOptions options;
        options.limits = ImportLimits{kMemory, 20s, 300s};
        auto imported = importScene(folder_.write(file.name, file.content), {}, options);
        answer_ = imported ? "" : imported.error().text;
        return imported ? std::optional(std::move(imported->scene)) : std::nullopt;
    }

    /// Our readers say no themselves: the limits of the process are for what nobody thought of, and for
    /// Assimp, which asks for whatever room a file claims to need.
    bool stopped() const { return answer_.find("the reader stopped") != std::string::npos; }
    static bool isRare(const WrittenMesh& file) {
        const std::string ending = file.name.substr(file.name.rfind('.'));
        return ending == ".3ds" || ending == ".fbx" || ending == ".dae";
    }

    void answered(const std::vector<WrittenMesh>& files) {
        int number = 0, refused = 0;
        faults_.clear();
        for (const WrittenMesh& file : files) {
            const std::string name = "file " + std::to_string(number++) + ", " + file.name + ": ";
            if (const auto scene = open(file)) {
                const std::string fault = faultOfTouch(*scene);
                if (!fault.empty()) keep(name + fault);
                continue;
            }
            ++refused;
            if (answer_.empty() || answer_.find('\n') != std::string::npos)
                keep(name + "the answer is not one line: " + answer_);
            if (stopped() && !isRare(file)) keep(name + answer_);
        }
        qInfo("%zu files, %d refused", files.size(), refused);
        QVERIFY2(faults_.empty(), faults_.c_str());
    }

    void keep(const std::string& fault) { faults_ += fault + "\n"; }

    FileFolder folder_;
    std::string answer_, faults_;
};

TACTUM_TEST(TestHostileFiles)

} // namespace test_hostile_files

#include "test_hostile_files.moc"
