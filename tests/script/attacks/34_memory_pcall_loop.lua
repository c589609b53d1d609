-- MUST: kill | swallowing memory errors in a loop still burns the budget
-- SPDX-License-Identifier: MIT
while true do pcall(string.rep, "x", 1 << 30) end
