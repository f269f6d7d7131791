package org.robotui.ros;

/**
 * What a service server says about itself.
 *
 * @param type the service type's full name
 * @param md5 the MD5 sum of the service's definition
 * @param requestType the type of the request; empty if the server does not say
 * @param responseType the type of the response; empty if the server does not say
 * @param node the server's node name
 */
public record ServiceIdentity(String type, String md5, String requestType, String responseType, String node) {}
