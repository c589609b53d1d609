-- MUST: error:not enough memory | growing table of tables
-- SPDX-License-Identifier: MIT
local t = {}
for i = 1, 1e9 do t[i] = { i } end
