package org.robotui.message.ros.std_srvs;

import org.robotui.message.MessageType;

/** Says that the action was done ({@code std_srvs/EmptyResponse}). */
@MessageType("std_srvs/EmptyResponse")
public record EmptyResponse() {}
