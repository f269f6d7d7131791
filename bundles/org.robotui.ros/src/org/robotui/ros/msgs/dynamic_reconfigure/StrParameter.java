package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * A text of a configuration ({@code dynamic_reconfigure/StrParameter}).
 *
 * @param name the parameter
 * @param value its value
 */
@MessageType("dynamic_reconfigure/StrParameter")
public record StrParameter(String name, String value) {}
