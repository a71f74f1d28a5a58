"""What each part of a cathode-ray tube shows of what it does to the beam."""

from workbench.algorithms.entry import View

COLUMNS = ("part", "set to", "gives", "value", "unit", "z")

CATHODE = "Heat the cathode"
GRID = "Hold electrons back with the control grid"
FOCUS = "Focus the beam"
ANODE = "Accelerate it"
DEFLECTION = "Deflect it"
SCREEN = "Light the phosphor"

_FOCUSED = "('focusing anode', v_focus, 'spot', spot, 'mm', LENS_MM)"
_BENT = "('deflection', (drive_x, drive_y), '(x, y)', (x, y), 'mm', PLATES_MM + length / 2.0)"

VIEWS = (
    View(
        block=CATHODE,
        row="('cathode', 0.0, 'K', peak, 'µA', 0.0)",
        sentence="The heater makes the cathode glow, and electrons boil off it: up to K = {peak} µA, "
        "which is {round(peak * 6.2415)} billion electrons in a millisecond.",
    ),
    View(
        block=GRID,
        when="current > 0.0",
        row="('control grid', v_grid, 'I', current, 'µA', GRID_MM)",
        sentence="The grid at V_g = {v_grid} V repels some of them and passes I = K (1 − V_g / V_c)^γ = "
        "{current} µA: that is the brightness. V_c = {v_cut} V would stop all.",
    ),
    View(
        block=GRID,
        row="('control grid', v_grid, 'I', current, 'µA', GRID_MM)",
        sentence="The grid at V_g = {v_grid} V is at or below its cut-off V_c = {v_cut} V: it turns every "
        "electron back, and the screen stays dark.",
    ),
    View(
        block=FOCUS,
        when="crossing < 0.995 * throw",
        row=_FOCUSED,
        sentence="V_f = {v_focus} V bends the rays too much: they cross {crossing} mm behind the lens, "
        "before the screen at {throw} mm, and the spot spreads to {spot} mm.",
    ),
    View(
        block=FOCUS,
        when="crossing > 1.005 * throw",
        row=_FOCUSED,
        sentence="V_f = {v_focus} V bends the rays too little: they would cross {crossing} mm behind the "
        "lens, beyond the screen at {throw} mm, and the spot is {spot} mm wide.",
    ),
    View(
        block=FOCUS,
        row=_FOCUSED,
        sentence="V_f = {v_focus} V bends the rays so that they come together {crossing} mm behind the lens, "
        "at the screen: the spot is as small as this current lets it be, {spot} mm.",
    ),
    View(
        block=ANODE,
        row="('accelerating anode', v_anode, 'v', speed, 'km/s', ANODE_MM)",
        sentence="The anode at V_a = {v_anode} V gives each electron e V_a = m v² / 2: it leaves with "
        "v = {round(speed)} km/s, by relativity {round(exact_speed(v_anode))} km/s.",
    ),
    View(
        block=DEFLECTION,
        when="coils and sine >= 1.0",
        row="('deflection', (drive_x, drive_y), 'sin θ', sine, '', PLATES_MM + length / 2.0)",
        sentence="The coils would turn the beam by sin θ = l B √(e / (2 m V_a)) = {sine}, but no sine is "
        "1 or more: it runs in a circle inside them. Make B smaller or V_a larger.",
    ),
    View(
        block=DEFLECTION,
        when="coils",
        row=_BENT,
        sentence="The coils turn the beam by sin θ = l B √(e / (2 m V_a)) = {sine}; at the screen that is "
        "D tan θ, so x = {x} mm and y = {y} mm.",
    ),
    View(
        block=DEFLECTION,
        when="max(abs(drive_x), abs(drive_y)) > limit",
        row="('deflection', (drive_x, drive_y), 'limit', limit, 'V', PLATES_MM + length / 2.0)",
        sentence="V_x = {drive_x} V and V_y = {drive_y} V are too much: beyond 2 d² V_a / l² = {limit} V the "
        "beam hits a plate before it has passed.",
    ),
    View(
        block=DEFLECTION,
        row=_BENT,
        sentence="Between the plates the beam bends: y = l D_y V_y / (2 d V_a) = {y} mm, and in the same way "
        "x = {x} mm. Beyond 2 d² V_a / l² = {limit} V the plates would catch it.",
    ),
    View(
        block=SCREEN,
        when="off_the_face(x, y)",
        row="('screen', refresh, 'left', left, '%', screen)",
        sentence="At x = {x} mm, y = {y} mm there is no screen any more: the beam ends on the conductive "
        "coating, which leads its {round(current * v_anode / 1000.0, 2)} mW away.",
    ),
    View(
        block=SCREEN,
        row="('screen', refresh, 'left', left, '%', screen)",
        sentence="I V_a = {round(current * v_anode / 1000.0, 2)} mW make the phosphor glow where the beam "
        "lands. Then the glow fades: {refresh} times a second it is drawn again, with {left} % of it left.",
    ),
)
