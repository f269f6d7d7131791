package org.robotui.core.internal.config.model;

import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;

/**
 * What a robot is asked when it is stopped.
 *
 * @param port a call port of one of its robot interfaces that takes a {@link ServiceRequest}
 * @param request what is asked
 */
public record StopCall(SourceId port, ServiceRequest request) {}
