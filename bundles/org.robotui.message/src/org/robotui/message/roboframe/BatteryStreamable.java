package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * The state of a battery ({@code roboframe/Battery}).
 *
 * @param stamp when it was measured, nanoseconds by the clock of the application
 * @param voltage volts
 * @param current amperes, negative when discharging
 * @param charge 0 to 1
 * @param charging whether it is being charged
 */
@MessageType("roboframe/Battery")
public record BatteryStreamable(long stamp, double voltage, double current, double charge, boolean charging) {}
