// The end of loops that would not end, and keep the GPU. raytoy lays calls of these functions into the
// snippets that do not ship with it, once it has read them: loopEnds at each step of a loop, allowSteps
// before each call of a snippet from outside (src/module/guard.rs). gpu/guard.rs reads what is told.

/// The number of a loop that was ended, counted from 1; 0 while all loops end by themselves.
@group(0) @binding(3) var<storage, read_write> ended_loop: atomic<u32>;

/// The steps that one call of a snippet may take. Mesa's software driver stops all loops of a pixel after
/// 65535 steps without a word, so these are fewer.
const GUARD_CALL_STEPS: u32 = 1u << 15u;

/// The steps that all calls may take for one sample of a pixel.
const GUARD_PIXEL_STEPS: u32 = 1u << 24u;

/// More than all that are allowed: from now on no loop goes on.
const GUARD_NO_STEPS: u32 = 1u << 31u;

/// Other pixels' loops are looked at once in so many steps.
const GUARD_LOOK_STEPS: u32 = 1024u;

/// Steps of loops, so far in this sample.
var<private> steps_taken: u32;
var<private> allowed_steps: u32;

fn allowSteps() {
    allowed_steps = min(steps_taken + GUARD_CALL_STEPS, GUARD_PIXEL_STEPS);
}

/// Counts a step of the loop with this number; whether it has to end.
fn loopEnds(number: u32) -> bool {
    steps_taken++;
    let looks = steps_taken % GUARD_LOOK_STEPS == 0u;
    if steps_taken < allowed_steps && !(looks && atomicLoad(&ended_loop) != 0u) {
        return false;
    }
    // Other loops end too, but only this one is to blame.
    if steps_taken == allowed_steps {
        atomicMax(&ended_loop, number);
    }
    steps_taken = GUARD_NO_STEPS;
    return true;
}
