-- MUST: kill | pcall continued after a yield (lua_pcallk continuation) must not swallow the budget error either
-- SPDX-License-Identifier: MIT
local co = coroutine.create(function()
  while true do
    pcall(function() coroutine.yield() while true do end end)
    xpcall(function() coroutine.yield() while true do end end, function() while true do end end)
  end
end)
while true do coroutine.resume(co) end
