package org.robotui.api.port;

import java.util.Map;

/**
 * A request to a service that is known by name only.
 *
 * @param service the robot's name of the service
 * @param arguments the fields of the request by name: numbers, text, lists, maps; absent fields are zero
 */
public record ServiceRequest(String service, Map<String, Object> arguments) {}
