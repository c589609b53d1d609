-- MUST: error:not enough memory | huge string.rep (stock: asks for 2 GiB at once)
-- SPDX-License-Identifier: MIT
local s = ("x"):rep((1 << 31) - 100)
