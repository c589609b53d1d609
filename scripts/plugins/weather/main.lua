-- SPDX-License-Identifier: MIT
-- Weather: gusts. Drag pulls along who flies, leaves fly past, and who sits on the ground hops. While
-- the wind blows, another integrator moves the pets; the log says so.

local GUST = 4                     -- seconds
local STEP = 0.25                  -- between two changes of the wind [s]

local function leaf(direction)
  local room = hyrax.arena()
  local pet = hyrax.spawn{
    kind = "leaf",
    x = direction > 0 and room.x or room.x + room.w - 40,
    y = room.y + room.h * (0.1 + 0.5 * math.random()),
    vx = direction * math.random(700, 1500),
    vy = -math.random(100, 500),
    scale = 0.6 + 0.8 * math.random(),
  }
  hyrax.after(GUST + math.random() * 2, function() pet:remove() end)
end

-- Rises, and falls again.
local function gust(direction)
  hyrax.log.info("a gust from the %s", direction > 0 and "left" or "right")
  for i, pet in ipairs(hyrax.pets{ all = true }) do
    if pet.state == "idle" and i % 2 == 0 then pet:push(direction * 120, -math.random(120, 260)) end
  end
  local steps, gone = GUST // STEP, 0
  for step = 1, steps - 1 do
    hyrax.wind(direction * hyrax.config.strength * math.sin(math.pi * step / steps))
    while gone < hyrax.config.leaves * step / steps do
      leaf(direction)
      gone = gone + 1
    end
    hyrax.wait(STEP)
  end
  hyrax.wind()
end

local function weather()
  while true do
    hyrax.wait(hyrax.config.calm * (0.5 + math.random()))
    gust(math.random(2) == 1 and 1 or -1)
  end
end

if hyrax.test then
  local test = hyrax.test
  test.case("a gust takes along who flies, and ends", function()
    local room = hyrax.arena()
    local pet = hyrax.spawn{ x = room.x + room.w / 2, y = room.y }
    hyrax.task(gust, 1)
    test.advance(1)
    test.expect(pet.vx > 20, "no wind")
    test.expect(#hyrax.pets{ kind = "leaf" } > 0, "no leaves")
    test.advance(9)
    test.equal(#hyrax.pets{ kind = "leaf" }, 0)
  end)
  test.case("who sits on the ground hops", function()
    local a, b = hyrax.spawn{ x = 300 }, hyrax.spawn{ x = 600 }
    test.advance(20)
    test.equal(a.state .. b.state, "idleidle")
    hyrax.task(gust, -1)
    test.advance(0.1)
    test.expect(a.state == "fall" or b.state == "fall")
    test.advance(10)
  end)
else
  hyrax.task(weather)
end
