// The parts of a page: text that is safe in it, tables, pictures that lie in it. For this folder only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactum {

/// Text for a page, an attribute in quotes included: nothing in it is a tag, whatever strangers called their
/// things.
std::string escaped(std::string_view text);

std::string heading(int level, std::string_view text);
std::string paragraph(std::string_view text);

/// Cells of a row; they are escaped.
using Row = std::vector<std::string>;
/// `head`: what the columns are. The first cell of a row says what it is of. Nothing where there are no rows.
std::string table(const Row& head, const std::vector<Row>& rows);

/// `alt`: what is to be seen. `width`, `height`: pixels on the page; 0: as many as the picture has itself,
/// which who prints takes where the width is another one.
std::string picture(std::string_view mimeType, std::string_view bytes, std::string_view alt, int width,
                    int height = 0);

/// At most six digits: more than a person reads.
std::string readable(double value);

/// A value of so much of an SI unit as people write it: lengths in mm, angles in degrees.
struct Quantity {
    std::string number, unit;
};
Quantity quantity(double value, std::string_view unit);

} // namespace tactum
