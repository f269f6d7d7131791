package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * Asks for other values ({@code dynamic_reconfigure/ReconfigureRequest}).
 *
 * @param config what is to change
 */
@MessageType("dynamic_reconfigure/ReconfigureRequest")
public record ReconfigureRequest(Config config) {}
