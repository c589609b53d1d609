// SPDX-License-Identifier: MIT
// GDI+'s header with what it takes for granted: the macros min and max, which NOMINMAX leaves out.
#pragma once

// clang-format off
#include <algorithm>

#include <windows.h>
#include <objidl.h>
namespace Gdiplus {
using std::max;
using std::min;
}  // namespace Gdiplus
#include <gdiplus.h>
// clang-format on
