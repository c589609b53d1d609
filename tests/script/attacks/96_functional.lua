-- MUST: ok | honest code works: pcall/xpcall/yield across pcall/load/tbc/gsub/sort/format
-- SPDX-License-Identifier: MIT
local r = {}
local co = coroutine.wrap(function() local ok, v = pcall(function() return coroutine.yield(1) + 1 end) coroutine.yield(ok and v) local ok2, e = pcall(function() coroutine.yield(3) error("boom", 0) end) return e end)
assert(co() == 1 and co(41) == 42 and co() == 3 and co() == "boom")
assert(select("#", pcall(error)) == 2)
local ok, tb = xpcall(function() error("oops") end, debug.traceback)
assert(not ok and tb:find("oops") and tb:find("stack traceback"))
assert(xpcall(function(a, b) return a + b end, print, 1, 2))
local closed
do local x <close> = setmetatable({}, { __close = function() closed = true end }) end
assert(closed and load("return 1 + 1")() == 2 and load("return x", "c", "t", { x = 7 })() == 7)
assert(("hello world"):gsub("o", "0") == "hell0 w0rld" and ("a,b,c"):find(",", 1, true) == 2)
local t = { 3, 1, 2 } table.sort(t, function(a, b) return a > b end) assert(t[1] == 3)
assert(table.concat({ 1, 2, 3 }, "-") == "1-2-3" and string.format("%5.2f|%s|%q", 1.5, {} ~= nil, "x") == " 1.50|true|\"x\"")
assert(#table.pack(table.unpack({ 1, 2, 3 })) == 3 and select(2, pcall(error, { code = 5 })).code == 5)
local weak = setmetatable({}, { __mode = "v" })
assert(math.type(3) == "integer" and utf8.len("h\u{E9}") == 2)
