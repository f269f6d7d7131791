package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * Answers a request for other values ({@code dynamic_reconfigure/ReconfigureResponse}).
 *
 * @param config all values as they are now
 */
@MessageType("dynamic_reconfigure/ReconfigureResponse")
public record ReconfigureResponse(Config config) {}
