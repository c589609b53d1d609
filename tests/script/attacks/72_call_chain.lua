-- MUST: kill | __call chain that never reaches a function: O(n^2) argument shifting in C until the stack limit
-- SPDX-License-Identifier: MIT
local t = {}
setmetatable(t, { __call = t })
t()
