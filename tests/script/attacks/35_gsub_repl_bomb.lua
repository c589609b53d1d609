-- MUST: error:not enough memory | 2^16 matches times a 2^16-byte replacement
-- SPDX-License-Identifier: MIT
local s = ("x"):rep(1 << 16)
s:gsub("x", ("y"):rep(1 << 16))
