package org.robotui.smartsoft.naming;

/**
 * An entry of a naming service.
 *
 * @param name of the service
 * @param address where it is, or was: a server that was killed stays entered
 */
public record NamedService(ServiceName name, ServiceAddress address) {}
