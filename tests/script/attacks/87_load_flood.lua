-- MUST: kill | compiling in a loop is charged
-- SPDX-License-Identifier: MIT
local s = ("local a = 1 "):rep(100)
while true do load(s) end
