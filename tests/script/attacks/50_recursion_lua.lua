-- MUST: error: | unbounded Lua recursion ends as an error (stack overflow or memory)
-- SPDX-License-Identifier: MIT
local function f() return 1 + f() end
f()
