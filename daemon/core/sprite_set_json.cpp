// SPDX-License-Identifier: MIT
// sprite.json and its sheet.
#include "daemon/core/checked_json.h"
#include "daemon/core/engine.h"
#include "daemon/core/files.h"
#include "daemon/core/png_header.h"
#include "daemon/core/sprite_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_json_bytes = 1U << 20U;
constexpr std::size_t max_frames = 1000;  // in one animation
constexpr int max_frame_ms = 600'000;

// In the order of Filter.
constexpr std::array<std::string_view, 2> filter_names{"smooth", "nearest"};

using Keys = std::initializer_list<std::string_view>;

// Sets may carry keys that this version does not know (a licence, a later version's
// settings), so only one that looks like a slip is an error.
void refuse_misspelt_keys(const JsonValue& object, Keys known) {
    const std::span<const std::string_view> names(known);
    for (const JsonValue& member : object.children()) {
        if (std::ranges::count(names, member.located().key) == 0) {
            member.refuse_misspelt_key(names);
        }
    }
}

// The part of sprite.json that becomes a SpriteSet without knowledge of the sheet.
class SetReader {
public:
    SetReader(const LocatedJson& root, std::string file)
        : problems_(std::move(file)), root_(root, "", problems_) {}

    Result<SpriteSet> read(std::string folder_name) {
        SpriteSet set;
        set.name = std::move(folder_name);
        if (root_.is_object()) {
            refuse_misspelt_keys(
                root_,
                {"$schema",
                 "name",
                 "sheet",
                 "cell",
                 "anchor",
                 "box",
                 "scale",
                 "filter",
                 "animations"}
            );
            if (const auto name = root_.member("name")) {
                set.name = name->name().value_or("");
            }
            if (const auto sheet = root_.required("sheet")) {
                sheet_ = sheet->relative_path().value_or("");
                // Nobody has looked at what is hidden, nor whether it is a link.
                if (sheet_.starts_with('.') || sheet_.contains("/.")) {
                    sheet->expected("must be a file that is not hidden");
                }
            }
            read_cell(set);
            read_scaling(set);
            read_animations(set);
        }
        if (problems_.has_errors()) {
            return std::unexpected(problems_.error());
        }
        return set;
    }

    /// Of the sheet's file, relative to the folder, with /.
    const std::string& sheet() const { return sheet_; }

    /// Fails where a frame shows a cell that the sheet does not have.
    Result<void> check_cells(int cells) {
        for (const JsonValue& number : cell_numbers_) {
            number.whole_number(0, cells - 1);
        }
        if (problems_.has_errors()) {
            return std::unexpected(problems_.error());
        }
        return {};
    }

private:
    static std::optional<int> whole(
        const JsonValue& object, std::string_view key, int low, int high
    ) {
        const std::optional<JsonValue> value = object.required(key);
        return value ? value->whole_number(low, high) : std::nullopt;
    }

    std::optional<JsonValue> required_object(std::string_view key, Keys known) const {
        std::optional<JsonValue> object = root_.required(key);
        if (!object || !object->is_object()) {
            return std::nullopt;
        }
        refuse_misspelt_keys(*object, known);
        return object;
    }

    void read_cell(SpriteSet& set) {
        const auto cell = required_object("cell", {"width", "height"});
        if (!cell) {
            return;
        }
        const std::optional<int> width = whole(*cell, "width", 1, max_image_side);
        const std::optional<int> height = whole(*cell, "height", 1, max_image_side);
        if (!width || !height) {
            return;
        }
        set.cell = {*width, *height};
        read_anchor(set.cell);
        read_box(set);
    }

    // Nothing uses the anchor yet; a set that has one must still get it right.
    void read_anchor(Size cell) {
        if (!root_.member("anchor")) {
            return;
        }
        if (const auto anchor = required_object("anchor", {"x", "y"})) {
            whole(*anchor, "x", 0, cell.width);
            whole(*anchor, "y", 0, cell.height);
        }
    }

    void read_box(SpriteSet& set) {
        const auto box = required_object("box", {"x", "y", "width", "height"});
        if (!box) {
            return;
        }
        const std::optional<int> x = whole(*box, "x", 0, set.cell.width - 1);
        const std::optional<int> y = whole(*box, "y", 0, set.cell.height - 1);
        // What is left of the cell beside x and below y.
        const auto width = whole(*box, "width", 1, set.cell.width - x.value_or(0));
        const auto height = whole(*box, "height", 1, set.cell.height - y.value_or(0));
        if (x && y && width && height) {
            set.box = {*x, *y, *width, *height};
        }
    }

    void read_scaling(SpriteSet& set) {
        if (const auto scale = root_.member("scale")) {
            set.scale = scale->number(least_scale, most_scale).value_or(1.0);
        }
        if (const auto filter = root_.member("filter")) {
            const auto name = filter->choice(filter_names);
            set.filter = name == filter_names[1] ? Filter::nearest : Filter::smooth;
        }
    }

    void read_animations(SpriteSet& set) {
        const std::optional<JsonValue> list = root_.required("animations");
        if (!list || !list->is_object()) {
            return;
        }
        list->required("idle");
        for (const JsonValue& each : list->children()) {
            set.animations.emplace(each.located().key, read_animation(each));
        }
    }

