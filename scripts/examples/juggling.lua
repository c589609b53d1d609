-- SPDX-License-Identifier: MIT
-- Juggling: an invisible juggler stands in the middle of the screen and keeps a few hyraxes in the
-- air. Whoever comes down near a hand is thrown so that it comes down at the other one.

local BALLS = 3
local FLIGHT = 1.5       -- seconds from hand to hand
local REACH = 0.2        -- half the distance of the hands, as a part of the screen's width

local arena, floor, hands

local function take_position()
  arena = hyrax.arena()
  for _, monitor in ipairs(hyrax.monitors()) do
    if monitor.primary then arena = monitor.work end
  end
  local middle = arena.x + arena.w / 2
  hands = { left = middle - REACH * arena.w, right = middle + REACH * arena.w }
  floor = arena.y + arena.h
end

-- How strong gravity is here: two looks at a falling hyrax tell (it can be changed in config.json).
local gravity = 1200
local last_vy, last_time = {}, {}
local function feel_gravity(ball)
  local vy, time = last_vy[ball], last_time[ball]
  if vy and vy > 0 and ball.vy > vy then
    gravity = gravity + 0.1 * ((ball.vy - vy) / (hyrax.now() - time) - gravity)
  end
  last_vy[ball], last_time[ball] = ball.vy, hyrax.now()
end

-- Up and over: half the flight to rise, half to fall, the distance of the hands on the way.
local function throw(ball)
  local middle = ball.x + ball.w / 2
  local target = middle < arena.x + arena.w / 2 and hands.right or hands.left
  local highest = math.max(floor - arena.y - 2 * ball.h, 0)         -- do not hit the ceiling
  local up = math.min(gravity * FLIGHT / 2, math.sqrt(2 * gravity * highest))
  ball:fling((target - middle) * gravity / (2 * up), -up)
  last_vy[ball] = nil
end

local function near_floor(ball)
  return ball.vy >= 0 and ball.y + ball.h > floor - 0.1 * arena.h
end

local function juggle()
  for _, ball in ipairs(hyrax.pets{ tag = "ball" }) do
    if ball.state ~= "held" then
      feel_gravity(ball)
      if near_floor(ball) then throw(ball) end
    end
  end
end

take_position()
hyrax.on("monitors", take_position)
hyrax.every(1 / 60, juggle)
hyrax.on("land", function(ball)                          -- one that slipped through
  if ball.tag == "ball" then throw(ball) end
end)
hyrax.on("remove", function(ball) last_vy[ball], last_time[ball] = nil, nil end)

-- The balls come in one after the other; whoever is lost is replaced.
while true do
  if #hyrax.pets{ tag = "ball" } < BALLS then
    hyrax.spawn{ tag = "ball", x = hands.left, y = floor - 0.4 * arena.h }
  end
  hyrax.wait(2 * FLIGHT / BALLS)
end
