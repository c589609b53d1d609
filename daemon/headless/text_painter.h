// SPDX-License-Identifier: MIT
// Lines of text by FreeType, in a font of the system.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/result.h"

#include <memory>
#include <string_view>

struct FT_LibraryRec_;
struct FT_FaceRec_;

namespace hyrax {

/// For any one thread at a time.
class FreetypePainter {
public:
    FreetypePainter();

    /// A line as speech.h wants it; fails where there is no font.
    [[nodiscard]] Result<Image> draw(std::string_view line) const;

private:
    struct EndLibrary {
        void operator()(FT_LibraryRec_* library) const;
    };
    struct EndFace {
        void operator()(FT_FaceRec_* face) const;
    };

    // In order of dependence.
    std::unique_ptr<FT_LibraryRec_, EndLibrary> library_;
    std::unique_ptr<FT_FaceRec_, EndFace> face_;
};

}  // namespace hyrax