    Animation read_animation(const JsonValue& value) {
        Animation animation;
        if (!value.is_object()) {
            return animation;
        }
        refuse_misspelt_keys(value, {"frames", "loop"});
        if (const auto loop = value.member("loop")) {
            animation.loop = loop->flag().value_or(false);
        }
        const std::optional<JsonValue> frames = value.required("frames");
        const auto items = frames ? frames->items(1, max_frames) : std::nullopt;
        for (const JsonValue& item : items.value_or(std::vector<JsonValue>{})) {
            read_frame(item, animation);
        }
        return animation;
    }

    void read_frame(const JsonValue& value, Animation& animation) {
        if (!value.is_object()) {
            return;
        }
        refuse_misspelt_keys(value, {"cell", "ms"});
        const auto cell = whole(value, "cell", 0, std::numeric_limits<int>::max());
        const auto ms = whole(value, "ms", 1, max_frame_ms);
        if (cell && ms) {
            animation.frames.push_back({.cell = *cell, .duration = *ms * ticks_per_ms});
            cell_numbers_.push_back(*value.member("cell"));
        }
    }

    JsonProblems problems_;
    JsonValue root_;
    std::string sheet_;
    std::vector<JsonValue> cell_numbers_;  // kept until the sheet is known
};

// From the header alone: a small file can announce a picture that fills all memory.
Result<Size> checked_size(std::span<const std::byte> file, std::string_view name) {
    const std::optional<Size> size = png_size(file);
    if (!size) {
        return failure(fmt::format("{}: is not a PNG picture", name));
    }
    const auto [least, most] = std::minmax(size->width, size->height);
    if (least < 1 || most > max_image_side) {
        return failure(fmt::format(
            "{}: is {} x {} pixels; 1 to {} a side are allowed",
            name,
            size->width,
            size->height,
            max_image_side
        ));
    }
    return *size;
}

/// Clear where nothing is seen, and with no colour above alpha, whatever the decoder made of it:
/// such a pixel would shine.
Pixel cleaned(Pixel pixel) {
    const unsigned alpha = alpha_of(pixel);
    if (alpha < least_alpha) {
        return 0;
    }
    Pixel result = Pixel{alpha} << 24U;
    for (const unsigned shift : {0U, 8U, 16U}) {
        result |= std::min((pixel >> shift) & 0xFFU, alpha) << shift;
    }
    return result;
}

Result<Image> load_sheet(
    const fs::path& path, Size cell, const ImageDecoder& decode, std::size_t room
) {
    const Result<std::vector<std::byte>> file = read_binary_file(path, max_image_file_bytes);
    if (!file) {
        return std::unexpected(file.error());
    }
    const std::string name = utf8_from_path(path);
    const Result<Size> size = checked_size(*file, name);
    if (!size) {
        return std::unexpected(size.error());
    }
    if (size->width % cell.width != 0 || size->height % cell.height != 0) {
        return failure(fmt::format(
            "{}: is {} x {} pixels, which is no whole number of cells of {} x {} (/cell in "
            "sprite.json)",
            name,
            size->width,
            size->height,
            cell.width,
            cell.height
        ));
    }
    const auto pixels =
        static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height);
    if (pixels > room) {
        return failure(fmt::format(
            "{}: has {} pixels, but there is room for {} more: all sheets together have at most {}",
            name,
            pixels,
            room,
            most_sheet_pixels
        ));
    }
    Result<Image> sheet = decode(*file);
    if (!sheet) {
        return failure(fmt::format("{}: cannot be decoded: {}", name, sheet.error().message));
    }
    if (sheet->size != *size || sheet->pixels.size() != pixels) {
        return failure(fmt::format("{}: was decoded to another size than its header says", name));
    }
    std::ranges::transform(sheet->pixels, sheet->pixels.begin(), cleaned);
    return sheet;
}

Result<SpriteSet> read_sprite_set(
    const fs::path& folder, const ImageDecoder& decode, std::size_t room
) {
    const fs::path file = folder / "sprite.json";
    const Result<std::string> text = read_text_file(file, max_json_bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    const Result<LocatedJson> root = parse_located_json(*text, utf8_from_path(file));
    if (!root) {
        return std::unexpected(root.error());
    }
    SetReader reader(*root, utf8_from_path(file));
    Result<SpriteSet> set = reader.read(utf8_from_path(folder.filename()));
    if (!set) {
        return set;
    }
    Result<Image> sheet =
        load_sheet(folder / path_from_utf8(reader.sheet()), set->cell, decode, room);
    if (!sheet) {
        return std::unexpected(sheet.error());
    }
    const int columns = sheet->size.width / set->cell.width;
    const int rows = sheet->size.height / set->cell.height;
    if (const Result<void> cells = reader.check_cells(columns * rows); !cells) {
        return std::unexpected(cells.error());
    }
    set->sheet = *std::move(sheet);
    return set;
}

}  // namespace

// One set without memory for its picture is no reason to lose the others.
Result<SpriteSet> load_sprite_set(
    const fs::path& folder, const ImageDecoder& decode, std::size_t room
) {
    try {
        return read_sprite_set(folder, decode, room);
    } catch (const std::exception& error) {
        return failure(fmt::format("{}: cannot be read: {}", utf8_from_path(folder), error.what()));
    }
}

}  // namespace hyrax
