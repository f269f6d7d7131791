package org.robotui.tests.novelty;

import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;

/**
 * How deep the water is below a boat. Known to this bundle alone.
 *
 * @param frame of the echo sounder
 * @param latitude radians
 * @param longitude radians
 * @param metres the depth
 */
public record WaterDepth(FrameId frame, double latitude, double longitude, double metres) implements Data, InFrame {}
