-- MUST: error:loop | __index loop
-- SPDX-License-Identifier: MIT
local t = setmetatable({}, nil)
local m = { }
m.__index = setmetatable({}, m)
getmetatable(m.__index).__index = m.__index
return m.__index.x
