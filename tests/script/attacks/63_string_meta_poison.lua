-- MUST: ok | poisoning the string library harms only this script's own state (HOST then checks another plugin and the host)
-- SPDX-License-Identifier: MIT
string.format = function() error("poisoned") end
string.rep = nil
local mt = getmetatable("")
assert(type(mt) ~= "table")
tostring = function() while true do end end
pcall = nil
assert = function() return true end
