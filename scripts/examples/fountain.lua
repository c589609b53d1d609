-- SPDX-License-Identifier: MIT
-- Fountain: hyraxes shoot up from the bottom middle of the screen, swaying to and fro.
-- The oldest ones make room for new ones.

local MOST = 20          -- hyraxes in the fountain at one time
local PAUSE = 0.3        -- seconds between two of them
local UP = 1100          -- px/s
local SWAY = 350         -- px/s to either side

-- The screen to play on: the main one, or whichever there is.
local function stage()
  for _, monitor in ipairs(hyrax.monitors()) do
    if monitor.primary then return monitor.work end
  end
  return hyrax.arena()
end

local drops = hyrax.pets{ tag = "drop" }                -- those that a reload left behind

local function jet()
  local ground = stage()
  table.insert(drops, hyrax.spawn{
    tag = "drop",
    x = ground.x + ground.w / 2, y = ground.y + ground.h,
    vx = SWAY * math.sin(hyrax.now()) + math.random(-60, 60),
    vy = -UP * (0.85 + 0.15 * math.random()),           -- negative: up
  })
  if #drops > MOST then table.remove(drops, 1):remove() end         -- the oldest goes
end

hyrax.every(PAUSE, jet)
hyrax.on("monitors", function() hyrax.log.info("the fountain looks for the main screen") end)
