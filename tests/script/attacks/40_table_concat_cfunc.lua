-- MUST: error: | table.concat over a C-function __index with a huge range (no VM instruction runs)
-- SPDX-License-Identifier: MIT
table.concat(setmetatable({}, { __index = type }), "", 1, 1 << 50)
