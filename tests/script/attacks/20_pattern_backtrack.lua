-- MUST: kill | exponential/polynomial backtracking inside one C call
-- SPDX-License-Identifier: MIT
local s = ("a"):rep(3000)
s:find((".-"):rep(10) .. "b")
