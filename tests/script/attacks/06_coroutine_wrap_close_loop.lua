-- MUST: kill | wrap() closes a failed coroutine: its __close handlers run with hooks off after a hook error
-- SPDX-License-Identifier: MIT
local mt = { __close = function() while true do end end }
local f = coroutine.wrap(function()
  local x <close> = setmetatable({}, mt)
  while true do end
end)
f()
