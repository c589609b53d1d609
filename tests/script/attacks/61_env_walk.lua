-- MUST: ok | every function reachable from the environment is on the allow-list (HOST prints and checks the list)
-- SPDX-License-Identifier: MIT
local seen, names = {}, {}
local function walk(v, path, depth)
  if depth > 8 or (type(v) ~= "table" and type(v) ~= "function" and type(v) ~= "userdata") or seen[v] then return end
  seen[v] = path
  if type(v) == "function" then names[#names + 1] = path end
  if type(v) == "table" then for k, x in next, v do walk(x, path .. "." .. tostring(k), depth + 1) end end
  local mt = getmetatable(v)
  if type(mt) == "table" then walk(mt, path .. "<mt>", depth + 1) end
end
walk(_G, "_G", 0)
walk(getmetatable(""), "string<mt>", 0)
table.sort(names)
AUDIT = table.concat(names, " ")
