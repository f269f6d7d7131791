package org.robotui.message.ros.std_srvs;

import org.robotui.message.MessageType;

/** Asks for an action that needs no arguments ({@code std_srvs/EmptyRequest}). */
@MessageType("std_srvs/EmptyRequest")
public record EmptyRequest() {}
