package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Rgba;

/**
 * What a tick of the scene is to the display in a slot.
 *
 * @param places where frames are
 * @param robotColor of its robot
 * @param nowNanos monotonic
 * @param reset forget what was collected
 * @param ages seconds since something was received
 */
record SlotTick(Places places, Rgba robotColor, long nowNanos, boolean reset, LongToDoubleFunction ages) {
  DisplayTick of(List<Envelope<? extends Data>> arrived, InputState state, Settings settings) {
    return new DisplayTick(arrived, state, places, settings, robotColor, nowNanos, reset, ages);
  }
}
