-- MUST: kill | string.packsize/pack over long formats
-- SPDX-License-Identifier: MIT
local f = ("i1"):rep(200000)
while true do pcall(string.packsize, f) end
