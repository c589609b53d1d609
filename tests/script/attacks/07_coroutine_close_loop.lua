-- MUST: kill | coroutine.close runs __close handlers of a suspended coroutine
-- SPDX-License-Identifier: MIT
local mt = { __close = function() while true do end end }
local co = coroutine.create(function() local x <close> = setmetatable({}, mt); coroutine.yield() end)
coroutine.resume(co)
coroutine.close(co)
