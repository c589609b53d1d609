-- MUST: error: | crafted bytecode crashes a stock VM; here string.dump does not exist and load is text only
-- SPDX-License-Identifier: MIT
local function f() local a = 1; return a end
local d = string.dump(f)
local g = load(d:gsub("..................$", ("\xff"):rep(18)), "x", "b")
for i = 1, #d do                      -- flip each byte: one of them crashes the VM
  local b = load(d:sub(1, i - 1) .. string.char((d:byte(i) + 131) % 256) .. d:sub(i + 1), "x", "b")
  if b then pcall(b) end
end
