package org.robotui.uic.parameters.internal.model;

/**
 * A parameter, a namespace of them, or a program with settings.
 *
 * @param robot the component that offers to be browsed
 * @param name the robot's name for it; of a namespace without the slash at the end, of the outermost empty
 */
public record Key(String robot, String name) {}
