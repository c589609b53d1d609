-- MUST: kill | coroutine.resume must not turn the budget error into "false, msg"
-- SPDX-License-Identifier: MIT
while true do
  local co = coroutine.create(function() while true do end end)
  coroutine.resume(co)
end
