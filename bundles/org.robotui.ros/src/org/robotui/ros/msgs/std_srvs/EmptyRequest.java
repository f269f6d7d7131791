package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.MessageType;

/** Asks for an action that needs no arguments ({@code std_srvs/EmptyRequest}). */
@MessageType("std_srvs/EmptyRequest")
public record EmptyRequest() {}
