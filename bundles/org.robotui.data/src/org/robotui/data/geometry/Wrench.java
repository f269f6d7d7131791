package org.robotui.data.geometry;

import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.geometry.Vector3;

/**
 * A force and a torque at one place, as force-torque sensors measure them.
 *
 * @param frame frame of the sensor, in whose axes both are
 * @param force newton
 * @param torque newton metres
 */
public record Wrench(FrameId frame, Vector3 force, Vector3 torque) implements Data, InFrame {}
