// A vibration in the formats that are played elsewhere.
#pragma once

#include <filesystem>
#include <string>

#include "core/vibration/vibration.h"

namespace tactum {

/// The bytes of a file, by the ending of its name:
/// - `.wav`: one channel of 16 bits; full scale is the vibration's peak, which a comment in it says in N;
/// - `.hjif`: MPEG haptics (ISO/IEC 23090-31), profile Main, level 1: one vibrotactile channel with one band,
/// a curve
///   of straight lines that is nowhere more than 1/1000 of full scale off;
/// - `.haptic`: the data model 1.0.0 of Lofelt and Meta Haptics Studio: amplitude and frequency as envelopes,
/// 0 to 1.
///   A frequency of 0 stands for kLowHaptic and 1 for kHighHaptic, which the format leaves open.
/// `source` is the name of what was touched. Usage error: another ending.
Result<std::string> vibrationBytes(const Vibration& vibration, const std::filesystem::path& file,
                                   const std::string& source);

/// Whether vibrationBytes() knows the ending. Usage error, with the sentence.
Result<void> checkVibrationFile(const std::filesystem::path& file);

inline constexpr double kLowHaptic = 60, kHighHaptic = 300; ///< Hz; between them by octaves

} // namespace tactum
