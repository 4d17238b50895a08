// The files of one export: all or none, and nothing that a person still needs. Wrong itself if a file that
// was written over with what it held before counted as untouched: each result here is other text.
#include <fstream>
#include <map>
#include <sstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/bundle/output_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_output_files {

using namespace tactum;

namespace fs = std::filesystem;

class TestOutputFiles : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    fs::path root_;

    fs::path at(const char* name) const { return root_ / name; }
    void put(const char* name, const std::string& text) const {
        fs::create_directories(at(name).parent_path());
        std::ofstream(at(name), std::ios::trunc) << text;
    }
    /// "a.obj=1 b/c.mtl=2": every file below the folder with its text.
    std::string there() const {
        std::map<std::string, std::string> files;
        for (const auto& each : fs::recursive_directory_iterator(root_)) {
            if (!each.is_regular_file()) continue;
            std::ostringstream text;
            text << std::ifstream(each.path()).rdbuf();
            files[each.path().lexically_relative(root_).string()] = text.str();
        }
        std::string all;
        for (const auto& [name, text] : files)
            all += (all.empty() ? "" : " ") + name + "=" + text;
        return all;
    }
    /// What is said, without the folder's name; "done" else.
    std::string write(const OutputPlaces& places, const std::vector<OutFile>& files) const {
        const auto written = writeAll(places, files);
        if (written) return "done";
        std::string text = written.error().text;
        for (std::size_t i = 0; (i = text.find(root_.string() + "/", i)) != std::string::npos;)
            text.erase(i, root_.string().size() + 1);
        return text;
    }
    /// An OBJ and its library, as one export.
    std::string exported(const std::vector<fs::path>& inputs = {},
                         const std::vector<fs::path>& outputs = {}) const {
        return write({at("out.obj"), inputs, outputs},
                     {{at("parts/out.mtl"), "new library"}, {at("out.obj"), "mtllib parts/out.mtl"}});
    }

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        root_ = fs::canonical(folder_->path().toStdString());
    }

    void allAreWritten() {
        QCOMPARE(exported(), "done");
        QCOMPARE(there(), "out.obj=mtllib parts/out.mtl parts/out.mtl=new library");
        QCOMPARE(exported(), "done");        // over itself: the library is the result's own
        put("parts/out.mtl", "old library"); // which the result that is there names
        QCOMPARE(exported(), "done");
        QCOMPARE(there(), "out.obj=mtllib parts/out.mtl parts/out.mtl=new library");
    }

    void whatIsAStrangersStays() {
        put("parts/out.mtl", "of somebody else");
        const std::string strangers =
            "parts/out.mtl: is there already, and would be replaced by what lies beside out.obj; "
            "move it away, or choose another name for the result";
        QCOMPARE(exported(), strangers);
        QCOMPARE(there(), "parts/out.mtl=of somebody else");
        // The name has to be a word of the result that is there.
        for (const char* text : {"mtllib xparts/out.mtl", "mtllib parts/out.mtlx", "mtllib parts/out.mtl.bak",
                                 "mtllib parts/out.mtl-2", "nothing"}) {
            put("out.obj", text);
            QCOMPARE(exported(), strangers);
        }
        for (const char* text :
             {"mtllib parts/out.mtl\n", "\"parts/out.mtl\"", "see parts/out.mtl.", "parts/out.mtl"}) {
            put("out.obj", text);
            put("parts/out.mtl", "of somebody else");
            QCOMPARE(exported(), "done");
        }
        put("out.obj", "nothing");
        put("parts/out.mtl", "new library"); // the same as is to be written
        QCOMPARE(exported(), "done");
    }

    /// A name that lies across the end of a block of the file is found, too.
    void namesAreFoundInLongFiles() {
        for (std::size_t before = (1u << 20) - 20; before < (1u << 20) + 3; ++before) {
            put("out.obj", std::string(before, ' ') + "parts/out.mtl");
            put("parts/out.mtl", "of before");
            QCOMPARE(exported(), "done");
        }
    }

    void whatAnInputNeedsStays() {
        put("in.obj", "mtllib parts/out.mtl");
        put("parts/out.mtl", "the input's");
        const std::string before = there();
        QCOMPARE(
            exported({at("in.obj")}),
            "parts/out.mtl: belongs to in.obj and would be replaced; choose another name for the result");
        QCOMPARE(there(), before);
        QCOMPARE(exported({at("parts/out.mtl")}),
                 "parts/out.mtl: would be written beside the result, and is also an input "
                 "or another output; give each its own file");
        QCOMPARE(exported({"-"}, {at("parts/../parts/out.mtl")}),
                 "parts/out.mtl: would be written beside the result, and is also an input or another output; "
                 "give each its own file");
        QCOMPARE(there(), before);
    }

    /// When one cannot be written, what was there before is there again, and no folder is left.
    void orNone() {
        put("out.obj", "before");
        put("old/keep.bin", "kept");
        const std::string before = there();
        fs::create_directories(at("taken.obj")); // a folder has that name
        const auto fault =
            write({at("taken.obj"), {}, {}},
                  {{at("made/new.mtl"), "1"}, {at("old/other.bin"), "2"}, {at("taken.obj"), "3"}});
        COMPARE_CONTAINS(QString::fromStdString(fault), "taken.obj");
        QCOMPARE(there(), before);
        QVERIFY(!fs::exists(at("made")));
        // What is replaced comes back with all of its names.
        fs::create_hard_link(at("out.obj"), at("second.obj"));
        const auto again = write({at("taken.obj"), {}, {}}, {{at("out.obj"), "new"}, {at("taken.obj"), "3"}});
        COMPARE_CONTAINS(QString::fromStdString(again), "taken.obj");
        QCOMPARE(there(), "old/keep.bin=kept out.obj=before second.obj=before");
        QVERIFY(fs::equivalent(at("out.obj"), at("second.obj")));
    }

    void clashesAreNamedAsThePersonCallsThem() {
        put("a", "1");
        fs::create_symlink(at("a"), at("link"));
        const auto clash = [](const std::vector<fs::path>& inputs, const std::vector<fs::path>& outputs) {
            return clashOf(inputs, outputs).value_or("none").filename().string();
        };
        QCOMPARE(clash({at("a")}, {at("b"), at("c")}), "none");
        QCOMPARE(clash({at("a")}, {at("b"), at("link")}), "link");
        QCOMPARE(clash({}, {at("b"), at("x/../b")}), "b");
        QCOMPARE(clash({"-"}, {"-"}), "none"); // standard input is no file
        QCOMPARE(clash({}, {"/dev/null", "/dev/null"}), "none");
    }
};

TACTUM_TEST(TestOutputFiles)

} // namespace test_output_files

#include "test_output_files.moc"
