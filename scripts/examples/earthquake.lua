-- SPDX-License-Identifier: MIT
-- Earthquake: now and then the ground shakes and throws everybody about; a few weaker aftershocks
-- follow. All pets feel it, not only those of this script.

local JOLT = 650         -- px/s, of the strongest jolt
local BEAT = 1 / 12      -- seconds between two jolts

-- One jolt: everybody is pushed up and to one side, each a little differently.
local function jolt(strength, side)
  for _, pet in ipairs(hyrax.pets{ all = true }) do
    if pet.state ~= "held" then                          -- a hand holds on
      local luck = 0.6 + 0.4 * math.random()
      pet:push(side * JOLT * strength * luck, -0.5 * JOLT * strength * math.random())
    end
  end
end

-- Shakes to and fro; swells, then dies away.
local function shake(magnitude, seconds)
  local jolts = math.floor(seconds / BEAT)
  for i = 1, jolts do
    local swell = math.sin(math.pi * i / (jolts + 1))
    jolt(magnitude * swell, i % 2 == 0 and 1 or -1)
    hyrax.wait(BEAT)
  end
end

local function earthquake()
  local magnitude = 0.5 + 0.5 * math.random()
  hyrax.log.info("earthquake of magnitude %.1f", 4 + 5 * magnitude)
  shake(magnitude, 2 + math.random())
  for _ = 1, math.random(1, 3) do
    hyrax.wait(2 + 3 * math.random())
    magnitude = magnitude * 0.5
    shake(magnitude, 0.5 + math.random())
  end
end

while true do
  hyrax.wait(15 + 15 * math.random())
  earthquake()
end
