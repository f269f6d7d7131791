package org.robotui.data.sensor;

import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;

/**
 * What an inertial measurement unit says. A part that the device does not measure is empty.
 *
 * @param frame frame of the device
 * @param orientation of the device in the world
 * @param angularVelocity radians per second
 * @param linearAcceleration metres per second squared, gravity included
 */
public record Imu(
    FrameId frame,
    Optional<Quaternion> orientation,
    Optional<Vector3> angularVelocity,
    Optional<Vector3> linearAcceleration)
    implements Data, InFrame {}
