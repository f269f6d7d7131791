package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * A whole number of a configuration ({@code dynamic_reconfigure/IntParameter}).
 *
 * @param name the parameter
 * @param value its value
 */
@MessageType("dynamic_reconfigure/IntParameter")
public record IntParameter(String name, int value) {}
