
-- Process data.

-- A bit of a word, or several.
local function add_bits_of(tree, entry, list, range, number)
    for _, bits in ipairs(list) do
        local value = bits_of(number, bits[1], bits[2])
        local field = fields[entry.filter .. "." .. bits[3]]
        local item = tree:add_le(field, range, bits[1] == bits[2] and value ~= 0 or value)
        local name = named(bits.values, value)
        if bits[1] == bits[2] then item:set_text(bits[4] .. ": " .. value) end
        if name then item:append_text(" (" .. name .. ")") end
    end
end

-- The bits of a word under it, those included that the mode gives a meaning.
local function add_word(tree, entry, range, number, mode)
    local word = WORDS[entry.word]
    if not word then return end
    add_bits_of(tree, entry, word, range, number)
    add_bits_of(tree, entry, word.modes[mode] or {}, range, number)
    if entry.word == "statusword" then
        local state = state_of(number)
        if state then tree:add(fields[entry.filter .. ".state"], range, state) end
    end
end

-- A field of process data.
local function add_value(tree, key, bytes, bit, bits, mode)
    local entry = ENTRIES[key]
    if not entry or not entry.filter then
        local text = string.format("0x%04X:%02X", math.floor(key / 256), key % 256)
        tree:add(devc, around(bytes, bit, bits), text .. ": " .. tostring(around(bytes, bit, bits):bytes()))
        return
    end
    local value, number = value_at(entry[2], entry[3], bytes, bit, bits)
    local range = around(bytes, bit, bits)
    local item = tree:add(fields[entry.filter], range, value)
    if entry.unit then item:append_text(", in " .. entry.unit) end
    local name = number and meaning(entry, number)
    if name then item:append_text(" (" .. name .. ")") end
    item:append_text(string.format(" [0x%04X:%02X]", math.floor(key / 256), key % 256))
    if entry.word and number then add_word(item, entry, range, number, mode) end
end

-- Calls for each entry of an image that lies in the bytes: its key, first bit and bits; 0 as the key of a gap.
local function each(layout, size, work)
    local bit = 0
    for _, pdo in ipairs(layout) do
        for at = 2, #pdo, 2 do
            if bit + pdo[at + 1] <= size * 8 then work(pdo[at], bit, pdo[at + 1], pdo) end
            bit = bit + pdo[at + 1]
        end
    end
    return bit
end

local function layout_of(station, object, pinfo)
    local layout = {}
    for _, index in ipairs(assigned(station, object, pinfo)) do
        local pdo = mapped(station, index, pinfo)
        if pdo then
            local own = { string.format("0x%04X %s", index, pdo[1]) }
            for at = 2, #pdo do own[at] = pdo[at] end
            layout[#layout + 1] = own
        end
    end
    return layout
end

local function size_of(layout)
    return math.floor((each(layout, math.huge, function() end) + 7) / 8)
end

-- The modes that an image tells, by axis, and before it other images.
local function modes_in(layout, bytes, station, pinfo)
    local modes = {}
    each(layout, bytes:len(), function(key, bit, bits)
        local entry = ENTRIES[key]
        if entry and entry.values == MODES then
            local _, number = value_at(entry[2], entry[3], bytes, bit, bits)
            modes[entry.axis or 0] = number
            learn(station, "mode " .. (entry.axis or 0), pinfo, number)
        end
    end)
    return function(axis)
        return modes[axis or 0] or known(station, "mode " .. (axis or 0), pinfo)
    end
end

-- Outputs or inputs of a station.
local function add_image(root, station, object, bytes, pinfo)
    local layout = layout_of(station, object, pinfo)
    local what = object == 0x1C12 and "Outputs" or "Inputs"
    local tree = root():add(devc, bytes(), string.format("%s of station 0x%04X", what, station))
    tree:add(fields["station"], bytes(), station):set_generated()
    local size = size_of(layout)
    if size ~= bytes:len() then
        local text = string.format("description %d bytes, frame %d", size, bytes:len())
        tree:add(fields["mismatch"], bytes(), text)
        return
    end
    local mode_of = modes_in(layout, bytes, station, pinfo)
    local trees = {}
    each(layout, bytes:len(), function(key, bit, bits, pdo)
        trees[pdo] = trees[pdo] or tree:add(devc, around(bytes, bit, bits), pdo[1])
        if key ~= 0 then
            local axis = ENTRIES[key] and ENTRIES[key].axis
            add_value(trees[pdo], key, bytes, bit, bits, mode_of(axis))
        end
    end)
end
