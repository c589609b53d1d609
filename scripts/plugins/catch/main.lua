-- SPDX-License-Identifier: MIT
-- Catch: throw hyraxes into a basket that walks about. The first throw begins a round; a catch from
-- far away counts more; the best rounds are kept. A click on the basket tells them.

local scores = require "scores"

local FAR = 500                    -- this much further away, a catch counts one more [px]

local basket
local points                       -- nil while no round is on
local thrown_from = {}             -- by ball, where the hand let it go

local function stage()
  for _, monitor in ipairs(hyrax.monitors()) do
    if monitor.primary then return monitor.work end
  end
  return hyrax.arena()
end

local function middle(pet) return pet.x + pet.w / 2 end

local function end_round()
  local place = scores.add(points)
  local praise = place == 1 and "A record: %d!" or place and "%d points, place " .. place or "%d points"
  if basket.valid then basket:say(praise:format(points), 6) end
  hyrax.log.info("a round of %d points", points)
  points = nil
end

local function begin_round()
  points = 0
  basket:say(("%d seconds!"):format(hyrax.config.seconds), 2)
  hyrax.after(hyrax.config.seconds, end_round)
end

-- Into the basket is through its mouth: from above, and not past its rim.
local function goes_in(ball)
  return ball.vy > 0 and ball.y + ball.h / 2 < basket.y + basket.h / 2
    and math.abs(middle(ball) - middle(basket)) < basket.w / 2
end

local function catch(ball)
  local worth = 1 + math.floor(math.abs(middle(basket) - thrown_from[ball]) / FAR)
  thrown_from[ball] = nil
  points = points + worth
  basket:play("cheer")
  basket:say(("+%d: %d"):format(worth, points), 1.5)
  ball:fling(math.random(-300, 300), -650)                     -- out again, to be thrown again
end

local function meet(_, other)
  if points and other.valid and thrown_from[other] and goes_in(other) then catch(other) end
end

-- From side to side, and on after whatever stopped it.
local to_right = true
local function walk()
  if not basket.valid or basket.state ~= "idle" or hyrax.config.speed == 0 then return end
  local room = stage()
  to_right = not to_right
  local margin = room.w * (0.05 + 0.25 * math.random())
  local target = to_right and room.x + room.w - basket.w - margin or room.x + margin
  basket:walk_to(target, hyrax.config.speed)
end

local function set_up()
  local room = stage()
  basket = hyrax.pets{ kind = "basket" }[1]
    or hyrax.spawn{ kind = "basket", x = room.x + room.w / 2, y = room.y + room.h / 2 }
  basket:on("collide", meet)
  basket:on("click", function() basket:say(scores.text(), 6) end)
  local balls = hyrax.pets{ tag = "ball" }
  for i = #balls + 1, hyrax.config.balls do
    hyrax.spawn{ tag = "ball", x = room.x + 40 + 130 * (i - 1), y = room.y + room.h / 2 }
  end
  for i = hyrax.config.balls + 1, #balls do balls[i]:remove() end
end

hyrax.on("throw", function(pet)
  if pet.tag ~= "ball" or pet.owner ~= hyrax.plugin.id or not basket.valid then return end
  thrown_from[pet] = middle(pet)
  if not points then begin_round() end
end)
hyrax.on("land", function(pet) thrown_from[pet] = nil end)     -- it missed
hyrax.on("remove", function(pet) thrown_from[pet] = nil end)
hyrax.on("config", set_up)
hyrax.every(0.5, walk)
if not hyrax.test then set_up() end

if hyrax.test then
  require "tests" {
    set_up = set_up,
    basket = function() return basket end,
    points = function() return points end,
    throw = function(ball) thrown_from[ball] = middle(ball); points = points or 0 end,
  }
end
