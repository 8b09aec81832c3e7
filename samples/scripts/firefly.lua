-- Glows at random, the same in every run, and tints all that is drawn in Gooch's tones when it is touched.

function start()
    home = self.transform.translation
end

function update(dt)
    local jitter = vec3(random() - 0.5, random() - 0.5, random() - 0.5)
    self.transform.translation = home + jitter * 0.1
end

function event(name)
    if name ~= "reached" then return end
    for e, gooch in scene.query("gooch") do
        gooch.y = 0.8
    end
end
