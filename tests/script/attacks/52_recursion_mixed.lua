-- MUST: error: | recursion through sort, pcall, metamethods and coroutines; the C stack must hold
-- SPDX-License-Identifier: MIT
local deepest = 0
local function f(n)
  deepest = n
  local t = setmetatable({}, { __index = function(_, k) return f(n + 1) end })
  table.sort({ 3, 2, 1 }, function(a, b) local _ = t.x return a < b end)
  return n
end
local ok, e = pcall(f, 1)
local function g(n) return coroutine.wrap(function() return g(n + 1) end)() end
local ok2, e2 = pcall(g, 1)
assert(not ok and not ok2)
local function h(n) return (("x"):gsub(".", function() return (select(2, pcall(h, n + 1))) end)) end
h(1)
local s = setmetatable({}, { __concat = function(a, b) return a .. b end })
s = s .. s
