#include <array>
#include <cmath>
#include <span>

#include "app/arguments.h"
#include "core/base/numbers.h"

namespace tactum {

namespace {

inline constexpr Parameter kSeconds{"seconds", "Seconds", "s", 0, 1e5, 1, 1, 3, "How long to go on."};
inline constexpr Parameter kRate{"rate", "Rate", "Hz", 1, 1e6, 100, 2000, 0, "Steps a second, at least."};
inline constexpr Parameter kEvery{"every", "Every", "s", 1e-6, 1e5, 0.01, 0.01, 3, "Time between two rows."};

/// Of a point, a force or an acceleration, SI: nothing that anybody means is beyond it.
constexpr double kLargestNumber = 1e9;

/// As many numbers as there are, with commas between them.
void readNumbers(const char* name, std::string_view text, std::span<double> numbers) {
    std::size_t count = 0;
    for (std::string_view rest = text; !rest.empty() || count == 0; ++count) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const auto number = parseNumber(rest.substr(0, comma));
        if (!number || std::abs(*number) > kLargestNumber || count == numbers.size())
            throw CLI::ValidationError(name, "'" + std::string(text) + "' is not " +
                                                 std::to_string(numbers.size()) +
                                                 " numbers with commas between them");
        numbers[count] = *number;
        if (comma == rest.size()) {
            ++count;
            break;
        }
        rest.remove_prefix(comma + 1);
        if (rest.empty()) count = numbers.size(); // a comma at the end
    }
    if (count != numbers.size())
        throw CLI::ValidationError(name, "'" + std::string(text) + "' is not " +
                                             std::to_string(numbers.size()) +
                                             " numbers with commas between them");
}

} // namespace

void addSimulate(CLI::App& program, SimulateOptions& options) {
    CLI::App* simulate =
        program.add_subcommand("simulate", "Let the bodies of a scene move by forces and joints");
    addFile(*simulate, "SCENE", options.scene, "Any file with KHR_physics_rigid_bodies; - is standard input")
        ->required();
    addNumber(*simulate, kSeconds, [&](double value) { options.seconds = value; });
    simulate->get_option("--seconds")->required();
    addNumber(*simulate, kRate, [&](double value) { options.rate = value; });
    addNumber(*simulate, kEvery, [&](double value) { options.every = value; });
    simulate
        ->add_option_function<std::vector<std::string>>(
            "--push",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    std::array<double, 8> n{};
                    readNumbers("--push", text, n);
                    if (!(n[0] < n[1]))
                        throw CLI::ValidationError("--push", "'" + text + "' ends before it begins");
                    options.pushes.push_back({n[0], n[1], Vec3(n[2], n[3], n[4]), Vec3(n[5], n[6], n[7])});
                }
            },
            "A force from t0 to t1 on the body that is at a point at t0, constant in the world; as often as "
            "wanted")
        ->type_name("T0,T1,X,Y,Z,FX,FY,FZ")
        ->expected(1)
        ->take_all();
    simulate
        ->add_option_function<std::string>(
            "--gravity",
            [&](const std::string& text) {
                Vec3 gravity;
                readNumbers("--gravity", text, {gravity.data(), 3});
                options.gravity = gravity;
            },
            "Instead of the scene's, m/s^2")
        ->type_name("X,Y,Z");
    addFile(*simulate, "--out", options.out,
            "Write the states as CSV, one row for each body and time; - is standard output");
    addFile(*simulate, "--summary", options.summary, "Write the summary as JSON");
    simulate->footer(
        "Columns: t,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,kinetic,potential; SI, world frame, at the\n"
        "centre of mass. Gravity is 9.81 m/s^2 along -y where the scene does not say.");
    simulate->final_callback([&] { checkOutputs({options.scene}, {options.out, options.summary}); });
}

} // namespace tactum
