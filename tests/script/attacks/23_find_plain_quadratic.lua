-- MUST: kill | plain find: memchr+memcmp is O(n*m)
-- SPDX-License-Identifier: MIT
local s = ("a"):rep(900000)
s:find(("a"):rep(450000) .. "b", 1, true)
