-- MUST: ok | nothing that reaches the system is there
-- SPDX-License-Identifier: MIT
assert(io == nil and package == nil and dofile == nil and loadfile == nil)
assert(string.dump == nil)
for _, k in ipairs{ "execute", "exit", "getenv", "remove", "rename", "tmpname", "setlocale" } do assert(os[k] == nil, k) end
for _, k in ipairs{ "getregistry", "getupvalue", "setupvalue", "sethook", "getlocal", "setmetatable", "getmetatable", "getinfo", "upvaluejoin", "setuservalue" } do
  assert(not debug or debug[k] == nil, k)
end
assert(collectgarbage == nil or not pcall(collectgarbage, "stop"))
assert(collectgarbage == nil or not pcall(collectgarbage, "generational"))
