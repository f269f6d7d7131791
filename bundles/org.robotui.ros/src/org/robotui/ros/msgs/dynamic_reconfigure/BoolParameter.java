package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * A truth value of a configuration ({@code dynamic_reconfigure/BoolParameter}).
 *
 * @param name the parameter
 * @param value its value
 */
@MessageType("dynamic_reconfigure/BoolParameter")
public record BoolParameter(String name, boolean value) {}
