package org.robotui.api.port;

/**
 * A service or an action that is offered to the programs of a robot now.
 *
 * @param name its whole name
 * @param type the robot's name of its type
 */
public record ServiceGrant(String name, String type) {}
