-- The ball jumps while space is held, and tells the box, which then takes a colour by chance.
local height = 0.7

function update(dt)
  local ball = scene.find("ball")
  if input.pressed("space") then scene.send("jumped", self) end
  height = input.down("space") and math.min(height + dt, 1.5) or math.max(height - dt, 0.7)
  local at = ball.transform.translation
  ball.transform.translation = vec3(at.x, height, at.z)
end

function event(name)
  if name == "jumped" then scene.find("box").surface.tint = vec3(1, random(), 0.2) end
end
