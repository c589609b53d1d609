-- MUST: kill | O(n^2) find on a long subject inside one C call
-- SPDX-License-Identifier: MIT
local s = ("a"):rep(900000)
s:find(".-b")
