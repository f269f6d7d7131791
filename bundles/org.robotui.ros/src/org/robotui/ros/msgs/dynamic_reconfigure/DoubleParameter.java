package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * A number of a configuration ({@code dynamic_reconfigure/DoubleParameter}).
 *
 * @param name the parameter
 * @param value its value
 */
@MessageType("dynamic_reconfigure/DoubleParameter")
public record DoubleParameter(String name, double value) {}
