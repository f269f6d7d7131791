package org.robotui.ros2.lifecycle;

/**
 * A change of state that a node offers now.
 *
 * @param id its number, such as 3
 * @param label its name, such as {@code activate}
 * @param start the state that it leads from
 * @param goal the state that it leads to
 */
public record LifecycleTransition(int id, String label, LifecycleState start, LifecycleState goal) {}
